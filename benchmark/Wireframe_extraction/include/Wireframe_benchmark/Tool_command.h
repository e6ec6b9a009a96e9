// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef WIREFRAME_BENCHMARK_TOOL_COMMAND_H
#define WIREFRAME_BENCHMARK_TOOL_COMMAND_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {

/*!
The command that runs a tool on a cloud: words, as a shell would split them (quotes and backslashes protect), in which
`{in}` stands for the cloud, `{out}` for the result, and `{r}` for the sampling distance. No shell is used.
If neither `{in}` nor `{out}` is there, `{in} -o {out}` is appended.
*/
class Tool_command
{
public:
  /// constructs a command from its text; throws `std::invalid_argument` if it has no words or an open quote.
  explicit Tool_command(const std::string& text) : m_words(split(text))
  {
    if (m_words.empty())
      throw std::invalid_argument("the command of the tool is empty");
    bool has_place = false;
    for (const std::string& word : m_words)
      has_place = has_place || word.find("{in}") != std::string::npos || word.find("{out}") != std::string::npos;
    if (!has_place)
      m_words.insert(m_words.end(), {"{in}", "-o", "{out}"});
  }

  /// constructs a command from words.
  explicit Tool_command(std::vector<std::string> words) : m_words(std::move(words)) {}

  /// returns the program, which is looked for in `PATH` unless there is a slash in it.
  const std::string& program() const { return m_words.front(); }

  /// returns whether the command needs the sampling distance.
  bool uses_sampling_distance() const
  {
    for (const std::string& word : m_words)
      if (word.find("{r}") != std::string::npos)
        return true;
    return false;
  }

  /// returns the words with all places filled in.
  std::vector<std::string> words(const std::string& in, const std::string& out, const std::string& r) const
  {
    std::vector<std::string> result;
    for (const std::string& word : m_words)
      result.push_back(filled(word, {{"{in}", in}, {"{out}", out}, {"{r}", r}}));
    return result;
  }

private:
  static std::string filled(const std::string& word, const std::vector<std::pair<std::string, std::string>>& values)
  {
    std::string result;
    for (std::size_t i = 0; i < word.size();)
    {
      const std::size_t before = i;
      for (const auto& value : values)
        if (word.compare(i, value.first.size(), value.first) == 0)
        {
          result += value.second;
          i += value.first.size();
          break;
        }
      if (i == before)
        result += word[i++];
    }
    return result;
  }

  static std::vector<std::string> split(const std::string& text)
  {
    std::vector<std::string> words;
    std::string word;
    bool is_word = false;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
      const char c = text[i];
      if (c == '\\' && quote != '\'' && i + 1 < text.size())
      {
        word += text[++i];
        is_word = true;
      }
      else if (quote != 0 ? c == quote : c == '"' || c == '\'')
      {
        quote = quote != 0 ? 0 : c;
        is_word = true;
      }
      else if (quote == 0 && (c == ' ' || c == '\t' || c == '\n'))
      {
        if (is_word)
          words.push_back(word);
        word.clear();
        is_word = false;
      }
      else
      {
        word += c;
        is_word = true;
      }
    }
    if (quote != 0)
      throw std::invalid_argument("a quote is open in the command of the tool");
    if (is_word)
      words.push_back(word);
    return words;
  }

  std::vector<std::string> m_words;
};

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_TOOL_COMMAND_H
