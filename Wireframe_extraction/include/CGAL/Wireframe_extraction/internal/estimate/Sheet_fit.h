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

// Finds the sheet on which the center of a ball lies, whatever else is in the ball: the plane through the center on which
// most points lie, then the quadric through these. Lengths are in sampling distances.
class Sheet_fit
{
  // planes are laid through pairs of so many nearest neighbors
  static constexpr std::size_t most_neighbors = 12;
  // which span it: neither is the sine of the angle between them smaller, nor the area
  static constexpr double least_sine = 0.3, least_area = 0.1;
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
  std::vector<Vector> m_offsets; // of the points from the center, nearest first

public:
  // `deviation`: standard deviation of the points
  explicit Sheet_fit(double deviation) : m_deviation(deviation) {}

  // points farther from a sheet are not on it
  double tolerance() const { return exceeded_by_one_in_370 * m_deviation; }

  // `ball` are the points around the center, and the center itself
  Sheet fit(const Vector& center, const std::vector<Vector>& ball)
  {
    m_offsets.clear();
    for (const Vector& p : ball)
      m_offsets.push_back(p - center);
    std::sort(m_offsets.begin(), m_offsets.end(), [](const Vector& a, const Vector& b) {
      const double sa = a.squaredNorm(), sb = b.squaredNorm();
      return sa != sb ? sa < sb : std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    });
    Sheet sheet;
    Vector normal = Vector::Zero();
    if (!find_plane(normal))
      return sheet;
    sheet.set_plane(center, normal);
    for (double reach : reaches)
      if (!fit_quadric(reach * m_deviation, sheet))
        return sheet;
    const auto lies_on_it = [&](const Vector& d) { return std::abs(sheet.offset(center + d)) < tolerance(); };
    sheet.is_known =
      std::count_if(m_offsets.begin(), m_offsets.end(), lies_on_it) >= least_points && lies_on_it(Vector::Zero());
    return sheet;
  }

private:
  bool find_plane(Vector& normal) const
  {
    const std::size_t count = (std::min)(m_offsets.size(), most_neighbors + 1); // the first is the center
    double best = -1.;
    for (std::size_t i = 1; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j)
      {
        Vector n = cross_product(m_offsets[i], m_offsets[j]);
        const double area = n.norm();
        if (area < least_area || area < least_sine * m_offsets[i].norm() * m_offsets[j].norm())
          continue;
        n /= area;
        const double score = this->score(n);
        if (score > best)
        {
          best = score;
          normal = n;
        }
      }
    return best > 0.;
  }

  // how many points lie on a plane through the center, more or less
  double score(const Vector& normal) const
  {
    double sum = 0.;
    for (const Vector& d : m_offsets)
    {
      const double square = d.squaredNorm();
      const double ratio = d.dot(normal) / (tolerance() + bending * square);
      if (ratio * ratio < 1.)
        sum += (1. - ratio * ratio) / (1. + fading * square);
    }
    return sum;
  }

  bool fit_quadric(double reach, Sheet& sheet) const
  {
    static constexpr int size = Sheet::size;
    double matrix[size * size] = {}, column[size] = {}, total = 0.;
    for (const Vector& d : m_offsets)
    {
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
    // the second derivative along an axis is twice the coefficient
    const double ridge = 4. * m_deviation * m_deviation / (curvature_deviation * curvature_deviation);
    for (int i = 0; i < size; ++i)
      matrix[i * size + i] += relative_ridge + (i >= 3 ? ridge : 0.);
    Symmetric_factorization(matrix, size).solve(column);
    std::copy(column, column + size, sheet.coefficients.begin());
    return true;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_FIT_H
