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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_FIND_UNIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_FIND_UNIT_H

#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_scale.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>

#include <string>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The one rule by which the numbers of a surveyed cloud are refused, for the whole extraction and for stages that are
// called alone. Finds the sampling distance, for the report: the given one, or the measured one if 0 is given. The
// cloud is measured by `run(function)`, which returns false after cancelling. If the cloud is refused, the report has
// the status and the reason.
template <class Run>
bool find_unit(const Surveyed_cloud& cloud, double given, const Extraction_options& options,
               Wireframe_extraction_report& report, const Run& run)
{
  const auto refuse = [&report](const std::string& message) {
    report.status = Wireframe_extraction_report::Status::INVALID_INPUT;
    report.message = message;
    return false;
  };
  if (!check_dimension(cloud, report))
    return refuse(report.message);
  Cloud_scale scale;
  if (!run([&] { scale = cloud.scale(); }))
    return false;
  if (!cloud.error().empty())
    return refuse(cloud.error());
  const double unit = given > 0. ? given : scale.sampling_distance;
  if (!check_scale(cloud, scale, given, report) || !check_resolution(cloud, unit, report)
      || (cloud.has_distances() && !check_truncation(cloud, unit, options, report)))
    return refuse(report.message);
  report.sampling_distance = unit;
  return true;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_FIND_UNIT_H
