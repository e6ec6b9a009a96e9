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

#ifndef CGAL_WIREFRAME_EXTRACTION_DISTANCE_FIELD_H
#define CGAL_WIREFRAME_EXTRACTION_DISTANCE_FIELD_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

/// \ingroup PkgWireframeExtractionClasses
/// A distance field that was estimated from points alone.
///
/// \sa `estimate_distance_field()`
struct Distance_field
{
  /// for each point of the cloud, in its order, the distance to the nearest sharp feature, in the cloud's unit. Points
  /// that were left out since they are invalid have no number (NaN).
  std::vector<double> distances;
  /// the standard deviations of the distances, in the cloud's unit
  std::vector<double> deviations;
  double sampling_distance = 0.; ///< the sampling distance r, in the cloud's unit
  double truncation = 0.;        ///< what points far from all features have as distance, in the cloud's unit
  double point_noise = 0.;       ///< the standard deviation of the points across the surface, in the cloud's unit
  double noise_level = 0.;       ///< what `noise_level` shall be for the stages that follow, in multiples of r
  std::size_t number_of_near_points = 0; ///< points whose distance is below `truncation`

  /// returns whether there is no field.
  bool is_empty() const { return distances.empty(); }
};

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_DISTANCE_FIELD_H
