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

#ifndef CGAL_WIREFRAME_EXTRACTION_SPLINE_CURVE_3_H
#define CGAL_WIREFRAME_EXTRACTION_SPLINE_CURVE_3_H

#include <CGAL/Wireframe_extraction/internal/spline/Arc_length_table.h>
#include <CGAL/Wireframe_extraction/internal/spline/Spline_projector.h>
#include <CGAL/Wireframe_extraction/internal/spline/local_shape.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_pieces.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgWireframeExtractionClasses

The class `Spline_curve_3` is a parametric curve in space: a B-spline, polynomial or rational, of any degree
from one on. It can be evaluated, differentiated, measured, sampled, projected on, and cut.

The curve is given by its degree \f$ p \f$, \f$ n \f$ control points, \f$ n + p + 1 \f$ non-decreasing knots
\f$ t_i \f$, and, if it is rational, \f$ n \f$ positive weights. It is defined for the parameters from
\f$ t_p \f$ to \f$ t_n \f$. Its knot vector is usually <em>clamped</em>, that is, the first and the last knot
are there \f$ p + 1 \f$ times, so that the curve starts at its first control point and ends at its last one;
then it does so exactly, without rounding.

A curve may be marked as closed. Such a curve ends at the point at which it starts, with the same tangent
direction; in clamped form its first and last control points are equal. The mark is a promise of whoever makes
the curve: it is not checked.

All functions that take a parameter `u` accept any finite value. Outside the range of parameters an open curve
continues with its end points (`u` is clamped to the range), and a closed curve is periodic (`u` is wrapped
around). Where derivatives jump, that is, at knots of high multiplicity, the values are the limits from the
right, and at the end of the range those from the left.

All calculation is in `double`, whatever `FT` is; where the complexity of a function is not given, it is
\f$ O(\log n + p^2) \f$. It is a precondition of all functions other than `is_empty()`, `degree()`, `knots()`,
`control_points()`, `weights()`, `is_rational()` and `is_closed()` that the curve is not empty.
Member functions that are `const` may be called from several threads at once.

\tparam GeomTraits a model of `WireframeExtractionTraits_3`
*/
template <class GeomTraits>
class Spline_curve_3
{
  typedef Wireframe_extraction::internal::Spline_data Spline_data;
  typedef Wireframe_extraction::internal::Spline_vector Spline_vector;
  typedef Wireframe_extraction::internal::Arc_length_table Arc_length_table;
  typedef Wireframe_extraction::internal::Spline_projector Spline_projector;

public:
  /// \name Types
  /// @{

  typedef GeomTraits Geom_traits;                 ///< the traits class
  typedef typename GeomTraits::FT FT;             ///< the number type
  typedef typename GeomTraits::Point_3 Point_3;   ///< the point type
  typedef typename GeomTraits::Vector_3 Vector_3; ///< the vector type

  /// The result of a projection on the curve.
  struct Closest_point
  {
    FT parameter;  ///< the parameter of the closest point
    Point_3 point; ///< the closest point of the curve
    FT distance;   ///< its distance to the query point
  };

  /// @}

  /// \name Creation
  /// @{

  /// constructs an empty curve.
  Spline_curve_3() = default;

  /*!
  constructs a polynomial B-spline curve. Linear in the number of knots.

  \param degree the degree
  \param knots the knots, in the unit of the parameter
  \param control_points the control points
  \param is_closed whether the curve is marked as closed; the default is `false`
  \param traits the traits object; the default is a default constructed one

  \pre `is_valid(degree, knots, control_points)`
  */
  Spline_curve_3(std::size_t degree, std::vector<FT> knots, std::vector<Point_3> control_points, bool is_closed = false,
                 const GeomTraits& traits = GeomTraits())
    : Spline_curve_3(degree, std::move(knots), std::move(control_points), std::vector<FT>(), is_closed, traits)
  {}

  /*!
  constructs a rational B-spline curve, or a polynomial one if there are no weights. Linear in the number of
  knots.

  \param degree the degree
  \param knots the knots, in the unit of the parameter
  \param control_points the control points, not multiplied by their weights
  \param weights one positive weight per control point, or none at all
  \param is_closed whether the curve is marked as closed; the default is `false`
  \param traits the traits object; the default is a default constructed one

  \pre `is_valid(degree, knots, control_points, weights)`
  */
  Spline_curve_3(std::size_t degree, std::vector<FT> knots, std::vector<Point_3> control_points,
                 std::vector<FT> weights, bool is_closed = false, const GeomTraits& traits = GeomTraits())
    : m_degree(degree), m_knots(std::move(knots)), m_control_points(std::move(control_points)),
      m_weights(std::move(weights)), m_is_closed(is_closed), m_traits(traits)
  {
    CGAL_precondition_msg(is_valid(m_degree, m_knots, m_control_points, m_weights, nullptr, m_traits),
                          "The degree, knots, control points and weights must make a valid B-spline: "
                          "see Spline_curve_3::is_valid().");
    m_data = to_data(m_degree, m_knots, m_control_points, m_weights, m_traits);
  }

  /*!
  returns the polyline through the given points as a curve of degree one that is parametrised by its arc
  length from zero on. A point that coincides with the one before is left out, as it has no arc length of its
  own; if all points coincide, two of them are kept, and the parameter runs from zero to one. The first and
  the last point are always those of the polyline. If there is no point the curve is empty. Linear in the
  number of points.

  \param points the points, with finite coordinates
  \param is_closed whether the curve is marked as closed; the last point must then be the first one. The
         default is `false`
  \param traits the traits object; the default is a default constructed one
  */
  static Spline_curve_3 from_polyline(const std::vector<Point_3>& points, bool is_closed = false,
                                      const GeomTraits& traits = GeomTraits())
  {
    if (points.empty())
      return Spline_curve_3();

    std::vector<Point_3> kept(1, points.front());
    std::vector<double> lengths(1, 0.);
    Spline_vector last = to_vector(points.front(), traits);
    for (std::size_t i = 1; i < points.size(); ++i)
    {
      const Spline_vector p = to_vector(points[i], traits);
      const double length = lengths.back() + norm(p - last);
      if (!(length > lengths.back()))
        continue;
      kept.push_back(points[i]);
      lengths.push_back(length);
      last = p;
    }
    if (kept.size() == 1)
    {
      kept.push_back(points.back());
      lengths.push_back(1.);
    }
    kept.back() = points.back();

    std::vector<FT> knots(1, FT(lengths.front()));
    knots.insert(knots.end(), lengths.begin(), lengths.end());
    knots.push_back(FT(lengths.back()));
    return Spline_curve_3(1, std::move(knots), std::move(kept), is_closed, traits);
  }

  /*!
  returns whether the data make a curve, without any exception, for whoever gets them from a file: the degree
  is at least one, there are more control points than the degree, the numbers of knots and weights fit, all
  numbers are finite, the knots do not decrease, the range of parameters is not empty, no knot inside of it is
  repeated more often than the degree (the curve would be torn there) and none at its ends more often than the
  degree plus one, and all weights are positive. Linear in the number of knots.

  \param degree the degree
  \param knots the knots
  \param control_points the control points
  \param weights the weights; empty by default
  \param why if it is not null, the string that gets a sentence about the first fault if there is one; null by
         default
  \param traits the traits object; the default is a default constructed one
  */
  static bool is_valid(std::size_t degree, const std::vector<FT>& knots, const std::vector<Point_3>& control_points,
                       const std::vector<FT>& weights = std::vector<FT>(), std::string* why = nullptr,
                       const GeomTraits& traits = GeomTraits())
  {
    const std::string fault = first_fault(degree, knots, control_points, weights, traits);
    if (!fault.empty() && why != nullptr)
      *why = fault;
    return fault.empty();
  }

  /// @}

  /// \name Access
  /// @{

  /// returns the degree, or zero if the curve is empty. Constant time.
  std::size_t degree() const { return m_degree; }

  /// returns the knots. Constant time.
  const std::vector<FT>& knots() const { return m_knots; }

  /// returns the control points. Constant time.
  const std::vector<Point_3>& control_points() const { return m_control_points; }

  /// returns the weights of the control points; empty if the curve is not rational. Constant time.
  const std::vector<FT>& weights() const { return m_weights; }

  /// returns whether the control points have weights. Constant time.
  bool is_rational() const { return !m_weights.empty(); }

  /// returns whether the curve is marked as closed. Constant time.
  bool is_closed() const { return m_is_closed; }

  /// returns whether the curve has no control points. Constant time.
  bool is_empty() const { return m_control_points.empty(); }

  /// returns the smallest and the largest parameter of the curve. Constant time.
  std::pair<FT, FT> parameter_range() const
  {
    check_not_empty();
    return std::make_pair(m_knots[m_degree], m_knots[m_control_points.size()]);
  }

  /// @}

  /// \name Evaluation
  /// @{

  /// returns the point of the curve at the parameter `u`.
  Point_3 point(FT u) const
  {
    check_not_empty();
    return point_in_range(to_range(CGAL::to_double(u)));
  }

  /*!
  returns a derivative of the curve with respect to its parameter, at the parameter `u`. With `order` zero
  this is the vector from the origin to the point. \f$ O(\log n + order\, p^2 + order^2) \f$.

  \param u the parameter
  \param order how often to differentiate; one by default
  */
  Vector_3 derivative(FT u, std::size_t order = 1) const
  {
    check_not_empty();
    const double v = to_range(CGAL::to_double(u));
    boost::container::small_vector<Spline_vector, 8> values(order + 1);
    Wireframe_extraction::internal::evaluate_on_span(m_data, span(v), v, order, values.data());
    return from_vector(values[order]);
  }

  /// returns the unit vector in the direction in which the curve is passed at the parameter `u`. Where the
  /// first derivative vanishes, this is the limit from the right, or at the end from the left; where the
  /// curve stands still, the direction in which it goes on. It is the null vector if the whole curve is a
  /// single point. \f$ O(\log n + p^3) \f$.
  Vector_3 tangent(FT u) const
  {
    check_not_empty();
    const double v = to_range(CGAL::to_double(u));
    return from_vector(Wireframe_extraction::internal::local_shape(m_data, v).tangent);
  }

  /// returns the curvature at the parameter `u`, in one over the unit of the points. Where the first
  /// derivative vanishes this is the limit, which is the largest `double` if the curvature grows beyond all
  /// bounds, as at a cusp. It is zero if the whole curve is a single point. \f$ O(\log n + p^3) \f$.
  FT curvature(FT u) const
  {
    check_not_empty();
    const double v = to_range(CGAL::to_double(u));
    return FT(Wireframe_extraction::internal::local_shape(m_data, v).curvature);
  }

  /// @}

  /// \name Arc Length
  /// The lengths come from Gauss-Legendre quadrature on each span of the knots, with spans halved until the
  /// relative error is below 10<sup>-10</sup>. If nothing else is said, the functions take \f$ O(n p^2) \f$
  /// time.
  /// @{

  /// returns the length of the curve, in the unit of the points.
  FT length() const
  {
    check_not_empty();
    return FT(length_between(m_data.front(), m_data.back()));
  }

  /// returns the length of the curve from the parameter `u0` to `u1`, in the unit of the points. The order of
  /// the two does not matter. On a closed curve each period counts: from inside the range to a parameter
  /// beyond its end, this is the length across the seam.
  FT length(FT u0, FT u1) const
  {
    check_not_empty();
    double from = CGAL::to_double(u0), to = CGAL::to_double(u1);
    if (from > to)
      std::swap(from, to);
    const double turns = m_is_closed ? turn(to) - turn(from) : 0.;
    from = to_range(from);
    to = to_range(to);
    if (turns == 0.)
      return FT(length_between(from, to));
    const double whole = turns > 1. ? (turns - 1.) * length_between(m_data.front(), m_data.back()) : 0.;
    return FT(length_between(from, m_data.back()) + whole + length_between(m_data.front(), to));
  }

  /// returns the parameter up to which the curve has the length `s`, in the unit of the points. Outside the
  /// range from zero to the curve's length, `s` is clamped on an open curve and wrapped around on a closed
  /// one.
  FT parameter_at_length(FT s) const
  {
    check_not_empty();
    const Arc_length_table table(m_data, m_data.front(), m_data.back());
    double length = CGAL::to_double(s);
    if (m_is_closed && table.length() > 0. && (length < 0. || length > table.length()))
      length -= std::floor(length / table.length()) * table.length();
    return FT(table.parameter(length));
  }

  /*!
  writes points that are spaced uniformly by arc length. The first and the last one are exactly the ends of
  the curve; on a closed curve both are the same point. \f$ O(n p^2 + count (\log n + p^2)) \f$.

  \tparam PointOutputIterator a model of `OutputIterator` that accepts `Point_3`

  \param count the number of points; with one there is only the start of the curve
  \param out the output iterator

  \return the output iterator behind the last point
  */
  template <class PointOutputIterator>
  PointOutputIterator sample_by_count(std::size_t count, PointOutputIterator out) const
  {
    check_not_empty();
    return sample(Arc_length_table(m_data, m_data.front(), m_data.back()), count, out);
  }

  /*!
  writes points that are spaced uniformly by arc length, by as much as fits the curve but, up to rounding, at
  most `step`. There are at least two points. The first and the last one are exactly the ends of the curve; on
  a closed curve both are the same point. \f$ O(n p^2 + count (\log n + p^2)) \f$.

  \tparam PointOutputIterator a model of `OutputIterator` that accepts `Point_3`

  \param step the largest spacing, in the unit of the points
  \param out the output iterator

  \return the output iterator behind the last point

  \pre `step > 0`, and the curve is at most 10<sup>15</sup> steps long
  */
  template <class PointOutputIterator>
  PointOutputIterator sample_by_distance(FT step, PointOutputIterator out) const
  {
    check_not_empty();
    const Arc_length_table table(m_data, m_data.front(), m_data.back());
    const double steps = table.length() / CGAL::to_double(step);
    CGAL_precondition_msg(CGAL::to_double(step) > 0. && steps <= 1e15,
                          "The step of Spline_curve_3::sample_by_distance() must be positive, and not tiny.");
    // the last digit of a length must not decide about one more point
    const double intervals = (std::max)(1., std::ceil(steps * (1. - 1e-12)));
    return sample(table, std::size_t(intervals) + 1, out);
  }

  /// @}

  /// \name Projection
  /// @{

  /// returns the point of the curve that is closest to `query`, over the whole curve and not only nearby. If
  /// several are equally close it is any of them, but always the same. \f$ O(n p^3) \f$, with the constant
  /// largest where much of the curve is equally close.
  Closest_point closest_point(const Point_3& query) const
  {
    check_not_empty();
    return project(Spline_projector(m_data), query);
  }

  /*!
  writes for each query point the point of the curve that is closest to it. This is faster than to call
  `closest_point()` for one after the other: \f$ O(n p^3) \f$ for all of them, and
  \f$ O(n \log n + n p) \f$ for each, and \f$ O(p^2) \f$ for each piece that is near enough to hold the point.

  \tparam PointInputIterator a model of `InputIterator` with value type `Point_3`
  \tparam ClosestPointOutputIterator a model of `OutputIterator` that accepts `Closest_point`

  \param first the first query point
  \param beyond the end of the query points
  \param out the output iterator

  \return the output iterator behind the last result
  */
  template <class PointInputIterator, class ClosestPointOutputIterator>
  ClosestPointOutputIterator closest_points(PointInputIterator first, PointInputIterator beyond,
                                            ClosestPointOutputIterator out) const
  {
    check_not_empty();
    const Spline_projector projector(m_data);
    for (; first != beyond; ++first)
      *out++ = project(projector, *first);
    return out;
  }

  /// @}

  /// \name Pieces
  /// The curves that these functions return have the very points of this curve, at the same parameters if not
  /// said otherwise, and those of `split()` and `bezier_pieces()` have clamped knots whatever this curve has.
  /// @{

  /// returns the two parts of the curve before and after the parameter `u`, both open. The first ends where
  /// the second starts, exactly. \f$ O(n + p^2) \f$.
  /// \pre `u` is inside of the range of parameters, not at its ends; on a closed curve after wrapping around
  std::pair<Spline_curve_3, Spline_curve_3> split(FT u) const
  {
    check_not_empty();
    const double v = to_range(CGAL::to_double(u));
    CGAL_precondition_msg(v > m_data.front() && v < m_data.back(),
                          "A spline curve can be split only inside of its range of parameters.");
    // cutting one and the same refined curve makes the shared point the same to the last digit
    using Wireframe_extraction::internal::clamped_part;
    Spline_data refined = clamped_part(m_data, m_data.front(), m_data.back());
    Wireframe_extraction::internal::insert_knot_fully(refined, v);
    Spline_data before = clamped_part(refined, refined.front(), v);
    Spline_data after = clamped_part(refined, v, refined.back());
    return std::make_pair(Spline_curve_3(std::move(before), false, m_traits),
                          Spline_curve_3(std::move(after), false, m_traits));
  }

  /*!
  writes the polynomial or rational pieces of the curve in order, each as a curve without inner knots, whose
  control points are those of a Bezier curve. \f$ O(n p^3) \f$.

  \tparam SplineOutputIterator a model of `OutputIterator` that accepts `Spline_curve_3`

  \param out the output iterator

  \return the output iterator behind the last piece
  */
  template <class SplineOutputIterator>
  SplineOutputIterator bezier_pieces(SplineOutputIterator out) const
  {
    check_not_empty();
    const std::vector<Wireframe_extraction::internal::Bezier_piece> pieces =
      Wireframe_extraction::internal::bezier_pieces(m_data);
    for (const Wireframe_extraction::internal::Bezier_piece& piece : pieces)
    {
      Spline_data data;
      data.degree = m_degree;
      data.knots.assign(m_degree + 1, piece.begin);
      data.knots.insert(data.knots.end(), m_degree + 1, piece.end);
      for (const Wireframe_extraction::internal::Weighted_control_point& p : piece.points)
      {
        data.points.push_back(p.point);
        if (is_rational())
          data.weights.push_back(p.weight);
      }
      *out++ = Spline_curve_3(std::move(data), m_is_closed && pieces.size() == 1, m_traits);
    }
    return out;
  }

  /// returns the curve passed the other way, over the same range of parameters: with the range from `a` to
  /// `b`, the point at `u` becomes that at `a + b - u`. Linear in the number of knots.
  Spline_curve_3 reversed() const
  {
    check_not_empty();
    const double a = m_data.front(), b = m_data.back();
    Spline_curve_3 result(*this);
    std::reverse(result.m_control_points.begin(), result.m_control_points.end());
    std::reverse(result.m_weights.begin(), result.m_weights.end());
    std::reverse(result.m_data.points.begin(), result.m_data.points.end());
    std::reverse(result.m_data.weights.begin(), result.m_data.weights.end());
    for (std::size_t i = 0; i < m_knots.size(); ++i)
    {
      // the ends change places without rounding
      const double knot = m_data.knots[m_knots.size() - 1 - i];
      result.m_data.knots[i] = knot == a ? b : a + (b - knot);
      result.m_knots[i] = FT(result.m_data.knots[i]);
    }
    return result;
  }

  /// @}

private:
  // for results, which are valid by construction
  Spline_curve_3(Spline_data data, bool is_closed, const GeomTraits& traits)
    : m_degree(data.degree), m_is_closed(is_closed), m_traits(traits), m_data(std::move(data))
  {
    m_knots.assign(m_data.knots.begin(), m_data.knots.end());
    m_weights.assign(m_data.weights.begin(), m_data.weights.end());
    m_control_points.reserve(m_data.points.size());
    for (const Spline_vector& p : m_data.points)
      m_control_points.push_back(from_position(p));
  }

  void check_not_empty() const { CGAL_precondition_msg(!is_empty(), "The spline curve is empty."); }

  static Spline_vector to_vector(const Point_3& p, const GeomTraits& traits)
  {
    auto it = traits.construct_cartesian_const_iterator_3_object()(p);
    Spline_vector v;
    v.x = CGAL::to_double(*it++);
    v.y = CGAL::to_double(*it++);
    v.z = CGAL::to_double(*it);
    return v;
  }

  Point_3 from_position(const Spline_vector& p) const
  {
    return m_traits.construct_point_3_object()(FT(p.x), FT(p.y), FT(p.z));
  }

  Vector_3 from_vector(const Spline_vector& v) const
  {
    return m_traits.construct_vector_3_object()(FT(v.x), FT(v.y), FT(v.z));
  }

  static Spline_data to_data(std::size_t degree, const std::vector<FT>& knots,
                             const std::vector<Point_3>& control_points, const std::vector<FT>& weights,
                             const GeomTraits& traits)
  {
    Spline_data data;
    data.degree = degree;
    for (const FT& knot : knots)
      data.knots.push_back(CGAL::to_double(knot));
    for (const Point_3& p : control_points)
      data.points.push_back(to_vector(p, traits));
    for (const FT& weight : weights)
      data.weights.push_back(CGAL::to_double(weight));
    return data;
  }

  // Returns a sentence about the first fault, or nothing.
  static std::string first_fault(std::size_t degree, const std::vector<FT>& knots,
                                 const std::vector<Point_3>& control_points, const std::vector<FT>& weights,
                                 const GeomTraits& traits)
  {
    if (degree == 0)
      return "The degree is 0; it must be at least 1.";
    if (control_points.size() <= degree)
      return "A curve of degree " + std::to_string(degree) + " needs more than " + std::to_string(degree)
        + " control points; there are " + std::to_string(control_points.size()) + ".";
    const std::size_t expected = control_points.size() + degree + 1;
    if (knots.size() != expected)
      return std::to_string(control_points.size()) + " control points and degree " + std::to_string(degree) + " need "
        + std::to_string(expected) + " knots; there are " + std::to_string(knots.size()) + ".";
    if (!weights.empty() && weights.size() != control_points.size())
      return "There are " + std::to_string(weights.size()) + " weights for " + std::to_string(control_points.size())
        + " control points.";

    const Spline_data data = to_data(degree, knots, control_points, weights, traits);
    for (std::size_t i = 0; i < data.points.size(); ++i)
      if (!is_finite(data.points[i]))
        return "Control point " + std::to_string(i) + " is not finite.";
    for (std::size_t i = 0; i < data.weights.size(); ++i)
      if (!std::isfinite(data.weights[i]) || !(data.weights[i] > 0.))
        return "Weight " + std::to_string(i) + " is not a positive, finite number.";
    return first_fault_of_knots(data);
  }

  static bool is_finite(const Spline_vector& p)
  {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }

  static std::string first_fault_of_knots(const Spline_data& data)
  {
    for (std::size_t i = 0; i < data.knots.size(); ++i)
    {
      if (!std::isfinite(data.knots[i]))
        return "Knot " + std::to_string(i) + " is not finite.";
      if (i > 0 && data.knots[i] < data.knots[i - 1])
        return "Knot " + std::to_string(i) + " is smaller than the one before.";
    }
    if (!(data.front() < data.back()))
      return "The range of parameters is empty: knots " + std::to_string(data.degree) + " and "
        + std::to_string(data.points.size()) + " are equal.";
    for (std::size_t i = 0, run = 1; i < data.knots.size(); ++i, ++run)
    {
      if (i > 0 && data.knots[i] != data.knots[i - 1])
        run = 1;
      const bool is_inside = data.knots[i] > data.front() && data.knots[i] < data.back();
      if (run > data.degree + (is_inside ? 0 : 1))
        return "Knot " + std::to_string(i) + " is one repetition too many: " + std::to_string(data.degree)
          + " are allowed inside of the range of parameters, one more at its ends.";
    }
    return std::string();
  }

  std::size_t span(double u) const { return Wireframe_extraction::internal::find_span(m_data.knots, m_degree, u); }

  // The number of the period in which u is. The end of the range belongs to it.
  double turn(double u) const
  {
    if (u >= m_data.front() && u <= m_data.back())
      return 0.;
    return std::floor((u - m_data.front()) / (m_data.back() - m_data.front()));
  }

  double to_range(double u) const
  {
    if (m_is_closed)
      u -= turn(u) * (m_data.back() - m_data.front());
    return (std::min)((std::max)(u, m_data.front()), m_data.back());
  }

  Point_3 point_in_range(double u) const
  {
    // at a clamped end it is the control point itself, with no rounding at all
    if (u == m_data.front() && m_data.knots.front() == u)
      return m_control_points.front();
    if (u == m_data.back() && m_data.knots.back() == u)
      return m_control_points.back();
    Spline_vector value;
    Wireframe_extraction::internal::evaluate_on_span(m_data, span(u), u, 0, &value);
    return from_position(value);
  }

  // u0 <= u1, both in the range
  double length_between(double u0, double u1) const { return Arc_length_table(m_data, u0, u1).length(); }

  template <class PointOutputIterator>
  PointOutputIterator sample(const Arc_length_table& table, std::size_t count, PointOutputIterator out) const
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      if (i == 0 || (i + 1 == count && m_is_closed))
        *out++ = point_in_range(m_data.front());
      else if (i + 1 == count)
        *out++ = point_in_range(m_data.back());
      else
        *out++ = point_in_range(table.parameter(table.length() * (double(i) / double(count - 1))));
    }
    return out;
  }

  Closest_point project(const Spline_projector& projector, const Point_3& query) const
  {
    const Spline_vector q = to_vector(query, m_traits);
    const Spline_projector::Result result = projector(q);
    const Point_3 point = point_in_range(result.parameter);
    return Closest_point{FT(result.parameter), point, FT(norm(q - to_vector(point, m_traits)))};
  }

  std::size_t m_degree = 0;
  std::vector<FT> m_knots;
  std::vector<Point_3> m_control_points;
  std::vector<FT> m_weights;
  bool m_is_closed = false;
  GeomTraits m_traits;
  Spline_data m_data; // the same in double, converted once
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_SPLINE_CURVE_3_H
