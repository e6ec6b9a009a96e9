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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_GRAPH_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_GRAPH_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/network/Subdivided_network.h>
#include <CGAL/Wireframe_extraction/internal/network/Traced_network.h>
#include <CGAL/Wireframe_extraction/internal/network/build_graph.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// leaves out points closer than `spacing` to the one before, or than half of that to the last one, but keeps `least`
// inner points
inline std::vector<Vector> thin_out(const std::vector<Vector>& polyline, double spacing, std::size_t least)
{
  std::vector<Vector> result{polyline.front()};
  for (std::size_t k = 1; k + 1 < polyline.size(); ++k)
    if ((polyline[k] - result.back()).norm() >= spacing && (polyline[k] - polyline.back()).norm() >= 0.5 * spacing)
      result.push_back(polyline[k]);
  result.push_back(polyline.back());
  if (result.size() >= least + 2)
    return result;
  // points at equal steps of arc length
  const std::vector<double> lengths = arc_lengths(polyline);
  Polyline_walk walk(polyline, lengths);
  result.assign(1, polyline.front());
  for (std::size_t j = 1; j <= least; ++j)
    result.push_back(walk.advance_to(lengths.back() * double(j) / double(least + 1)));
  result.push_back(polyline.back());
  return result;
}

inline Curve_network unthinned_network(const Skeleton_data& skeleton, const std::vector<Corner_group>& corners,
                                       const std::vector<std::vector<std::size_t>>& clusters,
                                       const Extraction_options& options, const std::function<bool(double)>& proceed)
{
  Progress progress(proceed);
  if (options.graph_method == Graph_method::SUBDIVIDED)
    return Subdivided_network(*skeleton.band, options, progress).run(clusters, corners);
  std::vector<std::size_t> seeds;
  for (const std::vector<std::size_t>& cluster : clusters)
    seeds.insert(seeds.end(), cluster.begin(), cluster.end());
  return Traced_network(*skeleton.band, *skeleton.surroundings, *skeleton.contraction, options).run(seeds, progress);
}

CGAL_WIREFRAME_EXTRACTION_INLINE Curve_network build_network(const Skeleton_data& skeleton,
                                                             const std::vector<Corner_group>& corners,
                                                             const std::vector<std::vector<std::size_t>>& clusters,
                                                             const Extraction_options& options,
                                                             const std::function<bool(double)>& proceed)
{
  if (skeleton.size() == 0)
    return Curve_network();
  // in r: traced points are closer than the graph needs them; those of a subdivision are few
  static constexpr double traced_spacing = 0.9;
  const double spacing = options.graph_method == Graph_method::SUBDIVIDED ? 0. : traced_spacing;
  // a loop with fewer would be no cycle of a simple graph, nor two edges between the same nodes two
  static constexpr std::size_t least_of_loop = 2, least_of_edge = 1;
  Curve_network network = unthinned_network(skeleton, corners, clusters, options, proceed);
  for (Network_curve& curve : network.curves)
  {
    const bool is_loop = curve.nodes[0] == curve.nodes[1];
    if (curve.is_alive && curve.points.size() >= 2)
      curve.points = thin_out(curve.points, spacing, is_loop ? least_of_loop : least_of_edge);
    else
      curve.is_alive = false;
  }
  return network;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_GRAPH_IMPL_H
