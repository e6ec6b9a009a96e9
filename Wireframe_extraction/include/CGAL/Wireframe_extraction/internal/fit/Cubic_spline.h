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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CUBIC_SPLINE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CUBIC_SPLINE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_pieces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A cubic spline over breakpoints, clamped or periodic, whose control points an optimizer may move.
class Cubic_spline
{
  // Newton's steps for feet: from a parameter that is close, five reach rounding errors; where the second derivative of
  // the squared distance falls below this share of the first one's part, the center of curvature is near.
  static constexpr int most_steps = 5;
  static constexpr double least_slope = 0.3;
  static constexpr double foot_precision = 1e-10; // of the length
  // Weights of least squares, where a position counts 1: of the ends, which are set exactly afterwards; of bends where
  // there is no data; of what is determined by neither.
  static constexpr double end_weight = 1e6, bend_weight = 1e-6, regularization = 1e-12;

  bool m_is_periodic = false;
  std::vector<double> m_breaks; // strictly increasing
  std::vector<double> m_knots;  // periodic: the breakpoints go on beyond both ends
  std::vector<Vector> m_points;

public:
  struct Basis
  {
    std::array<std::size_t, 4> controls;
    std::array<double, 12> values; // of the basis functions, then of their first and second derivatives
  };

  Cubic_spline() {}

  // A periodic spline needs at least four spans, so that the four control points of a span differ.
  Cubic_spline(std::vector<double> breaks, bool is_periodic) : m_is_periodic(is_periodic), m_breaks(std::move(breaks))
  {
    const std::size_t spans = m_breaks.size() - 1;
    if (!m_is_periodic)
    {
      m_knots.assign(3, m_breaks.front());
      m_knots.insert(m_knots.end(), m_breaks.begin(), m_breaks.end());
      m_knots.insert(m_knots.end(), 3, m_breaks.back());
      m_points.assign(spans + 3, Vector::Zero());
      return;
    }
    const double period = m_breaks.back() - m_breaks.front();
    for (std::size_t k = 0; k < 3; ++k)
      m_knots.push_back(m_breaks[spans - 3 + k] - period);
    m_knots.insert(m_knots.end(), m_breaks.begin(), m_breaks.end());
    for (std::size_t k = 1; k <= 3; ++k)
      m_knots.push_back(m_breaks[k] + period);
    m_points.assign(spans, Vector::Zero());
  }

  bool is_periodic() const { return m_is_periodic; }
  const std::vector<double>& breaks() const { return m_breaks; }
  std::vector<Vector>& points() { return m_points; }
  const std::vector<Vector>& points() const { return m_points; }
  double front() const { return m_breaks.front(); }
  double back() const { return m_breaks.back(); }

  double bring_into_range(double u) const
  {
    if (m_is_periodic)
    {
      const double period = back() - front();
      u -= period * std::floor((u - front()) / period);
    }
    return (std::min)(back(), (std::max)(front(), u));
  }

  // the index of the span that holds u
  std::size_t span(double u) const
  {
    const auto it = std::upper_bound(m_breaks.begin() + 1, m_breaks.end() - 1, u);
    return it - m_breaks.begin() - 1;
  }

  Basis basis(double u) const
  {
    Basis result;
    const std::size_t s = span(u);
    basis_functions(s + 3, u, 3, m_knots, 2, result.values.data());
    for (std::size_t j = 0; j < 4; ++j)
      result.controls[j] = m_is_periodic ? (s + j) % m_points.size() : s + j;
    return result;
  }

  Vector combine(const Basis& basis, int derivative = 0) const
  {
    Vector p = Vector::Zero();
    for (std::size_t j = 0; j < 4; ++j)
      p += basis.values[4 * derivative + j] * m_points[basis.controls[j]];
    return p;
  }

  Vector at(double u) const { return combine(basis(u)); }

  // Parameters from end to end, evenly spaced: so many steps for each unit of the parameter, and `least` at least.
  std::vector<double> even_parameters(double steps_per_unit, std::size_t least) const
  {
    const double length = back() - front();
    const std::size_t count = (std::max)(least, static_cast<std::size_t>(steps_per_unit * length));
    std::vector<double> result;
    for (std::size_t k = 0; k <= count; ++k)
      result.push_back(front() + length * double(k) / double(count));
    return result;
  }

  // Newton steps from a parameter that is close
  double foot(const Vector& p, double u) const
  {
    Basis b = basis(u);
    Vector offset = combine(b) - p;
    double best = u, best_distance = offset.squaredNorm();
    for (int k = 0; k < most_steps; ++k)
    {
      const Vector d1 = combine(b, 1), d2 = combine(b, 2);
      double slope = d1.squaredNorm() + offset.dot(d2);
      if (!(slope > least_slope * d1.squaredNorm()))
        slope = d1.squaredNorm(); // Gauss-Newton near centers of curvature
      if (!(slope > 0.))
        break;
      const double next = bring_into_range(u - offset.dot(d1) / slope);
      if (std::abs(next - u) < foot_precision * (back() - front()))
        break;
      b = basis(next);
      offset = combine(b) - p;
      if (offset.squaredNorm() < best_distance)
      {
        best = next;
        best_distance = offset.squaredNorm();
      }
      u = next;
    }
    return best;
  }

  // least squares through positions at parameters; the ends of a clamped spline are fixed
  void interpolate(const std::vector<double>& parameters, const std::vector<Vector>& positions);

  // the clamped form
  Spline_data to_data() const
  {
    Spline_data data;
    data.degree = 3;
    data.knots = m_knots;
    const std::size_t count = m_knots.size() - 4;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector& p = m_points[i % m_points.size()];
      data.points.push_back(Spline_vector{p.x(), p.y(), p.z()});
    }
    if (!m_is_periodic)
      return data;
    Spline_data clamped = clamped_part(data, front(), back());
    clamped.points.back() = clamped.points.front();
    return clamped;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/fit/Cubic_spline_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CUBIC_SPLINE_H
