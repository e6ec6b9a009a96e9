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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SURVEYED_CLOUD_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SURVEYED_CLOUD_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_scale.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_values.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Distance_histogram.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Position_sample.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

class Neighbor_scan;

// A cloud of which what all stages ask is known after it was read once. A small one is then in memory; a large one
// stays where it is, and is read again whenever all points are wanted. What it tells is the same either way.
class Surveyed_cloud
{
  typedef Distance_cloud_source::Sample Sample;

  Distance_cloud_source& m_source;
  Position_sample m_sample;
  std::unique_ptr<Distance_histogram> m_histogram;
  std::size_t m_number_of_points = 0, m_not_finite = 0, m_negative = 0, m_first_invalid = 0;
  double m_smallest = (std::numeric_limits<double>::infinity)(), m_largest = 0.;
  std::size_t m_number_of_smallest = 0, m_number_of_largest = 0;
  bool m_has_own_distances = false;
  mutable std::string m_error;

public:
  Surveyed_cloud(Distance_cloud_source& source, std::size_t points_in_memory)
    : m_source(source), m_sample(points_in_memory)
  {}

  std::size_t number_of_points() const { return m_number_of_points; }
  std::size_t number_of_not_finite() const { return m_not_finite; }
  std::size_t number_of_negative() const { return m_negative; }
  std::size_t number_of_valid() const { return m_number_of_points - m_not_finite - m_negative; }
  std::size_t first_invalid() const { return m_first_invalid; }
  double smallest_distance() const { return m_smallest; }
  double largest_distance() const { return m_largest; }
  std::size_t number_of_smallest() const { return m_number_of_smallest; }
  std::size_t number_of_largest() const { return m_number_of_largest; }

  // why it could not be read; empty if it could
  const std::string& error() const { return m_error; }

  // whether the distances are known, which is known once it was read
  bool has_distances() const { return m_has_own_distances || m_source.has_distances(); }

  bool is_in_memory() const { return m_sample.is_complete(); }

  // all points, or a sample of them
  const Cloud_values& sample() const { return m_sample.values(); }

  // reads it for the first time
  bool survey();

  // takes distances that its source has not; it has to be in memory
  void set_distances(const std::vector<double>& distances);

  // calls `use(position, distance, index)` for every valid point
  template <class Use>
  void for_each(const Use& use) const
  {
    if (is_in_memory())
    {
      m_sample.values().for_each(use);
      return;
    }
    if (!m_error.empty())
      return;
    std::size_t index = 0;
    const bool is_read = read([&](const Sample& s) {
      if (is_finite(s) && s.distance >= 0.)
        use(Vector(s.x, s.y, s.z), s.distance, index);
      ++index;
    });
    if (!is_read)
      m_error = reason();
    else if (index != m_number_of_points)
      m_error = "the cloud had " + std::to_string(m_number_of_points) + " points when it was read first, and "
        + std::to_string(index) + " later; let it be unchanged meanwhile";
  }

  Cloud_scale scale() const;

private:
  // From so many points on, looking at all of them is faster than a tree of all. The search starts with a tree of an
  // eighth of them.
  static constexpr std::size_t least_to_scan = 65536, start_share = 8;
  // the median over so many points errs by two per cent: fewer are not enough
  static constexpr std::size_t least_queries = 64;

  void start_with_few(Neighbor_scan& scan) const;

  // Calls `use(sample)` for all that the source has. Distances that are not known are 0, whatever the source says.
  template <class Use>
  bool read(const Use& use) const
  {
    return m_source.read([&](const Sample* first, const Sample* beyond) {
      const bool has_distances = m_source.has_distances();
      for (; first != beyond; ++first)
        use(has_distances ? *first : Sample{first->x, first->y, first->z, 0.});
      return true;
    });
  }

  static bool is_finite(const Sample& s)
  {
    return std::isfinite(s.x) && std::isfinite(s.y) && std::isfinite(s.z) && std::isfinite(s.distance);
  }

  std::string reason() const;

  void survey(const Sample& s);

  void survey_distance(double distance);

  // from now on the points are too many to be in memory
  void start_histogram();

  // as `Distance_histogram::for_each_bin()`
  template <class Use>
  void for_each_bin(const Use& use) const;

  // The points at which the density is measured. They are evenly spread over the ranks of the distances: the same
  // points whatever the order of the cloud. Those at the largest value are left out, since a field is truncated there.
  Cloud_values density_queries() const;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SURVEYED_CLOUD_H
