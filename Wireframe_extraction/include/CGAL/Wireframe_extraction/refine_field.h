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

#ifndef CGAL_WIREFRAME_EXTRACTION_REFINE_FIELD_H
#define CGAL_WIREFRAME_EXTRACTION_REFINE_FIELD_H

#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/refine.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

corrects the field by the surface, where the surface shows more: a sharp curve is a crease of the surface, and the
points on both sides tell where it is, often better than the estimated distances do.

At every point of the skeleton a crease is fitted to the points around it: two strips that leave a common local curve,
each with a curvature and a twist of its own. Robust Gauss-Newton steps minimise the distances of the points to the
strips, and, with the weight that the noise of the field allows, the differences between the distances to the curve and
the field's. Balls of several radii around `fitting_radius` are tried, and the one is taken that leaves the least
uncertainty. Creases that are sure, sharper than 20 degrees, are followed step by step, also for up to 40 r where the
field does not see them; the next stages start from these curves. Then all distances are computed anew: from the creases
where they agree with the field or were followed; points for which no crease speaks and around which the surface is flat
are left out; others keep their distances. The skeleton and its contraction are replaced.

Precise fields, whose noise level is below 0.03 r, are left as they are, and so is a skeleton that was selected with
`use_creases(false)`.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton what `select_skeleton()` returns. \pre `skeleton.is_contracted()`, unless it is empty
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{skeleton_distance}
    \cgalParamDescription{the threshold below which a point belongs to the new skeleton, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{1.5}
  \cgalParamNEnd
  \cgalParamNBegin{support_distance}
    \cgalParamDescription{the threshold below which a point supports the fits, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{fitting_radius}
    \cgalParamDescription{the radius of the balls that the fits take their points from, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the noise level of the new field, in multiples of r, at most 1}
    \cgalParamType{`double`}
    \cgalParamDefault{the median of the residuals, or the typical deviation of the creases if that is larger}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
  \wireframeParamCallback{After cancelling, the skeleton is as it was before.}
  \wireframeParamReport
\cgalNamedParamsEnd

\return whether the skeleton is refined, or need not be. It is as it was before if not: after cancelling, or if a
parameter is out of its range; the report says which.

Complexity: O(n (log n + k)) for n points around the skeleton with k neighbors each. The result is the same for all
tags.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
bool refine_field(Wireframe_skeleton<GeomTraits>& skeleton,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  if (!call.is_well())
    return false;
  return internal::run_concurrently<ConcurrencyTag>(
    [&] { return internal::refine(skeleton.data(), call.options(), call.progress()); });
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_REFINE_FIELD_H
