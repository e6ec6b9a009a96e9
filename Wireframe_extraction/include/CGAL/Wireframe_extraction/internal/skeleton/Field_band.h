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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIELD_BAND_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIELD_BAND_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The points of a cloud that lie near features, with their distances, in units of the sampling distance and
// relative to a common origin. They are sorted by distance, so that what lies under a smaller threshold is a prefix,
// and so that no later stage depends on the order of the input.
struct Field_band
{
  std::vector<Vector> points;
  std::vector<double> distances;
  std::vector<std::size_t> indices; // into the cloud
  std::vector<double> deviations;   // standard deviations of the distances, where they are known
  std::vector<char> is_on_crease;   // whether the surface has a crease there, where that is known
  std::size_t skeleton_size = 0;    // the first ones are the skeleton
  Ball_search search;

  std::size_t size() const { return points.size(); }

  // standard deviation of a distance, where the field's noise level is `noise`
  double deviation(std::size_t i, double noise) const
  {
    return deviations.empty() ? noise : (std::max)(noise, deviations[i]);
  }
};

// How far a distance of this standard deviation may be from the one to a curve that it agrees with. The least is for
// exact fields, where it is the curve that is not exact.
inline double agreement_tolerance(double deviation)
{
  static constexpr double least = 0.2;
  return (std::max)(least, exceeded_by_one_in_80 * deviation);
}

// Residuals beyond it belong to no curve, where the field's noise level is `noise`. The least is for exact fields.
inline double residual_cutoff(double noise)
{
  static constexpr double least = 0.5;
  return (std::max)(least, exceeded_by_one_in_16000 * noise);
}

// By how much the variance of a field's errors grows with the distance from the feature, for the weights of fits: twice
// as large at 1.4 r.
inline double growth_of_variance(double distance) { return 1. + distance * distance / 2.; }

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIELD_BAND_H
