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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SEVERAL_CURVES_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SEVERAL_CURVES_FIT_H

#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve_fit.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/distinct_curves.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/local_curve_step.h>

#include <CGAL/number_type_basic.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A local model of the field near a place: one to four curves, each point explained by the nearest. Which curves, and
// how many, is chosen from those that fits at neighbours have found, and told by the description length (BIC).
class Several_curves_fit
{
public:
  struct Result
  {
    std::vector<Local_curve> curves;
    std::size_t own = 0;  // the nearest
    double residual = 1.; // of the field close to the foot
  };

private:
  const Field_band& m_band;
  double m_noise;
  Local_curve_fit m_fit;
  std::vector<std::size_t> m_ball;
  std::vector<Local_curve_sample> m_samples;
  std::vector<Local_curve> m_pool;
  std::vector<double> m_distances; // pool times samples
  Vector m_center;
  double m_total = 0.;

  // Lengths in r. Measured on clouds with close curves: changing any of these by a factor of 2 moves the share of feet
  // on the right curve by at most 3 %.
  static constexpr double ball_radius = 5., farthest = 3.; // of the points: beyond, fields are less reliable
  static constexpr std::size_t least_samples = 4;          // fewer do not even tell one curve
  static constexpr std::size_t most_curves = 4, most_candidates = 30;
  // residuals of candidates well beyond it count as outliers, since candidates are not refined yet
  static constexpr double scale_of_candidates = 0.3;
  static constexpr double least_gain = 1e-9; // of an exchange of candidates: less is rounding
  // the joint refinement: the scale of outliers shrinks to 1.5 deviations, within what any field and any parabola has
  static constexpr int most_rounds = 10;
  static constexpr double first_scale = 0.6, shrinking = 0.6, settled = 1e-5;
  static constexpr double least_scale = 0.1, most_scale = 0.3, scale_per_noise = 1.5;
  static constexpr double least_noise = 0.05, most_noise = 0.4; // of the description length, in r
  static constexpr double share_of_outliers = 0.1;              // spread evenly up to `farthest`
  // half of the number of parameters of a curve: position 2, direction 2, a curvature that is mostly 0
  static constexpr double parameters_of_curve = 2.5;
  // fewer independent points, or curvatures of a radius below 5 r, are unlikely
  static constexpr double least_weight = 3., bend_deviation = 0.2;

public:
  // `noise` is the standard deviation of the distances, in r
  Several_curves_fit(const Field_band& band, double noise)
    : m_band(band), m_noise((std::min)(most_noise, (std::max)(least_noise, noise))), m_fit(band)
  {}

  // `single` is the best single curve of a larger ball, `pool` curves found nearby
  Result fit(const Vector& center, const Local_curve& single, const std::vector<Local_curve>& pool)
  {
    collect(center);
    m_pool = distinct_curves(pool, center, most_candidates);
    Result result;
    result.curves = {single};
    if (m_samples.size() >= least_samples)
      choose(single, result.curves);
    for (Local_curve& curve : result.curves)
      curve.move_along_to(center);
    result.own = nearest_curve(result.curves, center).index;
    result.residual = residual(result);
    return result;
  }

private:
  void collect(const Vector& center)
  {
    m_center = center;
    m_band.search.query(center, ball_radius, m_ball);
    m_samples.clear();
    m_total = 0.;
    for (std::size_t i : m_ball)
    {
      if (m_band.distances[i] > farthest)
        continue;
      const double ratio = (m_band.points[i] - center).squaredNorm() / (ball_radius * ball_radius);
      const double weight = CGAL::square(1. - ratio) / growth_of_variance(m_band.distances[i]);
      m_samples.push_back({m_band.points[i], m_band.distances[i], m_band.deviation(i, 0.), weight,
                           (std::numeric_limits<double>::infinity)()});
      m_total += weight;
    }
  }

  void tabulate()
  {
    const std::size_t n = m_samples.size();
    m_distances.resize(m_pool.size() * n);
    for (std::size_t c = 0; c < m_pool.size(); ++c)
      for (std::size_t i = 0; i < n; ++i)
        m_distances[c * n + i] = m_pool[c].distance(m_samples[i].point);
  }

  double loss(std::size_t i, double distance) const
  {
    const double u = CGAL::square((m_samples[i].distance - distance) / scale_of_candidates);
    return m_samples[i].weight * u / (1. + u);
  }

  // what a set of candidates leaves unexplained
  double loss(const std::vector<std::size_t>& chosen) const
  {
    const std::size_t n = m_samples.size();
    double sum = 0.;
    for (std::size_t i = 0; i < n; ++i)
    {
      double nearest = (std::numeric_limits<double>::infinity)();
      for (std::size_t c : chosen)
        nearest = (std::min)(nearest, m_distances[c * n + i]);
      sum += loss(i, nearest);
    }
    return sum;
  }

  // Replaces `best` by the curves with the shortest description: first the single curve, then the best one, two, and
  // greedily more of the candidates, each number refined together.
  void choose(const Local_curve& single, std::vector<Local_curve>& best)
  {
    std::vector<Local_curve> curves = {single};
    refine(curves);
    double best_length = description_length(curves);
    best = curves;
    const double cost_of_one = cost_of_curve();
    static constexpr double fewest = 2.; // of several curves, which alone would cost as much
    if (m_pool.empty() || best_length <= fewest * cost_of_one)
      return;
    tabulate();
    std::vector<std::size_t> chosen = best_single();
    for (std::size_t k = 1; k <= most_curves && k <= m_pool.size(); ++k)
    {
      // no number of further curves can pay any more
      if (best_length <= double(k) * cost_of_one)
        return;
      if (k == 2)
        chosen = best_pair();
      else if (k > 2)
        chosen = with_one_more(chosen);
      curves.clear();
      for (std::size_t c : chosen)
        curves.push_back(m_pool[c]);
      refine(curves);
      const double length = description_length(curves);
      if (length < best_length)
      {
        best_length = length;
        best = curves;
      }
      else if (k >= 3)
        return;
    }
  }

  std::vector<std::size_t> best_single() const
  {
    std::size_t best = 0;
    double least = (std::numeric_limits<double>::infinity)();
    for (std::size_t c = 0; c < m_pool.size(); ++c)
    {
      const double l = loss(std::vector<std::size_t>{c});
      if (l < least)
      {
        least = l;
        best = c;
      }
    }
    return {best};
  }

  std::vector<std::size_t> best_pair() const
  {
    const std::size_t n = m_samples.size();
    std::size_t best[2] = {0, 1};
    double least = (std::numeric_limits<double>::infinity)();
    for (std::size_t a = 0; a < m_pool.size(); ++a)
      for (std::size_t b = a + 1; b < m_pool.size(); ++b)
      {
        double sum = 0.;
        for (std::size_t i = 0; i < n && sum < least; ++i)
          sum += loss(i, (std::min)(m_distances[a * n + i], m_distances[b * n + i]));
        if (sum < least)
        {
          least = sum;
          best[0] = a;
          best[1] = b;
        }
      }
    return {best[0], best[1]};
  }

  std::vector<std::size_t> with_one_more(std::vector<std::size_t> chosen) const
  {
    chosen.push_back(0);
    double least = (std::numeric_limits<double>::infinity)();
    for (std::size_t k = chosen.size(); k-- > 0;)
    {
      std::vector<std::size_t> trial = chosen;
      for (std::size_t c = 0; c < m_pool.size(); ++c)
      {
        trial[k] = c;
        const double l = loss(trial);
        if (l < least - least_gain)
        {
          least = l;
          chosen = trial;
        }
      }
    }
    return chosen;
  }

  // in turns: each point goes to its nearest curve, each curve takes a step on its points
  void refine(std::vector<Local_curve>& curves)
  {
    const double final_scale = (std::min)(most_scale, (std::max)(least_scale, scale_per_noise * m_noise));
    std::vector<std::vector<Local_curve_sample>> own(curves.size());
    for (int k = 0; k < most_rounds; ++k)
    {
      const double scale = (std::max)(final_scale, first_scale * std::pow(shrinking, k));
      for (std::size_t c = 0; c < curves.size(); ++c)
      {
        curves[c].move_along_to(m_center);
        own[c].clear();
      }
      for (const Local_curve_sample& sample : m_samples)
        own[nearest_curve(curves, sample.point).index].push_back(sample);
      double change = 0.;
      for (std::size_t c = 0; c < curves.size(); ++c)
        if (own[c].size() > 1)
          change = (std::max)(change, improve(curves[c], own[c], bend_deviation, scale));
      if (change < settled && scale == final_scale)
        break;
    }
  }

  struct Nearest_curve
  {
    std::size_t index = 0;
    double distance = (std::numeric_limits<double>::infinity)();
  };

  static Nearest_curve nearest_curve(const std::vector<Local_curve>& curves, const Vector& p)
  {
    Nearest_curve nearest;
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      const double distance = curves[c].distance(p);
      if (distance < nearest.distance)
        nearest = {c, distance};
    }
    return nearest;
  }

  double cost_of_curve() const { return parameters_of_curve * std::log((std::max)(least_weight, m_total)); }

  // what the points, the curvatures and the curves cost together: BIC, with a mixture of normal errors and outliers
  double description_length(const std::vector<Local_curve>& curves) const
  {
    double sum = 0.;
    for (const Local_curve_sample& sample : m_samples)
    {
      const double sigma = (std::max)(m_noise, sample.deviation);
      const double background =
        share_of_outliers / (1. - share_of_outliers) * sigma * std::sqrt(2. * CGAL_PI) / farthest;
      const double e = (sample.distance - nearest_curve(curves, sample.point).distance) / sigma;
      sum -= sample.weight * std::log((std::exp(-0.5 * e * e) + background) / (1. + background));
    }
    for (const Local_curve& curve : curves)
      sum += 0.5 * curve.bend.squaredNorm() / (bend_deviation * bend_deviation);
    return sum + double(curves.size()) * cost_of_curve();
  }

  // of the field close to the own foot, as far as it is not the other curves'
  double residual(const Result& result)
  {
    std::vector<Local_curve> others;
    for (std::size_t c = 0; c < result.curves.size(); ++c)
      if (c != result.own)
        others.push_back(result.curves[c]);
    m_fit.set_other_curves(others);
    return m_fit.residual(result.curves[result.own], result.curves[result.own].point, Local_curve_fit::residual_radius);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SEVERAL_CURVES_FIT_H
