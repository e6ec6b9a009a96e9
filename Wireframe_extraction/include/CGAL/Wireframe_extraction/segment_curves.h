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

#ifndef CGAL_WIREFRAME_EXTRACTION_SEGMENT_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_SEGMENT_CURVES_H

#include <CGAL/Wireframe_extraction/detect_corners.h>

#include <CGAL/assertions.h>
#include <CGAL/number_type_config.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

namespace internal {

// whether two points may belong to one curve: their tangents agree, and each lies on the other one's local curve
inline bool do_tangents_agree(const Local_curve& a, const Local_curve& b, double least_cosine, double tolerance)
{
  if (std::abs(a.tangent.dot(b.tangent)) < least_cosine)
    return false;
  const double limit = tolerance + 0.1 * (a.point - b.point).norm();
  return a.distance(b.point) < limit && b.distance(a.point) < limit;
}

} // namespace internal

/*!
\ingroup PkgWireframeExtractionFunctions

segments the points of a skeleton outside the corners into curves: the connected components of a graph of neighbors.

With `use_tangents`, two points are neighbors only if their feet are close, their tangents agree and each foot lies on
the other one's local curve. That separates curves that cross or run side by side. Without, any two points closer than
`connection_radius` are neighbors, as published.

\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton. \pre `skeleton.is_contracted()` if `use_tangents`
\param corners the corners; their members belong to no curve
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{connection_radius}
    \cgalParamDescription{the distance below which points are connected, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{connection_angle}
    \cgalParamDescription{the angle between tangents up to which they agree, in degrees}
    \cgalParamType{`double`}
    \cgalParamDefault{30}
  \cgalParamNEnd
  \cgalParamNBegin{use_tangents}
    \cgalParamDescription{whether tangents have to agree}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return for every curve the indices of its points in the skeleton, in ascending order. The curves are sorted by their
first points.

Complexity: O(n log n + n k) for n points with k neighbors each.
*/
template <class GeomTraits, class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] std::vector<std::vector<std::size_t>> segment_curves(
  const Wireframe_skeleton<GeomTraits>& skeleton, const std::vector<Wireframe_corner<GeomTraits>>& corners,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  std::vector<std::vector<std::size_t>> clusters;
  if (skeleton.is_empty())
    return clusters;
  const internal::Extraction_options options = internal::extraction_options(np);
  const internal::Field_band& band = skeleton.band();
  std::vector<char> is_in_corner(skeleton.size(), 0);
  for (const Wireframe_corner<GeomTraits>& corner : corners)
    for (std::size_t i : corner.members)
    {
      CGAL_precondition(i < skeleton.size());
      is_in_corner[i] = 1;
    }
  std::vector<internal::Vector> positions(band.points.begin(), band.points.begin() + skeleton.size());
  if (options.use_tangents)
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions[i] = skeleton.contraction().curves[i].point;
  const internal::Ball_search search(positions);
  const double least_cosine = std::cos(options.connection_angle * CGAL_PI / 180.);
  const double tolerance = options.use_tangents ? 0.3 + 1.5 * skeleton.contraction().noise : 0.;

  // connected components of a graph whose many edges need not be kept
  std::vector<std::size_t> rank(skeleton.size()), parent(skeleton.size());
  boost::disjoint_sets<std::size_t*, std::size_t*> components(rank.data(), parent.data());
  for (std::size_t i = 0; i < positions.size(); ++i)
    components.make_set(i);
  std::vector<std::size_t> ball;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    if (is_in_corner[i])
      continue;
    search.query(positions[i], options.connection_radius, ball);
    for (std::size_t j : ball)
      if (j < i && !is_in_corner[j]
          && (!options.use_tangents
              || internal::do_tangents_agree(skeleton.contraction().curves[i], skeleton.contraction().curves[j],
                                             least_cosine, tolerance)))
        components.union_set(i, j);
  }
  const std::size_t none = skeleton.size();
  std::vector<std::size_t> cluster_of_component(skeleton.size(), none);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    if (is_in_corner[i])
      continue;
    std::size_t& cluster = cluster_of_component[components.find_set(i)];
    if (cluster == none)
    {
      cluster = clusters.size();
      clusters.emplace_back();
    }
    clusters[cluster].push_back(i);
  }
  return clusters;
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_SEGMENT_CURVES_H
