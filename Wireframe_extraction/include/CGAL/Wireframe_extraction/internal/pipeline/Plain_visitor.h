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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_PLAIN_VISITOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_PLAIN_VISITOR_H

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A visitor of the extraction, which is compiled for plain numbers. This one does nothing.
class Plain_visitor
{
public:
  typedef Wireframe_skeleton<Plain_traits> Skeleton;
  typedef std::vector<Wireframe_corner<Plain_traits>> Corners;
  typedef std::vector<std::vector<std::size_t>> Clusters;
  typedef Wireframe_graph<Plain_traits> Graph;
  typedef CGAL::Wireframe<Plain_traits> Result;

  virtual ~Plain_visitor() {}

  virtual void sampling_distance_estimated(double) {}
  virtual void field_estimated(const Distance_field&) {}
  virtual void skeleton_selected(const Skeleton&) {}
  virtual void skeleton_contracted(const Skeleton&) {}
  virtual void corners_detected(const Skeleton&, const Corners&) {}
  virtual void curves_segmented(const Skeleton&, const Clusters&) {}
  virtual void graph_built(const Graph&) {}
  virtual void curves_fitted(const Result&) {}
  virtual void types_recognized(const Result&) {}
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_PLAIN_VISITOR_H
