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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_EVIDENCE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_EVIDENCE_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/polyline_feet.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How much worse the field would be explained without a curve. The loss of a point is its squared residual in units
// of the tolerance, at most 1; the gain of a curve is what the losses of its points would grow by without it. After
// cancelling, curves are worth nothing, but none is pruned.
class Curve_evidence
{
  const Field_band& m_band;
  double m_noise, m_least_tolerance;
  Progress* m_progress;

  // in standard deviations of a distance: where its loss is full, 99 % of normal errors are smaller
  static constexpr double tolerance_per_deviation = 2.5;
  // Support of an edge, in r: by the points in balls that hold about three; not within half of the skeleton's width of
  // its ends, and not at all within this share of its length.
  static constexpr double radius_of_support = 1., disturbed_length = 1.5, disturbed_share = 0.4;
  static constexpr std::uint32_t none = Polyline_foot::no_curve;

  double loss(std::size_t i, double distance) const
  {
    const double tolerance = (std::max)(m_least_tolerance, tolerance_per_deviation * m_band.deviation(i, m_noise));
    const double ratio = (m_band.distances[i] - distance) / tolerance;
    return (std::min)(1., ratio * ratio);
  }

  struct Two_nearest
  {
    double first = farthest, second = farthest;
    std::uint32_t curve = none, other = none;

    void add(std::uint32_t c, double distance)
    {
      if (curve == c)
        first = (std::min)(first, distance);
      else if (distance < first)
      {
        second = first;
        other = curve;
        first = distance;
        curve = c;
      }
      else if (distance < second)
      {
        second = distance;
        other = c;
      }
    }
  };

  // Finds the feet on several polylines at the same time, and takes them in one after the other.
  void add_nearest(const std::vector<const std::vector<Vector>*>& polylines, std::size_t first, std::size_t beyond,
                   std::vector<Two_nearest>& nearest) const
  {
    struct Found
    {
      std::uint32_t point;
      double distance;
    };
    std::vector<std::vector<Found>> found(beyond - first);
    for_each_piece(
      found.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
          if (polylines[first + k] && goes_on(m_progress))
            visit_feet(m_band, first + k, *polylines[first + k], farthest,
                       [&](std::size_t i, const Polyline_foot& foot) {
                         found[k].push_back({static_cast<std::uint32_t>(i), foot.distance});
                       });
      },
      1);
    for (std::size_t k = 0; k < found.size(); ++k)
      for (const Found& foot : found[k])
        nearest[foot.point].add(static_cast<std::uint32_t>(first + k), foot.distance);
  }

public:
  // in sampling distances: beyond it, a curve is nobody's; beyond the band's points and their tolerance
  static constexpr double farthest = 4.;
  // in r: distances of an exact field differ by as much from those to a polyline whose points are r apart
  static constexpr double default_tolerance = 0.2;

  struct Scores
  {
    std::vector<double> gains; // per curve
    // the curves that would take over points from it, or it from them: their gains hang on its being there
    std::vector<std::vector<std::size_t>> neighbors;
  };

  Curve_evidence(const Field_band& band, double noise, Progress* progress = nullptr,
                 double least_tolerance = default_tolerance)
    : m_band(band), m_noise(noise), m_least_tolerance(least_tolerance), m_progress(progress)
  {}

  // polylines[c] may be null: no such curve
  Scores scores(const std::vector<const std::vector<Vector>*>& polylines) const
  {
    std::vector<Two_nearest> nearest(m_band.size());
    const std::size_t at_once = 4 * concurrency();
    for (std::size_t first = 0; first < polylines.size() && goes_on(m_progress); first += at_once)
      add_nearest(polylines, first, (std::min)(polylines.size(), first + at_once), nearest);
    Scores result;
    result.gains.assign(polylines.size(), 0.);
    result.neighbors.resize(polylines.size());
    for (std::size_t i = 0; i < m_band.size(); ++i)
    {
      const Two_nearest& of_point = nearest[i];
      if (of_point.curve == none)
        continue;
      const double without = loss(i, of_point.second);
      result.gains[of_point.curve] += without - loss(i, of_point.first);
      if (of_point.other != none && without < 1.)
      {
        result.neighbors[of_point.curve].push_back(of_point.other);
        result.neighbors[of_point.other].push_back(of_point.curve);
      }
    }
    for (std::vector<std::size_t>& neighbors : result.neighbors)
    {
      std::sort(neighbors.begin(), neighbors.end());
      neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    }
    return result;
  }

  // of every point of the band to the nearest polyline, at most `farthest`
  std::vector<double> distances(const std::vector<const std::vector<Vector>*>& polylines) const
  {
    std::vector<double> result(m_band.size(), farthest);
    for (const std::vector<Vector>* polyline : polylines)
      if (polyline && goes_on(m_progress))
        add(*polyline, result);
    return result;
  }

  // lowers the distances to those with one more polyline
  void add(const std::vector<Vector>& polyline, std::vector<double>& distances) const
  {
    visit_feet(m_band, 0, polyline, farthest, [&](std::size_t i, const Polyline_foot& foot) {
      distances[i] = (std::min)(distances[i], foot.distance);
    });
  }

  // how much better the field would be explained with one more polyline; `others` are the distances without it
  double gain_of(const std::vector<Vector>& polyline, const std::vector<double>& others) const
  {
    if (!goes_on(m_progress))
      return 0.;
    // a point has a foot on every run of segments
    std::map<std::size_t, double> nearest;
    visit_feet(m_band, 0, polyline, farthest, [&](std::size_t i, const Polyline_foot& foot) {
      const auto known = nearest.emplace(i, foot.distance).first;
      known->second = (std::min)(known->second, foot.distance);
    });
    double gain = 0.;
    for (const auto& point : nearest)
      gain += loss(point.first, others[point.first]) - loss(point.first, (std::min)(others[point.first], point.second));
    return gain;
  }

  // the loss of the points around `center` if there were only these polylines
  double loss_around(const Vector& center, double radius,
                     const std::vector<const std::vector<Vector>*>& polylines) const
  {
    std::vector<std::pair<Vector, Vector>> segments; // that may matter
    for (const std::vector<Vector>* polyline : polylines)
      for (std::size_t k = 1; k < polyline->size(); ++k)
        if (squared_distance_to_segment(center, (*polyline)[k - 1], (*polyline)[k]) < CGAL::square(radius + farthest))
          segments.emplace_back((*polyline)[k - 1], (*polyline)[k]);
    std::vector<std::size_t> ball;
    m_band.search.query(center, radius, ball);
    double sum = 0.;
    for (std::size_t i : ball)
    {
      double nearest = farthest * farthest;
      for (const auto& segment : segments)
        nearest = (std::min)(nearest, squared_distance_to_segment(m_band.points[i], segment.first, segment.second));
      sum += loss(i, std::sqrt(nearest));
    }
    return sum;
  }

  // The share of the places along a straight edge that have a point near which agrees with its distance. Places near
  // the ends do not count, since the points there are other curves'.
  double support(const std::vector<Vector>& edge) const
  {
    const double disturbed = (std::min)(disturbed_length, disturbed_share * (edge.back() - edge.front()).norm());
    std::vector<std::size_t> ball;
    std::size_t places = 0, supported = 0;
    for (const Vector& place : edge)
    {
      if ((place - edge.front()).norm() < disturbed || (place - edge.back()).norm() < disturbed)
        continue;
      m_band.search.query(place, radius_of_support, ball);
      ++places;
      supported += std::any_of(ball.begin(), ball.end(), [&](std::size_t i) {
        const double distance = std::sqrt(squared_distance_to_segment(m_band.points[i], edge.front(), edge.back()));
        return std::abs(m_band.distances[i] - distance) < agreement_tolerance(m_band.deviation(i, m_noise));
      });
    }
    return places > 0 ? double(supported) / double(places) : 0.;
  }

  // Returns which of the curves to keep: without the others, worst first, the field is explained about as well. Of
  // curves that are worth the same, the last one is first to go.
  std::vector<char> prune(std::vector<const std::vector<Vector>*> polylines, double least_gain,
                          double least_gain_per_length) const
  {
    std::vector<char> keep(polylines.size());
    for (std::size_t c = 0; c < polylines.size(); ++c)
      keep[c] = polylines[c] != nullptr;
    for (bool changed = true; changed;)
    {
      changed = false;
      const Scores all = scores(polylines);
      if (m_progress && m_progress->is_cancelled())
        return keep;
      std::vector<double> worth(polylines.size(), 0.);
      std::vector<std::size_t> order;
      for (std::size_t c = 0; c < polylines.size(); ++c)
        if (keep[c])
        {
          worth[c] = all.gains[c] - least_gain - least_gain_per_length * polyline_length(*polylines[c]);
          if (worth[c] < 0.)
            order.push_back(c);
        }
      std::sort(order.begin(), order.end(),
                [&](std::size_t a, std::size_t b) { return worth[a] < worth[b] || (worth[a] == worth[b] && a > b); });
      std::vector<char> is_affected(polylines.size(), 0);
      for (std::size_t c : order)
      {
        if (is_affected[c])
          continue;
        keep[c] = 0;
        polylines[c] = nullptr;
        changed = true;
        for (std::size_t other : all.neighbors[c])
          is_affected[other] = 1;
      }
    }
    return keep;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_EVIDENCE_H
