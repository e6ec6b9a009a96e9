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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_COURSE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_COURSE_H

#include <CGAL/Wireframe_extraction/internal/types/Primitive_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Tells whether a piece of a line, a circle or an ellipse stays, along its whole length, with the curve that it
// replaces and so with the points of the field, which lie along that one. Sums of residuals do not: where some of many
// stations count as outliers, a curve may leave there and come back from anywhere, and the feet of points on a whole
// ellipse say nothing about the arc of it that is written.
class Primitive_course
{
  // How far a curve may be from the one that it replaces: stations are looked for up to 1 r beside that one, and they
  // are known up to their standard deviations.
  static constexpr double most_offset = 1.;
  // Where no point holds either curve both guess, the more freely the farther it is to where points do: up to a half
  // circle over the gap.
  static constexpr double offset_per_gap = 0.5;
  // Around vertices, which may have moved, and where splines cut corners.
  static constexpr double most_offset_at_vertex = 2. * Curve_stations::spacing;
  static constexpr double most_deviation = 1.;     // r, of a station: no noise level is larger
  static constexpr double sampling_step = 0.5;     // r
  static constexpr std::size_t most_samples = 256; // from one station to the next
  static constexpr double negligible_angle = 1e-6; // that of rounding, in sums of angles that are multiples of a turn

  struct Place
  {
    Vector followed;  // on the curve that is replaced
    double parameter; // of the foot of what belongs there
    double offset;    // that is allowed
  };

  const Primitive_curve& m_curve;

public:
  // Where a piece ends: a vertex, and where the spline had it.
  struct End
  {
    Vector place, followed;
  };

  explicit Primitive_course(const Primitive_curve& curve) : m_curve(curve) {}

  // between the first and the last station, or all round
  bool follows(const Station_range& stations, bool is_closed) const
  {
    const std::vector<Place> places = places_of(stations);
    double sweep = 0.;
    return stays(places, is_closed, sweep) && (!is_closed || is_turn(sweep));
  }

  // from one vertex to the other
  bool follows(const Station_range& stations, const End& source, const End& target) const
  {
    std::vector<Place> places = places_of(stations);
    places.insert(places.begin(), place_of(source, places.front()));
    places.push_back(place_of(target, places.back()));
    double sweep = 0.;
    if (!stays(places, false, sweep))
      return false;
    // the arc that is written is the one that passes the middle
    const double from = places.front().parameter, to = places.back().parameter;
    return m_curve.kind == Primitive_kind::LINE
      || std::abs(sweep - m_curve.sweep(from, stations[stations.size() / 2].position, to)) < negligible_angle;
  }

  // the same for a curve that starts and ends in one vertex
  bool follows(const Station_range& stations, const End& vertex) const
  {
    std::vector<Place> places = places_of(stations);
    places.insert(places.begin(), place_of(vertex, places.front()));
    double sweep = 0.;
    return stays(places, true, sweep) && is_turn(sweep);
  }

private:
  static bool is_turn(double sweep) { return std::abs(std::abs(sweep) - 2. * CGAL_PI) < negligible_angle; }

  std::vector<Place> places_of(const Station_range& stations) const
  {
    const std::vector<std::size_t> gaps = stations_to_support(stations);
    std::vector<Place> places;
    for (std::size_t i = 0; i < stations.size(); ++i)
    {
      const Station& station = stations[i];
      const double offset = gaps[i] == 0
        ? most_offset + std::sqrt(Misfit::cap) * (std::min)(most_deviation, station.deviation())
        : most_offset + offset_per_gap * Curve_stations::spacing * double(gaps[i]);
      places.push_back({station.followed, m_curve.parameter(station.position), offset});
    }
    return places;
  }

  Place place_of(const End& end, const Place& neighbor) const
  {
    return {end.followed, m_curve.parameter(end.place), (std::max)(most_offset_at_vertex, neighbor.offset)};
  }

  // how many stations it is from each one to the nearest that points support
  static std::vector<std::size_t> stations_to_support(const Station_range& stations)
  {
    const std::size_t n = stations.size();
    std::vector<std::size_t> gaps(n, n);
    std::size_t gap = n;
    for (std::size_t i = 0; i < n; ++i)
      gaps[i] = gap = stations[i].is_supported() ? 0 : gap + 1;
    gap = n;
    for (std::size_t i = n; i-- > 0;)
    {
      gap = stations[i].is_supported() ? 0 : gap + 1;
      gaps[i] = (std::min)(gaps[i], gap);
    }
    return gaps;
  }

  // Whether all is close to what was followed: the places of the curve, and all that lies between them.
  bool stays(const std::vector<Place>& places, bool is_closed, double& sweep) const
  {
    for (const Place& place : places)
      if (!((m_curve.at_parameter(place.parameter) - place.followed).norm() <= place.offset))
        return false;
    for (std::size_t i = is_closed ? 0 : 1; i < places.size(); ++i)
    {
      const Place &one = places[i > 0 ? i - 1 : places.size() - 1], &two = places[i];
      const double step = m_curve.step(one.parameter, two.parameter);
      if (!stays(one, two, step))
        return false;
      sweep += step;
    }
    return true;
  }

  bool stays(const Place& one, const Place& two, double step) const
  {
    const double length = std::abs(step) * (m_curve.kind == Primitive_kind::LINE ? 1. : m_curve.major_radius);
    const double offset = (std::max)(one.offset, two.offset);
    const std::size_t count =
      std::size_t((std::min)(double(most_samples), std::ceil(length / sampling_step))); // false of what is not finite
    for (std::size_t k = 1; k < count; ++k)
    {
      const Vector p = m_curve.at_parameter(one.parameter + step * double(k) / double(count));
      if (!(distance_to_segment(p, one.followed, two.followed) <= offset))
        return false;
    }
    return true;
  }

  static double distance_to_segment(const Vector& p, const Vector& a, const Vector& b)
  {
    const Vector direction = b - a;
    const double square = direction.squaredNorm();
    const double share = square > 0. ? (std::min)(1., (std::max)(0., (p - a).dot(direction) / square)) : 0.;
    return (p - a - share * direction).norm();
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_COURSE_H
