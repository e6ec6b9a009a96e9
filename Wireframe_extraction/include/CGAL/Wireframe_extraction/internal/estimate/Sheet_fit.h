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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Sheet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The plane through the points of a small ball.
struct Plane_of_points
{
  Vector point = Vector::Zero(), normal = Vector::Zero();
};

// Finds the sheet on which the center of a ball lies, whatever else is in the ball: of the planes of its neighbors, of
// which some see nothing but the sheet, that on which most points lie, then the quadric through these. Lengths are in
// sampling distances.
class Sheet_fit
{
  // Surfaces leave their tangent plane by that times the squared distance: their radii are 5 r at least, or their other
  // points do not count. Near points count more, those at 1.8 r half.
  static constexpr double bending = 0.1, fading = 0.3;
  // standard deviation of the curvatures that surfaces have, in 1 / r
  static constexpr double curvature_deviation = 0.15;
  // up to so many standard deviations a point counts, round after round: first the plane errs, at the end the points
  static constexpr double reaches[4] = {8., 5., 3.5, exceeded_by_one_in_370};
  static constexpr int least_points = 5;
  static constexpr double relative_ridge = 1e-9;

  double m_deviation;

public:
  // `deviation`: standard deviation of the points
  explicit Sheet_fit(double deviation) : m_deviation(deviation) {}

  // points farther from a sheet are not on it
  double tolerance() const { return exceeded_by_one_in_370 * m_deviation; }

  // `offsets` are those of the points around the center, and of the center itself; `planes` may be tangent planes there
  Sheet fit(const Vector& center, const std::vector<Vector>& offsets, const std::vector<Plane_of_points>& planes) const
  {
    Sheet sheet;
    double best = 0.;
    for (const Plane_of_points& plane : planes)
    {
      const double height = plane.normal.dot(center - plane.point);
      if (std::abs(height) > tolerance())
        continue;
      const double score = this->score(offsets, plane.normal, height);
      if (score <= best)
        continue;
      best = score;
      sheet.set_plane(center - height * plane.normal, plane.normal);
    }
    if (best <= 0.)
      return sheet;
    const Vector shift = center - sheet.origin;
    for (double reach : reaches)
      if (!fit_quadric(offsets, reach * m_deviation, shift, sheet))
        return sheet;
    const auto lies_on_it = [&](const Vector& d) { return std::abs(sheet.offset(center + d)) < tolerance(); };
    sheet.is_known =
      std::count_if(offsets.begin(), offsets.end(), lies_on_it) >= least_points && lies_on_it(Vector::Zero());
    return sheet;
  }

private:
  // how many points lie on a plane through the center, more or less
  double score(const std::vector<Vector>& offsets, const Vector& normal, double height) const
  {
    double sum = 0.;
    for (const Vector& d : offsets)
    {
      const double square = d.squaredNorm();
      const double ratio = (d.dot(normal) + height) / (tolerance() + bending * square);
      if (ratio * ratio < 1.)
        sum += (1. - ratio * ratio) / (1. + fading * square);
    }
    return sum;
  }

  bool fit_quadric(const std::vector<Vector>& offsets, double reach, const Vector& shift, Sheet& sheet) const
  {
    static constexpr int size = Sheet::size;
    double matrix[size * size] = {}, column[size] = {}, total = 0.;
    for (const Vector& from_center : offsets)
    {
      const Vector d = from_center + shift;
      const double ratio = sheet.offset(sheet.origin + d) / reach;
      if (ratio * ratio >= 1.)
        continue;
      const double weight = (1. - ratio * ratio) * (1. - ratio * ratio);
      const std::array<double, size> m = Sheet::monomials(d.dot(sheet.first), d.dot(sheet.second));
      for (int i = 0; i < size; ++i)
      {
        for (int j = 0; j < size; ++j)
          matrix[i * size + j] += weight * m[i] * m[j];
        column[i] += weight * m[i] * d.dot(sheet.normal);
      }
      total += weight;
    }
    static constexpr double least_total = 3.; // a plane needs as many
    if (total < least_total)
      return false;
    // The squares of all second derivatives, 2 a, b, b, 2 c for a x^2 + b xy + c y^2: their sum is
    // the same for any axes.
    static constexpr double squares_in_sum[size] = {0., 0., 0., 4., 2., 4.};
    const double ridge = m_deviation * m_deviation / (curvature_deviation * curvature_deviation);
    for (int i = 0; i < size; ++i)
      matrix[i * size + i] += relative_ridge + squares_in_sum[i] * ridge;
    Symmetric_factorization(matrix, size).solve(column);
    std::copy(column, column + size, sheet.coefficients.begin());
    return true;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_FIT_H
