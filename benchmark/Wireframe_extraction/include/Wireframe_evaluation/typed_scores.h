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

#ifndef WIREFRAME_EVALUATION_TYPED_SCORES_H
#define WIREFRAME_EVALUATION_TYPED_SCORES_H

#include <Wireframe_evaluation/Evaluated_curve.h>
#include <Wireframe_evaluation/Wireframe_scores.h>
#include <Wireframe_evaluation/chain_curves.h>
#include <Wireframe_evaluation/circle_through_polyline.h>
#include <Wireframe_evaluation/match_curves.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace Wireframe_evaluation {
namespace internal {

inline double median(std::vector<double> values)
{
  if (values.empty())
    return Wireframe_scores::not_applicable;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

/// Compares the types of a prediction with those of the true segments.
class Type_scorer
{
public:
  Type_scorer(const True_wireframe& truth, const std::vector<Evaluated_curve>& prediction, double step)
    : m_r(truth.sampling_distance), m_truth(joined(with_vertices(truth.segments))), m_prediction(joined(prediction)),
      m_matches(match_curves(m_truth, m_prediction, 2. * m_r, step))
  {}

  void score(Wireframe_scores& scores) const
  {
    std::vector<bool> is_true_found(m_truth.size(), false), is_prediction_right(m_prediction.size(), false);
    std::size_t splines = 0, splines_called_primitive = 0;
    std::vector<double> radius_errors;
    for (const Match& match : m_matches)
    {
      const Evaluated_curve& a = m_truth[match.first];
      const Evaluated_curve& b = m_prediction[match.second];
      is_true_found[match.first] = is_prediction_right[match.second] = a.kind == b.kind;
      if (a.kind == Curve_kind::SPLINE)
      {
        ++splines;
        splines_called_primitive += b.kind != Curve_kind::SPLINE;
      }
      if (a.kind == Curve_kind::CIRCLE && b.kind == Curve_kind::CIRCLE && is_long(a))
        radius_errors.push_back(std::abs(radius(a) - radius(b)));
    }
    scores.typed_recall = share(m_truth, is_true_found);
    scores.typed_precision = share(m_prediction, is_prediction_right);
    scores.splines_called_primitive = splines == 0 ? 0. : double(splines_called_primitive) / double(splines);
    scores.radius_error = median(radius_errors);
  }

private:
  bool is_long(const Evaluated_curve& curve) const { return curve.polyline.length() >= 8. * m_r; }

  static double radius(const Evaluated_curve& curve)
  {
    return circle_through_polyline(curve.polyline, ends_meet(curve)).radius;
  }

  static bool ends_meet(const Evaluated_curve& curve)
  {
    const Polyline& p = curve.polyline;
    return distance(p.front(), p.back()) < 1e-6 * p.length();
  }

  // of the primitives of 8 r and longer
  double share(const std::vector<Evaluated_curve>& curves, const std::vector<bool>& is_right) const
  {
    std::size_t all = 0, right = 0;
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (curves[i].kind != Curve_kind::SPLINE && is_long(curves[i]))
      {
        ++all;
        right += is_right[i];
      }
    return all == 0 ? 1. : double(right) / double(all);
  }

  // the segments of the truth, whose ends are vertices where they are closer than 0.05 r
  std::vector<Evaluated_curve> with_vertices(std::vector<Evaluated_curve> segments) const
  {
    std::vector<Point> vertices;
    const auto vertex = [this, &vertices](const Point& p) {
      std::size_t nearest = vertices.size();
      for (std::size_t i = 0; i < vertices.size(); ++i)
        if (nearest == vertices.size() || distance(p, vertices[i]) < distance(p, vertices[nearest]))
          nearest = i;
      if (nearest == vertices.size() || !(distance(p, vertices[nearest]) < 0.05 * m_r))
      {
        nearest = vertices.size();
        vertices.push_back(p);
      }
      return nearest;
    };
    for (Evaluated_curve& segment : segments)
      if (!segment.is_closed)
      {
        segment.source = vertex(segment.polyline.front());
        segment.target = vertex(segment.polyline.back());
      }
    return segments;
  }

  // with the pieces of one line or one circle joined
  std::vector<Evaluated_curve> joined(const std::vector<Evaluated_curve>& curves) const
  {
    const auto are_same_primitive = [this](const Evaluated_curve& a, const Evaluated_curve& b) {
      if (a.kind != b.kind || (a.kind != Curve_kind::LINE && a.kind != Curve_kind::CIRCLE))
        return false;
      if (a.kind == Curve_kind::LINE)
        return true;
      const Circle c = circle_through_polyline(a.polyline, ends_meet(a));
      const Circle d = circle_through_polyline(b.polyline, ends_meet(b));
      const double tolerance = 0.5 * m_r + 0.02 * c.radius;
      return std::abs(c.radius - d.radius) < tolerance && distance(c.center, d.center) < tolerance;
    };
    return chain_curves(curves, 0.5 * m_r, 10., are_same_primitive).curves;
  }

  const double m_r;
  const std::vector<Evaluated_curve> m_truth, m_prediction;
  const std::vector<Match> m_matches;
};

} // namespace internal
} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_TYPED_SCORES_H
