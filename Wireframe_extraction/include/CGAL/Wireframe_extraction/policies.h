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

#ifndef CGAL_WIREFRAME_EXTRACTION_POLICIES_H
#define CGAL_WIREFRAME_EXTRACTION_POLICIES_H

namespace CGAL {
namespace Wireframe_extraction {

/// \ingroup PkgWireframeExtractionParameters
/// What tells a corner from the inside of a curve.
enum class Corner_measure
{
  FIELD_RESIDUAL, ///< how badly a single curve explains the distance field around a point
  VARIANCE        ///< the second explained variance ratio of the points in a ball (eq. 1 of \cgalCite{MAZB21})
};

/// \ingroup PkgWireframeExtractionParameters
/// How the topological graph comes about.
enum class Graph_method
{
  TRACED,    ///< curves are traced through the field and joined where their ends meet
  SUBDIVIDED ///< a polyline per cluster is subdivided (eq. 2 of \cgalCite{MAZB21}) and joined to the nearest corners
};

/// \ingroup PkgWireframeExtractionParameters
/// Which points of a cluster are its ends, for `Graph_method::SUBDIVIDED`.
enum class End_detection
{
  GRAPH_DISTANCE, ///< two points farthest from each other along the neighborhood graph
  MAIN_AXIS       ///< the extremes along the direction of largest variance
};

/// \ingroup PkgWireframeExtractionParameters
/// What becomes of the distances that overlapping patches give to the same point.
enum class Patch_fusion
{
  MINIMUM, ///< the smallest: the patches that see the feature count
  MEDIAN   ///< the median, the mean of the middle two if their number is even: single wrong patches do not count
};

/// \ingroup PkgWireframeExtractionParameters
/// What a mesh is of.
enum class Mesh_kind
{
  CAD, ///< a shape: its edges are edges of the mesh, which can be sampled
  SCAN ///< points that were measured, and joined to triangles: the vertices are a cloud, without distances
};

/// \ingroup PkgWireframeExtractionParameters
/// Where the distances of a cloud in a file come from.
enum class Field_origin
{
  GIVEN,     ///< the file has them; if it has none, that is an error
  ESTIMATED, ///< they are estimated from the points; those in the file are not looked at
  AUTOMATIC  ///< they are estimated if the file has none
};

/// \ingroup PkgWireframeExtractionParameters
/// What one unit of the coordinates is, for formats that say so. Coordinates are never converted.
enum class Length_unit
{
  MICROMETER, ///< 0.001 mm
  MILLIMETER, ///< 1 mm
  CENTIMETER, ///< 10 mm
  METER,      ///< 1000 mm
  INCH,       ///< 25.4 mm
  FOOT        ///< 304.8 mm
};

/// \ingroup PkgWireframeExtractionParameters
/// The application protocol of ISO 10303 that a STEP file follows.
enum class Step_schema
{
  AP214, ///< automotive design; what every program reads
  AP242  ///< managed model-based 3D engineering, its successor
};

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_POLICIES_H
