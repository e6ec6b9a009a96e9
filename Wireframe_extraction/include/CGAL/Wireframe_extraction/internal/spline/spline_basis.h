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

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

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
std::size_t find_span(const std::vector<double>& knots, std::size_t degree, double u);

// Writes the values at u of the degree + 1 basis functions of that degree that do not vanish on the span, and
// their derivatives up to `order`: out[k * (degree + 1) + j] is the k-th derivative of the basis function
// that belongs to the control point span - degree + j. `out` has room for (order + 1) * (degree + 1) values.
// O(order * degree^2).
void basis_functions(std::size_t span, double u, std::size_t degree, const std::vector<double>& knots,
                     std::size_t order, double* out);

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
void evaluate_on_span(const Spline_data& spline, std::size_t span, double u, std::size_t order, Spline_vector* out);

double speed_on_span(const Spline_data& spline, std::size_t span, double u);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_BASIS_H
