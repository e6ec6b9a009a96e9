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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_GRAPH_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_GRAPH_H

#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// What a vertex of a wireframe's graph knows besides its position.
struct Wireframe_vertex
{
  bool is_corner = false; ///< whether curves end here; the other vertices lie inside a curve
};

/// \ingroup PkgWireframeExtractionClasses
/// What an edge of a wireframe's graph knows.
struct Wireframe_edge
{
  std::size_t curve_id = 0; ///< the curve that the edge is, or is a part of
};

/// \ingroup PkgWireframeExtractionClasses
/// A wireframe as a graph of the Boost Graph Library: its topological graph, polylines that meet in corners, or what
/// `wireframe_graph()` returns, where each curve is an edge. `get(CGAL::vertex_point, graph)` is the
/// property map of the vertices' positions; `graph[v]` is a `Wireframe_vertex` and `graph[e]` a `Wireframe_edge`.
///
/// In the topological graph, every curve has at least one vertex that is no corner, and a curve from a corner to itself
/// has two, so that no two edges are parallel.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
using Wireframe_graph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                        boost::property<CGAL::vertex_point_t, typename GeomTraits::Point_3, Wireframe_vertex>,
                        Wireframe_edge>;

/*!
\ingroup PkgWireframeExtractionFunctions

returns a wireframe as a graph of the Boost Graph Library. Vertex `v` is the wireframe's vertex of that index, with its
position, and each curve that has vertices is an edge from its source to its target, whose `Wireframe_edge::curve_id` is
the index of the curve; edges are in the order of the curves. Curves between the same two vertices become parallel
edges, and a closed curve with a vertex becomes a loop, which counts twice in the degree. A closed curve without vertex
has none to be seen at: it is not in the graph, so look for curves whose source is `Wireframe_curve::no_vertex`.

\tparam GeomTraits a model of `WireframeExtractionTraits_3`

\param wireframe the wireframe. \pre Its curves refer to vertices that exist.

\return the graph; all of its vertices in which curves end are marked as corners.

Complexity: linear in the number of vertices and curves.
*/
template <class GeomTraits>
[[nodiscard]] Wireframe_graph<GeomTraits> wireframe_graph(const Wireframe<GeomTraits>& wireframe)
{
  typedef Wireframe_curve<GeomTraits> Curve;
  Wireframe_graph<GeomTraits> graph(wireframe.vertices.size());
  for (std::size_t i = 0; i < wireframe.vertices.size(); ++i)
    put(CGAL::vertex_point, graph, i, wireframe.vertices[i]);
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
  {
    const Curve& curve = wireframe.curves[i];
    if (curve.source == Curve::no_vertex || curve.target == Curve::no_vertex)
      continue;
    CGAL_precondition(curve.source < wireframe.vertices.size() && curve.target < wireframe.vertices.size());
    add_edge(curve.source, curve.target, Wireframe_edge{i}, graph);
    graph[curve.source].is_corner = graph[curve.target].is_corner = true;
  }
  return graph;
}

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_GRAPH_H
