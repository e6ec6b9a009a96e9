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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_DXF_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_DXF_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/dxf_frame.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// the entities of a wireframe, and the box around them
template <class GeomTraits>
class Dxf_entities
{
  typedef Wireframe_curve<GeomTraits> Curve;
  typedef Spline_curve_3<GeomTraits> Spline;

public:
  explicit Dxf_entities(const GeomTraits& traits) : m_traits(traits) {}

  void add(const CGAL::Wireframe<GeomTraits>& wireframe)
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

  // The plane of a circle has axes of its own, which follow from its normal by the rule of the format.
  void add_circle(const Curve& curve)
  {
    const Orthonormal_conic conic = orthonormal_conic(curve, m_traits);
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
    const Orthonormal_conic conic = orthonormal_conic(curve, m_traits);
    // the format has no flatter ones
    if (conic.minor_radius < 1e-6 * conic.major_radius)
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
    m_dxf.add(70, (spline.is_closed() ? 1 : 0) + (spline.is_rational() ? 4 : 0));
    m_dxf.add(71, spline.degree());
    m_dxf.add(72, spline.knots().size());
    m_dxf.add(73, spline.control_points().size());
    m_dxf.add(74, 0);
    for (const auto& knot : spline.knots())
      m_dxf.add(40, CGAL::to_double(knot));
    for (const auto& weight : spline.weights())
      m_dxf.add(41, CGAL::to_double(weight));
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

  const GeomTraits& m_traits;
  Dxf_text m_dxf;
  Dxf_extent m_extent;
  std::size_t m_handle = 0x100;
};

template <class GeomTraits, class NamedParameters>
bool write_dxf(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
               std::string& error)
{
  const GeomTraits traits = get_geom_traits<GeomTraits>(np);
  error = wireframe_problem(wireframe, traits);
  if (!error.empty())
    return false;
  Dxf_entities<GeomTraits> entities(traits);
  entities.add(wireframe);
  Dxf_text before, after;
  add_dxf_header(get_length_unit(np), entities.extent(), entities.next_handle(), before);
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

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the DXF format of AutoCAD 2000 (AC1015, ascii).
///
/// The curves are entities in space, exact up to rounding, in the model space and in the order of the
/// wireframe: a line is a `LINE`, a circle a `CIRCLE`, an arc an `ARC`, an ellipse or an arc of one an
/// `ELLIPSE`, and a B-spline a `SPLINE` with its degree, knots, weights and control points. A circle or an
/// ellipse has the normal of its plane as its extrusion direction, about which an arc runs counterclockwise.
/// Every kind of curve has a layer: `LINES`, `CIRCLES`, `ARCS`, `ELLIPSES`, `ELLIPTIC_ARCS` and `SPLINES`;
/// before the curves, the vertices are `POINT` entities in the layer `VERTICES`. An ellipse whose radii
/// differ by a factor of more than a million is a `SPLINE`, as the format has none; an arc of a whole turn is
/// a full circle or ellipse.
///
/// The format does not hold which vertices a curve joins, the uncertainties, how well the cloud supports a
/// curve, and the sampling distance.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; written as `$INSUNITS`, by which programs
///                           scale what they insert}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the stream cannot be written.
///
/// Takes time and memory linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_dxf(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_dxf(out, wireframe, np, error); });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the DXF format of AutoCAD 2000 (AC1015, ascii).
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; written as `$INSUNITS`, by which programs
///                           scale what they insert}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time and memory linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_dxf(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_dxf(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_DXF_H
