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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FIELD_ESTIMATE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FIELD_ESTIMATE_H

#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The field of a cloud as its points show it. Lengths are in sampling distances.
struct Field_estimate
{
  // No point is farther from a feature than that, as far as it is known.
  static constexpr double truncation = 4.;

  std::vector<double> distances, deviations; // of every point: to the nearest feature, and its standard deviation
  double point_noise = 0.;                   // standard deviation of the points across the surface
  double noise_level = 0.;                   // what the stages that follow shall take the noise of the field for
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FIELD_ESTIMATE_H
