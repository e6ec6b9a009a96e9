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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DRAWING_VIEWS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DRAWING_VIEWS_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace IO {
namespace internal {

// A direction of view, given by the directions to the right and upwards on the page.
struct Drawing_view
{
  const char* id;
  const char* title;
  Spline_vector right, up;
};

// the views of a drawing in third-angle projection, row by row
inline const std::array<Drawing_view, 4>& drawing_views()
{
  static const double a = std::sqrt(1. / 2.), b = std::sqrt(1. / 6.);
  static const std::array<Drawing_view, 4> views = {{{"top", "Top (x, y)", {1., 0., 0.}, {0., 1., 0.}},
                                                     {"isometric", "Isometric", {a, a, 0.}, {-b, b, 2. * b}},
                                                     {"front", "Front (x, z)", {1., 0., 0.}, {0., 0., 1.}},
                                                     {"right", "Right (y, z)", {0., 1., 0.}, {0., 0., 1.}}}};
  return views;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DRAWING_VIEWS_H
