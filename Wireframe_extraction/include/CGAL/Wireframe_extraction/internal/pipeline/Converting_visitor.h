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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CONVERTING_VISITOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CONVERTING_VISITOR_H

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/base/coordinates.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Plain_visitor.h>
#include <CGAL/Wireframe_extraction/internal/spline/Wireframe_converter.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Hands what a stage made over to a user's visitor, with the numbers and points that this one knows.
template <class GeomTraits, class Visitor>
class Converting_visitor : public Plain_visitor
{
  typedef typename GeomTraits::FT FT;
  typedef typename GeomTraits::Point_3 Point_3;

  Visitor& m_visitor;
  const GeomTraits& m_traits;
  Plain_traits m_plain;

public:
  Converting_visitor(Visitor& visitor, const GeomTraits& traits) : m_visitor(visitor), m_traits(traits) {}

  void sampling_distance_estimated(double unit) override { m_visitor.sampling_distance_estimated(unit); }

  void field_estimated(const Distance_field& field) override { m_visitor.field_estimated(field); }

  void skeleton_selected(const Skeleton& skeleton) override
  {
    const Wireframe_skeleton<GeomTraits> converted = convert(skeleton);
    m_visitor.skeleton_selected(converted);
  }

  void skeleton_contracted(const Skeleton& skeleton) override
  {
    const Wireframe_skeleton<GeomTraits> converted = convert(skeleton);
    m_visitor.skeleton_contracted(converted);
  }

  void corners_detected(const Skeleton& skeleton, const Corners& corners) override
  {
    const Wireframe_skeleton<GeomTraits> converted = convert(skeleton);
    std::vector<Wireframe_corner<GeomTraits>> converted_corners;
    for (const Wireframe_corner<Plain_traits>& corner : corners)
      converted_corners.push_back({convert(corner.center), FT(corner.radius), corner.members});
    m_visitor.corners_detected(converted, converted_corners);
  }

  void curves_segmented(const Skeleton& skeleton, const Clusters& clusters) override
  {
    const Wireframe_skeleton<GeomTraits> converted = convert(skeleton);
    m_visitor.curves_segmented(converted, clusters);
  }

  void graph_built(const Graph& graph) override
  {
    Wireframe_graph<GeomTraits> converted(num_vertices(graph));
    for (const auto v : CGAL::make_range(vertices(graph)))
    {
      put(CGAL::vertex_point, converted, v, convert(get(CGAL::vertex_point, graph, v)));
      converted[v] = graph[v];
    }
    for (const auto e : CGAL::make_range(edges(graph)))
      add_edge(source(e, graph), target(e, graph), graph[e], converted);
    m_visitor.graph_built(converted);
  }

  void curves_fitted(const Result& wireframe) override
  {
    const CGAL::Wireframe<GeomTraits> converted = convert(wireframe);
    m_visitor.curves_fitted(converted);
  }

  void types_recognized(const Result& wireframe) override
  {
    const CGAL::Wireframe<GeomTraits> converted = convert(wireframe);
    m_visitor.types_recognized(converted);
  }

private:
  Point_3 convert(const Plain_traits::Point_3& p) const
  {
    return m_traits.construct_point_3_object()(FT(p[0]), FT(p[1]), FT(p[2]));
  }

  // which shares its data
  Wireframe_skeleton<GeomTraits> convert(const Skeleton& skeleton) const
  {
    return Wireframe_skeleton<GeomTraits>(skeleton.data(), m_traits);
  }

  CGAL::Wireframe<GeomTraits> convert(const Result& wireframe) const
  {
    return Wireframe_converter<Plain_traits, GeomTraits>(m_plain, m_traits)(wireframe);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CONVERTING_VISITOR_H
