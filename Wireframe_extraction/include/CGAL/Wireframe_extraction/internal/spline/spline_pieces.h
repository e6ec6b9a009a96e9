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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PIECES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PIECES_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A control point with its weight. Interpolation is that of the homogeneous points, written such that equal
// points stay as they are and both ends are met exactly.
struct Weighted_control_point
{
  Spline_vector point;
  double weight = 1.;
};

Weighted_control_point interpolate(const Weighted_control_point& a, const Weighted_control_point& b, double t);

Weighted_control_point weighted_control_point(const Spline_data& spline, std::size_t i);

// Inserts the knot u, which lies in the range, until its multiplicity is the degree. O(n + degree^2).
void insert_knot_fully(Spline_data& spline, double u);

// Returns the part from u0 to u1, clamped at both ends; u0 < u1 lie in the range.
Spline_data clamped_part(Spline_data spline, double u0, double u1);

// The part of a spline on one span that is not empty, as the control points of a Bezier curve.
struct Bezier_piece
{
  std::size_t span = 0;
  double begin = 0., end = 0.;
  std::vector<Weighted_control_point> points;
};

// O(n degree^3). Each piece starts at the very point at which the one before ends.
std::vector<Bezier_piece> bezier_pieces(const Spline_data& spline);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/spline/spline_pieces_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PIECES_H
