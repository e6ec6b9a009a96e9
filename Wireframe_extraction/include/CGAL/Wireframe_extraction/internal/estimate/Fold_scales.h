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
  // The chi square that a fold gains grows with the fourth power of the radius, and falls with the square of the noise: with
  // this noise, balls of 6 show folds of 45 degrees that balls of 5 do not.
  static constexpr double typical_noise = 0.25;
  // from that share of it on the largest balls are used; with less noise they show nothing that smaller ones do not
  static constexpr double least_share_for_largest = 0.2;
  static constexpr int number_of_radii = 3;

  double deviation;                       // standard deviation of the points
  int number_of_balls;                    // how many of the radii are used
  double radii[number_of_radii];          // of the balls, from the smallest on
  double least_evidence[number_of_radii]; // of a fold; the largest balls hold more that is no fold
  double strong_margins[number_of_radii]; // a fold is sure whose margin is larger
  double strong_evidence;                 // and whose evidence is
  double vote_radius;                     // a vote needs so many others within it
  std::size_t least_votes;
  double sheet_radius;                     // of the balls in which sheets are fitted
  double plane_radius, plane_reach;        // of those in which planes are, and how far away planes are taken from
  double radius_of_ends, radius_of_margin; // of those in which two sheets are compared

  explicit Fold_scales(double noise)
  {
    const double share = noise / typical_noise, part = (std::min)(1., share);
    deviation = std::sqrt(noise * noise + least_deviation * least_deviation);
    number_of_balls = share > least_share_for_largest ? number_of_radii : number_of_radii - 1;
    radii[0] = 3. + share;
    radii[1] = 4. + share;
    radii[2] = 4. + 2. * share;
    least_evidence[0] = least_evidence[1] = 6. - 3. * part;
    least_evidence[2] = 8.;
    strong_margins[0] = 10. - 7. * part;
    strong_margins[1] = 15. - 11. * part;
    strong_margins[2] = 15. - 9. * part;
    strong_evidence = 6. + 4. * part;
    vote_radius = 0.5 + 0.2 * part;
    least_votes = part < 0.5 ? 3 : 4;
    sheet_radius = 3. + share;
    plane_radius = 1.6 + 0.5 * share;
    plane_reach = 2.5 + 0.5 * share;
    radius_of_ends = 1.5 + share;
    radius_of_margin = 3. + share;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_SCALES_H
