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

#include <boost/sort/spreadsort/float_sort.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE bool Surveyed_cloud::survey()
{
  m_sample.reserve(m_source.size_hint());
  const bool is_read = read([this](const Sample& s) { survey(s); });
  m_sample.thin_out();
  if (!is_read)
    m_error = reason();
  return is_read;
}

CGAL_WIREFRAME_EXTRACTION_INLINE Cloud_scale Surveyed_cloud::scale() const
{
  const Cloud_values queries = density_queries();
  if (is_in_memory() && sample().size() <= least_to_scan)
    return cloud_scale(sample().positions, sample().distances, queries);
  Neighbor_scan scan;
  for (std::size_t i = 0; i < queries.size(); ++i)
    scan.add_query(queries.positions[i], queries.distances[i]);
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
  Position_sample few(sample().size() / start_share);
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
  survey_distance(s.distance);
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Surveyed_cloud::survey_distance(double distance)
{
  if (distance < m_smallest)
  {
    m_smallest = distance;
    m_number_of_smallest = 0;
  }
  m_number_of_smallest += distance == m_smallest;
  if (distance > m_largest)
  {
    m_largest = distance;
    m_number_of_largest = 0;
  }
  m_number_of_largest += distance == m_largest;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Surveyed_cloud::set_distances(const std::vector<double>& distances)
{
  m_sample.set_distances(distances);
  m_has_own_distances = true;
  m_smallest = (std::numeric_limits<double>::infinity)();
  m_largest = 0.;
  m_number_of_smallest = m_number_of_largest = 0;
  for (double distance : m_sample.values().distances)
    survey_distance(distance);
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Surveyed_cloud::start_histogram()
{
  m_histogram = std::make_unique<Distance_histogram>();
  for (double distance : m_sample.values().distances)
    m_histogram->add(distance);
}

template <class Use>
void Surveyed_cloud::for_each_bin(const Use& use) const
{
  if (m_histogram)
  {
    m_histogram->for_each_bin(use);
    return;
  }
  // few distances are sorted faster than counted
  std::vector<double> distances = sample().distances;
  boost::sort::spreadsort::float_sort(distances.begin(), distances.end());
  for (std::size_t begin = 0, end = 0; begin < distances.size(); begin = end)
  {
    const Distance_histogram::Bin bin = Distance_histogram::bin(distances[begin]);
    for (end = begin; end < distances.size() && Distance_histogram::bin(distances[end]) == bin; ++end)
    {}
    use(bin, std::uint64_t(begin), std::uint64_t(end - begin));
  }
}

CGAL_WIREFRAME_EXTRACTION_INLINE Cloud_values Surveyed_cloud::density_queries() const
{
  const std::size_t count = number_of_valid() - m_number_of_largest;
  if (count < least_queries)
    return spread_positions(sample()); // the field is hardly known anywhere
  Density_candidates candidates(spread_indices(count));
  for_each_bin([&](Distance_histogram::Bin bin, std::uint64_t smaller, std::uint64_t number) {
    candidates.add_bin(bin, smaller, bin == Distance_histogram::bin(m_largest) ? number - m_number_of_largest : number);
  });
  for_each([&](const Vector& position, double distance, std::size_t index) {
    if (distance < m_largest)
      candidates.add(position, distance, index);
  });
  return candidates.chosen(least_queries);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SURVEYED_CLOUD_IMPL_H
