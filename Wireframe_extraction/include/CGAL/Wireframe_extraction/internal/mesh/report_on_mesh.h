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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_REPORT_ON_MESH_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_REPORT_ON_MESH_H

#include <CGAL/Wireframe_extraction/Sharp_mesh_report.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_mesh.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// what is to be told about a mesh
inline Sharp_mesh_report report_on_mesh(const Sharp_mesh& mesh)
{
  Sharp_mesh_report report;
  report.kind = mesh.kind;
  report.area = mesh.mesh.area;
  report.number_of_triangles = mesh.mesh.triangles.size();
  report.number_of_sharp_edges = mesh.sharp.edges.size();
  report.number_of_sharp_curves = mesh.curves.lengths.size();
  report.number_of_corners = mesh.curves.number_of_corners;
  report.number_of_loose_ends = mesh.curves.number_of_loose_ends;
  report.number_of_facet_edges = mesh.sharp.number_of_facet_edges;
  report.number_of_boundary_edges = mesh.sharp.number_of_boundary_edges;
  report.number_of_non_manifold_edges = mesh.sharp.number_of_non_manifold_edges;
  report.number_of_degenerate_faces = mesh.mesh.number_of_degenerate;
  report.number_of_duplicate_faces = mesh.mesh.number_of_duplicates;
  report.number_of_t_junctions = mesh.mesh.number_of_t_junctions;
  return report;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_REPORT_ON_MESH_H
