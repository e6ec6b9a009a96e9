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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DRAWN_CURVE_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DRAWN_CURVE_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_pieces.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// the least and the largest value along a direction
struct Drawn_range
{
  double low = (std::numeric_limits<double>::infinity)(), high = -low;

  void add(double value)
  {
    low = (std::min)(low, value);
    high = (std::max)(high, value);
  }
};

// A curve in the terms of drawings, whose projections are of the same kinds: a segment, an arc of an ellipse, or cubic
// Bezier curves.
class Drawn_curve
{
public:
  typedef std::array<Spline_vector, 4> Cubic;

  // c + cos(a) u + sin(a) v, of which u and v are any two conjugate half diameters
  struct Arc
  {
    Spline_vector center, u, v;
    double start = 0., sweep = 0.;
    bool is_full = false;

    Spline_vector point(double angle) const { return center + std::cos(angle) * u + std::sin(angle) * v; }
    Spline_vector tangent(double angle) const { return std::cos(angle) * v - std::sin(angle) * u; }
  };

  // `size` is that of the wireframe; positions are relative to `origin`
  Drawn_curve(const Plain_curve& curve, const Spline_vector& origin, double size) : m_kind(curve.type)
  {
    const Plain_traits traits;
    if (m_kind == Wireframe_curve_type::LINE)
      m_ends = {{vector_of(curve.spline.control_points().front(), traits) - origin,
                 vector_of(curve.spline.control_points().back(), traits) - origin}};
    else if (curve.conic)
    {
      const Orthonormal_conic conic = orthonormal_conic(curve, traits);
      m_arc.center = conic.center - origin;
      m_arc.u = conic.major_radius * conic.x;
      m_arc.v = conic.minor_radius * cross(conic.axis, conic.x);
      m_arc.start = conic.start_angle;
      m_arc.sweep = conic.sweep;
      m_arc.is_full = conic.is_full;
    }
    else
      add_cubics(curve.spline, origin, size);
  }

  bool is_segment() const { return m_kind == Wireframe_curve_type::LINE; }
  bool is_arc() const { return !is_segment() && m_cubics.empty(); }

  const std::array<Spline_vector, 2>& ends() const { return m_ends; }
  const Arc& arc() const { return m_arc; }
  const std::vector<Cubic>& cubics() const { return m_cubics; }

  void extend(const Spline_vector& direction, Drawn_range& range) const
  {
    if (is_segment())
      for (const Spline_vector& end : m_ends)
        range.add(dot(end, direction));
    else if (is_arc())
      extend_by_arc(direction, range);
    for (const Cubic& cubic : m_cubics)
      extend_by_cubic(cubic, direction, range);
  }

private:
  typedef CGAL::Wireframe_extraction::internal::Bezier_piece Bezier_piece;
  typedef CGAL::Wireframe_extraction::internal::Weighted_control_point Weighted_control_point;

  // Cubics in place of pieces of another degree, or of rational ones, are as near as this, in sizes of the wireframe.
  static constexpr double tolerance = 1e-8;
  static constexpr int most_halvings = 12; // then a piece is a four thousandth of its span

  void add_cubics(const Plain_spline& spline, const Spline_vector& origin, double size)
  {
    CGAL::Wireframe_extraction::internal::Spline_data data;
    data.degree = spline.degree();
    data.knots = spline.knots();
    data.weights = spline.weights();
    for (const auto& point : spline.control_points())
      data.points.push_back(vector_of(point, Plain_traits()) - origin);
    for (const Bezier_piece& piece : CGAL::Wireframe_extraction::internal::bezier_pieces(data))
      add_piece(piece.points, tolerance * size, most_halvings);
  }

  // Splits the piece until a cubic with its ends and tangents is near enough; one of degree 3 or less is its cubic.
  void add_piece(const std::vector<Weighted_control_point>& piece, double most_error, int halvings)
  {
    std::vector<Weighted_control_point> row = piece, before(1, row.front()), after(1, row.back());
    while (row.size() > 1)
    {
      for (std::size_t i = 0; i + 1 < row.size(); ++i)
        row[i] = CGAL::Wireframe_extraction::internal::interpolate(row[i], row[i + 1], 0.5);
      row.pop_back();
      before.push_back(row.front());
      after.insert(after.begin(), row.back());
    }
    const Cubic cubic = cubic_of(piece);
    const Spline_vector middle = 0.125 * (cubic[0] + 3. * cubic[1] + 3. * cubic[2] + cubic[3]);
    if (halvings == 0 || norm(middle - row.front().point) <= most_error)
    {
      m_cubics.push_back(cubic);
      return;
    }
    add_piece(before, most_error, halvings - 1);
    add_piece(after, most_error, halvings - 1);
  }

  static Cubic cubic_of(const std::vector<Weighted_control_point>& piece)
  {
    const std::size_t n = piece.size() - 1;
    const double third = static_cast<double>(n) / 3.;
    const auto towards = [third](const Weighted_control_point& end, const Weighted_control_point& next) {
      return end.point + (third * next.weight / end.weight) * (next.point - end.point);
    };
    return {{piece[0].point, towards(piece[0], piece[1]), towards(piece[n], piece[n - 1]), piece[n].point}};
  }

  void extend_by_arc(const Spline_vector& direction, Drawn_range& range) const
  {
    const double u = dot(m_arc.u, direction), v = dot(m_arc.v, direction), turn = 2. * CGAL_PI;
    const double peak = std::atan2(v, u);
    for (const double angle : {peak, peak + CGAL_PI})
    {
      const double after_start = angle - m_arc.start - turn * std::floor((angle - m_arc.start) / turn);
      if (m_arc.is_full || after_start <= m_arc.sweep)
        range.add(dot(m_arc.point(angle), direction));
    }
    range.add(dot(m_arc.point(m_arc.start), direction));
    range.add(dot(m_arc.point(m_arc.start + m_arc.sweep), direction));
  }

  static void extend_by_cubic(const Cubic& cubic, const Spline_vector& direction, Drawn_range& range)
  {
    std::array<double, 4> p;
    for (std::size_t i = 0; i < 4; ++i)
      p[i] = dot(cubic[i], direction);
    // a third of the derivative is a t^2 + 2 b t + c
    const double a = p[3] - 3. * p[2] + 3. * p[1] - p[0], b = p[2] - 2. * p[1] + p[0], c = p[1] - p[0];
    const double root = std::sqrt((std::max)(b * b - a * c, 0.)), q = -(b + (b < 0. ? -root : root));
    const std::array<double, 4> places = {{0., 1., a != 0. ? q / a : 0., q != 0. ? c / q : 0.}};
    for (const double t : places)
      if (t >= 0. && t <= 1.)
      {
        const double s = 1. - t;
        range.add(s * s * s * p[0] + 3. * s * s * t * p[1] + 3. * s * t * t * p[2] + t * t * t * p[3]);
      }
  }

  Wireframe_curve_type m_kind;
  std::array<Spline_vector, 2> m_ends;
  Arc m_arc;
  std::vector<Cubic> m_cubics;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_DRAWN_CURVE_H
