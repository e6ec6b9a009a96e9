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
#include <Sample_solids/Poisson_sampler.h>
#include <Sample_solids/Solid.h>
#include <Sample_solids/field_error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace Sample_solids {

enum class Sampling
{
  POISSON,
  UNIFORM
};

/// Which curves count for a point: all, or those of its own face and of the faces adjacent to it.
enum class Field_scope
{
  ADJACENT,
  ALL
};

struct Sampling_options
{
  double sampling_distance = 0.02;
  Sampling sampling = Sampling::POISSON;
  Field_scope scope = Field_scope::ADJACENT;
  double truncation = 50; ///< upper bound of the field, in sampling distances
  Field_kind field = Field_kind::EXACT;
  double position_noise = -1; ///< in sampling distances; negative: 0.25 for a noisy field, 0 for others
  std::uint64_t seed = 1;
};

namespace internal {

/// Uniformly random points on the faces: a face by its area, then a point on it by rejection.
class Uniform_sampler
{
public:
  Uniform_sampler(const Solid& solid, Random& random) : m_solid(solid), m_random(random)
  {
    for (const Face& face : m_solid.faces)
      m_sums.push_back(m_sum += face.area);
  }

  /// adds `n` points.
  void sample(std::size_t n, Cloud& cloud)
  {
    const std::size_t wanted = cloud.points.size() + n;
    cloud.points.reserve(wanted);
    cloud.faces.reserve(wanted);
    while (cloud.points.size() < wanted)
    {
      const double x = m_random.uniform(0, m_sum);
      const std::size_t k =
        (std::min)(static_cast<std::size_t>(std::upper_bound(m_sums.begin(), m_sums.end(), x) - m_sums.begin()),
                   m_sums.size() - 1);
      cloud.points.push_back(point_on(m_solid.faces[k]));
      cloud.faces.push_back(static_cast<std::uint32_t>(k));
    }
  }

private:
  Point point_on(const Face& face)
  {
    while (true)
    {
      const double u = m_random.uniform(), v = m_random.uniform();
      if (m_random.uniform() * face.largest_area_element() > face.area_element(v))
        continue;
      const Point p = face.at(u, v);
      if (face.inside(p) >= 0)
        return p;
    }
  }

  const Solid& m_solid;
  Random& m_random;
  std::vector<double> m_sums;
  double m_sum = 0;
};

/// The tiles of a solid's faces: rectangles of their parameters.
class Solid_tiling
{
public:
  struct Tile
  {
    std::uint32_t face, i, j;
  };

  explicit Solid_tiling(const Solid& solid) : m_solid(solid) {}

  std::vector<Tile> tiles(double side)
  {
    side *= 0.7;
    double heaviest = 0;
    for (const Face& face : m_solid.faces)
    {
      const double columns = std::ceil(face.side_u() / side), rows = std::ceil(face.side_v() / side);
      m_grids.push_back({columns, rows, face.largest_area_element() / (columns * rows)});
      heaviest = (std::max)(heaviest, m_grids.back().weight);
    }
    std::vector<Tile> result;
    for (std::uint32_t f = 0; f < m_solid.faces.size(); ++f)
    {
      m_grids[f].weight /= heaviest;
      for (std::uint32_t i = 0; i < m_grids[f].columns; ++i)
        for (std::uint32_t j = 0; j < m_grids[f].rows; ++j)
          if (!is_off_surface({f, i, j}))
            result.push_back({f, i, j});
    }
    return result;
  }

  bool throw_dart(const Tile& tile, Random& random, Point& p) const
  {
    const Grid& grid = m_grids[tile.face];
    const Face& face = m_solid.faces[tile.face];
    const double u = (tile.i + random.uniform()) / grid.columns;
    const double v = (tile.j + random.uniform()) / grid.rows;
    if (random.uniform() * face.largest_area_element() > grid.weight * face.area_element(v))
      return false;
    p = face.at(u, v);
    return true;
  }

  bool is_on_surface(const Tile& tile, const Point& p) const { return m_solid.faces[tile.face].inside(p) >= 0; }

  Point center(const Tile& tile) const
  {
    const Grid& grid = m_grids[tile.face];
    return m_solid.faces[tile.face].at((tile.i + 0.5) / grid.columns, (tile.j + 0.5) / grid.rows);
  }

  double extent(const Tile& tile) const
  {
    const Grid& grid = m_grids[tile.face];
    const Face& face = m_solid.faces[tile.face];
    return 0.5 * std::hypot(face.side_u() / grid.columns, face.side_v() / grid.rows);
  }

  bool is_off_surface(const Tile& tile) const
  {
    const Face& face = m_solid.faces[tile.face];
    return !face.trims.empty() && face.inside(center(tile)) < -extent(tile);
  }

  void halve()
  {
    for (Grid& grid : m_grids)
    {
      grid.columns *= 2;
      grid.rows *= 2;
    }
  }

  Tile quarter(const Tile& tile, std::uint32_t k) const { return {tile.face, 2 * tile.i + k % 2, 2 * tile.j + k / 2}; }

  std::uint32_t face(const Tile& tile) const { return tile.face; }

private:
  struct Grid
  {
    double columns, rows; ///< of the face, on the present level
    double weight;        ///< of one tile relative to the heaviest: how likely a dart may hit it
  };

  const Solid& m_solid;
  std::vector<Grid> m_grids;
};

/// Tells points of a solid their exact distances.
class Annotator
{
public:
  Annotator(const Solid& solid, const Sampling_options& options)
    : m_bound(options.truncation * options.sampling_distance)
  {
    if (options.scope == Field_scope::ALL)
      m_trees.emplace_back(solid.curves, solid.sharp_curves());
    else
      for (std::size_t i = 0; i < solid.faces.size(); ++i)
        m_trees.emplace_back(solid.curves, solid.curves_around(i));
  }

  void annotate(Cloud& cloud) const
  {
    cloud.exact_distances.reserve(cloud.points.size());
    for (std::size_t i = cloud.exact_distances.size(); i < cloud.points.size(); ++i)
      cloud.exact_distances.push_back(m_trees[m_trees.size() == 1 ? 0 : cloud.faces[i]](cloud.points[i], m_bound));
    cloud.distances = cloud.exact_distances;
  }

private:
  double m_bound;
  std::vector<Curve_distance> m_trees;
};

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
    internal::Uniform_sampler(solid, random).sample(n, cloud);
  else
  {
    internal::Solid_tiling tiling(solid);
    Poisson_sampler<internal::Solid_tiling>(tiling, options.sampling_distance, n, random, cloud).run();
  }
  internal::Annotator(solid, options).annotate(cloud);
  return cloud;
}

/// samples a solid uniformly with an exact field, as `sample_exactly()` does, but hands the cloud out piece by piece:
/// `use(cloud)` gets the next points, and returns whether it wants more. So the cloud need not fit into memory.
template <class Use>
bool sample_uniformly(const Solid& solid, const Sampling_options& options, const Use& use)
{
  const std::size_t piece = 65536;
  Random random(options.seed);
  internal::Uniform_sampler sampler(solid, random);
  const internal::Annotator annotator(solid, options);
  std::size_t left = number_of_points(solid.area(), options.sampling_distance);
  while (left > 0)
  {
    Cloud cloud;
    cloud.sampling_distance = options.sampling_distance;
    cloud.truncation = options.truncation;
    sampler.sample((std::min)(left, piece), cloud);
    left -= cloud.points.size();
    annotator.annotate(cloud);
    if (!use(cloud))
      return false;
  }
  return true;
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
