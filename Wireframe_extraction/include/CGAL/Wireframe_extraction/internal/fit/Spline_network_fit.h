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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_SPLINE_NETWORK_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_SPLINE_NETWORK_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/fit/Cubic_spline.h>
#include <CGAL/Wireframe_extraction/internal/fit/Fitted_curve.h>
#include <CGAL/Wireframe_extraction/internal/fit/ceres_support.h>
#include <CGAL/Wireframe_extraction/internal/fit/spline_residuals.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/polyline_feet.h>

#include <Eigen/Geometry>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Fits the splines of all curves at once; the curves that meet in a vertex share it.
class Spline_network_fit
{
  struct Support
  {
    std::size_t point, curve;
    double parameter;
  };

  class Stop_on_cancel : public ceres::IterationCallback
  {
    Progress& m_progress;

  public:
    explicit Stop_on_cancel(Progress& progress) : m_progress(progress) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override
    {
      if (m_progress.goes_on())
        return ceres::SOLVER_CONTINUE;
      return ceres::SOLVER_ABORT;
    }
  };

  // Lengths are in sampling distances r, which parameters nearly are, too.

  // Initial splines: their paths are sampled at half an r, and must be met up to two standard deviations of the field,
  // and what traced points are off on an exact one; spans may be halved down to half of `shortest_span`.
  static constexpr double samples_of_path = 2.;
  static constexpr std::size_t least_samples_of_path = 16;
  static constexpr double path_tolerance = 0.1, path_tolerance_per_noise = 2., shortest_span = 2.;
  // points of a path that are closer count as one: parameters must increase
  static constexpr double least_step = 1e-9;

  // Support: splines are polylines of steps of half an r, from which the feet start; points are looked for so far
  // beyond the option `support_distance` that none is lost to the chords
  static constexpr double samples_of_spline = 2., search_margin = 1.;
  static constexpr std::size_t least_samples_of_spline = 8;

  // The scale of Cauchy's loss: 1.5 standard deviations, and what splines miss of exact fields; twice that before the
  // last round.
  static constexpr double loss_scale = 0.05, scale_per_noise = 1.5, scale_of_first_rounds = 2.;
  // weights of points: one at distance sqrt(2) counts half as much, in squares, since regressors err the more the
  // farther; and a deviation matters only where it is above this one
  static constexpr double falloff = 0.5, least_deviation = 0.03;

  // Knots: a span is bisected if the residuals of its points, none farther than `farthest_of_knots` since only these
  // tell where a curve runs, are a quarter above the others', and these are no better than the noise allows. There must
  // be enough points to say so (a span of 3 r has some 12), and the halves stay above 1.5 r.
  static constexpr double farthest_of_knots = 2., excess = 1.25, residual_margin = 0.02, residual_per_noise = 1.5;
  static constexpr std::size_t least_of_level = 8, least_of_bad_span = 12;
  static constexpr double shortest_bisected_span = 3.;
  static constexpr int samples_of_refined_span = 6; // more than the four control points of its halves need

  // Weights that hold vertices near their places: an end that no other curve holds could slip along its own curve; the
  // others are held so weakly that any point is stronger.
  static constexpr double anchor_of_free_end = 0.5, anchor = 0.02;

  // The prior on curvature grows with the noise, which is all it has to even out.
  static constexpr double roughness = 0.05, roughness_per_noise = 30.;
  // r over which the curvature is averaged: waves of the noise are about as long as a ball
  static constexpr double curvature_reach = 6.;
  static constexpr double least_cubed_speed = 0.1; // below it, a curvature would be out of bounds

  // enough for most parts; what is left, the next round starts from
  static constexpr int most_iterations = 12;
  static constexpr double function_tolerance = 1e-5;

  const Field_band& m_band;
  const Extraction_options& m_options;
  double m_noise;
  std::vector<Vector> m_vertices, m_anchors;
  std::vector<std::size_t> m_degrees;
  std::vector<Fitted_curve> m_curves;
  std::vector<Cubic_spline> m_courses; // of the curves, as they were given
  std::vector<Support> m_support;

public:
  Spline_network_fit(const Field_band& band, double noise, const Extraction_options& options,
                     std::vector<Vector> vertices, std::vector<Fitted_curve> curves)
    : m_band(band), m_options(options), m_noise(noise), m_vertices(std::move(vertices)), m_anchors(m_vertices),
      m_degrees(m_vertices.size(), 0), m_curves(std::move(curves))
  {
    for (const Fitted_curve& curve : m_curves)
      if (!curve.is_closed_without_vertex())
        for (std::size_t v : curve.vertices)
          ++m_degrees[v];
  }

  const std::vector<Vector>& vertices() const { return m_vertices; }
  const std::vector<Fitted_curve>& curves() const { return m_curves; }

  // Returns whether it was not cancelled. Otherwise the curves are as far as the fit had come, without residuals.
  bool run(Progress& progress)
  {
    for (Fitted_curve& curve : m_curves)
    {
      initialize(curve, progress);
      m_courses.push_back(curve.spline);
    }
    const int rounds = (std::max)(1, m_options.number_of_rounds);
    for (int round = 0; round < rounds; ++round)
    {
      if (!progress.reach(double(round) / rounds) || !find_support(progress))
        return false;
      if (round > 0 && m_options.adapt_knots)
        add_knots();
      // the loss narrows while the curves approach
      const double scale_of_round =
        (loss_scale + scale_per_noise * m_noise) * (round + 1 < rounds ? scale_of_first_rounds : 1.);
      if (!solve(scale_of_round, progress))
        return false;
    }
    if (!find_support(progress))
      return false;
    measure();
    return true;
  }

private:
  // positions along the path at steps of half a sampling distance, or finer where it is short
  static void resample(const std::vector<Vector>& path, const std::vector<double>& s, std::vector<double>& parameters,
                       std::vector<Vector>& positions)
  {
    const std::size_t count =
      (std::max)(least_samples_of_path, static_cast<std::size_t>(std::ceil(samples_of_path * s.back())));
    Polyline_walk walk(path, s);
    for (std::size_t j = 0; j <= count; ++j)
    {
      parameters.push_back(s.back() * double(j) / double(count));
      positions.push_back(walk.advance_to(parameters.back()));
    }
  }

  static std::vector<double> bisect(const std::vector<double>& breaks, const std::vector<char>& is_bad)
  {
    std::vector<double> finer{breaks.front()};
    for (std::size_t k = 1; k < breaks.size(); ++k)
    {
      if (is_bad[k - 1])
        finer.push_back(0.5 * (breaks[k - 1] + breaks[k]));
      finer.push_back(breaks[k]);
    }
    return finer;
  }

  static std::vector<double> uniform_breaks(double length, std::size_t spans)
  {
    std::vector<double> breaks;
    for (std::size_t k = 0; k <= spans; ++k)
      breaks.push_back(length * double(k) / double(spans));
    return breaks;
  }

  // a spline through the path, with knots where the path asks for them; after cancelling, as if it asked for none
  void initialize(Fitted_curve& curve, Progress& progress) const
  {
    // they may become breakpoints, which must increase
    const std::vector<double> s = arc_lengths(curve.path, least_step);
    std::vector<double> parameters;
    std::vector<Vector> positions;
    resample(curve.path, s, parameters, positions);
    const bool is_periodic = curve.is_closed_without_vertex();
    std::vector<double> breaks =
      m_options.adapt_knots || s.size() <= curve.least_spans() ? uniform_breaks(s.back(), curve.least_spans()) : s;
    const double tolerance = path_tolerance + path_tolerance_per_noise * m_noise;
    while (true)
    {
      curve.spline = Cubic_spline(breaks, is_periodic);
      curve.spline.interpolate(parameters, positions);
      if (!m_options.adapt_knots || !progress.goes_on())
        return;
      std::vector<double> worst(breaks.size() - 1, 0.);
      for (std::size_t i = 0; i < parameters.size(); ++i)
      {
        double& w = worst[curve.spline.span(parameters[i])];
        w = (std::max)(w, (curve.spline.at(parameters[i]) - positions[i]).norm());
      }
      std::vector<char> is_bad(worst.size(), 0);
      for (std::size_t k = 0; k < worst.size(); ++k)
        is_bad[k] = worst[k] > tolerance && breaks[k + 1] - breaks[k] > shortest_span;
      if (std::find(is_bad.begin(), is_bad.end(), 1) == is_bad.end())
        return;
      breaks = bisect(breaks, is_bad);
    }
  }

  // the points that lie near the curves, each with the nearest curve and its foot there; returns whether to go on
  bool find_support(Progress& progress)
  {
    std::vector<std::vector<Vector>> polylines(m_curves.size());
    std::vector<std::vector<double>> parameters(m_curves.size());
    for (std::size_t c = 0; c < m_curves.size(); ++c)
    {
      const Cubic_spline& spline = m_curves[c].spline;
      parameters[c] = spline.even_parameters(samples_of_spline, least_samples_of_spline);
      for (double t : parameters[c])
        polylines[c].push_back(spline.at(t));
    }
    const std::vector<Polyline_foot> feet =
      nearest_feet(m_band, pointers_to(polylines), m_options.support_distance + search_margin, &progress);
    if (!progress.goes_on())
      return false;
    m_support.clear();
    for (std::size_t i = 0; i < m_band.size(); ++i)
      if (feet[i].is_valid())
        m_support.push_back({i, feet[i].curve, 0.});
    return for_each_piece_or_cancel(
      m_support.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
        {
          Support& s = m_support[k];
          const Polyline_foot& foot = feet[s.point];
          s.parameter = m_curves[s.curve].spline.foot(m_band.points[s.point], foot.interpolate(parameters[s.curve]));
        }
      },
      [&](double) { return progress.goes_on(); });
  }

  double residual(const Support& s) const
  {
    return m_band.distances[s.point] - (m_band.points[s.point] - m_curves[s.curve].spline.at(s.parameter)).norm();
  }

  double cutoff() const { return residual_cutoff(m_noise); }

  // bisects spans whose residuals are clearly above those of the others
  void add_knots()
  {
    std::vector<std::vector<double>> squares(m_curves.size());
    std::vector<std::vector<std::size_t>> counts(m_curves.size());
    for (std::size_t c = 0; c < m_curves.size(); ++c)
    {
      squares[c].assign(m_curves[c].spline.breaks().size() - 1, 0.);
      counts[c].assign(squares[c].size(), 0);
    }
    for (const Support& s : m_support)
    {
      const double e = residual(s);
      if (std::abs(e) > cutoff() || m_band.distances[s.point] > farthest_of_knots)
        continue;
      const std::size_t k = m_curves[s.curve].spline.span(s.parameter);
      squares[s.curve][k] += e * e;
      ++counts[s.curve][k];
    }
    std::vector<double> levels;
    for (std::size_t c = 0; c < m_curves.size(); ++c)
      for (std::size_t k = 0; k < squares[c].size(); ++k)
        if (counts[c][k] >= least_of_level)
          levels.push_back(std::sqrt(squares[c][k] / double(counts[c][k])));
    const double limit =
      residual_margin + excess * (std::min)(median(levels), residual_per_noise * m_noise + residual_margin);
    for (std::size_t c = 0; c < m_curves.size(); ++c)
    {
      const Cubic_spline& spline = m_curves[c].spline;
      const std::vector<double>& breaks = spline.breaks();
      std::vector<char> is_bad(squares[c].size(), 0);
      for (std::size_t k = 0; k < is_bad.size(); ++k)
        is_bad[k] = counts[c][k] >= least_of_bad_span && std::sqrt(squares[c][k] / double(counts[c][k])) > limit
          && breaks[k + 1] - breaks[k] > shortest_bisected_span;
      if (std::find(is_bad.begin(), is_bad.end(), 1) != is_bad.end())
        refine(m_curves[c], bisect(breaks, is_bad));
    }
  }

  // the same curve over more breakpoints
  static void refine(Fitted_curve& curve, const std::vector<double>& breaks)
  {
    std::vector<double> parameters;
    std::vector<Vector> positions;
    for (std::size_t k = 1; k < breaks.size(); ++k)
      for (int j = 0; j < samples_of_refined_span; ++j)
      {
        parameters.push_back(breaks[k - 1] + (breaks[k] - breaks[k - 1]) * j / double(samples_of_refined_span));
        positions.push_back(curve.spline.at(parameters.back()));
      }
    parameters.push_back(breaks.back());
    positions.push_back(curve.spline.at(breaks.back()));
    Cubic_spline finer(breaks, curve.spline.is_periodic());
    finer.interpolate(parameters, positions);
    curve.spline = finer;
  }

  // the ends of a clamped spline are vertices, the other control points its own
  double* control(Fitted_curve& curve, std::size_t i)
  {
    if (!curve.is_closed_without_vertex())
    {
      if (i == 0)
        return m_vertices[curve.vertices[0]].data();
      if (i + 1 == curve.spline.points().size())
        return m_vertices[curve.vertices[1]].data();
    }
    return curve.spline.points()[i].data();
  }

  std::array<double*, 4> controls(Fitted_curve& curve, const Cubic_spline::Basis& basis)
  {
    return {{control(curve, basis.controls[0]), control(curve, basis.controls[1]), control(curve, basis.controls[2]),
             control(curve, basis.controls[3])}};
  }

  // Curves that share no vertex do not know of each other: their problems are solved apart, at the same time.
  bool solve(double scale, Progress& progress)
  {
    const std::vector<std::vector<std::size_t>> parts = connected_curves();
    std::vector<std::vector<std::size_t>> supports(parts.size());
    std::vector<std::size_t> part_of_curve(m_curves.size());
    for (std::size_t part = 0; part < parts.size(); ++part)
      for (std::size_t c : parts[part])
        part_of_curve[c] = part;
    for (std::size_t i = 0; i < m_support.size(); ++i)
      supports[part_of_curve[m_support[i].curve]].push_back(i);
    for_each_piece(
      parts.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t part = begin; part < end && progress.goes_on(); ++part)
          solve(parts[part], supports[part], scale, progress);
      },
      1);
    return !progress.is_cancelled();
  }

  // the parts of the network, each by its curves
  std::vector<std::vector<std::size_t>> connected_curves() const
  {
    std::vector<std::size_t> rank(m_vertices.size()), parent(m_vertices.size());
    boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      sets.make_set(v);
    for (const Fitted_curve& curve : m_curves)
      if (!curve.is_closed_without_vertex())
        sets.union_set(curve.vertices[0], curve.vertices[1]);
    std::vector<std::vector<std::size_t>> parts;
    std::vector<std::size_t> part_of_set(m_vertices.size(), Fitted_curve::no_vertex);
    for (std::size_t c = 0; c < m_curves.size(); ++c)
    {
      std::size_t part = parts.size();
      if (!m_curves[c].is_closed_without_vertex())
      {
        std::size_t& known = part_of_set[sets.find_set(m_curves[c].vertices[0])];
        if (known == Fitted_curve::no_vertex)
          known = part;
        part = known;
      }
      if (part == parts.size())
        parts.emplace_back();
      parts[part].push_back(c);
    }
    return parts;
  }

  // the vertices of some curves, each once
  std::vector<std::size_t> vertices_of(const std::vector<std::size_t>& curves) const
  {
    std::vector<std::size_t> result;
    for (std::size_t c : curves)
      if (!m_curves[c].is_closed_without_vertex())
        result.insert(result.end(), m_curves[c].vertices.begin(), m_curves[c].vertices.end());
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // the problem of some curves that share vertices with no others
  void solve(const std::vector<std::size_t>& curves, const std::vector<std::size_t>& support, double scale,
             Progress& progress)
  {
    Span_preparer spans(progress);
    ceres::Problem::Options problem_options;
    problem_options.evaluation_callback = &spans;
    ceres::Problem problem(problem_options);
    add_distances(problem, support, m_options.use_robust_loss ? scale : 0., spans);
    for (std::size_t c : curves)
      add_roughness(problem, m_curves[c]);
    const std::vector<std::size_t> vertices = vertices_of(curves);
    for (std::size_t v : vertices)
    {
      problem.AddResidualBlock(new Anchor_residual(m_anchors[v], m_degrees[v] == 1 ? anchor_of_free_end : anchor),
                               nullptr, m_vertices[v].data());
      if (!m_options.move_corners)
        problem.SetParameterBlockConstant(m_vertices[v].data());
    }
    if (problem.NumResidualBlocks() == 0)
      return;
    std::vector<Vector> kept_vertices;
    std::vector<std::vector<Vector>> kept_points;
    for (std::size_t v : vertices)
      kept_vertices.push_back(m_vertices[v]);
    for (std::size_t c : curves)
      kept_points.push_back(m_curves[c].spline.points());
    Stop_on_cancel stop(progress);
    ceres::Solver::Options options = solver_options(most_iterations, function_tolerance);
    options.callbacks.push_back(&stop);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    // cancelling leaves the last state as well
    const bool is_usable = summary.IsSolutionUsable();
    for (std::size_t k = 0; k < vertices.size(); ++k)
      if (!is_usable || has_left(m_vertices[vertices[k]], m_anchors[vertices[k]]))
        m_vertices[vertices[k]] = kept_vertices[k];
    for (std::size_t k = 0; k < curves.size(); ++k)
      take_back_strays(curves[k], kept_points[k], is_usable);
  }

  // one residual block for each span
  void add_distances(ceres::Problem& problem, const std::vector<std::size_t>& support, double scale,
                     Span_preparer& spans)
  {
    std::map<std::pair<std::size_t, std::size_t>, Span_residual*> residuals; // by curve and span
    for (std::size_t i : support)
    {
      const Support& s = m_support[i];
      const Cubic_spline& spline = m_curves[s.curve].spline;
      Span_residual*& residual = residuals[{s.curve, spline.span(s.parameter)}];
      if (!residual)
        residual = new Span_residual(scale);
      const double d = m_band.distances[s.point];
      const double worth = (least_deviation + m_noise) / (least_deviation + m_band.deviation(s.point, m_noise));
      const double weight = m_options.use_robust_loss ? worth / std::sqrt(1. + falloff * d * d) : 1.;
      residual->add(m_band.points[s.point], d, weight, spline.basis(s.parameter).values.data());
    }
    for (const auto& entry : residuals)
    {
      Fitted_curve& curve = m_curves[entry.first.first];
      const std::vector<double>& breaks = curve.spline.breaks();
      const std::size_t span = entry.first.second;
      const Cubic_spline::Basis basis = curve.spline.basis(0.5 * (breaks[span] + breaks[span + 1]));
      entry.second->set_controls(controls(curve, basis));
      spans.add(entry.second);
      add_residual(problem, entry.second, curve, basis);
    }
  }

  void add_residual(ceres::Problem& problem, ceres::CostFunction* residual, Fitted_curve& curve,
                    const Cubic_spline::Basis& basis)
  {
    const std::array<double*, 4> blocks = controls(curve, basis);
    problem.AddResidualBlock(residual, nullptr, blocks.data(), static_cast<int>(blocks.size()));
  }

  // beyond it, no point supports a curve
  double reach() const { return m_options.support_distance + search_margin; }

  // Whether a place of a curve is one that neither points nor the course that was given speak for: from both, it is
  // farther than any point that supports a curve.
  bool has_left(const Vector& now, const Vector& given) const
  {
    if ((now - given).norm() < reach())
      return false;
    std::vector<std::size_t> found;
    if (now.allFinite())
      m_band.search.query(now, reach(), found);
    return found.empty();
  }

  // the same of any place along a curve
  bool has_left(std::size_t c) const
  {
    const Cubic_spline &spline = m_curves[c].spline, &given = m_courses[c]; // over the same parameters
    const std::vector<double> parameters = spline.even_parameters(samples_of_spline, least_samples_of_spline);
    return std::any_of(parameters.begin(), parameters.end(),
                       [&](double t) { return has_left(spline.at(t), given.at(t)); });
  }

  // Where a robust loss has lost all points, nothing holds a curve any more: it goes back. The ends are at the
  // vertices.
  void take_back_strays(std::size_t c, const std::vector<Vector>& before, bool is_usable)
  {
    Fitted_curve& curve = m_curves[c];
    std::vector<Vector>& points = curve.spline.points();
    const auto end_at_vertices = [&] {
      if (curve.is_closed_without_vertex())
        return;
      points.front() = m_vertices[curve.vertices[0]];
      points.back() = m_vertices[curve.vertices[1]];
    };
    end_at_vertices();
    if (is_usable && !has_left(c))
      return;
    points = before;
    end_at_vertices();
  }

  // A prior for curves whose curvature changes slowly, the stronger the more the field errs. On an arc of curvature k
  // the third derivative is -k^2 times the first one; what differs from that is rough.
  void add_roughness(ceres::Problem& problem, Fitted_curve& curve)
  {
    const double roughness_of_curve = m_options.adapt_knots ? roughness + roughness_per_noise * m_noise : roughness;
    const std::vector<double>& breaks = curve.spline.breaks();
    const std::vector<Vector> curvatures = span_curvatures(curve.spline);
    for (std::size_t k = 1; k < breaks.size(); ++k)
    {
      const double width = breaks[k] - breaks[k - 1];
      const Vector curvature = typical_curvature(curve.spline, curvatures, k - 1);
      const Cubic_spline::Basis first = curve.spline.basis(breaks[k - 1] + 0.25 * width),
                                second = curve.spline.basis(breaks[k] - 0.25 * width),
                                middle = curve.spline.basis(0.5 * (breaks[k] + breaks[k - 1]));
      // the derivatives of short spans grow beyond bounds
      const double weight = roughness_of_curve * std::sqrt(width) * std::pow((std::min)(1., width), 2);
      std::array<double, 4> factors;
      for (int j = 0; j < 4; ++j)
        factors[j] = weight
          * ((second.values[8 + j] - first.values[8 + j]) / (0.5 * width)
             + curvature.squaredNorm() * middle.values[4 + j]);
      add_residual(problem, new Roughness_residual(factors), curve, first);
    }
  }

  // curvature times binormal, in the middle of every span
  static std::vector<Vector> span_curvatures(const Cubic_spline& spline)
  {
    std::vector<Vector> result;
    for (std::size_t k = 1; k < spline.breaks().size(); ++k)
    {
      const Cubic_spline::Basis middle = spline.basis(0.5 * (spline.breaks()[k - 1] + spline.breaks()[k]));
      const Vector d1 = spline.combine(middle, 1), d2 = spline.combine(middle, 2);
      result.push_back(d1.cross(d2) / (std::max)(least_cubed_speed, std::pow(d1.norm(), 3)));
    }
    return result;
  }

  // the mean over some sampling distances: waves cancel, arcs add up
  static Vector typical_curvature(const Cubic_spline& spline, const std::vector<Vector>& curvatures, std::size_t span)
  {
    const std::vector<double>& breaks = spline.breaks();
    const std::size_t n = curvatures.size();
    const double period = spline.is_periodic() ? spline.back() - spline.front() : 0.;
    const auto middle = [&](std::size_t k) { return 0.5 * (breaks[k] + breaks[k + 1]); };
    double total = breaks[span + 1] - breaks[span];
    Vector sum = total * curvatures[span];
    for (const bool is_forward : {false, true})
    {
      const std::size_t most = spline.is_periodic() ? (n - 1) / 2 : is_forward ? n - 1 - span : span;
      for (std::size_t step = 1; step <= most; ++step)
      {
        const std::size_t k = (is_forward ? span + step : span + n - step) % n;
        double distance = is_forward ? middle(k) - middle(span) : middle(span) - middle(k);
        if (distance < 0.)
          distance += period;
        if (distance > curvature_reach)
          break;
        sum += (breaks[k + 1] - breaks[k]) * curvatures[k];
        total += breaks[k + 1] - breaks[k];
      }
    }
    return sum / total;
  }

  void measure()
  {
    std::vector<double> squares(m_curves.size(), 0.);
    for (const Support& s : m_support)
    {
      const double e = std::abs(residual(s));
      if (e > cutoff())
        continue;
      Fitted_curve& curve = m_curves[s.curve];
      squares[s.curve] += e * e;
      curve.maximum_deviation = (std::max)(curve.maximum_deviation, e);
      ++curve.support;
    }
    for (std::size_t c = 0; c < m_curves.size(); ++c)
      if (m_curves[c].support > 0)
        m_curves[c].root_mean_square = std::sqrt(squares[c] / double(m_curves[c].support));
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_SPLINE_NETWORK_FIT_H
