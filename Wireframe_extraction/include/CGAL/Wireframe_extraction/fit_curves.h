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

#ifndef CGAL_WIREFRAME_EXTRACTION_FIT_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_FIT_CURVES_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/fit/Spline_network_fit.h>

#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

namespace internal {

template <class Graph>
struct Path_collector
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  std::vector<std::vector<Vertex>>& paths;

  void start_new_polyline() { paths.emplace_back(); }
  void add_node(Vertex v) { paths.back().push_back(v); }
  void end_polyline() {}
};

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // a false one, about edges of Boost that CGAL collects
#endif

// the paths between vertices that are corners, or have a degree other than 2
template <class Graph>
std::vector<std::vector<typename boost::graph_traits<Graph>::vertex_descriptor>> split_into_paths(const Graph& graph)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Vertex;
  std::vector<std::vector<Vertex>> paths;
  Path_collector<Graph> collector{paths};
  CGAL::split_graph_into_polylines(graph, collector, [](Vertex v, const Graph& g) { return g[v].is_corner; });
  return paths;
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

template <class GeomTraits>
Spline_curve_3<GeomTraits> to_spline(const Cubic_spline& spline, bool is_closed,
                                     const Wireframe_skeleton<GeomTraits>& skeleton)
{
  typedef typename GeomTraits::FT FT;
  const Spline_data data = spline.to_data();
  std::vector<FT> knots;
  std::vector<typename GeomTraits::Point_3> points;
  for (double t : data.knots)
    knots.push_back(FT(t * skeleton.unit()));
  for (const Spline_vector& p : data.points)
    points.push_back(skeleton.to_point(Vector(p.x, p.y, p.z)));
  return Spline_curve_3<GeomTraits>(data.degree, knots, points, is_closed, skeleton.traits());
}

// the given noise level, or that of the contracted skeleton
template <class GeomTraits>
double noise_of(const Wireframe_skeleton<GeomTraits>& skeleton, const Extraction_options& options)
{
  return options.noise_or(skeleton.is_contracted() ? skeleton.contraction().noise : 0.1);
}

// the paths of the graph, in local coordinates, and the vertices in which they end
template <class GeomTraits>
std::vector<Fitted_curve> curves_to_fit(const Wireframe_skeleton<GeomTraits>& skeleton,
                                        const Wireframe_graph<GeomTraits>& graph, std::vector<Vector>& vertices)
{
  typedef typename boost::graph_traits<Wireframe_graph<GeomTraits>>::vertex_descriptor Vertex;
  std::vector<std::size_t> vertex_of_node(boost::num_vertices(graph), Fitted_curve::no_vertex);
  const auto vertex = [&](Vertex v) {
    if (vertex_of_node[v] == Fitted_curve::no_vertex)
    {
      vertex_of_node[v] = vertices.size();
      vertices.push_back(skeleton.to_local(get(CGAL::vertex_point, graph, v)));
    }
    return vertex_of_node[v];
  };
  std::vector<Fitted_curve> curves;
  for (const std::vector<Vertex>& path : split_into_paths(graph))
  {
    if (path.size() < 2)
      continue;
    Fitted_curve curve;
    for (Vertex v : path)
      curve.path.push_back(skeleton.to_local(get(CGAL::vertex_point, graph, v)));
    const bool is_free_loop = path.front() == path.back() && !graph[path.front()].is_corner;
    for (int e = 0; e < 2; ++e)
      curve.vertices[e] = is_free_loop ? Fitted_curve::no_vertex : vertex(e == 0 ? path.front() : path.back());
    curves.push_back(curve);
  }
  return curves;
}

template <class GeomTraits>
Wireframe<GeomTraits> fit(const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe_graph<GeomTraits>& graph,
                          const Extraction_options& options, const std::function<bool(double)>& proceed)
{
  typedef typename GeomTraits::FT FT;
  Wireframe<GeomTraits> wireframe;
  wireframe.sampling_distance = skeleton.sampling_distance();
  if (skeleton.support_size() == 0)
    return wireframe;
  std::vector<Vector> vertices;
  const std::vector<Fitted_curve> curves = curves_to_fit(skeleton, graph, vertices);
  if (curves.empty())
    return wireframe;

  const double noise = noise_of(skeleton, options);
  Spline_network_fit fit(skeleton.band(), noise, options, vertices, curves);
  fit.run(proceed);

  for (const Vector& v : fit.vertices())
    wireframe.vertices.push_back(skeleton.to_point(v));
  for (const Fitted_curve& fitted : fit.curves())
  {
    Wireframe_curve<GeomTraits> curve;
    curve.spline = to_spline(fitted.spline, fitted.is_closed_without_vertex() || fitted.is_loop(), skeleton);
    if (!fitted.is_closed_without_vertex())
    {
      curve.source = fitted.vertices[0];
      curve.target = fitted.vertices[1];
    }
    curve.root_mean_square = FT(fitted.root_mean_square * skeleton.unit());
    curve.maximum_deviation = FT(fitted.maximum_deviation * skeleton.unit());
    curve.support = fitted.support;
    wireframe.curves.push_back(curve);
  }
  return wireframe;
}

} // namespace internal

/*!
\ingroup PkgWireframeExtractionFunctions

fits one cubic B-spline to every path of the topological graph, all at once: the sum over the points near the curves of
rho(d_j - |p_j - gamma(u_j)|) is minimized (eq. 3 of \cgalCite{MAZB21}, with a robust loss) over the control points by
Ceres with analytic derivatives. The curves that meet in a corner share it as a parameter, so that it moves to where
they meet; closed curves without corner are periodic, so that position and tangent agree where they close. Between the
rounds, the feet of the points are found anew, and knots are added where residuals ask for them. Changes of curvature
along a spline cost the more the noisier the field is, so that splines do not follow the noise; lines and arcs are free.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton
\param graph the topological graph
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{support_distance}
    \cgalParamDescription{how far from the curves points may lie that are fitted to, in multiples of r; at most what
                          `select_skeleton()` kept}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the noise level of the field, in multiples of r, at most 1}
    \cgalParamType{`double`}
    \cgalParamDefault{what `contract_skeleton()` or `refine_field()` found; 0.1 if the skeleton is not contracted}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
  \cgalParamNBegin{use_robust_loss}
    \cgalParamDescription{whether residuals well above the noise level lose influence}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{move_corners}
    \cgalParamDescription{whether the corners move to where the curves meet}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{adapt_knots}
    \cgalParamDescription{whether knots are placed by residual; otherwise they are the vertices of the paths}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_rounds}
    \cgalParamDescription{how often the feet of the points are found and the splines fitted}
    \cgalParamType{`int`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that is called with the share that is done and returns whether to go on}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{unused}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the wireframe. After cancelling, its curves are as far as the fit had come.

Complexity: O(n log n) for n points per round, besides the solution of the sparse normal equations.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Wireframe<GeomTraits> fit_curves(const Wireframe_skeleton<GeomTraits>& skeleton,
                                               const Wireframe_graph<GeomTraits>& graph,
                                               const NamedParameters& np = CGAL::parameters::default_values())
{
  const std::function<bool(double)> proceed = internal::progress_callback(np);
  const internal::Extraction_options options = internal::extraction_options(np);
  return internal::run_concurrently<ConcurrencyTag>([&] { return internal::fit(skeleton, graph, options, proceed); });
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_FIT_CURVES_H
