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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_SCALES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_SCALES_H

#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How folds are looked for, given how the points err. Lengths are in sampling distances.
struct Fold_scales
{
  // Surfaces are no quadrics: so much they leave one in a ball of these radii, beside the noise.
  static constexpr double least_deviation = 0.04;
  // With that noise, a gaussian fold of 30 degrees needs balls that are larger by 1 than without noise.
  static constexpr double typical_noise = 0.25;

  double deviation;         // standard deviation of the points
  double radii[2];          // of the balls, from the smaller on
  double strong_margins[2]; // a fold is sure whose margin is larger
  double least_evidence;
  double strong_evidence = 6.;
  double vote_radius; // a vote needs so many others within it
  std::size_t least_votes;
  double sheet_radius; // of the balls in which sheets are fitted

  explicit Fold_scales(double noise)
  {
    const double share = noise / typical_noise, part = (std::min)(1., share);
    deviation = std::sqrt(noise * noise + least_deviation * least_deviation);
    radii[0] = 3. + share;
    radii[1] = 4. + share;
    strong_margins[0] = 10. - 7. * part;
    strong_margins[1] = 15. - 11. * part;
    least_evidence = 6. - 3. * part;
    vote_radius = 0.5 + 0.2 * part;
    least_votes = part < 0.5 ? 3 : 4;
    sheet_radius = 3. + share;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_SCALES_H
