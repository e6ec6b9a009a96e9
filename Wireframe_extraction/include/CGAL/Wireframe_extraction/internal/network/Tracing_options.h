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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACING_OPTIONS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACING_OPTIONS_H

#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Following.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How curves are traced. Lengths are in sampling distances r, angles in radians.
struct Tracing_options
{
  double noise = 0.1; // typical residual of the field near curves, in r
  double step = Following::step;
  double radius = 4.;        // of the balls the local fits use
  double maximum_gap = 3.;   // bridged without any evidence: points along an edge are seldom farther apart
  double maximum_turn = 0.6; // per step; a circle of radius r turns by 0.5

  double tolerance() const { return agreement_tolerance(noise); }

  // The length over which the field may contradict: less than a step where it is exact, and as much more as its errors
  // move the places where points agree.
  static constexpr double least_doubt = 0.25, doubt_per_noise = 4.;
  double maximum_doubt() const { return least_doubt + doubt_per_noise * noise; }

  // Where all points are other curves', a curve is believed for the distance of two points; it has one of its own then.
  static constexpr double longest_among_others = 1.;

  // Residuals beyond it count as outliers in the local fits: two standard deviations, but no less than what a parabola
  // misses of a curved edge.
  static constexpr double least_fit_scale = 0.15, fit_scale_per_noise = 2.;
  double fit_scale() const { return (std::max)(least_fit_scale, fit_scale_per_noise * noise); }
  static constexpr int fit_iterations = 3; // the front is nearly right already

  // The width of a curve's corridor: no other one is traced in it in the same direction. Less than the distance at
  // which two curves can be told apart, which is about r.
  static constexpr double corridor_width = 0.6;
  double corridor() const { return corridor_width + noise; }
  // so many points of the path are no news to the front: five r of them, where a curve may not yet have turned away
  static constexpr std::size_t trail = 10;

  // The points that speak for a front or against it: around the next step, as far as the next point may be, and
  // somewhat beyond r to the sides, where the field still changes with the front's place. They
  // count the more the nearer.
  static constexpr double behind_front = 0.4, before_front = 0.8, evidence_distance = 1.6;
  static_assert(before_front * before_front + evidence_distance * evidence_distance
                  < Following::evidence_radius * Following::evidence_radius,
                "the ball of the evidence holds these");

  // a fit may move the front off its predicted place by this share of a step, besides the tolerance
  static constexpr double largest_jump = 0.5;
  // the ball of the front's fit lies behind it, by this share of its radius, where the curve is known to be
  static constexpr double ball_behind_front = 0.25;

  // besides the tolerance: how far off its start a curve may come back
  static constexpr double return_distance = 0.25;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACING_OPTIONS_H
