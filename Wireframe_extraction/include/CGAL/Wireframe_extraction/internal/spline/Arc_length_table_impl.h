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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_ARC_LENGTH_TABLE_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_ARC_LENGTH_TABLE_IMPL_H

#include <CGAL/Wireframe_extraction/internal/spline/Arc_length_table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE Arc_length_table::Arc_length_table(const Spline_data& spline, double u0, double u1)
  : m_spline(spline), m_begin(u0), m_end(u1)
{
  if (!(u0 < u1))
    return;

  std::vector<Interval> pieces;
  double estimate = 0.;
  const std::size_t last_span = find_span(spline.knots, spline.degree, u1);
  for (std::size_t s = find_span(spline.knots, spline.degree, u0); s <= last_span; ++s)
  {
    const double begin = (std::max)(u0, spline.knots[s]);
    const double end = (std::min)(u1, spline.knots[s + 1]);
    if (!(begin < end))
      continue;
    pieces.push_back(Interval{begin, end, s, 0., integrate(s, begin, end)});
    estimate += pieces.back().length;
  }
  for (const Interval& piece : pieces)
    subdivide(piece, relative_tolerance * estimate, maximum_depth);
}

CGAL_WIREFRAME_EXTRACTION_INLINE double Arc_length_table::parameter(double s) const
{
  if (!(s > 0.) || m_intervals.empty())
    return m_begin;
  if (s >= m_length)
    return m_end;
  const auto after =
    std::upper_bound(m_intervals.begin(), m_intervals.end(), s,
                     [](double value, const Interval& interval) { return value < interval.length_before; });
  return parameter_in(*(after - 1), s - (after - 1)->length_before);
}

CGAL_WIREFRAME_EXTRACTION_INLINE double Arc_length_table::integrate(std::size_t span, double begin, double end) const
{
  // The quadrature of Gauss with 15 nodes, 0 and those to both sides of it. Boost has it, in a header that takes longer
  // to compile than all else here.
  static constexpr double middle_weight = 0.202578241925561273;
  static constexpr std::array<double, 7> nodes = {{0.201194093997434522, 0.394151347077563370, 0.570972172608538848,
                                                   0.724417731360170047, 0.848206583410427216, 0.937273392400705904,
                                                   0.987992518020485428}};
  static constexpr std::array<double, 7> weights = {{0.198431485327111576, 0.186161000015562211, 0.166269205816993934,
                                                     0.139570677926154314, 0.107159220467171935, 0.0703660474881081247,
                                                     0.0307532419961172684}};
  const double middle = (begin + end) * 0.5, half = (end - begin) * 0.5;
  double sum = speed_on_span(m_spline, span, middle) * middle_weight;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    sum += (speed_on_span(m_spline, span, middle + half * nodes[i])
            + speed_on_span(m_spline, span, middle - half * nodes[i]))
      * weights[i];
  return half * sum;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Arc_length_table::subdivide(const Interval& interval, double tolerance, int depth)
{
  const double middle = interval.begin + (interval.end - interval.begin) / 2.;
  const double left = integrate(interval.span, interval.begin, middle);
  const double right = integrate(interval.span, middle, interval.end);
  if (depth == 0 || !(std::abs(left + right - interval.length) > tolerance))
  {
    // both halves are kept: they are at hand, and more accurate than the whole
    append(Interval{interval.begin, middle, interval.span, 0., left});
    append(Interval{middle, interval.end, interval.span, 0., right});
    return;
  }
  subdivide(Interval{interval.begin, middle, interval.span, 0., left}, tolerance, depth - 1);
  subdivide(Interval{middle, interval.end, interval.span, 0., right}, tolerance, depth - 1);
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Arc_length_table::append(Interval interval)
{
  interval.length_before = m_length;
  m_length += interval.length;
  m_intervals.push_back(interval);
}

CGAL_WIREFRAME_EXTRACTION_INLINE double Arc_length_table::parameter_in(const Interval& interval, double s) const
{
  double low = interval.begin, high = interval.end;
  double u = low + (high - low) * (std::min)(1., s / interval.length);
  double length = integrate(interval.span, low, u);
  for (int i = 1; i < 100 && std::abs(length - s) > 1e-14 * m_length; ++i)
  {
    (length < s ? low : high) = u;
    double next = u + (s - length) / speed_on_span(m_spline, interval.span, u);
    if (!(next > low && next < high) || i % 4 == 0)
      next = low + (high - low) / 2.;
    if (!(next > low && next < high))
      break;
    length += integrate(interval.span, u, next);
    u = next;
  }
  return u;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_ARC_LENGTH_TABLE_IMPL_H
