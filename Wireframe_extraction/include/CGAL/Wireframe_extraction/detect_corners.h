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

#ifndef CGAL_WIREFRAME_EXTRACTION_DETECT_CORNERS_H
#define CGAL_WIREFRAME_EXTRACTION_DETECT_CORNERS_H

#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/farthest_point_sampling.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Union_find.h>
#include <CGAL/linear_least_squares_fitting_3.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// A place where curves of a wireframe presumably meet or end.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
struct Wireframe_corner
{
  typedef GeomTraits Geom_traits; ///< the traits class

  typename GeomTraits::Point_3 center; ///< where the corner is
  typename GeomTraits::FT radius;      ///< how far from the center the corner's points lie, in the cloud's unit
  std::vector<std::size_t> members;    ///< the points of the skeleton that belong to it, in ascending order
};

namespace Wireframe_extraction {

namespace internal {

// The second explained variance ratio of the points of a ball (eq. 1). CGAL's fits return 1 - l2 / l3 for a line and
// 1 - l1 / l2 for a plane, where l1 <= l2 <= l3 are the variances along the principal axes.
inline double second_variance_ratio(const std::vector<Vector>& points, const std::vector<std::size_t>& ball)
{
  typedef CGAL::Simple_cartesian<double> K;
  if (ball.size() < 3)
    return 0.;
  std::vector<K::Point_3> positions;
  for (std::size_t i : ball)
    positions.emplace_back(points[i].x(), points[i].y(), points[i].z());
  const CGAL::Dimension_tag<0> of_points;
  const auto first = positions.begin(), beyond = positions.end();
  K::Line_3 line;
  K::Plane_3 plane;
  const double l2_by_l3 = 1. - CGAL::linear_least_squares_fitting_3(first, beyond, line, of_points);
  const double l1_by_l2 = 1. - CGAL::linear_least_squares_fitting_3(first, beyond, plane, of_points);
  const double ratio = l2_by_l3 / (1. + l2_by_l3 + l1_by_l2 * l2_by_l3);
  return std::isfinite(ratio) ? ratio : 0.;
}

// Groups of skeleton points, each closer than `reach` to another one of its group.
inline std::vector<std::vector<std::size_t>> connected_groups(const Field_band& band,
                                                              const std::vector<char>& is_marked, double reach)
{
  typedef CGAL::Union_find<std::size_t> Union_find;
  Union_find sets;
  std::vector<Union_find::handle> handles(band.skeleton_size);
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    if (is_marked[i])
      handles[i] = sets.make_set(i);
  std::vector<std::size_t> ball;
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
  {
    if (!is_marked[i])
      continue;
    band.search.query(band.points[i], reach, ball);
    for (std::size_t j : ball)
      if (j < i && is_marked[j])
        sets.unify_sets(handles[i], handles[j]);
  }
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::size_t, std::size_t> group_of_root;
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    if (is_marked[i])
    {
      const auto inserted = group_of_root.emplace(*sets.find(handles[i]), groups.size());
      if (inserted.second)
        groups.emplace_back();
      groups[inserted.first->second].push_back(i);
    }
  return groups;
}

// The published measure: balls around farthest point samples, of which those with a large second variance ratio hold a
// corner; what a bounding box around connected balls takes belongs to it.
inline std::vector<std::vector<std::size_t>> corners_by_variance(const Field_band& band,
                                                                 const Extraction_options& options)
{
  const std::size_t count =
    static_cast<std::size_t>(std::ceil(options.corner_sampling_ratio * double(band.skeleton_size)));
  std::vector<char> is_in_corner_ball(band.skeleton_size, 0);
  std::vector<std::size_t> ball;
  for (std::size_t center : farthest_point_sampling(band.points, band.skeleton_size, count))
  {
    band.search.query(band.points[center], options.corner_radius, ball);
    ball.erase(std::remove_if(ball.begin(), ball.end(), [&](std::size_t i) { return i >= band.skeleton_size; }),
               ball.end());
    if (second_variance_ratio(band.points, ball) > options.corner_variance)
      for (std::size_t i : ball)
        is_in_corner_ball[i] = 1;
  }
  std::vector<std::vector<std::size_t>> groups = connected_groups(band, is_in_corner_ball, options.connection_radius);
  std::vector<char> is_taken(band.skeleton_size, 0);
  for (std::vector<std::size_t>& group : groups)
  {
    Eigen::AlignedBox3d box;
    for (std::size_t i : group)
      box.extend(band.points[i]);
    band.search.query(box.center(), 0.5 * box.diagonal().norm() + 1e-6, ball);
    std::vector<std::size_t> members;
    for (std::size_t i : ball)
      if (i < band.skeleton_size && !is_taken[i] && box.contains(band.points[i]))
      {
        is_taken[i] = 1;
        members.push_back(i);
      }
    std::sort(members.begin(), members.end());
    group = members;
  }
  groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.empty(); }), groups.end());
  return groups;
}

inline std::vector<std::vector<std::size_t>> corners_by_residual(const Field_band& band, const Contraction& contraction,
                                                                 const Extraction_options& options)
{
  const double threshold = options.corner_residual >= 0. ? options.corner_residual : 0.15 + 1.5 * contraction.noise;
  std::vector<char> is_irregular(band.skeleton_size, 0);
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    is_irregular[i] = contraction.residuals[i] > threshold;
  std::vector<std::vector<std::size_t>> groups = connected_groups(band, is_irregular, 1.5);
  // single bad fits occur anywhere
  groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.size() < 3; }), groups.end());
  return groups;
}

} // namespace internal

/*!
\ingroup PkgWireframeExtractionFunctions

detects where curves meet. Two measures are at hand:
- `Corner_measure::FIELD_RESIDUAL`: groups of points near which no single curve explains the field, that is, whose
  residual after `contract_skeleton()` exceeds `corner_residual`;
- `Corner_measure::VARIANCE`: `corner_sampling_ratio` of the points, chosen by farthest point sampling, are centers of
  balls of radius `corner_radius`; those whose second explained variance ratio exceeds `corner_variance` hold a corner,
  and what the bounding box of connected ones takes belongs to it (eq. 1 of \cgalCite{MAZB21}).

\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton. \pre `skeleton.is_contracted()` if the measure is `FIELD_RESIDUAL`
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{corner_measure}
    \cgalParamDescription{what tells a corner from the inside of a curve}
    \cgalParamType{`Corner_measure`}
    \cgalParamDefault{`Corner_measure::FIELD_RESIDUAL`}
  \cgalParamNEnd
  \cgalParamNBegin{corner_residual}
    \cgalParamDescription{the residual above which a point belongs to a corner, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{0.15 and 1.5 times the noise level}
  \cgalParamNEnd
  \cgalParamNBegin{corner_sampling_ratio}
    \cgalParamDescription{the share of the points that become centers of balls}
    \cgalParamType{`double`}
    \cgalParamDefault{0.1}
  \cgalParamNEnd
  \cgalParamNBegin{corner_radius}
    \cgalParamDescription{the radius of these balls, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{corner_variance}
    \cgalParamDescription{the second explained variance ratio above which a ball holds a corner}
    \cgalParamType{`double`}
    \cgalParamDefault{0.3}
  \cgalParamNEnd
  \cgalParamNBegin{connection_radius}
    \cgalParamDescription{the distance below which points of corner balls are connected, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the corners. Their centers are the centroids of their points.

Complexity: O(n log n + n k) for n points with k neighbors in a ball.
*/
template <class GeomTraits, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<Wireframe_corner<GeomTraits>> detect_corners(
  const Wireframe_skeleton<GeomTraits>& skeleton, const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<Wireframe_corner<GeomTraits>> corners;
  if (skeleton.is_empty())
    return corners;
  const internal::Extraction_options options = internal::extraction_options(np);
  const internal::Field_band& band = skeleton.band();
  const std::vector<std::vector<std::size_t>> groups = options.corner_measure == Corner_measure::VARIANCE
    ? internal::corners_by_variance(band, options)
    : internal::corners_by_residual(band, skeleton.contraction(), options);
  for (const std::vector<std::size_t>& group : groups)
  {
    internal::Vector center = internal::Vector::Zero();
    for (std::size_t i : group)
      center += band.points[i];
    center /= double(group.size());
    double radius = 0.;
    for (std::size_t i : group)
      radius = (std::max)(radius, (band.points[i] - center).norm());
    corners.push_back({skeleton.to_point(center), typename GeomTraits::FT(radius * skeleton.unit()), group});
  }
  return corners;
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_DETECT_CORNERS_H
