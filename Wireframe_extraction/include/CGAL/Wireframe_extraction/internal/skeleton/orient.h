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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_ORIENT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_ORIENT_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The sign of an eigenvector is arbitrary: the first point of the ball that is clearly on one side decides which way a
// curve goes.
inline void orient(Local_curve& curve, const Field_band& band, const std::vector<std::size_t>& ball)
{
  static constexpr double clear_side = 0.5; // r, so that rounding does not decide
  double side = 0.;
  std::size_t first = band.size();
  for (std::size_t j : ball)
  {
    const double s = curve.parameter(band.points[j]);
    if (std::abs(s) > clear_side && j < first)
    {
      first = j;
      side = s;
    }
  }
  if (side < 0.)
    curve.tangent = -curve.tangent;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_ORIENT_H
