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

#ifndef CGAL_WIREFRAME_EXTRACTION_FIND_DOUBTS_H
#define CGAL_WIREFRAME_EXTRACTION_FIND_DOUBTS_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/call_find_doubts.h>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

notes why curves of a finished wireframe may be wrong, in `Wireframe_curve::doubts`. Nothing else is changed, and what
is there already, such as the `Wireframe_doubt::UNCERTAIN_TYPE` of `recognize_curve_types()`, stays. The manual has the
threshold of each reason.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton
\param wireframe the wireframe that `fit_curves()` or `recognize_curve_types()` makes from it
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \wireframeParamReport
  \wireframeParamCallback
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the standard deviation of the distances, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{what `contract_skeleton()` or `refine_field()` found}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return `true` on success. It is `false` if a parameter is out of its range, or after cancelling; then some doubts may
be missing.

Complexity: O(n log n) for n points.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool find_doubts(const Wireframe_skeleton<GeomTraits>& skeleton, Wireframe<GeomTraits>& wireframe,
                 const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  return internal::call_find_doubts<ConcurrencyTag>(skeleton, wireframe, call);
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_FIND_DOUBTS_H
