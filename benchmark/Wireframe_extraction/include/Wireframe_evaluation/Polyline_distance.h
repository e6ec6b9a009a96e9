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

#ifndef WIREFRAME_EVALUATION_POLYLINE_DISTANCE_H
#define WIREFRAME_EVALUATION_POLYLINE_DISTANCE_H

#include <Wireframe_evaluation/Evaluated_curve.h>
#include <Wireframe_evaluation/Polyline.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_segment_primitive_3.h>
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Wireframe_evaluation {

/// The exact distance of points to a set of polylines.
class Polyline_distance
{
  typedef Kernel::Segment_3 Segment;
  typedef std::vector<Segment>::const_iterator Iterator;
#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_segment_primitive_3<Kernel, Iterator> Primitive;
  typedef CGAL::AABB_traits_3<Kernel, Primitive> Traits;
#else
  typedef CGAL::AABB_segment_primitive<Kernel, Iterator> Primitive;
  typedef CGAL::AABB_traits<Kernel, Primitive> Traits;
#endif

public:
  explicit Polyline_distance(const Polyline& polyline)
  {
    add(polyline);
    build();
  }

  explicit Polyline_distance(const std::vector<Evaluated_curve>& curves)
  {
    for (const Evaluated_curve& curve : curves)
      add(curve.polyline);
    build();
  }

  // the tree refers to the segments
  Polyline_distance(const Polyline_distance&) = delete;
  Polyline_distance& operator=(const Polyline_distance&) = delete;

  /// returns the distance of one point.
  double operator()(const Point& p) const { return std::sqrt(m_tree.squared_distance(p)); }

  /// returns the distance of each of some points.
  std::vector<double> operator()(const std::vector<Point>& points) const
  {
    std::vector<double> result;
    result.reserve(points.size());
    for (const Point& p : points)
      result.push_back((*this)(p));
    return result;
  }

  /// returns the largest distance of some points, or, once one is at least `bound`, any such distance.
  double largest(const std::vector<Point>& points, double bound) const
  {
    double result = 0.;
    for (std::size_t i = 0; i < points.size() && result < bound; ++i)
      result = (std::max)(result, (*this)(points[i]));
    return result;
  }

private:
  void add(const Polyline& polyline)
  {
    for (std::size_t i = 1; i < polyline.points().size(); ++i)
      m_segments.emplace_back(polyline.points()[i - 1], polyline.points()[i]);
  }

  void build()
  {
    m_tree.insert(m_segments.cbegin(), m_segments.cend());
    m_tree.build();
  }

  std::vector<Segment> m_segments;
  CGAL::AABB_tree<Traits> m_tree;
};

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_POLYLINE_DISTANCE_H
