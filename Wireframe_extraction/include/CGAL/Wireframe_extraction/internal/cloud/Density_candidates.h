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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_DENSITY_CANDIDATES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_DENSITY_CANDIDATES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_values.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Distance_histogram.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Position_sample.h>
#include <CGAL/Wireframe_extraction/internal/cloud/sampling_distance.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// a number that looks random, the same for equal distances
inline std::uint64_t distance_hash(double distance) { return position_hash(Vector(distance, 0., 0.)); }

// Of the points whose distances are in one bin of a histogram, those that may be chosen: all as long as they are few.
// Of many with the same distance, as coarse fields have, those with the smallest hashes are kept, and of many different
// distances likewise. So what is kept is bounded, and does not depend on the order of the cloud.
class Similar_points
{
public:
  struct Candidate
  {
    double distance;
    std::uint64_t hash; // of the position
    std::size_t index;
    Vector position;

    bool operator<(const Candidate& other) const
    {
      return std::tie(distance, hash) < std::tie(other.distance, other.hash);
    }
  };

private:
  // Of the 2^17 bins per power of two, a hundred million points of a field in double precision put about 150 in each:
  // of these none is left out.
  static constexpr std::size_t most = 256;

  std::vector<Candidate> m_candidates;                                 // sorted
  std::uint64_t m_bound = (std::numeric_limits<std::uint64_t>::max)(); // of the hashes of distances

public:
  // ranks, among all points of the bin, of the points that are wanted, and how many points it has
  std::vector<std::size_t> ranks;
  std::size_t number_of_points = 0;

  void add(const Vector& position, double distance, std::size_t index)
  {
    if (m_bound < (std::numeric_limits<std::uint64_t>::max)() && distance_hash(distance) >= m_bound)
      return;
    const Candidate added{distance, position_hash(position), index, position};
    const auto range = range_of(distance);
    const auto place = std::lower_bound(range.first, range.second, added);
    if (place != range.second && place->hash == added.hash)
      return; // the same position
    // two are needed to see that others have the same distance
    const std::size_t most_of_distance = (std::max)(std::size_t(2), ranks.size());
    if (std::size_t(range.second - range.first) < most_of_distance)
      m_candidates.insert(place, added);
    else if (place != range.second)
    {
      std::move_backward(place, range.second - 1, range.second);
      *place = added;
    }
    while (m_candidates.size() > (std::max)(most, most_of_distance))
      drop_distance();
  }

  std::size_t size() const { return m_candidates.size(); }
  const Candidate& operator[](std::size_t i) const { return m_candidates[i]; }

  // where the candidate is that stands for the point with a rank in the bin
  std::size_t place(std::size_t rank) const
  {
    return size() == number_of_points
      ? rank
      : (std::min)(size() - 1, static_cast<std::size_t>(double(rank) / double(number_of_points) * double(size())));
  }

  // The candidate nearest to a place whose distance no other position has, so that a moved cloud has the same. Returns
  // their number if all are ambiguous, as the zeros of a field with errors are.
  std::size_t nearest_clear_one(std::size_t place) const
  {
    for (std::size_t step = 0; step < size(); ++step)
    {
      if (place + step < size() && is_clear(place + step))
        return place + step;
      if (place >= step && is_clear(place - step))
        return place - step;
    }
    return size();
  }

private:
  typedef std::vector<Candidate>::iterator Iterator;

  std::pair<Iterator, Iterator> range_of(double distance)
  {
    struct Less
    {
      bool operator()(const Candidate& a, double d) const { return a.distance < d; }
      bool operator()(double d, const Candidate& a) const { return d < a.distance; }
    };
    return std::equal_range(m_candidates.begin(), m_candidates.end(), distance, Less());
  }

  // the one with the largest hash; from now on no point with this one or a larger one is taken
  void drop_distance()
  {
    const auto largest =
      std::max_element(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
        return distance_hash(a.distance) < distance_hash(b.distance);
      });
    m_bound = distance_hash(largest->distance);
    const auto range = range_of(largest->distance);
    m_candidates.erase(range.first, range.second);
  }

  bool is_clear(std::size_t i) const
  {
    return (i == 0 || m_candidates[i - 1].distance != m_candidates[i].distance)
      && (i + 1 == size() || m_candidates[i + 1].distance != m_candidates[i].distance);
  }
};

// The points of a cloud at which its density may be measured: those whose distances are in the same bins of a histogram
// as those with the wanted ranks.
class Density_candidates
{
  typedef Distance_histogram::Bin Bin;

  std::vector<std::size_t> m_ranks;
  std::size_t m_next = 0; // of the ranks
  std::vector<Similar_points> m_bins;
  std::unordered_map<Bin, std::size_t> m_bin_indices;
  // by the last digits of the bins: most points need no more than a look at this
  static constexpr std::size_t number_of_marks = std::size_t(1) << 16;
  std::vector<bool> m_marks;

public:
  // `ranks` are ascending
  explicit Density_candidates(std::vector<std::size_t> ranks)
    : m_ranks(std::move(ranks)), m_marks(number_of_marks, false)
  {}

  // Tells how many points lie in a bin that is not empty, and in smaller ones. To be called for all bins, in their
  // order, before points are added.
  void add_bin(Bin bin, std::uint64_t smaller, std::uint64_t number)
  {
    Similar_points points;
    for (; m_next < m_ranks.size() && m_ranks[m_next] < smaller + number; ++m_next)
      points.ranks.push_back(m_ranks[m_next] - static_cast<std::size_t>(smaller));
    if (points.ranks.empty())
      return;
    points.number_of_points = static_cast<std::size_t>(number);
    m_bin_indices.emplace(bin, m_bins.size());
    m_marks[bin % number_of_marks] = true;
    m_bins.push_back(std::move(points));
  }

  void add(const Vector& position, double distance, std::size_t index)
  {
    const Bin bin = Distance_histogram::bin(distance);
    if (!m_marks[bin % number_of_marks])
      return;
    const auto found = m_bin_indices.find(bin);
    if (found != m_bin_indices.end())
      m_bins[found->second].add(position, distance + 0., index); // there is a negative zero
  }

  // how many points are kept
  std::size_t size() const
  {
    std::size_t sum = 0;
    for (const Similar_points& points : m_bins)
      sum += points.size();
    return sum;
  }

  // Those that stand for the wanted ranks: such with a distance of their own, if there are `least` of them. A coarse
  // field tells hardly any points apart.
  Cloud_values chosen(std::size_t least) const
  {
    Cloud_values all, clear;
    for (const Similar_points& points : m_bins)
      for (std::size_t rank : points.ranks)
      {
        if (points.size() == 0)
          continue; // the cloud has changed meanwhile
        const std::size_t place = points.place(rank), clear_place = points.nearest_clear_one(place);
        const bool is_clear = clear_place < points.size();
        const Similar_points::Candidate& candidate = points[is_clear ? clear_place : place];
        all.add(candidate.position, candidate.distance, candidate.index);
        if (is_clear)
          clear.add(candidate.position, candidate.distance, candidate.index);
      }
    return clear.size() < least ? all : clear;
  }
};

// different positions of a cloud, with the smallest hashes
inline Cloud_values spread_positions(const Cloud_values& values)
{
  std::vector<std::pair<std::uint64_t, std::size_t>> keys;
  for (std::size_t i = 0; i < values.size(); ++i)
    keys.emplace_back(position_hash(values.positions[i]), i);
  std::sort(keys.begin(), keys.end());
  keys.erase(
    std::unique(keys.begin(), keys.end(),
                [&](const auto& a, const auto& b) { return values.positions[a.second] == values.positions[b.second]; }),
    keys.end());
  keys.resize((std::min)(keys.size(), most_density_samples));
  Cloud_values result;
  for (const auto& key : keys)
    result.add(values.positions[key.second], values.distances[key.second], key.second);
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_DENSITY_CANDIDATES_H
