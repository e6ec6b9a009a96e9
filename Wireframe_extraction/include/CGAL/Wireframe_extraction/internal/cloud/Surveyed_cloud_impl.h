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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SURVEYED_CLOUD_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SURVEYED_CLOUD_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Density_candidates.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Neighbor_scan.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/sampling_distance.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE bool Surveyed_cloud::survey()
{
  m_sample.reserve(m_source.size_hint());
  const bool is_read = m_source.read([&](const Sample* first, const Sample* beyond) {
    for (; first != beyond; ++first)
      survey(*first);
    return true;
  });
  m_sample.thin_out();
  if (!is_read)
    m_error = reason();
  return is_read;
}

CGAL_WIREFRAME_EXTRACTION_INLINE Cloud_scale Surveyed_cloud::scale() const
{
  Cloud_values others; // candidates that are not in memory
  const Cloud_values& values = is_in_memory() ? sample() : others;
  const std::vector<std::size_t> queries = density_queries(values, others);
  if (is_in_memory() && sample().size() <= least_to_scan)
    return cloud_scale(sample().positions, sample().distances, queries);
  Neighbor_scan scan;
  for (std::size_t i : queries)
    scan.add_query(values.positions[i], values.distances[i]);
  if (is_in_memory())
  {
    start_with_few(scan);
    scan.add(sample().positions, sample().distances);
  }
  else
  {
    scan.start(sample().positions, sample().distances);
    for_each([&scan](const Vector& position, double distance, std::size_t) { scan.add(position, distance); });
  }
  return scan.scale();
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Surveyed_cloud::start_with_few(Neighbor_scan& scan) const
{
  Position_sample few(sample().size() / 8);
  sample().for_each([&few](const Vector& p, double distance, std::size_t index) { few.add(p, distance, index); });
  few.thin_out();
  scan.start(few.values().positions, few.values().distances);
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::string Surveyed_cloud::reason() const
{
  const std::string text = m_source.error_message();
  return text.empty() ? "the cloud cannot be read" : text;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Surveyed_cloud::survey(const Sample& s)
{
  const std::size_t index = m_number_of_points++;
  const bool has_numbers = is_finite(s);
  if (!has_numbers || !(s.distance >= 0.))
  {
    if (m_not_finite + m_negative == 0)
      m_first_invalid = index;
    ++(has_numbers ? m_negative : m_not_finite);
    return;
  }
  if (m_sample.is_full())
    start_histogram();
  m_sample.add(Vector(s.x, s.y, s.z), s.distance, index);
  if (m_histogram)
    m_histogram->add(s.distance);
  m_smallest = (std::min)(m_smallest, s.distance);
  if (s.distance > m_largest)
  {
    m_largest = s.distance;
    m_number_of_largest = 0;
  }
  m_number_of_largest += s.distance == m_largest;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Surveyed_cloud::start_histogram()
{
  m_histogram = std::make_unique<Distance_histogram>();
  for (double distance : m_sample.values().distances)
    m_histogram->add(distance);
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::vector<std::size_t> Surveyed_cloud::density_queries(const Cloud_values& values,
                                                                                          Cloud_values& others) const
{
  static constexpr std::size_t least = 64;
  const std::size_t count = number_of_valid() - m_number_of_largest;
  if (count < least)
  { // the field is hardly known anywhere
    if (!is_in_memory())
      others = sample();
    return spread_positions(values);
  }
  std::vector<std::size_t> ranks = spread_indices(count);
  if (!is_in_memory())
    read_candidates(ranks, others);
  const Density_candidates candidates(values, m_largest);
  std::vector<std::size_t> queries, clear_queries;
  for (std::size_t rank : ranks)
  {
    if (rank >= candidates.size())
      continue;
    const std::size_t clear = candidates.nearest_clear_one(rank);
    const bool is_clear = clear < candidates.size();
    queries.push_back(candidates.index(is_clear ? clear : rank));
    if (is_clear)
      clear_queries.push_back(queries.back());
  }
  // a coarse field tells hardly any points apart
  return clear_queries.size() < least ? queries : clear_queries;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Surveyed_cloud::read_candidates(std::vector<std::size_t>& ranks,
                                                                      Cloud_values& candidates) const
{
  std::vector<bool> is_wanted(Distance_histogram::number_of_bins, false);
  std::size_t next = 0;
  std::uint64_t passed_over = 0;
  m_histogram->for_each_bin([&](Distance_histogram::Bin bin, std::uint64_t smaller, std::uint64_t number) {
    if (next == ranks.size() || ranks[next] >= smaller + number)
    {
      passed_over += number;
      return;
    }
    is_wanted[bin] = true;
    for (; next < ranks.size() && ranks[next] < smaller + number; ++next)
      ranks[next] -= static_cast<std::size_t>(passed_over);
  });
  for_each([&](const Vector& position, double distance, std::size_t index) {
    if (is_wanted[Distance_histogram::bin(distance)] && distance < m_largest)
      candidates.add(position, distance, index);
  });
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SURVEYED_CLOUD_IMPL_H
