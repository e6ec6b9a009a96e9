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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_BASIS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_BASIS_H

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Three doubles. Its functions are found by argument only, so they collide with no other vector's.
struct Spline_vector
{
  double x = 0., y = 0., z = 0.;

  friend Spline_vector operator+(const Spline_vector& a, const Spline_vector& b)
  {
    return Spline_vector{a.x + b.x, a.y + b.y, a.z + b.z};
  }

  friend Spline_vector operator-(const Spline_vector& a, const Spline_vector& b)
  {
    return Spline_vector{a.x - b.x, a.y - b.y, a.z - b.z};
  }

  friend Spline_vector operator*(double s, const Spline_vector& a) { return Spline_vector{s * a.x, s * a.y, s * a.z}; }

  friend double dot(const Spline_vector& a, const Spline_vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

  friend Spline_vector cross(const Spline_vector& a, const Spline_vector& b)
  {
    return Spline_vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }

  friend double norm(const Spline_vector& a) { return std::sqrt(dot(a, a)); }
};

// Returns the index s with knots[s] <= u < knots[s + 1] and degree <= s < number of control points. A
// parameter outside the range gets the first or the last span that is not empty; so does the end of the
// range, which makes evaluation there the limit from the left. The range must not be empty. O(log n).
inline std::size_t find_span(const std::vector<double>& knots, std::size_t degree, double u)
{
  const auto first = knots.begin() + degree;
  const auto last = knots.end() - degree - 1;
  if (u >= *last)
    return std::size_t(std::lower_bound(first, last, *last) - knots.begin()) - 1;
  if (u < *first)
    u = *first;
  return std::size_t(std::upper_bound(first, last, u) - knots.begin()) - 1;
}

// Writes the values at u of the degree + 1 basis functions of that degree that do not vanish on the span, and
// their derivatives up to `order`: out[k * (degree + 1) + j] is the k-th derivative of the basis function
// that belongs to the control point span - degree + j. `out` has room for (order + 1) * (degree + 1) values.
// O(order * degree^2).
inline void basis_functions(std::size_t span, double u, std::size_t degree, const std::vector<double>& knots,
                            std::size_t order, double* out)
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

// A B-spline in double: knots, control points, and weights that are empty if all are one.
struct Spline_data
{
  std::size_t degree = 0;
  std::vector<double> knots;
  std::vector<Spline_vector> points;
  std::vector<double> weights;

  double front() const { return knots[degree]; }
  double back() const { return knots[points.size()]; }
  std::size_t multiplicity(double u) const
  {
    const auto range = std::equal_range(knots.begin(), knots.end(), u);
    return std::size_t(range.second - range.first);
  }
};

// Writes the point at u and the derivatives up to `order` with respect to u into out[0 .. order].
inline void evaluate_on_span(const Spline_data& spline, std::size_t span, double u, std::size_t order,
                             Spline_vector* out)
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

inline double speed_on_span(const Spline_data& spline, std::size_t span, double u)
{
  Spline_vector values[2];
  evaluate_on_span(spline, span, u, 1, values);
  return norm(values[1]);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_BASIS_H
