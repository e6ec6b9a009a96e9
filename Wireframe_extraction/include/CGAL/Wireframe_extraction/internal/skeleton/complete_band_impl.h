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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_COMPLETE_BAND_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_COMPLETE_BAND_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/different_positions.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/complete_band.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE std::size_t sort_band(Field_band& band)
{
  std::vector<std::size_t> order(band.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const Vector &p = band.points[a], &q = band.points[b];
    return std::make_tuple(band.distances[a], p.squaredNorm(), p.x(), p.y(), p.z(), band.indices[a])
      < std::make_tuple(band.distances[b], q.squaredNorm(), q.x(), q.y(), q.z(), band.indices[b]);
  });
  std::vector<Vector> positions;
  for (std::size_t i : order)
    positions.push_back(band.points[i]);
  Field_band sorted;
  for (std::size_t k : different_positions(positions))
  {
    sorted.points.push_back(positions[k]);
    sorted.distances.push_back(band.distances[order[k]]);
    sorted.indices.push_back(band.indices[order[k]]);
    if (!band.is_on_crease.empty())
      sorted.is_on_crease.push_back(band.is_on_crease[order[k]]);
    if (!band.deviations.empty())
      sorted.deviations.push_back(band.deviations[order[k]]);
  }
  band = std::move(sorted);
  return order.size() - band.size();
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::size_t complete_band(Field_band& band, double skeleton_distance)
{
  const std::size_t duplicates = sort_band(band);
  band.skeleton_size =
    std::lower_bound(band.distances.begin(), band.distances.end(), skeleton_distance) - band.distances.begin();
  band.search.build(band.points, band.size());
  return duplicates;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_COMPLETE_BAND_IMPL_H
