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

#ifndef WIREFRAME_EVALUATION_MATCH_CORNERS_H
#define WIREFRAME_EVALUATION_MATCH_CORNERS_H

#include <Wireframe_evaluation/Polyline.h>
#include <Wireframe_evaluation/match_greedily.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace Wireframe_evaluation {

/// matches true and predicted corners that are less than `tolerance` apart, greedily and one to one.
inline std::vector<Match> match_corners(const std::vector<Point>& truth, const std::vector<Point>& prediction,
                                        double tolerance)
{
  std::vector<internal::Match_candidate> candidates;
  for (std::size_t i = 0; i < truth.size(); ++i)
    for (std::size_t j = 0; j < prediction.size(); ++j)
    {
      const double d = distance(truth[i], prediction[j]);
      if (d < tolerance)
        candidates.push_back({d, i, j});
    }
  return match_greedily(std::move(candidates), truth.size(), prediction.size());
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_MATCH_CORNERS_H
