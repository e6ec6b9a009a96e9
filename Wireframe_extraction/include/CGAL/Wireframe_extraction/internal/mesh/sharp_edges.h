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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_EDGES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_EDGES_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// which edges of a mesh are sharp
struct Sharp_edge_options
{
  double minimum_fold = 20.;       // degrees: smaller folds are smooth
  double maximum_facet_fold = 50.; // degrees: larger folds are no facets of a curved surface, however regular they are
  bool use_boundaries = false;     // whether edges of one face only are sharp
  double resolution = 0.;          // a length: small folds have to be there at this scale, too
};

struct Sharp_edges
{
  std::vector<std::uint32_t> edges;        // of the mesh, rising
  std::vector<std::uint32_t> folded_edges; // without those along which a curve fades, and without boundaries
  std::vector<double> folds;       // of all edges of the mesh, degrees; positive on the side of the normals' tips; 0 of
                                   // edges that have not two faces
  std::vector<bool> is_facet_edge; // of all edges: folded as facets of a curved surface are
  double minimum_fold = 20.;       // degrees, as of the options
  double largest_turn = 50.;       // degrees, by which the chords of a curve turn
  std::size_t number_of_facet_edges = 0; // larger than the minimum fold
  std::size_t number_of_boundary_edges = 0, number_of_non_manifold_edges = 0;
};

Sharp_edges find_sharp_edges(const Triangle_mesh& mesh, const Sharp_edge_options& options);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/mesh/sharp_edges_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_EDGES_H
