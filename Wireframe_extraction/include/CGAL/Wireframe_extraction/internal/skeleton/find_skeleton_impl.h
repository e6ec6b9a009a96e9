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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIND_SKELETON_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIND_SKELETON_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/cell_key.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_scale.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/complete_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/find_skeleton.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_set>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The places within about `reach` of some positions, cell by cell: from `reach` at least to three times as much.
class Neighborhood_cells
{
  double m_cell;
  std::unordered_set<std::uint64_t> m_cells;

  std::uint64_t key(const Vector& p, int dx, int dy, int dz) const
  {
    const auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / m_cell)); };
    return cell_key(index(p.x()) + dx, index(p.y()) + dy, index(p.z()) + dz);
  }

public:
  explicit Neighborhood_cells(double reach) : m_cell(reach) {}

  void add(const Vector& p)
  {
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz)
          m_cells.insert(key(p, dx, dy, dz));
  }

  bool holds(const Vector& p) const { return m_cells.count(key(p, 0, 0, 0)) > 0; }
};

// How far around the skeleton the surface is looked at, in radii of fits: a crease that is traced to where the field
// does not see it leaves the skeleton, and the ball of its fit reaches one radius farther.
constexpr double reach_of_surroundings = 2.;

// Moves the points of a band into local coordinates, whose origin is their mean. Returns how many were left out since
// they are too far away.
inline std::size_t localize(Field_band& band, double unit, Vector& origin)
{
  origin = median_position(band.points);
  Vector mean = Vector::Zero();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < band.size(); ++i)
  {
    const Vector p = (band.points[i] - origin) / unit;
    if (!(p.cwiseAbs().maxCoeff() < farthest_in_units))
      continue;
    band.points[kept] = p;
    band.distances[kept] = band.distances[i] / unit;
    band.indices[kept] = band.indices[i];
    mean += p;
    ++kept;
  }
  const std::size_t strays = band.size() - kept;
  band.points.resize(kept);
  band.distances.resize(kept);
  band.indices.resize(kept);
  mean /= (std::max)(1., double(kept));
  for (Vector& p : band.points)
    p -= mean;
  origin += unit * mean;
  return strays;
}

CGAL_WIREFRAME_EXTRACTION_INLINE Skeleton_data find_skeleton(const Surveyed_cloud& cloud, double unit,
                                                             const Extraction_options& options)
{
  auto band = std::make_shared<Field_band>();
  Skeleton_data skeleton;
  skeleton.unit = unit;
  skeleton.surroundings = std::make_shared<Field_band>();
  if (unit > 0.)
  {
    const double widest = unit * (std::max)(options.skeleton_distance, options.support_distance);
    cloud.for_each([&](const Vector& position, double distance, std::size_t index) {
      if (!(distance < widest))
        return;
      band->points.push_back(position);
      band->distances.push_back(distance);
      band->indices.push_back(index);
    });
    skeleton.number_of_strays = localize(*band, unit, skeleton.origin);
    skeleton.number_of_duplicates = complete_band(*band, options.skeleton_distance);
  }
  skeleton.band = band;
  return skeleton;
}

CGAL_WIREFRAME_EXTRACTION_INLINE void find_surroundings(const Surveyed_cloud& cloud, const Extraction_options& options,
                                                        Skeleton_data& skeleton)
{
  auto surroundings = std::make_shared<Field_band>();
  const Field_band& band = *skeleton.band;
  Neighborhood_cells cells(reach_of_surroundings * options.fitting_radius);
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    cells.add(band.points[i]);
  cloud.for_each([&](const Vector& position, double distance, std::size_t index) {
    const Vector p = skeleton.to_local(position);
    if (!(p.cwiseAbs().maxCoeff() < farthest_in_units) || !cells.holds(p))
      return;
    surroundings->points.push_back(p);
    surroundings->distances.push_back(distance / skeleton.unit);
    surroundings->indices.push_back(index);
  });
  sort_band(*surroundings);
  surroundings->skeleton_size = band.skeleton_size;
  surroundings->search.build(surroundings->points, surroundings->size());
  skeleton.surroundings = surroundings;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIND_SKELETON_IMPL_H
