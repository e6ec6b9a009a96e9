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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_RANGE_SOURCE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_RANGE_SOURCE_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/internal/cloud/cloud_access.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A cloud that is a range in memory.
template <class PointRange, class Access, bool has_known_distances = Access::has_distances>
class Range_source : public Distance_cloud_source
{
  static constexpr std::size_t samples_per_chunk = 4096;

  const PointRange& m_points;
  const Access& m_access;

public:
  Range_source(const PointRange& points, const Access& access) : m_points(points), m_access(access) {}

  std::size_t size_hint() const override
  {
    return static_cast<std::size_t>(std::distance(m_points.begin(), m_points.end()));
  }

  bool has_distances() const override { return has_known_distances && m_access.are_distances_known(); }

  bool read(const Sink& sink) override
  {
    std::vector<Sample> chunk;
    const bool are_distances_known = has_distances();
    const auto hand_out = [&] {
      const bool goes_on = sink(chunk.data(), chunk.data() + chunk.size());
      chunk.clear();
      return goes_on;
    };
    for (const auto& value : m_points)
    {
      const Vector p = m_access.position(value);
      double distance = 0.;
      if constexpr (has_known_distances)
        distance = are_distances_known ? m_access.distance(value) : 0.;
      chunk.push_back(Sample{p.x(), p.y(), p.z(), distance});
      if (chunk.size() == samples_per_chunk && !hand_out())
        return true;
    }
    if (!chunk.empty())
      hand_out();
    return true;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_RANGE_SOURCE_H
