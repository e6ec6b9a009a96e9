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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CROSSINGS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CROSSINGS_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Where two curves of a network pass through one place in different directions.
struct Curve_crossing
{
  double distance; // of the curves from each other
  std::array<std::size_t, 2> curves;
  Vector place;
};

// where two segments are nearest to each other, at an infinite distance if they are nearly
// parallel, or that is at an end
inline Curve_crossing crossing_of_segments(const std::array<Vector, 2>& a, const std::array<Vector, 2>& b,
                                           const std::array<std::size_t, 2>& curves)
{
  // of the angle between them (30 degrees): others touch, or are one curve that was traced twice
  static constexpr double least_sine = 0.5;
  Curve_crossing result{(std::numeric_limits<double>::infinity)(), curves, a[0]};
  const Vector u = a[1] - a[0], v = b[1] - b[0], w = b[0] - a[0];
  const double uu = u.dot(u), vv = v.dot(v), uv = u.dot(v), determinant = uu * vv - uv * uv;
  if (!(determinant > least_sine * least_sine * uu * vv))
    return result;
  const double s = (vv * u.dot(w) - uv * v.dot(w)) / determinant;
  const double t = (uv * u.dot(w) - uu * v.dot(w)) / determinant;
  if (s < 0. || s > 1. || t < 0. || t > 1.)
    return result;
  const Vector p = a[0] + s * u, q = b[0] + t * v;
  result.distance = (p - q).norm();
  result.place = 0.5 * (p + q);
  return result;
}

// Returns the crossings of curves that are closer than `tolerance` there, and farther than `distance_to_ends` from the
// ends of both: the closest ones first, each once. Nearly linear in the number of segments. After cancelling, some are
// missing.
inline std::vector<Curve_crossing> crossings(const Curve_network& network, double tolerance, double distance_to_ends,
                                             Progress* progress = nullptr)
{
  // in r: two curves do not cross again within it
  static constexpr double least_distance = 2.;
  Segment_grid grid;
  std::vector<Curve_crossing> found;
  for (std::size_t c = 0; c < network.curves.size() && goes_on(progress); ++c)
  {
    if (!network.curves[c].is_alive)
      continue;
    const std::vector<Vector>& points = network.curves[c].points;
    for (std::size_t k = 1; k < points.size(); ++k)
    {
      const double half = 0.5 * (points[k] - points[k - 1]).norm();
      grid.visit(0.5 * (points[k - 1] + points[k]), half + tolerance, [&](const Segment_grid::Hit& hit) {
        const std::vector<Vector>& others = network.curves[hit.curve].points;
        const Curve_crossing crossing = crossing_of_segments({others[hit.segment], others[hit.segment + 1]},
                                                             {points[k - 1], points[k]}, {hit.curve, c});
        if (crossing.distance < tolerance && network.curves[c].has_inside(crossing.place, distance_to_ends)
            && network.curves[hit.curve].has_inside(crossing.place, distance_to_ends))
          found.push_back(crossing);
      });
    }
    grid.add(c, points); // only now: no curve crosses itself
  }
  std::sort(found.begin(), found.end(), [](const Curve_crossing& a, const Curve_crossing& b) {
    return std::tie(a.distance, a.curves) < std::tie(b.distance, b.curves);
  });
  std::vector<Curve_crossing> result;
  std::map<std::array<std::size_t, 2>, std::vector<Vector>> places;
  for (const Curve_crossing& crossing : found)
  {
    std::vector<Vector>& known = places[crossing.curves];
    if (std::any_of(known.begin(), known.end(),
                    [&](const Vector& place) { return (place - crossing.place).norm() < least_distance; }))
      continue;
    known.push_back(crossing.place);
    result.push_back(crossing);
  }
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CROSSINGS_H
