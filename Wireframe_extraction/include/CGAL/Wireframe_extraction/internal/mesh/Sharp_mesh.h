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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_MESH_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_MESH_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Polygon_soup.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_curves.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Triangle_mesh.h>
#include <CGAL/Wireframe_extraction/internal/mesh/sharp_edges.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

struct Sharp_mesh_options
{
  double sampling_distance = 0.;                 // 0: from the shape
  std::size_t maximum_number_of_points = 200000; // that a cloud may have if its sampling distance comes from the shape
  double minimum_fold = 20.;                     // as of Sharp_edge_options
  double maximum_facet_fold = 50.;
  bool use_boundaries = false;
  std::uint32_t random_seed = 0;
};

// a mesh, where it is sharp, and what it is
struct Sharp_mesh
{
  Triangle_mesh mesh;
  Sharp_edges sharp;
  Sharp_curves curves;
  Mesh_kind kind = Mesh_kind::CAD;
};

// points on a mesh, and their distances to its sharp edges
struct Mesh_samples
{
  std::vector<Vector> points;
  std::vector<double> distances;
  double sampling_distance = 0.;
};

// returns what is wrong, nothing if all went well
std::string make_sharp_mesh(const Polygon_soup& soup, const Sharp_mesh_options& options, Sharp_mesh& result);

// Points all over a mesh, evenly spread. Distances are cut off at 50 sampling distances. There are no points if
// `proceed(share)`, which may be empty, says so.
Mesh_samples sample_mesh(const Sharp_mesh& mesh, const Sharp_mesh_options& options,
                         const std::function<bool(double)>& proceed);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_mesh_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_MESH_H
