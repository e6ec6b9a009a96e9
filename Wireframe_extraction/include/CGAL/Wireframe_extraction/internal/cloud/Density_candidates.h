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

#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_values.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Distance_histogram.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Position_sample.h>
#include <CGAL/Wireframe_extraction/internal/cloud/sampling_distance.h>

#include <boost/sort/spreadsort/float_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The points of a cloud at which its density may be measured, sorted by distance. Between equal distances, a hash of
// the position decides, so that the order of the cloud does not matter.
class Density_candidates
{
  struct Ranked
  {
    double distance;
    std::size_t index;
  };

  struct Distance_less
  {
    bool operator()(const Ranked& a, const Ranked& b) const { return a.distance < b.distance; }
  };
  // of the bits of a distance, from the highest on
  struct Distance_digits
  {
    std::int64_t operator()(const Ranked& a, unsigned int shift) const
    {
      return boost::sort::spreadsort::float_mem_cast<double, std::int64_t>(a.distance) >> shift;
    }
  };

  const Cloud_values& m_values;
  std::vector<Ranked> m_sorted;

public:
  // those of the values that lie nearer than `bound`
  Density_candidates(const Cloud_values& values, double bound) : m_values(values)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values.distances[i] < bound)
        m_sorted.push_back({values.distances[i] + 0., i}); // there is a negative zero
    boost::sort::spreadsort::float_sort(m_sorted.begin(), m_sorted.end(), Distance_digits(), Distance_less());
    for (std::size_t begin = 0, end = 0; begin < size(); begin = end)
    {
      for (end = begin + 1; end < size() && m_sorted[end].distance == m_sorted[begin].distance; ++end)
      {}
      if (end - begin > 1)
        sort_by_hash(begin, end);
    }
  }

  std::size_t size() const { return m_sorted.size(); }
  std::size_t index(std::size_t rank) const { return m_sorted[rank].index; } // among the values

  // Of the candidates the nearest to a rank whose distance no other position has, so that a moved cloud has the same.
  // Returns their number if all similar distances are ambiguous, as the zeros of a field with errors are.
  std::size_t nearest_clear_one(std::size_t rank) const
  {
    const Distance_histogram::Bin bin = Distance_histogram::bin(m_sorted[rank].distance);
    const auto is_similar = [&](std::size_t i) { return Distance_histogram::bin(m_sorted[i].distance) == bin; };
    bool goes_up = true, goes_down = true;
    for (std::size_t step = 0; goes_up || goes_down; ++step)
    {
      goes_up = goes_up && rank + step < size() && is_similar(rank + step);
      if (goes_up && is_clear(rank + step))
        return rank + step;
      goes_down = goes_down && rank >= step && is_similar(rank - step);
      if (goes_down && is_clear(rank - step))
        return rank - step;
    }
    return size();
  }

private:
  void sort_by_hash(std::size_t begin, std::size_t end)
  {
    std::vector<std::pair<std::uint64_t, std::size_t>> keys;
    for (std::size_t k = begin; k < end; ++k)
      keys.emplace_back(position_hash(m_values.positions[m_sorted[k].index]), m_sorted[k].index);
    std::sort(keys.begin(), keys.end());
    for (std::size_t k = begin; k < end; ++k)
      m_sorted[k].index = keys[k - begin].second;
  }

  bool is_clear(std::size_t i) const
  {
    const auto agrees = [&](std::size_t j) {
      return m_sorted[i].distance != m_sorted[j].distance
        || m_values.positions[m_sorted[i].index] == m_values.positions[m_sorted[j].index];
    };
    return (i == 0 || agrees(i - 1)) && (i + 1 == size() || agrees(i + 1));
  }
};

// the indices of the different positions with the smallest hashes
inline std::vector<std::size_t> spread_positions(const Cloud_values& values)
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
  std::vector<std::size_t> result;
  for (const auto& key : keys)
    result.push_back(key.second);
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_DENSITY_CANDIDATES_H
