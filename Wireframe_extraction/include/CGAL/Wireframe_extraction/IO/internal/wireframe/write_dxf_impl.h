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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_DXF_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_DXF_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/dxf_frame.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_dxf.h>
#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// the entities of a wireframe, and the box around them
class Dxf_entities
{
  typedef Plain_curve Curve;
  typedef Plain_spline Spline;

public:
  // conics that are tilted against the xy plane may be splines, as other programs flatten them or put them elsewhere
  Dxf_entities(const Plain_traits& traits, bool are_tilted_splines)
    : m_traits(traits), m_are_tilted_splines(are_tilted_splines)
  {}

  void add(const Plain_wireframe& wireframe)
  {
    for (const auto& vertex : wireframe.vertices)
      add_vertex(vector_of(vertex, m_traits));
    for (const Curve& curve : wireframe.curves)
      add_curve(curve);
  }

  const Dxf_text& dxf() const { return m_dxf; }
  const Dxf_extent& extent() const { return m_extent; }
  std::string next_handle() const { return to_hexadecimal(m_handle); }

private:
  void start(const char* name, const Dxf_layer& layer)
  {
    m_dxf.add(0, name);
    m_dxf.add(5, to_hexadecimal(m_handle++));
    m_dxf.add("330 1F\n100 AcDbEntity");
    m_dxf.add(8, layer.name);
  }

  void add_vertex(const Spline_vector& p)
  {
    m_extent.add(p);
    start("POINT", dxf_layer_of_vertices());
    m_dxf.add(100, "AcDbPoint");
    m_dxf.add(10, p);
  }

  void add_curve(const Curve& curve)
  {
    // the curve does not leave the hull of its control points
    for (const auto& point : curve.spline.control_points())
      m_extent.add(vector_of(point, m_traits));
    switch (curve.type)
    {
    case Wireframe_curve_type::LINE: return add_line(curve);
    case Wireframe_curve_type::CIRCLE:
    case Wireframe_curve_type::ARC: return add_circle(curve);
    case Wireframe_curve_type::ELLIPSE:
    case Wireframe_curve_type::ELLIPTIC_ARC: return add_ellipse(curve);
    default: return add_spline(curve.type, curve.spline);
    }
  }

  void add_line(const Curve& curve)
  {
    start("LINE", dxf_layer_of(curve.type));
    m_dxf.add(100, "AcDbLine");
    m_dxf.add(10, vector_of(curve.spline.control_points().front(), m_traits));
    m_dxf.add(11, vector_of(curve.spline.control_points().back(), m_traits));
  }

  // Many programs put an arc elsewhere unless its extrusion is exactly (0, 0, 1): that it is where the plane of the arc
  // is level as far as is known. Then it runs the other way round if it was seen from below.
  Orthonormal_conic upright_if_it_may_be(const Curve& curve) const
  {
    static constexpr double rounding = 1e-9;
    Orthonormal_conic conic = orthonormal_conic(curve, m_traits);
    const double tilt = std::hypot(conic.axis.x, conic.axis.y);
    const Spline_vector level = {conic.x.x, conic.x.y, 0.};
    if (!(tilt <= (std::max)(curve.uncertainty.direction, rounding)) || !(norm(level) > 0.))
      return conic;
    if (conic.axis.z < 0.)
      conic.start_angle = -(conic.start_angle + conic.sweep);
    conic.axis = {0., 0., 1.};
    conic.x = unit_vector(level);
    return conic;
  }

  // The plane of a circle has axes of its own, which follow from its normal by the rule of the format.
  void add_circle(const Curve& curve)
  {
    const Orthonormal_conic conic = upright_if_it_may_be(curve);
    if (m_are_tilted_splines && conic.axis.z < 1.)
      return add_spline(curve.type, curve.spline);
    const Spline_vector n = conic.axis;
    const bool is_steep = std::abs(n.x) < 1. / 64. && std::abs(n.y) < 1. / 64.;
    const Spline_vector x = unit_vector(cross(is_steep ? Spline_vector{0., 1., 0.} : Spline_vector{0., 0., 1.}, n));
    const Spline_vector y = unit_vector(cross(n, x));
    start(conic.is_full ? "CIRCLE" : "ARC", dxf_layer_of(curve.type));
    m_dxf.add(100, "AcDbCircle");
    m_dxf.add(10, Spline_vector{dot(conic.center, x), dot(conic.center, y), dot(conic.center, n)});
    m_dxf.add(40, conic.major_radius);
    m_dxf.add(210, n);
    if (conic.is_full)
      return;
    const double begin = std::atan2(dot(conic.x, y), dot(conic.x, x)) + conic.start_angle;
    m_dxf.add(100, "AcDbArc");
    m_dxf.add(50, in_turn(begin * 180. / CGAL_PI, 360.));
    m_dxf.add(51, end_in_turn((begin + conic.sweep) * 180. / CGAL_PI, 360.));
  }

  void add_ellipse(const Curve& curve)
  {
    const Orthonormal_conic conic = upright_if_it_may_be(curve);
    // the format has no flatter ones
    if (conic.minor_radius < 1e-6 * conic.major_radius || (m_are_tilted_splines && conic.axis.z < 1.))
      return add_spline(curve.type, curve.spline);
    start("ELLIPSE", dxf_layer_of(curve.type));
    m_dxf.add(100, "AcDbEllipse");
    m_dxf.add(10, conic.center);
    m_dxf.add(11, conic.major_radius * conic.x);
    m_dxf.add(210, conic.axis);
    m_dxf.add(40, conic.minor_radius / conic.major_radius);
    m_dxf.add(41, conic.is_full ? 0. : in_turn(conic.start_angle, 2. * CGAL_PI));
    m_dxf.add(42, conic.is_full ? 2. * CGAL_PI : end_in_turn(conic.start_angle + conic.sweep, 2. * CGAL_PI));
  }

  void add_spline(Wireframe_curve_type type, const Spline& spline)
  {
    start("SPLINE", dxf_layer_of(type));
    m_dxf.add(100, "AcDbSpline");
    // One that is called closed has to be periodic for LibreCAD, which draws another curve of clamped knots. Where it
    // ends, it starts in any case.
    m_dxf.add(70, spline.is_rational() ? 4 : 0);
    m_dxf.add(71, spline.degree());
    m_dxf.add(72, spline.knots().size());
    m_dxf.add(73, spline.control_points().size());
    m_dxf.add(74, 0);
    for (const auto& knot : spline.knots())
      m_dxf.add(40, knot);
    for (const auto& weight : spline.weights())
      m_dxf.add(41, weight);
    for (const auto& point : spline.control_points())
      m_dxf.add(10, vector_of(point, m_traits));
  }

  // the same angle in the first turn
  static double in_turn(double angle, double turn)
  {
    const double result = angle - turn * std::floor(angle / turn);
    return result < turn ? result : 0.;
  }

  // an arc may end after a whole turn, but not before it started
  static double end_in_turn(double angle, double turn)
  {
    const double result = in_turn(angle, turn);
    return result > 0. ? result : turn;
  }

  const Plain_traits& m_traits;
  bool m_are_tilted_splines;
  Dxf_text m_dxf;
  Dxf_extent m_extent;
  std::size_t m_handle = 0x100;
};

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_dxf(std::ostream& out, const Plain_wireframe& wireframe, Wireframe_extraction::Length_unit unit,
               bool are_tilted_splines, std::string& error)
{
  const Plain_traits traits;
  error = wireframe_problem(wireframe, traits);
  if (!error.empty())
    return false;
  Dxf_entities entities(traits, are_tilted_splines);
  entities.add(wireframe);
  Dxf_text before, after;
  add_dxf_header(unit, entities.extent(), entities.next_handle(), before);
  add_dxf_tables(entities.extent(), before);
  add_dxf_blocks(before);
  before.add("0 SECTION\n2 ENTITIES");
  after.add("0 ENDSEC");
  add_dxf_objects(after);
  // the middle of a box, or coordinates in a plane, may be out of range where those of the wireframe are not
  if (before.is_finite() && entities.dxf().is_finite())
    out << before.text() << entities.dxf().text() << after.text();
  else
    error = "the wireframe is too large for this format; scale it down";
  return error.empty();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_DXF_IMPL_H
