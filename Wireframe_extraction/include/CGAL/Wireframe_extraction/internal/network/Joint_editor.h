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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_EDITOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_EDITOR_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/network/Joint_course.h>
#include <CGAL/Wireframe_extraction/internal/network/Network_editor.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What an editor of a network may make of a place where two curves meet, or where one bends: a corner, or a rounded
// course.
class Joint_editor : protected Network_editor
{
  // Lengths in r, angles in radians.
  // How far before a corner traces may be wrong, or a rounded course starts. The first is the least that leaves other
  // points than the node; the last reaches beyond balls of radius_of_fits, in which the courses are compared.
  static constexpr double rounding_reaches[] = {0.7, 1., 1.4, 2., 2.8, 4., 5.6};
  static constexpr double farthest_corner = 3.; // from where the two were joined, which is as far as traces stop short
  static constexpr int pieces_of_arc = 10;      // 0.6 at most, where arcs are 6 long: about the step of a trace
  static constexpr double straight_turn = 1e-3; // less is a straight line, for which the handle is a third
  static constexpr double points_per_length = 2.; // of straight edges, as of traces
  static constexpr std::size_t least_pieces = 4;

protected:
  // with larger errors, in r, a spline that bends explains a corner as well
  static constexpr double least_noise_without_fits = 0.1;
  static constexpr double length_of_joint = 8.; // of each curve, twice what a ball sees of it
  static constexpr double least_edge = 1.;      // nodes within what one point covers are no two corners

  using Network_editor::Network_editor;

  static void improve(Joint_course& course, const Joint_course& fitted)
  {
    if (fitted.loss < course.loss)
      course = fitted;
  }

  // of those where one polyline ends and the other starts, and where they would meet if they went on from a little
  // farther away, since close to a corner traces go astray
  template <class Joint>
  static Joint_course best_corner(const Joint& joint, const std::vector<Vector>& head, const std::vector<Vector>& tail)
  {
    Joint_course best{{head, tail}, joint.loss({head, tail})};
    if (const std::optional<Joint_course> corner = best_extrapolated_corner(joint, head, tail))
      improve(best, *corner);
    return best;
  }

  // of those where two polylines would meet if they went on from a little farther away, if they do
  template <class Joint>
  static std::optional<Joint_course> best_extrapolated_corner(const Joint& joint, const std::vector<Vector>& head,
                                                              const std::vector<Vector>& tail)
  {
    std::optional<Joint_course> best;
    for (double reach : rounding_reaches)
    {
      std::vector<Vector> before = cut_back(head, 1, reach), after = cut_back(tail, 0, reach);
      if (before.size() < 2 || after.size() < 2)
        break;
      const Vector corner = meeting_point(before.back(), end_direction(before), after.back(), end_direction(after));
      if (!((corner - head.back()).norm() < farthest_corner))
        continue;
      before.push_back(corner);
      after.push_back(corner);
      std::reverse(after.begin(), after.end());
      const double loss = joint.loss({before, after});
      if (!best || loss < best->loss)
        best = Joint_course{{before, after}, loss};
    }
    return best;
  }

  // the point nearest to two lines, which are not parallel
  static Vector meeting_point(const Vector& p, const Vector& u, const Vector& q, const Vector& v)
  {
    const double uv = u.dot(v), determinant = 1. - uv * uv;
    const Vector w = q - p;
    return 0.5 * (p + q + ((u.dot(w) - uv * v.dot(w)) * u + (uv * u.dot(w) - v.dot(w)) * v) / determinant);
  }

  // of those that lead over from one polyline to the other by an arc
  template <class Joint>
  static Joint_course best_rounded_course(const Joint& joint, const std::vector<Vector>& head,
                                          const std::vector<Vector>& tail)
  {
    Joint_course best{{}, (std::numeric_limits<double>::infinity)()};
    for (double reach : rounding_reaches)
    {
      std::vector<Vector> path = cut_back(head, 1, reach);
      const std::vector<Vector> end = cut_back(tail, 0, reach);
      if (path.size() < 2 || end.size() < 2)
        break;
      append_arc(path, end_direction(path), end.back(), -end_direction(end));
      path.insert(path.end(), end.rbegin() + 1, end.rend());
      const double loss = joint.loss({path});
      if (loss < best.loss)
        best = {{path}, loss};
    }
    return best;
  }

  static Vector end_direction(const std::vector<Vector>& points) { return Inward_view(points, 1).direction(0); }

  static std::vector<Vector> straight(const Vector& a, const Vector& b)
  {
    const std::size_t count = (std::max)(least_pieces, static_cast<std::size_t>(points_per_length * (b - a).norm()));
    std::vector<Vector> points;
    for (std::size_t k = 0; k <= count; ++k)
      points.push_back(a + (b - a) * (double(k) / double(count)));
    return points;
  }

  // leads smoothly from the end of a polyline to another place, about on a circle where that is possible
  static void append_arc(std::vector<Vector>& points, const Vector& leave, const Vector& to, const Vector& arrive)
  {
    const Vector from = points.back();
    const double turn = std::acos((std::min)(1., (std::max)(-1., leave.dot(arrive))));
    const double chord = (to - from).norm();
    const double handle =
      turn > straight_turn ? (std::min)(1., 2. / 3. * std::tan(turn / 4.) / std::sin(turn / 2.)) : 1. / 3.;
    const Vector first = from + handle * chord * leave, second = to - handle * chord * arrive;
    for (int k = 1; k <= pieces_of_arc; ++k)
    {
      const double t = double(k) / pieces_of_arc, u = 1. - t;
      points.push_back(u * u * u * from + 3. * u * u * t * first + 3. * u * t * t * second + t * t * t * to);
    }
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_EDITOR_H
