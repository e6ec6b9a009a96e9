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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SECOND_VARIANCE_RATIO_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SECOND_VARIANCE_RATIO_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/linear_least_squares_fitting_3.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The second explained variance ratio of the points of a ball (eq. 1). CGAL's fits return 1 - l2 / l3 for a line and
// 1 - l1 / l2 for a plane, where l1 <= l2 <= l3 are the variances along the principal axes.
inline double second_variance_ratio(const std::vector<Vector>& points, const std::vector<std::size_t>& ball)
{
  typedef CGAL::Simple_cartesian<double> K;
  if (ball.size() < 3)
    return 0.;
  std::vector<K::Point_3> positions;
  for (std::size_t i : ball)
    positions.emplace_back(points[i].x(), points[i].y(), points[i].z());
  const CGAL::Dimension_tag<0> of_points;
  const auto first = positions.begin(), beyond = positions.end();
  K::Line_3 line;
  K::Plane_3 plane;
  const double l2_by_l3 = 1. - CGAL::linear_least_squares_fitting_3(first, beyond, line, of_points);
  const double l1_by_l2 = 1. - CGAL::linear_least_squares_fitting_3(first, beyond, plane, of_points);
  const double ratio = l2_by_l3 / (1. + l2_by_l3 + l1_by_l2 * l2_by_l3);
  return std::isfinite(ratio) ? ratio : 0.;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SECOND_VARIANCE_RATIO_H
