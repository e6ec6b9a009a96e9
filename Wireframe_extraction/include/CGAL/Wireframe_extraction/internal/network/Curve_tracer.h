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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_TRACER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_TRACER_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/network/Contracted_curves.h>
#include <CGAL/Wireframe_extraction/internal/network/Field_explanation.h>
#include <CGAL/Wireframe_extraction/internal/network/Tracing_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Contraction.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Following.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve_fit.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Traced_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/fronts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Follows a curve from a local fit in both directions, step by step, as long as the field agrees.
class Curve_tracer
{
  const Field_band& m_band;
  Tracing_options m_options;
  Local_curve_fit m_fit;
  Field_explanation* m_explanation; // by the curves that were kept
  Progress* m_progress;             // may stop a curve on its way
  Contracted_curves m_contracted;
  std::vector<std::size_t> m_ball;
  Segment_grid m_traced;
  std::size_t m_number_of_traced = 0;
  std::size_t m_extended = Segment_grid::no_curve; // the curve that is being extended

  static constexpr std::size_t trail = Tracing_options::trail;

public:
  enum Evidence
  {
    SUPPORT,
    NOTHING,
    ELSEWHERE, // the points there are other curves'
    CONTRADICTION
  };

  Curve_tracer(const Field_band& band, const Tracing_options& options, Field_explanation* explanation = nullptr,
               Progress* progress = nullptr, const Contraction* contraction = nullptr)
    : m_band(band), m_options(options), m_fit(band), m_explanation(explanation), m_progress(progress),
      m_contracted(band, contraction)
  {}

  Traced_curve trace(const Local_curve& seed)
  {
    Traced_curve curve;
    std::vector<Vector> forward;
    Segment_grid own; // what was traced already, but for the surroundings of the front
    curve.is_closed = follow(seed, own, forward, curve.residuals, curve.tips[1], curve.ends_in_void[1]);
    if (curve.is_closed)
    {
      curve.points.push_back(seed.point);
      curve.points.insert(curve.points.end(), forward.begin(), forward.end());
      curve.points.push_back(seed.point);
      return curve;
    }
    Local_curve reversed = seed;
    reversed.tangent = -seed.tangent;
    std::vector<Vector> backward;
    for (std::size_t k = trail; k < forward.size(); ++k)
      own.add(0, {forward[k - 1], forward[k]});
    follow(reversed, own, backward, curve.residuals, curve.tips[0], curve.ends_in_void[0]);
    curve.points.assign(backward.rbegin(), backward.rend());
    curve.points.push_back(seed.point);
    curve.points.insert(curve.points.end(), forward.begin(), forward.end());
    return curve;
  }

  // Follows the field beyond the ends of an open curve that was kept as number `index`, and keeps what it adds: that
  // explains the field, too.
  void extend(Traced_curve& curve, std::size_t index)
  {
    m_extended = index;
    for (int e = 0; e < 2 && !curve.is_closed; ++e)
    {
      std::vector<Vector> points = curve.points;
      if (e == 0)
        std::reverse(points.begin(), points.end());
      Segment_grid own;
      for (std::size_t k = 1; k + trail < points.size(); ++k)
        own.add(0, {points[k - 1], points[k]});
      std::vector<Vector> path;
      Local_curve tip;
      bool ends_in_void;
      if (follow(curve.tips[e], own, path, curve.residuals, tip, ends_in_void) || path.empty())
        continue;
      path.insert(path.begin(), points.back());
      m_traced.add(index, path);
      points.insert(points.end(), path.begin() + 1, path.end());
      if (e == 0)
        std::reverse(points.begin(), points.end());
      curve.points = points;
      curve.tips[e] = tip;
      curve.ends_in_void[e] = ends_in_void;
    }
    m_extended = Segment_grid::no_curve;
    explain_by(curve);
  }

  // no later curve is traced along this one, and what it explains does not contradict later ones
  void keep(const Traced_curve& curve)
  {
    m_traced.add(m_number_of_traced++, curve.points);
    explain_by(curve);
  }

  // whether a kept curve runs along this one
  bool is_traced(const Local_curve& front) const
  {
    return runs_along(m_traced, front, m_options.corridor(), m_extended);
  }

  // what the points around `front` say of the curve there
  Evidence evidence(const Local_curve& front)
  {
    m_band.search.query(front.point, Following::evidence_radius, m_ball);
    double agreeing = 0., opposing = 0., elsewhere = 0.;
    for (std::size_t i : m_ball)
    {
      const double s = front.parameter(m_band.points[i]);
      if (s < -Tracing_options::behind_front || s > Tracing_options::before_front)
        continue;
      const double distance = front.distance(m_band.points[i]);
      if (distance > Tracing_options::evidence_distance)
        continue;
      const double weight = 1. / (Following::evidence_softness + distance);
      const double tolerance = agreement_tolerance(m_band.deviation(i, m_options.noise));
      const double e = m_band.distances[i] - distance;
      // a point that lies nearer to another curve says nothing about this one
      if (e < 0. && std::abs(m_band.distances[i] - m_fit.distance_to_others(m_band.points[i])) < tolerance)
      {
        elsewhere += weight;
        continue;
      }
      if (e < 0. && m_explanation && std::abs(m_band.distances[i] - m_explanation->distance(i)) < tolerance)
        continue;
      if (std::abs(e) < tolerance)
        agreeing += weight;
      else
        opposing += weight;
    }
    // points that are no part of the band are far from every feature: their absence is no evidence
    if (agreeing + opposing + elsewhere == 0.)
      return NOTHING;
    if (agreeing + opposing == 0.)
      return ELSEWHERE;
    return agreeing >= opposing ? SUPPORT : CONTRADICTION;
  }

private:
  void explain_by(const Traced_curve& curve)
  {
    if (m_explanation)
      m_explanation->add(curve.points);
  }

  // returns whether the curve came back to where it began; otherwise the tip is set
  bool follow(const Local_curve& start, Segment_grid& own, std::vector<Vector>& path, std::vector<double>& residuals,
              Local_curve& tip, bool& ends_in_void)
  {
    Local_curve front = start;
    tip = front;
    ends_in_void = false;
    std::size_t supported = 0, covered = 0;
    double length = 0., gap = 0., doubt = 0., among_others = 0.;
    Local_fit_options options;
    options.radius = m_options.radius;
    options.scale = m_options.fit_scale();
    options.iterations = Tracing_options::fit_iterations;
    const std::size_t most = Following::most_steps(m_band.size());
    // a step takes some tens of microseconds
    static constexpr std::size_t steps_between_questions = 16;
    for (std::size_t steps = 0; path.size() < most; ++steps)
    {
      if (steps % steps_between_questions == 0 && !goes_on(m_progress))
        break;
      const Local_curve predicted = front.ahead(m_options.step);
      Local_curve next = predicted;
      const double residual = refine_at_front(next, predicted.point, options);
      if (next.tangent.dot(front.tangent) < std::cos(m_options.maximum_turn)
          || (next.point - predicted.point).norm()
            > Tracing_options::largest_jump * m_options.step + m_options.tolerance())
        next = predicted;
      length += (next.point - front.point).norm();
      front = next;
      if (is_traced(front) || runs_along(own, front, m_options.corridor()))
      {
        if (++covered == Following::most_covered)
        {
          // the covered steps are the other curve's
          supported = (std::min)(supported, path.size() - (std::min)(path.size(), covered - 1));
          break;
        }
      }
      else
        covered = 0;
      const Evidence found = evidence(front);
      if (found == CONTRADICTION)
      {
        doubt += m_options.step;
        if (doubt > m_options.maximum_doubt())
          break;
      }
      if (found == ELSEWHERE)
      {
        among_others += m_options.step;
        if (among_others > Tracing_options::longest_among_others)
          break;
      }
      path.push_back(front.point);
      residuals.push_back(residual);
      if (path.size() > trail)
        own.add(0, {path[path.size() - trail - 1], path[path.size() - trail]});
      if (found == SUPPORT)
      {
        tip = front;
        supported = path.size();
        gap = doubt = among_others = 0.;
      }
      else if (found == NOTHING)
      {
        gap += m_options.step;
        if (gap > m_options.maximum_gap)
        {
          ends_in_void = true;
          break;
        }
      }
      if (length > Following::shortest_closed_curve
          && has_returned(start, front, m_options.step, Tracing_options::return_distance + m_options.tolerance()))
        return true;
    }
    path.resize(supported);
    return false;
  }

  // the ball lies a little behind, where the curve is known to be
  double refine_at_front(Local_curve& front, const Vector& position, const Local_fit_options& options)
  {
    if (m_contracted.is_known())
    {
      m_fit.set_other_curves(m_contracted.others(front, m_options.corridor()));
      if (m_contracted.agree_on(front, m_options.noise))
      {
        front.move_along_to(position);
        return m_fit.residual(front, front.point, Local_curve_fit::residual_radius);
      }
    }
    const Vector back = -Tracing_options::ball_behind_front * front.tangent;
    return m_fit.refine_with_best_radius(front, options, [&](Local_curve& curve, const Local_fit_options& scaled) {
      m_fit.refine_from(curve, position + scaled.radius * back, scaled);
      curve.move_along_to(position);
    });
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_TRACER_H
