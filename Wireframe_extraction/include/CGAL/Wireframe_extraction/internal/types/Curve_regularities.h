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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_REGULARITIES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_REGULARITIES_H

#include <CGAL/Wireframe_extraction/internal/types/Primitive_curve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

enum class Regularity_kind
{
  EQUAL_RADII,
  COAXIAL,
  PARALLEL,
  ORTHOGONAL
};

// What two lines or circles seem to have been designed as; the first one is the more certain of them.
struct Regularity
{
  Regularity_kind kind;
  std::array<std::size_t, 2> curves;
};

// A line or circle with the standard deviations of its parameters, in sampling distances and radians.
struct Measured_curve
{
  Primitive_curve curve;
  double position_deviation = 0., direction_deviation = 0., radius_deviation = 0.;
};

// Finds what lines and circles have in common, as closely as their parameters are known.
class Regularity_finder
{
  // No smaller difference tells two parameters apart, however certain they are, and no larger one is overlooked.
  static constexpr double least_length = 0.02, most_length = 0.3;
  static constexpr double least_angle = 0.002, most_angle = 0.05;
  static constexpr double number_of_deviations = 3.;

  const std::vector<Measured_curve>& m_curves;

public:
  explicit Regularity_finder(const std::vector<Measured_curve>& curves) : m_curves(curves) {}

  std::vector<Regularity> run() const
  {
    std::vector<Regularity> result;
    const auto is_circle = [&](std::size_t i) { return m_curves[i].curve.kind == Primitive_kind::CIRCLE; };
    const auto has_direction = [&](std::size_t i) { return m_curves[i].curve.kind != Primitive_kind::ELLIPSE; };
    group(
      Regularity_kind::EQUAL_RADII, is_circle, [&](std::size_t i) { return m_curves[i].radius_deviation; }, result);
    group(
      Regularity_kind::COAXIAL, is_circle, [&](std::size_t i) { return m_curves[i].position_deviation; }, result);
    const std::vector<std::size_t> leaders = group(
      Regularity_kind::PARALLEL, has_direction, [&](std::size_t i) { return m_curves[i].direction_deviation; }, result);
    for (std::size_t k = 1; k < leaders.size(); ++k)
      for (std::size_t j = 0; j < k; ++j)
        if (holds(Regularity_kind::ORTHOGONAL, leaders[j], leaders[k]))
          result.push_back({Regularity_kind::ORTHOGONAL, {{leaders[j], leaders[k]}}});
    return result;
  }

private:
  // The most certain curves first, each joins the first earlier one that it goes with. Returns those that joined none.
  template <class Predicate, class Deviation>
  std::vector<std::size_t> group(Regularity_kind kind, const Predicate& takes_part, const Deviation& deviation,
                                 std::vector<Regularity>& result) const
  {
    std::vector<std::size_t> order(m_curves.size()), leaders;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return deviation(i) < deviation(j); });
    for (const std::size_t i : order)
    {
      if (!takes_part(i))
        continue;
      const auto leader =
        std::find_if(leaders.begin(), leaders.end(), [&](std::size_t j) { return holds(kind, j, i); });
      if (leader == leaders.end())
        leaders.push_back(i);
      else
        result.push_back({kind, {{*leader, i}}});
    }
    return leaders;
  }

  bool holds(Regularity_kind kind, std::size_t i, std::size_t j) const
  {
    const Measured_curve &one = m_curves[i], &two = m_curves[j];
    const Vector &a = one.curve.axis, &b = two.curve.axis, offset = two.curve.center - one.curve.center;
    const double angle = bound(one.direction_deviation, two.direction_deviation, least_angle, most_angle);
    switch (kind)
    {
    case Regularity_kind::EQUAL_RADII:
      return std::abs(one.curve.major_radius - two.curve.major_radius)
        < bound(one.radius_deviation, two.radius_deviation, least_length, most_length);
    case Regularity_kind::COAXIAL:
      return a.cross(b).norm() < angle
        && (offset - offset.dot(a) * a).norm()
        < bound(one.position_deviation, two.position_deviation, least_length, most_length);
    case Regularity_kind::PARALLEL: return a.cross(b).norm() < angle;
    case Regularity_kind::ORTHOGONAL: return std::abs(a.dot(b)) < angle;
    }
    return false;
  }

  static double bound(double one, double two, double least, double most)
  {
    return (std::min)(most, (std::max)(least, number_of_deviations * std::hypot(one, two)));
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_REGULARITIES_H
