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

#ifndef WIREFRAME_EVALUATION_EVALUATED_CURVE_H
#define WIREFRAME_EVALUATION_EVALUATED_CURVE_H

#include <Wireframe_evaluation/Curve_kind.h>
#include <Wireframe_evaluation/Polyline.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace Wireframe_evaluation {

/// A curve of a wireframe, as a fine polyline.
struct Evaluated_curve
{
  /// the value of `source` and `target` where there is no vertex
  static constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();

  Polyline polyline;
  bool is_closed = false;
  Curve_kind kind = Curve_kind::SPLINE;
  std::size_t source = no_vertex;
  std::size_t target = no_vertex;

  bool has_vertices() const { return source != no_vertex && target != no_vertex; }
};

/// A true wireframe. `curves` are chains through all smooth vertices, `segments` the single typed edges; those
/// have no vertices.
struct True_wireframe
{
  double sampling_distance = 0;
  std::size_t number_of_points = 0; ///< of the cloud; 0 if the file does not tell
  std::vector<Evaluated_curve> curves;
  std::vector<Evaluated_curve> segments;
  std::vector<Point> corners;
};

/// A wireframe to be evaluated. `corners` is used only if there are no vertices.
struct Predicted_wireframe
{
  std::vector<Point> vertices;
  std::vector<Point> corners;
  std::vector<Evaluated_curve> curves;
};

/// returns the smallest box around all curves.
inline CGAL::Bbox_3 bounding_box(const std::vector<Evaluated_curve>& curves)
{
  CGAL::Bbox_3 box;
  for (const Evaluated_curve& curve : curves)
    box += curve.polyline.bbox();
  return box;
}

/// returns the length of the diagonal of the box around all curves.
inline double diagonal(const std::vector<Evaluated_curve>& curves)
{
  const CGAL::Bbox_3 box = bounding_box(curves);
  return distance(Point(box.xmin(), box.ymin(), box.zmin()), Point(box.xmax(), box.ymax(), box.zmax()));
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_EVALUATED_CURVE_H
