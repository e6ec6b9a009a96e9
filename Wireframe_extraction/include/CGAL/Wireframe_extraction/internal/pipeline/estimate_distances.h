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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ESTIMATE_DISTANCES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ESTIMATE_DISTANCES_H

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_scale.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/estimate/estimate_field.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The points of a cloud as the estimate takes them: each position once, in an order of their own,
// in sampling distances.
class Points_to_estimate
{
  std::vector<Vector> m_points;
  Vector m_middle = Vector::Zero(); // of the positions: where the points have their origin
  double m_unit;
  std::vector<std::size_t> m_order, m_place; // of the positions: sorted, and where each of these is among the points

public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  Points_to_estimate(const std::vector<Vector>& positions, double unit) : m_unit(unit)
  {
    m_order.resize(positions.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::sort(m_order.begin(), m_order.end(), [&](std::size_t a, std::size_t b) {
      const double* const p = positions[a].data();
      const double* const q = positions[b].data();
      return std::lexicographical_compare(p, p + 3, q, q + 3);
    });
    for (std::size_t k = 0; k < m_order.size(); ++k)
    {
      if (k == 0 || positions[m_order[k]] != positions[m_order[k - 1]])
        m_points.push_back(positions[m_order[k]]);
      m_place.push_back(m_points.size() - 1);
    }
    localize();
  }

  const std::vector<Vector>& points() const { return m_points; }
  Vector to_global(const Vector& point) const { return m_middle + m_unit * point; }

  // calls `use(index of a position, index of a point or none)` for all positions
  template <class Use>
  void for_each(const Use& use) const
  {
    for (std::size_t k = 0; k < m_order.size(); ++k)
      use(m_order[k], m_place[k]);
  }

private:
  void localize()
  {
    m_middle = median_position(m_points);
    std::vector<std::size_t> new_place(m_points.size(), none);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_points.size(); ++i)
    {
      const Vector point = (m_points[i] - m_middle) / m_unit;
      if (!(point.cwiseAbs().maxCoeff() < farthest_in_units))
        continue;
      new_place[i] = kept;
      m_points[kept++] = point;
    }
    m_points.resize(kept);
    for (std::size_t& place : m_place)
      place = new_place[place];
  }
};

// Estimates the distances of the points of a cloud that is in memory. Returns whether it came to its end. The result is
// the same in whatever order the points are.
inline bool estimate_distances(const Surveyed_cloud& cloud, double unit, double minimum_fold,
                               const std::function<bool(double)>& proceed, Distance_field& field)
{
  const Points_to_estimate points(cloud.sample().positions, unit);
  Field_estimate estimate;
  if (!estimate_field(points.points(), minimum_fold, proceed, estimate))
    return false;
  field.sampling_distance = unit;
  field.truncation = Field_estimate::truncation * unit;
  field.point_noise = estimate.point_noise * unit;
  field.noise_level = estimate.noise_level;
  field.number_of_near_points = 0;
  field.distances.assign(cloud.number_of_points(), (std::numeric_limits<double>::quiet_NaN)());
  field.deviations = field.distances;
  points.for_each([&](std::size_t i, std::size_t place) {
    const std::size_t index = cloud.sample().index(i);
    const bool is_known = place != Points_to_estimate::none;
    const bool is_near = is_known && estimate.distances[place] < Field_estimate::truncation;
    field.number_of_near_points += is_near;
    field.distances[index] = is_near ? estimate.distances[place] * unit : field.truncation;
    field.deviations[index] = (is_known ? estimate.deviations[place] : estimate.noise_level) * unit;
  });
  return true;
}

inline void report_field(const Distance_field& field, Wireframe_extraction_report& report)
{
  report.is_field_estimated = true;
  report.point_noise = field.point_noise;
  report.number_of_near_points = field.number_of_near_points;
}

inline std::string no_fold_message(double minimum_fold)
{
  std::ostringstream message;
  message << "the points show no fold of " << minimum_fold << " degrees or more (minimum_fold), so there is no sharp "
          << "feature, or the points are too few or too noisy to see it";
  return message.str();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ESTIMATE_DISTANCES_H
