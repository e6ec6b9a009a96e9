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

#ifndef WIREFRAME_EVALUATION_POLYLINE_H
#define WIREFRAME_EVALUATION_POLYLINE_H

#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Wireframe_evaluation {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;

inline double distance(const Point& p, const Point& q) { return std::sqrt((q - p).squared_length()); }

inline bool is_finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

/*!
A polyline that can be measured and sampled by arc length. It has one point at least, and none that is equal to
the one before, unless all are equal; then it has two.
*/
class Polyline
{
public:
  /// constructs the polyline through points, of which there must be one at least.
  explicit Polyline(const std::vector<Point>& points)
  {
    for (const Point& p : points)
      if (m_points.empty() || p != m_points.back())
        m_points.push_back(p);
    if (m_points.size() == 1)
      m_points.push_back(m_points.front());
    m_lengths.assign(1, 0.);
    for (std::size_t i = 1; i < m_points.size(); ++i)
      m_lengths.push_back(m_lengths.back() + distance(m_points[i - 1], m_points[i]));
  }

  const std::vector<Point>& points() const { return m_points; }
  const Point& front() const { return m_points.front(); }
  const Point& back() const { return m_points.back(); }
  double length() const { return m_lengths.back(); }

  /// returns the smallest box around the polyline.
  CGAL::Bbox_3 bbox() const
  {
    CGAL::Bbox_3 box;
    for (const Point& p : m_points)
      box += p.bbox();
    return box;
  }

  /// returns the point at the arc length `s` from the start.
  Point point_at(double s) const
  {
    const auto it = std::upper_bound(m_lengths.begin() + 1, m_lengths.end() - 1, s);
    return point_on(static_cast<std::size_t>(it - m_lengths.begin()), s);
  }

  /// returns points at equal arc lengths, at most `step` apart, from the first to the last point.
  std::vector<Point> sample(double step) const
  {
    const std::size_t n = static_cast<std::size_t>((std::max)(1., std::ceil(length() / step * (1. - 1e-12))));
    std::vector<Point> result;
    result.reserve(n + 1);
    std::size_t i = 1;
    for (std::size_t k = 0; k < n; ++k)
    {
      const double s = length() * static_cast<double>(k) / static_cast<double>(n);
      while (i + 1 < m_lengths.size() && m_lengths[i] <= s)
        ++i;
      result.push_back(point_on(i, s));
    }
    result.push_back(back());
    return result;
  }

  /// returns the unit vector from an end to where the polyline leaves the ball of radius `radius` around it,
  /// or to the other end if it does not. It is the null vector where both are the same point.
  Vector direction_from_end(bool is_from_back, double radius) const
  {
    const Point& center = is_from_back ? back() : front();
    Point before = center, target = is_from_back ? front() : back();
    for (std::size_t k = 1; k < m_points.size(); ++k)
    {
      const Point& p = m_points[is_from_back ? m_points.size() - 1 - k : k];
      if (distance(center, p) >= radius)
      {
        target = leaving_point(center, before, p, radius);
        break;
      }
      before = p;
    }
    const double d = distance(center, target);
    return d > 0. ? (target - center) / d : Vector(0, 0, 0);
  }

  /// returns the polyline passed the other way.
  Polyline reversed() const { return Polyline(std::vector<Point>(m_points.rbegin(), m_points.rend())); }

private:
  // the point at arc length s, which is on the i-th segment, counted from one
  Point point_on(std::size_t i, double s) const
  {
    const double length_of_segment = m_lengths[i] - m_lengths[i - 1];
    const double t = length_of_segment > 0. ? (s - m_lengths[i - 1]) / length_of_segment : 0.;
    return m_points[i - 1] + (std::min)((std::max)(t, 0.), 1.) * (m_points[i] - m_points[i - 1]);
  }

  // where the segment from `inside` to `outside` leaves the ball
  static Point leaving_point(const Point& center, const Point& inside, const Point& outside, double radius)
  {
    const Vector v = outside - inside, w = inside - center;
    const double a = v.squared_length(), b = v * w, c = w.squared_length() - radius * radius;
    const double t = (-b + std::sqrt((std::max)(b * b - a * c, 0.))) / a;
    return inside + (std::min)((std::max)(t, 0.), 1.) * v;
  }

  std::vector<Point> m_points;
  std::vector<double> m_lengths; // from the start to each point
};

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_POLYLINE_H
