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

#ifndef SAMPLE_SOLIDS_MAKE_SOLID_H
#define SAMPLE_SOLIDS_MAKE_SOLID_H

#include <Sample_solids/Profile.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Sample_solids {

/// What `make_solid()` may be told.
struct Solid_options
{
  double angle = 30;               ///< of the wedge, in degrees, between 5 and 170
  double radius = 1;               ///< of the rounded plate's corners, in sampling distances, between 0.1 and 10
  double sampling_distance = 0.02; ///< the unit of some lengths; see `depends_on_sampling_distance()`
};

namespace internal {

inline Face disc(const Frame& frame, double inner_radius, double outer_radius)
{
  Face face;
  face.patch = Face::Patch::REVOLVED_LINE;
  face.frame = frame;
  face.from = {{inner_radius, 0}};
  face.to = {{outer_radius, 0}};
  return face;
}

inline Face revolved_line(const Frame& frame, double radius_0, double height_0, double radius_1, double height_1)
{
  Face face;
  face.patch = Face::Patch::REVOLVED_LINE;
  face.frame = frame;
  face.from = {{radius_0, height_0}};
  face.to = {{radius_1, height_1}};
  return face;
}

inline Frame frame_at(double x, double y, double z)
{
  Frame frame;
  frame.origin = {{x, y, z}};
  return frame;
}

/// the frame whose x-y-plane is the plane of x and z, for profiles seen from the front
inline Frame front_frame()
{
  Frame frame;
  frame.y = {{0, 0, 1}};
  frame.z = {{0, 1, 0}};
  return frame;
}

inline Extrusion add_block(Solid& solid, double x, double y, double z)
{
  return extrude(solid, frame_at(-x / 2, -y / 2, 0), Profile({rectangle_loop(0, 0, x, y)}), z);
}

inline void add_frustum(Solid& solid, double radius_0, double radius_1, double height)
{
  const Frame low = frame_at(0, 0, 0), high = frame_at(0, 0, height);
  const std::size_t low_circle = solid.add_circle(low, radius_0);
  const std::size_t high_circle = solid.add_circle(high, radius_1);
  solid.add_face(disc(low, 0, radius_0));
  solid.faces.back().edges = {low_circle};
  solid.add_face(disc(high, 0, radius_1));
  solid.faces.back().edges = {high_circle};
  solid.add_face(revolved_line(low, radius_0, 0, radius_1, height));
  solid.faces.back().edges = {low_circle, high_circle};
}

/// cuts a disc about the z-axis out of a plane face; returns its circle.
inline std::size_t cut_disc(Solid& solid, std::size_t plane_face, const Frame& frame, double radius)
{
  const std::size_t circle = solid.add_circle(frame, radius);
  Face& face = solid.faces[plane_face];
  face.edges.push_back(circle);
  face.trims.push_back([radius](const Point& p) { return std::hypot(p[0], p[1]) - radius; });
  return circle;
}

inline void add_block_with_hole(Solid& solid)
{
  const Extrusion block = add_block(solid, 1.2, 1.0, 0.6);
  drill(solid, block.bottom, block.top, {{0.1, 0, 0}}, {{0.1, 0, 0.6}}, 0.3);
}

inline void add_bracket(Solid& solid)
{
  const double t = 0.25;
  const Extrusion bracket =
    extrude(solid, front_frame(),
            Profile({polygon_loop({{{0, 0}}, {{1.1, 0}}, {{1.1, t}}, {{t, t}}, {{t, 1.0}}, {{0, 1.0}}})}), 0.8);
  drill(solid, bracket.sides[0], bracket.sides[2], {{0.7, 0.4, 0}}, {{0.7, 0.4, t}}, 0.2);
  drill(solid, bracket.sides[5], bracket.sides[3], {{0, 0.4, 0.62}}, {{t, 0.4, 0.62}}, 0.18);
}

inline void add_nut(Solid& solid)
{
  extrude(solid, Frame(), Profile({regular_polygon_loop(6, 0.7), circle_loop(0, 0, 0.36)}), 0.5);
}

inline void add_wedge(Solid& solid, double angle)
{
  const double half = 0.5 * angle * pi / 180., length = 1.2;
  const double x = length * std::cos(half), y = length * std::sin(half);
  extrude(solid, Frame(), Profile({polygon_loop({{{0, 0}}, {{x, -y}}, {{x, y}}})}), 0.8);
}

inline void add_dimple(Solid& solid)
{
  const double height = 0.5, radius = 0.4, above = 0.19;
  const double rim = std::sqrt(radius * radius - above * above);
  const Extrusion block = add_block(solid, 1.2, 1.0, height);
  const std::size_t circle = cut_disc(solid, block.top, frame_at(0, 0, height), rim);
  Face cap;
  cap.patch = Face::Patch::REVOLVED_ARC;
  cap.frame = frame_at(0, 0, height + above);
  cap.arc_radius = radius;
  cap.arc_start = -0.5 * pi;
  cap.arc_sweep = std::atan2(rim, above);
  cap.edges = {circle};
  solid.add_face(cap);
}

inline void add_inscribed_boss(Solid& solid)
{
  const double side = 1.0, height = 0.4, radius = side / 2;
  const Extrusion block = add_block(solid, side, side, height);
  const Frame low = frame_at(0, 0, height), high = frame_at(0, 0, 2 * height);
  const std::size_t foot = cut_disc(solid, block.top, low, radius), rim = solid.add_circle(high, radius);
  solid.add_face(revolved_line(low, radius, 0, radius, height));
  solid.faces.back().edges = {foot, rim};
  solid.add_face(disc(high, 0, radius));
  solid.faces.back().edges = {rim};
}

/// The curve in which the thin cylinder (about x) meets the thick one (about z); `sign` tells the side.
inline std::size_t add_crossing(Solid& solid, double thick, double thin, double sign)
{
  return solid.add_closed_spline([thick, thin, sign](double t) {
    const double y = thin * std::cos(2 * pi * t), z = thin * std::sin(2 * pi * t);
    return Point{{sign * std::sqrt(thick * thick - y * y), y, z}};
  });
}

inline void add_crossing_cylinders(Solid& solid)
{
  const double thick = 0.4, thin = 0.25, half_height = 0.75, reach = 0.85;
  std::vector<std::size_t> barrel_edges;
  for (double sign : {-1., 1.})
  {
    const Frame end = frame_at(0, 0, sign * half_height);
    barrel_edges.push_back(solid.add_circle(end, thick));
    solid.add_face(disc(end, 0, thick));
    solid.faces.back().edges = {barrel_edges.back()};

    const Frame stub_end = frame_along({{sign * reach, 0, 0}}, {{sign, 0, 0}});
    const std::size_t rim = solid.add_circle(stub_end, thin);
    const std::size_t crossing = add_crossing(solid, thick, thin, sign);
    solid.add_face(disc(stub_end, 0, thin));
    solid.faces.back().edges = {rim};
    const double nearest = std::sqrt(thick * thick - thin * thin);
    Face stub = revolved_line(stub_end, thin, nearest - reach, thin, 0);
    stub.edges = {rim, crossing};
    stub.trims.push_back([thick](const Point& p) { return std::hypot(p[0], p[1]) - thick; });
    solid.add_face(stub);
    barrel_edges.push_back(crossing);
  }
  Face barrel = revolved_line(Frame(), thick, -half_height, thick, half_height);
  barrel.edges = barrel_edges;
  barrel.trims.push_back([thin](const Point& p) { return std::hypot(p[1], p[2]) - thin; });
  solid.add_face(barrel);
}

inline void add_channel(Solid& solid)
{
  const double w = 1.0, h = 0.8, t = 0.25;
  extrude(
    solid, front_frame(),
    Profile({polygon_loop({{{0, 0}}, {{w, 0}}, {{w, h}}, {{w - t, h}}, {{w - t, t}}, {{t, t}}, {{t, h}}, {{0, h}}})}),
    1.2);
}

inline void add_slotted_plate(Solid& solid)
{
  const double a = 0.4, radius = 0.22;
  const Loop slot = {line_side({{-a, -radius}}, {{a, -radius}}), arc_side({{a, -radius}}, {{a, radius}}, {{a, 0}}, pi),
                     line_side({{a, radius}}, {{-a, radius}}),
                     arc_side({{-a, radius}}, {{-a, -radius}}, {{-a, 0}}, pi)};
  extrude(solid, Frame(), Profile({rectangle_loop(-0.8, -0.5, 0.8, 0.5), slot}), 0.3);
}

/// A disc with a bore in the middle and a bolt circle of six holes, all of them right through.
inline void add_flange(Solid& solid)
{
  std::vector<Loop> loops = {circle_loop(0, 0, 1.0), circle_loop(0, 0, 0.35)};
  for (int i = 0; i < 6; ++i)
    loops.push_back(circle_loop(0.68 * std::cos(i * pi / 3), 0.68 * std::sin(i * pi / 3), 0.12));
  extrude(solid, Frame(), Profile(loops), 0.3);
}

/// A plate whose corners are rounded.
inline void add_rounded_plate(Solid& solid, double radius)
{
  const double x = 0.8, y = 0.55, a = x - radius, b = y - radius;
  const Loop outline = {line_side({{-a, -y}}, {{a, -y}}), arc_side({{a, -y}}, {{x, -b}}, {{a, -b}}, pi / 2),
                        line_side({{x, -b}}, {{x, b}}),   arc_side({{x, b}}, {{a, y}}, {{a, b}}, pi / 2),
                        line_side({{a, y}}, {{-a, y}}),   arc_side({{-a, y}}, {{-x, b}}, {{-a, b}}, pi / 2),
                        line_side({{-x, b}}, {{-x, -b}}), arc_side({{-x, -b}}, {{-a, -y}}, {{-a, -b}}, pi / 2)};
  extrude(solid, Frame(), Profile({outline}), 0.4);
}

/// A disc with twelve plane sides.
inline void add_faceted_disc(Solid& solid, double thickness)
{
  extrude(solid, Frame(), Profile({regular_polygon_loop(12, 0.6)}), thickness);
}

/// the frame at `center` in a plane that rises along x by `slope`
inline Frame oblique_frame(const Point& center, double slope)
{
  Frame frame;
  frame.origin = center;
  frame.x = unit({{1, 0, slope}});
  frame.z = cross(frame.x, frame.y);
  return frame;
}

/// A cylinder of which an oblique plane cuts off the upper end.
inline void add_elliptic_cut(Solid& solid)
{
  const double radius = 0.5, height = 0.8, slope = 0.6, along = radius * std::hypot(1., slope);
  const Frame low = frame_at(0, 0, 0), cut = oblique_frame({{0, 0, height}}, slope);
  const std::size_t circle = solid.add_circle(low, radius), ellipse = solid.add_ellipse(cut, along, radius);
  solid.add_face(disc(low, 0, radius));
  solid.faces.back().edges = {circle};

  Face top;
  top.frame = cut;
  top.frame.origin = cut(-along, -radius, 0);
  top.width = 2 * along;
  top.height = 2 * radius;
  top.trims.push_back([radius](const Point& p) { return radius - std::hypot(p[0], p[1]); });
  top.edges = {ellipse};
  solid.add_face(top);

  Face wall = revolved_line(low, radius, 0, radius, height + slope * radius);
  wall.trims.push_back([cut](const Point& p) { return dot(cut.origin - p, cut.z); });
  wall.edges = {circle, ellipse};
  solid.add_face(wall);
}

/// A plate with a round hole that is drilled obliquely, so that its rims are ellipses.
inline void add_oblique_hole(Solid& solid)
{
  const double thickness = 0.3, radius = 0.25, angle = 35. * pi / 180.;
  const Extrusion plate = add_block(solid, 1.3, 0.9, thickness);
  const Frame axis = frame_along({{0, 0, thickness / 2}}, {{std::sin(angle), 0, std::cos(angle)}});
  const auto outside_hole = [axis, radius](const Point& p) {
    const Point v = p - axis.origin;
    return std::hypot(dot(v, axis.x), dot(v, axis.y)) - radius;
  };
  const double reach = thickness / (2 * std::cos(angle)) + radius * std::tan(angle);
  Face wall = revolved_line(axis, radius, -reach, radius, reach);
  wall.trims.push_back([thickness](const Point& p) { return (std::min)(p[2], thickness - p[2]); });
  for (std::size_t face : {plate.bottom, plate.top})
  {
    const double height = face == plate.bottom ? 0 : thickness;
    const Frame rim = frame_at((height - thickness / 2) * std::tan(angle), 0, height);
    const std::size_t ellipse = solid.add_ellipse(rim, radius / std::cos(angle), radius);
    solid.faces[face].edges.push_back(ellipse);
    solid.faces[face].trims.push_back(outside_hole);
    wall.edges.push_back(ellipse);
  }
  solid.add_face(wall);
}

inline void add_torus(Solid& solid)
{
  const double large = 0.6, small = 0.3, cut = 0.15;
  const double half = std::sqrt(small * small - cut * cut);
  const Frame plane = frame_at(0, 0, cut);
  const std::size_t inner = solid.add_circle(plane, large - half);
  const std::size_t outer = solid.add_circle(plane, large + half);
  solid.add_face(disc(plane, large - half, large + half));
  solid.faces.back().edges = {inner, outer};
  Face tube;
  tube.patch = Face::Patch::REVOLVED_ARC;
  tube.center = {{large, 0}};
  tube.arc_radius = small;
  tube.arc_start = std::atan2(cut, -half);
  tube.arc_sweep = 2 * pi - 2 * std::atan2(half, cut);
  tube.edges = {inner, outer};
  solid.add_face(tube);
}

inline void add_gear(Solid& solid)
{
  const double tip_radius = 1.3, root_radius = 1.0;
  const double tip = 4.5 * pi / 180., root = 7.5 * pi / 180., pitch = pi / 6.;
  const auto polar = [](double radius, double angle) {
    return Point_2{{radius * std::cos(angle), radius * std::sin(angle)}};
  };
  Loop outline;
  for (int i = 0; i < 12; ++i)
  {
    const double middle = i * pitch;
    const Point_2 a = polar(root_radius, middle - root), b = polar(tip_radius, middle - tip);
    const Point_2 c = polar(tip_radius, middle + tip), d = polar(root_radius, middle + root);
    const Point_2 next = polar(root_radius, (i + 1) % 12 * pitch - root);
    outline.push_back(line_side(a, b));
    outline.push_back(arc_side(b, c, {{0, 0}}, 2 * tip));
    outline.push_back(line_side(c, d));
    outline.push_back(arc_side(d, next, {{0, 0}}, pitch - 2 * root));
  }
  extrude(solid, Frame(), Profile({outline, circle_loop(0, 0, 0.4)}), 0.4);
}

} // namespace internal

/// tells whether lengths of a solid are multiples of the sampling distance.
inline bool depends_on_sampling_distance(const std::string& name)
{
  return name == "thin_plate" || name == "rounded_plate" || name == "faceted_disc";
}

/// returns the names that `make_solid()` knows, each with what it is. The wedge takes any angle.
inline std::vector<std::pair<std::string, std::string>> solid_names()
{
  return {{"box", "a box"},
          {"cylinder", "a cylinder"},
          {"frustum", "a cone frustum"},
          {"box_with_hole", "a box with a round through hole"},
          {"l_bracket", "an L-bracket with a hole in each leg"},
          {"nut", "a hexagonal nut"},
          {"wedge", "a wedge; its angle is an option"},
          {"wedge_15", "a wedge of 15 degrees"},
          {"wedge_30", "a wedge of 30 degrees"},
          {"wedge_60", "a wedge of 60 degrees"},
          {"dimple", "a block with a spherical dimple"},
          {"inscribed_boss", "a block with a round boss that touches its upper edges"},
          {"crossing_cylinders", "two crossing cylinders of different radius"},
          {"u_channel", "a U-channel"},
          {"slotted_plate", "a plate with a slot whose outline is tangent lines and arcs"},
          {"thin_plate", "a plate two sampling distances thick"},
          {"torus", "a torus with a flat cut"},
          {"gear", "a gear with twelve teeth and a hole"},
          {"flange", "a disc with a bore and a bolt circle of six holes"},
          {"elliptic_cut", "a cylinder with an oblique end, whose rim is an ellipse"},
          {"oblique_hole", "a plate with a round hole drilled obliquely: its rims are ellipses"},
          {"rounded_plate", "a plate with rounded corners; their radius is an option"},
          {"faceted_disc", "a disc with twelve plane sides, seven sampling distances thick"}};
}

/// makes the solid of the given name.
/// \throw std::invalid_argument if there is no such solid, or if an option of the one that is asked for is out of
/// its range
inline Solid make_solid(const std::string& name, const Solid_options& options = Solid_options())
{
  if (name == "wedge" && !(options.angle >= 5 && options.angle <= 170))
    throw std::invalid_argument("the angle of a wedge must be between 5 and 170 degrees");
  if (name == "rounded_plate" && !(options.radius >= 0.1 && options.radius <= 10))
    throw std::invalid_argument("the radius of the rounded plate must be between 0.1 and 10 sampling distances");
  const double r = options.sampling_distance;
  Solid solid;
  solid.name = name;
  if (name == "box")
    internal::add_block(solid, 1.2, 1.0, 0.8);
  else if (name == "cylinder")
    internal::add_frustum(solid, 0.5, 0.5, 1.0);
  else if (name == "frustum")
    internal::add_frustum(solid, 0.6, 0.35, 0.8);
  else if (name == "box_with_hole")
    internal::add_block_with_hole(solid);
  else if (name == "l_bracket")
    internal::add_bracket(solid);
  else if (name == "nut")
    internal::add_nut(solid);
  else if (name == "wedge")
    internal::add_wedge(solid, options.angle);
  else if (name == "wedge_15")
    internal::add_wedge(solid, 15);
  else if (name == "wedge_30")
    internal::add_wedge(solid, 30);
  else if (name == "wedge_60")
    internal::add_wedge(solid, 60);
  else if (name == "dimple")
    internal::add_dimple(solid);
  else if (name == "inscribed_boss")
    internal::add_inscribed_boss(solid);
  else if (name == "crossing_cylinders")
    internal::add_crossing_cylinders(solid);
  else if (name == "u_channel")
    internal::add_channel(solid);
  else if (name == "slotted_plate")
    internal::add_slotted_plate(solid);
  else if (name == "thin_plate")
    internal::add_block(solid, 1.2, 0.9, 2 * r);
  else if (name == "torus")
    internal::add_torus(solid);
  else if (name == "gear")
    internal::add_gear(solid);
  else if (name == "flange")
    internal::add_flange(solid);
  else if (name == "elliptic_cut")
    internal::add_elliptic_cut(solid);
  else if (name == "oblique_hole")
    internal::add_oblique_hole(solid);
  else if (name == "rounded_plate")
    internal::add_rounded_plate(solid, options.radius * r);
  else if (name == "faceted_disc")
    internal::add_faceted_disc(solid, 7 * r);
  else
    throw std::invalid_argument("there is no solid '" + name + "'");
  solid.finish();
  return solid;
}

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_MAKE_SOLID_H
