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

#ifndef SAMPLE_SOLIDS_FACE_H
#define SAMPLE_SOLIDS_FACE_H

#include <Sample_solids/geometry.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace Sample_solids {

/// One face of a solid: a parametric patch over the unit square, and what is trimmed off it.
/// The patch is a rectangle, or a line or an arc revolved about an axis: that makes planes, discs, rings,
/// cylinders, cones, spheres and tori.
struct Face
{
  enum class Patch
  {
    RECTANGLE,
    REVOLVED_LINE,
    REVOLVED_ARC
  };

  Patch patch = Patch::RECTANGLE;
  Frame frame;                            ///< the rectangle's corner and sides, or the axis (z) of revolution
  double width = 0, height = 0;           ///< of a rectangle
  Point_2 from = {{0, 0}};                ///< of a revolved line: radius and height at its start,
  Point_2 to = {{0, 0}};                  ///< and at its end
  Point_2 center = {{0, 0}};              ///< of a revolved arc: radius and height of its centre
  double arc_radius = 0;                  ///< of a revolved arc
  double arc_start = 0, arc_sweep = 0;    ///< of a revolved arc
  double first_angle = 0, sweep = 2 * pi; ///< of any revolution

  /// What is kept: where all of these are positive. Each is a signed distance (its slope is at most 1).
  std::vector<std::function<double(const Point&)>> trims;
  std::vector<std::size_t> edges; ///< the curves on its boundary, seams among them
  double area = 0;

  /// returns the point at the parameters (u, v), both in [0, 1].
  Point at(double u, double v) const
  {
    if (patch == Patch::RECTANGLE)
      return frame(u * width, v * height, 0);
    const Point_2 p = profile(v);
    const double angle = first_angle + u * sweep;
    return frame(p[0] * std::cos(angle), p[0] * std::sin(angle), p[1]);
  }

  double area_element(double v) const { return width_at(v) * side_v(); }

  double largest_area_element() const { return side_u() * side_v(); }

  /// an upper bound of the length of a parameter line on which v is constant
  double side_u() const
  {
    if (patch == Patch::RECTANGLE)
      return width;
    if (patch == Patch::REVOLVED_LINE)
      return sweep * (std::max)(from[0], to[0]);
    return sweep * (center[0] + arc_radius);
  }

  /// the length of every parameter line on which u is constant
  double side_v() const
  {
    if (patch == Patch::RECTANGLE)
      return height;
    if (patch == Patch::REVOLVED_LINE)
      return std::hypot(to[0] - from[0], to[1] - from[1]);
    return arc_radius * arc_sweep;
  }

  /// returns the signed distance to what is trimmed off: positive on the face.
  double inside(const Point& p) const
  {
    double least = 1e300;
    for (const std::function<double(const Point&)>& trim : trims)
      least = (std::min)(least, trim(p));
    return least;
  }

  /// returns the area of the trimmed patch: cells that the boundary crosses are cut ever finer.
  double computed_area() const
  {
    const double shape = std::sqrt(side_u() / side_v());
    const int columns = (std::max)(8, static_cast<int>(32 * shape));
    const int rows = (std::max)(8, static_cast<int>(32 / shape));
    double sum = 0;
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j)
        sum += cell_area((i + 0.5) / columns, (j + 0.5) / rows, 1. / columns, 1. / rows, 6);
    return sum;
  }

private:
  Point_2 profile(double v) const
  {
    if (patch == Patch::REVOLVED_LINE)
      return {{from[0] + v * (to[0] - from[0]), from[1] + v * (to[1] - from[1])}};
    const double angle = arc_start + v * arc_sweep;
    return {{center[0] + arc_radius * std::cos(angle), center[1] + arc_radius * std::sin(angle)}};
  }

  double width_at(double v) const { return patch == Patch::RECTANGLE ? width : sweep * profile(v)[0]; }

  double cell_area(double u, double v, double width, double height, int depth) const
  {
    // Simpson's rule along v, on which alone the area element depends
    const double whole =
      width * height * (area_element(v - height / 2) + 4. * area_element(v) + area_element(v + height / 2)) / 6.;
    if (trims.empty())
      return whole;
    const double margin = inside(at(u, v)), a = width * side_u(), b = height * side_v();
    if (std::abs(margin) > 0.5 * std::hypot(a, b))
      return margin > 0 ? whole : 0.;
    if (depth == 0)
      return whole * (std::min)(1., (std::max)(0., 0.5 + margin / std::sqrt(a * b)));
    double sum = 0;
    for (int k = 0; k < 4; ++k)
      sum += cell_area(u + width * (k % 2 == 0 ? -0.25 : 0.25), v + height * (k < 2 ? -0.25 : 0.25), width / 2,
                       height / 2, depth - 1);
    return sum;
  }
};

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_FACE_H
