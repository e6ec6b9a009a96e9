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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_DISTANCE_HISTOGRAM_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_DISTANCE_HISTOGRAM_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How many distances there are in each of narrow bins, whose bounds are floating point numbers of 17 binary digits: so
// ranks are found in a cloud that is not in memory. Takes a megabyte per power of two that occurs.
class Distance_histogram
{
  static constexpr int bits = 17;
  static constexpr std::size_t bins_per_octave = std::size_t(1) << bits;
  static constexpr std::size_t octaves = 2048;
  typedef std::vector<std::uint64_t> Counts;

  std::vector<std::unique_ptr<Counts>> m_counts;

public:
  typedef std::uint32_t Bin;
  static constexpr std::size_t number_of_bins = octaves * bins_per_octave;

  Distance_histogram() : m_counts(octaves) {}

  // of a distance that is finite and not negative
  static Bin bin(double distance)
  {
    const double positive = distance + 0.; // there is a negative zero
    std::uint64_t representation;
    std::memcpy(&representation, &positive, sizeof(positive));
    return static_cast<Bin>(representation >> (52 - bits));
  }

  void add(double distance)
  {
    const Bin b = bin(distance);
    std::unique_ptr<Counts>& counts = m_counts[b >> bits];
    if (!counts)
      counts = std::make_unique<Counts>(bins_per_octave, 0);
    ++(*counts)[b & (bins_per_octave - 1)];
  }

  // calls `use(bin, number of distances in smaller bins, number of distances in it)` for all bins that are not empty
  template <class Use>
  void for_each_bin(const Use& use) const
  {
    std::uint64_t smaller = 0;
    for (std::size_t octave = 0; octave < octaves; ++octave)
      if (m_counts[octave])
        for (std::size_t k = 0; k < bins_per_octave; ++k)
          if (const std::uint64_t count = (*m_counts[octave])[k])
          {
            use(static_cast<Bin>(octave << bits | k), smaller, count);
            smaller += count;
          }
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_DISTANCE_HISTOGRAM_H
