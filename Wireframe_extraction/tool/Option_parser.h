// The kinds of options that the tool extract_wireframe has, on top of CLI11.

#ifndef EXTRACT_WIREFRAME_OPTION_PARSER_H
#define EXTRACT_WIREFRAME_OPTION_PARSER_H

#include "Help_formatter.h"
#include "nearest_name.h"
#include "write_page.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <initializer_list>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// Options of one value each, which is checked, and their values as texts.
class Option_parser
{
public:
  Option_parser(const std::string& description, const std::string& name) : m_app(description, name)
  {
    m_app.formatter(std::make_shared<Help_formatter>());
  }

  int show_help_or_version(const CLI::ParseError& request) const { return m_app.exit(request); }

  // what the options are in this run, the files left out
  std::vector<Parameter> parameters() const
  {
    std::vector<Parameter> result;
    for (const auto& parameter : m_parameters)
      if (parameter.first->get_group() != "Files")
        result.push_back({parameter.first->get_group(), parameter.first->get_name(), parameter.second(),
                          parameter.first->count() > 0});
    return result;
  }

  // Which option a word was meant to be that is none, as a question; nothing if none is near.
  std::string suggestion(const std::string& word) const
  {
    std::vector<std::string> names;
    for (const CLI::Option* const option : m_app.get_options())
      for (const std::string& name : option->get_lnames())
        names.push_back("--" + name);
    const std::string name = word.substr(0, word.find('='));
    const std::string nearest = name.compare(0, 2, "--") == 0 ? nearest_name(name, names)
      : name.compare(0, 1, "-") == 0 && name.size() > 2       ? nearest_name("-" + name, names)
                                                              : std::string();
    return nearest.empty() ? std::string() : "; did you mean " + nearest + "?";
  }

  // The options as a file that --config reads: those that were given, and as comments the others with their defaults.
  // What belongs to one run only is left out.
  std::string configuration() const
  {
    std::string text, group;
    for (const CLI::Option* const option : m_app.get_options())
    {
      const bool is_of_one_run = option->get_group() == "Many clouds" || option->get_type_name() == "DIR"
        || option->get_type_name().compare(0, 3, "OUT") == 0;
      if (!option->get_configurable() || option->get_lnames().empty() || is_of_one_run
          || (option->count() == 0 && option->get_default_str().empty()))
        continue;
      if (option->get_group() != group)
        text += "\n# " + option->get_group() + "\n";
      group = option->get_group();
      const std::string value = option->count() > 0 ? option->results().back() : option->get_default_str();
      text += (option->count() > 0 ? "" : "# ") + option->get_lnames().front() + " = " + quoted(value) + "\n";
    }
    return text;
  }

  // The library speaks of its named parameters, the user of the tool knows them as options, by the
  // first of their names.
  std::string with_option_names(std::string text) const
  {
    for (const CLI::Option* const option : m_app.get_options())
      for (const std::string& name : option->get_lnames())
        if (name.find('-') != std::string::npos)
          replace_words(text, with_underscores(name), "--" + option->get_lnames().front());
    return text;
  }

protected:
  static constexpr double infinity = HUGE_VAL;

  // The words of the command line in reverse order, as CLI11 takes them. A boolean option gets the word behind it as
  // its value only if that is one, so that a cloud may follow; without a value it is true.
  std::vector<std::string> words_of(int argc, char** argv) const
  {
    std::vector<std::string> words;
    bool may_be_option = true;
    for (int i = 1; i < argc; ++i)
    {
      words.push_back(argv[i]);
      may_be_option = may_be_option && words.back() != "--";
      if (!may_be_option || m_booleans.count(words.back()) == 0)
        continue;
      const std::string next = i + 1 < argc ? argv[i + 1] : "";
      const bool has_value = next == "true" || next == "false";
      words.back() += "=" + (has_value ? next : "true");
      i += has_value ? 1 : 0;
    }
    std::reverse(words.begin(), words.end());
    return words;
  }

  CLI::Option* add_number(const std::string& name, double& value, double least, double most, bool is_least_allowed,
                          const std::string& description, const std::string& group, bool has_default = true)
  {
    // CLI11's own checks let through what is not a number, and infinities
    const auto check = [=](const std::string& text) {
      double x = 0.;
      const bool is_number = CLI::detail::lexical_cast(text, x) && std::isfinite(x);
      if (is_number && (x > least || (is_least_allowed && x == least)) && x <= most)
        return std::string();
      return "\"" + text + "\" is not a number " + (is_least_allowed ? "from " : "above ") + to_text(least)
        + (most != infinity     ? " to " + to_text(most)
             : is_least_allowed ? " on"
                                : "");
    };
    CLI::Option* const option =
      m_app.add_option(name, value, description)->check(CLI::Validator(check, ""))->type_name("NUMBER")->group(group);
    if (has_default)
      option->default_str(to_text(value));
    add_parameter(option, [&value, has_default, option] {
      return has_default || option->count() > 0 ? to_text(value) : std::string("from the cloud");
    });
    return option;
  }

  CLI::Option* add_checked(const std::string& name, int& value, int least, int most, const std::string& description,
                           const std::string& group)
  {
    const auto check = [=](const std::string& text) {
      int x = 0;
      const bool is_digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
      if (is_digits && text.size() < 9 && CLI::detail::lexical_cast(text, x) && x >= least && x <= most)
        return std::string();
      return "\"" + text + "\" is not a whole number from " + std::to_string(least) + " to " + std::to_string(most);
    };
    CLI::Option* const option =
      m_app.add_option(name, value, description)->check(CLI::Validator(check, ""))->type_name("NUMBER")->group(group);
    add_parameter(option, [&value] { return value > 0 ? std::to_string(value) : std::string("as many as there are"); });
    return option;
  }

  // as --name, or with a value, as --name false or --name=false
  CLI::Option* add_boolean(const std::string& name, bool& value, const std::string& description,
                           const std::string& group)
  {
    m_booleans.insert(name);
    return add_choice(name, value, {{"true", true}, {"false", false}}, description, group)->type_name("[true|false]");
  }

  template <class Value>
  CLI::Option* add_choice(const std::string& name, Value& value,
                          std::initializer_list<std::pair<const char*, Value>> choices, const std::string& description,
                          const std::string& group)
  {
    const std::vector<std::pair<std::string, Value>> known(choices.begin(), choices.end());
    std::vector<std::string> names;
    std::string names_text, name_of_default;
    for (const auto& choice : known)
    {
      names.push_back(choice.first);
      names_text += (names_text.empty() ? "" : "|") + choice.first;
      if (choice.second == value)
        name_of_default = choice.first;
    }
    const std::function<void(const std::string&)> set = [&value, known](const std::string& text) {
      for (const auto& choice : known)
        if (choice.first == text)
          value = choice.second;
    };
    const auto check = [names_text, names](const std::string& text) {
      for (const std::string& known_name : names)
        if (known_name == text)
          return std::string();
      return "\"" + text + "\" is not one of " + names_text;
    };
    CLI::Option* const option = m_app.add_option_function<std::string>(name, set, description)
                                  ->check(CLI::Validator(check, ""))
                                  ->type_name(names_text)
                                  ->default_str(name_of_default)
                                  ->group(group);
    add_parameter(option, [&value, known] {
      for (const auto& choice : known)
        if (choice.second == value)
          return choice.first;
      return std::string();
    });
    return option;
  }

  // the function gives the value that the option has then
  void add_parameter(const CLI::Option* option, const std::function<std::string()>& value)
  {
    m_parameters.emplace_back(option, value);
  }

  static std::string to_text(double value)
  {
    char text[32];
    std::snprintf(text, sizeof(text), "%g", value);
    return text;
  }

  CLI::App m_app;

private:
  // as TOML has it: in the quotes that are not in the text
  static std::string quoted(const std::string& text)
  {
    const char quote = text.find('"') == std::string::npos ? '"' : '\'';
    return quote + text + quote;
  }

  static std::string with_underscores(std::string name)
  {
    for (char& c : name)
      c = (c == '-') ? '_' : c;
    return name;
  }

  static bool is_part_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

  static void replace_words(std::string& text, const std::string& word, const std::string& replacement)
  {
    for (std::size_t i = text.find(word); i != std::string::npos; i = text.find(word, i))
    {
      const std::size_t end = i + word.size();
      const bool is_word =
        (i == 0 || !is_part_of_word(text[i - 1])) && (end == text.size() || !is_part_of_word(text[end]));
      // a call, or one that says true, is but the name on a command line
      std::size_t length = word.size();
      for (const std::string arguments : {"()", "(true)"})
        length += text.compare(end, arguments.size(), arguments) == 0 ? arguments.size() : 0;
      if (is_word)
        text.replace(i, length, replacement);
      i = is_word ? i + replacement.size() : end;
    }
  }

  std::set<std::string> m_booleans; // names of options
  std::vector<std::pair<const CLI::Option*, std::function<std::string()>>> m_parameters;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_OPTION_PARSER_H
