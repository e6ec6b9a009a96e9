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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_MEAN_CLOUD_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_MEAN_CLOUD_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/estimate/mean_points.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/estimate_distances.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The means of a cloud with much noise, as a cloud with the same indices: the points that are none of them have no
// position.
class Mean_cloud : public Distance_cloud_source
{
  std::vector<Vector> m_positions; // of all indices

public:
  // `unit` is the sampling distance of the cloud
  Mean_cloud(const Surveyed_cloud& cloud, double unit)
  {
    const Points_to_estimate points(cloud.sample().positions, unit);
    const Mean_points means = mean_points(points.points(), spacing_of_means(points.points()));
    std::vector<std::size_t> mean_of(points.points().size(), Points_to_estimate::none);
    for (std::size_t k = 0; k < means.indices.size(); ++k)
      mean_of[means.indices[k]] = k;
    const double unknown = (std::numeric_limits<double>::quiet_NaN)();
    m_positions.assign(cloud.number_of_points(), Vector(unknown, unknown, unknown));
    points.for_each([&](std::size_t i, std::size_t place) {
      if (place == Points_to_estimate::none || mean_of[place] == Points_to_estimate::none)
        return;
      m_positions[cloud.sample().index(i)] = points.to_global(means.positions[mean_of[place]]);
      mean_of[place] = Points_to_estimate::none; // the first of equal points stands for all
    });
  }

  bool has_distances() const override { return false; }

  bool read(const Sink& sink) override
  {
    for (const Vector& p : m_positions)
    {
      const Sample sample{p.x(), p.y(), p.z(), 0.};
      if (!sink(&sample, &sample + 1))
        break;
    }
    return true;
  }
};

// gives the points of the cloud that are no means the distances of the nearest mean
inline void complete_field(const Surveyed_cloud& cloud, const Surveyed_cloud& means, Distance_field& field)
{
  static constexpr double reach = 2.; // all points are nearer to a mean, strays aside
  const double unit = field.sampling_distance;
  const Vector middle = median_position(means.sample().positions);
  const auto to_local = [&](const Vector& p) { return Vector((p - middle) / unit); };
  std::vector<Vector> places;
  for (const Vector& p : means.sample().positions)
    places.push_back(to_local(p));
  const Ball_search search(places);
  std::vector<std::size_t> found;
  field.number_of_near_points = 0;
  cloud.for_each([&](const Vector& p, double, std::size_t index) {
    const Vector place = to_local(p);
    search.query(place, reach, found);
    const auto nearest = std::min_element(found.begin(), found.end(), [&](std::size_t a, std::size_t b) {
      return std::make_pair((places[a] - place).squaredNorm(), a)
        < std::make_pair((places[b] - place).squaredNorm(), b);
    });
    const bool is_known = nearest != found.end();
    const std::size_t source = is_known ? means.sample().index(*nearest) : index;
    field.distances[index] = is_known ? field.distances[source] : field.truncation;
    field.deviations[index] = is_known ? field.deviations[source] : field.noise_level * unit;
    field.number_of_near_points += field.distances[index] < field.truncation;
  });
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_MEAN_CLOUD_H
