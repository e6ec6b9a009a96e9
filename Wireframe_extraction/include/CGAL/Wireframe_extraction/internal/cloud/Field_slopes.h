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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_FIELD_SLOPES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_FIELD_SLOPES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Cloud_scale.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How steep a field is along the surface, at some points. A distance changes as fast as one walks: its gradient is 1,
// but where two features are equally near, where it is less. What is computed from distances gives itself away: the
// gradient of a square grows with its root, that of an exponential with itself.
class Field_slopes
{
  struct Slope
  {
    double field, gradient, largest_around;
  };

  std::vector<Slope> m_slopes;

  // the median of fewer says little
  static constexpr std::size_t least_count = 64;
  // Fields with errors are noise where they are least.
  static constexpr double share_of_least = 0.1;
  // By how much the gradients have to scatter less around such a law than around 1. Over the clouds of the benchmark,
  // with errors or without, they never scatter less by 0.7.
  static constexpr double most_relative_scatter = 0.6;
  // The gradient of the root of a square; that of a distance in a thin part, where features are everywhere, is 0.6.
  static constexpr double least_gradient_of_root = 0.5, most_gradient_of_root = 1.6;
  // Within about the radius of a ball from a feature, which lies in the ball then, gradients are too small, and grow
  // with the distance as those of a square do. There the largest value in the ball is beyond twice that at its center.
  static constexpr double most_relative_change = 2.;
  // Below this share of the first axis, a ball of points has no extent: it is a strip, or flat.
  static constexpr double least_relative_axis = 0.25;

public:
  // takes a point, and the offsets to its neighbors with the field there
  void add(double field, const std::vector<std::pair<Vector, double>>& neighbors)
  {
    if (neighbors.size() < 4)
      return; // a plane goes through three whatever they are
    const Scatter offsets = scatter(neighbors, [](const auto& neighbor) { return neighbor.first; });
    double mean = 0., largest = 0.;
    for (const auto& neighbor : neighbors)
    {
      mean += neighbor.second / double(neighbors.size());
      largest = (std::max)(largest, neighbor.second);
    }
    Vector change = Vector::Zero();
    for (const auto& neighbor : neighbors)
      change += (neighbor.second - mean) * (neighbor.first - offsets.mean);
    const Principal_axes axes = principal_axes(offsets.matrix);
    double squared = 0.;
    for (const int k : {1, 2}) // the surface; ascending
      if (axes.values[k] > least_relative_axis * least_relative_axis * axes.values[2])
      {
        const double slope = axes.axes[std::size_t(k)].dot(change) / axes.values[k];
        squared += slope * slope;
      }
    if (std::isfinite(squared))
      m_slopes.push_back({field, std::sqrt(squared), largest});
  }

  // what the field seems to be
  void describe(Cloud_scale& scale) const
  {
    std::vector<Slope> slopes = m_slopes;
    std::sort(slopes.begin(), slopes.end(), [](const Slope& a, const Slope& b) {
      return a.field < b.field || (a.field == b.field && a.gradient < b.gradient);
    });
    double largest = 0.;
    for (const Slope& slope : slopes)
      largest = (std::max)(largest, slope.largest_around);
    slopes.erase(slopes.begin(), slopes.begin() + static_cast<std::ptrdiff_t>(share_of_least * double(slopes.size())));
    slopes.erase(std::remove_if(slopes.begin(), slopes.end(),
                                [largest](const Slope& slope) {
                                  // where a field is cut off, it changes no more
                                  return !(slope.field > 0.) || !(slope.gradient > 0.)
                                    || slope.largest_around == largest;
                                }),
                 slopes.end());
    if (slopes.size() < least_count)
      return;
    scale.gradient = upper_quartile_over_root(slopes, 0.);
    const double of_root = 0.5 * upper_quartile_over_root(slopes, 0.5);
    const std::vector<Slope> inner = away_from_features(slopes);
    // All of them must follow the law, since those away from features are few in a thin part, and may be alike; but one
    // that falls so fast that no point is far from features, as it says, is no distance in any case.
    if (follows_power(slopes, 1.) && (inner.size() < least_count || follows_power(inner, 1.)))
      scale.meaning = Field_meaning::EXPONENTIAL;
    else if (of_root > least_gradient_of_root && of_root < most_gradient_of_root && inner.size() >= least_count
             && follows_power(inner, 0.5))
      scale.meaning = Field_meaning::SQUARED;
  }

private:
  static std::vector<Slope> away_from_features(std::vector<Slope> slopes)
  {
    slopes.erase(
      std::remove_if(slopes.begin(), slopes.end(),
                     [](const Slope& slope) { return slope.largest_around > most_relative_change * slope.field; }),
      slopes.end());
    return slopes;
  }

  static bool follows_power(const std::vector<Slope>& slopes, double power)
  {
    return scatter_around_power(slopes, power) < most_relative_scatter * scatter_around_power(slopes, 0.);
  }

  // how much the logarithms of the gradients scatter around a power of the field
  static double scatter_around_power(const std::vector<Slope>& slopes, double power)
  {
    std::vector<double> values;
    for (const Slope& slope : slopes)
      values.push_back(std::log(slope.gradient) - power * std::log(slope.field));
    const double middle = median(values);
    for (double& value : values)
      value = std::abs(value - middle);
    return median(values);
  }

  // Of the gradients divided by a power of the field: the upper quartile, since it is less where features are near on
  // two sides.
  static double upper_quartile_over_root(const std::vector<Slope>& slopes, double power)
  {
    std::vector<double> values;
    for (const Slope& slope : slopes)
      values.push_back(slope.gradient / std::pow(slope.field, power));
    const std::size_t index = 3 * values.size() / 4;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index), values.end());
    return values[index];
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_FIELD_SLOPES_H
