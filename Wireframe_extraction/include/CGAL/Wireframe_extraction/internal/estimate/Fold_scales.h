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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How folds are looked for, given how the points err. Lengths are in sampling distances.
struct Fold_scales
{
  // Surfaces are no quadrics: so much they leave one in a ball of these radii, beside the noise.
  static constexpr double least_deviation = 0.04;
  // no points are better
  static constexpr double least_noise = 0.01;
  // The chi square that a fold gains grows with the fourth power of the radius, and falls with the square of the noise:
  // with this noise balls are larger by 1.
  static constexpr double typical_noise = 0.25;
  // Up to that share of it frames are turned: with more noise this shows more folds that are none than others.
  static constexpr double most_share_to_turn_frames = 0.4;
  // From that share on, weak folds are hidden in these balls, and wider ones are asked as well.
  static constexpr double least_share_for_wide_balls = 0.2;
  static constexpr double wide_radius = 5.5;

  // What follows was chosen on CAD shapes, as their points are and with points that typical noise has moved: the first
  // of two values is for points without noise, the second is what typical noise adds.
  // Of the balls, which have some 23 and 41 points without noise.
  static constexpr double small_radius = 3., large_radius = 4., radius_by_noise = 1.;
  // Of the gain of chi square less what chance gains: noise hides weak folds, of which the margins tell the false ones.
  static constexpr double evidence = 6., evidence_lost_by_noise = 3., wide_evidence = 3.;
  // Of the chi square by which a fold explains the points better than a sheet that bends: tight fillets stay smooth.
  static constexpr double small_margin = 10., small_margin_lost_by_noise = 7.;
  static constexpr double large_margin = 15., large_margin_lost_by_noise = 11., wide_margin = 6.;
  // Wide balls hold more than one fold often: then their residuals are larger than this, in standard deviations.
  static constexpr double most_wide_residual = 1.6;
  // votes scatter with the noise
  static constexpr double radius_of_votes = 0.5, radius_of_votes_by_noise = 0.2;
  static constexpr double noise_for_more_votes = 0.5; // of the typical one
  static constexpr std::size_t votes_without_noise = 3, votes_in_noise = 4;
  // Sheets have the balls of small folds. Planes, which tell their normals, have seven points; those of neighbors are
  // taken from as far as a sheet reaches.
  static constexpr double radius_of_sheets = 3., radius_of_planes = 1.6, radius_of_planes_by_noise = 0.5;
  static constexpr double reach_of_planes = 2.5, reach_of_planes_by_noise = 0.5;
  // whether sheets end is asked next to the fold, and farther where too few points tell; whether one sheet explains
  // both in the ball of a small fold
  static constexpr int number_of_radii_for_ends = 3;
  static constexpr double radius_for_ends = 1.5, step_of_radii_for_ends = 0.75, radius_for_margin = 3.;

  // The balls of one size in which folds are looked for.
  struct Balls
  {
    double radius;
    double least_evidence; // of a fold
    double strong_margin;  // a fold is sure whose margin is larger
    double most_residual;  // beside the fold, in standard deviations of the points: else there is more than a fold
  };

  double deviation; // standard deviation of the points from a quadric
  // of those from the two sheets of a pair, which tell by what they leave how far they are no quadrics
  double deviation_of_sheets;
  bool are_frames_turned; // whether folds are fitted in frames of their own
  bool are_wide_balls_asked;
  Balls small, large, wide;                     // small and large ones always
  static constexpr double strong_evidence = 6.; // a sure fold has more
  double vote_radius;                           // a vote needs so many others within it
  std::size_t least_votes;
  double sheet_radius;              // of the balls in which sheets are fitted
  double plane_radius, plane_reach; // of those in which planes are, and how far away planes are taken from
  double
    radii_of_ends[number_of_radii_for_ends]; // of those that tell whether sheets end; the smallest that does counts
  double radius_of_margin;                   // of those in which two sheets are compared with one

  explicit Fold_scales(double noise)
  {
    const double share = noise / typical_noise, part = (std::min)(1., share);
    deviation = std::sqrt(noise * noise + least_deviation * least_deviation);
    deviation_of_sheets = std::sqrt(noise * noise + least_noise * least_noise);
    are_frames_turned = share <= most_share_to_turn_frames;
    are_wide_balls_asked = share > least_share_for_wide_balls;
    constexpr double any = (std::numeric_limits<double>::infinity)();
    const double larger = radius_by_noise * share, least = evidence - evidence_lost_by_noise * part;
    small = {small_radius + larger, least, small_margin - small_margin_lost_by_noise * part, any};
    large = {large_radius + larger, least, large_margin - large_margin_lost_by_noise * part, any};
    wide = {wide_radius + larger, wide_evidence, wide_margin, most_wide_residual};
    vote_radius = radius_of_votes + radius_of_votes_by_noise * part;
    least_votes = part < noise_for_more_votes ? votes_without_noise : votes_in_noise;
    sheet_radius = radius_of_sheets + larger;
    plane_radius = radius_of_planes + radius_of_planes_by_noise * share;
    plane_reach = reach_of_planes + reach_of_planes_by_noise * share;
    for (int n = 0; n < number_of_radii_for_ends; ++n)
      radii_of_ends[n] = radius_for_ends + step_of_radii_for_ends * n + larger;
    radius_of_margin = radius_for_margin + larger;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_SCALES_H
