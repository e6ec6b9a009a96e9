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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_TEXT_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_TEXT_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_chunk.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Text_table.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Unnamed_columns.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/property_names.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Reads the points and distances of a text file and hands them out chunk by chunk.
class Text_cloud_reader
{
public:
  Text_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options)
    : m_table(stream, filename), m_options(options), m_filter(options)
  {}

  // reads all points; `sink(first, last)` gets chunk after chunk of usable samples, and stops the reading by
  // returning `false`
  bool read(Sample_sink& sink)
  {
    std::vector<std::string_view> fields;
    for (;;)
    {
      const Text_table::Row row = m_table.next_row(fields);
      if (row == Text_table::Row::FAILED)
        return false;
      if (row == Text_table::Row::END)
        break;
      if (m_number_of_columns == 0 && is_preamble(fields))
        continue;
      if (m_number_of_columns == 0)
      {
        if (!find_columns(fields))
          return false;
        sink.describe(m_options.distances != nullptr || m_number_of_wanted == 4, m_assumption, distance_place());
      }
      if (!read_row(fields, sink))
        return false;
    }
    return (m_chunk.flush(sink) || fail_as_stopped()) && is_count_as_promised() && is_cloud_usable();
  }

  const Sample_filter& filter() const { return m_filter; }
  const std::string& error() const { return m_table.error(); }

private:
  // A line of names, or the number of points alone, may stand before the first row of data.
  bool is_preamble(const std::vector<std::string_view>& fields)
  {
    if (m_names.empty() && std::none_of(fields.begin(), fields.end(), looks_like_number))
    {
      m_names.assign(fields.begin(), fields.end());
      return true;
    }
    if (fields.size() != 1 || m_has_promised_count)
      return false;
    m_has_promised_count = parse_count(fields[0], m_promised_count);
    return m_has_promised_count;
  }

  // A comment counts as line of names only if it can hardly be anything else: if it has as many words as there are
  // columns, x, y and z among them. What ends with a colon before them, as in "# columns: x y z", is none of the names.
  void take_names_from_comments(std::size_t number_of_columns)
  {
    for (const std::string& comment : m_table.comments())
    {
      std::vector<std::string_view> words;
      const std::size_t title = (std::min)(comment.find(": "), comment.find(":\t"));
      const std::string_view text = std::string_view(comment).substr(title == std::string::npos ? 0 : title + 1);
      Text_table::split_by(Text_table::find_separator(text), text, words);
      const std::vector<std::string> names(words.begin(), words.end());
      if (names.size() == number_of_columns && are_coordinates_among(names))
        m_names = names;
    }
  }

  bool are_coordinates_among(const std::vector<std::string>& names) const
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (find_coordinate_name(names, k, m_options.coordinate_properties) == names.size())
        return false;
    return true;
  }

  bool find_columns(const std::vector<std::string_view>& fields)
  {
    const std::size_t number_of_columns = fields.size();
    m_table.fix_separator();
    m_number_of_columns = number_of_columns;
    if (m_table.has_decimal_commas(fields))
      return m_table.fail_at_line("the numbers have decimal commas; decimals need a point, not a comma");
    const bool needs_distances = m_options.needs_distances();
    if (number_of_columns < (needs_distances ? 4 : 3))
      return m_table.fail_at_line(
        "the row has " + plural(number_of_columns, "column", "columns") + ", at least "
        + (needs_distances ? "4 (x y z distance)" : "3 (x y z)") + " are needed"
        + (number_of_columns == 3 ? "; distances may also come as a separate file" + m_options.estimate_text() : ""));
    if (m_names.empty())
      take_names_from_comments(number_of_columns);
    else if (m_names.size() != number_of_columns)
      return m_table.fail_at_line("the row has " + plural(number_of_columns, "column", "columns")
                                  + ", the line of names has " + std::to_string(m_names.size())
                                  + "; name every column once");
    m_number_of_wanted = m_options.looks_for_distances() ? 4 : 3;
    return find_coordinate_columns() && (m_number_of_wanted == 3 || find_distance_column(fields));
  }

  bool find_coordinate_columns()
  {
    const std::vector<std::string>& wanted = m_options.coordinate_properties;
    if (m_names.empty() && wanted.empty())
      return true; // they are the first
    for (std::size_t i = 0; i < 3; ++i)
    {
      m_columns[i] = m_names.empty() ? column_of_number(wanted[i]) : find_coordinate_name(m_names, i, wanted);
      if (m_columns[i] < m_number_of_columns)
        continue;
      if (m_names.empty())
        return m_table.fail_at_line("no column is named " + quote(wanted[i])
                                    + ", as the file's columns are without "
                                      "names; give the numbers of those with x, y and z, from 1 to "
                                    + std::to_string(m_number_of_columns) + " (coordinate_properties)");
      if (!wanted.empty())
        return fail_at_names("no column is named " + quote(wanted[i]) + " (coordinate_properties)");
      return fail_at_names("the columns of x, y and z cannot all be found; name them (coordinate_properties), or leave "
                           "out the line of names if the first three columns are the coordinates");
    }
    return true;
  }

  // of a column that is named by its number, counted from 1; as many as there are if it is none
  std::size_t column_of_number(const std::string& text) const
  {
    const std::size_t number = column_number(text);
    return number >= 1 && number <= m_number_of_columns ? number - 1 : m_number_of_columns;
  }

  bool find_distance_column(const std::vector<std::string_view>& fields)
  {
    if (!(!m_names.empty()                            ? find_distance_column_by_name()
            : m_options.coordinate_properties.empty() ? find_distance_column_by_number(fields)
                                                      : find_distance_column_beside_coordinates()))
      return false;
    if (m_number_of_wanted == 4)
      m_filter.set_distance_place(" in " + distance_place() + (m_names.empty() ? "" : ","));
    return true;
  }

  // the column with the distances
  std::string distance_place() const
  {
    if (m_number_of_wanted < 4)
      return std::string();
    return "column " + std::to_string(m_columns[3] + 1) + (m_names.empty() ? "" : ", " + quote(m_names[m_columns[3]]));
  }

  // What stands behind the coordinates of columns without names, where distances need not be there.
  bool assume_columns(std::size_t count, const Unnamed_columns& columns)
  {
    if (count == 3)
      m_number_of_wanted = 3;
    else if (count == 6 && columns.have_normals())
      leave_out_distances("columns 4 to 6 are taken for a normal, so the file has no distances");
    else if (columns.have_colours(3))
      leave_out_distances("columns 4 to 6 are taken for a colour, so the file has no distances");
    else if (count == 7 && columns.have_colours(4))
      leave_out_distances("columns 5 to 7 are taken for a colour, so the file has no distances");
    else if (count > 4 && !columns.have_normals())
      m_assumption = "column 4 of " + std::to_string(count) + " is taken for the distance";
    return m_number_of_wanted == 4;
  }

  void leave_out_distances(const std::string& reason)
  {
    m_number_of_wanted = 3;
    m_assumption = reason + "; distance_property names the column if it has";
  }

  bool find_distance_column_by_number(const std::vector<std::string_view>& fields)
  {
    Unnamed_columns columns(fields.size());
    columns.add(fields);
    m_table.for_each_row_ahead([&columns](const std::vector<std::string_view>& ahead) { columns.add(ahead); });
    if (!m_options.needs_distances() && !assume_columns(fields.size(), columns))
      return true;
    const std::string& wanted = m_options.distance_property;
    std::size_t number = 4;
    if (wanted.empty() && (columns.have_normals() || columns.have_colours(3)))
      return m_table.fail_at_line("the row has " + std::to_string(m_number_of_columns)
                                  + " columns without names, of which 4 to 6 look like a "
                                  + (columns.have_normals() ? "normal" : "colour")
                                  + "; say which one holds the distance by its number, "
                                    "counted from 1 (distance_property), or put a line of names first"
                                  + m_options.estimate_text());
    if (!wanted.empty()
        && (!parse_count(std::string_view(wanted), number) || number < 4 || number > m_number_of_columns))
      return m_table.fail_at_line("no column is named " + quote(wanted)
                                  + ", as the file's columns are without names; "
                                    "give the number of the one with the distance, from 4 to "
                                  + std::to_string(m_number_of_columns)
                                  + " (distance_property), or put a line of names "
                                    "first");
    m_columns[3] = number - 1;
    return true;
  }

  // the same where the columns of the coordinates are known by their numbers
  bool find_distance_column_beside_coordinates()
  {
    const std::string& wanted = m_options.distance_property;
    m_columns[3] = !wanted.empty() ? column_of_number(wanted)
      : m_number_of_columns == 4   ? other_column()
                                   : m_number_of_columns;
    const bool is_coordinate =
      std::find(m_columns.begin(), m_columns.begin() + 3, m_columns[3]) < m_columns.begin() + 3;
    if (m_columns[3] < m_number_of_columns && !is_coordinate)
      return true;
    if (m_options.needs_distances())
      return m_table.fail_at_line(wanted.empty()
                                    ? "the columns are without names; say which one holds the distance by its "
                                      "number, counted from 1 (distance_property)"
                                      + m_options.estimate_text()
                                    : "no column but those of the coordinates is named " + quote(wanted)
                                      + ", as the file's columns are without names; give the number of the one with "
                                        "the distance (distance_property)");
    leave_out_distances("no column is known to be a distance, so the file has none");
    return true;
  }

  bool find_distance_column_by_name()
  {
    m_columns[3] = find_distance_name(m_names, m_options.distance_property);
    if (m_columns[3] < m_names.size())
      return true;
    if (!m_options.distance_property.empty())
      return fail_at_names("no column is named " + quote(m_options.distance_property));
    if (!m_options.needs_distances() && (m_names.size() != 4 || is_other_name(m_names[other_column()])))
    {
      m_number_of_wanted = 3;
      m_assumption = no_distance_note(m_names);
      return true;
    }
    if (m_names.size() > 4 || is_other_name(m_names[other_column()]))
      return fail_at_names("no column is named as the distance (looked for: " + join(known_distance_names())
                           + "); name the right one (distance_property)" + m_options.estimate_text());
    m_columns[3] = other_column();
    if (!m_options.needs_distances())
      m_assumption = "the column " + quote(m_names[m_columns[3]]) + " is taken for the distance";
    return true;
  }

  // of four columns the one besides the coordinates
  std::size_t other_column() const { return 6 - m_columns[0] - m_columns[1] - m_columns[2]; }

  bool fail_at_names(const std::string& what)
  {
    return m_table.fail(m_table.filename() + ": " + what + "; the file's columns are: " + join(m_names));
  }

  bool read_row(const std::vector<std::string_view>& fields, Sample_sink& sink)
  {
    if (fields.size() != m_number_of_columns)
      return m_table.fail_at_line("the row has " + plural(fields.size(), "column", "columns")
                                  + ", the rows before have " + std::to_string(m_number_of_columns)
                                  + "; complete it, or leave it out");
    std::array<double, 4> values = {{0., 0., 0., 0.}};
    for (std::size_t i = 0; i < m_number_of_wanted; ++i)
    {
      const std::string_view field = fields[m_columns[i]];
      if (!parse_number(field, values[i]))
        return m_table.fail_at_line("column " + std::to_string(m_columns[i] + 1) + " is " + no_number_text(field)
                                    + ", or leave the line out");
    }
    Distance_sample sample = {values[0], values[1], values[2], values[3]};
    return !m_filter(sample, m_table.line_number()) || m_chunk.add(sample, sink) || fail_as_stopped();
  }

  bool fail_as_stopped() { return m_table.fail(m_table.filename() + ": " + Sample_chunk::stopped_text()); }

  bool is_count_as_promised()
  {
    if (!m_has_promised_count || m_promised_count == m_filter.number_of_samples())
      return true;
    return m_table.fail(m_table.filename() + ": its first line promises " + std::to_string(m_promised_count)
                        + " points, it holds " + std::to_string(m_filter.number_of_samples())
                        + ": it is truncated or its first line is wrong; get a complete copy of it, or correct "
                          "that line");
  }

  bool is_cloud_usable()
  {
    std::string error;
    if (m_table.is_empty_file())
      error = m_table.filename() + ": " + empty_file_text();
    else if (m_filter.is_cloud_usable(m_table.filename(), error))
      return true;
    return m_table.fail(error);
  }

  Text_table m_table;
  const Cloud_reader_options& m_options;
  Sample_filter m_filter;
  std::vector<std::string> m_names;
  std::size_t m_number_of_columns = 0, m_number_of_wanted = 4;
  std::string m_assumption;
  std::array<std::size_t, 4> m_columns = {{0, 1, 2, 3}};
  bool m_has_promised_count = false;
  std::size_t m_promised_count = 0;
  Sample_chunk m_chunk;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_TEXT_CLOUD_READER_H
