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

#ifndef CGAL_EXTRACT_WIREFRAME_H
#define CGAL_EXTRACT_WIREFRAME_H

#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Range_source.h>
#include <CGAL/Wireframe_extraction/internal/cloud/cloud_access.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/call_extract_wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <functional>

namespace CGAL {

/*!
\ingroup PkgWireframeExtractionFunctions

extracts the parametric wireframe of a shape from a dense point cloud of its surface. Every point may carry an estimate
of its distance to the nearest sharp feature curve; where there are no distances, they are
estimated from the points alone.

The function chains `estimate_sampling_distance()`, `estimate_distance_field()` if there are no distances,
`select_skeleton()`, `contract_skeleton()`, `refine_field()`,
`detect_corners()`, `segment_curves()`, `build_topological_graph()`, `fit_curves()`, `recognize_curve_types()` and
`find_doubts()`, which extend the method of \cgalCite{MAZB21}; every named parameter of these functions can be
given. The result does not depend on the order of the points or the number of threads, and moves and scales with the
cloud, up to rounding. What visitor, callback and property maps throw is passed on.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam PointRange a model of `ConstRange` whose iterators are forward iterators
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the cloud
\param np an optional sequence of named parameters, those of the stages and:
\cgalNamedParamsBegin
  \wireframeParamPointMap
  \cgalParamNBegin{distance_map}
    \cgalParamDescription{a property map from the value type of `points` to the distance to the nearest sharp feature}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the second of a pair of a point and a number, or the property `distance` of a
                      `CGAL::Point_set_3`; otherwise, `estimate_distance_field()` makes the
                      distances}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_fold}
    \cgalParamDescription{where the distances are estimated: the least angle, in degrees, by which the surface has to be
                          folded at a sharp feature}
    \cgalParamType{`double`}
    \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the noise level of the field, in multiples of r, at most 1}
    \cgalParamType{`double`}
    \cgalParamDefault{what `refine_field()` finds, or `Distance_field::noise_level` of an estimated field}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
  \cgalParamNBegin{sampling_distance}
    \cgalParamDescription{the sampling distance r of the cloud, in its unit}
    \cgalParamType{`double`}
    \cgalParamDefault{what `estimate_sampling_distance()` finds}
    \cgalParamExtra{0 stands for the default.}
  \cgalParamNEnd
  \cgalParamNBegin{points_in_memory}
    \cgalParamDescription{up to how many points are copied; a larger cloud is gone over several times instead}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{1048576}
    \cgalParamExtra{The result is the same, up to rounding. A cloud without distances is copied whatever its size.}
  \cgalParamNEnd
  \wireframeParamSkipInvalid
  \cgalParamNBegin{use_creases}
    \cgalParamDescription{whether `refine_field()` corrects the field by the surface}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{recognize_types}
    \cgalParamDescription{whether `recognize_curve_types()` replaces splines by lines, circles and ellipses}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{extraction_report}
    \cgalParamDescription{a reference to what shall tell how the extraction went: `std::ref(report)`}
    \cgalParamType{`std::reference_wrapper<Wireframe_extraction_report>`}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that sees the result of each stage; pass `std::ref(visitor)` to keep it}
    \cgalParamType{a model of `WireframeExtractionVisitor`, or a `std::reference_wrapper` of one}
    \cgalParamDefault{`Wireframe_extraction::Default_visitor`}
  \cgalParamNEnd
  \wireframeParamCallback
  \wireframeParamCloudTraits
\cgalNamedParamsEnd

\return the wireframe. It is empty if the input is invalid, if there is no feature, or after cancelling; the report
says which.

Complexity: O(n log n) for n points. Beyond the cloud itself, memory goes to at most `points_in_memory` points and to
those around the features; without distances, to all points.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class PointRange,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
Wireframe<GeomTraits>
#else
Wireframe<typename Wireframe_extraction::internal::Cloud_access<PointRange, NamedParameters>::Geom_traits>
#endif
extract_wireframe(const PointRange& points, const NamedParameters& np = CGAL::parameters::default_values())
{
  namespace internal = Wireframe_extraction::internal;
  typedef internal::Cloud_access<PointRange, NamedParameters> Access;
  const Access access(points, np);
  internal::Range_source<PointRange, Access> source(points, access);
  return internal::call_extract_wireframe<ConcurrencyTag>(source, access.traits(), np, false);
}

/*!
\ingroup PkgWireframeExtractionFunctions

extracts the parametric wireframe of a shape from a cloud that need not be in memory. It is read once, or
several times if it has more than `points_in_memory` points; what is kept of it are so many points and those around the
features. The result is that of
`extract_wireframe()` for the same points.

\tparam GeomTraits a model of `WireframeExtractionTraits_3`, for instance a kernel
\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param source the cloud, for instance an `IO::Distance_cloud_file`. If it cannot be read, the report has the reason. If
it has no distances, they are estimated, for which all of its points are in memory.
\param np an optional sequence of named parameters: those of `extract_wireframe()`, except `point_map` and
`distance_map`

\return the wireframe. It is empty if the input is invalid, if there is no feature, or after cancelling; the report
says which.

Complexity: O(n log n) for n points. A cloud of more than `points_in_memory` points is read five times, four times
if its field is precise or without `use_creases`.
*/
template <class GeomTraits, class ConcurrencyTag = CGAL::Parallel_if_available_tag,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Wireframe<GeomTraits> extract_wireframe_from_source(Wireframe_extraction::Distance_cloud_source& source,
                                                    const NamedParameters& np = CGAL::parameters::default_values())
{
  const GeomTraits traits =
    CGAL::parameters::choose_parameter<GeomTraits>(CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits));
  return Wireframe_extraction::internal::call_extract_wireframe<ConcurrencyTag>(source, traits, np, true);
}

} // namespace CGAL

#endif // CGAL_EXTRACT_WIREFRAME_H
