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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACTION_REQUEST_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACTION_REQUEST_H

#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/options/points_in_memory.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What the whole extraction is asked for, in plain values.
struct Extraction_request
{
  Extraction_options options;
  double sampling_distance = 0.; // 0: it is estimated
  std::size_t points_in_memory = 0;
  bool skip_invalid = false;
  bool is_reading_timed = false;
  std::function<bool(double)> callback; // may be empty
};

template <class NamedParameters>
Extraction_request extraction_request(const NamedParameters& np, bool is_reading_timed)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Extraction_request request;
  request.options = given_options(np);
  request.sampling_distance = CGAL::to_double(choose_parameter(get_parameter(np, internal_np::sampling_distance), 0.));
  request.points_in_memory = points_in_memory(np);
  request.skip_invalid = choose_parameter(get_parameter(np, internal_np::skip_invalid), false);
  request.is_reading_timed = is_reading_timed;
  request.callback = choose_parameter(get_parameter(np, CGAL::internal_np::callback), std::function<bool(double)>());
  return request;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACTION_REQUEST_H
