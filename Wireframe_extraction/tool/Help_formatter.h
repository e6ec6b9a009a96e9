// How the tool extract_wireframe shows its options.

#ifndef EXTRACT_WIREFRAME_HELP_FORMATTER_H
#define EXTRACT_WIREFRAME_HELP_FORMATTER_H

#include <CLI/CLI.hpp>

#include <cstddef>
#include <sstream>
#include <string>

namespace tool {

// Option by option: its name, and its description in lines that fit a terminal.
class Help_formatter : public CLI::Formatter
{
public:
  std::string make_option(const CLI::Option* option, bool is_positional) const override
  {
    std::string text = "  " + make_option_name(option, is_positional);
    if (!option->get_type_name().empty())
      text += " " + option->get_type_name();
    std::string line = text + std::string(text.size() < indent - 1 ? indent - text.size() : indent, ' ');
    if (text.size() >= indent - 1)
      line.insert(text.size(), "\n");
    std::string description = option->get_description();
    if (!option->get_default_str().empty())
      description += " [" + option->get_default_str() + "]";
    return line + wrapped(description) + "\n";
  }

private:
  static std::string wrapped(const std::string& description)
  {
    std::string result;
    std::size_t column = indent;
    std::istringstream words(description);
    for (std::string word; words >> word; column += word.size() + 1)
    {
      if (column + word.size() > 100)
      {
        result += "\n" + std::string(indent, ' ');
        column = indent;
      }
      else if (!result.empty())
        result += " ";
      result += word;
    }
    return result;
  }

  static constexpr std::size_t indent = 32;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_HELP_FORMATTER_H
