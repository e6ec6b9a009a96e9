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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_CORNERS_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_CORNERS_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/farthest_point_sampling.h>
#include <CGAL/Wireframe_extraction/internal/network/find_corners.h>
#include <CGAL/Wireframe_extraction/internal/network/second_variance_ratio.h>

#include <CGAL/Union_find.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Thresholds of corners by residual, in r. Fits on single curves leave the noise, of which 1.5 times is exceeded by an
// eighth of normal ones, and 0.15 by bends where there is no noise (0.01 r on curves of exact fields, 0.8 r at
// corners); single bad fits occur anywhere, so irregular points count where there are three of
// them within the skeleton's width.
constexpr double residual_of_corner = 0.15, residual_of_corner_per_noise = 1.5;
constexpr double reach_of_irregular_points = 1.5;
constexpr std::size_t least_irregular_points = 3;

// Groups of skeleton points, each closer than `reach` to another one of its group.
inline std::vector<std::vector<std::size_t>> connected_groups(const Field_band& band,
                                                              const std::vector<char>& is_marked, double reach,
                                                              Progress& progress)
{
  typedef CGAL::Union_find<std::size_t> Union_find;
  Union_find sets;
  std::vector<Union_find::handle> handles(band.skeleton_size);
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    if (is_marked[i])
      handles[i] = sets.make_set(i);
  std::vector<std::size_t> ball;
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
  {
    if (i % points_between_questions == 0 && !progress.goes_on())
      return {};
    if (!is_marked[i])
      continue;
    band.search.query(band.points[i], reach, ball);
    for (std::size_t j : ball)
      if (j < i && is_marked[j])
        sets.unify_sets(handles[i], handles[j]);
  }
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::size_t, std::size_t> group_of_root;
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    if (is_marked[i])
    {
      const auto inserted = group_of_root.emplace(*sets.find(handles[i]), groups.size());
      if (inserted.second)
        groups.emplace_back();
      groups[inserted.first->second].push_back(i);
    }
  return groups;
}

// The published measure: balls around farthest point samples, of which those with a large second variance ratio hold a
// corner; what a bounding box around connected balls takes belongs to it.
inline std::vector<std::vector<std::size_t>> corners_by_variance(const Field_band& band,
                                                                 const Extraction_options& options, Progress& progress)
{
  const std::size_t count =
    static_cast<std::size_t>(std::ceil(options.corner_sampling_ratio * double(band.skeleton_size)));
  std::vector<char> is_in_corner_ball(band.skeleton_size, 0);
  std::vector<std::size_t> ball;
  std::size_t done = 0;
  for (std::size_t center : farthest_point_sampling(band.points, band.skeleton_size, count, &progress))
  {
    if (!progress.reach(double(done++) / double(count)))
      return {};
    band.search.query(band.points[center], options.corner_radius, ball);
    ball.erase(std::remove_if(ball.begin(), ball.end(), [&](std::size_t i) { return i >= band.skeleton_size; }),
               ball.end());
    if (second_variance_ratio(band.points, ball) > options.corner_variance)
      for (std::size_t i : ball)
        is_in_corner_ball[i] = 1;
  }
  std::vector<std::vector<std::size_t>> groups =
    connected_groups(band, is_in_corner_ball, options.connection_radius, progress);
  std::vector<char> is_taken(band.skeleton_size, 0);
  for (std::vector<std::size_t>& group : groups)
  {
    static constexpr double rounding = 1e-6; // so that no corner of the box is lost; contains() decides
    Eigen::AlignedBox3d box;
    for (std::size_t i : group)
      box.extend(band.points[i]);
    band.search.query(box.center(), 0.5 * box.diagonal().norm() + rounding, ball);
    std::vector<std::size_t> members;
    for (std::size_t i : ball)
      if (i < band.skeleton_size && !is_taken[i] && box.contains(band.points[i]))
      {
        is_taken[i] = 1;
        members.push_back(i);
      }
    std::sort(members.begin(), members.end());
    group = members;
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.empty(); }), groups.end());
  return groups;
}

inline std::vector<std::vector<std::size_t>> corners_by_residual(const Field_band& band, const Contraction& contraction,
                                                                 const Extraction_options& options, Progress& progress)
{
  const double threshold = options.corner_residual >= 0.
    ? options.corner_residual
    : residual_of_corner + residual_of_corner_per_noise * contraction.noise;
  std::vector<char> is_irregular(band.skeleton_size, 0);
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    is_irregular[i] = contraction.residuals[i] > threshold;
  std::vector<std::vector<std::size_t>> groups =
    connected_groups(band, is_irregular, reach_of_irregular_points, progress);
  groups.erase(
    std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.size() < least_irregular_points; }),
    groups.end());
  return groups;
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::vector<Corner_group> find_corners(const Skeleton_data& skeleton,
                                                                        const Extraction_options& options,
                                                                        const std::function<bool(double)>& proceed)
{
  std::vector<Corner_group> result;
  if (skeleton.size() == 0)
    return result;
  const Field_band& band = *skeleton.band;
  Progress progress(proceed);
  const std::vector<std::vector<std::size_t>> groups = options.corner_measure == Corner_measure::VARIANCE
    ? corners_by_variance(band, options, progress)
    : corners_by_residual(band, *skeleton.contraction, options, progress);
  if (progress.is_cancelled())
    return result;
  for (const std::vector<std::size_t>& group : groups)
  {
    Corner_group corner;
    for (std::size_t i : group)
      corner.center += band.points[i];
    corner.center /= double(group.size());
    for (std::size_t i : group)
      corner.radius = (std::max)(corner.radius, (band.points[i] - corner.center).norm());
    corner.members = group;
    result.push_back(std::move(corner));
  }
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_CORNERS_IMPL_H
