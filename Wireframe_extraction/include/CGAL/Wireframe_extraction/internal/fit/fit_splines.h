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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_SPLINES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_SPLINES_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/fit/Fitted_curve.h>
#include <CGAL/Wireframe_extraction/internal/fit/graph_paths.h>
#include <CGAL/Wireframe_extraction/internal/fit/to_spline.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Fits the splines of all curves, and moves the vertices in which they meet. `proceed(share)` returns whether to go on;
// this returns whether it did.
bool fit_splines(const Skeleton_data& skeleton, const Extraction_options& options, std::vector<Vector>& vertices,
                 std::vector<Fitted_curve>& curves, const std::function<bool(double)>& proceed);

template <class GeomTraits>
Polyline_graph plain_graph(const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe_graph<GeomTraits>& graph)
{
  Polyline_graph result;
  for (const auto v : CGAL::make_range(vertices(graph)))
  {
    result.points.push_back(skeleton.to_local(get(CGAL::vertex_point, graph, v)));
    result.is_corner.push_back(graph[v].is_corner);
  }
  for (const auto e : CGAL::make_range(edges(graph)))
    result.edges.emplace_back(source(e, graph), target(e, graph));
  return result;
}

template <class GeomTraits>
Wireframe<GeomTraits> fit_splines(const Wireframe_skeleton<GeomTraits>& skeleton,
                                  const Wireframe_graph<GeomTraits>& graph, const Extraction_options& options,
                                  const std::function<bool(double)>& proceed)
{
  typedef typename GeomTraits::FT FT;
  Wireframe<GeomTraits> wireframe;
  wireframe.sampling_distance = skeleton.sampling_distance();
  if (skeleton.support_size() == 0)
    return wireframe;
  std::vector<Vector> vertices;
  std::vector<Fitted_curve> curves = curves_to_fit(plain_graph(skeleton, graph), vertices);
  if (curves.empty())
    return wireframe;

  fit_splines(skeleton.data(), options, vertices, curves, proceed);
  for (const Vector& v : vertices)
    wireframe.vertices.push_back(skeleton.to_point(v));
  for (const Fitted_curve& fitted : curves)
  {
    Wireframe_curve<GeomTraits> curve;
    curve.spline = to_spline(fitted.spline, fitted.is_closed_without_vertex() || fitted.is_loop(), skeleton);
    if (!fitted.is_closed_without_vertex())
    {
      curve.source = fitted.vertices[0];
      curve.target = fitted.vertices[1];
    }
    curve.rms = FT(fitted.root_mean_square * skeleton.data().unit);
    curve.max = FT(fitted.maximum_deviation * skeleton.data().unit);
    curve.support = fitted.support;
    wireframe.curves.push_back(curve);
  }
  return wireframe;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/fit/fit_splines_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_SPLINES_H
