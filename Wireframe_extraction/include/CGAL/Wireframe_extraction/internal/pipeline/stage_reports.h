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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_STAGE_REPORTS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_STAGE_REPORTS_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What is told of the results of stages, by whoever runs them one after the other.

inline void report_skeleton(const Skeleton_data& skeleton, Wireframe_extraction_report& report)
{
  report.skeleton_size = skeleton.size();
  report.number_of_duplicates = skeleton.number_of_duplicates;
  report.number_of_strays = skeleton.number_of_strays;
  const auto warn = [&](std::size_t number, const char* reason) {
    if (number > 0)
      report.warnings.push_back("points near features that were left out since they lie " + std::string(reason) + ": "
                                + std::to_string(number));
  };
  warn(report.number_of_duplicates, "exactly where others do");
  warn(report.number_of_strays, "more than 1e9 sampling distances away from the others");
}

inline const char* no_curve_message() { return "no curve explains the field"; }

template <class GeomTraits>
void report_wireframe(const Wireframe<GeomTraits>& wireframe, Wireframe_extraction_report& report)
{
  std::vector<std::size_t> ends(wireframe.vertices.size(), 0);
  double squares = 0., support = 0.;
  report.max = 0.;
  report.number_of_doubtful_curves = 0;
  for (const auto& curve : wireframe.curves)
  {
    if (curve.source != curve.no_vertex)
    {
      ++ends[curve.source];
      ++ends[curve.target];
    }
    squares += CGAL::square(CGAL::to_double(curve.rms)) * double(curve.support);
    support += double(curve.support);
    report.max = (std::max)(report.max, CGAL::to_double(curve.max));
    report.number_of_doubtful_curves += std::size_t(curve.is_doubtful());
  }
  report.rms = support > 0. ? std::sqrt(squares / support) : 0.;
  report.number_of_free_ends = std::count(ends.begin(), ends.end(), std::size_t(1));
  report.number_of_corners = wireframe.vertices.size() - report.number_of_free_ends;
  report.number_of_curves = wireframe.curves.size();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_STAGE_REPORTS_H
