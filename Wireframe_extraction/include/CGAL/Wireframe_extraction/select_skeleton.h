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

#ifndef CGAL_WIREFRAME_EXTRACTION_SELECT_SKELETON_H
#define CGAL_WIREFRAME_EXTRACTION_SELECT_SKELETON_H

#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/cell_key.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Range_source.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/cloud_access.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

namespace internal {

// Sorts the points by distance, and takes out those that lie where another one does: the one with the smallest distance
// stays.
inline std::size_t sort_band(Field_band& band)
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

// Sorts the points, says which are the skeleton, and indexes all. Returns how many were left out.
inline std::size_t complete_band(Field_band& band, double skeleton_distance)
{
  const std::size_t duplicates = sort_band(band);
  band.skeleton_size =
    std::lower_bound(band.distances.begin(), band.distances.end(), skeleton_distance) - band.distances.begin();
  band.search.build(band.points, band.size());
  return duplicates;
}

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

// Positions farther than that from the features belong to no shape: scanners write such points where they saw nothing.
constexpr double farthest_in_units = 1e9;

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

// `cloud.for_each(f)` calls `f(position, distance, index)` for every point
template <class Cloud, class GeomTraits>
Wireframe_skeleton<GeomTraits> select_skeleton(const Cloud& cloud, double unit, const Extraction_options& options,
                                               const GeomTraits& traits)
{
  auto band = std::make_shared<Field_band>();
  Vector origin = Vector::Zero();
  std::size_t duplicates = 0, strays = 0;
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
    strays = localize(*band, unit, origin);
    duplicates = complete_band(*band, options.skeleton_distance);
  }
  return Wireframe_skeleton<GeomTraits>(band, std::make_shared<Field_band>(), unit, origin, duplicates, strays, traits);
}

// The points around the skeleton whatever their distances say: what the surface looks like there.
template <class Cloud, class GeomTraits>
void select_surroundings(const Cloud& cloud, const Extraction_options& options,
                         Wireframe_skeleton<GeomTraits>& skeleton)
{
  auto surroundings = std::make_shared<Field_band>();
  const Field_band& band = skeleton.band();
  Neighborhood_cells cells(2. * options.fitting_radius);
  for (std::size_t i = 0; i < band.skeleton_size; ++i)
    cells.add(band.points[i]);
  cloud.for_each([&](const Vector& position, double distance, std::size_t index) {
    const Vector p = skeleton.to_local(position);
    if (!(p.cwiseAbs().maxCoeff() < farthest_in_units) || !cells.holds(p))
      return;
    surroundings->points.push_back(p);
    surroundings->distances.push_back(distance / skeleton.unit());
    surroundings->indices.push_back(index);
  });
  sort_band(*surroundings);
  surroundings->skeleton_size = band.skeleton_size;
  surroundings->search.build(surroundings->points, surroundings->size());
  skeleton.set_surroundings(surroundings);
}

} // namespace internal

/*!
\ingroup PkgWireframeExtractionFunctions

selects the points near sharp features: the skeleton, whose distances are below `skeleton_distance`, and around it the
points below `support_distance`, which later stages fit to.

\tparam PointRange a model of `ConstRange` whose iterators are forward iterators
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the cloud. \pre All coordinates and distances are finite, and no distance is negative.
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map from the value type of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the first of a pair, or the value itself}
  \cgalParamNEnd
  \cgalParamNBegin{distance_map}
    \cgalParamDescription{a property map from the value type of `points` to the distance to the nearest sharp feature}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the second of a pair}
  \cgalParamNEnd
  \cgalParamNBegin{sampling_distance}
    \cgalParamDescription{the sampling distance r, in the cloud's unit}
    \cgalParamType{`double`}
    \cgalParamDefault{what `estimate_sampling_distance()` finds}
    \cgalParamExtra{0 stands for the default.}
  \cgalParamNEnd
  \cgalParamNBegin{skeleton_distance}
    \cgalParamDescription{the threshold below which a point belongs to the skeleton, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{1.5}
  \cgalParamNEnd
  \cgalParamNBegin{support_distance}
    \cgalParamDescription{the threshold below which a point supports the fits, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{fitting_radius}
    \cgalParamDescription{the radius of the balls in which later stages fit, in multiples of r; points within twice
                          as much of the skeleton are kept for `refine_field()`}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{points_in_memory}
    \cgalParamDescription{up to how many points are copied; a larger cloud is gone over several times instead}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{1048576}
  \cgalParamNEnd
  \cgalParamNBegin{use_creases}
    \cgalParamDescription{whether the points around the skeleton are kept for `refine_field()`, which otherwise does
                          nothing}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a model of `WireframeExtractionTraits_3`}
    \cgalParamDefault{the kernel of the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the skeleton; it is empty if no point lies below the threshold or the sampling distance is 0.

Complexity: O(n) for n points and O(m log m) for the m points kept, after the estimation of the sampling distance.
*/
template <class PointRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
[[nodiscard]] Wireframe_skeleton<GeomTraits>
#else
[[nodiscard]] Wireframe_skeleton<typename internal::Cloud_access<PointRange, NamedParameters>::Geom_traits>
#endif
select_skeleton(const PointRange& points, const NamedParameters& np = CGAL::parameters::default_values())
{
  static_assert(internal::Cloud_access<PointRange, NamedParameters>::has_distances,
                "pass the distances of the points to features with the named parameter distance_map()");
  const internal::Cloud_access<PointRange, NamedParameters> access(np);
  internal::Range_source<PointRange, internal::Cloud_access<PointRange, NamedParameters>> source(points, access);
  internal::Surveyed_cloud cloud(source, internal::points_in_memory(np));
  cloud.survey();
  double unit = CGAL::to_double(
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::sampling_distance), 0.));
  if (!(unit > 0.))
    unit = cloud.scale().sampling_distance;
  const internal::Extraction_options options = internal::extraction_options(np);
  auto skeleton = internal::select_skeleton(cloud, unit, options, access.traits());
  if (options.use_creases && !skeleton.is_empty())
    internal::select_surroundings(cloud, options, skeleton);
  return skeleton;
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_SELECT_SKELETON_H
