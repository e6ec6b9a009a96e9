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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACED_NETWORK_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACED_NETWORK_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/fit/Spline_network_fit.h>
#include <CGAL/Wireframe_extraction/internal/network/Bend_sharpener.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_end_joiner.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_evidence.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_tracer.h>
#include <CGAL/Wireframe_extraction/internal/network/Field_explanation.h>
#include <CGAL/Wireframe_extraction/internal/network/Fold_evidence.h>
#include <CGAL/Wireframe_extraction/internal/network/Joint_fit.h>
#include <CGAL/Wireframe_extraction/internal/network/Missing_edge_folds.h>
#include <CGAL/Wireframe_extraction/internal/network/Tracing_options.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Contraction.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Traces curves from the seeds, best first, and joins them to a network.
class Traced_network
{
  const Field_band &m_band, &m_surroundings;
  const Contraction& m_contraction;
  const Extraction_options& m_options;
  Tracing_options m_tracing;
  Joining_options m_joining;

public:
  // `surroundings` may be empty: then the surface says nothing
  Traced_network(const Field_band& band, const Field_band& surroundings, const Contraction& contraction,
                 const Extraction_options& options)
    : m_band(band), m_surroundings(surroundings), m_contraction(contraction), m_options(options)
  {
    m_tracing.noise = contraction.noise;
    m_tracing.radius = options.fitting_radius;
    m_joining.noise = contraction.noise;
    m_joining.reach = options.corner_reach;
    m_joining.maximum_bridge = options.maximum_gap;
    m_joining.smooth_turn = options.smooth_angle * CGAL_PI / 180.;
  }

  // after cancelling, what was found so far
  Curve_network run(std::vector<std::size_t> seeds, Progress& progress) const
  {
    Curve_network network(trace(std::move(seeds), progress));
    double share = share_of_traces;
    for (int pass = 0; pass < number_of_passes && progress.reach(share); ++pass)
    {
      network = join(network, pass > 0, progress);
      // smooth curves know better where they lead than traces do
      smooth(network, progress, share, share + share_of_pass);
      share += share_of_pass;
    }
    return join(network, true, progress);
  }

private:
  static constexpr int number_of_passes = 2;

  // Evidence: a curve must gain the option `minimum_evidence`, and this share of it for each r of its length. Of the
  // seeds that no other curve explains, some are chance: curves from them must prove twice as much.
  static constexpr double gain_per_length = 0.35;
  static constexpr double unexplained_gain = 2., unexplained_gain_per_length = 0.7;
  // a rounded course must be better than a corner by this share of the evidence for a curve
  static constexpr double gain_of_rounding = 0.5;
  // in r: where corner and round course are compared, errors count that are too small to tell whether there is a curve
  static constexpr double sharp_tolerance = 0.06;
  // in r: around a joint, the points that judge it, and those that its curves are fitted to
  static constexpr double radius_of_joint = 4., reach_of_joint = 9.;
  // in r: edges between found nodes, which are shorter than what the tracer follows
  static constexpr double longest_edge = 10.;

  // Traces, in r: what is shorter is too short to tell from a chance agreement, the more the field errs; and what fits
  // worse than most points do (`noise` is their median) follows no curve.
  static constexpr double least_length = 3., least_length_per_noise = 5.;
  static constexpr double residual = 0.1, residual_of_seed_per_noise = 1.3, residual_per_noise = 1.6;
  // residuals below it, in r, do not make one seed better than another
  static constexpr double equal_residual = 0.02;
  // in r: a field with larger errors tells no more of a fading crease than the surface did
  static constexpr double extending_noise = 0.1;
  // Seeds from what is left: the share of the usual ball, since a curve is near; the radius in r in which points are
  // left, and how many of these are no chance.
  static constexpr double share_of_ball = 0.6, unexplained_radius = 3.;
  static constexpr std::size_t least_unexplained = 5;

  // Spurs, in r: pieces that hang on nothing, or on one side only, up to a length that grows with the noise
  static constexpr double free_spur = 4., free_spur_per_noise = 5., spur = 2., spur_per_noise = 4.;

  // in r: the ball whose points say whether a place is on a crease (about seven do), and the length from which a curve
  // stays without any
  static constexpr double crease_radius = 1.5, longest_without_crease = 25.;

  // The tips of splines: taken at most so far from the end, in r, and at most at this share of the length, since the
  // end itself is what the joiner shall judge; with a radius of at least 2.5 r, since a shorter one is noise.
  static constexpr double tip_depth = 1., tip_share = 0.3, largest_bend = 0.4;
  // squared length of the derivative by the parameter, which is about 1: below it, a bend would be out of bounds
  static constexpr double least_squared_speed = 0.25;
  // steps of half an r, and enough of them for short splines
  static constexpr double samples_per_length = 2.;
  static constexpr std::size_t least_samples = 6;
  // rounds of a fit whose splines are traced lines for the joiner, not results
  static constexpr int rounds_of_smoothing = 2;

  double least_length_of_trace() const { return least_length + least_length_per_noise * m_contraction.noise; }

  // of the time, about; the last joining takes the rest
  static constexpr double share_of_traces = 0.5, share_of_pass = 0.2;
  // a seed takes some tens of microseconds where there is nothing to trace
  static constexpr std::size_t seeds_between_questions = 64;

  double tolerance_of(std::size_t i) const { return agreement_tolerance(m_band.deviation(i, m_contraction.noise)); }

  Curve_network join(Curve_network network, bool is_smooth, Progress& progress) const
  {
    const double least_gain = m_options.minimum_evidence;
    const Curve_evidence evidence(m_band, m_contraction.noise, &progress);
    const auto prune = [&](const std::vector<const std::vector<Vector>*>& polylines) {
      return evidence.prune(polylines, least_gain, gain_per_length * least_gain);
    };
    Curve_end_joiner joiner(network, m_joining, &progress);
    const std::function<void()> steps[] = {
      [&] { joiner.prune(prune); },
      [&] { joiner.join(); },
      [&] { joiner.prune(prune); },
      [&] {
        if (m_surroundings.size() > 0)
          joiner.prune(
            [&](const std::vector<const std::vector<Vector>*>& polylines) { return folded(polylines, progress); });
      },
      [&] {
        if (is_smooth)
          round_off(joiner, network, progress);
      },
      [&] {
        if (is_smooth)
          sharpen_bends(joiner, network, evidence, progress);
      },
      [&] {
        if (is_smooth)
          add_edges(joiner, network, evidence, progress);
      },
      [&] { drop_spurs(joiner); },
      [&] {
        if (m_band.is_on_crease.empty())
          return;
        joiner.trim_free_ends([&](const Vector& p) { return is_on_crease(p); }, longest_without_crease);
        joiner.join();
        drop_spurs(joiner);
      }};
    for (const std::function<void()>& step : steps)
      if (progress.goes_on())
        step();
    return network;
  }

  void round_off(Curve_end_joiner& joiner, const Curve_network& network, Progress& progress) const
  {
    const Segment_grid grid = network.segments();
    joiner.round_off(joint_fit(grid), gain_of_rounding * m_options.minimum_evidence, progress);
  }

  void sharpen_bends(Curve_end_joiner& joiner, Curve_network& network, const Curve_evidence& evidence,
                     Progress& progress) const
  {
    const Segment_grid grid = network.segments();
    Bend_sharpener sharpener(network, m_joining, &progress);
    if (sharpener.run(joint_fit(grid), evidence, gain_of_rounding * m_options.minimum_evidence))
      joiner.join();
  }

  // makes a Joint_fit of polylines that meet at a center
  std::function<Joint_fit(const Vector& center, const std::vector<std::vector<Vector>>& polylines)> joint_fit(
    const Segment_grid& grid) const
  {
    return [this, &grid](const Vector& center, const std::vector<std::vector<Vector>>& polylines) {
      return Joint_fit(m_band, m_contraction.noise, m_options, center, radius_of_joint, reach_of_joint, sharp_tolerance,
                       grid, polylines);
    };
  }

  // after cancelling, none is worth it
  void add_edges(Curve_end_joiner& joiner, const Curve_network& network, const Curve_evidence& evidence,
                 Progress& progress) const
  {
    const double least_gain = m_options.minimum_evidence;
    std::vector<double> distances = evidence.distances(network.polylines());
    Missing_edge_folds folds(m_surroundings, m_contraction.noise, network, progress);
    joiner.add_edges_between_nodes(
      longest_edge,
      [&](const std::vector<Vector>& edge) {
        const double gain =
          evidence.gain_of(edge, distances) - least_gain - gain_per_length * least_gain * polyline_length(edge);
        return progress.is_cancelled() ? 0. : gain;
      },
      [&](const std::vector<Vector>& edge) { return folds.is_folded(edge); },
      [&](const std::vector<Vector>& edge) {
        evidence.add(edge, distances);
        folds.add(edge);
      });
  }

  void drop_spurs(Curve_end_joiner& joiner) const
  {
    joiner.drop_spurs(free_spur + free_spur_per_noise * m_contraction.noise,
                      spur + spur_per_noise * m_contraction.noise);
  }

  // Returns which of the curves the surface does not rule out. If it rules out all, the cloud is no surface with folds,
  // and the field alone counts.
  std::vector<char> folded(const std::vector<const std::vector<Vector>*>& polylines, Progress& progress) const
  {
    const std::vector<Fold_evidence::Fold> folds = Fold_evidence(m_surroundings, &progress).folds(polylines);
    std::vector<char> keep(polylines.size());
    for (std::size_t c = 0; c < polylines.size(); ++c)
      keep[c] = polylines[c] && !folds[c].is_flat_beyond_doubt();
    if (std::find(keep.begin(), keep.end(), 1) == keep.end())
      for (std::size_t c = 0; c < polylines.size(); ++c)
        keep[c] = polylines[c] != nullptr;
    return keep;
  }

  // whether most of the points near a position say so
  bool is_on_crease(const Vector& position) const
  {
    std::vector<std::size_t> found;
    m_band.search.query(position, crease_radius, found);
    std::size_t on_crease = 0, all = 0;
    for (std::size_t i : found)
      if (i < m_band.skeleton_size)
      {
        ++all;
        on_crease += m_band.is_on_crease[i] != 0;
      }
    return 2 * on_crease > all;
  }

  // Replaces the polylines by splines fitted to the field, between these shares of the work. They
  // stay after cancelling.
  void smooth(Curve_network& network, Progress& progress, double first_share, double last_share) const
  {
    std::vector<Fitted_curve> fitted;
    std::vector<std::size_t> origin;
    for (std::size_t c = 0; c < network.curves.size(); ++c)
      if (network.curves[c].is_alive)
      {
        Fitted_curve curve;
        curve.path = network.curves[c].points;
        for (int e = 0; e < 2; ++e)
          curve.vertices[e] =
            network.curves[c].nodes[e] == no_node ? Fitted_curve::no_vertex : network.curves[c].nodes[e];
        fitted.push_back(curve);
        origin.push_back(c);
      }
    if (fitted.empty())
      return;
    Extraction_options options = m_options;
    options.number_of_rounds = rounds_of_smoothing;
    Spline_network_fit fit(m_band, m_contraction.noise, options, network.nodes, fitted);
    const std::function<bool(double)> proceed = [&](double share) {
      return progress.reach(first_share + share * (last_share - first_share));
    };
    Progress progress_of_fit(proceed);
    if (!fit.run(progress_of_fit))
      return;
    network.nodes = fit.vertices();
    for (std::size_t k = 0; k < origin.size(); ++k)
      sample(fit.curves()[k].spline, network.curves[origin[k]]);
  }

  static void sample(const Cubic_spline& spline, Network_curve& curve)
  {
    const double length = spline.back() - spline.front();
    curve.points.clear();
    for (double t : spline.even_parameters(samples_per_length, least_samples))
      curve.points.push_back(spline.at(t));
    if (curve.is_closed_without_node())
    {
      curve.points.back() = curve.points.front();
      return;
    }
    const double inward = (std::min)(tip_depth, tip_share * length);
    for (int e = 0; e < 2; ++e)
    {
      const Cubic_spline::Basis basis = spline.basis(e == 0 ? spline.front() + inward : spline.back() - inward);
      const Vector d1 = spline.combine(basis, 1), d2 = spline.combine(basis, 2);
      Local_curve& tip = curve.tips[e];
      tip.point = spline.combine(basis);
      tip.tangent = (e == 0 ? -1. : 1.) * d1.normalized();
      tip.bend = (d2 - d2.dot(tip.tangent) * tip.tangent) / (std::max)(least_squared_speed, d1.squaredNorm());
      if (tip.bend.norm() > largest_bend)
        tip.bend *= largest_bend / tip.bend.norm();
      tip.move_along_to(e == 0 ? curve.points.front() : curve.points.back());
    }
  }

  std::vector<Traced_curve> trace(std::vector<std::size_t> seeds, Progress& progress) const
  {
    const std::vector<double>& residuals = m_contraction.own_residuals;
    std::sort(seeds.begin(), seeds.end(), [&](std::size_t a, std::size_t b) {
      const double ra = (std::max)(residuals[a], equal_residual), rb = (std::max)(residuals[b], equal_residual);
      return ra < rb || (ra == rb && a < b);
    });
    const double noise = m_contraction.noise;
    std::vector<Traced_curve> curves;
    Field_explanation explanation(m_band);
    Curve_tracer tracer(m_band, m_tracing, &explanation, &progress, &m_contraction);
    for (const Traced_curve& curve : m_contraction.creases)
    {
      tracer.keep(curve);
      curves.push_back(curve);
    }
    // a fading crease can be followed further in a field that is precise
    for (std::size_t c = 0; noise < extending_noise && c < curves.size() && progress.goes_on(); ++c)
      tracer.extend(curves[c], c);
    std::size_t done = 0;
    for (std::size_t i : seeds)
    {
      if (++done % seeds_between_questions == 0
          && !progress.reach(share_of_traces * double(done) / double(seeds.size())))
        break;
      if (residuals[i] > residual + residual_of_seed_per_noise * noise)
        break;
      const Local_curve& seed = m_contraction.curves[i];
      if (explanation.is_explained(i, noise)
          || std::abs(m_band.distances[i] - seed.distance(m_band.points[i])) > tolerance_of(i)
          || tracer.is_traced(seed))
        continue;
      const Traced_curve curve = tracer.trace(seed);
      if (progress.is_cancelled())
        break;
      if (curve.length() < least_length_of_trace() || curve.typical_residual() > residual + residual_per_noise * noise)
        continue;
      tracer.keep(curve);
      curves.push_back(curve);
    }
    trace_unexplained(tracer, explanation, curves, progress);
    return curves;
  }

  // Curves so close to others that no fit there was good: what the others explain is set aside now.
  void trace_unexplained(Curve_tracer& tracer, const Field_explanation& explanation, std::vector<Traced_curve>& curves,
                         Progress& progress) const
  {
    const Curve_evidence evidence(m_band, m_contraction.noise);
    Local_curve_fit fit(m_band);
    Local_fit_options fit_options;
    fit_options.radius = share_of_ball * m_options.fitting_radius;
    fit_options.scale = m_tracing.fit_scale();
    for (std::size_t i = 0; i < m_band.skeleton_size; ++i)
    {
      if (i % seeds_between_questions == 0 && !progress.goes_on())
        break;
      if (explanation.is_explained(i, m_contraction.noise))
        continue;
      std::size_t unexplained = 0;
      Local_curve seed = fit.principal_axis(m_band.points[i], unexplained_radius, [&](std::size_t j) {
        const bool is_left = !explanation.is_explained(j, m_contraction.noise);
        unexplained += is_left && j < m_band.skeleton_size;
        return is_left;
      });
      if (unexplained < least_unexplained)
        continue;
      fit.refine_from(seed, m_band.points[i], fit_options);
      seed.move_along_to(m_band.points[i]);
      if (std::abs(m_band.distances[i] - seed.distance(m_band.points[i])) > tolerance_of(i) || tracer.is_traced(seed))
        continue;
      const Traced_curve curve = tracer.trace(seed);
      if (progress.is_cancelled())
        break;
      // these seeds are worse than the others, so their curves must prove more
      const double length = curve.length();
      if (length < least_length_of_trace()
          || evidence.gain_of(curve.points, explanation.distances())
            < (unexplained_gain + unexplained_gain_per_length * length) * m_options.minimum_evidence)
        continue;
      tracer.keep(curve);
      curves.push_back(curve);
    }
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACED_NETWORK_H
