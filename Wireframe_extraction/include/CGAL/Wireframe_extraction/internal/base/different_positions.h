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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_DIFFERENT_POSITIONS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_DIFFERENT_POSITIONS_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The indices of the positions that differ from all earlier ones, ascending. A kd-tree cannot split equal positions.
inline std::vector<std::size_t> different_positions(const std::vector<Vector>& positions)
{
  // Equal positions have equal keys, and different ones hardly ever: the sort needs to look at keys only.
  struct Keyed
  {
    double key;
    std::size_t index;
  };
  std::vector<Keyed> order(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = {positions[i].x() + 0.7548776662466927 * positions[i].y() + 0.5698402909980532 * positions[i].z(), i};
  std::sort(order.begin(), order.end(),
            [](const Keyed& a, const Keyed& b) { return a.key < b.key || (a.key == b.key && a.index < b.index); });
  std::vector<std::size_t> result;
  for (std::size_t first = 0, beyond = 0; first < order.size(); first = beyond)
  {
    const std::size_t known = result.size();
    for (beyond = first; beyond < order.size() && order[beyond].key == order[first].key; ++beyond)
    {
      const Vector& p = positions[order[beyond].index];
      if (std::none_of(result.begin() + known, result.end(), [&](std::size_t i) { return positions[i] == p; }))
        result.push_back(order[beyond].index);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_DIFFERENT_POSITIONS_H
