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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_DISTINCT_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_DISTINCT_CURVES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/field/Local_curve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Of local curves, which the fits at several points have found, those that differ where they pass `center`, moved there;
// the nearest ones, and no more than `most`.
inline std::vector<Local_curve> distinct_curves(std::vector<Local_curve> curves, const Vector& center, std::size_t most)
{
  // closer in r, in directions closer than 18 degrees, two fits have found the same curve
  static constexpr double equal_distance = 0.25, equal_cosine = 0.95;
  for (Local_curve& curve : curves)
    curve.move_along_to(center);
  std::stable_sort(curves.begin(), curves.end(), [&](const Local_curve& a, const Local_curve& b) {
    return (a.point - center).squaredNorm() < (b.point - center).squaredNorm();
  });
  std::vector<Local_curve> result;
  for (const Local_curve& curve : curves)
  {
    if (result.size() == most)
      break;
    if (std::none_of(result.begin(), result.end(), [&](const Local_curve& other) {
          return (other.point - curve.point).squaredNorm() < equal_distance * equal_distance
            && std::abs(other.tangent.dot(curve.tangent)) > equal_cosine;
        }))
      result.push_back(curve);
  }
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_DISTINCT_CURVES_H
