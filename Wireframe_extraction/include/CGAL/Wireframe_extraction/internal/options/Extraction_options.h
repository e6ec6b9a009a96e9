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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_EXTRACTION_OPTIONS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_EXTRACTION_OPTIONS_H

#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// All that a user may set, with the defaults; thresholds of a single step stand in its own file. Lengths are in
// multiples of the sampling distance, angles in degrees; a negative value stands for "follows from the cloud".
struct Extraction_options
{
  double minimum_fold = 20.;
  double noise_level = -1.;
  double skeleton_distance = 1.5;
  double support_distance = 3.;
  double fitting_radius = 4.;
  bool use_creases = true;
  Corner_measure corner_measure = Corner_measure::FIELD_RESIDUAL;
  double corner_sampling_ratio = 0.1;
  double corner_radius = 4.;
  double corner_variance = 0.3;
  double corner_residual = -1.;
  double connection_radius = 3.;
  double connection_angle = 30.;
  bool use_tangents = true;
  Graph_method graph_method = Graph_method::TRACED;
  End_detection end_detection = End_detection::GRAPH_DISTANCE;
  double split_threshold = 4.;
  double corner_reach = 5.;
  double maximum_gap = 18.;
  double smooth_angle = 20.;
  double minimum_evidence = 2.;
  bool use_robust_loss = true;
  bool move_corners = true;
  bool adapt_knots = true;
  int number_of_rounds = 3;
  bool recognize_types = true;
  double type_significance = 0.001;
  bool regularize = false;

  // the given noise level, or what was found in the field
  double noise_or(double found) const { return noise_level >= 0. ? (std::min)(1., noise_level) : found; }
};

// Says which option is out of its range; empty if none is.
inline std::string out_of_range(const Extraction_options& options)
{
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  struct Range
  {
    const char* name;
    double value, least, most;
    bool is_least_allowed;
  };
  const Range ranges[] = {{"minimum_fold", options.minimum_fold, 0., 180., false},
                          {"noise_level", options.noise_level, -infinity, 1., false},
                          {"skeleton_distance", options.skeleton_distance, 0., infinity, false},
                          {"support_distance", options.support_distance, 0., infinity, false},
                          {"fitting_radius", options.fitting_radius, 0., infinity, false},
                          {"corner_sampling_ratio", options.corner_sampling_ratio, 0., 1., false},
                          {"corner_radius", options.corner_radius, 0., infinity, false},
                          {"corner_variance", options.corner_variance, 0., 1., true},
                          {"corner_residual", options.corner_residual, -infinity, infinity, false},
                          {"connection_radius", options.connection_radius, 0., infinity, false},
                          {"connection_angle", options.connection_angle, 0., 90., true},
                          {"split_threshold", options.split_threshold, 0., infinity, false},
                          {"corner_reach", options.corner_reach, 0., infinity, true},
                          {"maximum_gap", options.maximum_gap, 0., infinity, true},
                          {"smooth_angle", options.smooth_angle, 0., 180., true},
                          {"minimum_evidence", options.minimum_evidence, 0., infinity, true},
                          {"number_of_rounds", double(options.number_of_rounds), 1., 1000., true},
                          {"type_significance", options.type_significance, 0., 1., false}};
  std::ostringstream message;
  for (const Range& range : ranges)
  {
    const bool is_above = range.is_least_allowed ? range.value >= range.least : range.value > range.least;
    if (std::isfinite(range.value) && is_above && range.value <= range.most)
      continue;
    message << range.name << " is " << range.value << "; it must be finite";
    if (range.least > -infinity)
      message << (range.is_least_allowed ? ", at least " : ", more than ") << range.least;
    if (range.most < infinity)
      message << ", at most " << range.most;
    break;
  }
  return message.str();
}

// as they were given, in their ranges or not
template <class NamedParameters>
Extraction_options given_options(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Extraction_options options;
#define CGAL_WIREFRAME_READ_LENGTH(name) \
  options.name = CGAL::to_double(choose_parameter(get_parameter(np, internal_np::name), options.name))
#define CGAL_WIREFRAME_READ(name) options.name = choose_parameter(get_parameter(np, internal_np::name), options.name)
  CGAL_WIREFRAME_READ_LENGTH(minimum_fold);
  CGAL_WIREFRAME_READ_LENGTH(noise_level);
  CGAL_WIREFRAME_READ_LENGTH(skeleton_distance);
  CGAL_WIREFRAME_READ_LENGTH(support_distance);
  CGAL_WIREFRAME_READ_LENGTH(fitting_radius);
  CGAL_WIREFRAME_READ(use_creases);
  CGAL_WIREFRAME_READ(corner_measure);
  CGAL_WIREFRAME_READ_LENGTH(corner_sampling_ratio);
  CGAL_WIREFRAME_READ_LENGTH(corner_radius);
  CGAL_WIREFRAME_READ_LENGTH(corner_variance);
  CGAL_WIREFRAME_READ_LENGTH(corner_residual);
  CGAL_WIREFRAME_READ_LENGTH(connection_radius);
  CGAL_WIREFRAME_READ_LENGTH(connection_angle);
  CGAL_WIREFRAME_READ(use_tangents);
  CGAL_WIREFRAME_READ(graph_method);
  CGAL_WIREFRAME_READ(end_detection);
  CGAL_WIREFRAME_READ_LENGTH(split_threshold);
  CGAL_WIREFRAME_READ_LENGTH(corner_reach);
  CGAL_WIREFRAME_READ_LENGTH(maximum_gap);
  CGAL_WIREFRAME_READ_LENGTH(smooth_angle);
  CGAL_WIREFRAME_READ_LENGTH(minimum_evidence);
  CGAL_WIREFRAME_READ(use_robust_loss);
  CGAL_WIREFRAME_READ(move_corners);
  CGAL_WIREFRAME_READ(adapt_knots);
  CGAL_WIREFRAME_READ(number_of_rounds);
  CGAL_WIREFRAME_READ(recognize_types);
  CGAL_WIREFRAME_READ_LENGTH(type_significance);
  CGAL_WIREFRAME_READ(regularize);
#undef CGAL_WIREFRAME_READ_LENGTH
#undef CGAL_WIREFRAME_READ
  return options;
}

// where there is nobody to tell that values are out of their ranges: they are the caller's error
template <class NamedParameters>
Extraction_options extraction_options(const NamedParameters& np)
{
  const Extraction_options options = given_options(np);
  CGAL_precondition_msg(out_of_range(options).empty(), out_of_range(options).c_str());
  return options;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_EXTRACTION_OPTIONS_H
