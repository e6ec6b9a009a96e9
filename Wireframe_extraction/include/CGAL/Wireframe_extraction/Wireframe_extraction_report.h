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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_EXTRACTION_REPORT_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_EXTRACTION_REPORT_H

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// What happened during an extraction.
struct Wireframe_extraction_report
{
  /// how an extraction ended
  enum class Status
  {
    SUCCESS,       ///< there is a wireframe
    INVALID_INPUT, ///< the cloud or a parameter cannot be right; `message` says why
    NO_FEATURE,    ///< the cloud has no sharp feature
    CANCELLED      ///< the callback returned `false`
  };

  Status status = Status::SUCCESS;           ///< how the extraction ended
  std::string message;                       ///< why there is no wireframe, in one line
  std::vector<std::string> warnings;         ///< what looks odd but did no harm
  std::size_t number_of_points = 0;          ///< points of the cloud
  std::size_t number_of_skipped_points = 0;  ///< points left out since they are invalid
  std::size_t number_of_duplicates = 0;      ///< points near features left out since they repeat others
  std::size_t number_of_strays = 0;          ///< points near features left out since they are farther than
                                             ///< 10<sup>9</sup> sampling distances from the others
  std::size_t skeleton_size = 0;             ///< points of the skeleton
  std::size_t number_of_corners = 0;         ///< vertices of the wireframe in which curves meet
  std::size_t number_of_free_ends = 0;       ///< vertices of the wireframe in which a single curve ends
  std::size_t number_of_clusters = 0;        ///< groups of points that curves start from
  std::size_t number_of_curves = 0;          ///< curves of the wireframe
  std::size_t number_of_doubtful_curves = 0; ///< of these, the ones with `Wireframe_curve::doubts`
  std::vector<std::string> regularities;     ///< what `regularize` made equal, coaxial, parallel or orthogonal: a line
                                             ///< for each group, with indices of curves
  bool is_field_estimated = false;           ///< whether the distances come from the points alone, by
                                             ///< `Wireframe_extraction::estimate_distance_field()`
  std::size_t number_of_near_points = 0;     ///< of such a field: points that see a feature
  double point_noise = 0.;       ///< of such a field: standard deviation of the points across the surface, in
                                 ///< the cloud's unit
  double sampling_distance = 0.; ///< in the cloud's unit
  double noise = 0.;             ///< noise level of the field, in the cloud's unit: what
                                 ///< `Wireframe_skeleton::noise()` returns after the refinement
  double rms = 0.;               ///< of the residuals of all curves, in the cloud's unit
  double max = 0.;               ///< largest residual of a supporting point, in the cloud's unit
  std::vector<std::pair<std::string, double>> seconds; ///< duration of the stages, in their order
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_EXTRACTION_REPORT_H
