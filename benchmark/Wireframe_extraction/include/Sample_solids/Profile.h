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

#ifndef SAMPLE_SOLIDS_PROFILE_H
#define SAMPLE_SOLIDS_PROFILE_H

#include <Sample_solids/Solid.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace Sample_solids {

/// A side of a profile: a line, or an arc (counterclockwise if its sweep is positive).
struct Side
{
  Point_2 from = {{0, 0}}, to = {{0, 0}};
  bool is_arc = false;
  Point_2 center = {{0, 0}};
  double radius = 0, first_angle = 0, sweep = 0;

  bool is_circle() const { return is_arc && std::abs(sweep) > 2. * pi - 1e-12; }

  double low_angle() const { return sweep > 0 ? first_angle : first_angle + sweep; }

  Point_2 direction(bool at_end) const
  {
    if (!is_arc)
    {
      const double l = std::hypot(to[0] - from[0], to[1] - from[1]);
      return {{(to[0] - from[0]) / l, (to[1] - from[1]) / l}};
    }
    const double angle = first_angle + (at_end ? sweep : 0.), sign = sweep > 0 ? 1. : -1.;
    return {{-sign * std::sin(angle), sign * std::cos(angle)}};
  }

  double distance_to(double x, double y) const
  {
    if (!is_arc)
    {
      const double a = to[0] - from[0], b = to[1] - from[1];
      const double t = ((x - from[0]) * a + (y - from[1]) * b) / (a * a + b * b);
      const double s = (std::min)(1., (std::max)(0., t));
      return std::hypot(x - from[0] - s * a, y - from[1] - s * b);
    }
    double angle = std::atan2(y - center[1], x - center[0]) - low_angle();
    angle -= 2. * pi * std::floor(angle / (2. * pi));
    if (angle > std::abs(sweep))
      return (std::min)(std::hypot(x - from[0], y - from[1]), std::hypot(x - to[0], y - to[1]));
    return std::abs(std::hypot(x - center[0], y - center[1]) - radius);
  }
};

inline Side line_side(const Point_2& from, const Point_2& to)
{
  Side side;
  side.from = from;
  side.to = to;
  return side;
}

/// the arc from `from` to `to` about `center`, which turns by `sweep` (signed)
inline Side arc_side(const Point_2& from, const Point_2& to, const Point_2& center, double sweep)
{
  Side side = line_side(from, to);
  side.is_arc = true;
  side.center = center;
  side.radius = std::hypot(from[0] - center[0], from[1] - center[1]);
  side.first_angle = std::atan2(from[1] - center[1], from[0] - center[0]);
  side.sweep = sweep;
  return side;
}

typedef std::vector<Side> Loop;

inline Loop polygon_loop(const std::vector<Point_2>& corners)
{
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.push_back(line_side(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}

inline Loop rectangle_loop(double x_0, double y_0, double x_1, double y_1)
{
  return polygon_loop({{{x_0, y_0}}, {{x_1, y_0}}, {{x_1, y_1}}, {{x_0, y_1}}});
}

/// around the origin, with a corner on the x-axis, `radius` away from the origin
inline Loop regular_polygon_loop(int number_of_corners, double radius)
{
  std::vector<Point_2> corners;
  for (int i = 0; i < number_of_corners; ++i)
  {
    const double angle = 2 * i * pi / number_of_corners;
    corners.push_back({{radius * std::cos(angle), radius * std::sin(angle)}});
  }
  return polygon_loop(corners);
}

inline Loop circle_loop(double x, double y, double radius)
{
  const Point_2 p = {{x + radius, y}};
  return {arc_side(p, p, {{x, y}}, 2. * pi)};
}

/// A planar region: an outer loop, and the loops of its holes.
class Profile
{
public:
  Profile(std::vector<Loop> loops) : m_loops(std::move(loops))
  {
    for (const Loop& loop : m_loops)
      for (const Side& side : loop)
        add_monotone_pieces(side);
  }

  const std::vector<Loop>& get_loops() const { return m_loops; }

  /// returns the distance to the boundary, positive inside.
  double signed_distance(double x, double y) const
  {
    double least = (std::numeric_limits<double>::max)();
    for (const Loop& loop : m_loops)
      for (const Side& side : loop)
        least = (std::min)(least, side.distance_to(x, y));
    return is_inside(x, y) ? least : -least;
  }

  bool is_rectangle() const
  {
    if (m_loops.size() != 1 || m_loops[0].size() != 4)
      return false;
    for (const Side& side : m_loops[0])
      if (side.is_arc || (side.from[0] != side.to[0] && side.from[1] != side.to[1]))
        return false;
    return true;
  }

  /// the bounding box: x and y of the lowest corner, x and y of the highest
  std::array<double, 4> box() const
  {
    std::array<double, 4> result = {{1e300, 1e300, -1e300, -1e300}};
    for (const Piece& piece : m_pieces)
    {
      const double x_low = (std::min)(piece.x_0, piece.x_1), x_high = (std::max)(piece.x_0, piece.x_1);
      const double bulge = piece.radius > 0 ? piece.center[0] + piece.sign * piece.radius : x_low;
      const bool has_bulge = piece.radius > 0 && piece.y_0 <= piece.center[1] && piece.center[1] <= piece.y_1;
      result[0] = (std::min)(result[0], has_bulge ? (std::min)(x_low, bulge) : x_low);
      result[1] = (std::min)(result[1], piece.y_0);
      result[2] = (std::max)(result[2], has_bulge ? (std::max)(x_high, bulge) : x_high);
      result[3] = (std::max)(result[3], piece.y_1);
    }
    return result;
  }

private:
  /// A part of a side on which y does not turn back: with it the parity of crossings needs no special case.
  struct Piece
  {
    double x_0, y_0, x_1, y_1; // y_0 <= y_1
    double radius;             // 0 for a line
    Point_2 center;
    double sign; // of an arc: on which side of its centre it is
  };

  void add_piece(Point_2 a, Point_2 b, double radius, const Point_2& center, double sign)
  {
    if (a[1] > b[1])
      std::swap(a, b);
    m_pieces.push_back({a[0], a[1], b[0], b[1], radius, center, sign});
  }

  void add_monotone_pieces(const Side& side)
  {
    if (!side.is_arc)
      return add_piece(side.from, side.to, 0, {{0, 0}}, 0);
    const double low = side.low_angle(), high = low + std::abs(side.sweep);
    Point_2 last = side.sweep > 0 ? side.from : side.to;
    const Point_2 final = side.sweep > 0 ? side.to : side.from;
    double last_angle = low;
    for (double k = std::ceil(low / pi - 0.5 + 1e-9); (k + 0.5) * pi < high - 1e-9; ++k)
    {
      const double angle = (k + 0.5) * pi;
      const double up = std::sin(angle) > 0 ? 1. : -1.;
      const Point_2 next = {{side.center[0], side.center[1] + up * side.radius}};
      add_piece(last, next, side.radius, side.center, std::cos(0.5 * (last_angle + angle)) > 0 ? 1. : -1.);
      last = next;
      last_angle = angle;
    }
    add_piece(last, final, side.radius, side.center, std::cos(0.5 * (last_angle + high)) > 0 ? 1. : -1.);
  }

  bool is_inside(double x, double y) const
  {
    bool result = false;
    for (const Piece& piece : m_pieces)
      if (piece.y_0 <= y && y < piece.y_1 && x < crossing(piece, y))
        result = !result;
    return result;
  }

  static double crossing(const Piece& piece, double y)
  {
    if (piece.radius == 0)
      return piece.x_0 + (piece.x_1 - piece.x_0) * (y - piece.y_0) / (piece.y_1 - piece.y_0);
    const double b = y - piece.center[1];
    return piece.center[0] + piece.sign * std::sqrt((std::max)(0., piece.radius * piece.radius - b * b));
  }

  std::vector<Loop> m_loops;
  std::vector<Piece> m_pieces;
};

/// The faces that `extrude()` made.
struct Extrusion
{
  std::size_t bottom = 0, top = 0;
  std::vector<std::size_t> sides; ///< one per side of the profile, loop after loop
};

namespace internal {

inline Frame arc_frame(const Frame& frame, const Side& side, double height)
{
  Frame result = frame;
  result.origin = frame(side.center[0], side.center[1], height);
  const double c = std::cos(side.low_angle()), s = std::sin(side.low_angle());
  result.x = c * frame.x + s * frame.y;
  result.y = c * frame.y - s * frame.x;
  return result;
}

inline std::size_t add_side_curve(Solid& solid, const Frame& frame, const Side& side, double height)
{
  if (side.is_arc)
    return solid.add_arc(arc_frame(frame, side, height), side.radius, std::abs(side.sweep));
  return solid.add_line(frame(side.from[0], side.from[1], height), frame(side.to[0], side.to[1], height));
}

inline Face side_face(const Frame& frame, const Side& side, double height)
{
  Face face;
  face.height = height;
  if (side.is_arc)
  {
    face.patch = Face::Patch::REVOLVED_LINE;
    face.frame = arc_frame(frame, side, 0);
    face.from = {{side.radius, 0}};
    face.to = {{side.radius, height}};
    face.sweep = std::abs(side.sweep);
    return face;
  }
  const Point_2 d = side.direction(false);
  face.frame.origin = frame(side.from[0], side.from[1], 0);
  face.frame.x = d[0] * frame.x + d[1] * frame.y;
  face.frame.y = frame.z;
  face.width = std::hypot(side.to[0] - side.from[0], side.to[1] - side.from[1]);
  return face;
}

inline Face cap_face(const Frame& frame, const Profile& profile, double height)
{
  const std::array<double, 4> box = profile.box();
  Face face;
  face.frame = frame;
  face.frame.origin = frame(box[0], box[1], height);
  face.width = box[2] - box[0];
  face.height = box[3] - box[1];
  if (!profile.is_rectangle())
    face.trims.push_back([frame, profile](const Point& p) {
      const Point v = p - frame.origin;
      return profile.signed_distance(dot(v, frame.x), dot(v, frame.y));
    });
  return face;
}

} // namespace internal

/// extrudes a profile in the x-y-plane of `frame` along its z-direction, and adds all faces and edges.
/// Where two sides are tangent the edge between them is a smooth seam.
inline Extrusion extrude(Solid& solid, const Frame& frame, const Profile& profile, double height)
{
  Extrusion result;
  result.bottom = solid.add_face(internal::cap_face(frame, profile, 0));
  result.top = solid.add_face(internal::cap_face(frame, profile, height));
  for (const Loop& loop : profile.get_loops())
  {
    const std::size_t first = solid.faces.size();
    for (const Side& side : loop)
    {
      const std::size_t low = internal::add_side_curve(solid, frame, side, 0);
      const std::size_t high = internal::add_side_curve(solid, frame, side, height);
      result.sides.push_back(solid.add_face(internal::side_face(frame, side, height)));
      solid.faces.back().edges = {low, high};
      solid.faces[result.bottom].edges.push_back(low);
      solid.faces[result.top].edges.push_back(high);
    }
    for (std::size_t i = 0; i < loop.size() && !loop[i].is_circle(); ++i)
    {
      const std::size_t next = (i + 1) % loop.size();
      const Point_2 a = loop[i].direction(true), b = loop[next].direction(false), p = loop[next].from;
      const bool is_smooth = a[0] * b[0] + a[1] * b[1] > 1. - 1e-9;
      const std::size_t edge = solid.add_line(frame(p[0], p[1], 0), frame(p[0], p[1], height), !is_smooth);
      solid.faces[first + i].edges.push_back(edge);
      solid.faces[first + next].edges.push_back(edge);
    }
  }
  return result;
}

/// drills a hole from `entry` to `exit`, which lie on the two planar faces that are given.
inline void drill(Solid& solid, std::size_t entry_face, std::size_t exit_face, const Point& entry, const Point& exit,
                  double radius)
{
  const Frame frame = frame_along(entry, exit - entry);
  const double depth = distance(entry, exit);
  Frame far_frame = frame;
  far_frame.origin = exit;
  const std::size_t near_circle = solid.add_circle(frame, radius);
  const std::size_t far_circle = solid.add_circle(far_frame, radius);
  const auto trim = [frame, radius](const Point& p) {
    const Point v = p - frame.origin;
    return std::hypot(dot(v, frame.x), dot(v, frame.y)) - radius;
  };
  solid.faces[entry_face].trims.push_back(trim);
  solid.faces[entry_face].edges.push_back(near_circle);
  solid.faces[exit_face].trims.push_back(trim);
  solid.faces[exit_face].edges.push_back(far_circle);
  Face wall;
  wall.patch = Face::Patch::REVOLVED_LINE;
  wall.frame = frame;
  wall.from = {{radius, 0}};
  wall.to = {{radius, depth}};
  wall.edges = {near_circle, far_circle};
  solid.add_face(wall);
}

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_PROFILE_H
