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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_PATCH_FUSER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_PATCH_FUSER_H

#include <CGAL/Wireframe_extraction/Distance_patch.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Finds out which points of overlapping patches are the same, and gives each of them one distance. No step depends on
// the order of the patches.
template <class Point, class FT>
class Patch_fuser
{
  typedef std::vector<std::pair<Point, FT>> Cloud;
  typedef std::array<double, 3> Position;

public:
  // points are the same up to this share of the diagonal of the box around the middle nine tenths of the coordinates
  static constexpr double tolerance = 1e-6;
  // points with the same index cannot be farther from each other than this share
  static constexpr double index_tolerance = 1e-3;

  // of the coordinates, at each end, that are no part of these nine tenths
  static constexpr std::size_t outer_share = 20;

  explicit Patch_fuser(Patch_fusion fusion) : m_fusion(fusion) {}

  // returns what went wrong, nothing if all went well
  std::string fuse(const std::vector<Distance_patch<Point, FT>>& patches, Cloud& cloud)
  {
    bool has_indices = true;
    const std::string error = collect(patches, has_indices);
    if (!error.empty())
      return error;
    sort(has_indices);
    find_groups(has_indices);
    cloud.clear();
    cloud.reserve(m_group_begins.size());
    for (std::size_t i = 0; i < m_group_begins.size(); ++i)
    {
      const std::size_t begin = m_group_begins[i];
      const std::size_t end = i + 1 < m_group_begins.size() ? m_group_begins[i + 1] : m_samples.size();
      const std::string group_error = has_indices ? check_group(begin, end) : std::string();
      if (!group_error.empty())
        return group_error;
      cloud.emplace_back(*m_samples[begin].point, distance_of_group(begin, end));
    }
    return std::string();
  }

private:
  struct Sample
  {
    Position position;
    const Point* point;
    const FT* distance;
    std::size_t index, group;
  };

  std::string collect(const std::vector<Distance_patch<Point, FT>>& patches, bool& has_indices)
  {
    using CGAL::IO::internal::plural;
    std::size_t count = 0;
    for (const auto& patch : patches)
      count += patch.samples.size();
    if (count == 0)
      return "the patches have no points";
    m_samples.reserve(count);
    for (const auto& patch : patches)
    {
      if (!patch.indices.empty() && patch.indices.size() != patch.samples.size())
        return "a patch has " + plural(patch.samples.size(), "point", "points") + ", but "
          + plural(patch.indices.size(), "index", "indices") + "; each point needs one, or none has one";
      has_indices = has_indices && (patch.samples.empty() || !patch.indices.empty());
      for (std::size_t i = 0; i < patch.samples.size(); ++i)
      {
        const Point& p = patch.samples[i].first;
        const Position position = {{CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}};
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (!std::isfinite(position[axis]))
            return "a patch has a point with a coordinate that is not finite";
        const double distance = CGAL::to_double(patch.samples[i].second);
        if (!(std::isfinite(distance) && distance >= 0.))
          return "a patch has a distance that is not finite, or negative";
        m_samples.push_back({position, &p, &patch.samples[i].second, patch.indices.empty() ? 0 : patch.indices[i], 0});
      }
    }
    m_diagonal = std::hypot(extent(0), extent(1), extent(2));
    return std::string();
  }

  // of the middle nine tenths of the coordinates: a point that is far off must not make all others look the same
  double extent(std::size_t axis) const
  {
    std::vector<double> values;
    values.reserve(m_samples.size());
    for (const Sample& sample : m_samples)
      values.push_back(sample.position[axis]);
    const std::size_t low = values.size() / outer_share, high = values.size() - 1 - low;
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(low), values.end());
    const double least = values[low];
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(high), values.end());
    return values[high] - least;
  }

  // by index or position; what is the same in both may stand in any order
  void sort(bool has_indices)
  {
    std::sort(m_samples.begin(), m_samples.end(), [has_indices](const Sample& a, const Sample& b) {
      if (has_indices && a.index != b.index)
        return a.index < b.index;
      return a.position < b.position;
    });
  }

  void find_groups(bool has_indices)
  {
    if (!has_indices)
      sort_by_clusters();
    for (std::size_t i = 0; i < m_samples.size(); ++i)
      if (i == 0
          || (has_indices ? m_samples[i].index != m_samples[i - 1].index
                          : m_samples[i].group != m_samples[i - 1].group))
        m_group_begins.push_back(i);
  }

  // Points that are closer than the tolerance, and those connected by such pairs, are a cluster. After a sort along a
  // direction that no plane of a shape is likely to be perpendicular to, they are close to each other in the order,
  // so that few pairs are looked at.
  void sort_by_clusters()
  {
    // equal positions first, of which there may be many
    std::vector<std::size_t> first_of_position;
    for (std::size_t i = 0; i < m_samples.size(); ++i)
    {
      if (i == 0 || m_samples[i].position != m_samples[i - 1].position)
        first_of_position.push_back(i);
      m_samples[i].group = first_of_position.size() - 1;
    }
    std::vector<std::size_t> parent(first_of_position.size());
    std::iota(parent.begin(), parent.end(), std::size_t(0));
    link_close_positions(first_of_position, parent);
    // parents come first, so the smallest position of a cluster is its root
    for (Sample& sample : m_samples)
      sample.group = root_of(parent, sample.group);
    std::stable_sort(m_samples.begin(), m_samples.end(),
                     [](const Sample& a, const Sample& b) { return a.group < b.group; });
  }

  void link_close_positions(const std::vector<std::size_t>& first_of_position, std::vector<std::size_t>& parent) const
  {
    static const Position direction = {{0.7236067977, 0.5257311121, 0.4472135955}};
    const double length = tolerance * m_diagonal;
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(parent.size());
    for (std::size_t i = 0; i < parent.size(); ++i)
    {
      const Position& p = m_samples[first_of_position[i]].position;
      order.emplace_back(direction[0] * p[0] + direction[1] * p[1] + direction[2] * p[2], i);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && order[j].first - order[i].first <= 2. * length; ++j)
        if (distance_between(m_samples[first_of_position[order[i].second]].position,
                             m_samples[first_of_position[order[j].second]].position)
            <= length)
          link(parent, order[i].second, order[j].second);
  }

  static double distance_between(const Position& a, const Position& b)
  {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  static std::size_t root_of(std::vector<std::size_t>& parent, std::size_t i)
  {
    while (parent[i] != i)
    {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  }

  static void link(std::vector<std::size_t>& parent, std::size_t i, std::size_t j)
  {
    i = root_of(parent, i);
    j = root_of(parent, j);
    parent[(std::max)(i, j)] = (std::min)(i, j);
  }

  std::string check_group(std::size_t begin, std::size_t end) const
  {
    for (std::size_t i = begin + 1; i < end; ++i)
      if (distance_between(m_samples[i].position, m_samples[begin].position) > index_tolerance * m_diagonal)
        return "the index " + std::to_string(m_samples[begin].index) + " stands for different points, "
          + position_text(m_samples[begin].position) + " and " + position_text(m_samples[i].position)
          + "; indices have to say where points are in the whole cloud, not in their patch. Name the data set "
            "that does (indices_dataset), or go by the positions of the points (use_indices false)";
    return std::string();
  }

  static std::string position_text(const Position& position)
  {
    using CGAL::IO::internal::number_to_string;
    return "(" + number_to_string(position[0]) + " " + number_to_string(position[1]) + " "
      + number_to_string(position[2]) + ")";
  }

  FT distance_of_group(std::size_t begin, std::size_t end)
  {
    m_distances.clear();
    for (std::size_t i = begin; i < end; ++i)
      m_distances.push_back(*m_samples[i].distance);
    std::sort(m_distances.begin(), m_distances.end());
    if (m_fusion == Patch_fusion::MINIMUM)
      return m_distances.front();
    const std::size_t middle = m_distances.size() / 2;
    if (m_distances.size() % 2 == 1 || m_distances[middle - 1] == m_distances[middle])
      return m_distances[middle];
    return m_distances[middle - 1] + (m_distances[middle] - m_distances[middle - 1]) / FT(2);
  }

  Patch_fusion m_fusion;
  double m_diagonal = 0.;
  std::vector<Sample> m_samples;
  std::vector<std::size_t> m_group_begins;
  std::vector<FT> m_distances;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_PATCH_FUSER_H
