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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_SELECTED_SKELETON_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_SELECTED_SKELETON_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/internal/field/select_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/options/points_in_memory.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/survey_for_stage.h>
#include <CGAL/Wireframe_extraction/parameters.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The skeleton of a cloud, for the stage that is called alone; empty if the report has something to say.
template <class NamedParameters>
Skeleton_data selected_skeleton(Distance_cloud_source& source, Stage_call& call, const NamedParameters& np)
{
  typedef Wireframe_extraction_report::Status Status;
  Surveyed_cloud cloud(source, points_in_memory(np));
  if (!survey_for_stage(cloud, call, given_sampling_distance(np), np))
    return Skeleton_data();
  const double unit = call.report().sampling_distance;
  Skeleton_data skeleton = select_skeleton(cloud, unit, call.options());
  if (call.options().use_creases && skeleton.size() > 0)
    select_surroundings(cloud, call.options(), skeleton);
  if (!cloud.error().empty())
  {
    call.fail(Status::INVALID_INPUT, cloud.error());
    return Skeleton_data();
  }
  if (skeleton.size() == 0)
    call.fail(Status::NO_FEATURE, no_feature_message(cloud, unit, call.options().skeleton_distance));
  return skeleton;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_SELECTED_SKELETON_H
