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

#ifndef CGAL_WIREFRAME_EXTRACTION_SHARP_MESH_REPORT_H
#define CGAL_WIREFRAME_EXTRACTION_SHARP_MESH_REPORT_H

#include <CGAL/Wireframe_extraction/policies.h>

#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {

/// \ingroup PkgWireframeExtractionClasses
/// What was found about a mesh, and how it was sampled.
struct Sharp_mesh_report
{
  Mesh_kind kind = Mesh_kind::CAD;              ///< what the mesh is of
  double area = 0.;                             ///< of its faces
  double sampling_distance = 0.;                ///< of the cloud, in the unit of the mesh; 0 if none was made
  std::size_t number_of_triangles = 0;          ///< with an area, and only once each
  std::size_t number_of_sharp_edges = 0;        ///< edges of the mesh
  std::size_t number_of_sharp_curves = 0;       ///< polylines of sharp edges, from corner to corner, or closed
  std::size_t number_of_corners = 0;            ///< vertices where more than two sharp edges meet
  std::size_t number_of_loose_ends = 0;         ///< inner vertices where one sharp edge ends, or two meet at an angle
  std::size_t number_of_facet_edges = 0;        ///< folded edges that belong to the facets of a curved surface
  std::size_t number_of_boundary_edges = 0;     ///< edges of one face only
  std::size_t number_of_non_manifold_edges = 0; ///< edges of more than two faces
  std::size_t number_of_degenerate_faces = 0;   ///< triangles without area that were left out
  std::size_t number_of_duplicate_faces = 0;    ///< triangles that were there twice
  std::size_t number_of_t_junctions = 0;        ///< edges on which others end
};

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_SHARP_MESH_REPORT_H
