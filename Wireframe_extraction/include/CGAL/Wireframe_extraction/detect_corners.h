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

#ifndef CGAL_WIREFRAME_EXTRACTION_DETECT_CORNERS_H
#define CGAL_WIREFRAME_EXTRACTION_DETECT_CORNERS_H

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/network/find_corners.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>

#include <functional>
#include <vector>

namespace CGAL {

namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

detects where curves meet. Two measures are at hand:
- `Corner_measure::FIELD_RESIDUAL`: groups of points near which no single curve explains the field, that is, whose
  residual after `contract_skeleton()` exceeds `corner_residual`;
- `Corner_measure::VARIANCE`: `corner_sampling_ratio` of the points, chosen by farthest point sampling, are centers of
  balls of radius `corner_radius`; those whose second explained variance ratio exceeds `corner_variance` hold a corner,
  and what the bounding box of connected ones takes belongs to it (eq. 1 of \cgalCite{MAZB21}).

\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton. \pre `skeleton.is_contracted()` if the measure is `FIELD_RESIDUAL`
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{corner_measure}
    \cgalParamDescription{what tells a corner from the inside of a curve}
    \cgalParamType{`Corner_measure`}
    \cgalParamDefault{`Corner_measure::FIELD_RESIDUAL`}
  \cgalParamNEnd
  \cgalParamNBegin{corner_residual}
    \cgalParamDescription{the residual above which a point belongs to a corner, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{0.15 and 1.5 times the noise level}
  \cgalParamNEnd
  \cgalParamNBegin{corner_sampling_ratio}
    \cgalParamDescription{the share of the points that become centers of balls}
    \cgalParamType{`double`}
    \cgalParamDefault{0.1}
  \cgalParamNEnd
  \cgalParamNBegin{corner_radius}
    \cgalParamDescription{the radius of these balls, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{corner_variance}
    \cgalParamDescription{the second explained variance ratio above which a ball holds a corner}
    \cgalParamType{`double`}
    \cgalParamDefault{0.3}
  \cgalParamNEnd
  \cgalParamNBegin{connection_radius}
    \cgalParamDescription{the distance below which points of corner balls are connected, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \wireframeParamReport
  \wireframeParamCallback{After cancelling, there are no corners, and the status in the report is `CANCELLED`.}
\cgalNamedParamsEnd

\return the corners. Their centers are the centroids of their points. There is none if a parameter is out of its range,
or after cancelling; the report has the reason.

Complexity: O(n log n + n k) for n points with k neighbors in a ball.
*/
template <class GeomTraits, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<Wireframe_corner<GeomTraits>> detect_corners(
  const Wireframe_skeleton<GeomTraits>& skeleton, const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  if (!call.is_well())
    return {};
  return internal::find_corners(skeleton, call.options(), call.progress());
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_DETECT_CORNERS_H
