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

#ifndef CGAL_WIREFRAME_EXTRACTION_SELECT_SKELETON_H
#define CGAL_WIREFRAME_EXTRACTION_SELECT_SKELETON_H

#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Range_source.h>
#include <CGAL/Wireframe_extraction/internal/cloud/cloud_access.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/call_select_skeleton.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

selects the points near sharp features: the skeleton, whose distances are below `skeleton_distance`, and around it the
points below `support_distance`, which later stages fit to.

\tparam PointRange a model of `ConstRange` whose iterators are forward iterators
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the cloud
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \wireframeParamPointMap
  \cgalParamNBegin{distance_map}
    \cgalParamDescription{a property map from the value type of `points` to the distance to the nearest sharp feature}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the second of a pair, or the property `distance` of a `CGAL::Point_set_3`}
  \cgalParamNEnd
  \cgalParamNBegin{sampling_distance}
    \cgalParamDescription{the sampling distance r, in the cloud's unit}
    \cgalParamType{`double`}
    \cgalParamDefault{what `estimate_sampling_distance()` finds}
    \cgalParamExtra{0 stands for the default.}
  \cgalParamNEnd
  \cgalParamNBegin{skeleton_distance}
    \cgalParamDescription{the threshold below which a point belongs to the skeleton, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{1.5}
  \cgalParamNEnd
  \cgalParamNBegin{support_distance}
    \cgalParamDescription{the threshold below which a point supports the fits, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{fitting_radius}
    \cgalParamDescription{the radius of the balls in which later stages fit, in multiples of r; points within twice
                          as much of the skeleton are kept for `refine_field()`}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{points_in_memory}
    \cgalParamDescription{up to how many points are copied; a larger cloud is gone over several times instead}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{1048576}
  \cgalParamNEnd
  \cgalParamNBegin{use_creases}
    \cgalParamDescription{whether the points around the skeleton are kept for `refine_field()`, which otherwise does
                          nothing}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \wireframeParamSkipInvalid
  \wireframeParamReport
  \wireframeParamCloudTraits
\cgalNamedParamsEnd

\return the skeleton; it is empty if no point lies below the threshold, if the cloud is one that `extract_wireframe()`
refuses: without points, with invalid ones that are not to be skipped, with all points at one place or on one line, with
distances that do not fit the points or are cut off too near the features; or if a parameter is out
of its range. The report says which.

Complexity: O(n) for n points and O(m log m) for the m points kept, after the estimation of the sampling distance.
*/
template <class PointRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
[[nodiscard]] Wireframe_skeleton<GeomTraits>
#else
[[nodiscard]] Wireframe_skeleton<typename internal::Cloud_access<PointRange, NamedParameters>::Geom_traits>
#endif
select_skeleton(const PointRange& points, const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(
    internal::Cloud_access<PointRange, NamedParameters>::has_distances,
    "pass the distances of the points to features with the named parameter distance_map(), for instance what "
    "estimate_distance_field() makes of the points");
  const internal::Cloud_access<PointRange, NamedParameters> access(points, np);
  internal::Range_source<PointRange, internal::Cloud_access<PointRange, NamedParameters>> source(points, access);
  internal::Stage_call call(np);
  return {internal::call_select_skeleton(source, call, np), access.traits()};
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_SELECT_SKELETON_H
