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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_TEXT_TABLE_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_TEXT_TABLE_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Hands out the lines of a text file that hold data, split into columns. Fields may be quoted, and comments start with
// #, // or %, or in the middle of a line with # behind a separator: 1.#QNAN is a number.
class Text_table
{
public:
  // comments before the first row that are kept, the last ones; and bytes that can be looked at before they are read
  static constexpr std::size_t most_comments = 32, bytes_ahead = std::size_t(1) << 16;

  Text_table(std::istream& stream, const std::string& filename) : m_input(stream), m_filename(filename) {}

  enum class Row
  {
    DATA,
    END,
    FAILED
  };

  // The first line of data decides what separates the columns, unless a line such as "sep=;" before it does: a
  // semicolon if it has one, else a comma if it has one, else blanks. So a decimal comma can never
  // pass as a separator unnoticed.
  Row next_row(std::vector<std::string_view>& fields)
  {
    std::string_view line;
    for (;;)
    {
      const Chunked_input::Line_status status = m_input.next_line(line);
      if (status == Chunked_input::Line_status::TOO_LONG)
        return fail_after_line("is longer than a line of numbers can be; is this a text file?");
      if (status == Chunked_input::Line_status::END)
        return m_input.has_failed() ? fail_after_line("reading failed") : Row::END;
      if (m_input.line_number() == 1 && starts_with(line, "\xEF\xBB\xBF"))
        line.remove_prefix(3);
      line = trim(line);
      if (is_comment(line) && m_number_of_rows == 0)
        keep_comment(line);
      if (m_number_of_rows == 0 && takes_separator(line))
        continue;
      line = data_of(line);
      if (line.empty())
        continue;
      if (!m_is_separator_fixed)
      {
        if (has_control_characters(line))
          return fail_with(line_number(),
                           "holds bytes that are no text; only plain text in ASCII or UTF-8 "
                           "is read");
        line = m_line = std::string(line); // which stays when one looks ahead
      }
      split(line, fields);
      return Row::DATA;
    }
  }

  // to be called when the first row of data was recognised: from now on its separator is the separator
  void fix_separator() { m_is_separator_fixed = true; }

  // Calls `visit(fields)` for some of the rows that come next. They are handed out nevertheless.
  template <class Visit>
  void for_each_row_ahead(const Visit& visit)
  {
    const std::size_t size = m_input.require(bytes_ahead);
    const std::string_view text(m_input.data(), size);
    std::vector<std::string_view> fields;
    for (std::size_t begin = 0; begin < size;)
    {
      const std::size_t end = (std::min)(text.find_first_of("\r\n", begin), size);
      if (end == size && size == bytes_ahead)
        return; // there is more of this line
      const std::string_view line = data_of(trim(text.substr(begin, end - begin)));
      begin = end + 1;
      if (line.empty())
        continue;
      split_by(m_separator, line, fields);
      visit(fields);
    }
  }

  // Whether columns of numbers were split at commas that can only be decimal ones: "0,5 1,5" is 0, 5 1 and 5.
  bool has_decimal_commas(const std::vector<std::string_view>& fields) const
  {
    std::vector<std::string_view> words;
    double value;
    return m_separator == ',' && std::any_of(fields.begin(), fields.end(), [&](std::string_view field) {
             split_at_blanks(field, words);
             return words.size() > 1 && std::all_of(words.begin(), words.end(), [&](std::string_view word) {
                      return parse_number(word, value);
                    });
           });
  }

  // the comments before the first row, without what makes them comments
  const std::vector<std::string>& comments() const { return m_comments; }

  bool is_empty_file() { return m_input.consumed() == 0; }
  std::size_t line_number() const { return m_input.line_number(); }
  const std::string& filename() const { return m_filename; }
  const std::string& error() const { return m_error; }

  bool fail(const std::string& error)
  {
    m_error = error;
    return false;
  }

  bool fail_at_line(const std::string& what)
  {
    return fail(m_filename + ":" + std::to_string(line_number()) + ": " + what);
  }

  static char find_separator(std::string_view line)
  {
    if (line.find(';') != std::string_view::npos)
      return ';';
    return line.find(',') != std::string_view::npos ? ',' : ' ';
  }

  static void split_by(char separator, std::string_view line, std::vector<std::string_view>& fields)
  {
    if (separator == ' ')
      split_at_blanks(line, fields);
    else
      split_at(separator, line, fields);
    for (std::string_view& field : fields)
      if (field.size() >= 2 && (field.front() == '"' || field.front() == '\'') && field.back() == field.front())
        field = trim(field.substr(1, field.size() - 2));
  }

private:
  static bool is_comment(std::string_view line)
  {
    return starts_with(line, "#") || starts_with(line, "//") || starts_with(line, "%");
  }

  // a line without its comment
  static std::string_view data_of(std::string_view line)
  {
    if (is_comment(line))
      return std::string_view();
    for (std::size_t i = line.find('#'); i != std::string_view::npos; i = line.find('#', i + 1))
      if (is_blank(line[i - 1]) || line[i - 1] == ',' || line[i - 1] == ';')
        return trim(line.substr(0, i));
    return line;
  }

  void keep_comment(std::string_view line)
  {
    if (m_comments.size() == most_comments)
      m_comments.erase(m_comments.begin());
    m_comments.emplace_back(line.substr(line[0] == '/' ? 2 : 1));
  }

  // what spreadsheets write as the first line
  bool takes_separator(std::string_view line)
  {
    if (to_lower(line.substr(0, 4)) != "sep=" || line.size() > 5)
      return false;
    m_separator = line.size() == 5 && (line[4] == ';' || line[4] == ',') ? line[4] : ' '; // a tab was trimmed
    m_is_separator_given = true;
    return true;
  }

  static bool has_control_characters(std::string_view line)
  {
    return std::any_of(line.begin(), line.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 32 && !is_blank(c); });
  }

  Row fail_with(std::size_t line_number, const std::string& what)
  {
    m_error = m_filename + ":" + std::to_string(line_number) + ": " + what;
    return Row::FAILED;
  }

  Row fail_after_line(const std::string& what) { return fail_with(line_number() + 1, what); }

  void split(std::string_view line, std::vector<std::string_view>& fields)
  {
    ++m_number_of_rows;
    if (!m_is_separator_fixed && !m_is_separator_given)
      m_separator = find_separator(line);
    split_by(m_separator, line, fields);
  }

  Chunked_input m_input;
  std::string m_filename;
  std::vector<std::string> m_comments;
  std::string m_line; // of which fields are, until the separator is fixed
  std::string m_error;
  char m_separator = ' ';
  bool m_is_separator_fixed = false, m_is_separator_given = false;
  std::size_t m_number_of_rows = 0;
};

// a number, or what was meant to be one, such as "1,5"
inline bool looks_like_number(std::string_view field)
{
  double value;
  return !field.empty()
    && (std::string_view("0123456789+-.").find(field[0]) != std::string_view::npos || parse_number(field, value));
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_TEXT_TABLE_H
