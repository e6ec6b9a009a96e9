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

#ifndef CGAL_WIREFRAME_EXTRACTION_DISTANCE_CLOUD_FILTER_H
#define CGAL_WIREFRAME_EXTRACTION_DISTANCE_CLOUD_FILTER_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_values.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/cloud_access.h>
#include <CGAL/Wireframe_extraction/internal/cloud/sampling_distance.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/options/points_in_memory.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionClasses

keeps of a cloud that comes once, point after point, what `extract_wireframe()` needs of it: the points near features,
and the sampling distance. A cloud that can be read several times is better given to
`extract_wireframe_from_source()`, which loses nothing.

Points are kept whose distances are below `width()` times an upper bound of the sampling distance. The bound sinks
while points come: whenever `points_in_memory` points, or twice what was kept last, are there, it becomes at most 1.5
times the sampling distance of those near features. So the order of the points does not matter, and a sorted scan is
as good as a random one, unless the density varies by more than a factor of two; `is_complete()` tells. What is kept
in the end are the points below `width()` times the sampling distance.

The sampling distance is measured at up to 4096 of these points, from all their true neighbors, for Poisson-disk
clouds and uniformly random ones alike. Where the cloud is evenly dense, it is within about two per cent of that of
`extract_wireframe()`. What is lost are points near features whose distances say that they are far from any, up to
which `extract_wireframe()` would look for the surface around the skeleton. With an exact field there are none.

`cloud()`, `sampling_distance()` and `is_complete()` first bring the state up to date with what was inserted since they
were called last, in \f$ O(m \log m) \f$ time for the \f$ m \f$ points that are there; else they take constant time.
Inserting takes \f$ O(\log m) \f$ amortized time. At most `points_in_memory` points are held, or twice as many as were
kept when the bound sank last, whichever is more.

\tparam Point a point type for which `Kernel_traits<Point>::Kernel` is a model of `WireframeExtractionTraits_3`, such as
the points of a kernel
\tparam FT a model of `FieldNumberType` that is constructible from `double`
*/
template <class Point, class FT = double>
class Distance_cloud_filter
{
  typedef std::vector<std::pair<Point, FT>> Cloud;
  typedef internal::Cloud_access<Cloud, CGAL::parameters::Default_named_parameters> Access;

  static constexpr double safety = 1.5;
  static constexpr double reach_of_neighbors = 5.; // in sampling distances

  Cloud m_cloud;
  double m_width;
  std::size_t m_least_limit, m_limit;
  std::size_t m_number_of_points = 0, m_number_of_invalid = 0;
  double m_bound = (std::numeric_limits<double>::infinity)(); // of the sampling distance
  double m_sampling_distance = 0.;
  bool m_is_up_to_date = true;

public:
  /// constructs a filter for an extraction with the same parameters.
  ///
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param np an optional sequence of named parameters among the ones listed below.
  /// \pre The first three are positive and finite.
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{skeleton_distance}
  ///     \cgalParamDescription{the threshold below which a point belongs to the skeleton, in multiples of r}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{1.5}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{support_distance}
  ///     \cgalParamDescription{the threshold below which a point supports the fits, in multiples of r}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{3}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{fitting_radius}
  ///     \cgalParamDescription{the radius of the balls in which curves are fitted, in multiples of r}
  ///     \cgalParamType{`double`}
  ///     \cgalParamDefault{4}
  ///   \cgalParamNEnd
  ///   \cgalParamNBegin{points_in_memory}
  ///     \cgalParamDescription{the number of points up to which nothing is dropped}
  ///     \cgalParamType{`std::size_t`}
  ///     \cgalParamDefault{1048576}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  template <class NamedParameters = CGAL::parameters::Default_named_parameters>
  explicit Distance_cloud_filter(const NamedParameters& np = CGAL::parameters::default_values())
    : m_least_limit((std::max)(std::size_t(256), internal::points_in_memory(np))), m_limit(m_least_limit)
  {
    const internal::Extraction_options options = internal::extraction_options(np);
    m_width = (std::max)(options.skeleton_distance, options.support_distance)
      + (std::max)(2. * options.fitting_radius, reach_of_neighbors);
  }

  /// takes a point and its distance. Those that are not finite, and negative distances, are counted and left out.
  /// References to `cloud()` become invalid.
  void insert(const Point& point, const FT& distance)
  {
    ++m_number_of_points;
    const double d = CGAL::to_double(distance);
    const std::pair<Point, FT> value(point, distance);
    if (!access().position(value).allFinite() || !std::isfinite(d) || d < 0.)
    {
      ++m_number_of_invalid;
      return;
    }
    m_is_up_to_date = false;
    if (!(d < m_width * m_bound))
      return;
    m_cloud.push_back(value);
    if (m_cloud.size() >= m_limit)
    {
      lower_bound();
      m_limit = (std::max)(m_least_limit, 2 * m_cloud.size());
    }
  }

  /// takes the pairs of a point and a distance of an input range, as if they were inserted one by one.
  ///
  /// \tparam InputIterator a model of `InputIterator` whose value type is `std::pair<Point, FT>`
  template <class InputIterator>
  auto insert(InputIterator first, InputIterator beyond) -> decltype(void(first->first))
  {
    for (; first != beyond; ++first)
      insert(first->first, first->second);
  }

  /// returns how many points came.
  std::size_t number_of_points() const { return m_number_of_points; }

  /// returns how many of these were left out since they are invalid.
  std::size_t number_of_invalid() const { return m_number_of_invalid; }

  /// returns the distance below which points are kept, in sampling distances.
  double width() const { return m_width; }

  /// returns the points that are kept, with their distances. The reference is valid until the next insertion.
  const std::vector<std::pair<Point, FT>>& cloud()
  {
    update();
    return m_cloud;
  }

  /// returns the sampling distance; 0 if there are fewer than two different points.
  double sampling_distance()
  {
    update();
    return m_sampling_distance;
  }

  /// returns whether all points are there that are closer to features than `width()` times the sampling distance. If
  /// not, the density of the cloud varies too much; raise `points_in_memory`.
  bool is_complete()
  {
    update();
    return m_sampling_distance <= m_bound;
  }

private:
  static const Access& access()
  {
    static const Access result(Cloud(), CGAL::parameters::default_values());
    return result;
  }

  void update()
  {
    if (m_is_up_to_date)
      return;
    m_sampling_distance = measured();
    drop_beyond((std::min)(m_bound, m_sampling_distance > 0. ? m_sampling_distance : m_bound));
    m_is_up_to_date = true;
  }

  void lower_bound()
  {
    const double measure = measured();
    if (measure > 0.)
      m_bound = (std::min)(m_bound, safety * measure);
    drop_beyond(m_bound);
  }

  void drop_beyond(double bound)
  {
    m_cloud.erase(std::remove_if(m_cloud.begin(), m_cloud.end(),
                                 [&](const std::pair<Point, FT>& value) {
                                   return !(CGAL::to_double(value.second) < m_width * bound);
                                 }),
                  m_cloud.end());
    if (m_cloud.size() < m_cloud.capacity() / 4)
      m_cloud.shrink_to_fit();
  }

  // the sampling distance of the points that are there, at those whose neighbors are there, too
  double measured() const
  {
    std::vector<internal::Vector> positions;
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < m_cloud.size(); ++i)
    {
      positions.push_back(access().position(m_cloud[i]));
      if (CGAL::to_double(m_cloud[i].second) <= (m_width - reach_of_neighbors) * m_bound)
        inner.push_back(i);
    }
    internal::Cloud_values queries;
    for (std::size_t k : internal::spread_indices(inner.size()))
      queries.add(positions[inner[k]], 0., inner[k]);
    return internal::cloud_scale(positions, std::vector<double>(), queries).sampling_distance;
  }
};

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_DISTANCE_CLOUD_FILTER_H
