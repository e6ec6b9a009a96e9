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

#ifndef WIREFRAME_EVALUATION_MATCH_CURVES_H
#define WIREFRAME_EVALUATION_MATCH_CURVES_H

#include <Wireframe_evaluation/Evaluated_curve.h>
#include <Wireframe_evaluation/Polyline_distance.h>
#include <Wireframe_evaluation/match_greedily.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace Wireframe_evaluation {
namespace internal {

// The curves of one side, ready for many questions.
class Curve_set
{
public:
  Curve_set(const std::vector<Evaluated_curve>& curves, double step)
  {
    for (const Evaluated_curve& curve : curves)
    {
      m_samples.push_back(curve.polyline.sample(step));
      m_boxes.push_back(curve.polyline.bbox());
      m_distances.emplace_back(curve.polyline);
    }
  }

  std::size_t size() const { return m_samples.size(); }
  const std::vector<Point>& samples(std::size_t i) const { return m_samples[i]; }
  const CGAL::Bbox_3& box(std::size_t i) const { return m_boxes[i]; }
  const Polyline_distance& distances(std::size_t i) const { return m_distances[i]; }

private:
  std::vector<std::vector<Point>> m_samples;
  std::vector<CGAL::Bbox_3> m_boxes;
  std::deque<Polyline_distance> m_distances;
};

// Boxes differ by the mutual Hausdorff distance at most.
inline bool may_be_close(const CGAL::Bbox_3& a, const CGAL::Bbox_3& b, double tolerance)
{
  for (int k = 0; k < 3; ++k)
    if (std::abs((a.min)(k) - (b.min)(k)) > tolerance || std::abs((a.max)(k) - (b.max)(k)) > tolerance)
      return false;
  return true;
}

} // namespace internal

/*!
matches true and predicted curves whose mutual Hausdorff distance is below `tolerance`, greedily and one to one.

\param truth the true curves
\param prediction the predicted curves
\param tolerance the tolerance
\param step distance of the samples whose distances to the other curve are measured
*/
inline std::vector<Match> match_curves(const std::vector<Evaluated_curve>& truth,
                                       const std::vector<Evaluated_curve>& prediction, double tolerance, double step)
{
  const internal::Curve_set a(truth, step), b(prediction, step);
  std::vector<internal::Match_candidate> candidates;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      if (!internal::may_be_close(a.box(i), b.box(j), tolerance))
        continue;
      double d = b.distances(j).largest(a.samples(i), tolerance);
      if (d < tolerance)
        d = (std::max)(d, a.distances(i).largest(b.samples(j), tolerance));
      if (d < tolerance)
        candidates.push_back({d, i, j});
    }
  return match_greedily(std::move(candidates), a.size(), b.size());
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_MATCH_CURVES_H
