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
#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIELD_REFINEMENT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIELD_REFINEMENT_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Contraction.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Crease_tracer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Estimates the distances anew from the creases of the surface: the field tells where to look for a crease, the points
// of the two faces where it is. Creases are followed to where the field does not see them; where it wants one but the
// surface is flat, it is not believed.
class Field_refinement
{
  const Field_band& m_band;
  const Contraction& m_contraction;
  Crease_fit_options m_options;
  std::vector<std::size_t> m_places; // points of the skeleton at which creases are looked for
  std::vector<Vector> m_positions;   // theirs
  Ball_search m_search;              // among them
  std::vector<Crease> m_creases;     // those of the places come first
  Traced_creases m_traced, m_rejected;
  std::size_t m_number_of_traces = 0;
  std::vector<Traced_curve> m_curves; // along creases

  // Thresholds. Lengths are in sampling distances, angles in radians.

  // A crease counts if its position is known better than that, in multiples of the field's noise: else it adds nothing.
  static constexpr double good_deviation = 0.8;
  // it speaks for the points up to so far along it: beyond, the next ones do
  static constexpr double crease_length = 1.5;
  // a curve along creases goes through all of its points, so that the nearest of its creases is nearer
  static constexpr double traced_share = 0.5;
  // how far points lie from the strips to which they belong, beyond the surface's errors
  static constexpr double strip_tolerance = 0.2;
  // by how much of itself a distance errs beside the noise at the feature: regressors err more far from it
  static constexpr double relative_noise = 0.3;
  // variance of what creases say that are known better than that: they are no parabolas
  static constexpr double least_variance = 0.02;
  // Folds above are no mere effect of noise; larger ones than `clear_fold`, 29 degrees, however little is known.
  static constexpr double noise_fold = 0.05, clear_fold = 0.5;
  // distances up to which the surface may know more than the field: farther, no stage asks
  static constexpr double known_distance = 3.;
  // the new distance of points that are near no feature
  static constexpr double nowhere = 10.;
  // around a point, where creases were looked for, and how badly they may fit where the surface is flat
  static constexpr double flat_radius = 1.5, flat_residual = 0.05;
  // Of a curve along creases. Shorter ones end within the ball of the fit that they start from.
  static constexpr double least_length = 3.;
  // the share of it with which the field must agree: what it denies for the most part is no feature
  static constexpr double least_support = 0.3;
  // seeds that are followed at the same time lie that far apart, most of them on different curves
  static constexpr double far_apart = 30.;
  // The surface's noise is measured from so many fits, twice, since they need it themselves; points are never better.
  static constexpr std::size_t most_noise_fits = 500;
  static constexpr double first_surface_noise = 0.1, least_surface_noise = 0.01;
  // Feet closer than this many times the surface's noise show the same crease, and the farthest that may.
  static constexpr double largest_spacing = 0.7;
  static constexpr double least_cosine = 0.9; // of 26 degrees, between curves that may be the same

  struct Average
  {
    double sum = 0., total = 0., squares = 0., count = 0.;

    void add(double value, double deviation, double weight)
    {
      sum += weight * value;
      total += weight;
      squares += weight * weight * deviation * deviation;
      count += 1.;
    }
    double mean() const { return sum / total; }
    // neighboring creases rest on the same points
    double deviation() const { return std::sqrt(squares * count) / total; }
  };

public:
  Field_refinement(const Field_band& band, const Contraction& contraction, double radius)
    : m_band(band), m_contraction(contraction)
  {
    m_options.radius = radius;
    m_options.field_noise = (std::max)(Contraction::least_noise, contraction.noise);
  }

  // `proceed(share)` returns whether to go on; this returns whether it did
  template <class Proceed>
  bool run(const Proceed& proceed)
  {
    estimate_surface_noise();
    choose_places();
    return fit_creases([&](double share) { return proceed(0.5 * share); })
      && trace_creases([&](double share) { return proceed(0.5 + 0.5 * share); });
  }

  double surface_noise() const { return m_options.surface_noise; }
  const std::vector<Traced_curve>& curves() const { return m_curves; }

  // how many curves were followed, also in vain
  std::size_t number_of_traces() const { return m_number_of_traces; }

  // standard deviation of the new distances, where creases are good
  double typical_deviation() const
  {
    std::vector<double> deviations;
    for (const Crease& crease : m_creases)
      if (is_good(crease))
        deviations.push_back(crease.deviation);
    return median(deviations);
  }

  // of every point of the band, and their standard deviations; returns whether it was not cancelled
  template <class Proceed>
  bool compute_distances(const Proceed& proceed, std::vector<double>& distances, std::vector<double>& deviations,
                         std::vector<char>& is_on_crease) const
  {
    std::vector<Vector> feet;
    std::vector<std::size_t> good;
    for (std::size_t i = 0; i < m_creases.size(); ++i)
      if (is_good(m_creases[i]))
      {
        good.push_back(i);
        feet.push_back(m_creases[i].curve.point);
      }
    distances.resize(m_band.size());
    deviations.resize(m_band.size());
    is_on_crease.resize(m_band.size());
    const Ball_search search(feet);
    const std::vector<std::size_t> order = m_band.search.spatial_order();
    return for_each_piece_or_cancel(
      order.size(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<std::size_t> found;
        for (std::size_t n = begin; n < end; ++n)
        {
          const std::size_t i = order[n];
          search.query(m_band.points[i], (std::min)(known_distance, m_band.distances[i]) + crease_length, found);
          for (std::size_t& k : found)
            k = good[k];
          const Estimate estimate = estimate_at(i, found);
          distances[i] = estimate.distance;
          deviations[i] = estimate.deviation;
          is_on_crease[i] = estimate.is_on_crease;
        }
      },
      proceed);
  }

private:
  struct Estimate
  {
    double distance, deviation;
    bool is_on_crease;
  };

  // what good creases nearby say of a point of the band; `creases` is used for more
  Estimate estimate_at(std::size_t i, std::vector<std::size_t>& creases) const
  {
    const Vector& point = m_band.points[i];
    const double field = m_band.distances[i];
    Average any, strong;
    double nearest = nowhere, deviation_of_nearest = 0.;
    bool is_on_crease = false;
    for (std::size_t k : creases)
    {
      const Crease& crease = m_creases[k];
      const double s = crease.curve.parameter(point) / crease_length;
      if (std::abs(s) >= 1. || !crease.holds(point, strip_tolerance + exceeded_by_one_in_370 * m_options.surface_noise))
        continue;
      const double distance = crease.curve.distance(point);
      if (crease.is_traced && std::abs(s) < traced_share && distance < nearest)
      {
        nearest = distance;
        deviation_of_nearest = crease.deviation;
      }
      const double ratio =
        (distance - field) / (exceeded_by_one_in_370 * m_options.field_noise * (1. + relative_noise * distance));
      if (std::abs(ratio) >= 1.)
        continue;
      const double weight =
        (1. - s * s) * (1. - ratio * ratio) / (least_variance + crease.deviation * crease.deviation);
      any.add(distance, crease.deviation, weight);
      is_on_crease |= crease.fold > (std::min)(clear_fold, least_fold(crease));
      if (is_strong(crease))
        strong.add(distance, crease.deviation, weight);
    }
    is_on_crease |= strong.total > 0. || nearest < known_distance;
    if (strong.total > 0.)
      return {strong.mean(), strong.deviation(), is_on_crease};
    if (nearest < nowhere)
      return {nearest, deviation_of_nearest, is_on_crease};
    if (any.total > 0.)
      return {any.mean(), any.deviation(), is_on_crease};
    if (field < known_distance && is_flat_around(i, creases))
      return {nowhere, 0., is_on_crease};
    return {field, m_options.field_noise * (1. + relative_noise * field), is_on_crease};
  }

  bool is_good(const Crease& crease) const { return crease.deviation < good_deviation * m_options.field_noise; }

  // whether the surface has no crease where the field wants one
  bool is_flat_around(std::size_t i, std::vector<std::size_t>& found) const
  {
    m_search.query(m_band.points[i], flat_radius, found);
    std::size_t flat = 0;
    for (std::size_t k : found)
      flat += m_creases[k].fold < (std::min)(clear_fold, least_fold(m_creases[k]))
        && m_creases[k].residual < exceeded_by_one_in_22 * m_options.surface_noise + flat_residual;
    return 2 * flat > found.size();
  }

  // what is no mere effect of noise
  static double least_fold(const Crease& crease) { return noise_fold + exceeded_by_one_in_80 * crease.fold_deviation; }

  // it is there whatever the field says
  bool is_strong(const Crease& crease) const { return is_good(crease) && crease.is_sharp(); }

  // Follows strong creases, also to where the field did not show them. Several are followed at the same time, before it
  // is known whether those with better seeds will cover them: if they do, it was in vain and is done again. So the
  // curves are those that come about one after the other.
  template <class Proceed>
  bool trace_creases(const Proceed& proceed)
  {
    const std::vector<std::size_t> seeds = crease_seeds();
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < seeds.size(); begin = end)
    {
      if (!proceed(double(begin) / double(seeds.size())))
        return false;
      const std::vector<std::size_t> chosen = seeds_far_apart(seeds, begin, end);
      std::vector<Crease_path> paths(chosen.size());
      m_number_of_traces += chosen.size();
      for_each_piece(
        chosen.size(),
        [&](std::size_t first, std::size_t beyond) {
          for (std::size_t k = first; k < beyond; ++k)
            paths[k] = tracer().trace(m_creases[chosen[k]]);
        },
        1);
      Traced_creases meanwhile;
      std::size_t next = 0;
      for (std::size_t n = begin; n < end; ++n)
      {
        const bool is_chosen = next < chosen.size() && chosen[next] == seeds[n];
        const std::size_t k = next;
        next += is_chosen;
        if (is_done(m_creases[seeds[n]].curve))
          continue;
        const bool holds = is_chosen && !tracer().depends_on(meanwhile, paths[k]);
        m_number_of_traces += !holds;
        keep(holds ? std::move(paths[k]) : tracer().trace(m_creases[seeds[n]]), seeds[n], meanwhile);
      }
    }
    return true;
  }

  // whether a curve was followed there already, and kept or not
  bool is_done(const Local_curve& seed) const
  {
    const Crease_tracer tracer = this->tracer();
    return tracer.is_traced(seed) || tracer.is_along(m_rejected, seed);
  }

  Crease_tracer tracer() const { return Crease_tracer(m_band, m_options, m_traced); }

  // the creases to start from, best first
  std::vector<std::size_t> crease_seeds() const
  {
    const Crease_tracer tracer = this->tracer();
    std::vector<std::size_t> seeds;
    for (std::size_t i = 0; i < m_creases.size(); ++i)
      if (tracer.may_start(m_creases[i]))
        seeds.push_back(i);
    std::sort(seeds.begin(), seeds.end(), [&](std::size_t a, std::size_t b) {
      return std::tie(m_creases[a].deviation, a) < std::tie(m_creases[b].deviation, b);
    });
    return seeds;
  }

  // As many seeds from `begin` on as there are threads, most of which will lie on different curves; `end` is beyond
  // those that were looked at.
  std::vector<std::size_t> seeds_far_apart(const std::vector<std::size_t>& seeds, std::size_t begin,
                                           std::size_t& end) const
  {
    const std::size_t most = concurrency();
    std::vector<std::size_t> chosen;
    for (end = begin; end < seeds.size() && chosen.size() < most; ++end)
    {
      const Local_curve& seed = m_creases[seeds[end]].curve;
      const bool is_far = std::all_of(chosen.begin(), chosen.end(), [&](std::size_t i) {
        return (m_creases[i].curve.point - seed.point).norm() > far_apart;
      });
      if (is_far && !is_done(seed))
        chosen.push_back(seeds[end]);
    }
    return chosen;
  }

  void keep(const Crease_path& path, std::size_t seed, Traced_creases& meanwhile)
  {
    Crease_tracer tracer = this->tracer();
    const Traced_curve curve = tracer.curve_along(path);
    if (curve.length() < least_length)
      return; // which takes little to find out, and from another seed it may be longer
    if (tracer.share_of_support(curve.points) < least_support)
    {
      m_rejected.add(curve.points); // from other seeds along it, the same would come about
      return;
    }
    m_traced.add(curve.points);
    meanwhile.add(curve.points);
    m_curves.push_back(curve);
    m_creases[seed].is_traced = true;
    m_creases.insert(m_creases.end(), path.creases.begin(), path.creases.end());
  }

  void estimate_surface_noise()
  {
    const std::size_t count = (std::min)(most_noise_fits, m_contraction.curves.size());
    Crease_fit fit(m_band);
    m_options.surface_noise = first_surface_noise;
    for (int round = 0; round < 2; ++round)
    {
      std::vector<double> residuals;
      for (std::size_t k = 0; k < count; ++k)
      {
        const Local_curve& curve = m_contraction.curves[k * m_contraction.curves.size() / count];
        residuals.push_back(fit.fit(curve, curve.point, m_options).residual);
      }
      m_options.surface_noise = (std::max)(least_surface_noise, median(residuals));
    }
  }

  // Points whose feet are closer to one another than the surface errs show the same crease, with the same errors: one
  // of them will do, that with the best fit.
  void choose_places()
  {
    const double spacing = (std::min)(largest_spacing, exceeded_by_one_in_370 * m_options.surface_noise);
    const std::vector<Local_curve>& curves = m_contraction.curves;
    std::vector<Vector> feet;
    for (const Local_curve& curve : curves)
      feet.push_back(curve.point);
    const Ball_search search(feet);
    std::vector<std::size_t> order(curves.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::tie(m_contraction.residuals[a], a) < std::tie(m_contraction.residuals[b], b);
    });
    std::vector<char> is_covered(curves.size(), 0);
    std::vector<std::size_t> found;
    for (std::size_t i : order)
    {
      if (is_covered[i])
        continue;
      m_places.push_back(i);
      search.query(feet[i], spacing, found);
      for (std::size_t j : found)
        is_covered[j] |= std::abs(curves[i].tangent.dot(curves[j].tangent)) > least_cosine;
      is_covered[i] = 1;
    }
    std::sort(m_places.begin(), m_places.end());
    for (std::size_t i : m_places)
      m_positions.push_back(m_band.points[i]);
    m_search.build(m_positions, m_positions.size());
  }

  template <class Proceed>
  bool fit_creases(const Proceed& proceed)
  {
    m_creases.resize(m_places.size());
    const std::vector<std::size_t> order = m_search.spatial_order();
    return for_each_piece_or_cancel(
      order.size(),
      [&](std::size_t begin, std::size_t end) {
        Crease_fit fit(m_band);
        for (std::size_t n = begin; n < end; ++n)
        {
          const std::size_t k = order[n];
          m_creases[k] = fit.fit_with_best_radius(m_contraction.curves[m_places[k]], m_options);
        }
      },
      proceed);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIELD_REFINEMENT_H
