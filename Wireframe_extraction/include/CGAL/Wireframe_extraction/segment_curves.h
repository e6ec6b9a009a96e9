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

#ifndef CGAL_WIREFRAME_EXTRACTION_SEGMENT_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_SEGMENT_CURVES_H

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/network/separate_curves.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

segments the points of a skeleton outside the corners into curves: the connected components of a graph of neighbors.

With `use_tangents`, two points are neighbors only if their feet are close, their tangents agree and each foot lies on
the other one's local curve. That separates curves that cross or run side by side. Without, any two points closer than
`connection_radius` are neighbors, as published.

\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton. \pre `skeleton.is_contracted()` if `use_tangents`
\param corners the corners; their members belong to no curve
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{connection_radius}
    \cgalParamDescription{the distance below which points are connected, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{connection_angle}
    \cgalParamDescription{the angle between tangents up to which they agree, in degrees}
    \cgalParamType{`double`}
    \cgalParamDefault{30}
  \cgalParamNEnd
  \cgalParamNBegin{use_tangents}
    \cgalParamDescription{whether tangents have to agree}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \wireframeParamReport
  \wireframeParamCallback{After cancelling, there are no curves, and the status in the report is `CANCELLED`.}
\cgalNamedParamsEnd

\return for every curve the indices of its points in the skeleton, in ascending order. The curves are sorted by their
first points. There is none if a parameter is out of its range, or after cancelling; the report has the reason.

Complexity: O(n log n + n k) for n points with k neighbors each.
*/
template <class GeomTraits, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<std::vector<std::size_t>> segment_curves(
  const Wireframe_skeleton<GeomTraits>& skeleton, const std::vector<Wireframe_corner<GeomTraits>>& corners,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  if (!call.is_well())
    return {};
  return internal::separate_curves(skeleton, corners, call.options(), call.progress());
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_SEGMENT_CURVES_H
