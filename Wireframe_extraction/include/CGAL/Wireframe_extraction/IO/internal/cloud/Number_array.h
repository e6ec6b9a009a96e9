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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NUMBER_ARRAY_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NUMBER_ARRAY_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_chunk.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/property_names.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// an array of numbers as it stands in a file, row by row
struct Number_array
{
  std::vector<std::uint64_t> shape;
  std::vector<double> values;
  bool is_ragged = false;               // rows of different lengths, as many as the shape says
  std::vector<std::uint64_t> row_sizes; // of a ragged array
};

inline std::string shape_text(const std::vector<std::uint64_t>& shape)
{
  std::string text;
  for (const std::uint64_t size : shape)
    text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text.empty() ? "of a single number" : text;
}

inline std::string shape_text(const Number_array& array)
{
  return shape_text(array.shape) + (array.is_ragged ? " rows of their own lengths" : "");
}

// returns whether the product could be computed
inline bool find_number_of_values(const std::vector<std::uint64_t>& shape, std::uint64_t& count)
{
  count = 1;
  for (const std::uint64_t size : shape)
  {
    if (size != 0 && count > (std::numeric_limits<std::uint64_t>::max)() / 16 / size)
      return false;
    count *= size;
  }
  return true;
}

// A file that holds arrays with names.
class Array_file
{
public:
  virtual ~Array_file() {}

  virtual const std::string& filename() const = 0;
  virtual const char* word_for_array() const = 0; // what the format calls an array
  virtual const std::vector<std::string>& names() const = 0;
  virtual std::string contents_text() = 0; // for messages
  virtual bool read(const std::string& name, Number_array& array, std::string& error) = 0;

  // whether an array is there that can be read by rows, and its shape
  virtual bool find_rows(const std::string&, std::vector<std::uint64_t>&) { return false; }
  virtual bool read_rows(const std::string&, std::uint64_t /*first*/, std::uint64_t /*count*/, std::vector<double>&,
                         std::string&)
  {
    return false;
  }
};

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
    const std::string word = file.word_for_array();
    const std::string points_name = m_options.points_dataset.empty() ? "points" : m_options.points_dataset;
    const std::size_t points_index = find_name(file.names(), points_name);
    if (points_index == file.names().size())
      return fail(file.filename() + ": has no " + word + " " + quote(points_name) + "; it has: " + file.contents_text()
                  + ". Name the one that holds the points (points_dataset)");
    Rows rows;
    std::size_t distances_index;
    m_has_distances = m_options.looks_for_distances()
      && (m_options.needs_distances() || find_distances(file, m_options, distances_index));
    if (find_rows(file, file.names()[points_index], rows))
    {
      sink.describe(m_options.distances != nullptr || m_has_distances, std::string());
      return read_by_rows(file, rows, sink);
    }
    Number_array points, distances, indices;
    if (!file.read(file.names()[points_index], points, m_error))
      return false;
    const std::string points_word = word + " " + quote(file.names()[points_index]);
    if (!set_points(file.filename(), points_word, points, 3))
      return false;
    if (m_has_distances && !read_distances(file, points, points_word, distances))
      return false;
    sink.describe(m_options.distances != nullptr || m_has_distances, std::string());
    return read_indices(file, points, points_word, indices)
      && hand_out(file.filename(), points, distances, indices, sink);
  }

  // the same for a single array, whose fourth column holds the distances
  bool read(const std::string& filename, const Number_array& points, Sample_sink& sink)
  {
    const std::uint64_t columns = points.shape.empty() ? 0 : points.shape.back();
    const bool has_normals = columns == 6 && !m_options.needs_distances();
    if (!set_points(filename, "array", points, columns == 4 ? 4 : has_normals ? 6 : 3))
      return false;
    m_has_distances = columns == 4 && m_options.looks_for_distances();
    if (!m_has_distances && m_options.needs_distances())
      return fail(filename + ": its array has the shape " + shape_text(points)
                  + ", so it has points but no distances; give the distances as a separate file, or as a fourth "
                    "column, or both arrays in one .npz file"
                  + m_options.estimate_text());
    sink.describe(m_options.distances != nullptr || m_has_distances,
                  has_normals ? "the last three of its six columns are not looked at" : "");
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
  bool fail(const std::string& error)
  {
    m_error = error;
    return false;
  }

  bool set_points(const std::string& filename, const std::string& word, const Number_array& points,
                  std::size_t number_of_columns)
  {
    m_number_of_columns = number_of_columns;
    bool is_fine = false;
    if (points.is_ragged)
      is_fine =
        std::all_of(points.row_sizes.begin(), points.row_sizes.end(), [](std::uint64_t size) { return size % 3 == 0; });
    else
      is_fine = (points.shape.size() == 2 || points.shape.size() == 3) && points.shape.back() == number_of_columns;
    if (!is_fine)
      return fail(filename + ": its " + word + " has the shape " + shape_text(points)
                  + (points.is_ragged ? ", not all of multiples of three" : "")
                  + "; points have the shape N x 3, or in patches B x N x 3"
                  + (word == "array" ? ", or with their distances N x 4"
                                     : ". Name the one that holds the points (points_dataset)"));
    m_number_of_points = points.values.size() / number_of_columns;
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
    if (m_options.reads_indices || !file.find_rows(points_name, shape) || (shape.size() != 2 && shape.size() != 3)
        || shape.back() != 3 || !find_number_of_values(shape, number_of_values))
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
      Distance_sample sample = {p[0], p[1], p[2], m_number_of_columns == 4 && m_has_distances ? p[3] : 0.};
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
  bool m_has_distances = true; // of its own
  std::string m_error;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NUMBER_ARRAY_H
