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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_TWO_FACES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_TWO_FACES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Two half-planes that meet in a straight edge, and which points they hold.
struct Two_faces
{
  std::array<Vector, 2> arms = {Vector::Zero(), Vector::Zero()}; // directions at right angles to the edge
  std::vector<char> holds;
};

// The two half-planes through points beside a straight edge that hold the most of them, closer than `tolerance`. The
// points are given by their `offsets` from the edge, at right angles to it; half-planes go through those that are at
// least `arm` away, and are faces of the edge only if they also hold a nearer one. Cubic in the number of points, of
// which there are some tens.
inline Two_faces find_two_faces(const std::vector<Vector>& offsets, double tolerance, double arm)
{
  const auto holds = [&](const Vector& arm, const Vector& offset) {
    const double along = offset.dot(arm);
    return along > 0. ? (offset - along * arm).norm() < tolerance : offset.norm() < tolerance;
  };
  std::vector<Vector> arms;
  std::vector<std::vector<char>> held; // of the points, for each arm
  for (const Vector& offset : offsets)
  {
    if (offset.norm() < arm)
      continue;
    const Vector direction = offset.normalized();
    std::vector<char> held_here;
    bool starts_at_edge = false;
    for (const Vector& other : offsets)
    {
      held_here.push_back(holds(direction, other));
      // closer to the edge than the tolerance, points are on all half-planes
      starts_at_edge = starts_at_edge || (held_here.back() && other.norm() >= tolerance && other.norm() < arm);
    }
    if (!starts_at_edge)
      continue;
    arms.push_back(direction);
    held.push_back(held_here);
  }
  Two_faces best;
  best.holds.assign(offsets.size(), 0);
  std::vector<char> either(offsets.size());
  std::ptrdiff_t most = 0;
  for (std::size_t a = 0; a < arms.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
    {
      std::transform(held[a].begin(), held[a].end(), held[b].begin(), either.begin(),
                     [](char by_first, char by_second) { return char(by_first || by_second); });
      const std::ptrdiff_t count = std::count(either.begin(), either.end(), 1);
      if (count <= most)
        continue;
      most = count;
      best = {{arms[a], arms[b]}, either};
    }
  return best;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_TWO_FACES_H
