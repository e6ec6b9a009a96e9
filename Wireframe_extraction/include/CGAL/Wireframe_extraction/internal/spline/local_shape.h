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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_LOCAL_SHAPE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_LOCAL_SHAPE_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What the curve does next to a parameter, on the side on which it goes on: to the right, or at the end of
// the range to the left.
struct Local_shape
{
  // a unit vector in the direction of growing parameters; null on a curve that is a point
  Spline_vector tangent;
  double curvature = 0.;
};

// Finds the lowest derivatives that do not vanish: with c(t) = c(0) + a t^m + ... + b t^n + ..., where b is
// the first coefficient not parallel to a, the tangent is a and the curvature behaves like
// n (n - m) |a x b| / (m^2 |a|^3) t^(n - 2 m). Returns whether the curve moves on that span at all.
bool shape_on_span(const Spline_data& spline, std::size_t span, double u, bool is_left_limit, Local_shape& shape);

Local_shape local_shape(const Spline_data& spline, double u);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/spline/local_shape_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_LOCAL_SHAPE_H
