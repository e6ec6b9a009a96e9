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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_SELECT_SKELETON_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_SELECT_SKELETON_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/options/points_in_memory.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/survey_for_stage.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/find_skeleton.h>
#include <CGAL/Wireframe_extraction/parameters.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The skeleton of a cloud whose sampling distance is known; empty if the report has something to say.
inline Skeleton_data skeleton_of(const Surveyed_cloud& cloud, double unit, const Extraction_options& options,
                                 Wireframe_extraction_report& report)
{
  typedef Wireframe_extraction_report::Status Status;
  Skeleton_data skeleton = find_skeleton(cloud, unit, options);
  if (options.use_creases && skeleton.size() > 0)
    find_surroundings(cloud, options, skeleton);
  if (!cloud.error().empty())
  {
    report.status = Status::INVALID_INPUT;
    report.message = cloud.error();
    return Skeleton_data();
  }
  if (skeleton.size() == 0)
  {
    report.status = Status::NO_FEATURE;
    report.message = no_feature_message(cloud, unit, options.skeleton_distance);
  }
  return skeleton;
}

// The same for the stage that is called alone.
template <class NamedParameters>
Skeleton_data call_select_skeleton(Distance_cloud_source& source, Stage_call& call, const NamedParameters& np)
{
  Surveyed_cloud cloud(source, points_in_memory(np));
  if (!survey_for_stage(cloud, call, given_sampling_distance(np), np))
    return Skeleton_data();
  if (!cloud.has_distances())
  {
    call.fail(Wireframe_extraction_report::Status::INVALID_INPUT,
              "the points have no distances to features; estimate_distance_field() finds them");
    return Skeleton_data();
  }
  return skeleton_of(cloud, call.report().sampling_distance, call.options(), call.report());
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_SELECT_SKELETON_H
