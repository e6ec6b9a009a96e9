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

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// What a vertex of a wireframe's topological graph knows besides its position.
struct Wireframe_vertex
{
  bool is_corner = false; ///< whether curves end here; the other vertices lie inside a curve
};

/// \ingroup PkgWireframeExtractionClasses
/// What an edge of a wireframe's topological graph knows.
struct Wireframe_edge
{
  std::size_t curve_id = 0; ///< the curve that the edge is a part of
};

/// \ingroup PkgWireframeExtractionClasses
/// The topological graph of a wireframe: polylines that meet in corners. `get(CGAL::vertex_point, graph)` is the
/// property map of the vertices' positions; `graph[v]` is a `Wireframe_vertex` and `graph[e]` a `Wireframe_edge`.
/// Every curve has at least one vertex that is no corner, and a curve from a corner to itself has two, so that no two
/// edges are parallel.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
using Wireframe_graph =
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS,
                        boost::property<CGAL::vertex_point_t, typename GeomTraits::Point_3, Wireframe_vertex>,
                        Wireframe_edge>;

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_GRAPH_H
