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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_CURVES_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Triangle_mesh.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How the sharp edges of a mesh hang together.
struct Sharp_curves
{
  // The polylines that sharp edges form between the vertices where not two of them meet, or that are turned at, by the
  // indices of their points. Closed ones end where they start.
  std::vector<std::vector<std::uint32_t>> polylines;
  std::vector<double> lengths;
  std::size_t number_of_vertices = 0;   // of sharp edges
  std::size_t number_of_corners = 0;    // where more than two sharp edges meet
  std::size_t number_of_loose_ends = 0; // where one ends, or two of them meet at a sharp angle, within the mesh
};

// Two sharp edges that turn by no more than the largest turn, in degrees, are chords of one curve; those that turn by
// more meet at an angle. There is no third case between these.
Sharp_curves find_sharp_curves(const Triangle_mesh& mesh, const std::vector<std::uint32_t>& sharp_edges,
                               double largest_turn);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_curves_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_CURVES_H
