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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_TEXT_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_TEXT_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/text_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Hands out the lines of a text file that hold data, split into columns.
class Text_table
{
public:
  Text_table(std::istream& stream, const std::string& filename) : input_(stream), filename_(filename) {}

  enum class Row { DATA, END, FAILED };

  // The first line of data decides what separates the columns: a semicolon if it has one, else a comma if it
  // has one, else blanks. So a decimal comma can never pass as a separator unnoticed.
  Row next_row(std::vector<std::string_view>& fields)
  {
    std::string_view line;
    for(;;)
    {
      const Chunked_input::Line_status status = input_.next_line(line);
      if(status == Chunked_input::Line_status::TOO_LONG)
        return fail_after_line("is longer than a line of numbers can be; is this a text file?");
      if(status == Chunked_input::Line_status::END)
        return input_.has_failed() ? fail_after_line("reading failed") : Row::END;
      if(input_.line_number() == 1 && starts_with(line, "\xEF\xBB\xBF"))
        line.remove_prefix(3);
      line = trim(line);
      if(is_comment(line))
      {
        if(number_of_rows_ == 0)
          last_comment_ = std::string(line.substr(line[0] == '#' ? 1 : 2));
        continue;
      }
      line = trim(line.substr(0, line.find('#')));
      if(line.empty())
        continue;
      if(!is_separator_fixed_ && has_control_characters(line))
        return fail_with(line_number(), "holds bytes that are no text; only plain text in ASCII or UTF-8 "
                                        "is read");
      split(line, fields);
      return Row::DATA;
    }
  }

  // to be called when the first row of data was recognised: from now on its separator is the separator
  void fix_separator() { is_separator_fixed_ = true; }

  // Whether columns of numbers were split at commas that can only be decimal ones: "0,5 1,5" is 0, 5 1 and 5.
  bool has_decimal_commas(const std::vector<std::string_view>& fields) const
  {
    std::vector<std::string_view> words;
    double value;
    return separator_ == ',' && std::any_of(fields.begin(), fields.end(), [&](std::string_view field)
    {
      split_at_blanks(field, words);
      return words.size() > 1 && std::all_of(words.begin(), words.end(),
                                             [&](std::string_view word) { return parse_number(word, value); });
    });
  }

  // the last comment before the first row of data
  const std::string& last_comment() const { return last_comment_; }

  bool is_empty_file() { return input_.consumed() == 0; }
  std::size_t line_number() const { return input_.line_number(); }
  const std::string& filename() const { return filename_; }
  const std::string& error() const { return error_; }

  bool fail(const std::string& error)
  {
    error_ = error;
    return false;
  }

  bool fail_at_line(const std::string& what)
  {
    return fail(filename_ + ":" + std::to_string(line_number()) + ": " + what);
  }

  static char find_separator(std::string_view line)
  {
    if(line.find(';') != std::string_view::npos)
      return ';';
    return line.find(',') != std::string_view::npos ? ',' : ' ';
  }

  static void split_by(char separator, std::string_view line, std::vector<std::string_view>& fields)
  {
    if(separator == ' ')
      split_at_blanks(line, fields);
    else
      split_at(separator, line, fields);
  }

private:
  static bool is_comment(std::string_view line)
  {
    return starts_with(line, "#") || starts_with(line, "//");
  }

  static bool has_control_characters(std::string_view line)
  {
    return std::any_of(line.begin(), line.end(),
                       [](char c) { return static_cast<unsigned char>(c) < 32 && !is_blank(c); });
  }

  Row fail_with(std::size_t line_number, const std::string& what)
  {
    error_ = filename_ + ":" + std::to_string(line_number) + ": " + what;
    return Row::FAILED;
  }

  Row fail_after_line(const std::string& what)
  {
    return fail_with(line_number() + 1, what);
  }

  void split(std::string_view line, std::vector<std::string_view>& fields)
  {
    ++number_of_rows_;
    if(!is_separator_fixed_)
      separator_ = find_separator(line);
    split_by(separator_, line, fields);
  }

  Chunked_input input_;
  std::string filename_;
  std::string last_comment_;
  std::string error_;
  char separator_ = ' ';
  bool is_separator_fixed_ = false;
  std::size_t number_of_rows_ = 0;
};

// a number, or what was meant to be one, such as "1,5"
inline bool looks_like_number(std::string_view field)
{
  double value;
  return !field.empty() && (std::string_view("0123456789+-.").find(field[0]) != std::string_view::npos
                            || parse_number(field, value));
}

// Reads the points and distances of a text file and hands them out chunk by chunk.
class Text_cloud_reader
{
public:
  Text_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options)
    : table_(stream, filename), options_(options), filter_(options)
  {}

  // reads all points; `sink(first, last)` gets chunk after chunk of usable samples, and stops the reading by
  // returning `false`
  template <class Sink>
  bool read(Sink&& sink)
  {
    std::vector<std::string_view> fields;
    for(;;)
    {
      const Text_table::Row row = table_.next_row(fields);
      if(row == Text_table::Row::FAILED)
        return false;
      if(row == Text_table::Row::END)
        break;
      if(number_of_columns_ == 0 && is_preamble(fields))
        continue;
      if(number_of_columns_ == 0 && !find_columns(fields))
        return false;
      if(!read_row(fields) || (chunk_.size() == samples_per_chunk && !flush(sink)))
        return false;
    }
    return flush(sink) && is_count_as_promised() && is_cloud_usable();
  }

  const Sample_filter& filter() const { return filter_; }
  const std::string& error() const { return table_.error(); }

private:
  static constexpr std::size_t samples_per_chunk = 4096;

  std::size_t number_of_wanted() const { return options_.distances == nullptr ? 4 : 3; }

  // A line of names, or the number of points alone, may stand before the first row of data.
  bool is_preamble(const std::vector<std::string_view>& fields)
  {
    if(names_.empty() && std::none_of(fields.begin(), fields.end(), looks_like_number))
    {
      set_names(fields);
      return true;
    }
    if(fields.size() != 1 || has_promised_count_)
      return false;
    has_promised_count_ = parse_count(fields[0], promised_count_);
    return has_promised_count_;
  }

  void set_names(const std::vector<std::string_view>& fields)
  {
    names_.clear();
    for(std::string_view field : fields)
    {
      if(field.size() >= 2 && (field.front() == '"' || field.front() == '\'')
         && field.back() == field.front())
        field = field.substr(1, field.size() - 2);
      names_.emplace_back(field);
    }
  }

  // A comment counts as line of names only if it can hardly be anything else, such as "# columns: x y z".
  void take_names_from_comment(std::size_t number_of_columns)
  {
    std::vector<std::string_view> fields;
    const std::string_view comment = table_.last_comment();
    Text_table::split_by(Text_table::find_separator(comment), comment, fields);
    if(fields.size() != number_of_columns || comment.find(':') != std::string_view::npos)
      return;
    set_names(fields);
    const std::size_t none = names_.size();
    if(find_name(names_, "x") == none || find_name(names_, "y") == none || find_name(names_, "z") == none
       || (number_of_wanted() == 4 && find_distance_name(names_, options_.distance_property) == none))
      names_.clear();
  }

  bool find_columns(const std::vector<std::string_view>& fields)
  {
    const std::size_t number_of_columns = fields.size();
    table_.fix_separator();
    number_of_columns_ = number_of_columns;
    if(table_.has_decimal_commas(fields))
      return table_.fail_at_line("the numbers have decimal commas; decimals need a point, not a comma");
    if(number_of_columns < number_of_wanted())
      return table_.fail_at_line("the row has " + plural(number_of_columns, "column", "columns")
                                 + ", at least "
                                 + (number_of_wanted() == 4 ? "4 (x y z distance)" : "3 (x y z)")
                                 + " are needed"
                                 + (number_of_columns == 3 ? "; distances may also come as a separate file"
                                                           : ""));
    if(names_.empty())
      take_names_from_comment(number_of_columns);
    else if(names_.size() != number_of_columns)
      return table_.fail_at_line("the row has " + plural(number_of_columns, "column", "columns")
                                 + ", the line of names has " + std::to_string(names_.size())
                                 + "; name every column once");
    return find_coordinate_columns() && (number_of_wanted() == 3 || find_distance_column(fields));
  }

  bool find_coordinate_columns()
  {
    static const char* const coordinates[] = { "x", "y", "z" };
    std::size_t number_of_found = 0;
    for(std::size_t i = 0; i < 3; ++i)
    {
      columns_[i] = find_name(names_, coordinates[i]);
      number_of_found += (columns_[i] < names_.size()) ? 1 : 0;
    }
    if(number_of_found == 0)
      columns_ = {{ 0, 1, 2, 3 }};
    else if(number_of_found < 3)
      return fail_at_names("the columns of x, y and z cannot all be found; name them so");
    return true;
  }

  bool find_distance_column(const std::vector<std::string_view>& fields)
  {
    if(!(names_.empty() ? find_distance_column_by_number(fields) : find_distance_column_by_name()))
      return false;
    filter_.set_distance_place(" in column " + std::to_string(columns_[3] + 1)
                               + (names_.empty() ? "" : ", " + quote(names_[columns_[3]]) + ","));
    return true;
  }

  // Whether the numbers behind the coordinates are a vector of length 1: a normal, rather than a distance and more.
  static bool may_have_normals(const std::vector<std::string_view>& fields)
  {
    double square = 0., value;
    return fields.size() > 5
           && std::all_of(fields.begin() + 3, fields.begin() + 6, [&](std::string_view field)
              {
                const bool is_number = parse_number(field, value);
                square += value * value;
                return is_number;
              })
           && std::abs(square - 1.) < 0.02;
  }

  bool find_distance_column_by_number(const std::vector<std::string_view>& fields)
  {
    const std::string& wanted = options_.distance_property;
    std::size_t number = 4;
    if(wanted.empty() && may_have_normals(fields))
      return table_.fail_at_line("the row has " + std::to_string(number_of_columns_) + " columns without names, of which "
                                 "4 to 6 look like a normal; say which one holds the distance by its number, "
                                 "counted from 1 (distance_property), or put a line of names first");
    if(!wanted.empty() && (!parse_count(std::string_view(wanted), number) || number < 4 || number > number_of_columns_))
      return table_.fail_at_line("no column is named " + quote(wanted) + ", as the file's columns are without names; "
                                 "give the number of the one with the distance, from 4 to "
                                 + std::to_string(number_of_columns_) + " (distance_property), or put a line of names "
                                 "first");
    columns_[3] = number - 1;
    return true;
  }

  bool find_distance_column_by_name()
  {
    columns_[3] = find_distance_name(names_, options_.distance_property);
    if(columns_[3] < names_.size())
      return true;
    if(!options_.distance_property.empty())
      return fail_at_names("no column is named " + quote(options_.distance_property));
    if(names_.size() > 4)
      return fail_at_names("no column is named as the distance (looked for: " + join(known_distance_names())
                           + "); name the right one (distance_property)");
    columns_[3] = 6 - columns_[0] - columns_[1] - columns_[2];
    return true;
  }

  bool fail_at_names(const std::string& what)
  {
    return table_.fail(table_.filename() + ": " + what + "; the file's columns are: " + join(names_));
  }

  bool read_row(const std::vector<std::string_view>& fields)
  {
    if(fields.size() != number_of_columns_)
      return table_.fail_at_line("the row has " + plural(fields.size(), "column", "columns")
                                 + ", the rows before have " + std::to_string(number_of_columns_)
                                 + "; complete it, or leave it out");
    std::array<double, 4> values = {{ 0., 0., 0., 0. }};
    for(std::size_t i = 0; i < number_of_wanted(); ++i)
    {
      const std::string_view field = fields[columns_[i]];
      if(!parse_number(field, values[i]))
        return table_.fail_at_line("column " + std::to_string(columns_[i] + 1) + " is " + no_number_text(field)
                                   + ", or leave the line out");
    }
    Distance_sample sample = { values[0], values[1], values[2], values[3] };
    if(filter_(sample, table_.line_number()))
      chunk_.push_back(sample);
    return true;
  }

  template <class Sink>
  bool flush(Sink& sink)
  {
    const bool goes_on = chunk_.empty() || sink(chunk_.data(), chunk_.data() + chunk_.size());
    chunk_.clear();
    return goes_on || table_.fail(table_.filename() + ": reading was stopped");
  }

  bool is_count_as_promised()
  {
    if(!has_promised_count_ || promised_count_ == filter_.number_of_samples())
      return true;
    return table_.fail(table_.filename() + ": its first line promises " + std::to_string(promised_count_)
                       + " points, it holds " + std::to_string(filter_.number_of_samples())
                       + ": it is truncated or its first line is wrong; get a complete copy of it, or correct "
                         "that line");
  }

  bool is_cloud_usable()
  {
    std::string error;
    if(table_.is_empty_file())
      error = table_.filename() + ": " + empty_file_text();
    else if(filter_.is_cloud_usable(table_.filename(), error))
      return true;
    return table_.fail(error);
  }

  Text_table table_;
  const Cloud_reader_options& options_;
  Sample_filter filter_;
  std::vector<std::string> names_;
  std::size_t number_of_columns_ = 0;
  std::array<std::size_t, 4> columns_ = {{ 0, 1, 2, 3 }};
  bool has_promised_count_ = false;
  std::size_t promised_count_ = 0;
  std::vector<Distance_sample> chunk_;
};

// reads a text file of one distance per line
inline bool read_separate_distances(std::istream& stream, const std::string& filename,
                                    Separate_distances& distances, std::string& error)
{
  Text_table table(stream, filename);
  std::vector<std::string_view> fields;
  distances.filename = filename;
  bool has_names = false;
  Text_table::Row row;
  while((row = table.next_row(fields)) == Text_table::Row::DATA)
  {
    double value = 0.;
    if(fields.size() == 1 && parse_number(fields[0], value))
    {
      if(distances.first_bad_line == 0 && !(std::isfinite(value) && value >= 0.))
        distances.first_bad_line = table.line_number();
      distances.values.push_back(value);
    }
    else if(distances.values.empty() && !has_names && fields.size() == 1 && !looks_like_number(fields[0]))
      has_names = true;
    else
    {
      table.fail_at_line(fields.size() == 1 ? "the distance is " + no_number_text(fields[0])
                                            : "a distances file has one number per line, this line has "
                                              + std::to_string(fields.size()) + " columns; remove all but the "
                                                "distance, and write decimals with a point");
      break;
    }
  }
  error = table.error();
  if(error.empty() && distances.values.empty())
    error = filename + ": "
            + (table.is_empty_file() ? empty_file_text() : "holds no distances; write one for each point into it");
  return error.empty();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_TEXT_CLOUD_READER_H
