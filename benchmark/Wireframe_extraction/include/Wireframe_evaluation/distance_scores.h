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

#ifndef WIREFRAME_EVALUATION_DISTANCE_SCORES_H
#define WIREFRAME_EVALUATION_DISTANCE_SCORES_H

#include <Wireframe_evaluation/Evaluated_curve.h>
#include <Wireframe_evaluation/Polyline_distance.h>
#include <Wireframe_evaluation/Wireframe_scores.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Wireframe_evaluation {
namespace internal {

/// The distances of one side to the curves of the other one, at samples at equal arc lengths. The largest one is looked
/// for at the vertices of the polylines too, where they turn.
class One_sided_distances
{
public:
  One_sided_distances(const std::vector<Evaluated_curve>& from, const std::vector<Evaluated_curve>& to, double step)
  {
    const Polyline_distance distance_to(to);
    for (const Evaluated_curve& curve : from)
    {
      for (const Point& p : curve.polyline.sample(step))
        m_distances.push_back(distance_to(p));
      for (const Point& p : curve.polyline.points())
        m_largest = (std::max)(m_largest, distance_to(p));
    }
    m_largest = (std::max)(m_largest, *std::max_element(m_distances.begin(), m_distances.end()));
  }

  double mean() const
  {
    double sum = 0.;
    for (double d : m_distances)
      sum += d;
    return sum / static_cast<double>(m_distances.size());
  }

  double mean_square() const
  {
    double sum = 0.;
    for (double d : m_distances)
      sum += d * d;
    return sum / static_cast<double>(m_distances.size());
  }

  double largest() const { return m_largest; }

  double share_below(double bound) const
  {
    const auto count = std::count_if(m_distances.begin(), m_distances.end(), [bound](double d) { return d < bound; });
    return static_cast<double>(count) / static_cast<double>(m_distances.size());
  }

private:
  std::vector<double> m_distances;
  double m_largest = 0.;
};

/// the factor that scales the box around the curves to the cube from -1 to 1
inline double unit_cube_scale(const std::vector<Evaluated_curve>& curves)
{
  const CGAL::Bbox_3 box = bounding_box(curves);
  const double side = (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
  return side > 0. ? 2. / side : 0.;
}

inline void score_distances(const True_wireframe& truth, const std::vector<Evaluated_curve>& prediction,
                            double prediction_step, Wireframe_scores& scores)
{
  const double r = truth.sampling_distance;
  const One_sided_distances from_truth(truth.curves, prediction, 0.1 * r);
  const One_sided_distances from_prediction(prediction, truth.curves, prediction_step);
  scores.chamfer_distance = 0.5 * (from_truth.mean() + from_prediction.mean());
  scores.hausdorff_distance = (std::max)(from_truth.largest(), from_prediction.largest());
  scores.recall_at_1r = from_truth.share_below(r);
  scores.precision_at_1r = from_prediction.share_below(r);
  scores.f1_at_1r = f1_score(scores.recall_at_1r, scores.precision_at_1r);
  scores.recall_at_2r = from_truth.share_below(2. * r);
  scores.precision_at_2r = from_prediction.share_below(2. * r);
  scores.f1_at_2r = f1_score(scores.recall_at_2r, scores.precision_at_2r);
  const double scale = unit_cube_scale(truth.curves);
  scores.squared_chamfer_unit_cube = scale * scale * (from_truth.mean_square() + from_prediction.mean_square());
  scores.averaged_hausdorff_unit_cube = scale * 0.5 * (from_truth.largest() + from_prediction.largest());
}

} // namespace internal
} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_DISTANCE_SCORES_H
