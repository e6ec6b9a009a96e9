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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_POLYLINE_FEET_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_POLYLINE_FEET_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The nearest place on a polyline.
struct Polyline_foot
{
  // 32 bits for indices: there is a foot for every point of a band
  static constexpr std::uint32_t no_curve = static_cast<std::uint32_t>(-1);

  double distance = 0.;
  double share = 0.; // of the segment that lies before the foot
  std::uint32_t curve = no_curve, segment = 0;

  bool is_valid() const { return curve != no_curve; }
  Vector point(const std::vector<Vector>& polyline) const
  {
    return polyline[segment] + share * (polyline[segment + 1] - polyline[segment]);
  }
  // of values that grow along each segment of the polyline, such as its arc lengths
  double interpolate(const std::vector<double>& values) const
  {
    return values[segment] + share * (values[segment + 1] - values[segment]);
  }
};

// Calls visitor(i, foot) for the points of a band closer than `radius` to a polyline. It goes along the polyline, run
// by run of segments, and asks the band for the points around each: a point has a foot on every run that is close
// enough.
template <class Visitor>
void visit_feet(const Field_band& band, std::size_t curve, const std::vector<Vector>& polyline, double radius,
                const Visitor& visitor)
{
  struct Segment
  {
    Vector from, direction;
    double per_square;
  };
  static constexpr double longest_run = 4.; // r, as the radius of the ball around it: longer ones hold points in vain
  static constexpr double rounding = 1e-9;
  std::vector<std::size_t> ball;
  std::vector<Segment> run;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin + 1 < polyline.size(); begin = end)
  {
    run.clear();
    double length = 0.;
    Vector low = polyline[begin], high = polyline[begin];
    for (end = begin; end + 1 < polyline.size(); ++end)
    {
      const Vector direction = polyline[end + 1] - polyline[end];
      const double square = direction.squaredNorm(), longer = length + std::sqrt(square);
      if (end > begin && longer > longest_run)
        break;
      length = longer;
      run.push_back({polyline[end], direction, square > 0. ? 1. / square : 0.});
      low = low.cwiseMin(polyline[end + 1]);
      high = high.cwiseMax(polyline[end + 1]);
    }
    // a single segment may be long
    const std::size_t pieces = 1 + static_cast<std::size_t>(length / (2. * longest_run));
    for (std::size_t piece = 0; piece < pieces; ++piece)
    {
      const double first = double(piece) / double(pieces), last = double(piece + 1) / double(pieces);
      const Vector center =
        pieces == 1 ? Vector(0.5 * (low + high)) : Vector(polyline[begin] + 0.5 * (first + last) * run[0].direction);
      const double half = pieces == 1 ? 0.5 * (high - low).norm() : 0.5 * length / double(pieces);
      band.search.query(center, radius + half + rounding, ball);
      for (std::size_t i : ball)
      {
        double best = radius * radius, share = 0.;
        std::size_t nearest = run.size();
        for (std::size_t k = 0; k < run.size(); ++k)
        {
          const Vector offset = band.points[i] - run[k].from;
          const double s = (std::min)(last, (std::max)(first, offset.dot(run[k].direction) * run[k].per_square));
          const double square = (offset - s * run[k].direction).squaredNorm();
          if (square < best)
          {
            best = square;
            share = s;
            nearest = k;
          }
        }
        if (nearest < run.size())
          visitor(i,
                  Polyline_foot{std::sqrt(best), share, static_cast<std::uint32_t>(curve),
                                static_cast<std::uint32_t>(begin + nearest)});
      }
    }
  }
}

// The nearest foot of every point of a band, on those of the polylines that are not null and closer than `radius`. Of
// feet that are equally near, that on the first polyline counts. After cancelling, some are missing.
inline std::vector<Polyline_foot> nearest_feet(const Field_band& band,
                                               const std::vector<const std::vector<Vector>*>& polylines, double radius,
                                               Progress* progress = nullptr)
{
  std::vector<Polyline_foot> feet(band.size());
  std::mutex mutex;
  for_each_piece(
    polylines.size(),
    [&](std::size_t begin, std::size_t end) {
      std::vector<std::pair<std::size_t, Polyline_foot>> found;
      for (std::size_t c = begin; c < end; ++c)
        if (polylines[c] && goes_on(progress))
          visit_feet(band, c, *polylines[c], radius,
                     [&](std::size_t i, const Polyline_foot& foot) { found.emplace_back(i, foot); });
      const std::lock_guard<std::mutex> lock(mutex);
      for (const auto& entry : found)
      {
        Polyline_foot& foot = feet[entry.first];
        if (!foot.is_valid()
            || std::tie(entry.second.distance, entry.second.curve) < std::tie(foot.distance, foot.curve))
          foot = entry.second;
      }
    },
    1);
  return feet;
}

// Whether a foot is an end of the polyline. Where that is open, points beyond it have their feet there, which say
// nothing of where the curve runs, and other curves may meet.
inline bool is_at_end(double arc_length, double length)
{
  static constexpr double rounding = 1e-6; // of sums over thousands of segments
  return arc_length < rounding || arc_length > length - rounding;
}

inline std::vector<const std::vector<Vector>*> pointers_to(const std::vector<std::vector<Vector>>& polylines)
{
  std::vector<const std::vector<Vector>*> result;
  for (const std::vector<Vector>& polyline : polylines)
    result.push_back(&polyline);
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_POLYLINE_FEET_H
