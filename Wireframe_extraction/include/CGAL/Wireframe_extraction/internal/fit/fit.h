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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/fit/Fitted_curve.h>
#include <CGAL/Wireframe_extraction/internal/fit/fit_network.h>
#include <CGAL/Wireframe_extraction/internal/fit/to_spline.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>

#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

template <class Graph>
struct Path_collector
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  std::vector<std::vector<Vertex>>& paths;

  void start_new_polyline() { paths.emplace_back(); }
  void add_node(Vertex v) { paths.back().push_back(v); }
  void end_polyline() {}
};

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // a false one, about edges of Boost that CGAL collects
#endif

// the paths between vertices that are corners, or have a degree other than 2
template <class Graph>
std::vector<std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>> split_into_paths(const Graph& graph)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  std::vector<std::vector<Vertex>> paths;
  Path_collector<Graph> collector{paths};
  CGAL::split_graph_into_polylines(graph, collector, [](Vertex v, const Graph& g) { return g[v].is_corner; });
  return paths;
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

// the paths of the graph, in local coordinates, and the vertices in which they end
template <class GeomTraits>
std::vector<Fitted_curve> curves_to_fit(const Wireframe_skeleton<GeomTraits>& skeleton,
                                        const Wireframe_graph<GeomTraits>& graph, std::vector<Vector>& vertices)
{
  typedef typename boost::graph_traits<Wireframe_graph<GeomTraits>>::vertex_descriptor Vertex;
  std::vector<std::size_t> vertex_of_node(boost::num_vertices(graph), Fitted_curve::no_vertex);
  const auto vertex = [&](Vertex v) {
    if (vertex_of_node[v] == Fitted_curve::no_vertex)
    {
      vertex_of_node[v] = vertices.size();
      vertices.push_back(skeleton.to_local(get(CGAL::vertex_point, graph, v)));
    }
    return vertex_of_node[v];
  };
  std::vector<Fitted_curve> curves;
  for (const std::vector<Vertex>& path : split_into_paths(graph))
  {
    if (path.size() < 2)
      continue;
    Fitted_curve curve;
    for (Vertex v : path)
      curve.path.push_back(skeleton.to_local(get(CGAL::vertex_point, graph, v)));
    const bool is_free_loop = path.front() == path.back() && !graph[path.front()].is_corner;
    for (int e = 0; e < 2; ++e)
      curve.vertices[e] = is_free_loop ? Fitted_curve::no_vertex : vertex(e == 0 ? path.front() : path.back());
    curves.push_back(curve);
  }
  return curves;
}

template <class GeomTraits>
Wireframe<GeomTraits> fit(const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe_graph<GeomTraits>& graph,
                          const Extraction_options& options, const std::function<bool(double)>& proceed)
{
  typedef typename GeomTraits::FT FT;
  Wireframe<GeomTraits> wireframe;
  wireframe.sampling_distance = skeleton.sampling_distance();
  if (skeleton.support_size() == 0)
    return wireframe;
  std::vector<Vector> vertices;
  std::vector<Fitted_curve> curves = curves_to_fit(skeleton, graph, vertices);
  if (curves.empty())
    return wireframe;

  fit_network(skeleton.data(), options, vertices, curves, proceed);
  for (const Vector& v : vertices)
    wireframe.vertices.push_back(skeleton.to_point(v));
  for (const Fitted_curve& fitted : curves)
  {
    Wireframe_curve<GeomTraits> curve;
    curve.spline = to_spline(fitted.spline, fitted.is_closed_without_vertex() || fitted.is_loop(), skeleton);
    if (!fitted.is_closed_without_vertex())
    {
      curve.source = fitted.vertices[0];
      curve.target = fitted.vertices[1];
    }
    curve.root_mean_square = FT(fitted.root_mean_square * skeleton.data().unit);
    curve.maximum_deviation = FT(fitted.maximum_deviation * skeleton.data().unit);
    curve.support = fitted.support;
    wireframe.curves.push_back(curve);
  }
  return wireframe;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_H
