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


#ifndef SAMPLE_SOLIDS_SAMPLING_H
#define SAMPLE_SOLIDS_SAMPLING_H

#include <Sample_solids/Curve_distance.h>
#include <Sample_solids/Point_grid.h>
#include <Sample_solids/Solid.h>
#include <Sample_solids/field_error.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Sample_solids {

/// Points per squared sampling distance: at this density a Poisson-disk cloud has points whose nearest
/// neighbours are one sampling distance away in the mean.
constexpr double density = 0.82;

enum class Sampling { POISSON, UNIFORM };

/// Which curves count for a point: all, or those of its own face and of the faces adjacent to it.
enum class Field_scope { ADJACENT, ALL };

struct Sampling_options
{
  double sampling_distance = 0.02;
  Sampling sampling = Sampling::POISSON;
  Field_scope scope = Field_scope::ADJACENT;
  double truncation = 50;          ///< upper bound of the field, in sampling distances
  Field_kind field = Field_kind::EXACT;
  double position_noise = -1;      ///< in sampling distances; negative: 0.25 for a noisy field, 0 for others
  std::uint64_t seed = 1;
};

/// returns how many points `sample()` takes.
inline std::size_t number_of_points(double area, double sampling_distance)
{
  return static_cast<std::size_t>(density * area / (sampling_distance * sampling_distance) + 0.5);
}

/// returns the sampling distance at which an area holds `n` points.
inline double sampling_distance_for(double area, std::size_t n)
{
  return std::sqrt(density * area / static_cast<double>(n));
}

namespace internal {

/// Uniformly random points on the faces: a face by its area, then a point on it by rejection.
inline void sample_uniformly(const Solid& solid, std::size_t n, Random& random, Cloud& cloud)
{
  std::vector<double> sums;
  double sum = 0;
  for (const Face& face : solid.faces)
    sums.push_back(sum += face.area);
  cloud.points.reserve(n);
  cloud.faces.reserve(n);
  while (cloud.points.size() < n)
  {
    const double x = random.uniform(0, sum);
    const std::size_t k = (std::min)(static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end(), x)
                                                              - sums.begin()), sums.size() - 1);
    const Face& face = solid.faces[k];
    while (true)
    {
      const double u = random.uniform(), v = random.uniform();
      if (random.uniform() * face.largest_area_element() > face.area_element(v))
        continue;
      const Point p = face.at(u, v);
      if (face.inside(p) < 0)
        continue;
      cloud.points.push_back(p);
      cloud.faces.push_back(static_cast<std::uint32_t>(k));
      break;
    }
  }
}

/// Poisson-disk points by dart throwing. Darts go only where there is still room: the faces are cut into
/// tiles, and a tile that lies in one point's disk or off its face is dropped, the others are quartered.
/// So the result is that of dart throwing over the whole surface, in linear time. The disks begin larger than
/// they end: at the same density this makes the nearest neighbours more equally far than disks of one size.
class Poisson_sampler
{
public:
  Poisson_sampler(const Solid& solid_, double sampling_distance, std::size_t n, Random& random_,
                  Cloud& cloud_)
    : solid(solid_), smallest(0.9 * sampling_distance), largest(sampling_distance), wanted(n),
      random(random_), cloud(cloud_), grid(2 * largest, n)
  {
    cloud.faces.reserve(wanted);
    make_tiles();
  }

  void run()
  {
    const int rounds = 12, rounds_per_level = 4, deepest = 12;
    for (int round = 0; grid.size() < wanted && !tiles.empty() && level <= deepest; ++round)
    {
      disk_radius = (std::max)(smallest, largest - (largest - smallest) * round / rounds);
      sweep();
      const bool is_quartered = round >= rounds || round % rounds_per_level == rounds_per_level - 1;
      if (grid.size() < wanted && is_quartered)
        refine();
    }
    cloud.points = grid.get_points();
  }

private:
  struct Tile
  {
    std::uint32_t face, i, j;
  };

  struct Tiling
  {
    double columns, rows;   ///< of the face, on the present level
    double weight;          ///< of one tile relative to the heaviest: how likely a dart may hit it
  };

  void make_tiles()
  {
    const double side = 0.7 * smallest;
    double heaviest = 0;
    for (const Face& face : solid.faces)
    {
      const double columns = std::ceil(face.side_u() / side), rows = std::ceil(face.side_v() / side);
      tilings.push_back({columns, rows, face.largest_area_element() / (columns * rows)});
      heaviest = (std::max)(heaviest, tilings.back().weight);
    }
    for (std::uint32_t f = 0; f < solid.faces.size(); ++f)
    {
      tilings[f].weight /= heaviest;
      for (std::uint32_t i = 0; i < tilings[f].columns; ++i)
        for (std::uint32_t j = 0; j < tilings[f].rows; ++j)
          if (!is_off_face({f, i, j}))
            tiles.push_back({f, i, j});
    }
  }

  /// throws about as many darts as there are tiles. Going through the tiles with long random steps, many
  /// times, is as good as taking random tiles, and finds in the cache what it looks at.
  void sweep()
  {
    for (int k = 0; k < 8; ++k)
      for (std::size_t i = random.index(15); i < tiles.size() && grid.size() < wanted;
           i += 1 + random.index(15))
        throw_dart(tiles[i]);
  }

  void throw_dart(const Tile& tile)
  {
    const Tiling& tiling = tilings[tile.face];
    const Face& face = solid.faces[tile.face];
    const double u = (tile.i + random.uniform()) / tiling.columns;
    const double v = (tile.j + random.uniform()) / tiling.rows;
    if (random.uniform() * face.largest_area_element() > tiling.weight * face.area_element(v))
      return;
    const Point p = face.at(u, v);
    if (grid.has_point_within(p, disk_radius) || face.inside(p) < 0)
      return;
    grid.add(p);
    cloud.faces.push_back(tile.face);
  }

  Point center(const Tile& tile) const
  {
    const Tiling& tiling = tilings[tile.face];
    return solid.faces[tile.face].at((tile.i + 0.5) / tiling.columns, (tile.j + 0.5) / tiling.rows);
  }

  /// an upper bound of the distance of a tile's points to its centre
  double extent(const Tile& tile) const
  {
    const Tiling& tiling = tilings[tile.face];
    const Face& face = solid.faces[tile.face];
    return 0.5 * std::hypot(face.side_u() / tiling.columns, face.side_v() / tiling.rows);
  }

  bool is_off_face(const Tile& tile) const
  {
    const Face& face = solid.faces[tile.face];
    return !face.trims.empty() && face.inside(center(tile)) < -extent(tile);
  }

  bool is_full(const Tile& tile) const
  {
    const double radius = smallest - extent(tile);
    return radius > 0 && grid.has_point_within(center(tile), radius);
  }

  void refine()
  {
    ++level;
    for (Tiling& tiling : tilings)
    {
      tiling.columns *= 2;
      tiling.rows *= 2;
    }
    std::vector<Tile> finer;
    for (const Tile& tile : tiles)
      for (std::uint32_t k = 0; k < 4; ++k)
      {
        const Tile quarter = {tile.face, 2 * tile.i + k % 2, 2 * tile.j + k / 2};
        if (!is_full(quarter) && !is_off_face(quarter))
          finer.push_back(quarter);
      }
    tiles.swap(finer);
  }

  const Solid& solid;
  double smallest, largest;      ///< distance of any two points, at the end and at the beginning
  double disk_radius = 0;        ///< at present
  std::size_t wanted;
  Random& random;
  Cloud& cloud;
  Point_grid grid;
  std::vector<Tile> tiles;
  std::vector<Tiling> tilings;
  int level = 0;
};

inline void annotate(const Solid& solid, const Sampling_options& options, Cloud& cloud)
{
  std::vector<Curve_distance> trees;
  if (options.scope == Field_scope::ALL)
    trees.emplace_back(solid.curves, solid.sharp_curves());
  else
    for (std::size_t i = 0; i < solid.faces.size(); ++i)
      trees.emplace_back(solid.curves, solid.curves_around(i));
  const double bound = options.truncation * options.sampling_distance;
  cloud.exact_distances.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    cloud.exact_distances.push_back(trees[trees.size() == 1 ? 0 : cloud.faces[i]](cloud.points[i], bound));
}

} // namespace internal

/// samples a solid with an exact field. Linear in the number of points.
inline Cloud sample_exactly(const Solid& solid, const Sampling_options& options = Sampling_options())
{
  Cloud cloud;
  cloud.sampling_distance = options.sampling_distance;
  cloud.truncation = options.truncation;
  const std::size_t n = number_of_points(solid.area(), options.sampling_distance);
  Random random(options.seed);
  if (options.sampling == Sampling::UNIFORM)
    internal::sample_uniformly(solid, n, random, cloud);
  else
    internal::Poisson_sampler(solid, options.sampling_distance, n, random, cloud).run();
  internal::annotate(solid, options, cloud);
  cloud.distances = cloud.exact_distances;
  return cloud;
}

/// samples a solid, with the field that the options ask for.
inline Cloud sample(const Solid& solid, const Sampling_options& options = Sampling_options())
{
  Cloud cloud = sample_exactly(solid, options);
  disturb(cloud, options.field, options.position_noise, options.seed);
  return cloud;
}

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_SAMPLING_H
