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

#ifndef CGAL_WIREFRAME_EXTRACTION_ESTIMATE_DISTANCE_FIELD_H
#define CGAL_WIREFRAME_EXTRACTION_ESTIMATE_DISTANCE_FIELD_H

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/call_estimate_distance_field.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/tags.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

estimates for each point of a cloud its distance to the nearest sharp feature, from the points alone: for clouds without
a distance field, such as scans. `extract_wireframe()` calls it where there are no distances.

A sharp feature is a fold: a place where two smooth sheets explain the points of a ball better than one does, by
evidence at the noise that the points show. Folds are looked for in two ways, by height functions with one or several
folds through all points of a ball, and by the sheets of single faces, where those of different neighbors meet and both
end there. Each point votes for where the fold is; the votes that neighbors confirm are the
features, and the distances are those to them.

Tight fillets are folds only if their radius is well below the balls, and surfaces that bend evenly with radii of 3 r or
more have none; the boundary of an open cloud is none either.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam PointRange a model of `Range` whose iterators are forward iterators; a model of
`ConstRange` if no map is written to
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the cloud
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \wireframeParamPointMap
  \cgalParamNBegin{distance_map}
    \cgalParamDescription{a property map from the value type of `points`, to which the distances are written, too}
    \cgalParamType{a model of `WritablePropertyMap` with a number type as value type}
    \cgalParamDefault{the second of a pair of a point and a number, or the property `distance` of a
                      `CGAL::Point_set_3` that has one, unless the range is constant; otherwise none}
    \cgalParamExtra{Nothing is written if the field that is returned is empty.}
  \cgalParamNEnd
  \cgalParamNBegin{deviation_map}
    \cgalParamDescription{the same for the standard deviations of the distances}
    \cgalParamType{a model of `WritablePropertyMap` with a number type as value type}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{sampling_distance}
    \cgalParamDescription{the sampling distance r, in the cloud's unit}
    \cgalParamType{`double`}
    \cgalParamDefault{what `estimate_sampling_distance()` finds}
    \cgalParamExtra{0 stands for the default.}
  \cgalParamNEnd
  \cgalParamNBegin{minimum_fold}
    \cgalParamDescription{the least angle, in degrees, by which the surface has to be folded at a sharp feature; more
                          than 0, at most 180. Flat is 0, the edge of a box is folded by 90 degrees.}
    \cgalParamType{`double`}
    \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{skip_invalid}
    \cgalParamDescription{whether points that are not finite are left out; otherwise they are an error}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{The distance of a point that is left out is no number (NaN), so that later stages with the same
                    parameter leave it out as well.}
  \cgalParamNEnd
  \cgalParamNBegin{extraction_report}
    \cgalParamDescription{a reference to what gets the status and the message, the sampling distance and the noise of
                          the points: `std::ref(report)`}
    \cgalParamType{`std::reference_wrapper<Wireframe_extraction_report>`}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \wireframeParamCallback
  \wireframeParamCloudTraits
\cgalNamedParamsEnd

\return the field. It is empty if there are no points, or invalid ones that are not to be skipped, if all points
coincide or lie on one line, if a parameter is out of its range, or after cancelling; the report says which. If no
feature is found, all distances are `Distance_field::truncation`, and the status is `NO_FEATURE`.

To go on with the field as `extract_wireframe()` does, the stages that follow have to get
`Distance_field::sampling_distance` as `sampling_distance` and `Distance_field::noise_level` as `noise_level`.

Where the points err by more than 0.6 r, the field is that of their means, which lie farther apart:
`Distance_field::sampling_distance` is that of the means, each point has the distance of the nearest one, and the report
has a warning. `extract_wireframe()` goes on with the means then, and not with the points. A
sampling distance that is given is kept.

Complexity: O(n (log n + k)) for n points with k neighbors each. All points are in memory, whatever `points_in_memory`
is. The result does not depend on the order of the points, and is the same for all tags.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class PointRange,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Distance_field estimate_distance_field(PointRange& points,
                                       const NamedParameters& np = CGAL::parameters::default_values())
{
  return internal::call_estimate_distance_field<ConcurrencyTag>(points, np);
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_ESTIMATE_DISTANCE_FIELD_H
