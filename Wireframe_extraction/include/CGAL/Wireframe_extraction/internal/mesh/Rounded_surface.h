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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUNDED_SURFACE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUNDED_SURFACE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Triangle_mesh.h>
#include <CGAL/Wireframe_extraction/internal/mesh/sharp_edges.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The curved surface that the facets of a mesh approximate. It passes through the vertices, where its normals are the
// mean of those of the facets around, and is flat where there are no facets of a curved surface.
class Rounded_surface
{
public:
  Rounded_surface(const Triangle_mesh& mesh, const Sharp_edges& sharp);

  // the point above that of a triangle with these barycentric coordinates
  Vector operator()(std::size_t triangle, const std::array<double, 3>& coordinates) const;

private:
  const Triangle_mesh& m_mesh;
  std::vector<std::array<Vector, 3>> m_normals; // at the corners of triangles
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/mesh/Rounded_surface_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUNDED_SURFACE_H
