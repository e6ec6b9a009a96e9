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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FRONTS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FRONTS_H

#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Directions of one curve at places a step apart differ by less than 32 degrees, unless it turns within 2 r.
constexpr double least_cosine_along = 0.85;

// whether a curve in the grid, other than the ignored one, runs within `reach` of the front, in its direction
inline bool runs_along(const Segment_grid& curves, const Local_curve& front, double reach,
                       std::size_t ignored = Segment_grid::no_curve)
{
  return curves
    .nearest(front.point, reach,
             [&](const Segment_grid::Hit& hit) {
               return hit.curve != ignored && std::abs(hit.direction.dot(front.tangent)) > least_cosine_along;
             })
    .is_valid();
}

// Whether the next step of a front leads to where it started: from a little behind it to a fifth of a step beyond the
// next one, since steps vary, and with directions that differ by what closed curves of a few r turn within a step.
inline bool has_returned(const Local_curve& start, const Local_curve& front, double step, double tolerance)
{
  static constexpr double farthest_behind = 0.1, farthest_ahead = 1.2; // in r, in steps
  static constexpr double least_cosine = 0.8;                          // of 37 degrees
  const Vector offset = start.point - front.point;
  const double s = offset.dot(front.tangent);
  return s > -farthest_behind && s < farthest_ahead * step && start.tangent.dot(front.tangent) > least_cosine
    && (offset - s * front.tangent).norm() < tolerance;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FRONTS_H
