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

#ifndef WIREFRAME_EVALUATION_EVALUATE_WIREFRAME_H
#define WIREFRAME_EVALUATION_EVALUATE_WIREFRAME_H

#include <Wireframe_evaluation/Evaluated_curve.h>
#include <Wireframe_evaluation/Wireframe_scores.h>
#include <Wireframe_evaluation/chain_curves.h>
#include <Wireframe_evaluation/distance_scores.h>
#include <Wireframe_evaluation/match_corners.h>
#include <Wireframe_evaluation/match_curves.h>
#include <Wireframe_evaluation/read_prediction.h>
#include <Wireframe_evaluation/typed_scores.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <new>
#include <set>
#include <string>
#include <vector>

namespace Wireframe_evaluation {

/// returns the distance at which curves are to be sampled so that a result of monstrous size can be evaluated too.
inline double sampling_step(const std::vector<Evaluated_curve>& curves, double step)
{
  const double most_samples = 2e6;
  double length = 0.;
  for (const Evaluated_curve& curve : curves)
    length += curve.polyline.length();
  return (std::max)(step, length / most_samples);
}

/// returns the scores of a case without a usable result.
inline Wireframe_scores failed_scores(const True_wireframe& truth, const std::string& failure)
{
  Wireframe_scores result;
  result.failure = failure;
  result.sampling_distance = truth.sampling_distance;
  result.diagonal = diagonal(truth.curves);
  result.true_corners = truth.corners.size();
  result.true_curves = truth.curves.size();
  result.chamfer_distance = result.hausdorff_distance = result.diagonal;
  const double scaled = internal::unit_cube_scale(truth.curves) * result.diagonal;
  result.squared_chamfer_unit_cube = 2. * scaled * scaled;
  result.averaged_hausdorff_unit_cube = scaled;
  result.end_gap = Wireframe_scores::not_applicable;
  return result;
}

namespace internal {

inline std::string first_failure(const Predicted_wireframe& prediction)
{
  if (prediction.curves.empty())
    return "there is no curve";
  for (const Evaluated_curve& curve : prediction.curves)
    if (!std::isfinite(curve.polyline.length()))
      return "a curve is not finite";
  for (const Point& p : prediction.vertices)
    if (!is_finite(p))
      return "a vertex is not finite";
  return std::string();
}

inline std::vector<Point> corners(const Predicted_wireframe& prediction, const std::set<std::size_t>& vertices)
{
  if (vertices.empty())
    return prediction.corners;
  std::vector<Point> result;
  for (std::size_t vertex : vertices)
    result.push_back(prediction.vertices[vertex]);
  return result;
}

inline void score_corners(const True_wireframe& truth, const std::vector<Point>& predicted, Wireframe_scores& scores)
{
  const std::size_t matches = match_corners(truth.corners, predicted, 3. * truth.sampling_distance).size();
  scores.true_corners = truth.corners.size();
  scores.predicted_corners = predicted.size();
  scores.corner_recall = truth.corners.empty() ? 1. : double(matches) / double(truth.corners.size());
  scores.corner_precision =
    predicted.empty() ? double(truth.corners.empty()) : double(matches) / double(predicted.size());
}

inline void score_curves(const True_wireframe& truth, const std::vector<Evaluated_curve>& chains, double step,
                         Wireframe_scores& scores)
{
  const double r = truth.sampling_distance;
  const std::vector<Match> matches = match_curves(truth.curves, chains, 2. * r, step);
  scores.true_curves = truth.curves.size();
  scores.predicted_chains = chains.size();
  scores.curve_count_ratio = double(chains.size()) / double(truth.curves.size());
  scores.curve_recall = double(matches.size()) / double(truth.curves.size());
  scores.curve_precision = double(matches.size()) / double(chains.size());
  scores.curve_f1 = f1_score(scores.curve_recall, scores.curve_precision);

  const auto is_long = [r](const Evaluated_curve& curve) { return curve.polyline.length() >= 6. * r; };
  const auto all = std::count_if(truth.curves.begin(), truth.curves.end(), is_long);
  const auto found = std::count_if(matches.begin(), matches.end(),
                                   [&](const Match& match) { return is_long(truth.curves[match.first]); });
  scores.long_curve_recall = all == 0 ? 1. : double(found) / double(all);
}

inline double largest_end_gap(const Predicted_wireframe& prediction)
{
  double result = 0.;
  for (const Evaluated_curve& curve : prediction.curves)
  {
    const Point& front = curve.polyline.front();
    const Point& back = curve.polyline.back();
    if (curve.is_closed)
      result = (std::max)(result, distance(front, back));
    if (curve.source != Evaluated_curve::no_vertex)
      result = (std::max)(result, distance(front, prediction.vertices[curve.source]));
    if (curve.target != Evaluated_curve::no_vertex)
      result = (std::max)(result, distance(back, prediction.vertices[curve.target]));
  }
  return result;
}

} // namespace internal

/*!
evaluates a wireframe against the true one. A prediction that is empty or not finite has the scores of a failed case.

\pre the truth has curves, and its sampling distance is positive
*/
inline Wireframe_scores evaluate_wireframe(const True_wireframe& truth, const Predicted_wireframe& prediction)
{
  const std::string failure = internal::first_failure(prediction);
  if (!failure.empty())
    return failed_scores(truth, failure);

  Wireframe_scores result;
  const double r = truth.sampling_distance, step = sampling_step(prediction.curves, 0.1 * r);
  result.sampling_distance = r;
  result.diagonal = diagonal(truth.curves);
  result.predicted_curves = prediction.curves.size();
  internal::score_distances(truth, prediction.curves, step, result);
  const Chained_curves chained = chain_curves(prediction.curves, 0.5 * r, 20.);
  internal::score_corners(truth, internal::corners(prediction, chained.vertices), result);
  internal::score_curves(truth, chained.curves, step, result);
  const bool is_typed = std::any_of(prediction.curves.begin(), prediction.curves.end(),
                                    [](const Evaluated_curve& curve) { return curve.kind != Curve_kind::SPLINE; });
  if (is_typed && !truth.segments.empty())
    internal::Type_scorer(truth, prediction.curves, step).score(result);
  result.end_gap = internal::largest_end_gap(prediction);
  return result;
}

/// evaluates the wireframe in a file. One that cannot be read has the scores of a failed case.
inline Wireframe_scores evaluate_wireframe(const True_wireframe& truth, const std::string& path)
{
  try
  {
    return evaluate_wireframe(truth, read_prediction(path, 0.05 * truth.sampling_distance));
  }
  catch (const Format_error& error)
  {
    return failed_scores(truth, error.what());
  }
  catch (const std::bad_alloc&)
  {
    return failed_scores(truth, "takes more memory than there is");
  }
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_EVALUATE_WIREFRAME_H
