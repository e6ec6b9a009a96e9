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
#include <CGAL/Wireframe_extraction/internal/Extraction_options.h>

#include <algorithm>
#include <memory>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

contracts a skeleton to the curves that the field draws: for every point, a local curve is fitted to the distances of
the points around it, sum of rho(d_i - |p_i - c|) -> min, starting at the main axis of the points weighted by
exp(-(d/r)^2). The point's foot on that curve, the tangent there and the residual of the fit are kept with it.
Balls of several radii around `fitting_radius` are tried, and the largest one that fits as well as any is taken.

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
  \cgalParamNEnd
\cgalNamedParamsEnd

Complexity: O(n (log n + k)) for n points with k neighbors each; in parallel if TBB is linked, with the same result.
*/
template <class GeomTraits, class NamedParameters = CGAL::parameters::Default_named_parameters>
void contract_skeleton(Wireframe_skeleton<GeomTraits>& skeleton,
                       const NamedParameters& np = CGAL::parameters::default_values())
{
  if (skeleton.support_size() == 0)
    return;
  const internal::Extraction_options options = internal::extraction_options(np);
  auto contraction = std::make_shared<internal::Contraction>(
    internal::contract(skeleton.band(), options.fitting_radius));
  if (options.noise_level >= 0.)
    contraction->noise = (std::min)(1., options.noise_level);
  skeleton.set_contraction(contraction);
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_CONTRACT_SKELETON_H
