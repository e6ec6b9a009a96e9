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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_WIREFRAME_CHECK_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_WIREFRAME_CHECK_H

#include <CGAL/Wireframe_extraction/Wireframe_conic.h>
#include <CGAL/Wireframe_extraction/Wireframe_curve_type.h>
#include <CGAL/Wireframe_extraction/internal/base/coordinates.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL {

template <class GeomTraits>
struct Wireframe;
template <class GeomTraits>
struct Wireframe_curve;

namespace Wireframe_extraction {
namespace internal {

// Finds what is wrong with a wireframe.
template <class GeomTraits>
class Wireframe_check
{
public:
  typedef CGAL::Wireframe<GeomTraits> Wireframe;
  typedef CGAL::Wireframe_curve<GeomTraits> Curve;

  Wireframe_check(const Wireframe& wireframe, const GeomTraits& traits) : m_wireframe(wireframe), m_traits(traits) {}

  // the first problem; empty if there is none
  std::string operator()() const
  {
    const double sampling_distance = CGAL::to_double(m_wireframe.sampling_distance);
    if (!is_measure(sampling_distance))
      return "the sampling distance is " + IO::internal::number_to_string(sampling_distance)
        + "; it has to be finite and not negative";
    for (std::size_t i = 0; i < m_wireframe.vertices.size(); ++i)
      if (!is_finite_point(coordinates_of(m_wireframe.vertices[i], m_traits)))
        return "vertex " + std::to_string(i) + " has a coordinate that is not finite";
    for (std::size_t i = 0; i < m_wireframe.curves.size(); ++i)
    {
      const std::string problem = curve_problem(m_wireframe.curves[i]);
      if (!problem.empty())
        return "curve " + std::to_string(i) + ": " + problem;
    }
    return "";
  }

private:
  // Places, in sizes of the curve, and directions and angles may be off by the digits that a file or a number type of
  // single precision loses, not by more.
  static constexpr double tolerance_of_files = 1e-6;

  static bool is_measure(double value) { return std::isfinite(value) && value >= 0.; }

  std::string curve_problem(const Curve& curve) const
  {
    if (!is_measure(CGAL::to_double(curve.rms)) || !is_measure(CGAL::to_double(curve.max)))
      return "A residual is not finite or is negative.";
    std::string problem = spline_problem(curve);
    if (problem.empty())
      problem = vertices_problem(curve);
    if (problem.empty())
      problem = ends_problem(curve);
    return problem.empty() ? type_problem(curve) : problem;
  }

  // A line and a conic have parameters beside the spline, and both must say the same.
  std::string type_problem(const Curve& curve) const
  {
    const auto& u = curve.uncertainty;
    for (const auto& value : {u.position, u.direction, u.major_radius, u.minor_radius})
      if (!is_measure(CGAL::to_double(value)))
        return "An uncertainty is not finite or is negative.";
    if (is_conic(curve.type) != bool(curve.conic))
      return "It is of type " + to_string(curve.type) + (curve.conic ? ", but has" : ", but does not have")
        + " a conic.";
    if (!curve.conic)
      return "";
    std::string problem = conic_problem(*curve.conic);
    if (problem.empty())
      problem = kind_problem(curve);
    return problem.empty() ? conic_ends_problem(curve) : problem;
  }

  std::string kind_problem(const Curve& curve) const
  {
    typedef Wireframe_curve_type Type;
    const bool is_full = curve.type == Type::CIRCLE || curve.type == Type::ELLIPSE;
    if (is_full != curve.is_closed())
      return is_full ? "It is a full circle or ellipse, but not closed." : "It is an arc, but closed.";
    const bool is_round = curve.type == Type::CIRCLE || curve.type == Type::ARC;
    const double major = CGAL::to_double(curve.conic->major_radius);
    if (is_round && std::abs(major - CGAL::to_double(curve.conic->minor_radius)) > 1e-9 * major)
      return "It is a circle, but its radii differ.";
    return "";
  }

  std::string conic_problem(const Wireframe_conic<GeomTraits>& conic) const
  {
    const Coordinates axis = coordinates_of(conic.axis, m_traits);
    const Coordinates direction = coordinates_of(conic.major_direction, m_traits);
    const double major = CGAL::to_double(conic.major_radius), minor = CGAL::to_double(conic.minor_radius);
    const double sweep = CGAL::to_double(conic.end_angle) - CGAL::to_double(conic.start_angle);
    if (!is_finite_point(coordinates_of(conic.center, m_traits)) || !is_finite_point(axis)
        || !is_finite_point(direction) || !std::isfinite(major) || !std::isfinite(sweep))
      return "Its center, axis, major direction, radii or angles are not finite.";
    if (!(std::abs(dot(axis, axis) - 1.) < tolerance_of_files)
        || !(std::abs(dot(direction, direction) - 1.) < tolerance_of_files)
        || !(std::abs(dot(axis, direction)) < tolerance_of_files))
      return "Its axis and its major direction have to be unit vectors that are orthogonal.";
    if (!(minor > 0.) || !(major >= minor))
      return "Its radii have to be positive, the major one first.";
    if (!(sweep > 0.) || !(sweep <= 2. * CGAL_PI + tolerance_of_files))
      return "Its end angle has to be larger than its start angle, by a full turn at most.";
    return "";
  }

  std::string conic_ends_problem(const Curve& curve) const
  {
    const double tolerance = tolerance_of_files * size_of(curve);
    const auto& points = curve.spline.control_points();
    const Coordinates start = coordinates_of(curve.conic->point(curve.conic->start_angle, m_traits), m_traits);
    const Coordinates end = coordinates_of(curve.conic->point(curve.conic->end_angle, m_traits), m_traits);
    if (!are_close(start, coordinates_of(points.front(), m_traits), tolerance)
        || !are_close(end, coordinates_of(points.back(), m_traits), tolerance))
      return "Its center, radii and angles do not lead to the ends of its spline.";
    return "";
  }

  static double dot(const Coordinates& p, const Coordinates& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

  double size_of(const Curve& curve) const
  {
    double size = 0.;
    for (const auto& point : curve.spline.control_points())
      for (const double coordinate : coordinates_of(point, m_traits))
        size = (std::max)(size, std::abs(coordinate));
    return size;
  }

  std::string spline_problem(const Curve& curve) const
  {
    const auto& spline = curve.spline;
    std::string why;
    if (!Curve::Spline::is_valid(spline.degree(), spline.knots(), spline.control_points(), spline.weights(), &why,
                                 m_traits))
      return why;
    const auto& knots = spline.knots();
    if (knots[spline.degree()] != knots.front() || knots[spline.control_points().size()] != knots.back())
      return "The knots are not clamped: the first and the last have to be there " + std::to_string(spline.degree() + 1)
        + " times.";
    return "";
  }

  std::string vertices_problem(const Curve& curve) const
  {
    for (const std::size_t vertex : {curve.source, curve.target})
      if (vertex != Curve::no_vertex && vertex >= m_wireframe.vertices.size())
        return "Its vertex " + std::to_string(vertex) + " does not exist; there are "
          + std::to_string(m_wireframe.vertices.size()) + " vertices.";
    if (curve.is_closed() && curve.source != curve.target)
      return "It is closed, but its source and its target differ.";
    if (!curve.is_closed() && (curve.source == Curve::no_vertex || curve.target == Curve::no_vertex))
      return "It is open and has no source or no target; only a closed curve may be without vertex.";
    return "";
  }

  std::string ends_problem(const Curve& curve) const
  {
    const double size = size_of(curve);
    const Coordinates first = coordinates_of(curve.spline.control_points().front(), m_traits);
    const Coordinates last = coordinates_of(curve.spline.control_points().back(), m_traits);
    if (curve.is_closed() && !are_close(first, last, tolerance_of_files * size))
      return "It is closed, but does not end where it starts.";
    if (curve.source != Curve::no_vertex
        && !are_close(first, coordinates_of(m_wireframe.vertices[curve.source], m_traits), tolerance_of_files * size))
      return "It does not start at its source, vertex " + std::to_string(curve.source) + ".";
    if (curve.target != Curve::no_vertex
        && !are_close(last, coordinates_of(m_wireframe.vertices[curve.target], m_traits), tolerance_of_files * size))
      return "It does not end at its target, vertex " + std::to_string(curve.target) + ".";
    return "";
  }

  static bool are_close(const Coordinates& p, const Coordinates& q, double tolerance)
  {
    return std::abs(p[0] - q[0]) <= tolerance && std::abs(p[1] - q[1]) <= tolerance
      && std::abs(p[2] - q[2]) <= tolerance;
  }

  const Wireframe& m_wireframe;
  const GeomTraits& m_traits;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_WIREFRAME_CHECK_H
