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

#ifndef CGAL_WIREFRAME_EXTRACTION_BUILD_TOPOLOGICAL_GRAPH_H
#define CGAL_WIREFRAME_EXTRACTION_BUILD_TOPOLOGICAL_GRAPH_H

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/network/build_graph.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

builds the topological graph of a wireframe: polylines that end in corners.

- `Graph_method::TRACED`: from the points of the clusters, best fits first, curves are traced through the field, step by
  step, as long as it agrees with them; then from points that these curves leave unexplained. What is not needed to
  explain the field is dropped, and so is a curve that runs over a smooth surface: where the points around it (kept if
  `use_creases` was not switched off and the field is not precise) are a graph over a plane, a fold of less than 17
  degrees, beyond doubt. The ends of the curves are beliefs about corners, sure across the curve and unsure along it:
  ends whose beliefs agree are joined, ends next to the inside of another curve split it, ends that face each other over
  a gap are bridged, short curves between corners are added where the field asks for them. Splines fitted to the field
  replace the polylines, and their ends are joined in the same way once more. The corners handed over only matter in
  that their points are no seeds.
- `Graph_method::SUBDIVIDED`: every cluster gets a polyline between its two ends, or a triangle if it is a cycle, which
  is subdivided at the point that disagrees most with it while that exceeds `split_threshold` (eq. 2 of
  \cgalCite{MAZB21}); ends join the nearest corner.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton. \pre `skeleton.is_contracted()` if the method is `TRACED`
\param corners the corners
\param clusters the points of the curves, as `segment_curves()` returns them
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{graph_method}
    \cgalParamDescription{how the graph comes about}
    \cgalParamType{`Graph_method`}
    \cgalParamDefault{`Graph_method::TRACED`}
  \cgalParamNEnd
  \cgalParamNBegin{corner_reach}
    \cgalParamDescription{how far from each other ends may lie that are joined in one corner, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{5}
  \cgalParamNEnd
  \cgalParamNBegin{maximum_gap}
    \cgalParamDescription{the widest gap over which ends that face each other are bridged, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{18}
  \cgalParamNEnd
  \cgalParamNBegin{smooth_angle}
    \cgalParamDescription{two curves that meet and turn by less are one curve, in degrees}
    \cgalParamType{`double`}
    \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_evidence}
    \cgalParamDescription{the number of points that must be explained by a curve, and by no other one}
    \cgalParamType{`double`}
    \cgalParamDefault{2}
    \cgalParamExtra{For each r of its length, a curve has to explain 0.35 times as many more.}
  \cgalParamNEnd
  \cgalParamNBegin{fitting_radius}
    \cgalParamDescription{the radius of the balls in which local curves are fitted on the way, for `TRACED`, in
                          multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{connection_radius}
    \cgalParamDescription{the distance below which points of a cluster are connected, for `SUBDIVIDED`, in multiples
                          of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{support_distance}
    \cgalParamDescription{how far from the curves points may lie that splines are fitted to, for `TRACED`, in
                          multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{use_robust_loss}
    \cgalParamDescription{whether residuals well above the noise level lose influence on these splines}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{move_corners}
    \cgalParamDescription{whether corners move to where these splines meet}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{adapt_knots}
    \cgalParamDescription{whether knots of these splines are placed by residual}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{end_detection}
    \cgalParamDescription{which points of a cluster are its ends, for `SUBDIVIDED`}
    \cgalParamType{`End_detection`}
    \cgalParamDefault{`End_detection::GRAPH_DISTANCE`}
  \cgalParamNEnd
  \cgalParamNBegin{split_threshold}
    \cgalParamDescription{the residual above which a polyline is subdivided, for `SUBDIVIDED`, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \wireframeParamCallback
  \wireframeParamReport
\cgalNamedParamsEnd

\return the graph. After cancelling, it holds the curves traced so far. It is empty if a parameter is out of its range.
The report says what happened.

Complexity: `TRACED`: O(n (log n + k)) for n points with k neighbors each; `SUBDIVIDED`: O(n s^2) for clusters of n
points that get s segments.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Wireframe_graph<GeomTraits> build_topological_graph(
  const Wireframe_skeleton<GeomTraits>& skeleton, const std::vector<Wireframe_corner<GeomTraits>>& corners,
  const std::vector<std::vector<std::size_t>>& clusters, const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  if (!call.is_well())
    return Wireframe_graph<GeomTraits>();
  return internal::run_concurrently<ConcurrencyTag>(
    [&] { return internal::build_graph(skeleton, corners, clusters, call.options(), call.progress()); });
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_BUILD_TOPOLOGICAL_GRAPH_H
