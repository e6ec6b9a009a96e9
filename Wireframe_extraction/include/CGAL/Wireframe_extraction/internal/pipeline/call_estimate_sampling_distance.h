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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_ESTIMATE_SAMPLING_DISTANCE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_ESTIMATE_SAMPLING_DISTANCE_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/options/points_in_memory.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/survey_for_stage.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The sampling distance of a cloud, as estimate_sampling_distance() measures it; 0 if the cloud is refused.
template <class NamedParameters>
double call_estimate_sampling_distance(Distance_cloud_source& source, Stage_call& call, const NamedParameters& np)
{
  Surveyed_cloud cloud(source, points_in_memory(np));
  return survey_for_stage(cloud, call, 0., np) ? call.report().sampling_distance : 0.;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_ESTIMATE_SAMPLING_DISTANCE_H
