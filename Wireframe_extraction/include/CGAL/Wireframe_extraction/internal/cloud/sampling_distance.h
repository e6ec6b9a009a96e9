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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SAMPLING_DISTANCE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SAMPLING_DISTANCE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/different_positions.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/base/position_search_traits.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_scale.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_values.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Field_slopes.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Discs with 16 points vary by a quarter of their areas, so that the sampling distance from the median of so many errs
// by a quarter of a per cent.
constexpr std::size_t most_density_samples = 4096;

// at most `most_density_samples` indices, evenly spread over [0, n)
inline std::vector<std::size_t> spread_indices(std::size_t n)
{
  const std::size_t count = (std::min)(n, most_density_samples);
  std::vector<std::size_t> indices(count);
  for (std::size_t k = 0; k < count; ++k)
    indices[k] = k * n / count;
  return indices;
}

// Their disc has a radius of 2.5 r: it stays on one face next to most features.
constexpr std::size_t density_neighbors = 16;

// What was found around the queries. The sampling distance follows from the median, over the queries, of the area of
// the disc to the k-th different neighbor, divided by what it holds. In a Poisson-disk cloud, the distance to the
// nearest neighbor itself is the better measure.
class Density_measures
{
  std::vector<double> m_areas, m_nearest, m_slopes;
  Field_slopes m_gradients;

  // A random cloud holds k - 1/3 points in the median of these discs, a regular one about k + 1/2.
  static constexpr double surplus_in_disc = 0.1;
  // the square of r, per area of a point, in a Poisson-disk cloud: so both measures agree there
  static constexpr double squared_distance_per_area = 0.82;
  // The ratio of both measures is 0.55 where the points are random, above 0.9 where they keep their distance.
  static constexpr double most_random = 0.85, transition = 0.05;

public:
  // the squared distances of the first and of the last of some neighbors
  void add(double first, double last, std::size_t neighbors, double slope)
  {
    m_areas.push_back(CGAL_PI * last / (double(neighbors) + surplus_in_disc));
    m_nearest.push_back(std::sqrt(first));
    m_slopes.push_back(slope);
  }

  // the field at a point, and the offsets to its neighbors with the field there
  void add_field(double field, const std::vector<std::pair<Vector, double>>& neighbors)
  {
    m_gradients.add(field, neighbors);
  }

  Cloud_scale scale() const
  {
    Cloud_scale scale;
    const double from_density = std::sqrt(squared_distance_per_area * median(m_areas)),
                 from_nearest = median(m_nearest);
    if (!(from_density > 0.))
      return scale;
    const double regularity = (std::min)(1., (std::max)(0., (from_nearest / from_density - most_random) / transition));
    scale.sampling_distance = from_density + regularity * (from_nearest - from_density);
    scale.slope = median(m_slopes);
    m_gradients.describe(scale);
    return scale;
  }
};

inline Cloud_scale cloud_scale(const std::vector<Vector>& positions, const std::vector<double>& distances,
                               const Cloud_values& queries)
{
  typedef Position_search_traits Traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Traits> Search;
  typedef typename Search::Tree Tree;
  if (positions.size() < 2)
    return Cloud_scale();
  const Position_map map{positions.data()};
  const std::vector<std::size_t> unique = different_positions(positions);
  if (unique.size() < 2)
    return Cloud_scale();
  Tree tree(unique.begin(), unique.end(), typename Tree::Splitter(), Traits(map));
  tree.build();
  const typename Search::Distance metric(map);
  Density_measures measures;
  std::vector<std::pair<Vector, double>> field_around;
  const unsigned int wanted_or_all = static_cast<unsigned int>((std::min)(density_neighbors + 1, unique.size()));
  for (std::size_t q = 0; q < queries.size(); ++q)
  {
    const Search search(tree, queries.positions[q], wanted_or_all, 0., true, metric);
    std::size_t neighbors = 0;
    double first = 0., last = 0., slope = 0.;
    field_around.clear();
    for (const auto& neighbor : search)
    {
      if (!(neighbor.second > 0.))
        continue; // the query itself
      last = neighbor.second;
      if (neighbors++ == 0)
        first = last;
      if (distances.empty())
        continue;
      const double field = distances[neighbor.first];
      slope = (std::max)(slope, std::abs(queries.distances[q] - field) / std::sqrt(last));
      field_around.emplace_back(positions[neighbor.first] - queries.positions[q], field);
    }
    if (neighbors > 0)
      measures.add(first, last, neighbors, slope);
    if (!distances.empty())
      measures.add_field(queries.distances[q], field_around);
  }
  return measures.scale();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_SAMPLING_DISTANCE_H
