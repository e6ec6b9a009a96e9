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

#ifndef SAMPLE_SOLIDS_POISSON_SAMPLER_H
#define SAMPLE_SOLIDS_POISSON_SAMPLER_H

#include <Sample_solids/Point_grid.h>
#include <Sample_solids/field_error.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Sample_solids {

/// Points per squared sampling distance: at this density a Poisson-disk cloud has points whose nearest
/// neighbours are one sampling distance away in the mean.
constexpr double density = 0.82;

/// returns how many points a cloud has.
inline std::size_t number_of_points(double area, double sampling_distance)
{
  return static_cast<std::size_t>(density * area / (sampling_distance * sampling_distance) + 0.5);
}

/// returns the sampling distance at which an area holds `n` points.
inline double sampling_distance_for(double area, std::size_t n)
{
  return std::sqrt(density * area / static_cast<double>(n));
}

/// Poisson-disk points by dart throwing. Darts go only where there is still room: the surface is cut into
/// tiles, and a tile that lies in one point's disk or off the surface is dropped, the others are quartered.
/// So the result is that of dart throwing over the whole surface, in linear time. The disks begin larger than
/// they end: at the same density this makes the nearest neighbours more equally far than disks of one size.
///
/// `Tiling` knows the surface. It has a type `Tile` and
/// - `tiles(side)`: the tiles of the first level, about `side` large;
/// - `throw_dart(tile, random, p)`: a random point of the tile; false if the tile, by its area, is not hit;
/// - `is_on_surface(tile, p)`;
/// - `center(tile)`, `extent(tile)`: an upper bound of the distance of a tile's points to its centre;
/// - `is_off_surface(tile)`: whether it surely lies off the surface;
/// - `halve()`: begins the next level; `quarter(tile, k)`: one of four parts of a tile of the level before;
/// - `face(tile)`: what `Cloud::faces` tells of its points.
template <class Tiling>
class Poisson_sampler
{
public:
  typedef typename Tiling::Tile Tile;

  Poisson_sampler(Tiling& tiling, double sampling_distance, std::size_t n, Random& random, Cloud& cloud)
    : m_tiling(tiling), m_smallest(0.9 * sampling_distance), m_largest(sampling_distance), m_wanted(n),
      m_random(random), m_cloud(cloud), m_grid(2 * m_largest, n), m_tiles(m_tiling.tiles(m_smallest))
  {
    m_cloud.faces.reserve(m_wanted);
  }

  void run()
  {
    const int rounds = 12, rounds_per_level = 4, deepest = 12;
    for (int round = 0; m_grid.size() < m_wanted && !m_tiles.empty() && m_level <= deepest; ++round)
    {
      m_disk_radius = (std::max)(m_smallest, m_largest - (m_largest - m_smallest) * round / rounds);
      sweep();
      const bool is_quartered = round >= rounds || round % rounds_per_level == rounds_per_level - 1;
      if (m_grid.size() < m_wanted && is_quartered)
        refine();
    }
    m_cloud.points = m_grid.get_points();
  }

private:
  /// throws about as many darts as there are tiles. Going through the tiles with long random steps, many
  /// times, is as good as taking random tiles, and finds in the cache what it looks at.
  void sweep()
  {
    for (int k = 0; k < 8; ++k)
      for (std::size_t i = m_random.index(15); i < m_tiles.size() && m_grid.size() < m_wanted;
           i += 1 + m_random.index(15))
        throw_dart(m_tiles[i]);
  }

  void throw_dart(const Tile& tile)
  {
    Point p;
    if (!m_tiling.throw_dart(tile, m_random, p) || m_grid.has_point_within(p, m_disk_radius)
        || !m_tiling.is_on_surface(tile, p))
      return;
    m_grid.add(p);
    m_cloud.faces.push_back(m_tiling.face(tile));
  }

  bool is_full(const Tile& tile) const
  {
    const double radius = m_smallest - m_tiling.extent(tile);
    return radius > 0 && m_grid.has_point_within(m_tiling.center(tile), radius);
  }

  void refine()
  {
    ++m_level;
    m_tiling.halve();
    std::vector<Tile> finer;
    for (const Tile& tile : m_tiles)
      for (std::uint32_t k = 0; k < 4; ++k)
      {
        const Tile quarter = m_tiling.quarter(tile, k);
        if (!is_full(quarter) && !m_tiling.is_off_surface(quarter))
          finer.push_back(quarter);
      }
    m_tiles.swap(finer);
  }

  Tiling& m_tiling;
  double m_smallest, m_largest; ///< distance of any two points, at the end and at the beginning
  double m_disk_radius = 0;     ///< at present
  std::size_t m_wanted;
  Random& m_random;
  Cloud& m_cloud;
  Point_grid m_grid;
  std::vector<Tile> m_tiles;
  int m_level = 0;
};

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_POISSON_SAMPLER_H
