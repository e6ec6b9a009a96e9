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
#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CREASE_TRACER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CREASE_TRACER_H

#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Crease_fit.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Following.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Traced_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/fronts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Creases along a curve, one after the other; their tangents point forward.
struct Crease_path
{
  std::vector<Crease> creases;
  std::vector<Local_curve> fronts; // where it was asked whether the curve is traced already
  bool is_closed = false;
};

// The curves along creases that were kept: no later one is traced along them.
class Traced_creases
{
  Segment_grid m_segments;
  std::size_t m_size = 0;

public:
  void add(const std::vector<Vector>& polyline) { m_segments.add(m_size++, polyline); }

  // whether one of them runs along a front
  bool hold(const Local_curve& front, double reach) const { return m_size > 0 && runs_along(m_segments, front, reach); }
};

// Follows creases of the surface, from one that the field asked for, step by step as far as the surface is folded.
class Crease_tracer
{
  const Field_band& m_band;
  Crease_fit_options m_options;
  double m_field_noise;
  const Traced_creases& m_traced;
  Crease_fit m_fit;
  std::vector<std::size_t> m_ball;

  // Thresholds. Lengths are in sampling distances, angles in radians.

  static constexpr double step = Following::step;
  // Without a crease, then the curve ends: three steps, for the ball of a fit reaches that far beyond a bad place.
  static constexpr double longest_miss = 1.6;
  // On a crease which the field does not see: a regressor may miss a whole edge. A choice, not measured.
  static constexpr double longest_gap = 40.;
  // steps of the path that are no news to the front: 4 r, the radius of a fit
  static constexpr std::size_t trail = 8;
  // Two curves closer than that, and than the surface errs, are one: hardly a point lies between them.
  static constexpr double least_reach = 0.4;
  // how well a crease must be known to start from, in multiples of the field's noise: it must know more than the field
  static constexpr double start_deviation = 0.8, least_start_deviation = 0.03;
  // less is asked of what a crease leads to, which says where to look
  static constexpr double next_deviation = 1.3, least_next_deviation = 0.05, least_next_fold = 0.3;
  // A fold that shrinks faster than that from one step to the next is another one, or noise.
  static constexpr double least_fold_ratio = 0.6;
  // how far the next crease may be from where it was expected, beyond what both are known to
  static constexpr double farthest_from_expected = 0.2;
  // Cosines between the next tangent and what was expected (18 degrees), and the last one (22 degrees): a curve with a
  // radius of 1.7 r turns by as much within a step.
  static constexpr double least_cosine_to_expected = 0.95, least_cosine_to_last = 0.93;
  static constexpr double largest_bend = 0.6; // per r, the same radius
  // points around a crease, and the share of them that must lie on its strips, up to the surface's errors
  static constexpr double holding_radius = 1.3, holding_tolerance = 0.1, least_held = 0.7;
  // A closed curve comes back to where it began up to this and the surface's errors.
  static constexpr double closing_tolerance = 0.3;
  // of the distances, in fits: so much that they do not count
  static constexpr double ignored_field_noise = 100.;

public:
  // `options.field_noise` is the noise of the field, which only decides where the field agrees
  Crease_tracer(const Field_band& band, const Crease_fit_options& options, const Traced_creases& traced)
    : m_band(band), m_options(options), m_field_noise(options.field_noise), m_traced(traced), m_fit(band)
  {
    m_options.field_noise = ignored_field_noise;
  }

  // its position is known well enough, and the surface is folded there whatever the field says
  bool may_start(const Crease& crease) const
  {
    return crease.deviation < (std::max)(least_start_deviation, start_deviation * m_field_noise) && crease.is_sharp();
  }

  // less is asked of what a crease leads to
  bool goes_on(const Crease& crease) const
  {
    return crease.deviation < (std::max)(least_next_deviation, next_deviation * m_field_noise)
      && crease.fold > (std::max)(least_next_fold, exceeded_by_one_in_80 * crease.fold_deviation);
  }

  bool is_traced(const Local_curve& front) const { return is_along(m_traced, front); }

  // whether one of some curves is the one that a front is on
  bool is_along(const Traced_creases& curves, const Local_curve& front) const { return curves.hold(front, reach()); }

  // whether a path would be another if some more curves had been kept before
  bool depends_on(const Traced_creases& more, const Crease_path& path) const
  {
    return std::any_of(path.fronts.begin(), path.fronts.end(),
                       [&](const Local_curve& front) { return is_along(more, front); });
  }

  Crease_path trace(const Crease& seed)
  {
    Crease_path path;
    std::vector<Crease> forward, backward;
    Segment_grid own;
    path.is_closed = follow(seed, own, forward, path.fronts);
    if (!path.is_closed)
    {
      Crease reversed = seed;
      reversed.curve.tangent = -seed.curve.tangent;
      for (std::size_t k = trail; k < forward.size(); ++k)
        own.add(0, {forward[k - 1].curve.point, forward[k].curve.point});
      follow(reversed, own, backward, path.fronts);
    }
    for (auto it = backward.rbegin(); it != backward.rend(); ++it)
    {
      path.creases.push_back(*it);
      path.creases.back().curve.tangent = -it->curve.tangent;
    }
    path.creases.push_back(seed);
    path.creases.insert(path.creases.end(), forward.begin(), forward.end());
    return path;
  }

  Traced_curve curve_along(const Crease_path& path) const
  {
    Traced_curve curve;
    curve.is_closed = path.is_closed;
    for (const Crease& crease : path.creases)
      curve.points.push_back(crease.curve.point);
    curve.tips[0] = path.creases.front().curve;
    curve.tips[0].tangent = -curve.tips[0].tangent;
    curve.tips[1] = path.creases.back().curve;
    if (path.is_closed)
      curve.points.push_back(curve.points.front());
    curve.residuals.assign(curve.points.size(), m_options.surface_noise);
    return curve;
  }

  // share of the points along a curve where the field agrees with it
  double share_of_support(const std::vector<Vector>& points)
  {
    std::size_t supported = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k)
    {
      Local_curve curve;
      curve.point = points[k];
      const Vector direction = points[k + 1] - points[k];
      if (direction.norm() > 0.)
        curve.tangent = direction.normalized();
      supported += is_supported(curve);
    }
    return points.size() < 2 ? 0. : double(supported) / double(points.size() - 1);
  }

private:
  // what runs closer to a curve is the same curve
  double reach() const { return least_reach + m_options.surface_noise; }

  // whether it came back to where it began
  bool follow(const Crease& start, Segment_grid& own, std::vector<Crease>& path, std::vector<Local_curve>& fronts)
  {
    Crease front = start; // the last one that is sure
    Local_curve predicted = start.curve;
    double miss = 0., gap = 0., length = 0.;
    std::size_t supported = 0, covered = 0, uncovered_size = 0;
    const std::size_t most = Following::most_steps(m_band.size());
    while (path.size() < most)
    {
      const Vector last = predicted.point;
      const Local_curve ahead = predicted.ahead(step);
      Crease next;
      const bool is_sure = fit_ahead(ahead, front, next);
      predicted = is_sure ? next.curve : ahead;
      length += (predicted.point - last).norm();
      fronts.push_back(predicted);
      if (is_traced(predicted) || runs_along(own, predicted, reach()))
      {
        if (covered == 0)
          uncovered_size = path.size();
        if (++covered == Following::most_covered)
        {
          path.resize(uncovered_size); // steps that were not sure added nothing to it
          return false;
        }
      }
      else
        covered = 0;
      if (!is_sure)
      {
        miss += step;
        if (miss > longest_miss)
          break;
        continue;
      }
      miss = 0.;
      path.push_back(next);
      front = next;
      if (path.size() > trail)
        own.add(0, {path[path.size() - trail - 1].curve.point, path[path.size() - trail].curve.point});
      if (is_supported(next.curve))
      {
        gap = 0.;
        supported = path.size();
      }
      else
        gap += step;
      if (gap > longest_gap)
      {
        // the field denies a crease as long as that
        path.resize(supported);
        return false;
      }
      if (length > Following::shortest_closed_curve
          && has_returned(start.curve, predicted, step,
                          closing_tolerance + exceeded_by_one_in_22 * m_options.surface_noise))
        return true;
    }
    return false;
  }

  bool fit_ahead(const Local_curve& ahead, const Crease& from, Crease& best)
  {
    best = m_fit.fit_with_best_radius(ahead, m_options, &from);
    best.curve.move_along_to(ahead.point);
    if (best.curve.bend.norm() > largest_bend)
      best.curve.bend *= largest_bend / best.curve.bend.norm();
    best.is_traced = true;
    return goes_on(best) && best.fold > least_fold_ratio * from.fold
      && (best.curve.point - ahead.point).norm()
      < farthest_from_expected + exceeded_by_one_in_22 * (best.deviation + from.deviation)
      && best.curve.tangent.dot(ahead.tangent) > least_cosine_to_expected
      && best.curve.tangent.dot(from.curve.tangent) > least_cosine_to_last && is_held(best);
  }

  // whether the points around the crease's point lie on its strips
  bool is_held(const Crease& crease)
  {
    m_band.search.query(crease.curve.point, holding_radius, m_ball);
    std::size_t held = 0;
    for (std::size_t i : m_ball)
      held += crease.holds(m_band.points[i], holding_tolerance + exceeded_by_one_in_80 * m_options.surface_noise);
    return held > 0 && held >= least_held * m_ball.size();
  }

  // whether the field agrees, near the curve's point
  bool is_supported(const Local_curve& curve)
  {
    m_band.search.query(curve.point, Following::evidence_radius, m_ball);
    double agreeing = 0., opposing = 0.;
    for (std::size_t i : m_ball)
    {
      const double distance = curve.distance(m_band.points[i]);
      const bool agrees = std::abs(m_band.distances[i] - distance) < agreement_tolerance(m_field_noise);
      (agrees ? agreeing : opposing) += 1. / (Following::evidence_softness + distance);
    }
    return agreeing > opposing;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CREASE_TRACER_H
