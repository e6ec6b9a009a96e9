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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_GRAPH_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_GRAPH_H

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>
#include <CGAL/Wireframe_extraction/internal/network/find_corners.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>
#include <CGAL/use.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The network of curves that explain the field, as polylines with few points. `proceed(share)` returns whether to go
// on; after cancelling, the network is what was found so far.
Curve_network build_network(const Skeleton_data& skeleton, const std::vector<Corner_group>& corners,
                            const std::vector<std::vector<std::size_t>>& clusters, const Extraction_options& options,
                            const std::function<bool(double)>& proceed);

template <class GeomTraits>
Wireframe_graph<GeomTraits> to_graph(const Curve_network& network, const Wireframe_skeleton<GeomTraits>& skeleton)
{
  typedef Wireframe_graph<GeomTraits> Graph;
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  Graph graph;
  const auto add = [&](const Vector& p, bool is_corner) {
    const Vertex v = boost::add_vertex(graph);
    put(CGAL::vertex_point, graph, v, skeleton.to_point(p));
    graph[v].is_corner = is_corner;
    return v;
  };
  const Vertex none = boost::graph_traits<Graph>::null_vertex();
  std::vector<Vertex> vertex_of_node(network.nodes.size(), none);
  std::size_t id = 0;
  for (const Network_curve& curve : network.curves)
  {
    if (!curve.is_alive)
      continue;
    const std::vector<Vector>& polyline = curve.points;
    Vertex ends[2];
    for (int e = 0; e < 2; ++e)
    {
      if (curve.is_closed_without_node())
      {
        ends[e] = e == 0 ? add(polyline.front(), false) : ends[0];
        continue;
      }
      Vertex& v = vertex_of_node[curve.nodes[e]];
      if (v == none)
        v = add(network.nodes[curve.nodes[e]], true);
      ends[e] = v;
    }
    Vertex previous = ends[0];
    for (std::size_t k = 1; k < polyline.size(); ++k)
    {
      const Vertex next = k + 1 < polyline.size() ? add(polyline[k], false) : ends[1];
      boost::add_edge(previous, next, Wireframe_edge{id}, graph);
      previous = next;
    }
    ++id;
  }
  return graph;
}

template <class GeomTraits>
Wireframe_graph<GeomTraits> build_graph(const Wireframe_skeleton<GeomTraits>& skeleton,
                                        const std::vector<Wireframe_corner<GeomTraits>>& corners,
                                        const std::vector<std::vector<std::size_t>>& clusters,
                                        const Extraction_options& options, const std::function<bool(double)>& proceed)
{
  std::vector<Corner_group> groups;
  for (const Wireframe_corner<GeomTraits>& corner : corners)
    groups.push_back(
      {skeleton.to_local(corner.center), CGAL::to_double(corner.radius) / skeleton.data().unit, corner.members});
  for (const std::vector<std::size_t>& cluster : clusters)
  {
    CGAL_USE(cluster);
    CGAL_precondition(std::all_of(cluster.begin(), cluster.end(), [&](std::size_t i) { return i < skeleton.size(); }));
  }
  return to_graph(build_network(skeleton.data(), groups, clusters, options, proceed), skeleton);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/network/build_graph_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_GRAPH_H
