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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_FARTHEST_POINT_SAMPLING_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_FARTHEST_POINT_SAMPLING_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Exact farthest point sampling of the first `size` positions. Points whose nearest sample changes lie in a ball around
// the new sample, whose radius is the distance of the farthest point, so that no sample needs a pass over all points.
// The farthest point comes from a heap whose entries are checked when they surface. The first sample is the position
// farthest from the centroid. Returns `count` indices, fewer where all positions coincide with
// samples, or after cancelling.
inline std::vector<std::size_t> farthest_point_sampling(const std::vector<Vector>& positions, std::size_t size,
                                                        std::size_t count, Progress* progress = nullptr)
{
  std::vector<std::size_t> samples;
  if (size == 0 || count == 0)
    return samples;
  Ball_search search;
  search.build(positions, size);
  Vector centroid = Vector::Zero();
  for (std::size_t i = 0; i < size; ++i)
    centroid += positions[i];
  centroid /= double(size);
  std::size_t next = 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((positions[i] - centroid).squaredNorm() > (positions[next] - centroid).squaredNorm())
      next = i;
  const double infinity = (std::numeric_limits<double>::infinity)();
  std::vector<double> distances(size, infinity);
  typedef std::pair<double, std::size_t> Entry;
  const auto less = [](const Entry& a, const Entry& b) {
    return a.first < b.first || (a.first == b.first && a.second > b.second);
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(less)> heap(less);
  std::vector<std::size_t> ball;
  double radius = infinity;
  while (samples.size() % points_between_questions != 0 || goes_on(progress))
  {
    samples.push_back(next);
    const auto update = [&](std::size_t i) {
      const double d = (positions[i] - positions[next]).norm();
      if (d < distances[i])
      {
        distances[i] = d;
        heap.emplace(d, i);
      }
    };
    if (radius == infinity)
    {
      for (std::size_t i = 0; i < size; ++i)
        update(i);
    }
    else
    {
      // the ball is open, and rounding must not lose a point on its boundary
      search.query(positions[next], radius * (1. + 1e-9), ball);
      for (std::size_t i : ball)
        update(i);
    }
    if (samples.size() == count)
      break;
    while (!heap.empty() && heap.top().first != distances[heap.top().second])
      heap.pop();
    if (heap.empty() || !(heap.top().first > 0.))
      break;
    radius = heap.top().first;
    next = heap.top().second;
  }
  return samples;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_FARTHEST_POINT_SAMPLING_H
