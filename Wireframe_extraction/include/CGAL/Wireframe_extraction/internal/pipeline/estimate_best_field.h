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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ESTIMATE_BEST_FIELD_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ESTIMATE_BEST_FIELD_H

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/estimate/mean_points.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Mean_cloud.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/estimate_distances.h>

#include <cstddef>
#include <functional>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The field of a cloud that has none, and what the stages after it look at instead of the cloud if that has much noise.
struct Best_field
{
  Distance_field field;                  // of all points; its sampling distance is that of the means, if there are any
  std::unique_ptr<Mean_cloud> means;     // of the points
  std::unique_ptr<Surveyed_cloud> cloud; // of the means
  std::string warning;                   // of the means
};

// The one way from points to their field. `unit` is the sampling distance of the cloud, which is in memory; a unit that
// was given is kept, whatever the noise. Returns whether it came to its end.
inline bool estimate_best_field(const Surveyed_cloud& cloud, double unit, bool is_unit_given, double minimum_fold,
                                const std::function<bool(double)>& proceed, Best_field& result)
{
  Distance_field& field = result.field;
  if (!estimate_distances(cloud, unit, minimum_fold, proceed, field))
    return false;
  if (is_unit_given || !(field.point_noise > most_point_noise * unit))
    return true;
  auto means = std::make_unique<Mean_cloud>(cloud, unit);
  auto cloud_of_means = std::make_unique<Surveyed_cloud>(*means, (std::numeric_limits<std::size_t>::max)());
  cloud_of_means->survey();
  const double coarse_unit = cloud_of_means->scale().sampling_distance;
  if (!(coarse_unit > unit))
    return true;
  const double point_noise = field.point_noise;
  // its share of the progress is used up
  const auto go_on = [&proceed](double) { return !proceed || proceed(1.); };
  if (!estimate_distances(*cloud_of_means, coarse_unit, minimum_fold, go_on, field))
    return false;
  field.point_noise = point_noise;
  complete_field(cloud, *cloud_of_means, field);
  result.means = std::move(means);
  result.cloud = std::move(cloud_of_means);
  std::ostringstream text;
  text << std::setprecision(3) << "the points err by " << point_noise << ", more than they lie apart (" << unit
       << "): the sharp features are those of their means, which lie " << coarse_unit << " apart";
  result.warning = text.str();
  return true;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ESTIMATE_BEST_FIELD_H
