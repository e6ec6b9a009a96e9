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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_EDGE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_EDGE_H

#include <CGAL/Wireframe_extraction/internal/types/Curve_stations.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_curve.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// An edge of the network whose shape is that of a line, a circle or an ellipse.
struct Primitive_edge
{
  static constexpr std::size_t no_vertex = static_cast<std::size_t>(-1);

  Primitive_kind kind = Primitive_kind::LINE;
  std::array<std::size_t, 2> vertices{{no_vertex, no_vertex}};
  // What the vertices leave open. A circle passes through its two vertices and the first of these points, through its
  // vertex and two, or through all three; an ellipse is given by its center and the tips of two conjugate radii.
  std::array<Vector, 3> points{{Vector::Zero(), Vector::Zero(), Vector::Zero()}};
  std::vector<Station> stations;

  bool is_loop() const { return vertices[0] == vertices[1]; }
  bool has_vertex() const { return vertices[0] != no_vertex; }

  // the parameters that determine the shape
  std::vector<double*> blocks(std::vector<Vector>& positions)
  {
    std::vector<double*> result;
    if (kind != Primitive_kind::ELLIPSE && has_vertex())
      result.push_back(positions[vertices[0]].data());
    const std::size_t own = kind == Primitive_kind::LINE ? 0
      : kind == Primitive_kind::ELLIPSE || !has_vertex() ? 3
      : is_loop()                                        ? 2
                                                         : 1;
    for (std::size_t i = 0; i < own; ++i)
      result.push_back(points[i].data());
    if (kind != Primitive_kind::ELLIPSE && has_vertex() && !is_loop())
      result.push_back(positions[vertices[1]].data());
    return result;
  }

  // in the order of `blocks()`
  static Primitive_curve curve(Primitive_kind kind, double const* const* blocks)
  {
    const auto block = [blocks](int i) { return Vector(blocks[i][0], blocks[i][1], blocks[i][2]); };
    if (kind == Primitive_kind::LINE)
      return Primitive_curve::line(block(0), block(1));
    if (kind == Primitive_kind::CIRCLE)
      return Primitive_curve::circle(block(0), block(1), block(2));
    return Primitive_curve::ellipse(block(0), block(1) - block(0), block(2) - block(0));
  }

  Primitive_curve curve(std::vector<Vector>& positions)
  {
    const std::vector<double*> parameters = blocks(positions);
    return curve(kind, parameters.data());
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_EDGE_H
