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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_BALLS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_BALLS_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Leaves at most so many of what was found in a ball, from all of it: neighbors follow one another in the answers of a
// search. Where scans overlap, points lie much closer than elsewhere, and each of them would look at all others.
inline void thin_out(std::vector<std::size_t>& found, std::size_t most)
{
  if (found.size() <= most)
    return;
  for (std::size_t k = 0; k < most; ++k)
    found[k] = found[k * found.size() / most];
  found.resize(most);
}

inline void find_in_ball(const Ball_search& search, const Vector& center, double radius,
                         std::vector<std::size_t>& found)
{
  static constexpr std::size_t most = 256; // a ball of 6 sampling distances on a plane holds less than a hundred points
  search.query(center, radius, found);
  thin_out(found, most);
}

// The points in a ball; it keeps its memory.
struct Fold_ball
{
  std::vector<std::size_t> indices;
  std::vector<Vector> offsets; // from the center

  void collect(const std::vector<Vector>& points, const Ball_search& search, const Vector& center, double radius)
  {
    find_in_ball(search, center, radius, indices);
    offsets.clear();
    for (std::size_t j : indices)
      offsets.push_back(points[j] - center);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_BALLS_H
