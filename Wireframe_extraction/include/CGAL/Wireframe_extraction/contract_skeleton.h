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

#ifndef CGAL_WIREFRAME_EXTRACTION_CONTRACT_SKELETON_H
#define CGAL_WIREFRAME_EXTRACTION_CONTRACT_SKELETON_H

#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/contract.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

contracts a skeleton to the curves that the field draws: for every point, a local curve is fitted to the distances of
the points around it, sum of rho(d_i - |p_i - c|) -> min, starting at the main axis of the points weighted by
exp(-(d/r)^2). The point's foot on that curve, the tangent there and the residual of the fit are kept with it.
Balls of several radii around `fitting_radius` are tried, and the largest one that fits as well as any is taken.

If the noise level is below 0.03 r, the field is *precise*: it knows better than the surface where curves are, and the
points around the skeleton that `select_skeleton()` kept are let go.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton what `select_skeleton()` returns
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{fitting_radius}
    \cgalParamDescription{the radius of the balls that the local fits take their points from, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the noise level of the field, in multiples of r, at most 1}
    \cgalParamType{`double`}
    \cgalParamDefault{the median of the residuals}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
  \wireframeParamCallback{After cancelling, the skeleton is as it was before.}
  \wireframeParamReport
\cgalNamedParamsEnd

\return whether the skeleton is contracted. It is as it was before if not: after cancelling, or if a parameter is out
of its range; the report says which.

Complexity: O(n (log n + k)) for n points with k neighbors each. The result is the same for all tags.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool contract_skeleton(Wireframe_skeleton<GeomTraits>& skeleton,
                       const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  if (!call.is_well())
    return false;
  return internal::run_concurrently<ConcurrencyTag>(
    [&] { return internal::contract(skeleton.data(), call.options(), call.progress()); });
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_CONTRACT_SKELETON_H
