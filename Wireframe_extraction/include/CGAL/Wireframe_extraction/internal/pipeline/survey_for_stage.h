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

#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/parameters.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Reads a cloud for the first time for a stage that is called alone, and refuses what the whole extraction does.
template <class NamedParameters>
bool survey_for_stage(Surveyed_cloud& cloud, Stage_call& call, const NamedParameters& np)
{
  const bool skip_invalid =
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::skip_invalid), false);
  return call.is_well()
    && (survey(cloud, skip_invalid, call.report())
        || call.fail(Wireframe_extraction_report::Status::INVALID_INPUT, call.report().message));
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_SURVEY_FOR_STAGE_H
