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
#include <CGAL/Wireframe_extraction/internal/fit/fit_splines.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {

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
  \wireframeParamCallback
  \wireframeParamReport
\cgalNamedParamsEnd

\return the wireframe. After cancelling, its curves are as far as the fit had come, without residuals and support. It is
empty if a parameter is out of its range. The report says what happened.

Complexity: O(n log n) for n points per round, besides the solution of the sparse normal equations.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Wireframe<GeomTraits> fit_curves(const Wireframe_skeleton<GeomTraits>& skeleton,
                                               const Wireframe_graph<GeomTraits>& graph,
                                               const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  if (!call.is_well())
    return Wireframe<GeomTraits>();
  return internal::run_concurrently<ConcurrencyTag>(
    [&] { return internal::fit_splines(skeleton, graph, call.options(), call.progress()); });
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_FIT_CURVES_H
