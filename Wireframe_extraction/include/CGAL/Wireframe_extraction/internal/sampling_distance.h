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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SAMPLING_DISTANCE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SAMPLING_DISTANCE_H

#include <CGAL/Wireframe_extraction/internal/Field_band.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

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

// Indices evenly spread over the ranks of the distances: the same points whatever the order of the cloud. The points
// at the largest value are left out, since a field is truncated there and their order would be arbitrary.
inline std::vector<std::size_t> indices_spread_by_distance(const std::vector<double>& distances,
                                                           const std::vector<Vector>& positions)
{
  const double largest = distances.empty() ? 0. : *std::max_element(distances.begin(), distances.end());
  struct Ranked { double distance; std::size_t index; };
  std::vector<Ranked> order;
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (distances[i] < largest)
      order.push_back({distances[i], i});
  std::sort(order.begin(), order.end(), [](const Ranked& a, const Ranked& b) { return a.distance < b.distance; });
  // of different positions with the same distance none is taken: which one would depend on the order of the cloud
  std::vector<std::size_t> unique;
  for (std::size_t first = 0, beyond = 0; first < order.size(); first = beyond) {
    bool is_one_position = true;
    for (beyond = first; beyond < order.size() && order[beyond].distance == order[first].distance; ++beyond)
      is_one_position = is_one_position && positions[order[beyond].index] == positions[order[first].index];
    if (is_one_position)
      unique.push_back(order[first].index);
  }
  if (unique.size() < 64)
    return spread_indices(distances.size());
  std::vector<std::size_t> indices = spread_indices(unique.size());
  for (std::size_t& i : indices)
    i = unique[i];
  return indices;
}

inline double median(std::vector<double> values)
{
  if (values.empty())
    return 0.;
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// From the median, over the queries, of the area of the disc to the k-th different neighbor, divided by what it holds.
// In a Poisson-disk cloud, the distance to the nearest neighbor itself is the better measure.
struct Cloud_scale
{
  double sampling_distance = 0.;
  double slope = 0.;    // of the field between neighbors: about 1 if points and distances have the same unit
};

inline Cloud_scale cloud_scale(const std::vector<Vector>& positions, const std::vector<double>& distances,
                               const std::vector<std::size_t>& queries)
{
  typedef CGAL::Search_traits<double, Vector, const double*, Construct_vector_coordinates,
                              CGAL::Dimension_tag<3> > Base_traits;
  typedef CGAL::Search_traits_adapter<std::size_t, Position_map, Base_traits> Traits;
  typedef CGAL::Orthogonal_k_neighbor_search<Traits> Search;
  typedef typename Search::Tree Tree;
  constexpr std::size_t wanted = 16;
  Cloud_scale scale;
  if (positions.size() < 2)
    return scale;
  const Position_map map{positions.data()};
  const std::vector<std::size_t> unique = different_positions(positions);
  if (unique.size() < 2)
    return scale;
  Tree tree(unique.begin(), unique.end(), typename Tree::Splitter(), Traits(map));
  tree.build();
  const typename Search::Distance metric(map);
  std::vector<double> slopes;
  std::vector<double> areas, nearest;
  const unsigned int wanted_or_all = static_cast<unsigned int>((std::min)(wanted + 1, unique.size()));
  for (std::size_t q : queries) {
    const Search search(tree, positions[q], wanted_or_all, 0., true, metric);
    std::size_t neighbors = 0;
    double first = 0., last = 0., slope = 0.;
    for (const auto& neighbor : search) {
      if (!(neighbor.second > 0.))
        continue;   // the query itself
      last = neighbor.second;
      if (neighbors++ == 0)
        first = last;
      if (!distances.empty())
        slope = (std::max)(slope, std::abs(distances[q] - distances[neighbor.first]) / std::sqrt(last));
    }
    if (neighbors == 0)
      continue;
    // a random cloud holds k - 1/3 points in the median of these discs, a regular one about k + 1/2
    areas.push_back(CGAL_PI * last / (double(neighbors) + 0.1));
    nearest.push_back(std::sqrt(first));
    slopes.push_back(slope);
  }
  const double from_density = std::sqrt(0.82 * median(areas)), from_nearest = median(nearest);
  if (!(from_density > 0.))
    return scale;
  // their ratio is 0.55 where the points are random, above 0.9 where they keep their distance
  const double regularity = (std::min)(1., (std::max)(0., (from_nearest / from_density - 0.85) / 0.05));
  scale.sampling_distance = from_density + regularity * (from_nearest - from_density);
  scale.slope = median(slopes);
  return scale;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SAMPLING_DISTANCE_H
