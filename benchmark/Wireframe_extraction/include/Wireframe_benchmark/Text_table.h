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

#ifndef WIREFRAME_BENCHMARK_TEXT_TABLE_H
#define WIREFRAME_BENCHMARK_TEXT_TABLE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {

/// returns a number with a fixed count of digits, or a dash if it is not one.
inline std::string fixed(double x, int digits)
{
  if (std::isnan(x))
    return "-";
  char buffer[400];
  std::snprintf(buffer, sizeof(buffer), "%.*f", digits, x);
  return buffer;
}

/// A table that can be read as plain text and as Markdown. The first columns are texts, all others numbers.
class Text_table
{
public:
  Text_table(std::vector<std::string> headings, std::size_t number_of_texts)
    : m_lines(1, std::move(headings)), m_number_of_texts(number_of_texts)
  {}

  void add(std::vector<std::string> line) { m_lines.push_back(std::move(line)); }
  bool is_empty() const { return m_lines.size() == 1; }

  void write_text(std::ostream& out) const
  {
    const std::vector<std::size_t> widths = widths_of_columns();
    for (const auto& line : m_lines)
    {
      std::string text;
      for (std::size_t i = 0; i < line.size(); ++i)
        text += (i == 0 ? "" : "  ") + padded(line[i], widths[i], i);
      out << text.substr(0, text.find_last_not_of(' ') + 1) << '\n';
    }
  }

  void write_markdown(std::ostream& out) const
  {
    const std::vector<std::size_t> widths = widths_of_columns();
    for (std::size_t k = 0; k < m_lines.size(); ++k)
    {
      for (std::size_t i = 0; i < m_lines[k].size(); ++i)
        out << "| " << padded(escaped(m_lines[k][i]), widths[i], i) << ' ';
      out << "|\n";
      for (std::size_t i = 0; k == 0 && i < m_lines[k].size(); ++i)
        out << '|' << std::string(widths[i] + 1, '-') << (i < m_number_of_texts ? '-' : ':');
      out << (k == 0 ? "|\n" : "");
    }
  }

private:
  std::vector<std::size_t> widths_of_columns() const
  {
    std::vector<std::size_t> widths(m_lines.front().size(), 1);
    for (const auto& line : m_lines)
      for (std::size_t i = 0; i < line.size(); ++i)
        widths[i] = (std::max)(widths[i], line[i].size());
    return widths;
  }

  std::string padded(const std::string& text, std::size_t width, std::size_t column) const
  {
    const std::string space(width > text.size() ? width - text.size() : 0, ' ');
    return column < m_number_of_texts ? text + space : space + text;
  }

  static std::string escaped(const std::string& text)
  {
    std::string result;
    for (char c : text)
      result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
  }

  std::vector<std::vector<std::string>> m_lines;
  const std::size_t m_number_of_texts;
};

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_TEXT_TABLE_H
