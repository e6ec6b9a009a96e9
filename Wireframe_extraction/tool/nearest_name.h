// What a mistyped name was meant to be.

#ifndef EXTRACT_WIREFRAME_NEAREST_NAME_H
#define EXTRACT_WIREFRAME_NEAREST_NAME_H

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {

// how many letters have to be put in, taken out or changed to make one text of another
inline std::size_t edit_distance(const std::string& a, const std::string& b)
{
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j)
    row[j] = j;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = (std::min)({changed, row[j] + 1, diagonal + 1});
    }
  }
  return row[b.size()];
}

// The nearest name, the first one of several; nothing if none is near. One that goes on as the text does is near.
inline std::string nearest_name(const std::string& text, const std::vector<std::string>& names)
{
  const std::size_t letters_per_error = 3; // a third of a word may be wrong, but not more
  std::string nearest;
  std::size_t least = text.size() / letters_per_error + 1;
  for (const std::string& name : names)
  {
    const std::size_t distance = edit_distance(text, name);
    if (distance < least)
    {
      least = distance;
      nearest = name;
    }
  }
  for (const std::string& name : names)
    if (nearest.empty() && text.size() > letters_per_error && name.compare(0, text.size(), text) == 0)
      nearest = name;
  return nearest;
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_NEAREST_NAME_H
