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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_POSITION_SAMPLE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_POSITION_SAMPLE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_values.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// a number that looks random, the same for equal positions
inline std::uint64_t position_hash(const Vector& position)
{
  std::uint64_t hash = 0x9e3779b97f4a7c15u;
  for (int k = 0; k < 3; ++k)
  {
    const double coordinate = position[k] + 0.; // there is a negative zero
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof(coordinate));
    hash = (hash ^ bits) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 29)) * 0x94d049bb133111ebu;
    hash ^= hash >> 32;
  }
  return hash;
}

// Keeps the points of a cloud as long as they are few, and then a sample of its different positions: those with the
// smallest hashes. Which these are depends neither on the order of the cloud nor on how often a position occurs in it.
class Position_sample
{
  std::size_t m_most;
  Cloud_values m_values;
  std::vector<std::uint64_t> m_hashes; // once it is a sample
  std::uint64_t m_bound = (std::numeric_limits<std::uint64_t>::max)();
  bool m_is_complete = true;
  static constexpr std::size_t least_size = 128; // fewer would tell no density, whoever asks for them

public:
  explicit Position_sample(std::size_t most) : m_most((std::max)(+least_size, most)) {}

  // whether one more point would make it a sample
  bool is_full() const { return m_is_complete && m_values.size() == m_most; }
  // whether all points are kept
  bool is_complete() const { return m_is_complete; }
  const Cloud_values& values() const { return m_values; }

  // for about so many points
  void reserve(std::size_t n) { m_values.reserve((std::min)(n, m_most)); }

  void add(const Vector& position, double distance, std::size_t index)
  {
    if (is_full())
    {
      for (const Vector& p : m_values.positions)
        m_hashes.push_back(position_hash(p));
      m_is_complete = false;
      thin_out();
    }
    if (!m_is_complete)
    {
      const std::uint64_t hash = position_hash(position);
      if (hash >= m_bound)
        return;
      m_hashes.push_back(hash);
    }
    m_values.add(position, distance, index);
    if (!m_is_complete && m_values.size() >= m_most)
      thin_out();
  }

  // takes other distances, of which it has those of its indices
  void set_distances(const std::vector<double>& distances)
  {
    for (std::size_t i = 0; i < m_values.size(); ++i)
      m_values.distances[i] = distances[m_values.index(i)];
  }

  // keeps no more than half of what there is room for
  void thin_out()
  {
    if (m_is_complete)
      return;
    std::vector<std::size_t> order(m_values.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return std::make_pair(m_hashes[a], a) < std::make_pair(m_hashes[b], b);
    });
    order.erase(
      std::unique(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return m_hashes[a] == m_hashes[b]; }),
      order.end());
    if (order.size() > m_most / 2)
    {
      m_bound = m_hashes[order[m_most / 2]];
      order.resize(m_most / 2);
    }
    Cloud_values kept;
    std::vector<std::uint64_t> hashes;
    for (std::size_t i : order)
    {
      kept.add(m_values.positions[i], m_values.distances[i], m_values.index(i));
      hashes.push_back(m_hashes[i]);
    }
    m_values = std::move(kept);
    m_hashes.swap(hashes);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_POSITION_SAMPLE_H
