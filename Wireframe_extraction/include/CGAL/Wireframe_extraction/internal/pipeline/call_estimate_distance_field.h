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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_ESTIMATE_DISTANCE_FIELD_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_ESTIMATE_DISTANCE_FIELD_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Range_source.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/cloud_access.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/estimate_best_field.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/estimate_distances.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/survey_for_stage.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/property_map.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The field of a cloud, for the stage that is called alone; empty if the report has something to say, unless that is
// that no feature was found.
template <class NamedParameters>
Distance_field call_estimate_distance_field(Distance_cloud_source& source, Stage_call& call, const NamedParameters& np)
{
  typedef Wireframe_extraction_report::Status Status;
  Surveyed_cloud cloud(source, (std::numeric_limits<std::size_t>::max)());
  const double given = given_sampling_distance(np);
  if (!survey_for_stage(cloud, call, given, np))
    return Distance_field();
  Best_field best;
  if (!estimate_best_field(cloud, call.report().sampling_distance, given > 0., call.options().minimum_fold,
                           call.progress(), best))
    return Distance_field();
  call.report().sampling_distance = best.field.sampling_distance;
  report_field(best.field, call.report());
  if (best.means)
    call.report().warnings.push_back(best.warning);
  if (best.field.number_of_near_points == 0)
    call.fail(Status::NO_FEATURE, no_fold_message(call.options().minimum_fold));
  return best.field;
}

// puts a value to each element of a range
template <class Range, class Map>
void put_values(Range& range, const Map& map, const std::vector<double>& values)
{
  typedef typename boost::property_traits<Map>::value_type Value;
  std::size_t i = 0;
  for (auto&& element : range)
    put(map, element, Value(values[i++]));
}

// the same of a range, whose maps get what is estimated, if they can
template <class ConcurrencyTag, class PointRange, class NamedParameters>
Distance_field call_estimate_distance_field(PointRange& points, const NamedParameters& np)
{
  typedef Cloud_access<PointRange, NamedParameters> Access;
  const Access access(points, np);
  Range_source<PointRange, Access, false> source(points, access);
  Stage_call call(np);
  Distance_field field =
    run_concurrently<ConcurrencyTag>([&] { return call_estimate_distance_field(source, call, np); });
  if (field.is_empty())
    return field;
  constexpr bool is_map_given =
    !CGAL::parameters::is_default_parameter<NamedParameters, internal_np::distance_map_t>::value;
  if constexpr (is_map_given || (Access::has_distances && !std::is_const<PointRange>::value))
    put_values(points, access.distance_map(), field.distances);
  if constexpr (!CGAL::parameters::is_default_parameter<NamedParameters, internal_np::deviation_map_t>::value)
    put_values(points, CGAL::parameters::get_parameter(np, internal_np::deviation_map), field.deviations);
  return field;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_ESTIMATE_DISTANCE_FIELD_H
