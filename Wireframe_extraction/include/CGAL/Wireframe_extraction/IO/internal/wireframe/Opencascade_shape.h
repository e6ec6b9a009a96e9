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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_OPENCASCADE_SHAPE_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_OPENCASCADE_SHAPE_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <CGAL/number_utils.h>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Ellipse.hxx>
#include <Geom_Line.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopAbs_Orientation.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Dir.hxx>
#include <gp_Lin.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>
#include <gp_XYZ.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// A wireframe in the terms of OpenCASCADE: a compound of closed wires and of single edges.
struct Opencascade_shape
{
  // curves in the order in which they are passed, and whether against their own direction
  typedef std::vector<std::pair<std::size_t, bool>> Path;

  struct Child
  {
    Path path;
    bool is_wire = false; // else a single edge
  };

  TopoDS_Compound compound;
  std::vector<TopoDS_Edge> edges; // of the curves, in their order
  std::vector<Child> children;    // of the compound, in its order
  double size = 0.;               // the diagonal of the box around all control points
  double largest_coordinate = 0.; // of all control points, without sign
  double tolerance = 0.;          // farther apart than this are no two points that should be one
};

// Makes the shape of a wireframe in which nothing is wrong, and which has a curve.
template <class GeomTraits>
class Wireframe_shape_builder
{
  typedef CGAL::Wireframe<GeomTraits> Wireframe;
  typedef CGAL::Wireframe_curve<GeomTraits> Curve;
  typedef Opencascade_shape::Path Path;
  typedef Opencascade_shape::Child Child;

  struct Trimmed_curve
  {
    Handle(Geom_Curve) curve;
    double first = 0., last = 0.;
  };

public:
  Wireframe_shape_builder(const Wireframe& wireframe, const GeomTraits& traits)
    : m_wireframe(wireframe), m_traits(traits)
  {}

  // returns false and says why if a curve is none for OpenCASCADE
  bool build(Opencascade_shape& shape, std::string& error)
  {
    measure(shape);
    shape.tolerance = 1e-9 * shape.size;
    for (const auto& vertex : m_wireframe.vertices)
      m_vertices.push_back(make_vertex(to_point(vertex)));
    for (std::size_t i = 0; i < m_wireframe.curves.size(); ++i)
    {
      error = make_edge(m_wireframe.curves[i], shape);
      if (!error.empty())
      {
        error = "curve " + std::to_string(i) + ": " + error;
        return false;
      }
    }
    shape.children = children();
    m_builder.MakeCompound(shape.compound);
    for (const Child& child : shape.children)
    {
      if (child.is_wire)
        m_builder.Add(shape.compound, make_wire(child.path, shape.edges));
      else
        m_builder.Add(shape.compound, shape.edges[child.path.front().first]);
    }
    return true;
  }

private:
  template <class Position>
  gp_XYZ to_xyz(const Position& position) const
  {
    const Coordinates c = coordinates_of(position, m_traits);
    return gp_XYZ(c[0], c[1], c[2]);
  }

  template <class Point>
  gp_Pnt to_point(const Point& point) const
  {
    return gp_Pnt(to_xyz(point));
  }

  void measure(Opencascade_shape& shape) const
  {
    gp_XYZ low(HUGE_VAL, HUGE_VAL, HUGE_VAL), high = -1. * low;
    const auto add = [&](const gp_XYZ& p) {
      for (int k = 1; k <= 3; ++k)
      {
        low.SetCoord(k, (std::min)(low.Coord(k), p.Coord(k)));
        high.SetCoord(k, (std::max)(high.Coord(k), p.Coord(k)));
        shape.largest_coordinate = (std::max)(shape.largest_coordinate, std::abs(p.Coord(k)));
      }
    };
    for (const Curve& curve : m_wireframe.curves)
      for (const auto& point : curve.spline.control_points())
        add(to_xyz(point));
    shape.size = (high - low).Modulus();
  }

  TopoDS_Vertex make_vertex(const gp_Pnt& point) const
  {
    TopoDS_Vertex vertex;
    m_builder.MakeVertex(vertex, point, Precision::Confusion());
    return vertex;
  }

  std::string make_edge(const Curve& curve, Opencascade_shape& shape) const
  {
    Trimmed_curve trimmed;
    const std::string problem = make_curve(curve, shape.size, trimmed);
    if (!problem.empty())
      return problem;
    const bool has_vertices = curve.source != Curve::no_vertex;
    const TopoDS_Vertex source =
      has_vertices ? m_vertices[curve.source] : make_vertex(trimmed.curve->Value(trimmed.first));
    const TopoDS_Vertex target = has_vertices ? m_vertices[curve.target] : source;
    TopoDS_Edge edge;
    m_builder.MakeEdge(edge, trimmed.curve, Precision::Confusion());
    m_builder.Add(edge, source.Oriented(TopAbs_FORWARD));
    m_builder.Add(edge, target.Oriented(TopAbs_REVERSED));
    m_builder.Range(edge, trimmed.first, trimmed.last);
    cover_gap(source, trimmed.curve->Value(trimmed.first), shape);
    cover_gap(target, trimmed.curve->Value(trimmed.last), shape);
    shape.edges.push_back(edge);
    return "";
  }

  // a vertex is a ball that has to hold the ends of its edges
  void cover_gap(const TopoDS_Vertex& vertex, const gp_Pnt& end, Opencascade_shape& shape) const
  {
    const double gap = 1.001 * BRep_Tool::Pnt(vertex).Distance(end);
    m_builder.UpdateVertex(vertex, gap);
    shape.tolerance = (std::max)(shape.tolerance, gap);
  }

  std::string make_curve(const Curve& curve, double size, Trimmed_curve& trimmed) const
  {
    switch (curve.type)
    {
    case Wireframe_curve_type::BSPLINE: return make_spline(curve, trimmed);
    case Wireframe_curve_type::LINE: return make_line(curve, size, trimmed);
    default: return make_conic(curve, trimmed);
    }
  }

  std::string make_line(const Curve& curve, double size, Trimmed_curve& trimmed) const
  {
    if (curve.is_closed() || curve.source == curve.target)
      return "It is a line, but ends where it starts.";
    const gp_Pnt source = to_point(m_wireframe.vertices[curve.source]);
    const gp_Vec v(source, to_point(m_wireframe.vertices[curve.target]));
    if (!(v.Magnitude() > gp::Resolution()))
      return "It is a line, but its length is zero.";
    const gp_Lin line(source, gp_Dir(v));
    for (const auto& point : curve.spline.control_points())
      if (!(line.Distance(to_point(point)) <= 1e-6 * size))
        return "It is a line, but the control points of its spline are not on one.";
    trimmed.curve = new Geom_Line(line);
    trimmed.last = v.Magnitude();
    return "";
  }

  std::string make_conic(const Curve& curve, Trimmed_curve& trimmed) const
  {
    const auto& conic = *curve.conic;
    const gp_Ax2 axes(to_point(conic.center), gp_Dir(to_xyz(conic.axis)), gp_Dir(to_xyz(conic.major_direction)));
    const double major = CGAL::to_double(conic.major_radius), minor = CGAL::to_double(conic.minor_radius);
    if (curve.type == Wireframe_curve_type::CIRCLE || curve.type == Wireframe_curve_type::ARC)
      trimmed.curve = new Geom_Circle(axes, major);
    else
      trimmed.curve = new Geom_Ellipse(axes, major, minor);
    trimmed.first = CGAL::to_double(conic.start_angle);
    trimmed.last = curve.is_closed() ? trimmed.first + 2. * CGAL_PI
                                     : (std::min)(CGAL::to_double(conic.end_angle), trimmed.first + 2. * CGAL_PI);
    return "";
  }

  std::string make_spline(const Curve& curve, Trimmed_curve& trimmed) const
  {
    const auto& spline = curve.spline;
    if (spline.degree() > std::size_t(Geom_BSplineCurve::MaxDegree()))
      return "Its degree is " + std::to_string(spline.degree()) + "; OpenCASCADE takes "
        + std::to_string(Geom_BSplineCurve::MaxDegree()) + " at most.";
    std::vector<double> knots;
    std::vector<int> multiplicities;
    for (const auto& value : spline.knots())
    {
      const double knot = CGAL::to_double(value);
      if (knots.empty() || knots.back() != knot)
      {
        knots.push_back(knot);
        multiplicities.push_back(0);
      }
      ++multiplicities.back();
    }
    TColgp_Array1OfPnt points(1, int(spline.control_points().size()));
    TColStd_Array1OfReal weights(1, points.Length());
    for (int i = 0; i < points.Length(); ++i)
    {
      points.SetValue(i + 1, to_point(spline.control_points()[std::size_t(i)]));
      weights.SetValue(i + 1, spline.is_rational() ? CGAL::to_double(spline.weights()[std::size_t(i)]) : 1.);
    }
    const TColStd_Array1OfReal knot_array(knots.front(), 1, int(knots.size()));
    const TColStd_Array1OfInteger multiplicity_array(multiplicities.front(), 1, int(knots.size()));
    const int degree = int(spline.degree());
    try
    {
      trimmed.curve = spline.is_rational()
        ? new Geom_BSplineCurve(points, weights, knot_array, multiplicity_array, degree)
        : new Geom_BSplineCurve(points, knot_array, multiplicity_array, degree);
    }
    catch (const Standard_Failure&)
    {
      return "Two of its knots, or weights, are too close to zero or to each other for OpenCASCADE.";
    }
    trimmed.first = knots.front();
    trimmed.last = knots.back();
    return "";
  }

  TopoDS_Wire make_wire(const Path& path, const std::vector<TopoDS_Edge>& edges) const
  {
    TopoDS_Wire wire;
    m_builder.MakeWire(wire);
    for (const auto& step : path)
      m_builder.Add(wire, edges[step.first].Oriented(step.second ? TopAbs_REVERSED : TopAbs_FORWARD));
    wire.Closed(true);
    return wire;
  }

  // Closed loops as a whole, and all other curves one by one.
  std::vector<Child> children() const
  {
    std::vector<std::vector<std::size_t>> curves_at(m_wireframe.vertices.size());
    for (std::size_t i = 0; i < m_wireframe.curves.size(); ++i)
      for (const std::size_t vertex : {m_wireframe.curves[i].source, m_wireframe.curves[i].target})
        if (vertex != Curve::no_vertex)
          curves_at[vertex].push_back(i);
    std::vector<Child> result;
    std::vector<bool> is_done(m_wireframe.curves.size(), false), is_in_no_loop(m_wireframe.curves.size(), false);
    for (std::size_t i = 0; i < m_wireframe.curves.size(); ++i)
    {
      if (is_done[i])
        continue;
      Child child;
      if (!is_in_no_loop[i])
        child.path = loop_from(i, curves_at, is_in_no_loop);
      child.is_wire = !child.path.empty();
      if (!child.is_wire)
        child.path.emplace_back(i, false);
      for (const auto& step : child.path)
        is_done[step.first] = true;
      result.push_back(std::move(child));
    }
    return result;
  }

  // Follows the curves until the first one is there again. Empty where they branch or end; then
  // none of them is in a loop.
  Path loop_from(std::size_t first, const std::vector<std::vector<std::size_t>>& curves_at,
                 std::vector<bool>& is_in_no_loop) const
  {
    Path path(1, std::make_pair(first, false));
    for (;;)
    {
      const Curve& curve = m_wireframe.curves[path.back().first];
      const std::size_t vertex = path.back().second ? curve.source : curve.target;
      if (vertex == Curve::no_vertex)
        return path;
      const std::vector<std::size_t>& curves = curves_at[vertex];
      if (curves.size() != 2)
      {
        for (const auto& step : path)
          is_in_no_loop[step.first] = true;
        return Path();
      }
      const std::size_t next = curves[0] == path.back().first ? curves[1] : curves[0];
      if (next == first)
        return path;
      path.emplace_back(next, m_wireframe.curves[next].source != vertex);
    }
  }

  const Wireframe& m_wireframe;
  const GeomTraits& m_traits;
  BRep_Builder m_builder;
  std::vector<TopoDS_Vertex> m_vertices;
};

// returns false and says why if the wireframe is malformed or OpenCASCADE has no such curve
template <class GeomTraits>
bool make_shape(const CGAL::Wireframe<GeomTraits>& wireframe, const GeomTraits& traits, Opencascade_shape& shape,
                std::string& error)
{
  error = wireframe.is_empty() ? "the wireframe has no curve, and there is nothing to write"
                               : wireframe_problem(wireframe, traits);
  return error.empty() && Wireframe_shape_builder<GeomTraits>(wireframe, traits).build(shape, error);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_OPENCASCADE_SHAPE_H
