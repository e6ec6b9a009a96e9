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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_TYPED_CURVE_MAKER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_TYPED_CURVE_MAKER_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/fit/Cubic_spline.h>
#include <CGAL/Wireframe_extraction/internal/fit/to_spline.h>
#include <CGAL/Wireframe_extraction/internal/types/Typed_piece.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Makes the curves of a wireframe from the pieces that were recognized, in the cloud's coordinates.
template <class GeomTraits>
class Typed_curve_maker
{
  typedef typename GeomTraits::FT FT;
  typedef typename GeomTraits::Point_3 Point_3;
  typedef Wireframe_curve<GeomTraits> Curve;
  typedef Spline_curve_3<GeomTraits> Spline;

  const Wireframe_skeleton<GeomTraits>& m_skeleton;
  const std::vector<Vector>& m_vertices;
  const std::vector<Point_3>& m_points;

public:
  // `vertices` in units of the sampling distance, `points` the same in the cloud's coordinates
  Typed_curve_maker(const Wireframe_skeleton<GeomTraits>& skeleton, const std::vector<Vector>& vertices,
                    const std::vector<Point_3>& points)
    : m_skeleton(skeleton), m_vertices(vertices), m_points(points)
  {}

  // `whole` is the curve that the piece was cut from
  Curve make(const Typed_piece& piece, const Curve& whole, const std::vector<Vector>& polyline) const
  {
    Curve curve;
    const bool is_untouched = !piece.is_primitive && piece.is_whole;
    if (is_untouched)
    {
      curve = whole;
      adapt_ends(piece, curve);
    }
    else
    {
      curve.rms = length(piece.root_mean_square);
      curve.max = length(piece.maximum_deviation);
      curve.support = piece.support;
      if (!piece.is_primitive)
        curve.spline = to_spline(part(piece, polyline), piece.vertices[0] == piece.vertices[1], m_skeleton);
      else if (piece.shape.kind == Primitive_kind::LINE)
        make_line(piece, curve);
      else
        make_conic(piece, polyline, curve);
    }
    if (piece.is_type_uncertain)
      curve.doubts.insert(Wireframe_doubt::UNCERTAIN_TYPE);
    curve.source = piece.vertices[0];
    curve.target = piece.vertices[1];
    return curve;
  }

private:
  FT length(double value) const { return FT(value * m_skeleton.data().unit); }

  typename GeomTraits::Vector_3 direction(const Vector& v) const
  {
    return m_skeleton.traits().construct_vector_3_object()(FT(v.x()), FT(v.y()), FT(v.z()));
  }

  // the control points follow the vertices, the less the farther away they are
  void adapt_ends(const Typed_piece& piece, Curve& curve) const
  {
    if (piece.vertices[0] == Typed_piece::no_vertex)
      return;
    const Spline& spline = curve.spline;
    std::vector<Point_3> points = spline.control_points();
    const std::size_t n = points.size();
    const Vector first = m_vertices[piece.vertices[0]] - m_skeleton.to_local(points.front());
    const Vector last = m_vertices[piece.vertices[1]] - m_skeleton.to_local(points.back());
    if (first.isZero(0.) && last.isZero(0.))
      return;
    for (std::size_t i = 1; i + 1 < n; ++i)
    {
      const double share = double(i) / double(n - 1);
      points[i] = m_skeleton.to_point(m_skeleton.to_local(points[i]) + (1. - share) * first + share * last);
    }
    points.front() = m_points[piece.vertices[0]];
    points.back() = m_points[piece.vertices[1]];
    curve.spline = with_points(spline, std::move(points));
  }

  Spline with_points(const Spline& spline, std::vector<Point_3> points) const
  {
    if (spline.is_rational())
      return Spline(spline.degree(), spline.knots(), std::move(points), spline.weights(), spline.is_closed(),
                    m_skeleton.traits());
    return Spline(spline.degree(), spline.knots(), std::move(points), spline.is_closed(), m_skeleton.traits());
  }

  // Of the splines between cuts: spans are of about the length that fits of splines start with, and there are some
  // places to interpolate in each.
  static constexpr double span_length = 3., places_per_length = 4.; // r, and per r
  static constexpr std::size_t least_spans = 3, least_places = 16;

  // a spline along a part of the polyline, from vertex to vertex
  Cubic_spline part(const Typed_piece& piece, const std::vector<Vector>& polyline) const
  {
    const std::vector<double> lengths = arc_lengths(polyline);
    const double begin = piece.range[0], size = piece.range[1] - begin;
    const std::size_t count = (std::max)(+least_places, std::size_t(std::ceil(places_per_length * size)));
    std::vector<double> parameters;
    std::vector<Vector> positions;
    for (std::size_t i = 0; i <= count; ++i)
    {
      parameters.push_back(size * double(i) / double(count));
      positions.push_back(at(polyline, lengths, begin + parameters.back()));
    }
    const Vector first = m_vertices[piece.vertices[0]] - positions.front();
    const Vector last = m_vertices[piece.vertices[1]] - positions.back();
    for (std::size_t i = 0; i <= count; ++i)
    {
      const double share = double(i) / double(count);
      positions[i] += (1. - share) * first + share * last;
    }
    const std::size_t spans = (std::max)(+least_spans, std::size_t(std::ceil(size / span_length)));
    std::vector<double> breaks;
    for (std::size_t i = 0; i <= spans; ++i)
      breaks.push_back(size * double(i) / double(spans));
    Cubic_spline spline(breaks, false);
    spline.interpolate(parameters, positions);
    std::vector<Vector>& controls = spline.points();
    controls.front() = m_vertices[piece.vertices[0]];
    controls.back() = m_vertices[piece.vertices[1]];
    const std::size_t n = controls.size();
    if (!piece.end_tangents[0].isZero(0.))
      controls[1] = controls[0] + (controls[1] - controls[0]).norm() * piece.end_tangents[0];
    if (!piece.end_tangents[1].isZero(0.))
      controls[n - 2] = controls[n - 1] - (controls[n - 2] - controls[n - 1]).norm() * piece.end_tangents[1];
    return spline;
  }

  static Vector at(const std::vector<Vector>& polyline, const std::vector<double>& lengths, double s)
  {
    if (s > lengths.back() && polyline.front() == polyline.back())
      s -= lengths.back();
    const std::size_t k = std::size_t(
      (std::min)(std::max<std::ptrdiff_t>(1, std::upper_bound(lengths.begin(), lengths.end(), s) - lengths.begin()),
                 std::ptrdiff_t(lengths.size()) - 1));
    const double t = (s - lengths[k - 1]) / (std::max)(1e-30, lengths[k] - lengths[k - 1]);
    return polyline[k - 1] + (std::min)(1., (std::max)(0., t)) * (polyline[k] - polyline[k - 1]);
  }

  void make_line(const Typed_piece& piece, Curve& curve) const
  {
    const Vector &a = m_vertices[piece.vertices[0]], &b = m_vertices[piece.vertices[1]];
    curve.type = Wireframe_curve_type::LINE;
    const FT end = length((b - a).norm());
    curve.spline = Spline(1, {FT(0), FT(0), end, end}, {m_points[piece.vertices[0]], m_points[piece.vertices[1]]},
                          false, m_skeleton.traits());
    curve.uncertainty.position = length(piece.position_deviation);
    curve.uncertainty.direction = FT(piece.direction_deviation);
  }

  void make_conic(const Typed_piece& piece, const std::vector<Vector>& polyline, Curve& curve) const
  {
    const bool is_circle = piece.shape.kind == Primitive_kind::CIRCLE,
               has_vertex = piece.vertices[0] != Typed_piece::no_vertex;
    const bool is_closed = piece.vertices[0] == piece.vertices[1];
    curve.type = is_closed ? (is_circle ? Wireframe_curve_type::CIRCLE : Wireframe_curve_type::ELLIPSE)
                           : (is_circle ? Wireframe_curve_type::ARC : Wireframe_curve_type::ELLIPTIC_ARC);
    Primitive_curve shape = piece.shape;
    const Vector start = has_vertex ? m_vertices[piece.vertices[0]] : shape.foot(polyline.front());
    const Vector end = has_vertex ? m_vertices[piece.vertices[1]] : start;
    const std::vector<double> lengths = arc_lengths(polyline);
    const Vector middle = is_closed ? at(polyline, lengths, piece.range[0] + 0.25 * lengths.back()) : piece.middle;
    double begin = shape.parameter(start), sweep = 2. * CGAL_PI;
    const double through_middle =
      is_closed ? shape.step(begin, shape.parameter(middle)) : shape.sweep(begin, middle, shape.parameter(end));
    if (!is_closed)
      sweep = std::abs(through_middle);
    if (through_middle < 0.)
    {
      // it runs clockwise
      shape.axis = -shape.axis;
      begin = -begin;
    }
    if (is_circle)
    {
      shape.major = (start - shape.center - (start - shape.center).dot(shape.axis) * shape.axis).normalized();
      begin = 0.;
    }
    Wireframe_conic<GeomTraits>& conic = curve.conic.emplace();
    conic.center = m_skeleton.to_point(shape.center);
    conic.axis = direction(shape.axis);
    conic.major_direction = direction(shape.major);
    conic.major_radius = length(shape.major_radius);
    conic.minor_radius = length(shape.minor_radius);
    conic.start_angle = FT(begin);
    conic.end_angle = FT(begin + sweep);
    curve.spline = conic.to_spline(is_closed, m_skeleton.traits());
    if (has_vertex)
    {
      std::vector<Point_3> points = curve.spline.control_points();
      points.front() = m_points[piece.vertices[0]];
      points.back() = m_points[piece.vertices[1]];
      curve.spline = with_points(curve.spline, std::move(points));
    }
    curve.uncertainty.position = length(piece.position_deviation);
    curve.uncertainty.direction = FT(piece.direction_deviation);
    curve.uncertainty.major_radius = length(piece.major_radius_deviation);
    curve.uncertainty.minor_radius = length(piece.minor_radius_deviation);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_TYPED_CURVE_MAKER_H
