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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGLE_MESH_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGLE_MESH_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Polygon_soup.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Triangles that know their neighbors. Points at the same place are one; triangles without area, and those that are
// there twice, are left out. Neighbors are oriented alike where that is possible.
struct Triangle_mesh
{
  typedef std::array<std::uint32_t, 3> Triangle;
  static constexpr std::uint32_t none = 0xffffffffu;

  // A whole edge of triangles, or a piece of one that others end on (a T-junction).
  struct Edge
  {
    std::uint32_t source, target;
    std::array<std::uint32_t, 2> faces = {none, none}; // the first two
    std::uint32_t number_of_faces = 0;
    bool is_split = false; // its pieces are edges of their own
  };

  std::vector<Vector> points;
  std::vector<Triangle> triangles;
  std::vector<Vector> normals; // of the triangles, of length one
  std::vector<double> areas;
  std::vector<Edge> edges;
  std::vector<std::array<std::uint32_t, 3>> edges_of_triangles; // from the k-th to the next vertex
  double area = 0., diagonal = 0.;
  std::size_t number_of_degenerate = 0, number_of_duplicates = 0; // faces that were left out
  std::size_t number_of_t_junctions = 0;                          // edges that were split

  bool is_boundary(const Edge& edge) const { return edge.number_of_faces == 1 && !edge.is_split; }
};

// Returns what is wrong with the soup, nothing if it can be used: an index without a point, a coordinate that is not
// finite, a polygon of fewer than three points.
std::string check_soup(const Polygon_soup& soup);

// of a soup that is as it has to be
Triangle_mesh make_triangle_mesh(const Polygon_soup& soup);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/mesh/Triangle_mesh_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGLE_MESH_H
