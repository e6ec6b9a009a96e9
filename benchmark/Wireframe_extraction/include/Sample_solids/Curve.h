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

#ifndef SAMPLE_SOLIDS_CURVE_H
#define SAMPLE_SOLIDS_CURVE_H

#include <Sample_solids/geometry.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

namespace Sample_solids {

enum class Curve_kind
{
  LINE,
  CIRCLE,
  ARC,
  ELLIPSE,
  ELLIPTIC_ARC,
  SPLINE,
  COMPOSITE
};

inline const char* name_of(Curve_kind kind)
{
  switch (kind)
  {
  case Curve_kind::LINE: return "line";
  case Curve_kind::CIRCLE: return "circle";
  case Curve_kind::ARC: return "arc";
  case Curve_kind::ELLIPSE: return "ellipse";
  case Curve_kind::ELLIPTIC_ARC: return "elliptic_arc";
  case Curve_kind::SPLINE: return "spline";
  case Curve_kind::COMPOSITE: return "composite";
  }
  return "";
}

/// One edge of a solid, over the parameters 0 to 1: a line, a circle, an arc, any other smooth curve given as a
/// map, or, whatever its kind, the polyline by which it is known.
struct Curve
{
  static constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();

  Curve_kind kind = Curve_kind::LINE;
  bool is_closed = false;
  bool is_sharp = true;           ///< a smooth seam between two faces is an edge, but not a sharp one
  std::size_t source = no_vertex; ///< vertex at the parameter 0
  std::size_t target = no_vertex; ///< vertex at the parameter 1

  Point start = {{0, 0, 0}};        ///< of a line
  Point end = {{0, 0, 0}};          ///< of a line
  Frame frame;                      ///< of a circle or an arc: the centre; the angle 0 is along x
  double radius = 0;                ///< of a circle or an arc
  double sweep = 0;                 ///< of a circle or an arc, positive, in radians
  std::function<Point(double)> map; ///< of any other curve
  std::vector<Point> polyline;      ///< if not empty, what the curve is; see `set_polyline()`
  std::vector<double> arc_lengths;  ///< of the polyline, up to each of its points

  /// makes the curve a polyline of two or more points. Its parameter is the arc length.
  void set_polyline(std::vector<Point> points)
  {
    polyline.swap(points);
    arc_lengths.assign(1, 0.);
    for (std::size_t i = 1; i < polyline.size(); ++i)
      arc_lengths.push_back(arc_lengths.back() + distance(polyline[i - 1], polyline[i]));
  }

  bool has_closed_form_distance() const { return polyline.empty() && !map; }

  /// returns the point at the parameter `t`.
  Point at(double t) const
  {
    if (!polyline.empty())
      return at_arc_length(t * arc_lengths.back());
    if (map)
      return map(t);
    if (kind == Curve_kind::LINE)
      return start + t * (end - start);
    const double angle = t * sweep;
    return frame(radius * std::cos(angle), radius * std::sin(angle), 0);
  }

  /// returns the direction at the parameter `t`, of unit length.
  Point tangent(double t) const
  {
    if (!polyline.empty() && t <= 0)
      return end_tangent(0);
    if (!polyline.empty() && t >= 1)
      return -1. * end_tangent(polyline.size() - 1);
    const double h = 1e-6;
    const double low = (std::max)(0., t - h), high = (std::min)(1., t + h);
    return unit(at(high) - at(low));
  }

  /// returns the length; of a map by Simpson's rule on the speed.
  double length() const
  {
    if (!polyline.empty())
      return arc_lengths.back();
    if (!map)
      return kind == Curve_kind::LINE ? distance(start, end) : radius * sweep;
    const int n = 4096;
    const double h = 1. / n;
    double sum = 0;
    for (int i = 0; i <= n; ++i)
      sum += (i == 0 || i == n ? 1. : i % 2 == 1 ? 4. : 2.) * speed(i * h);
    return sum * h / 3.;
  }

  /// returns the distance to a line, a circle or an arc.
  double closed_form_distance(const Point& p) const
  {
    return kind == Curve_kind::LINE ? distance_to_line(p) : distance_to_arc(p);
  }

  /// returns the distance to the segment of a polyline that begins at its point `i`.
  double distance_to_segment(const Point& p, std::size_t i) const
  {
    return distance_to_segment(p, polyline[i], polyline[i + 1]);
  }

  /// returns the smallest distance to the part between two near parameters of a map.
  double local_distance(const Point& p, double low, double high) const
  {
    // the sign of the derivative of the squared distance brackets its minimum
    double f_low = slope(p, low), f_high = slope(p, high);
    if (f_low >= 0 || f_high <= 0)
      return (std::min)(distance(p, at(low)), distance(p, at(high)));
    double t = low;
    int side = 0;
    for (int i = 0; i < 60 && high - low > 1e-12; ++i)
    {
      t = (low * f_high - high * f_low) / (f_high - f_low);
      const double f = slope(p, t);
      if (std::abs(f) < 1e-13)
        break;
      if (f < 0)
      {
        low = t;
        f_low = f;
        if (side == -1)
          f_high *= 0.5;
        side = -1;
      }
      else
      {
        high = t;
        f_high = f;
        if (side == 1)
          f_low *= 0.5;
        side = 1;
      }
    }
    return distance(p, at(t));
  }

  /// returns points at most `step` apart by arc length, from end to end.
  std::vector<Point> sampled(double step) const
  {
    const std::size_t n =
      (std::max)(std::size_t(is_closed ? 3 : 1), static_cast<std::size_t>(std::ceil(length() / step - 1e-9)));
    std::vector<Point> points;
    points.reserve(n + 1);
    for (double t : even_parameters(n))
      points.push_back(at(t));
    if (is_closed)
      points.back() = points.front();
    return points;
  }

private:
  Point at_arc_length(double s) const
  {
    const auto next = std::upper_bound(arc_lengths.begin() + 1, arc_lengths.end() - 1, s);
    const std::size_t i = static_cast<std::size_t>(next - arc_lengths.begin());
    const double t = (s - arc_lengths[i - 1]) / (arc_lengths[i] - arc_lengths[i - 1]);
    return polyline[i - 1] + (std::min)(1., (std::max)(0., t)) * (polyline[i] - polyline[i - 1]);
  }

  /// the direction from an end of the polyline inwards: that of the circle through the last three points, so
  /// that a coarse polyline of an arc has the arc's tangent
  Point end_tangent(std::size_t first) const
  {
    const std::size_t n = polyline.size();
    const Point& p = polyline[first];
    const Point u = polyline[first == 0 ? 1 : n - 2] - p;
    if (n == 2)
      return unit(u);
    const Point v = polyline[first == 0 ? 2 : n - 3] - p;
    const Point w = (1. / dot(u, u)) * u - (1. / (std::max)(dot(v, v), 1e-300)) * v;
    return dot(w, u) > 0 ? unit(w) : unit(u);
  }

  Point derivative(double t) const
  {
    const double h = 1e-5;
    return (1. / (2. * h)) * (at(t + h) - at(t - h));
  }

  double speed(double t) const { return norm(derivative(t)); }

  double slope(const Point& p, double t) const { return dot(at(t) - p, derivative(t)); }

  static double distance_to_segment(const Point& p, const Point& a, const Point& b)
  {
    const Point v = b - a;
    const double t = dot(p - a, v) / dot(v, v);
    return distance(p, a + (std::min)(1., (std::max)(0., t)) * v);
  }

  double distance_to_line(const Point& p) const { return distance_to_segment(p, start, end); }

  double distance_to_arc(const Point& p) const
  {
    const Point v = p - frame.origin;
    const double a = dot(v, frame.x), b = dot(v, frame.y), c = dot(v, frame.z);
    if (!is_closed)
    {
      double angle = std::atan2(b, a);
      if (angle < 0)
        angle += 2. * pi;
      if (angle > sweep)
        return (std::min)(distance(p, at(0)), distance(p, at(1)));
    }
    return std::hypot(std::sqrt(a * a + b * b) - radius, c);
  }

  std::vector<double> even_parameters(std::size_t n) const
  {
    std::vector<double> result;
    if (!map || !polyline.empty())
    {
      for (std::size_t i = 0; i <= n; ++i)
        result.push_back(static_cast<double>(i) / static_cast<double>(n));
      return result;
    }
    const std::size_t m = 16 * n + 1024;
    std::vector<double> lengths(m + 1, 0.);
    Point last = at(0);
    for (std::size_t i = 1; i <= m; ++i)
    {
      const Point next = at(static_cast<double>(i) / static_cast<double>(m));
      lengths[i] = lengths[i - 1] + distance(last, next);
      last = next;
    }
    std::size_t k = 0;
    for (std::size_t i = 0; i <= n; ++i)
    {
      const double s = lengths[m] * static_cast<double>(i) / static_cast<double>(n);
      while (k + 1 < m && lengths[k + 1] < s)
        ++k;
      const double t = (s - lengths[k]) / (lengths[k + 1] - lengths[k]);
      result.push_back((static_cast<double>(k) + (std::min)(1., (std::max)(0., t))) / static_cast<double>(m));
    }
    return result;
  }
};

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_CURVE_H
