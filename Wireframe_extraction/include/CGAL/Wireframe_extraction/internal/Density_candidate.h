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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_DENSITY_CANDIDATE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_DENSITY_CANDIDATE_H

#include <CGAL/Wireframe_extraction/internal/Cloud_values.h>
#include <CGAL/Wireframe_extraction/internal/Distance_histogram.h>
#include <CGAL/Wireframe_extraction/internal/sampling_distance.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A point at which the density of a cloud may be measured.
struct Density_candidate
{
  Vector position;
  double distance;
  std::uint64_t hash;   // of the position: it decides between equal distances
  std::size_t index;

  Density_candidate(const Vector& position_, double distance_, std::size_t index_)
    : position(position_), distance(distance_), hash(position_hash(position_)), index(index_)
  {}

  static bool is_before(const Density_candidate& a, const Density_candidate& b)
  {
    return std::tie(a.distance, a.hash, a.index) < std::tie(b.distance, b.hash, b.index);
  }
};

// Of sorted candidates the nearest to a rank whose distance no other position has, so that a moved cloud has the same.
// Returns their number if all similar distances are ambiguous, as the zeros of a field with errors are.
inline std::size_t nearest_clear_one(const std::vector<Density_candidate>& candidates, std::size_t rank)
{
  const auto is_clear = [&](std::size_t i) {
    const auto agrees = [&](std::size_t j) {
      return candidates[i].distance != candidates[j].distance || candidates[i].position == candidates[j].position;
    };
    return (i == 0 || agrees(i - 1)) && (i + 1 == candidates.size() || agrees(i + 1));
  };
  const Distance_histogram::Bin bin = Distance_histogram::bin(candidates[rank].distance);
  const auto is_similar = [&](std::size_t i) { return Distance_histogram::bin(candidates[i].distance) == bin; };
  bool goes_up = true, goes_down = true;
  for (std::size_t step = 0; goes_up || goes_down; ++step) {
    goes_up = goes_up && rank + step < candidates.size() && is_similar(rank + step);
    if (goes_up && is_clear(rank + step))
      return rank + step;
    goes_down = goes_down && rank >= step && is_similar(rank - step);
    if (goes_down && is_clear(rank - step))
      return rank - step;
  }
  return candidates.size();
}

// the different positions with the smallest hashes
inline std::vector<Density_candidate> different_candidates(const Cloud_values& values)
{
  std::vector<Density_candidate> candidates;
  for (std::size_t i = 0; i < values.size(); ++i)
    candidates.emplace_back(values.positions[i], values.distances[i], i);
  std::sort(candidates.begin(), candidates.end(), [](const Density_candidate& a, const Density_candidate& b) {
    return std::tie(a.hash, a.index) < std::tie(b.hash, b.index);
  });
  candidates.erase(std::unique(candidates.begin(), candidates.end(),
                               [](const Density_candidate& a, const Density_candidate& b) {
    return a.position == b.position;
  }), candidates.end());
  candidates.erase(candidates.begin()
                     + static_cast<std::ptrdiff_t>((std::min)(candidates.size(), most_density_samples)),
                   candidates.end());
  return candidates;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_DENSITY_CANDIDATE_H
