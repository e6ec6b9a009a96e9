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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_BASIS_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_BASIS_IMPL_H

#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE void basis_functions(std::size_t span, double u, std::size_t degree,
                                                      const std::vector<double>& knots, std::size_t order, double* out)
{
  const std::size_t width = degree + 1;
  for (std::size_t k = 0; k <= order; ++k)
  {
    double* row = out + k * width;
    std::fill(row, row + width, 0.);
    if (k > degree)
      continue;

    // the values of the basis of degree - k; each pass raises the degree by one, in place from the right
    row[0] = 1.;
    for (std::size_t d = 1; d <= degree - k; ++d)
      for (std::size_t j = d + 1; j-- > 0;)
      {
        const std::size_t i = span - d + j;
        double value = 0.;
        if (j > 0)
          value += (u - knots[i]) / (knots[i + d] - knots[i]) * row[j - 1];
        if (j < d)
          value += (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) * row[j];
        row[j] = value;
      }

    // each pass differentiates once, which raises the degree by one too
    for (std::size_t d = degree - k + 1; d <= degree; ++d)
      for (std::size_t j = d + 1; j-- > 0;)
      {
        const std::size_t i = span - d + j;
        double value = 0.;
        if (j > 0)
          value += row[j - 1] / (knots[i + d] - knots[i]);
        if (j < d)
          value -= row[j] / (knots[i + d + 1] - knots[i + 1]);
        row[j] = double(d) * value;
      }
  }
}

CGAL_WIREFRAME_EXTRACTION_INLINE void evaluate_on_span(const Spline_data& spline, std::size_t span, double u,
                                                       std::size_t order, Spline_vector* out)
{
  const std::size_t degree = spline.degree;
  const std::size_t first = span - degree;
  boost::container::small_vector<double, 32> basis((order + 1) * (degree + 1));
  basis_functions(span, u, degree, spline.knots, order, basis.data());

  // Sums relative to a control point keep their digits on a small curve that is far from the origin.
  const Spline_vector origin = spline.points[first];
  boost::container::small_vector<double, 8> weight(order + 1, 0.);
  for (std::size_t k = 0; k <= order; ++k)
  {
    out[k] = Spline_vector();
    for (std::size_t j = 0; j <= degree; ++j)
    {
      double b = basis[k * (degree + 1) + j];
      if (!spline.weights.empty())
        b *= spline.weights[first + j];
      weight[k] += b;
      out[k] = out[k] + b * (spline.points[first + j] - origin);
    }
  }

  if (!spline.weights.empty())
  {
    // the product rule for (w c)^(k), solved for c^(k)
    for (std::size_t k = 0; k <= order; ++k)
    {
      double binomial = 1.;
      for (std::size_t j = 1; j <= k; ++j)
      {
        binomial *= double(k - j + 1) / double(j);
        out[k] = out[k] - (binomial * weight[j]) * out[k - j];
      }
      out[k] = (1. / weight[0]) * out[k];
    }
  }
  out[0] = out[0] + origin;
}

CGAL_WIREFRAME_EXTRACTION_INLINE double speed_on_span(const Spline_data& spline, std::size_t span, double u)
{
  Spline_vector values[2];
  evaluate_on_span(spline, span, u, 1, values);
  return norm(values[1]);
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::size_t find_span(const std::vector<double>& knots, std::size_t degree, double u)
{
  const auto first = knots.begin() + degree;
  const auto last = knots.end() - degree - 1;
  if (u >= *last)
    return std::size_t(std::lower_bound(first, last, *last) - knots.begin()) - 1;
  if (u < *first)
    u = *first;
  return std::size_t(std::upper_bound(first, last, u) - knots.begin()) - 1;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_BASIS_IMPL_H
