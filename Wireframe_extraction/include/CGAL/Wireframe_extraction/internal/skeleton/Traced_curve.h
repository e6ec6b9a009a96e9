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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_TRACED_CURVE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_TRACED_CURVE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A curve followed through the field, as a polyline. Where it is open, the tips tell how it goes on: a local curve
// whose tangent points outward, at the last position that the field supports.
struct Traced_curve
{
  std::vector<Vector> points;
  bool is_closed = false;                // the last point is then the first one
  Local_curve tips[2];                   // at the first and at the last point
  bool ends_in_void[2] = {false, false}; // no data beyond the tip, rather than data that speak against the curve
  std::vector<double> residuals;         // of the local fits along the curve

  // A low quantile, two fifths, since other curves disturb the fits near the ends. Of no fits, in r, more than what any
  // curve may have.
  double typical_residual() const
  {
    static constexpr std::size_t numerator = 2, denominator = 5;
    static constexpr double no_residual = 1.;
    if (residuals.empty())
      return no_residual;
    std::vector<double> sorted = residuals;
    const std::size_t k = sorted.size() * numerator / denominator;
    std::nth_element(sorted.begin(), sorted.begin() + k, sorted.end());
    return sorted[k];
  }

  double length() const { return polyline_length(points); }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_TRACED_CURVE_H
