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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FOLLOWING_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FOLLOWING_H

#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What following a curve step by step has in common, whether creases of the surface lead or the field. Lengths are in
// sampling distances.
struct Following
{
  static constexpr double step = 0.5; // half of what the points resolve
  // so many steps along another curve make an end: one or two may be a crossing
  static constexpr std::size_t most_covered = 3;
  // The points that speak for a front or against it lie in a ball of this radius, and count the more the nearer: at the
  // second distance half as much as on the front.
  static constexpr double evidence_radius = 1.8, evidence_softness = 0.5;
  // no closed curve is shorter: a circle of radius 0.8 r has no points of its own
  static constexpr double shortest_closed_curve = 5.;
  // a curve that has more steps than these, for each point of the band, runs in circles
  static std::size_t most_steps(std::size_t number_of_points) { return 10 + 4 * number_of_points; }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FOLLOWING_H
