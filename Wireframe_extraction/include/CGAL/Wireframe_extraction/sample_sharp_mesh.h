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

#ifndef CGAL_WIREFRAME_EXTRACTION_SAMPLE_SHARP_MESH_H
#define CGAL_WIREFRAME_EXTRACTION_SAMPLE_SHARP_MESH_H

#include <CGAL/Wireframe_extraction/internal/mesh/call_sample_sharp_mesh.h>
#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
/// \ingroup PkgWireframeExtractionFunctions
/// samples the surface of a mesh whose sharp edges are edges of the mesh, as that of a CAD model, and computes the
/// distance of each point to the nearest sharp edge. The result can be handed to `CGAL::extract_wireframe()`.
///
/// An edge is sharp if its two faces are folded by at least `minimum_fold`, and if it does not belong to the facets by
/// which a curved surface is approximated: a fold is that of a facet if it is at most `maximum_facet_fold`, and if
/// the surface is folded by about as much, in the same direction, where the facets beside it end, which are about
/// as wide. Folds of at most 70 degrees that vanish at half a sampling distance, as slivers have them, are not sharp.
/// Edges of more than two faces are sharp. Where a sharp curve ends within a face, it is followed along edges that are
/// folded by 0.3 times `minimum_fold` or more, for no longer than it is sharp: its fold fades.
///
/// Curves and surfaces are taken to be round where chords and facets approximate something round: sharp edges that turn
/// on as chords of an arc do are replaced by that arc, and between facets that are folded by 3 to `maximum_facet_fold`
/// degrees, the points are moved onto the parabola that has the mean normals at the vertices. So the cloud of a
/// tessellated cylinder is that of a cylinder, with circles.
///
/// Points at the same place are one, polygons are triangulated, triangles without area and triangles that are there
/// twice are left out, and edges on which vertices of others lie are joined with them. The mesh need be neither closed
/// nor oriented.
///
/// Points are evenly spread: none is closer to another one on the same side than 0.9 sampling distances. They depend on
/// `random_seed` alone, and not on the number of threads.
///
/// \tparam PointRange a range of points, with coordinates `x()`, `y()` and `z()`
/// \tparam PolygonRange a range of ranges of integers
/// \tparam Point a type constructible from three `double` coordinates
/// \tparam FT a model of `FieldNumberType` that is constructible from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param points the vertices of the mesh
/// \param polygons its faces: the indices of their vertices in `points`
/// \param cloud the points and their distances, cut off at 50 sampling distances. What it held before is replaced; it
///   is left as it was if the function fails.
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{sampling_distance}
///     \cgalParamDescription{the mean distance of a point to its nearest neighbor, in the unit of the mesh}
///     \cgalParamType{`double`}
///     \cgalParamDefault{such that most sharp curves are longer than 12 sampling distances, if
///                       `maximum_number_of_points` allows it, and that there are at least about 20,000 points}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_number_of_points}
///     \cgalParamDescription{about how many points there may be if `sampling_distance` is not given}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{`200000`}
///   \cgalParamNEnd
///   \cgalParamNBegin{minimum_fold}
///     \cgalParamDescription{the angle, in degrees, between the normals of two faces from which on the edge between
///                           them is sharp}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`20`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_facet_fold}
///     \cgalParamDescription{the angle, in degrees, up to which edges may belong to the facets by which a curved
///                           surface is approximated}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`50`: a cylinder of eight facets is a cylinder, a hexagonal prism is a prism}
///     \cgalParamExtra{With 0, all folds are sharp that are larger than `minimum_fold`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{use_boundaries}
///     \cgalParamDescription{whether edges of one face only are sharp}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{random_seed}
///     \cgalParamDescription{where random numbers start}
///     \cgalParamType{`unsigned int`}
///     \cgalParamDefault{`0`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{a function that is called with the share that is done and returns whether to go on}
///     \cgalParamType{an instance of `std::function<bool(double)>`}
///     \cgalParamDefault{unused}
///   \cgalParamNEnd
///   \cgalParamNBegin{mesh_report}
///     \cgalParamDescription{receives what was found about the mesh}
///     \cgalParamType{`std::reference_wrapper<Sharp_mesh_report>`}
///     \cgalParamDefault{nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what is wrong, and what helps; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if there is a cloud, else `false`: it was cancelled, there are no faces or none
/// has an area, a face has fewer than three
///   vertices or one that does not exist, a coordinate is not finite or beyond 10<sup>150</sup>, or the sampling
///   distance would take more than 50 million points. A mesh without a sharp edge is no error: all distances are
///   50 sampling distances then.
///
/// For n points and m edges, it takes time O(n log n + m log m), and memory for the points and the mesh.
template <class PointRange, class PolygonRange, class Point, class FT, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool sample_sharp_mesh(const PointRange& points, const PolygonRange& polygons, std::vector<std::pair<Point, FT>>& cloud,
                       const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::sampled_sharp_mesh(points, polygons, cloud, np);
}

/// \ingroup PkgWireframeExtractionFunctions
/// tells whether the sharp edges of a mesh are edges of the mesh, or whether it is made of points that were measured.
///
/// Sharp edges are found as in `sample_sharp_mesh()`. Those of a shape form chains, and end at corners. Where
/// triangles join points that were measured, they follow the triangles: they fork, zigzag and break off. So a mesh is a
/// scan if there are more than 0.6 chains per sharp edge, and if in addition more than 4 % of the vertices of sharp
/// edges are loose ends, or more than half of the other edges are folded by more than 2 degrees. A mesh without sharp
/// edges counts as `Mesh_kind::CAD`.
///
/// \tparam PointRange a range of points, with coordinates `x()`, `y()` and `z()`
/// \tparam PolygonRange a range of ranges of integers
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param points the vertices of the mesh
/// \param polygons its faces: the indices of their vertices in `points`
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{minimum_fold}
///     \cgalParamDescription{the angle, in degrees, between the normals of two faces from which on the edge between
///                           them is sharp}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`20`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_facet_fold}
///     \cgalParamDescription{the angle, in degrees, up to which edges may belong to the facets by which a curved
///                           surface is approximated}
///     \cgalParamType{`double`}
///     \cgalParamDefault{`50`: a cylinder of eight facets is a cylinder, a hexagonal prism is a prism}
///     \cgalParamExtra{With 0, all folds are sharp that are larger than `minimum_fold`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{use_boundaries}
///     \cgalParamDescription{whether edges of one face only are sharp}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \cgalParamNBegin{mesh_report}
///     \cgalParamDescription{receives what was found about the mesh}
///     \cgalParamType{`std::reference_wrapper<Sharp_mesh_report>`}
///     \cgalParamDefault{nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what is wrong, and what helps; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return what the mesh is of; `Mesh_kind::CAD` with an `error_message` if it cannot be used, for the reasons of
///   `sample_sharp_mesh()`.
///
/// For m edges, it takes time O(m log m).
template <class PointRange, class PolygonRange, typename CGAL_NP_TEMPLATE_PARAMETERS>
Mesh_kind classify_mesh(const PointRange& points, const PolygonRange& polygons,
                        const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::kind_of_mesh(points, polygons, np);
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_SAMPLE_SHARP_MESH_H
