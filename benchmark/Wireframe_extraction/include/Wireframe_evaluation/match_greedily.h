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

#ifndef WIREFRAME_EVALUATION_MATCH_GREEDILY_H
#define WIREFRAME_EVALUATION_MATCH_GREEDILY_H

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace Wireframe_evaluation {

typedef std::pair<std::size_t, std::size_t> Match; ///< index of what is true, index of what is predicted

namespace internal {

/// A pair that may be matched, and how far apart its partners are.
struct Match_candidate
{
  double distance;
  std::size_t truth, prediction;
};

} // namespace internal

/// takes the closest pair again and again, each partner once. Equally close pairs are taken in the order of
/// their indices.
inline std::vector<Match> match_greedily(std::vector<internal::Match_candidate> candidates, std::size_t number_of_true,
                                         std::size_t number_of_predicted)
{
  typedef internal::Match_candidate Candidate;
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.distance, a.truth, a.prediction) < std::tie(b.distance, b.truth, b.prediction);
  });
  std::vector<bool> is_true_taken(number_of_true, false), is_prediction_taken(number_of_predicted, false);
  std::vector<Match> result;
  for (const Candidate& c : candidates)
    if (!is_true_taken[c.truth] && !is_prediction_taken[c.prediction])
    {
      is_true_taken[c.truth] = is_prediction_taken[c.prediction] = true;
      result.emplace_back(c.truth, c.prediction);
    }
  return result;
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_MATCH_GREEDILY_H
