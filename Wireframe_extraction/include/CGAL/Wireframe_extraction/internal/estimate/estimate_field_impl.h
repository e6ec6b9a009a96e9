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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_ESTIMATE_FIELD_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_ESTIMATE_FIELD_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_finder.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_votes.h>
#include <CGAL/Wireframe_extraction/internal/estimate/estimate_field.h>
#include <CGAL/Wireframe_extraction/internal/estimate/point_noise.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// the distance to the nearest fold, truncated
inline double truncated_distance(const Vector& point, const Fold_votes& votes, std::vector<std::size_t>& found)
{
  // most points are near a fold, or far from all: then a small ball, or none, tells
  for (double radius : {1., 2., Field_estimate::truncation})
  {
    const double distance = votes.known_distance(point, radius, found);
    if (distance != radius)
      return (std::min)(distance, Field_estimate::truncation);
  }
  return Field_estimate::truncation;
}

CGAL_WIREFRAME_EXTRACTION_INLINE bool estimate_field(const std::vector<Vector>& points, double minimum_fold,
                                                     const std::function<bool(double)>& proceed,
                                                     Field_estimate& estimate)
{
  // Votes of neighbors rest on the same points, so that their errors are not independent, and their mean errs as they
  // do. With a level above the largest, stages take wrong parts of the field for noise, and find
  // fewer curves (measured).
  static constexpr double least_noise_level = 0.1, most_noise_level = 0.3;
  const Ball_search search(points);
  estimate.point_noise = point_noise(points, search);
  const Fold_scales scales(estimate.point_noise);
  Fold_finder finder(points, search, scales, minimum_fold);
  if (!finder.run([&](double share) { return proceed(0.9 * share); }))
    return false;
  const std::vector<Fold_vote> all_votes = finder.votes();
  const Fold_votes votes(all_votes, scales);
  estimate.noise_level = (std::min)(most_noise_level, (std::max)(least_noise_level, votes.disagreement(all_votes)));
  estimate.distances.resize(points.size());
  estimate.deviations.assign(points.size(), estimate.noise_level);
  return for_each_piece_or_cancel(
    points.size(),
    [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> found;
      for (std::size_t i = begin; i < end; ++i)
        estimate.distances[i] = truncated_distance(points[i], votes, found);
    },
    [&](double share) { return proceed(0.9 + 0.1 * share); });
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_ESTIMATE_FIELD_IMPL_H
