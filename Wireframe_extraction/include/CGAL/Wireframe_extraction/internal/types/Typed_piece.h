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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_TYPED_PIECE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_TYPED_PIECE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_curve.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A curve whose type is asked for, in units of the sampling distance.
struct Untyped_curve
{
  static constexpr std::size_t no_vertex = static_cast<std::size_t>(-1);

  std::vector<Vector> polyline; // dense; of a closed curve the first point again at the end
  std::array<std::size_t, 2> vertices{{no_vertex, no_vertex}};
  double number_of_parameters = 0.;
  bool is_closed_without_vertex() const { return vertices[0] == no_vertex; }
  bool is_loop() const { return !is_closed_without_vertex() && vertices[0] == vertices[1]; }
};

// A piece of such a curve: a line, a circle or an ellipse, or what remains a spline.
struct Typed_piece
{
  static constexpr std::size_t no_vertex = Untyped_curve::no_vertex;

  std::size_t curve = 0;                 // the one that it is a piece of
  std::array<double, 2> range{{0., 0.}}; // of arc lengths on that one's polyline; may pass the end of a closed one
  bool is_whole = true;
  std::array<std::size_t, 2> vertices{{no_vertex, no_vertex}};
  bool is_primitive = false;
  bool is_type_uncertain = false; // it is a spline, but only just
  Primitive_curve shape;
  Vector middle = Vector::Zero(); // a point about half way, which tells in what direction a shape is run through
  std::array<Vector, 2> end_tangents{{Vector::Zero(), Vector::Zero()}}; // that a spline has to take on, if not zero
  double position_deviation = 0., direction_deviation = 0., major_radius_deviation = 0., minor_radius_deviation = 0.;
  double root_mean_square = 0., maximum_deviation = 0.;
  std::size_t support = 0;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_TYPED_PIECE_H
