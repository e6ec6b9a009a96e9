// Scripts with which shells complete the command line of the tool extract_wireframe.

#ifndef EXTRACT_WIREFRAME_COMPLETION_H
#define EXTRACT_WIREFRAME_COMPLETION_H

#include "joined.h"

#include <CLI/CLI.hpp>

#include <sstream>
#include <string>
#include <vector>

namespace tool {

// what may stand behind an option
enum class Argument_kind
{
  CHOICE,
  FILE,
  FOLDER,
  TEXT
};

inline Argument_kind kind_of_argument(const CLI::Option& option)
{
  const std::string type = option.get_type_name();
  if (type.find('|') != std::string::npos)
    return Argument_kind::CHOICE;
  if (type == "DIR")
    return Argument_kind::FOLDER;
  return type == "FILE" || type == "LIST" || type.compare(0, 3, "OUT") == 0 ? Argument_kind::FILE : Argument_kind::TEXT;
}

// the values of a choice: "a|b" or "[true|false]"
inline std::vector<std::string> choices_of(const CLI::Option& option)
{
  std::string type = option.get_type_name();
  if (!type.empty() && type.front() == '[')
    type = type.substr(1, type.size() - 2);
  std::vector<std::string> choices;
  std::istringstream stream(type);
  for (std::string choice; std::getline(stream, choice, '|');)
    choices.push_back(choice);
  return choices;
}

inline std::vector<std::string> names_of(const CLI::Option& option)
{
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames())
    names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    names.push_back("--" + name);
  return names;
}

inline std::string bash_completion(const CLI::App& app)
{
  std::string cases, all;
  for (const CLI::Option* const option : app.get_options())
  {
    const std::vector<std::string> names = names_of(*option);
    if (names.empty())
      continue; // the files
    all += (all.empty() ? "" : " ") + joined(names, " ");
    const Argument_kind kind = kind_of_argument(*option);
    const std::string start = "    " + joined(names, "|") + ") COMPREPLY=( ";
    if (kind == Argument_kind::CHOICE)
      cases += start + "$(compgen -W \"" + joined(choices_of(*option), " ") + "\" -- \"$word\") ); return;;\n";
    else if (kind == Argument_kind::FOLDER)
      cases += start + "$(compgen -d -- \"$word\") ); return;;\n";
  }
  return "# Completion of extract_wireframe for bash: source <(extract_wireframe --completion bash)\n"
         "_extract_wireframe() {\n"
         "  local word=\"${COMP_WORDS[COMP_CWORD]}\" before=\"${COMP_WORDS[COMP_CWORD-1]}\"\n"
         "  case \"$before\" in\n"
    + cases
    + "  esac\n"
      "  if [[ $word == -* ]]; then\n"
      "    COMPREPLY=( $(compgen -W \""
    + all
    + "\" -- \"$word\") )\n"
      "  else\n"
      "    COMPREPLY=( $(compgen -f -- \"$word\") )\n"
      "  fi\n"
      "}\n"
      "complete -o filenames -F _extract_wireframe extract_wireframe\n";
}

// the text within quotes and brackets of zsh
inline std::string in_zsh(const std::string& text)
{
  std::string result;
  for (const char c : text)
    if (c == '\'')
      result += "'\\''";
    else if (c == '[' || c == ']' || c == ':' || c == '\\')
      result += std::string("\\") + c;
    else
      result += c;
  return result;
}

inline std::string zsh_completion(const CLI::App& app)
{
  std::string text = "#compdef extract_wireframe\n"
                     "# Completion of extract_wireframe for zsh: source <(extract_wireframe --completion zsh)\n"
                     "_extract_wireframe() {\n  _arguments -s \\\n";
  for (const CLI::Option* const option : app.get_options())
    for (const std::string& name : names_of(*option))
    {
      std::string action;
      switch (kind_of_argument(*option))
      {
      case Argument_kind::CHOICE: action = "(" + joined(choices_of(*option), " ") + ")"; break;
      case Argument_kind::FILE: action = "_files"; break;
      case Argument_kind::FOLDER: action = "_files -/"; break;
      default: break;
      }
      // a boolean may stand alone; so does what has no value at all
      const bool is_boolean = !option->get_type_name().empty() && option->get_type_name().front() == '[';
      const std::string argument =
        option->get_items_expected_max() == 0 ? "" : (is_boolean ? "::" : ":") + std::string("value:") + action;
      text += "    '*" + name + "[" + in_zsh(option->get_description()) + "]" + argument + "' \\\n";
    }
  return text
    + "    '*:cloud:_files'\n"
      "}\n"
      "compdef _extract_wireframe extract_wireframe\n";
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_COMPLETION_H
