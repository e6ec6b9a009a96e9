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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_GRAPH_PATHS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_GRAPH_PATHS_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/fit/Fitted_curve.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A topological graph in local coordinates.
struct Polyline_graph
{
  std::vector<Vector> points; // of the vertices
  std::vector<char> is_corner;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

// The paths of the graph between corners, and the vertices in which they end.
std::vector<Fitted_curve> curves_to_fit(const Polyline_graph& graph, std::vector<Vector>& vertices);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/fit/graph_paths_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_GRAPH_PATHS_H
