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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_MEAN_POINTS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_MEAN_POINTS_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/estimate/point_noise.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Clouds whose noise is larger than their spacing: a cloud of means of their points has less of both.

// With more noise than that, in sampling distances, folds are seen only by means.
constexpr double most_point_noise = 0.6;

// How far apart the means have to lie so that the noise of the points is at most `share` of it; 1 or more, and no more
// than `most`. It is found step by step: in balls that the noise fills, it seems less than it is.
inline double spacing_of_means(const std::vector<Vector>& points)
{
  // A noise in which folds are seen well, less than most_point_noise. Steps by a tenth, since the spacing need not be
  // known better. Beyond 16 spacings, a mean is one of a thousand points, and the edges of any shape are round.
  static constexpr double share = 0.45, step = 1.1, most = 16.;
  double spacing = 1.;
  std::vector<Vector> scaled(points.size());
  while (spacing < most)
  {
    std::transform(points.begin(), points.end(), scaled.begin(), [&](const Vector& p) { return Vector(p / spacing); });
    if (point_noise(scaled, Ball_search(scaled)) < share)
      break;
    spacing *= step;
  }
  return spacing;
}

// The indices of points that lie `distance` apart at least, so many that all others are closer to one of them.
inline std::vector<std::size_t> spread_points(const std::vector<Vector>& points, const Ball_search& search,
                                              double distance)
{
  std::vector<char> is_covered(points.size());
  std::vector<std::size_t> kept, found;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (is_covered[i])
      continue;
    kept.push_back(i);
    search.query(points[i], distance, found);
    for (std::size_t j : found)
      is_covered[j] = true;
  }
  return kept;
}

// A point moved across the surface, to the plane through the points around.
inline Vector mean_point(const std::vector<Vector>& points, const Ball_search& search, const Vector& place,
                         double radius, std::vector<std::size_t>& found)
{
  search.query(place, radius, found);
  static constexpr std::size_t least_points = 6; // a plane, and as much again
  if (found.size() < least_points)
    return place;
  const auto position = [&](std::size_t j) -> const Vector& { return points[j]; };
  const auto weight = [&](std::size_t j) { return 1. - (points[j] - place).squaredNorm() / (radius * radius); };
  const Scatter around = scatter(found, position, weight);
  const Vector normal = principal_axes(around.matrix).axes[0];
  return place + normal.dot(around.mean - place) * normal;
}

struct Mean_points
{
  std::vector<std::size_t> indices; // of the points that have become means
  std::vector<Vector> positions;    // of these
};

// Means that lie `spacing` apart, more or less.
inline Mean_points mean_points(const std::vector<Vector>& points, double spacing)
{
  // Poisson disks whose points have that mean distance to the nearest other
  static constexpr double least_distance = 0.85;
  // smaller balls leave more noise, larger ones round more of the edges
  static constexpr double radius = 1.5;
  static constexpr int number_of_rounds = 2;
  const Ball_search search(points);
  Mean_points result;
  result.indices = spread_points(points, search, least_distance * spacing);
  result.positions.resize(result.indices.size());
  for_each_piece(result.indices.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<std::size_t> found;
    for (std::size_t k = begin; k < end; ++k)
    {
      Vector place = points[result.indices[k]];
      for (int round = 0; round < number_of_rounds; ++round)
        place = mean_point(points, search, place, radius * spacing, found);
      result.positions[k] = place;
    }
  });
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_MEAN_POINTS_H
