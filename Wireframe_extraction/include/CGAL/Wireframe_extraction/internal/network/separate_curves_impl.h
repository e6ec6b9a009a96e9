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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SEPARATE_CURVES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SEPARATE_CURVES_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/network/separate_curves.h>

#include <CGAL/number_type_config.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How far a point may lie off the local curve of another one, in r: twice the 0.15 by which curves without noise differ
// from a parabola, and 1.5 times the noise; and 0.1 (6 degrees), the error of a tangent, times the distance.
constexpr double offset_of_neighbors = 0.3, offset_of_neighbors_per_noise = 1.5, slope_of_neighbors = 0.1;

// whether two points may belong to one curve: their tangents agree, and each lies on the other one's local curve
inline bool do_tangents_agree(const Local_curve& a, const Local_curve& b, double least_cosine, double tolerance)
{
  if (std::abs(a.tangent.dot(b.tangent)) < least_cosine)
    return false;
  const double limit = tolerance + slope_of_neighbors * (a.point - b.point).norm();
  return a.distance(b.point) < limit && b.distance(a.point) < limit;
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::vector<std::vector<std::size_t>> separate_curves(
  const Skeleton_data& skeleton, const std::vector<char>& is_in_corner, const Extraction_options& options,
  const std::function<bool(double)>& proceed)
{
  const std::size_t size = skeleton.size();
  std::vector<std::vector<std::size_t>> clusters;
  if (size == 0)
    return clusters;
  std::vector<Vector> positions(skeleton.band->points.begin(), skeleton.band->points.begin() + size);
  if (options.use_tangents)
    for (std::size_t i = 0; i < size; ++i)
      positions[i] = skeleton.contraction->curves[i].point;
  const Ball_search search(positions);
  const double least_cosine = std::cos(options.connection_angle * CGAL_PI / 180.);
  const double tolerance =
    options.use_tangents ? offset_of_neighbors + offset_of_neighbors_per_noise * skeleton.contraction->noise : 0.;
  const auto may_connect = [&](std::size_t i, std::size_t j) {
    return !options.use_tangents
      || do_tangents_agree(skeleton.contraction->curves[i], skeleton.contraction->curves[j], least_cosine, tolerance);
  };

  // connected components of a graph whose many edges need not be kept
  std::vector<std::size_t> rank(size), parent(size);
  boost::disjoint_sets<std::size_t*, std::size_t*> components(rank.data(), parent.data());
  for (std::size_t i = 0; i < size; ++i)
    components.make_set(i);
  std::vector<std::size_t> ball;
  Progress progress(proceed);
  for (std::size_t i = 0; i < size; ++i)
  {
    if (i % points_between_questions == 0 && !progress.reach(double(i) / double(size)))
      return clusters;
    if (is_in_corner[i])
      continue;
    search.query(positions[i], options.connection_radius, ball);
    for (std::size_t j : ball)
      if (j < i && !is_in_corner[j] && may_connect(i, j))
        components.union_set(i, j);
  }
  std::vector<std::size_t> cluster_of_component(size, size); // size: none yet
  for (std::size_t i = 0; i < size; ++i)
  {
    if (is_in_corner[i])
      continue;
    std::size_t& cluster = cluster_of_component[components.find_set(i)];
    if (cluster == size)
    {
      cluster = clusters.size();
      clusters.emplace_back();
    }
    clusters[cluster].push_back(i);
  }
  return clusters;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SEPARATE_CURVES_IMPL_H
