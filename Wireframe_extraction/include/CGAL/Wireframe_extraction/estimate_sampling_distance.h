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

#ifndef CGAL_WIREFRAME_EXTRACTION_ESTIMATE_SAMPLING_DISTANCE_H
#define CGAL_WIREFRAME_EXTRACTION_ESTIMATE_SAMPLING_DISTANCE_H

#include <CGAL/Wireframe_extraction/internal/cloud/Range_source.h>
#include <CGAL/Wireframe_extraction/internal/cloud/cloud_access.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/call_estimate_sampling_distance.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

estimates the sampling distance r of a cloud: the mean distance of a point to its nearest neighbor in a Poisson-disk
cloud of the same density, r = sqrt(0.82 * area per point).

The area per point comes from the discs that reach to the 16th neighbor, the median over at most 4096 points, so that
neither duplicates nor outliers matter. These are spread evenly over the ranks of the distances to features; points
without distances are chosen by a hash of their positions. So the order of the cloud does not matter. The estimate is
right for Poisson-disk clouds and for uniformly random ones alike; there, the mean distance to the nearest neighbor is
only about 0.55 r.

\tparam PointRange a model of `ConstRange` whose iterators are forward iterators
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the cloud
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \wireframeParamPointMap
  \cgalParamNBegin{distance_map}
    \cgalParamDescription{a property map from the value type of `points` to the distance to the nearest sharp feature}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the second of a pair, or the property `distance` of a `CGAL::Point_set_3`; bare points need none}
  \cgalParamNEnd
  \cgalParamNBegin{points_in_memory}
    \cgalParamDescription{up to how many points are copied; a larger cloud is gone over several times instead}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{1048576}
  \cgalParamNEnd
  \wireframeParamSkipInvalid
  \wireframeParamReport
  \wireframeParamCloudTraits
\cgalNamedParamsEnd

\return the sampling distance in the cloud's unit; 0 if the cloud is one that `extract_wireframe()` refuses: without
points, with invalid ones that are not to be skipped, with all points at one place or on one line, or with distances
that do not fit the points. The report says which.

Complexity: O(n log n) for n points.
*/
template <class PointRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] double estimate_sampling_distance(const PointRange& points,
                                                const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef internal::Cloud_access<PointRange, NamedParameters> Access;
  const Access access(points, np);
  internal::Range_source<PointRange, Access> source(points, access);
  internal::Stage_call call(np);
  return internal::call_estimate_sampling_distance(source, call, np);
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_ESTIMATE_SAMPLING_DISTANCE_H
