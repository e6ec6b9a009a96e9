// Words in a row, with something between them.

#ifndef EXTRACT_WIREFRAME_JOINED_H
#define EXTRACT_WIREFRAME_JOINED_H

#include <string>
#include <vector>

namespace tool {

template <class Names, class Text>
std::string joined(const Names& names, const char* separator, const Text& text)
{
  std::string result;
  for (const auto& name : names)
    result += (result.empty() ? "" : separator) + text(name);
  return result;
}

inline std::string joined(const std::vector<std::string>& words, const char* separator)
{
  return joined(words, separator, [](const std::string& word) { return word; });
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_JOINED_H
