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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_VOTES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_VOTES_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_scales.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A place where a point says that the surface is folded.
struct Fold_vote
{
  Vector foot;
  bool is_strong; // whether the point is sure
};

// What the votes of all points agree on: places on the folds.
class Fold_votes
{
  // a vote counts near strong ones: as many of them within that
  static constexpr std::size_t least_strong = 3;
  static constexpr double strong_reach = 1.;
  // votes are moved across the fold to the mean of those within that
  static constexpr double smoothing_radius = 1.;
  static constexpr int smoothing_rounds = 2;

  // where folds end: the feet within that around one lie to one side of it, so far at least in the mean
  static constexpr double end_radius = 1., least_offset_at_ends = 0.25;
  // beyond an end, distances to it may be too large by as much
  static constexpr double most_excess = 0.2;

  std::vector<Vector> m_feet;
  std::vector<Vector> m_ways_on; // from the feet at which folds end, to where they would go on; 0 for the others
  Ball_search m_search;          // among the feet

public:
  Fold_votes(const std::vector<Fold_vote>& votes, const Fold_scales& scales)
  {
    keep_near_strong(votes);
    keep_confirmed(scales);
    for (int round = 0; round < smoothing_rounds; ++round)
      smooth();
    m_search = Ball_search(m_feet);
    find_ends();
  }

  const std::vector<Vector>& feet() const { return m_feet; }

  // the distance of a place to the nearest foot, or `most` if that is less; `found` is memory for the search
  double distance(const Vector& place, double most, std::vector<std::size_t>& found) const
  {
    m_search.query(place, most, found);
    double nearest = most;
    for (std::size_t j : found)
      nearest = (std::min)(nearest, (m_feet[j] - place).norm());
    return nearest;
  }

  // The same, but infinite beyond the end of a fold: most folds do not end there, but go on to a corner where too many
  // meet to be seen, so that the distance is not known.
  double known_distance(const Vector& place, double most, std::vector<std::size_t>& found) const
  {
    m_search.query(place, most, found);
    double nearest = most, ahead = 0.;
    for (std::size_t j : found)
    {
      const Vector offset = place - m_feet[j];
      const double distance = offset.norm();
      if (!(distance < nearest))
        continue;
      nearest = distance;
      ahead = (std::max)(0., offset.dot(m_ways_on[j]));
    }
    const double aside = std::sqrt((std::max)(0., nearest * nearest - ahead * ahead));
    return nearest - aside > most_excess ? (std::numeric_limits<double>::infinity)() : nearest;
  }

  // How far three of four votes lie from where all agreed that the folds are, at most, up to `smoothing_radius`. It is
  // small where folds are plain, and large where they are crowded or the points err.
  double disagreement(const std::vector<Fold_vote>& votes) const
  {
    static constexpr double quantile = 0.75; // a fourth of the votes may be wrong in any cloud
    if (votes.empty() || m_feet.empty())
      return smoothing_radius;
    std::vector<double> distances(votes.size());
    for_each_piece(votes.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> found;
      for (std::size_t i = begin; i < end; ++i)
        distances[i] = distance(votes[i].foot, smoothing_radius, found);
    });
    const auto place = distances.begin() + std::ptrdiff_t(quantile * double(distances.size() - 1));
    std::nth_element(distances.begin(), place, distances.end());
    return *place;
  }

private:
  // calls keep(found) for what is found around each of `places` among `others`, and keeps those for which it is true
  template <class Keep>
  static std::vector<Vector> kept(const std::vector<Vector>& places, const std::vector<Vector>& others, double radius,
                                  const Keep& keep)
  {
    const Ball_search search(others);
    std::vector<char> is_kept(places.size());
    for_each_piece(places.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        search.query(places[i], radius, found);
        is_kept[i] = keep(found.size());
      }
    });
    std::vector<Vector> result;
    for (std::size_t i = 0; i < places.size(); ++i)
      if (is_kept[i])
        result.push_back(places[i]);
    return result;
  }

  void keep_near_strong(const std::vector<Fold_vote>& votes)
  {
    std::vector<Vector> strong;
    for (const Fold_vote& vote : votes)
    {
      m_feet.push_back(vote.foot);
      if (vote.is_strong)
        strong.push_back(vote.foot);
    }
    m_feet = kept(m_feet, strong, strong_reach, [](std::size_t n) { return n >= least_strong; });
  }

  void keep_confirmed(const Fold_scales& scales)
  {
    m_feet = kept(m_feet, m_feet, scales.vote_radius, [&](std::size_t n) { return n > scales.least_votes; });
  }

  void find_ends()
  {
    m_ways_on.assign(m_feet.size(), Vector::Zero());
    for_each_piece(m_feet.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> found;
      for (std::size_t i = begin; i < end; ++i)
      {
        m_search.query(m_feet[i], end_radius, found);
        Vector mean = Vector::Zero();
        for (std::size_t j : found)
          mean += (m_feet[j] - m_feet[i]) / double(found.size());
        if (mean.norm() > least_offset_at_ends)
          m_ways_on[i] = -mean.normalized();
      }
    });
  }

  void smooth()
  {
    const Ball_search search(m_feet);
    std::vector<Vector> moved(m_feet.size());
    for_each_piece(m_feet.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> found;
      for (std::size_t i = begin; i < end; ++i)
        moved[i] = moved_to_mean(m_feet[i], search, found);
    });
    m_feet.swap(moved);
  }

  Vector moved_to_mean(const Vector& foot, const Ball_search& search, std::vector<std::size_t>& found) const
  {
    search.query(foot, smoothing_radius, found);
    const auto weight = [&](std::size_t j) {
      return 1. - (m_feet[j] - foot).squaredNorm() / (smoothing_radius * smoothing_radius);
    };
    const auto position = [&](std::size_t j) -> const Vector& { return m_feet[j]; };
    const Scatter around = scatter(found, position, weight);
    const Vector along = principal_axes(around.matrix).axes[2];
    const Vector move = around.mean - foot;
    return foot + move - move.dot(along) * along;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_VOTES_H
