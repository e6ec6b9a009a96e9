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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUND_POLYLINE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUND_POLYLINE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Polylines of tessellated curves are chords of arcs. Returns the polyline with finer chords where its segments turn on
// as those of an arc do, and as it is elsewhere. Its points stay. A closed polyline ends where it starts.
std::vector<Vector> round_polyline(const std::vector<Vector>& polyline);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/mesh/round_polyline_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUND_POLYLINE_H
