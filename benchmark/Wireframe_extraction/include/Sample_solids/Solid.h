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

#ifndef SAMPLE_SOLIDS_SOLID_H
#define SAMPLE_SOLIDS_SOLID_H

#include <Sample_solids/Curve.h>
#include <Sample_solids/Face.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace Sample_solids {

/// A solid by its boundary: vertices, curves (sharp edges and smooth seams), and faces.
struct Solid
{
  std::string name;
  std::vector<Point> vertices;
  std::vector<Curve> curves;
  std::vector<Face> faces;

  double area() const
  {
    double sum = 0;
    for (const Face& face : faces)
      sum += face.area;
    return sum;
  }

  /// returns all sharp curves.
  std::vector<std::size_t> sharp_curves() const
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (curves[i].is_sharp)
        result.push_back(i);
    return result;
  }

  /// returns the sharp curves of a face and of the faces that share an edge with it.
  std::vector<std::size_t> curves_around(std::size_t face) const
  {
    std::vector<std::size_t> result;
    for (const Face& other : faces)
      if (share_an_edge(faces[face], other))
        for (std::size_t edge : other.edges)
          if (curves[edge].is_sharp)
            result.push_back(edge);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  /// \name Construction. Vertices and curves that are there already are found again.
  /// @{
  std::size_t add_vertex(const Point& p)
  {
    for (std::size_t i = 0; i < vertices.size(); ++i)
      if (distance(vertices[i], p) < tolerance)
        return i;
    vertices.push_back(p);
    return vertices.size() - 1;
  }

  std::size_t add_line(const Point& p, const Point& q, bool is_sharp = true)
  {
    Curve curve;
    curve.start = p;
    curve.end = q;
    curve.is_sharp = is_sharp;
    return add_curve(std::move(curve));
  }

  /// the arc about the z-direction of `frame` that starts on its x-direction; a circle if it turns by 2 pi
  std::size_t add_arc(const Frame& frame, double radius, double sweep)
  {
    Curve curve;
    curve.is_closed = sweep > 2. * pi - 1e-12;
    curve.kind = curve.is_closed ? Curve_kind::CIRCLE : Curve_kind::ARC;
    curve.frame = frame;
    curve.radius = radius;
    curve.sweep = sweep;
    return add_curve(std::move(curve));
  }

  std::size_t add_circle(const Frame& frame, double radius) { return add_arc(frame, radius, 2. * pi); }

  /// the ellipse with the given half axes along the x- and the y-direction of `frame`
  std::size_t add_ellipse(const Frame& frame, double half_x, double half_y)
  {
    return add_closed_curve(Curve_kind::ELLIPSE, [frame, half_x, half_y](double t) {
      return frame(half_x * std::cos(2. * pi * t), half_y * std::sin(2. * pi * t), 0);
    });
  }

  /// a closed smooth curve that is given by a periodic map of [0, 1]
  std::size_t add_closed_spline(std::function<Point(double)> map)
  {
    return add_closed_curve(Curve_kind::SPLINE, std::move(map));
  }

  std::size_t add_face(Face face)
  {
    faces.push_back(std::move(face));
    return faces.size() - 1;
  }

  /// computes the areas; to be called when all faces are there and trimmed.
  void finish()
  {
    for (Face& face : faces)
      face.area = face.computed_area();
  }
  /// @}

private:
  static constexpr double tolerance = 1e-9;

  static bool share_an_edge(const Face& a, const Face& b)
  {
    return &a == &b || std::any_of(a.edges.begin(), a.edges.end(), [&b](std::size_t edge) {
      return std::find(b.edges.begin(), b.edges.end(), edge) != b.edges.end();
    });
  }

  std::size_t add_closed_curve(Curve_kind kind, std::function<Point(double)> map)
  {
    Curve curve;
    curve.kind = kind;
    curve.is_closed = true;
    curve.map = std::move(map);
    return add_curve(std::move(curve));
  }

  std::size_t add_curve(Curve curve)
  {
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (are_same(curves[i], curve))
        return i;
    if (!curve.is_closed)
    {
      curve.source = add_vertex(curve.at(0));
      curve.target = add_vertex(curve.at(1));
    }
    curves.push_back(std::move(curve));
    return curves.size() - 1;
  }

  static bool are_same(const Curve& a, const Curve& b)
  {
    if (a.kind != b.kind)
      return false;
    if (a.kind == Curve_kind::CIRCLE)
      return distance(a.frame.origin, b.frame.origin) < tolerance && std::abs(a.radius - b.radius) < tolerance
        && norm(cross(a.frame.z, b.frame.z)) < tolerance;
    if (distance(a.at(0.5), b.at(0.5)) > tolerance)
      return false;
    const bool is_parallel = distance(a.at(0), b.at(0)) < tolerance && distance(a.at(1), b.at(1)) < tolerance;
    const bool is_opposite = distance(a.at(0), b.at(1)) < tolerance && distance(a.at(1), b.at(0)) < tolerance;
    return is_parallel || is_opposite;
  }
};

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_SOLID_H
