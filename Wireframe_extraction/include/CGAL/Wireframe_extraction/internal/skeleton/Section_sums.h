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
#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SECTION_SUMS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SECTION_SUMS_H

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Sums for the normal equations of a fit whose residuals depend on where a curve passes a cross-section: on its
// position there, which changes along the curve by a tangent and a curvature. The derivatives by these six parameters
// are those by the position, times 1, s and s^2 / 2: sums over powers of s hold all of their products.
struct Section_sums
{
  double xx[5] = {}, xy[5] = {}, yy[5] = {}; // by powers of s
  double x[3] = {}, y[3] = {};               // right-hand side

  // A residual e with its derivatives by the position; `powers` are those of s, from 1 to s^4.
  void add(const double* powers, double by_x, double by_y, double weight, double e)
  {
    const double wx = weight * by_x, wy = weight * by_y;
    const double wxx = wx * by_x, wxy = wx * by_y, wyy = wy * by_y;
    for (int k = 0; k < 5; ++k)
    {
      xx[k] += wxx * powers[k];
      xy[k] += wxy * powers[k];
      yy[k] += wyy * powers[k];
    }
    const double wex = wx * e, wey = wy * e;
    for (int k = 0; k < 3; ++k)
    {
      x[k] -= wex * powers[k];
      y[k] -= wey * powers[k];
    }
  }

  // into the first six rows and columns; the parameters alternate between x and y
  template <class Matrix, class Column>
  void assemble(Matrix& hessian, Column& gradient) const
  {
    static constexpr double factors[3] = {1., 1., 0.5};
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double factor = factors[j] * factors[k];
        hessian(2 * j, 2 * k) = factor * xx[j + k];
        hessian(2 * j, 2 * k + 1) = hessian(2 * k + 1, 2 * j) = factor * xy[j + k];
        hessian(2 * j + 1, 2 * k + 1) = factor * yy[j + k];
      }
      gradient[2 * j] = factors[j] * x[j];
      gradient[2 * j + 1] = factors[j] * y[j];
    }
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SECTION_SUMS_H
