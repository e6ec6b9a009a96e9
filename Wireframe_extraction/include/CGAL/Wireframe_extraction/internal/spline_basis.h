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


#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_BASIS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_BASIS_H

#include <boost/container/small_vector.hpp>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Three doubles. Its functions are found by argument only, so they collide with no other vector's.
struct Spline_vector
{
  double x = 0., y = 0., z = 0.;

  friend Spline_vector operator+(const Spline_vector& a, const Spline_vector& b)
  {
    return Spline_vector{a.x + b.x, a.y + b.y, a.z + b.z};
  }

  friend Spline_vector operator-(const Spline_vector& a, const Spline_vector& b)
  {
    return Spline_vector{a.x - b.x, a.y - b.y, a.z - b.z};
  }

  friend Spline_vector operator*(double s, const Spline_vector& a)
  {
    return Spline_vector{s * a.x, s * a.y, s * a.z};
  }

  friend double dot(const Spline_vector& a, const Spline_vector& b)
  {
    return a.x * b.x + a.y * b.y + a.z * b.z;
  }

  friend Spline_vector cross(const Spline_vector& a, const Spline_vector& b)
  {
    return Spline_vector{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }

  friend double norm(const Spline_vector& a) { return std::sqrt(dot(a, a)); }
};

// Returns the index s with knots[s] <= u < knots[s + 1] and degree <= s < number of control points. A
// parameter outside the range gets the first or the last span that is not empty; so does the end of the
// range, which makes evaluation there the limit from the left. The range must not be empty. O(log n).
inline std::size_t find_span(const std::vector<double>& knots, std::size_t degree, double u)
{
  const auto first = knots.begin() + degree;
  const auto last = knots.end() - degree - 1;
  if (u >= *last)
    return std::size_t(std::lower_bound(first, last, *last) - knots.begin()) - 1;
  if (u < *first)
    u = *first;
  return std::size_t(std::upper_bound(first, last, u) - knots.begin()) - 1;
}

// Writes the values at u of the degree + 1 basis functions of that degree that do not vanish on the span, and
// their derivatives up to `order`: out[k * (degree + 1) + j] is the k-th derivative of the basis function
// that belongs to the control point span - degree + j. `out` has room for (order + 1) * (degree + 1) values.
// O(order * degree^2).
inline void basis_functions(std::size_t span, double u, std::size_t degree, const std::vector<double>& knots,
                            std::size_t order, double* out)
{
  const std::size_t width = degree + 1;
  for (std::size_t k = 0; k <= order; ++k)
  {
    double* row = out + k * width;
    std::fill(row, row + width, 0.);
    if (k > degree)
      continue;

    // the values of the basis of degree - k; each pass raises the degree by one, in place from the right
    row[0] = 1.;
    for (std::size_t d = 1; d <= degree - k; ++d)
      for (std::size_t j = d + 1; j-- > 0;)
      {
        const std::size_t i = span - d + j;
        double value = 0.;
        if (j > 0)
          value += (u - knots[i]) / (knots[i + d] - knots[i]) * row[j - 1];
        if (j < d)
          value += (knots[i + d + 1] - u) / (knots[i + d + 1] - knots[i + 1]) * row[j];
        row[j] = value;
      }

    // each pass differentiates once, which raises the degree by one too
    for (std::size_t d = degree - k + 1; d <= degree; ++d)
      for (std::size_t j = d + 1; j-- > 0;)
      {
        const std::size_t i = span - d + j;
        double value = 0.;
        if (j > 0)
          value += row[j - 1] / (knots[i + d] - knots[i]);
        if (j < d)
          value -= row[j] / (knots[i + d + 1] - knots[i + 1]);
        row[j] = double(d) * value;
      }
  }
}

// A B-spline in double: knots, control points, and weights that are empty if all are one.
struct Spline_data
{
  std::size_t degree = 0;
  std::vector<double> knots;
  std::vector<Spline_vector> points;
  std::vector<double> weights;

  double front() const { return knots[degree]; }
  double back() const { return knots[points.size()]; }
  std::size_t multiplicity(double u) const
  {
    const auto range = std::equal_range(knots.begin(), knots.end(), u);
    return std::size_t(range.second - range.first);
  }
};

// Writes the point at u and the derivatives up to `order` with respect to u into out[0 .. order].
inline void evaluate_on_span(const Spline_data& spline, std::size_t span, double u, std::size_t order,
                             Spline_vector* out)
{
  const std::size_t degree = spline.degree;
  const std::size_t first = span - degree;
  boost::container::small_vector<double, 32> basis((order + 1) * (degree + 1));
  basis_functions(span, u, degree, spline.knots, order, basis.data());

  // Sums relative to a control point keep their digits on a small curve that is far from the origin.
  const Spline_vector origin = spline.points[first];
  boost::container::small_vector<double, 8> weight(order + 1, 0.);
  for (std::size_t k = 0; k <= order; ++k)
  {
    out[k] = Spline_vector();
    for (std::size_t j = 0; j <= degree; ++j)
    {
      double b = basis[k * (degree + 1) + j];
      if (!spline.weights.empty())
        b *= spline.weights[first + j];
      weight[k] += b;
      out[k] = out[k] + b * (spline.points[first + j] - origin);
    }
  }

  if (!spline.weights.empty())
  {
    // the product rule for (w c)^(k), solved for c^(k)
    for (std::size_t k = 0; k <= order; ++k)
    {
      double binomial = 1.;
      for (std::size_t j = 1; j <= k; ++j)
      {
        binomial *= double(k - j + 1) / double(j);
        out[k] = out[k] - (binomial * weight[j]) * out[k - j];
      }
      out[k] = (1. / weight[0]) * out[k];
    }
  }
  out[0] = out[0] + origin;
}

inline double speed_on_span(const Spline_data& spline, std::size_t span, double u)
{
  Spline_vector values[2];
  evaluate_on_span(spline, span, u, 1, values);
  return norm(values[1]);
}

// The arc length over a range of parameters, as a table of intervals on which one Gauss rule is accurate.
class Arc_length_table
{
  typedef boost::math::quadrature::gauss<double, 15> Gauss;

  struct Interval
  {
    double begin, end;        // parameters
    std::size_t span;
    double length_before;     // from the start of the table to `begin`
    double length;
  };

public:
  Arc_length_table(const Spline_data& spline, double u0, double u1)
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

  double length() const { return m_length; }

  // Returns the parameter at which the length from the start of the table is s.
  double parameter(double s) const
  {
    if (!(s > 0.) || m_intervals.empty())
      return m_begin;
    if (s >= m_length)
      return m_end;
    const auto after = std::upper_bound(m_intervals.begin(), m_intervals.end(), s,
      [](double value, const Interval& interval) { return value < interval.length_before; });
    return parameter_in(*(after - 1), s - (after - 1)->length_before);
  }

private:
  static constexpr double relative_tolerance = 1e-12;
  static constexpr int maximum_depth = 40;

  double integrate(std::size_t span, double begin, double end) const
  {
    return Gauss::integrate([&](double u) { return speed_on_span(m_spline, span, u); }, begin, end);
  }

  void subdivide(const Interval& interval, double tolerance, int depth)
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

  void append(Interval interval)
  {
    interval.length_before = m_length;
    m_length += interval.length;
    m_intervals.push_back(interval);
  }

  // Newton's method from linear interpolation, with bisection wherever it would leave the bracket or creep.
  double parameter_in(const Interval& interval, double s) const
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

  const Spline_data& m_spline;
  double m_begin, m_end;
  double m_length = 0.;
  std::vector<Interval> m_intervals;
};

// What the curve does next to a parameter, on the side on which it goes on: to the right, or at the end of
// the range to the left.
struct Local_shape
{
  // a unit vector in the direction of growing parameters; null on a curve that is a point
  Spline_vector tangent;
  double curvature = 0.;
};

// Finds the lowest derivatives that do not vanish: with c(t) = c(0) + a t^m + ... + b t^n + ..., where b is
// the first coefficient not parallel to a, the tangent is a and the curvature behaves like
// n (n - m) |a x b| / (m^2 |a|^3) t^(n - 2 m). Returns whether the curve moves on that span at all.
inline bool shape_on_span(const Spline_data& spline, std::size_t span, double u, bool is_left_limit,
                          Local_shape& shape)
{
  // below this fraction of the largest term a term is rounding
  const double negligible = 1e-12;
  const double width = spline.knots[span + 1] - spline.knots[span];

  // A curve whose first `degree` derivatives vanish is constant on the span; the curvature asks for twice as
  // many.
  const std::size_t order = 2 * spline.degree;
  boost::container::small_vector<Spline_vector, 16> terms(order + 1);
  evaluate_on_span(spline, span, u, order, terms.data());
  double scale = 1., largest = 0.;
  for (std::size_t k = 1; k <= order; ++k)
  {
    scale *= width / double(k);
    terms[k] = scale * terms[k];
    if (k <= spline.degree)
      largest = (std::max)(largest, norm(terms[k]));
  }
  if (!(largest > 0.))
    return false;

  std::size_t m = 1;
  while (!(norm(terms[m]) > negligible * largest))
    ++m;
  const double a = norm(terms[m]);
  shape.tangent = ((is_left_limit && m % 2 == 0 ? -1. : 1.) / a) * terms[m];

  shape.curvature = 0.;
  for (std::size_t n = m + 1; n <= 2 * m; ++n)
  {
    const double sine = norm(cross(shape.tangent, terms[n]));
    if (n < 2 * m && !(sine > negligible * largest))
      continue;
    shape.curvature = n < 2 * m ? (std::numeric_limits<double>::max)() : 2. * sine / (a * a);
    break;
  }
  return true;
}

inline Local_shape local_shape(const Spline_data& spline, double u)
{
  Local_shape shape;
  const std::size_t start = find_span(spline.knots, spline.degree, u);
  const bool is_left_limit = u >= spline.back();
  if (shape_on_span(spline, start, u, is_left_limit, shape))
    return shape;

  // The curve stands still here. What comes next decides, and if nothing does, what came before.
  const auto is_empty = [&](std::size_t s) { return !(spline.knots[s] < spline.knots[s + 1]); };
  for (std::size_t s = start + 1; s < spline.points.size(); ++s)
    if (!is_empty(s) && shape_on_span(spline, s, spline.knots[s], false, shape))
      return shape;
  for (std::size_t s = start; s-- > spline.degree;)
    if (!is_empty(s) && shape_on_span(spline, s, spline.knots[s + 1], true, shape))
      return shape;
  return shape;
}

// A control point with its weight. Interpolation is that of the homogeneous points, written such that equal
// points stay as they are and both ends are met exactly.
struct Weighted_control_point
{
  Spline_vector point;
  double weight = 1.;
};

inline Weighted_control_point interpolate(const Weighted_control_point& a, const Weighted_control_point& b,
                                          double t)
{
  if (t <= 0.)
    return a;
  if (t >= 1.)
    return b;
  if (a.weight == b.weight)
    return Weighted_control_point{a.point + t * (b.point - a.point), a.weight};
  const double weight = (1. - t) * a.weight + t * b.weight;
  return Weighted_control_point{a.point + (t * b.weight / weight) * (b.point - a.point), weight};
}

inline Weighted_control_point weighted_control_point(const Spline_data& spline, std::size_t i)
{
  return Weighted_control_point{spline.points[i], spline.weights.empty() ? 1. : spline.weights[i]};
}

// Inserts the knot u, which lies in the range, until its multiplicity is the degree. O(n + degree^2).
inline void insert_knot_fully(Spline_data& spline, double u)
{
  const std::size_t degree = spline.degree;
  const std::size_t multiplicity = spline.multiplicity(u);
  if (multiplicity >= degree)
    return;
  const std::size_t count = degree - multiplicity;
  const std::size_t span =
    std::size_t(std::upper_bound(spline.knots.begin(), spline.knots.end(), u) - spline.knots.begin()) - 1;

  // Of the control points that act on u, each round of the corner cutting fixes the first and the last one.
  std::vector<Weighted_control_point> row, left, right;
  for (std::size_t i = span - degree; i <= span - multiplicity; ++i)
    row.push_back(weighted_control_point(spline, i));
  for (std::size_t round = 1; round <= count; ++round)
  {
    left.push_back(row.front());
    right.push_back(row.back());
    for (std::size_t j = 0; j + 1 < row.size(); ++j)
    {
      const std::size_t i = span - degree + round + j;
      const double begin = spline.knots[i];
      row[j] = interpolate(row[j], row[j + 1], (u - begin) / (spline.knots[i + degree - round + 1] - begin));
    }
    row.pop_back();
  }
  row.insert(row.begin(), left.begin(), left.end());
  row.insert(row.end(), right.rbegin(), right.rend());

  // the row is longer by `count` than the control points that it replaces
  const std::size_t first = span - degree;
  spline.points.insert(spline.points.begin() + first, count, Spline_vector());
  if (!spline.weights.empty())
    spline.weights.insert(spline.weights.begin() + first, count, 1.);
  for (std::size_t j = 0; j < row.size(); ++j)
  {
    spline.points[first + j] = row[j].point;
    if (!spline.weights.empty())
      spline.weights[first + j] = row[j].weight;
  }
  spline.knots.insert(spline.knots.begin() + span + 1, count, u);
}

// Returns the part from u0 to u1, clamped at both ends; u0 < u1 lie in the range.
inline Spline_data clamped_part(Spline_data spline, double u0, double u1)
{
  insert_knot_fully(spline, u0);
  insert_knot_fully(spline, u1);
  const auto begin = std::upper_bound(spline.knots.begin(), spline.knots.end(), u0);
  const auto end = std::lower_bound(spline.knots.begin(), spline.knots.end(), u1);
  const std::size_t first = std::size_t(begin - spline.knots.begin()) - 1 - spline.degree;
  const std::size_t beyond = std::size_t(end - spline.knots.begin());

  Spline_data part;
  part.degree = spline.degree;
  part.knots.assign(spline.degree + 1, u0);
  part.knots.insert(part.knots.end(), begin, end);
  part.knots.insert(part.knots.end(), spline.degree + 1, u1);
  part.points.assign(spline.points.begin() + first, spline.points.begin() + beyond);
  if (!spline.weights.empty())
    part.weights.assign(spline.weights.begin() + first, spline.weights.begin() + beyond);
  return part;
}

// The part of a spline on one span that is not empty, as the control points of a Bezier curve.
struct Bezier_piece
{
  std::size_t span = 0;
  double begin = 0., end = 0.;
  std::vector<Weighted_control_point> points;
};

// O(n degree^3). Each piece starts at the very point at which the one before ends.
inline std::vector<Bezier_piece> bezier_pieces(const Spline_data& spline)
{
  const std::size_t degree = spline.degree;
  std::vector<Bezier_piece> pieces;
  std::vector<Weighted_control_point> row(degree + 1);
  for (std::size_t span = degree; span < spline.points.size(); ++span)
  {
    if (!(spline.knots[span] < spline.knots[span + 1]))
      continue;
    Bezier_piece piece{span, spline.knots[span], spline.knots[span + 1], {}};
    // control point k is the polar form at k times the end and degree - k times the begin of the span
    for (std::size_t k = 0; k <= degree; ++k)
    {
      for (std::size_t j = 0; j <= degree; ++j)
        row[j] = weighted_control_point(spline, span - degree + j);
      for (std::size_t round = 1; round <= degree; ++round)
      {
        const double u = round <= k ? piece.end : piece.begin;
        for (std::size_t j = 0; j + round <= degree; ++j)
        {
          const std::size_t i = span - degree + round + j;
          const double low = spline.knots[i];
          row[j] = interpolate(row[j], row[j + 1], (u - low) / (spline.knots[i + degree - round + 1] - low));
        }
      }
      piece.points.push_back(row[0]);
    }
    if (!pieces.empty())
      piece.points.front() = pieces.back().points.back();
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

inline double distance_to_segment(const Spline_vector& p, const Spline_vector& a, const Spline_vector& b)
{
  const Spline_vector ab = b - a;
  const double t = dot(p - a, ab) / dot(ab, ab);
  if (!(t > 0.))
    return norm(p - a);
  return t < 1. ? norm(p - (a + t * ab)) : norm(p - b);
}

// Finds the globally closest point of a spline. A Bezier piece stays in the hull of its control points, hence
// no farther from its chord than they are: this bounds the distance from below, and what cannot hold the
// minimum is left out. The derivative of the squared distance has, in Bernstein form, at most as many roots
// as its coefficients change sign: a piece is halved until there is at most one, which a safeguarded Newton's
// method finds.
class Spline_projector
{
  typedef boost::container::small_vector<Weighted_control_point, 192> Stack;
  typedef boost::container::small_vector<double, 32> Coefficients;
  typedef boost::container::small_vector<Spline_vector, 32> Vectors;

  enum class Slope { NEVER_RISES_FROM_A_FALL, RISES_FROM_A_FALL_ONCE, UNKNOWN };

  struct Box
  {
    double bound;
    std::size_t piece;
  };

public:
  struct Result
  {
    double parameter;
    double distance;
  };

  explicit Spline_projector(const Spline_data& spline)
    : m_spline(spline), m_pieces(bezier_pieces(spline)), m_binomials(1, 1.), m_binomials_of_degree(1, 1.)
  {
    const double degree = double(spline.degree);
    for (double k = 1.; k < degree; k += 1.)
      m_binomials.push_back(m_binomials.back() * (degree - k) / k);
    for (double k = 1.; k <= degree; k += 1.)
      m_binomials_of_degree.push_back(m_binomials_of_degree.back() * (degree - k + 1.) / k);
  }

  Result operator()(const Spline_vector& query) const
  {
    Result best{m_pieces.back().end, norm(m_pieces.back().points.back().point - query)};
    boost::container::small_vector<Box, 32> boxes;
    for (std::size_t i = m_pieces.size(); i-- > 0;)
    {
      consider(m_pieces[i].begin, m_pieces[i].points.front().point, query, best);
      boxes.push_back(Box{lower_bound(m_pieces[i].points.data(), query), i});
    }
    std::sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b)
              { return a.bound < b.bound || (a.bound == b.bound && a.piece < b.piece); });

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

private:
  // two minima that are not told apart within 2^-20 of a span are the same up to rounding
  static constexpr std::size_t maximum_depth = 20;
  // far more than a piece needs, except where its distance to the query is the same all along up to rounding
  static constexpr std::size_t maximum_number_of_splits = 512;

  double lower_bound(const Weighted_control_point* points, const Spline_vector& query) const
  {
    const Spline_vector& a = points[0].point;
    const Spline_vector& b = points[m_spline.degree].point;
    double deviation = 0.;
    for (std::size_t i = 1; i < m_spline.degree; ++i)
      deviation = (std::max)(deviation, distance_to_segment(points[i].point, a, b));
    return distance_to_segment(query, a, b) - deviation;
  }

  static void consider(double u, const Spline_vector& point, const Spline_vector& query, Result& best)
  {
    const double distance = norm(point - query);
    if (distance < best.distance || (distance == best.distance && u < best.parameter))
      best = Result{u, distance};
  }

  void search(const Weighted_control_point* points, std::size_t span, double begin, double end,
              Weighted_control_point* stack, std::size_t depth, std::size_t& splits,
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

  // With c - query = a / w the slope has the sign of a * (a' w - a w'), which is a polynomial.
  Slope slope_of_distance(const Weighted_control_point* points, const Spline_vector& query) const
  {
    const std::size_t degree = m_spline.degree;
    const bool is_rational = !m_spline.weights.empty();
    Vectors a(degree + 1);
    for (std::size_t i = 0; i <= degree; ++i)
      a[i] = points[i].weight * (points[i].point - query);

    // scaled Bernstein coefficients, that is, with the binomials, multiply like those of the power basis
    Vectors b(is_rational ? 2 * degree : degree);
    double largest_a = 0., largest_b = 0.;    // b before its terms cancel each other
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

  static Slope classify(const Coefficients& slope, double rounding)
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
    return number_of_changes == 1 && is_first_negative ? Slope::RISES_FROM_A_FALL_ONCE
                                                       : Slope::NEVER_RISES_FROM_A_FALL;
  }

  // Finds the root of the slope on an interval on which it goes from falling to rising.
  void refine(std::size_t span, double low, double high, const Spline_vector& query, Result& best) const
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

  // The distance is flat at its minimum, where points beside it are as close up to rounding: among them the
  // stationary one is the most accurate.
  static void consider_stationary(double u, const Spline_vector& point, const Spline_vector& query,
                                  Result& best)
  {
    const double distance = norm(point - query);
    const double rounding = 4. * std::numeric_limits<double>::epsilon() * (norm(point) + distance);
    if (distance <= best.distance + rounding)
      best = Result{u, distance};
  }

  const Spline_data& m_spline;
  std::vector<Bezier_piece> m_pieces;
  std::vector<double> m_binomials;              // of degree - 1
  std::vector<double> m_binomials_of_degree;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_BASIS_H
