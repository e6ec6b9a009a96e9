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

#ifndef WIREFRAME_EVALUATION_CIRCLE_THROUGH_POLYLINE_H
#define WIREFRAME_EVALUATION_CIRCLE_THROUGH_POLYLINE_H

#include <Wireframe_evaluation/Polyline.h>

#include <limits>

namespace Wireframe_evaluation {

struct Circle
{
  Point center;
  double radius; ///< infinite if the points are on a line
};

/// returns the circle through the two ends and the middle of a polyline, or through its thirds if it is closed.
inline Circle circle_through_polyline(const Polyline& polyline, bool is_closed)
{
  const double length = polyline.length();
  const Point a = polyline.front();
  const Point b = polyline.point_at(is_closed ? length / 3. : length / 2.);
  const Point c = is_closed ? polyline.point_at(2. * length / 3.) : polyline.back();
  const Vector u = b - a, v = c - a, w = CGAL::cross_product(u, v);
  const double n = w.squared_length();
  if (!(n > 0.))
    return {a, std::numeric_limits<double>::infinity()};
  const Vector to_center =
    (CGAL::cross_product(w, u) * v.squared_length() + CGAL::cross_product(v, w) * u.squared_length()) / (2. * n);
  return {a + to_center, std::sqrt(to_center.squared_length())};
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_CIRCLE_THROUGH_POLYLINE_H
