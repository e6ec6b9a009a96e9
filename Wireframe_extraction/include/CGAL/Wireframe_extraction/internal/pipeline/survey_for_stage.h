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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_SURVEY_FOR_STAGE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_SURVEY_FOR_STAGE_H

#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/find_unit.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// the sampling distance that is given to a stage; 0 if it is to be measured
template <class NamedParameters>
double given_sampling_distance(const NamedParameters& np)
{
  return CGAL::to_double(
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::sampling_distance), 0.));
}

// Reads a cloud for the first time for a stage that is called alone, finds its sampling distance for the report, and
// refuses what the whole extraction does.
template <class NamedParameters>
bool survey_for_stage(Surveyed_cloud& cloud, Stage_call& call, double given, const NamedParameters& np)
{
  const bool skip_invalid =
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::skip_invalid), false);
  if (!call.is_well())
    return false;
  Wireframe_extraction_report& report = call.report();
  report.warnings.clear(); // they are about a cloud, and here it is seen for the first time
  if (!survey(cloud, skip_invalid, report))
    return call.fail(Wireframe_extraction_report::Status::INVALID_INPUT, report.message);
  return find_unit(cloud, given, call.options(), report, [](const auto& measure) {
    measure();
    return true;
  });
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_SURVEY_FOR_STAGE_H
