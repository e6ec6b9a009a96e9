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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_FILTER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_FILTER_H

#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/policies.h>

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

// one point of a cloud as it stands in a file
struct Distance_sample
{
  static constexpr std::uint64_t no_index = (std::numeric_limits<std::uint64_t>::max)();

  double x, y, z, distance;
  std::uint64_t index = no_index; // in the cloud that a patch is a part of
};

// the distances of a cloud that come from a file of their own
struct Separate_distances
{
  std::string filename;
  std::vector<double> values;
  std::size_t first_bad_line = 0; // of text: line of the first value that is not finite or negative
};

struct Cloud_reader_options
{
  std::vector<std::string> coordinate_properties; // of x, y and z; empty: the usual ones
  std::string distance_property;                  // empty: the first known one
  std::string points_dataset;                     // empty: the usual one
  std::string distances_dataset;                  // empty: the distance property
  std::string indices_dataset;                    // empty: the first known one, if there is one
  std::string format;                             // an extension; empty: that of the file
  bool reads_indices = false;
  bool skip_invalid = false;
  bool clamp_negative = false;                                     // whether distances below zero count as zero
  double largest_magnitude = (std::numeric_limits<double>::max)(); // what the number type can hold
  bool may_be_estimated = false;                                   // whether the caller can do without distances
  const Separate_distances* distances = nullptr; // if set, the cloud's own distances are not looked at
  Wireframe_extraction::Field_origin field_origin = Wireframe_extraction::Field_origin::GIVEN;

  bool looks_for_distances() const
  {
    return distances == nullptr && field_origin != Wireframe_extraction::Field_origin::ESTIMATED;
  }

  // whether it is an error if none are found: who names them wants them
  bool needs_distances() const
  {
    return looks_for_distances()
      && (field_origin == Wireframe_extraction::Field_origin::GIVEN || !distance_property.empty()
          || !distances_dataset.empty());
  }

  // how to do without distances, to be added to what is wrong with them; nothing where that is no remedy
  std::string estimate_text() const
  {
    if (!may_be_estimated)
      return std::string();
    return field_origin == Wireframe_extraction::Field_origin::GIVEN
      ? ", or have them estimated from the points (field_origin)"
      : ", or do not name them, so that they are estimated from the points";
  }
};

// Looks at every sample of a file in turn: completes it by its separate distance, and counts those that
// no algorithm can use.
class Sample_filter
{
public:
  explicit Sample_filter(const Cloud_reader_options& options) : m_options(options) {}

  // returns whether the sample is to be kept; `line` is 0 for a binary file
  bool operator()(Distance_sample& sample, std::size_t line)
  {
    const std::size_t index = m_number_of_samples++;
    if (m_options.distances != nullptr)
    {
      if (index >= m_options.distances->values.size())
        return false;
      sample.distance = m_options.distances->values[index];
    }
    if (m_options.clamp_negative && is_usable(sample.distance))
      clamp(sample.distance);
    if (is_usable(sample.x) && is_usable(sample.y) && is_usable(sample.z) && is_usable(sample.distance)
        && sample.distance >= 0.)
      return true;
    count_invalid(sample, index, line);
    return false;
  }

  // where the distances stand, for messages, such as " in column 4"
  void set_distance_place(const std::string& place) { m_distance_place = place; }

  std::size_t number_of_samples() const { return m_number_of_samples; }

  std::size_t number_of_invalid() const { return m_invalid_coordinates + m_invalid_distances + m_negative_distances; }

  // after the last sample: returns whether the cloud can be used, else says why not
  bool is_cloud_usable(const std::string& filename, std::string& error) const
  {
    if (m_number_of_samples == 0)
      error = filename + ": holds no points; write the cloud into it again";
    else if (m_options.distances != nullptr && m_options.distances->values.size() != m_number_of_samples)
      error = filename + ": holds " + plural(m_number_of_samples, "point", "points") + ", but "
        + m_options.distances->filename + " holds "
        + plural(m_options.distances->values.size(), "distance", "distances") + "; each point needs exactly one";
    else if (-m_most_negative > largest_negative_share * m_largest)
      error = filename + ": its most negative distance is " + number_to_string(m_most_negative) + ", the largest "
        + number_to_string(m_largest)
        + "; clamp_negative(true) is for distances a little below zero. Are they signed? Then write the magnitudes";
    else if (number_of_invalid() > 0 && !m_options.skip_invalid)
      error = filename + ": " + invalid_text() + ". Repair the file, or leave such points out by skip_invalid(true)"
        + (m_negative_distances > 0 ? ", or let distances a little below zero count as zero by clamp_negative(true)"
                                    : "");
    else if (number_of_invalid() == m_number_of_samples)
      error = filename + ": no point is left after skipping: " + invalid_text() + ". Repair the file";
    else
      return true;
    return false;
  }

private:
  // A regressor predicts a little less than zero where it should be zero; distances that have signs are something else.
  static constexpr double largest_negative_share = 0.1;

  void clamp(double& distance)
  {
    m_most_negative = (std::min)(m_most_negative, distance);
    m_largest = (std::max)(m_largest, distance);
    distance = (std::max)(distance, 0.);
  }

  bool is_usable(double value) const { return std::isfinite(value) && std::abs(value) <= m_options.largest_magnitude; }

  void count_invalid(const Distance_sample& sample, std::size_t index, std::size_t line)
  {
    const bool is_first = (number_of_invalid() == 0);
    std::string what;
    if (!(is_usable(sample.x) && is_usable(sample.y) && is_usable(sample.z)))
    {
      ++m_invalid_coordinates;
      if (is_first)
        what = "its coordinates are " + number_to_string(sample.x) + " " + number_to_string(sample.y) + " "
          + number_to_string(sample.z);
    }
    else
    {
      ++(is_usable(sample.distance) ? m_negative_distances : m_invalid_distances);
      if (is_first)
      {
        what = "its distance" + m_distance_place + " is " + number_to_string(sample.distance);
        if (m_options.distances != nullptr)
        {
          const std::size_t bad_line = m_options.distances->first_bad_line;
          what += " (" + m_options.distances->filename + (bad_line > 0 ? ":" + std::to_string(bad_line) : "") + ")";
        }
      }
    }
    if (is_first)
      m_first_invalid = "point " + std::to_string(index) + " (counted from 0"
        + (line > 0 ? ", line " + std::to_string(line) : "") + "): " + what;
  }

  std::string invalid_text() const
  {
    std::string kinds;
    const auto add = [&kinds](std::size_t count, const char* kind) {
      if (count > 0)
        kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " with " + kind;
    };
    add(m_invalid_coordinates, "a coordinate that is not finite");
    add(m_invalid_distances, "a distance that is not finite");
    add(m_negative_distances, "a negative distance");
    return std::to_string(number_of_invalid()) + " of " + plural(m_number_of_samples, "point", "points")
      + " cannot be used (" + kinds + "); the first is " + m_first_invalid;
  }

  const Cloud_reader_options& m_options;
  std::size_t m_number_of_samples = 0;
  std::size_t m_invalid_coordinates = 0, m_invalid_distances = 0, m_negative_distances = 0;
  double m_most_negative = 0., m_largest = 0.; // of the distances that are clamped
  std::string m_first_invalid, m_distance_place;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_FILTER_H
