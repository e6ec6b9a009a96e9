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

#ifndef CGAL_WIREFRAME_EXTRACTION_DEFAULT_VISITOR_H
#define CGAL_WIREFRAME_EXTRACTION_DEFAULT_VISITOR_H

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

/// \ingroup PkgWireframeExtractionClasses
/// A visitor that does nothing. Derive from it, and define the functions for the stages of interest.
///
/// \cgalModels{WireframeExtractionVisitor}
struct Default_visitor
{
  /// is called with the sampling distance, in the cloud's unit.
  void sampling_distance_estimated(double) {}

  /// is called with the field that was estimated, if the cloud has no distances.
  void field_estimated(const Distance_field&) {}

  /// is called with the skeleton.
  template <class GeomTraits>
  void skeleton_selected(const Wireframe_skeleton<GeomTraits>&)
  {}

  /// is called with the contracted skeleton, after the field was refined.
  template <class GeomTraits>
  void skeleton_contracted(const Wireframe_skeleton<GeomTraits>&)
  {}

  /// is called with the corners.
  template <class GeomTraits>
  void corners_detected(const Wireframe_skeleton<GeomTraits>&, const std::vector<Wireframe_corner<GeomTraits>>&)
  {}

  /// is called with the points of the curves.
  template <class GeomTraits>
  void curves_segmented(const Wireframe_skeleton<GeomTraits>&, const std::vector<std::vector<std::size_t>>&)
  {}

  /// is called with the topological graph.
  template <class Graph>
  void graph_built(const Graph&)
  {}

  /// is called with the wireframe, whose curves are splines.
  template <class GeomTraits>
  void curves_fitted(const Wireframe<GeomTraits>&)
  {}

  /// is called with the wireframe in which lines, circles and ellipses were recognized.
  template <class GeomTraits>
  void types_recognized(const Wireframe<GeomTraits>&)
  {}
};

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_DEFAULT_VISITOR_H
