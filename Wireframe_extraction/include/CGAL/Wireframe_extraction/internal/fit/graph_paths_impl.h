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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_GRAPH_PATHS_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_GRAPH_PATHS_IMPL_H

#include <CGAL/Wireframe_extraction/internal/fit/graph_paths.h>

#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What CGAL reports the paths to.
struct Path_collector
{
  std::vector<std::vector<std::size_t>>& paths;

  void start_new_polyline() { paths.emplace_back(); }
  void add_node(std::size_t v) { paths.back().push_back(v); }
  void end_polyline() {}
};

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // a false one, about edges of Boost that CGAL collects
#endif

inline std::vector<std::vector<std::size_t>> split_into_paths(const Polyline_graph& graph)
{
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> Graph;
  Graph copy(graph.points.size());
  for (const auto& edge : graph.edges)
    boost::add_edge(edge.first, edge.second, copy);
  std::vector<std::vector<std::size_t>> paths;
  Path_collector collector{paths};
  CGAL::split_graph_into_polylines(copy, collector,
                                   [&](std::size_t v, const Graph&) { return graph.is_corner[v] != 0; });
  return paths;
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

CGAL_WIREFRAME_EXTRACTION_INLINE std::vector<Fitted_curve> curves_to_fit(const Polyline_graph& graph,
                                                                         std::vector<Vector>& vertices)
{
  std::vector<std::size_t> vertex_of_node(graph.points.size(), Fitted_curve::no_vertex);
  const auto vertex = [&](std::size_t v) {
    if (vertex_of_node[v] == Fitted_curve::no_vertex)
    {
      vertex_of_node[v] = vertices.size();
      vertices.push_back(graph.points[v]);
    }
    return vertex_of_node[v];
  };
  std::vector<Fitted_curve> curves;
  for (const std::vector<std::size_t>& path : split_into_paths(graph))
  {
    if (path.size() < 2)
      continue;
    Fitted_curve curve;
    for (std::size_t v : path)
      curve.path.push_back(graph.points[v]);
    const bool is_free_loop = path.front() == path.back() && !graph.is_corner[path.front()];
    for (int e = 0; e < 2; ++e)
      curve.vertices[e] = is_free_loop ? Fitted_curve::no_vertex : vertex(e == 0 ? path.front() : path.back());
    curves.push_back(curve);
  }
  return curves;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_GRAPH_PATHS_IMPL_H
