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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_DISTINCT_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_DISTINCT_CURVES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Sorts the indices of positions by their distance from `center`: the order in which a search finds them depends on the
// axes.
inline void sort_by_distance(std::vector<std::size_t>& indices, const std::vector<Vector>& positions,
                             const Vector& center)
{
  std::sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
    const double da = (positions[a] - center).squaredNorm(), db = (positions[b] - center).squaredNorm();
    return da < db || (da == db && a < b);
  });
}

// Of local curves, which the fits at several points have found, those that differ where they pass `center`, moved
// there. The first one of several that are the same counts; the result begins with the nearest
// curve, and has `most` at most.
inline std::vector<Local_curve> distinct_curves(const std::vector<Local_curve>& curves, const Vector& center,
                                                std::size_t most)
{
  // closer in r, in directions closer than 18 degrees, two fits have found the same curve
  static constexpr double equal_distance = 0.25, equal_cosine = 0.95;
  std::vector<Local_curve> result;
  for (Local_curve curve : curves)
  {
    curve.move_along_to(center);
    if (std::none_of(result.begin(), result.end(), [&](const Local_curve& other) {
          return (other.point - curve.point).squaredNorm() < equal_distance * equal_distance
            && std::abs(other.tangent.dot(curve.tangent)) > equal_cosine;
        }))
      result.push_back(curve);
  }
  std::stable_sort(result.begin(), result.end(), [&](const Local_curve& a, const Local_curve& b) {
    return (a.point - center).squaredNorm() < (b.point - center).squaredNorm();
  });
  if (result.size() > most)
    result.resize(most);
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_DISTINCT_CURVES_H
