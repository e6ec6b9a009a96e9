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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ARRAY_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ARRAY_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Array_file.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_chunk.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/property_names.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// names of the data set that says where the points of a patch are in the cloud
inline const std::vector<std::string>& known_index_names()
{
  static const std::vector<std::string> names = {"indices", "indexes_in_whole"};
  return names;
}

// Makes a cloud of an array of points, one of distances, and one of indices.
class Array_cloud_reader
{
public:
  explicit Array_cloud_reader(const Cloud_reader_options& options) : m_options(options), m_filter(options) {}

  bool read(Array_file& file, Sample_sink& sink)
  {
    std::string name, note;
    std::size_t distances_index = file.names().size();
    m_has_distances = m_options.looks_for_distances() && find_distances(file, m_options, distances_index);
    if (!find_points(file, distances_index, name, note))
      return false;
    Rows rows;
    if (find_rows(file, name, rows))
    {
      sink.describe(m_options.distances != nullptr || m_has_distances, note, distance_place(&file, distances_index));
      return read_by_rows(file, rows, sink);
    }
    Number_array points, distances, indices;
    if (!file.read(name, points, m_error))
      return false;
    const std::string points_word = std::string(file.word_for_array()) + " " + quote(name);
    if (!choose_columns(file.filename(), points_word, points, note))
      return false;
    if (m_options.needs_distances() && !m_has_distances && !m_has_distance_column)
      return fail(no_distances_text(file, m_options));
    if (m_has_distances && !read_distances(file, points, points_word, distances))
      return false;
    sink.describe(m_options.distances != nullptr || m_has_distances || m_has_distance_column, note,
                  distance_place(&file, distances_index, points.columns));
    return read_indices(file, points, points_word, indices)
      && hand_out(file.filename(), points, distances, indices, sink);
  }

  // the same for a single array, which holds the distances, too, if there are any
  bool read(const std::string& filename, const Number_array& points, Sample_sink& sink)
  {
    std::string note;
    if (!choose_columns(filename, "array", points, note))
      return false;
    if (!m_has_distance_column && m_options.needs_distances())
      return fail(filename + ": its array has "
                  + (points.columns.empty() ? "the shape " + shape_text(points) : "the fields " + join(points.columns))
                  + ", so it has points but no distances; give the distances as a separate file, or as a fourth "
                    "column, or both arrays in one .npz file"
                  + m_options.estimate_text());
    sink.describe(m_options.distances != nullptr || m_has_distance_column, note,
                  distance_place(nullptr, 0, points.columns));
    return hand_out(filename, points, Number_array(), Number_array(), sink);
  }

  const Sample_filter& filter() const { return m_filter; }
  const std::string& error() const { return m_error; }

  // the name that the distances have in a file: the one wanted, else the first known one that is there
  static bool find_distances(const Array_file& file, const Cloud_reader_options& options, std::size_t& index)
  {
    const std::string& wanted =
      options.distances_dataset.empty() ? options.distance_property : options.distances_dataset;
    index = find_distance_name(file.names(), wanted);
    return index < file.names().size();
  }

  static std::string no_distances_text(Array_file& file, const Cloud_reader_options& options)
  {
    const std::string& wanted =
      options.distances_dataset.empty() ? options.distance_property : options.distances_dataset;
    return file.filename() + ": has no " + file.word_for_array() + " "
      + (wanted.empty() ? "for the distances (looked for: " + join(known_distance_names()) + ")" : quote(wanted))
      + "; it has: " + file.contents_text()
      + ". Name the one that holds the distances (distances_dataset), or give the distances as a separate file"
      + options.estimate_text();
  }

private:
  // What holds the distances: an array of its own, or a column, which may have a name. Nothing if there are none.
  std::string distance_place(const Array_file* file, std::size_t index,
                             const std::vector<std::string>& columns = std::vector<std::string>()) const
  {
    if (m_has_distances)
      return std::string("the ") + file->word_for_array() + " " + quote(file->names()[index]);
    if (!m_has_distance_column)
      return std::string();
    return "column " + std::to_string(m_columns[3] + 1) + (columns.empty() ? "" : ", " + quote(columns[m_columns[3]]));
  }

  bool fail(const std::string& error)
  {
    m_error = error;
    return false;
  }

  // The name of the array of points: the one wanted, the usual one, or the only one that is there besides distances.
  bool find_points(Array_file& file, std::size_t distances_index, std::string& name, std::string& note)
  {
    const std::string wanted = m_options.points_dataset.empty() ? "points" : m_options.points_dataset;
    const std::vector<std::string>& names = file.names();
    std::size_t index = find_name(names, wanted);
    if (index == names.size() && m_options.points_dataset.empty() && names.size() == (m_has_distances ? 2 : 1))
    {
      index = m_has_distances && distances_index == 0 ? 1 : 0;
      note = std::string("the ") + file.word_for_array() + " " + quote(names[index]) + " is taken for the points";
    }
    if (index == names.size())
      return fail(file.filename() + ": has no " + file.word_for_array() + " " + quote(wanted)
                  + "; it has: " + file.contents_text() + ". Name the one that holds the points (points_dataset)");
    name = names[index];
    return true;
  }

  // Finds what the numbers of a row are: by the names of the columns if they have some, else by their number.
  bool choose_columns(const std::string& filename, const std::string& word, const Number_array& points,
                      std::string& note)
  {
    if (!points.columns.empty())
      return choose_columns_by_name(filename, word, points, note);
    const bool is_shape_of_points = !points.is_ragged && (points.shape.size() == 2 || points.shape.size() == 3);
    m_number_of_columns = is_shape_of_points ? static_cast<std::size_t>(points.shape.back()) : 3;
    const bool is_told = !m_options.coordinate_properties.empty() || column_number(m_options.distance_property) > 0;
    bool is_fine = false;
    if (points.is_ragged)
      is_fine =
        std::all_of(points.row_sizes.begin(), points.row_sizes.end(), [](std::uint64_t size) { return size % 3 == 0; });
    else
      is_fine = is_shape_of_points && m_number_of_columns >= 3
        && (is_told || m_number_of_columns < 5 || (m_number_of_columns == 6 && !m_options.needs_distances()));
    if (!is_fine)
      return fail(filename + ": its " + word + " has the shape " + shape_text(points)
                  + (points.is_ragged ? ", not all of multiples of three" : "")
                  + "; points have the shape N x 3, or in patches B x N x 3, or with their distances N x 4"
                  + (word == "array" ? "; which columns are what, their numbers can tell (coordinate_properties, "
                                       "distance_property)"
                                     : ". Name the one that holds the points (points_dataset)"));
    m_number_of_points = points.values.size() / m_number_of_columns;
    if (points.is_ragged)
      return true;
    return choose_columns_by_number(filename, note);
  }

  bool choose_columns_by_number(const std::string& filename, std::string& note)
  {
    const std::vector<std::string>& wanted = m_options.coordinate_properties;
    for (std::size_t k = 0; k < wanted.size(); ++k)
    {
      const std::size_t number = column_number(wanted[k]);
      if (number == 0 || number > m_number_of_columns)
        return fail(filename + ": no column is named " + quote(wanted[k])
                    + ", as the columns of its array are without "
                      "names; give the numbers of those with x, y and z, from 1 to "
                    + std::to_string(m_number_of_columns) + " (coordinate_properties)");
      m_columns[k] = number - 1;
    }
    const std::size_t number = column_number(m_options.distance_property);
    if (m_has_distances || !m_options.looks_for_distances())
      return true;
    m_has_distance_column = number > 0 ? number <= m_number_of_columns : m_number_of_columns == 4;
    m_columns[3] = number > 0 ? number - 1 : 6 - m_columns[0] - m_columns[1] - m_columns[2];
    if (!m_has_distance_column && m_number_of_columns == 6)
      note += std::string(note.empty() ? "" : "; ") + "the last three of its six columns are not looked at";
    return true;
  }

  // the fields of a structured array
  bool choose_columns_by_name(const std::string& filename, const std::string& word, const Number_array& points,
                              std::string& note)
  {
    const std::vector<std::string>& names = points.columns;
    m_number_of_columns = names.size();
    m_number_of_points = points.values.size() / m_number_of_columns;
    for (std::size_t k = 0; k < 3; ++k)
    {
      m_columns[k] = find_coordinate_name(names, k, m_options.coordinate_properties);
      if (m_columns[k] == names.size())
        return fail(filename + ": its " + word + " has no field "
                    + quote(coordinate_name(k, m_options.coordinate_properties)) + "; it has: " + join(names)
                    + ". Name those that hold the coordinates (coordinate_properties)");
    }
    if (m_has_distances || !m_options.looks_for_distances())
      return true;
    m_columns[3] = find_distance_name(names, m_options.distance_property);
    m_has_distance_column = m_columns[3] < names.size();
    if (!m_has_distance_column && !m_options.needs_distances())
      note += (note.empty() || no_distance_note(names).empty() ? "" : "; ") + no_distance_note(names);
    return true;
  }

  // points, and distances unless they come separately, that can be read some rows at a time
  struct Rows
  {
    std::string points, distances;
    std::uint64_t count = 0, points_per_row = 1;
  };

  // All else, and what is wrong, is for those who read whole arrays.
  bool find_rows(Array_file& file, const std::string& points_name, Rows& rows) const
  {
    std::vector<std::uint64_t> shape, distances_shape;
    std::uint64_t number_of_values;
    if (m_options.reads_indices || !m_options.coordinate_properties.empty()
        || (m_options.needs_distances() && !m_has_distances) || !file.find_rows(points_name, shape)
        || (shape.size() != 2 && shape.size() != 3) || shape.back() != 3
        || !find_number_of_values(shape, number_of_values))
      return false;
    rows.points = points_name;
    rows.count = shape.front();
    shape.pop_back();
    rows.points_per_row = shape.size() == 2 ? shape.back() : 1;
    if (!m_has_distances)
      return true;
    std::size_t index;
    if (!find_distances(file, m_options, index) || !file.find_rows(file.names()[index], distances_shape))
      return false;
    rows.distances = file.names()[index];
    if (distances_shape.size() == shape.size() + 1 && distances_shape.back() == 1)
      distances_shape.pop_back();
    return distances_shape == shape;
  }

  bool read_by_rows(Array_file& file, const Rows& rows, Sample_sink& sink)
  {
    const std::uint64_t points_at_once = std::uint64_t(1) << 18;
    const std::uint64_t step =
      (std::max)(std::uint64_t(1), points_at_once / (std::max)(std::uint64_t(1), rows.points_per_row));
    Number_array points, distances;
    for (std::uint64_t first = 0; first < rows.count; first += step)
    {
      const std::uint64_t count = (std::min)(step, rows.count - first);
      if (!file.read_rows(rows.points, first, count, points.values, m_error)
          || (!rows.distances.empty() && !file.read_rows(rows.distances, first, count, distances.values, m_error)))
        return false;
      m_number_of_points = points.values.size() / 3;
      if (!hand_out_some(file.filename(), points, distances, Number_array(), sink))
        return false;
    }
    return m_filter.is_cloud_usable(file.filename(), m_error);
  }

  // whether an array has one number per point
  static bool is_one_per_point(const Number_array& array, const Number_array& points, std::size_t number_of_points)
  {
    if (array.values.size() != number_of_points)
      return false;
    if (array.is_ragged && points.is_ragged)
      return std::equal(array.row_sizes.begin(), array.row_sizes.end(), points.row_sizes.begin(),
                        points.row_sizes.end(), [](std::uint64_t a, std::uint64_t b) { return 3 * a == b; });
    if (array.is_ragged || points.is_ragged || array.shape.size() == 1)
      return true;
    std::vector<std::uint64_t> shape = array.shape;
    if (shape.size() == points.shape.size() && shape.back() == 1)
      shape.pop_back();
    return std::equal(shape.begin(), shape.end(), points.shape.begin(), points.shape.end() - 1);
  }

  std::string mismatch_text(const Array_file& file, const std::string& name, const Number_array& array,
                            const std::string& points_word, const Number_array& points, const std::string& what,
                            const std::string& parameter) const
  {
    return file.filename() + ": its " + file.word_for_array() + " " + quote(name) + " has the shape "
      + shape_text(array) + ", its " + points_word + " " + shape_text(points) + "; each point needs exactly one " + what
      + ". Name another one (" + parameter + ")";
  }

  bool read_distances(Array_file& file, const Number_array& points, const std::string& points_word,
                      Number_array& distances)
  {
    std::size_t index;
    if (!find_distances(file, m_options, index))
      return fail(no_distances_text(file, m_options));
    const std::string& name = file.names()[index];
    if (!file.read(name, distances, m_error))
      return false;
    return is_one_per_point(distances, points, m_number_of_points)
      || fail(mismatch_text(file, name, distances, points_word, points, "distance", "distances_dataset"));
  }

  bool read_indices(Array_file& file, const Number_array& points, const std::string& points_word, Number_array& indices)
  {
    if (!m_options.reads_indices)
      return true;
    const std::string& wanted = m_options.indices_dataset;
    std::size_t index = file.names().size();
    if (!wanted.empty())
      index = find_name(file.names(), wanted);
    else
      for (const std::string& name : known_index_names())
        if (index == file.names().size())
          index = find_name(file.names(), name);
    if (index == file.names().size())
      return wanted.empty()
        || fail(file.filename() + ": has no " + file.word_for_array() + " " + quote(wanted)
                + "; it has: " + file.contents_text() + ". Name the one that holds the indices (indices_dataset)");
    const std::string& name = file.names()[index];
    if (!file.read(name, indices, m_error))
      return false;
    if (!is_one_per_point(indices, points, m_number_of_points))
      return fail(mismatch_text(file, name, indices, points_word, points, "index", "indices_dataset"));
    for (std::size_t i = 0; i < indices.values.size(); ++i)
      if (!(indices.values[i] >= 0. && indices.values[i] <= 9e15) || indices.values[i] != std::floor(indices.values[i]))
        return fail(file.filename() + ": its " + file.word_for_array() + " " + quote(name) + " has "
                    + number_to_string(indices.values[i]) + " at " + std::to_string(i)
                    + " (counted from 0), which is no index. Name another one (indices_dataset)");
    return true;
  }

  bool hand_out(const std::string& filename, const Number_array& points, const Number_array& distances,
                const Number_array& indices, Sample_sink& sink)
  {
    return hand_out_some(filename, points, distances, indices, sink) && m_filter.is_cloud_usable(filename, m_error);
  }

  bool hand_out_some(const std::string& filename, const Number_array& points, const Number_array& distances,
                     const Number_array& indices, Sample_sink& sink)
  {
    const std::string stopped = filename + ": " + Sample_chunk::stopped_text();
    Sample_chunk chunk;
    for (std::size_t i = 0; i < m_number_of_points; ++i)
    {
      const double* const p = points.values.data() + i * m_number_of_columns;
      Distance_sample sample = {p[m_columns[0]], p[m_columns[1]], p[m_columns[2]],
                                m_has_distance_column ? p[m_columns[3]] : 0.};
      if (!distances.values.empty())
        sample.distance = distances.values[i];
      if (!indices.values.empty())
        sample.index = static_cast<std::uint64_t>(indices.values[i]);
      if (m_filter(sample, 0) && !chunk.add(sample, sink))
        return fail(stopped);
    }
    return chunk.flush(sink) || fail(stopped);
  }

  const Cloud_reader_options& m_options;
  Sample_filter m_filter;
  std::size_t m_number_of_columns = 3, m_number_of_points = 0;
  std::array<std::size_t, 4> m_columns = {{0, 1, 2, 3}};
  bool m_has_distances = false;       // in an array of their own
  bool m_has_distance_column = false; // beside the coordinates
  std::string m_error;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ARRAY_CLOUD_READER_H
