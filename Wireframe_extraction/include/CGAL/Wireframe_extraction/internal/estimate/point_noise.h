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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_POINT_NOISE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_POINT_NOISE_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_fit.h>
#include <CGAL/Wireframe_extraction/internal/estimate/fold_balls.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The standard deviation of the points across their surface, in sampling distances: from the residuals of quadrics in
// balls that hold nothing else, which are those with the smallest residuals. Larger balls have more points, smaller
// ones hold less often a second sheet.
inline double point_noise(const std::vector<Vector>& points, const Ball_search& search)
{
  static constexpr std::size_t most_balls = 4000; // the tenth smallest of 100 errs by 3 per cent
  static constexpr std::size_t least_balls = 100;
  static constexpr double quantile = 0.1; // a tenth of the balls at least holds a single sheet
  struct Radius
  {
    double radius;
    double quantile_of_deviation; // what the quantile of the residuals is if the deviation is 1
  };
  // some 28 and 14 points; the quantiles were measured
  static constexpr Radius radii[] = {{3.3, 0.78}, {2.3, 0.62}};
  double best = (std::numeric_limits<double>::infinity)();
  const std::size_t count = (std::min)(points.size(), most_balls);
  Fold_fit fit;
  Fold_ball ball;
  for (const Radius& radius : radii)
  {
    std::vector<double> residuals;
    for (std::size_t k = 0; k < count; ++k)
    {
      ball.collect(points, search, points[k * points.size() / count], radius.radius);
      const double residual = fit.residual_of_sheet(ball.offsets);
      if (std::isfinite(residual))
        residuals.push_back(residual);
    }
    if (residuals.empty() || residuals.size() < (std::min)(least_balls, count))
      continue;
    const auto place = residuals.begin() + std::ptrdiff_t(quantile * double(residuals.size()));
    std::nth_element(residuals.begin(), place, residuals.end());
    best = (std::min)(best, *place / radius.quantile_of_deviation);
  }
  return std::isfinite(best) ? best : 0.;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_POINT_NOISE_H
