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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_INPUT_CHECKS_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_INPUT_CHECKS_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What a cloud must have so that its numbers can be meant, and what is told to the user otherwise.
struct Input_limits
{
  // the outermost tenth of a sample is left out where its dimension is asked
  static constexpr std::size_t outermost_share = 10;
  // Rounding, relative to the coordinates; and of variances, relative to the squared extent, where single precision
  // leaves planes a thickness of 1e-7.
  static constexpr double rounding = 1e-12, variance_rounding = 1e-14;
  // How much a field changes from point to point per distance: by 1 at most if it is exact, by more with errors, and by
  // a power of ten with another unit.
  static constexpr double most_slope = 8., least_slope = 0.1, most_usual_slope = 4., least_usual_slope = 0.6;
  // The gradient of a field along the surface is 1, but less where features are near on two sides: over the clouds of
  // the benchmark, its upper quartile is 0.6 to 1.3.
  static constexpr double least_gradient = 0.1, most_gradient = 3.;
  // If so many points of at least so many have the smallest distance, it is no distance.
  static constexpr double most_at_smallest = 0.5;
  static constexpr std::size_t least_points_at_smallest = 64;
  // Steps of single precision, in sampling distances: rounding to them is noise of 0.14 and of 0.03.
  static constexpr double largest_step = 0.5, largest_usual_step = 0.1;
  // by what factor a given sampling distance may differ from the measured one
  static constexpr double most_times_denser = 10., most_times_coarser = 0.1;
  // if as many points have the largest distance, it was cut off there
  static constexpr double least_truncated_share = 0.05;
  // no point within so many sampling distances of a feature: the regressor DEF cuts its fields off there
  static constexpr double farthest_from_features = 50.;
};

CGAL_WIREFRAME_EXTRACTION_INLINE bool survey(Surveyed_cloud& cloud, bool skip_invalid,
                                             Wireframe_extraction_report& report)
{
  const bool is_read = cloud.survey();
  const std::size_t invalid = cloud.number_of_not_finite() + cloud.number_of_negative();
  report.number_of_points = cloud.number_of_points();
  report.number_of_skipped_points = invalid;
  std::ostringstream message;
  if (!is_read)
    message << cloud.error();
  else if (cloud.number_of_points() == 0)
    message << "the cloud has no points; a wireframe needs points of a surface";
  else if (invalid > 0 && !skip_invalid && !cloud.has_distances())
    message << invalid << " points have coordinates that are not finite; the first is the point with index "
            << cloud.first_invalid() << " (counted from 0); remove them, or leave them out by skip_invalid(true)";
  else if (invalid > 0 && !skip_invalid)
    message << cloud.number_of_not_finite() << " points have coordinates or distances that are not finite and "
            << cloud.number_of_negative() << " have negative distances; the first is the point with index "
            << cloud.first_invalid() << " (counted from 0); remove them, or leave them out by skip_invalid(true)";
  else if (cloud.number_of_valid() == 0)
    message << "none of the " << cloud.number_of_points() << " points is valid; repair coordinates"
            << (cloud.has_distances() ? " and distances" : "");
  report.message = message.str();
  return report.message.empty();
}

CGAL_WIREFRAME_EXTRACTION_INLINE int dimension(const std::vector<Vector>& positions,
                                               const std::vector<std::size_t>& sample)
{
  std::vector<Vector> offsets;
  for (std::size_t i : sample)
    offsets.push_back(positions[i]);
  const Vector center = median_position(offsets);
  for (Vector& offset : offsets)
    offset -= center;
  std::sort(offsets.begin(), offsets.end(),
            [](const Vector& a, const Vector& b) { return a.stableNorm() < b.stableNorm(); });
  offsets.resize((std::max)(std::size_t(1), offsets.size() - offsets.size() / Input_limits::outermost_share));
  const double extent = offsets.back().stableNorm();
  if (!(extent > Input_limits::rounding * center.cwiseAbs().maxCoeff()))
    return 0;
  Vector mean = Vector::Zero();
  for (Vector& offset : offsets)
  {
    offset /= extent;
    mean += offset / double(offsets.size());
  }
  Matrix_3 covariance = Matrix_3::Zero();
  for (const Vector& offset : offsets)
    covariance += Matrix_3::outer(offset - mean, offset - mean) / double(offsets.size());
  const Vector variances = principal_axes(covariance).values;
  const auto is_there = [](double variance) { return int(variance > Input_limits::variance_rounding); };
  return is_there(variances[0]) + is_there(variances[1]) + is_there(variances[2]);
}

CGAL_WIREFRAME_EXTRACTION_INLINE int dimension(const std::vector<Vector>& positions)
{
  const int result = dimension(positions, spread_indices(positions.size()));
  if (result > 1)
    return result;
  // scanners write many points at one place: those count once
  const std::vector<std::size_t> different = different_positions(positions);
  std::vector<std::size_t> sample = spread_indices(different.size());
  for (std::size_t& i : sample)
    i = different[i];
  return dimension(positions, sample);
}

CGAL_WIREFRAME_EXTRACTION_INLINE bool check_dimension(const Surveyed_cloud& cloud, Wireframe_extraction_report& report)
{
  const int dimension = internal::dimension(cloud.sample().positions);
  if (dimension == 0 && different_positions(cloud.sample().positions).size() > 1)
    report.message =
      "against their distance from the origin, all points nearly coincide, so that their coordinates do not tell "
      "them apart; subtract an offset from the coordinates";
  else if (dimension < 2)
    report.message = std::string(dimension == 0 ? "all points coincide" : "all points lie on one line")
      + "; a wireframe needs points of a surface, so check what holds x, y and z";
  if (dimension == 2)
    report.warnings.push_back("all points lie in one plane");
  return dimension >= 2;
}

// what is wrong with a field that is no distance, with the likely reason; empty if it may be one
CGAL_WIREFRAME_EXTRACTION_INLINE std::string other_meaning(const Surveyed_cloud& cloud, const Cloud_scale& scale)
{
  std::ostringstream message;
  const std::size_t count = cloud.number_of_valid(), smallest = cloud.number_of_smallest();
  const std::string wanted =
    "give each point its distance to the nearest sharp curve, or no field, so that the distances are estimated";
  if (count < Input_limits::least_points_at_smallest)
    return std::string();
  if (smallest + cloud.number_of_largest() == count)
    message << "the field has only two values, " << cloud.smallest_distance() << " and " << cloud.largest_distance()
            << ": it marks points, and is no distance; " << wanted;
  else if (double(smallest) > Input_limits::most_at_smallest * double(count))
    message << smallest << " of " << count << " points have the smallest value of the field, "
            << cloud.smallest_distance() << ", which is the distance of points at features only; is it a probability? "
            << wanted;
  else if (scale.meaning == Field_meaning::SQUARED)
    message << "the field is no distance: it gets steeper the larger it is, as squared distances do; take the square "
               "root of it";
  else if (scale.meaning == Field_meaning::EXPONENTIAL)
    message << "the field is no distance: it gets steeper the larger it is, as a probability or exp(-distance / s) "
               "does, which is largest at features; "
            << wanted;
  return message.str();
}

// what is wrong with a field that changes otherwise than one walks; empty if it does not
CGAL_WIREFRAME_EXTRACTION_INLINE std::string other_gradient(const Cloud_scale& scale)
{
  const double gradient = scale.gradient;
  if (gradient == 0. || (gradient >= Input_limits::least_gradient && gradient <= Input_limits::most_gradient))
    return std::string();
  std::ostringstream message;
  message << "the distances do not fit the points: along the surface, they change by " << gradient
          << " per distance, and not by 1; are they in another unit, or something else than distances?";
  return message.str();
}

CGAL_WIREFRAME_EXTRACTION_INLINE bool check_scale(const Surveyed_cloud& cloud, const Cloud_scale& scale, double given,
                                                  Wireframe_extraction_report& report)
{
  std::ostringstream message;
  const bool has_distances = cloud.has_distances();
  const std::string meaning = has_distances ? other_meaning(cloud, scale) : std::string();
  const std::string gradient = has_distances ? other_gradient(scale) : std::string();
  if (has_distances && cloud.smallest_distance() == cloud.largest_distance())
    message << "all distances are " << cloud.smallest_distance() << ": this is no distance field; "
            << "give each point its own distance to the nearest sharp curve";
  else if (!meaning.empty())
    message << meaning;
  else if (has_distances && scale.slope > Input_limits::most_slope)
    message << "the distances do not fit the points: from point to point they change " << scale.slope
            << " times as much as the points are apart; are they in another unit?";
  else if (has_distances && scale.slope < Input_limits::least_slope)
    message << "the distances do not fit the points: from point to point they change only " << scale.slope
            << " times as much as the points are apart; are they in another unit?";
  else if (!gradient.empty())
    message << gradient;
  else if (!(given >= 0.) || !std::isfinite(given))
    message << "the sampling distance must be positive and finite, not " << given;
  else if (given > Input_limits::most_times_denser * scale.sampling_distance
           || (given > 0. && given < Input_limits::most_times_coarser * scale.sampling_distance))
    message << "a sampling distance of " << given << " does not fit the points: their density says "
            << scale.sampling_distance << "; is it in another unit?";
  report.message = message.str();
  if (report.message.empty() && has_distances
      && (scale.slope > Input_limits::most_usual_slope || scale.slope < Input_limits::least_usual_slope))
  {
    message << "from point to point the distances change " << scale.slope
            << " times as much as the points are apart, so they have large errors or another unit";
    report.warnings.push_back(message.str());
  }
  return report.message.empty();
}

// The step from number to number of single precision, if all coordinates have it, where it is largest, and the
// coordinate there; 0 if they are more precise.
CGAL_WIREFRAME_EXTRACTION_INLINE double largest_single_step(const std::vector<Vector>& positions, double& where)
{
  for (const Vector& p : positions)
    for (int k = 0; k < 3; ++k)
    {
      if (p[k] != double(float(p[k])))
        return 0.;
      if (std::abs(p[k]) > std::abs(where))
        where = p[k];
    }
  const float single = std::abs(float(where));
  return double(std::nextafter(single, (std::numeric_limits<float>::infinity)())) - double(single);
}

CGAL_WIREFRAME_EXTRACTION_INLINE bool check_resolution(const Surveyed_cloud& cloud, double unit,
                                                       Wireframe_extraction_report& report)
{
  double where = 0.;
  const double step = largest_single_step(cloud.sample().positions, where);
  if (!(step > Input_limits::largest_usual_step * unit))
    return true;
  std::ostringstream message;
  message << "the coordinates have single precision, whose steps at " << where << " are " << step << ", " << step / unit
          << " times the sampling distance " << unit
          << "; write them in double precision, or subtract an offset before they are written";
  const bool is_usable = step <= Input_limits::largest_step * unit;
  if (is_usable)
    report.warnings.push_back(message.str());
  else
    report.message = message.str();
  return is_usable;
}

CGAL_WIREFRAME_EXTRACTION_INLINE bool check_truncation(const Surveyed_cloud& cloud, double unit,
                                                       const Extraction_options& options,
                                                       Wireframe_extraction_report& report)
{
  const double largest = cloud.largest_distance() / unit;
  if (double(cloud.number_of_largest()) < Input_limits::least_truncated_share * double(cloud.number_of_valid())
      || largest >= options.support_distance)
    return true;
  std::ostringstream message;
  message << "the distances are cut off at " << cloud.largest_distance() << ", " << largest
          << " times the sampling distance " << unit << "; they must be known up to " << options.support_distance
          << " times of it";
  const bool is_usable = largest > options.skeleton_distance;
  if (is_usable)
    report.warnings.push_back(message.str());
  else
    report.message = message.str();
  return is_usable;
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::string no_feature_message(const Surveyed_cloud& cloud, double unit,
                                                                double threshold)
{
  const double smallest = cloud.smallest_distance();
  std::ostringstream message;
  message << "no point lies near a feature: the smallest distance is " << smallest << ", the threshold is "
          << threshold * unit << " (" << threshold << " times the sampling distance " << unit << ")";
  if (smallest > Input_limits::farthest_from_features * unit)
    message << "; are the distances in another unit than the points, or largest at features, as probabilities are?";
  return message.str();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_INPUT_CHECKS_IMPL_H
