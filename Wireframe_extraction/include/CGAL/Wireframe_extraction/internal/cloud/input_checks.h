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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_INPUT_CHECKS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_INPUT_CHECKS_H

#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_scale.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Reads the cloud for the first time; returns false, with a message, if it cannot be read or has points that must not
// be skipped.
bool survey(Surveyed_cloud& cloud, bool skip_invalid, Wireframe_extraction_report& report);

// The dimension of the affine hull, up to rounding, of some points without the outermost tenth: a single outlier must
// not make the rest look like a point.
int dimension(const std::vector<Vector>& positions, const std::vector<std::size_t>& sample);

int dimension(const std::vector<Vector>& positions);

// whether the points are more than those of a line; those of a plane are odd
bool check_dimension(const Surveyed_cloud& cloud, Wireframe_extraction_report& report);

// whether points, distances if they are known, and a sampling distance given by the caller (or 0) have the same unit
bool check_scale(const Surveyed_cloud& cloud, const Cloud_scale& scale, double given,
                 Wireframe_extraction_report& report);

// Whether a field that was cut off at some distance is known as far as the stages need it. The share of the points that
// have the largest distance tells whether it was cut off.
bool check_resolution(const Surveyed_cloud& cloud, double unit, Wireframe_extraction_report& report);

bool check_truncation(const Surveyed_cloud& cloud, double unit, const Extraction_options& options,
                      Wireframe_extraction_report& report);

std::string no_feature_message(const Surveyed_cloud& cloud, double unit, double threshold);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_INPUT_CHECKS_H
