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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PROJECTOR_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PROJECTOR_IMPL_H

#include <CGAL/Wireframe_extraction/internal/spline/Spline_projector.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

inline double distance_to_segment(const Spline_vector& p, const Spline_vector& a, const Spline_vector& b)
{
  const Spline_vector ab = b - a;
  const double t = dot(p - a, ab) / dot(ab, ab);
  if (!(t > 0.))
    return norm(p - a);
  return t < 1. ? norm(p - (a + t * ab)) : norm(p - b);
}

CGAL_WIREFRAME_EXTRACTION_INLINE Spline_projector::Spline_projector(const Spline_data& spline)
  : m_spline(spline), m_pieces(bezier_pieces(spline)), m_binomials(1, 1.), m_binomials_of_degree(1, 1.)
{
  const double degree = double(spline.degree);
  for (double k = 1.; k < degree; k += 1.)
    m_binomials.push_back(m_binomials.back() * (degree - k) / k);
  for (double k = 1.; k <= degree; k += 1.)
    m_binomials_of_degree.push_back(m_binomials_of_degree.back() * (degree - k + 1.) / k);
}

CGAL_WIREFRAME_EXTRACTION_INLINE Spline_projector::Result Spline_projector::operator()(const Spline_vector& query) const
{
  Result best{m_pieces.back().end, norm(m_pieces.back().points.back().point - query)};
  boost::container::small_vector<Box, 32> boxes;
  for (std::size_t i = m_pieces.size(); i-- > 0;)
  {
    consider(m_pieces[i].begin, m_pieces[i].points.front().point, query, best);
    boxes.push_back(Box{lower_bound(m_pieces[i].points.data(), query), i});
  }
  std::sort(boxes.begin(), boxes.end(),
            [](const Box& a, const Box& b) { return a.bound < b.bound || (a.bound == b.bound && a.piece < b.piece); });

  Stack stack((maximum_depth + 1) * 2 * (m_spline.degree + 1));
  for (const Box& box : boxes)
  {
    const Bezier_piece& piece = m_pieces[box.piece];
    if (box.bound >= best.distance)
      break;
    std::size_t splits = 0;
    search(piece.points.data(), piece.span, piece.begin, piece.end, stack.data(), 0, splits, query, best);
  }
  return best;
}

CGAL_WIREFRAME_EXTRACTION_INLINE double Spline_projector::lower_bound(const Weighted_control_point* points,
                                                                      const Spline_vector& query) const
{
  const Spline_vector& a = points[0].point;
  const Spline_vector& b = points[m_spline.degree].point;
  double deviation = 0.;
  for (std::size_t i = 1; i < m_spline.degree; ++i)
    deviation = (std::max)(deviation, distance_to_segment(points[i].point, a, b));
  return distance_to_segment(query, a, b) - deviation;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Spline_projector::consider(double u, const Spline_vector& point,
                                                                 const Spline_vector& query, Result& best)
{
  const double distance = norm(point - query);
  if (distance < best.distance || (distance == best.distance && u < best.parameter))
    best = Result{u, distance};
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Spline_projector::search(const Weighted_control_point* points, std::size_t span,
                                                               double begin, double end, Weighted_control_point* stack,
                                                               std::size_t depth, std::size_t& splits,
                                                               const Spline_vector& query, Result& best) const
{
  if (lower_bound(points, query) >= best.distance)
    return;
  const Slope slope = slope_of_distance(points, query);
  const bool is_last = depth == maximum_depth || splits == maximum_number_of_splits;
  if (slope == Slope::RISES_FROM_A_FALL_ONCE || (slope == Slope::UNKNOWN && is_last))
    refine(span, begin, end, query, best);
  if (slope != Slope::UNKNOWN || is_last)
    return;
  ++splits;

  const double middle = begin + (end - begin) / 2.;
  const std::size_t degree = m_spline.degree;
  Weighted_control_point* left = stack;
  Weighted_control_point* right = stack + degree + 1;
  Weighted_control_point* rest = right + degree + 1;
  std::copy(points, points + degree + 1, right);
  left[0] = right[0];
  for (std::size_t round = 1; round <= degree; ++round)
  {
    for (std::size_t j = 0; j + round <= degree; ++j)
      right[j] = interpolate(right[j], right[j + 1], 0.5);
    left[round] = right[0];
  }

  consider(middle, right[0].point, query, best);
  const bool is_left_first = lower_bound(left, query) <= lower_bound(right, query);
  if (is_left_first)
    search(left, span, begin, middle, rest, depth + 1, splits, query, best);
  search(right, span, middle, end, rest, depth + 1, splits, query, best);
  if (!is_left_first)
    search(left, span, begin, middle, rest, depth + 1, splits, query, best);
}

CGAL_WIREFRAME_EXTRACTION_INLINE Spline_projector::Slope Spline_projector::slope_of_distance(
  const Weighted_control_point* points, const Spline_vector& query) const
{
  const std::size_t degree = m_spline.degree;
  const bool is_rational = !m_spline.weights.empty();
  Vectors a(degree + 1);
  for (std::size_t i = 0; i <= degree; ++i)
    a[i] = points[i].weight * (points[i].point - query);

  // scaled Bernstein coefficients, that is, with the binomials, multiply like those of the power basis
  Vectors b(is_rational ? 2 * degree : degree);
  double largest_a = 0., largest_b = 0.; // b before its terms cancel each other
  for (std::size_t i = 0; i < degree; ++i)
  {
    const Spline_vector da = m_binomials[i] * (a[i + 1] - a[i]);
    if (!is_rational)
    {
      b[i] = da;
      largest_b = (std::max)(largest_b, norm(da));
      continue;
    }
    const double dw = m_binomials[i] * (points[i + 1].weight - points[i].weight);
    for (std::size_t j = 0; j <= degree; ++j)
    {
      const double binomial = m_binomials_of_degree[j];
      b[i + j] = b[i + j] + binomial * (points[j].weight * da - dw * a[j]);
      largest_b = (std::max)(largest_b, binomial * points[j].weight * norm(da));
      largest_b = (std::max)(largest_b, binomial * std::abs(dw) * norm(a[j]));
    }
  }
  for (std::size_t i = 0; i <= degree; ++i)
  {
    a[i] = m_binomials_of_degree[i] * a[i];
    largest_a = (std::max)(largest_a, norm(a[i]));
  }

  Coefficients slope(a.size() + b.size() - 1, 0.);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      slope[i + j] += dot(a[i], b[j]);
  // what is rounding is no sign: on a circle around the query the slope is nothing else
  return classify(slope, 1e-15 * double(slope.size()) * largest_a * largest_b);
}

CGAL_WIREFRAME_EXTRACTION_INLINE Spline_projector::Slope Spline_projector::classify(const Coefficients& slope,
                                                                                    double rounding)
{
  int number_of_changes = 0;
  bool is_first_known = false, is_first_negative = false, is_negative = false;
  for (const double coefficient : slope)
  {
    if (!(std::abs(coefficient) > rounding))
      continue;
    if (!is_first_known)
      is_first_negative = coefficient < 0.;
    else if ((coefficient < 0.) != is_negative)
      ++number_of_changes;
    is_first_known = true;
    is_negative = coefficient < 0.;
  }
  if (number_of_changes > 1)
    return Slope::UNKNOWN;
  return number_of_changes == 1 && is_first_negative ? Slope::RISES_FROM_A_FALL_ONCE : Slope::NEVER_RISES_FROM_A_FALL;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Spline_projector::refine(std::size_t span, double low, double high,
                                                               const Spline_vector& query, Result& best) const
{
  Spline_vector c[3];
  const double precision = 4. * std::numeric_limits<double>::epsilon() * (high - low);
  double u = low + (high - low) / 2.;
  for (int i = 0; i < 100; ++i)
  {
    evaluate_on_span(m_spline, span, u, 2, c);
    const double slope = dot(c[0] - query, c[1]);
    (slope < 0. ? low : high) = u;
    double next = u - slope / (dot(c[1], c[1]) + dot(c[0] - query, c[2]));
    if (std::abs(next - u) <= precision)
      break;
    // every fourth step halves the bracket, so that Newton's method may not creep
    if (!(next > low && next < high) || i % 4 == 3)
      next = low + (high - low) / 2.;
    if (!(next > low && next < high))
      break;
    u = next;
  }
  consider_stationary(u, c[0], query, best);
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Spline_projector::consider_stationary(double u, const Spline_vector& point,
                                                                            const Spline_vector& query, Result& best)
{
  const double distance = norm(point - query);
  const double rounding = 4. * std::numeric_limits<double>::epsilon() * (norm(point) + distance);
  if (distance <= best.distance + rounding)
    best = Result{u, distance};
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PROJECTOR_IMPL_H
