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
#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CAUCHY_FACTOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CAUCHY_FACTOR_H

#include <cmath>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Makes the residuals of a least-squares problem robust one by one: a residual x is multiplied by
// sqrt(rho(x^2) / x^2), where rho is Cauchy's loss, so that the sum of squares becomes the sum of losses. Many
// residuals can then share a block, which spares a solver its bookkeeping.
struct Cauchy_factor
{
  // below it, two terms of the series are exact up to 1e-12
  static constexpr double least_ratio = 1e-6;

  double value = 1.;
  double derivative = 0.; // by the square of the residual

  Cauchy_factor() {}

  Cauchy_factor(double square, double squared_scale)
  {
    const double q = square / squared_scale;
    if (q < least_ratio)
    {
      value = 1. - 0.25 * q;
      derivative = -0.25 / squared_scale;
      return;
    }
    const double ratio = std::log1p(q) / q;
    value = std::sqrt(ratio);
    derivative = (1. / (1. + q) - ratio) / (2. * value * square);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CAUCHY_FACTOR_H
