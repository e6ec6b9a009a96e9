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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FITTED_CURVE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FITTED_CURVE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/fit/Cubic_spline.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A path of the topological graph that becomes a spline.
struct Fitted_curve
{
  std::vector<Vector> path;            // closed: the first point again at the end
  std::array<std::size_t, 2> vertices; // of the network, or `no_vertex` on a closed curve without
  Cubic_spline spline;
  double root_mean_square = 0., maximum_deviation = 0.;
  std::size_t support = 0;

  static constexpr std::size_t no_vertex = static_cast<std::size_t>(-1);
  bool is_closed_without_vertex() const { return vertices[0] == no_vertex; }
  bool is_loop() const { return !is_closed_without_vertex() && vertices[0] == vertices[1]; }
  std::size_t least_spans() const { return is_closed_without_vertex() ? 4 : is_loop() ? 3 : 1; }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FITTED_CURVE_H
