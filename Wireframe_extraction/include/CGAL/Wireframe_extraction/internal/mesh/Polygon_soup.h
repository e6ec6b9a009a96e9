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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_POLYGON_SOUP_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_POLYGON_SOUP_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Points, and polygons by the indices of their points.
struct Polygon_soup
{
  std::vector<Vector> points;
  std::vector<std::vector<std::size_t>> polygons;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_POLYGON_SOUP_H
