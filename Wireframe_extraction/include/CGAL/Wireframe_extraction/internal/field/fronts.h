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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_FRONTS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_FRONTS_H

#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/field/Local_curve.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// whether a curve in the grid, other than the ignored one, runs within `reach` of the front, in its direction
inline bool runs_along(const Segment_grid& curves, const Local_curve& front, double reach,
                       std::size_t ignored = Segment_grid::no_curve)
{
  return curves
    .nearest(front.point, reach,
             [&](const Segment_grid::Hit& hit) {
               return hit.curve != ignored && std::abs(hit.direction.dot(front.tangent)) > 0.85;
             })
    .is_valid();
}

// whether the next step of a front leads to where it started
inline bool has_returned(const Local_curve& start, const Local_curve& front, double step, double tolerance)
{
  const Vector offset = start.point - front.point;
  const double s = offset.dot(front.tangent);
  return s > -0.1 && s < 1.2 * step && start.tangent.dot(front.tangent) > 0.8
    && (offset - s * front.tangent).norm() < tolerance;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_FRONTS_H
