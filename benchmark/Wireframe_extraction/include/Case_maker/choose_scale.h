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

#ifndef CASE_MAKER_CHOOSE_SCALE_H
#define CASE_MAKER_CHOOSE_SCALE_H

#include <Case_maker/Case_error.h>
#include <Sample_solids/Poisson_sampler.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

namespace Case_maker {

/// How large a shape is made: the sampling distance is given, so its size decides how dense its cloud is.
struct Scale_rule
{
  double sampling_distance = 0.02;
  double quantile = 0.25;      ///< the curves of this quantile of the lengths
  double quantile_length = 50; ///< become so long, in sampling distances
  std::size_t max_points = 2000000;
  bool is_coarsened = true; ///< whether shapes that need more points are made smaller, or left out
};

/// returns a quantile, between two values by linear interpolation.
inline double quantile_of(std::vector<double> values, double quantile)
{
  std::sort(values.begin(), values.end());
  const double x = quantile * static_cast<double>(values.size() - 1);
  const std::size_t i = (std::min)(static_cast<std::size_t>(x), values.size() - 1);
  const std::size_t j = (std::min)(i + 1, values.size() - 1);
  return values[i] + (x - static_cast<double>(i)) * (values[j] - values[i]);
}

/// returns the factor by which a shape is to be scaled.
/// \param lengths  of its sharp curves
/// \param area     of its surface
/// \param remarks  where it is told if the shape needs too many points
inline double choose_scale(const std::vector<double>& lengths, double area, const Scale_rule& rule,
                           std::string& remarks)
{
  if (lengths.empty())
    throw Case_error(NO_SHARP_CURVE, "the shape has no sharp curve, and nothing else tells how to scale it");
  const double length = quantile_of(lengths, rule.quantile);
  if (!(length > 0) || !(area > 0) || !std::isfinite(length) || !std::isfinite(area))
    throw bad_input("the shape has no extent: its area is " + std::to_string(area)
                    + ", the quantile of its "
                      "curves' lengths "
                    + std::to_string(length));
  const double scale = rule.quantile_length * rule.sampling_distance / length;
  const double per_area = Sample_solids::density / (rule.sampling_distance * rule.sampling_distance);
  const double points = per_area * area * scale * scale;
  if (points < 50)
    throw bad_input("the cloud would have only " + std::to_string(static_cast<int>(points))
                    + " points; ask for longer curves (--quantile-length)");
  if (points <= static_cast<double>(rule.max_points))
    return scale;
  const double smaller = std::sqrt((static_cast<double>(rule.max_points) - 0.5) / (per_area * area));
  std::ostringstream text;
  text.precision(3);
  text << points << " points would be needed, more than " << static_cast<double>(rule.max_points);
  if (!rule.is_coarsened)
    throw Case_skipped(text.str());
  text << "; made coarser, the quantile of the curves is " << length * smaller / rule.sampling_distance
       << " r long instead of " << rule.quantile_length;
  remarks += (remarks.empty() ? "" : "; ") + text.str();
  return smaller;
}

} // namespace Case_maker

#endif // CASE_MAKER_CHOOSE_SCALE_H
