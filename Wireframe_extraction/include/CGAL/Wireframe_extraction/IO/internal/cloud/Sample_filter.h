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
  std::string distance_property; // empty: the first known one
  std::string points_dataset;    // empty: the usual one
  std::string distances_dataset; // empty: the distance property
  std::string indices_dataset;   // empty: the first known one, if there is one
  bool reads_indices = false;
  bool skip_invalid = false;
  double largest_magnitude = (std::numeric_limits<double>::max)(); // what the number type can hold
  const Separate_distances* distances = nullptr; // if set, the cloud's own distances are not looked at
};

// names of the field's property, in the order in which they are looked for
inline const std::vector<std::string>& known_distance_names()
{
  static const std::vector<std::string> names = {"distance", "distances", "sharpness", "scalar_distance", "quality"};
  return names;
}

// index of a name, an exact match before one that differs in case; `names.size()` if there is none
inline std::size_t find_name(const std::vector<std::string>& names, const std::string& wanted)
{
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == wanted)
      return i;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (to_lower(names[i]) == to_lower(wanted))
      return i;
  return names.size();
}

// index of the field's property; `names.size()` if there is none
inline std::size_t find_distance_name(const std::vector<std::string>& names, const std::string& wanted)
{
  if (!wanted.empty())
    return find_name(names, wanted);
  for (const std::string& name : known_distance_names())
  {
    const std::size_t index = find_name(names, name);
    if (index < names.size())
      return index;
  }
  return names.size();
}

// Looks at every sample of a file in turn: completes it by its separate distance, and counts those that
// no algorithm can use.
class Sample_filter
{
public:
  explicit Sample_filter(const Cloud_reader_options& options) : options_(options) {}

  // returns whether the sample is to be kept; `line` is 0 for a binary file
  bool operator()(Distance_sample& sample, std::size_t line)
  {
    const std::size_t index = number_of_samples_++;
    if (options_.distances != nullptr)
    {
      if (index >= options_.distances->values.size())
        return false;
      sample.distance = options_.distances->values[index];
    }
    if (is_usable(sample.x) && is_usable(sample.y) && is_usable(sample.z) && is_usable(sample.distance)
        && sample.distance >= 0.)
      return true;
    count_invalid(sample, index, line);
    return false;
  }

  // where the distances stand, for messages, such as " in column 4"
  void set_distance_place(const std::string& place) { distance_place_ = place; }

  std::size_t number_of_samples() const { return number_of_samples_; }

  std::size_t number_of_invalid() const { return invalid_coordinates_ + invalid_distances_ + negative_distances_; }

  // after the last sample: returns whether the cloud can be used, else says why not
  bool is_cloud_usable(const std::string& filename, std::string& error) const
  {
    if (number_of_samples_ == 0)
      error = filename + ": holds no points; write the cloud into it again";
    else if (options_.distances != nullptr && options_.distances->values.size() != number_of_samples_)
      error = filename + ": holds " + plural(number_of_samples_, "point", "points") + ", but "
        + options_.distances->filename + " holds " + plural(options_.distances->values.size(), "distance", "distances")
        + "; each point needs exactly one";
    else if (number_of_invalid() > 0 && !options_.skip_invalid)
      error = filename + ": " + invalid_text() + ". Repair the file, or leave such points out by skip_invalid(true)";
    else if (number_of_invalid() == number_of_samples_)
      error = filename + ": no point is left after skipping: " + invalid_text() + ". Repair the file";
    else
      return true;
    return false;
  }

private:
  bool is_usable(double value) const { return std::isfinite(value) && std::abs(value) <= options_.largest_magnitude; }

  void count_invalid(const Distance_sample& sample, std::size_t index, std::size_t line)
  {
    const bool is_first = (number_of_invalid() == 0);
    std::string what;
    if (!(is_usable(sample.x) && is_usable(sample.y) && is_usable(sample.z)))
    {
      ++invalid_coordinates_;
      if (is_first)
        what = "its coordinates are " + number_to_string(sample.x) + " " + number_to_string(sample.y) + " "
          + number_to_string(sample.z);
    }
    else
    {
      ++(is_usable(sample.distance) ? negative_distances_ : invalid_distances_);
      if (is_first)
      {
        what = "its distance" + distance_place_ + " is " + number_to_string(sample.distance);
        if (options_.distances != nullptr)
        {
          const std::size_t bad_line = options_.distances->first_bad_line;
          what += " (" + options_.distances->filename + (bad_line > 0 ? ":" + std::to_string(bad_line) : "") + ")";
        }
      }
    }
    if (is_first)
      first_invalid_ = "point " + std::to_string(index) + " (counted from 0"
        + (line > 0 ? ", line " + std::to_string(line) : "") + "): " + what;
  }

  std::string invalid_text() const
  {
    std::string kinds;
    const auto add = [&kinds](std::size_t count, const char* kind) {
      if (count > 0)
        kinds += (kinds.empty() ? "" : ", ") + std::to_string(count) + " with " + kind;
    };
    add(invalid_coordinates_, "a coordinate that is not finite");
    add(invalid_distances_, "a distance that is not finite");
    add(negative_distances_, "a negative distance");
    return std::to_string(number_of_invalid()) + " of " + plural(number_of_samples_, "point", "points")
      + " cannot be used (" + kinds + "); the first is " + first_invalid_;
  }

  const Cloud_reader_options& options_;
  std::size_t number_of_samples_ = 0;
  std::size_t invalid_coordinates_ = 0, invalid_distances_ = 0, negative_distances_ = 0;
  std::string first_invalid_, distance_place_;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_FILTER_H
