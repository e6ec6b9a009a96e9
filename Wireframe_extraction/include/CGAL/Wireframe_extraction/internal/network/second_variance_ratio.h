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
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The second explained variance ratio of the points of a ball (eq. 1), of the variances l1 <= l2 <= l3 along the
// principal axes.
inline double second_variance_ratio(const std::vector<Vector>& points, const std::vector<std::size_t>& ball)
{
  if (ball.size() < 3)
    return 0.;
  const auto position = [&](std::size_t i) -> const Vector& { return points[i]; };
  const Vector variances = principal_axes(scatter(ball, position).matrix).values;
  if (variances[0] == variances[2])
    return 1. / 3.;
  const double l2_by_l3 = variances[1] / variances[2];
  const double l1_by_l2 = variances[1] == 0. ? 1. : variances[0] / variances[1];
  const double ratio = l2_by_l3 / (1. + l2_by_l3 + l1_by_l2 * l2_by_l3);
  return std::isfinite(ratio) ? ratio : 0.;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SECOND_VARIANCE_RATIO_H
