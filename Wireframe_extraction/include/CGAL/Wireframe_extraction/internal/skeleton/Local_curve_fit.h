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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/local_curve_step.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

struct Local_fit_options
{
  double radius = 4.;          // of the ball the points come from
  double scale = 0.3;          // residuals well above it count as outliers: about the noise of a regressor
  double bend_deviation = 0.2; // expected size of the curvature, per r: of a circle with a radius of 5 r
  int iterations = 8;          // at most; the scale of outliers reaches its end after three
};

// Fits a local curve to the field: the distances of the points to the curve shall be the field's values.
// Robust Gauss-Newton steps on the sum of rho(d_i - |p_i - c(p_i)|).
class Local_curve_fit
{
  typedef Local_curve_sample Sample;

  const Field_band& m_band;
  std::vector<std::size_t> m_ball;
  Vector m_center = Vector::Zero();
  double m_radius = -1.;
  std::vector<Sample> m_samples;     // of the ball, for a fit
  std::vector<Local_curve> m_others; // curves nearby that explain points of their own

  // Thresholds. Lengths are in sampling distances.

  // The scale above which residuals count as outliers starts where the first guess may be off, and shrinks.
  static constexpr double first_scale = 1.2, shrinking = 0.6;
  // steps below it change nothing
  static constexpr double settled_step = 1e-4;
  // Balls are tried from large to small: large ones average more noise away, small ones follow small features.
  static constexpr int number_of_radii = 4;
  static constexpr double radius_factors[number_of_radii] = {1.6, 1., 0.6, 0.4};
  // A residual that needs no smaller ball, twice that of exact fields; and how much larger than the best one that of
  // the largest ball may be, by chance: residuals of a dozen points are known to a third.
  static constexpr double good_enough = 0.02, most_above_best = 1.35;
  // of a curve that too few points agree with, and the most that a single point counts for
  static constexpr double worst_residual = 1.;
  static constexpr std::size_t least_points = 4;
  // variance of distances that are known better than that: curves are no parabolas
  static constexpr double least_variance = 0.01;

public:
  static constexpr double residual_radius = 2.; // r, of the ball in which residuals are taken

  explicit Local_curve_fit(const Field_band& band) : m_band(band) {}

  const std::vector<std::size_t>& ball() const { return m_ball; }

  // from now on, points that these curves explain better, and are nearer to, say nothing
  void set_other_curves(const std::vector<Local_curve>& others) { m_others = others; }

  double distance_to_others(const Vector& p) const
  {
    double result = (std::numeric_limits<double>::infinity)();
    for (const Local_curve& other : m_others)
      result = (std::min)(result, other.distance(p));
    return result;
  }

  // the main axis of the points near `center` weighted by their closeness to the feature
  Local_curve principal_axis(const Vector& center, double radius)
  {
    return principal_axis(center, radius, [](std::size_t) { return true; });
  }

  // the same for those of the points that `accept` takes
  template <class Accept>
  Local_curve principal_axis(const Vector& center, double radius, const Accept& accept)
  {
    query(center, radius);
    double total = 0.;
    Vector mean = Vector::Zero();
    Matrix_3 moments = Matrix_3::Zero();
    for (std::size_t i : m_ball)
    {
      if (!accept(i))
        continue;
      const Vector offset = m_band.points[i] - center;
      const double weight =
        std::exp(-m_band.distances[i] * m_band.distances[i]) * kernel(offset.squaredNorm() / (radius * radius));
      total += weight;
      mean += weight * offset;
      moments += Matrix_3::outer(weight * offset, offset);
    }
    Local_curve axis;
    axis.point = center;
    if (!(total > 0.))
      return axis;
    mean /= total;
    axis.point = center + mean;
    axis.tangent = principal_axes(moments / total - Matrix_3::outer(mean, mean)).axes[2];
    return axis;
  }

  // improves `curve` on the points around `center`
  void refine(Local_curve& curve, const Vector& center, const Local_fit_options& options)
  {
    collect(center, options.radius);
    for (int k = 0; k < options.iterations; ++k)
    {
      // the outliers leave gradually, or the first guess would decide alone
      const double scale = (std::max)(options.scale, first_scale * std::pow(shrinking, k));
      curve.move_along_to(center);
      if (improve(curve, m_samples, options.bend_deviation, scale) < settled_step && scale == options.scale)
        break;
    }
    curve.move_along_to(center);
  }

  // improves a `curve` that is nearly right already: outliers are none of its business from the start
  void refine_from(Local_curve& curve, const Vector& center, const Local_fit_options& options)
  {
    collect(center, options.radius);
    for (int k = 0; k < options.iterations; ++k)
    {
      curve.move_along_to(center);
      if (improve(curve, m_samples, options.bend_deviation, options.scale) < settled_step)
        break;
    }
  }

  // refines `curve` with balls of several radii and keeps the largest one that fits as well as any: a large ball
  // averages more noise away, a small one follows small features. Returns the residual close to the point.
  template <class Refine>
  double refine_with_best_radius(Local_curve& curve, const Local_fit_options& options, const Refine& refine_one)
  {
    Local_curve fits[number_of_radii];
    double residuals[number_of_radii], best = worst_residual;
    for (int k = 0; k < number_of_radii && (k == 0 || residuals[0] > good_enough); ++k)
    {
      fits[k] = curve;
      Local_fit_options scaled = options;
      scaled.radius *= radius_factors[k];
      refine_one(fits[k], scaled);
      // too few points agree with any curve
      residuals[k] = m_ball.size() < least_points ? worst_residual : residual(fits[k], fits[k].point, residual_radius);
      best = (std::min)(best, residuals[k]);
    }
    int chosen = 0;
    while (residuals[chosen] > most_above_best * best + good_enough)
      ++chosen;
    curve = fits[chosen];
    return residuals[chosen];
  }

  // root mean square, cut off at 1, of the residuals of the points within `radius` of `center`
  double residual(const Local_curve& curve, const Vector& center, double radius)
  {
    query(center, radius);
    double sum = 0., total = 0.;
    for (std::size_t i : m_ball)
    {
      const double weight =
        1. / growth_of_variance(m_band.distances[i]) / (least_variance + std::pow(m_band.deviation(i, 0.), 2));
      const double distance = curve.distance(m_band.points[i]);
      if (sample(i, weight).belongs_to_other(distance))
        continue;
      const double e = m_band.distances[i] - distance;
      sum += weight * (std::min)(worst_residual * worst_residual, e * e);
      total += weight;
    }
    return total > 0. ? std::sqrt(sum / total) : worst_residual;
  }

private:
  static double kernel(double squared_ratio)
  {
    return squared_ratio < 1. ? (1. - squared_ratio) * (1. - squared_ratio) : 0.;
  }

  Sample sample(std::size_t i, double weight) const
  {
    return {m_band.points[i], m_band.distances[i], m_band.deviation(i, 0.), weight,
            distance_to_others(m_band.points[i])};
  }

  // one ball is often asked for several times
  void query(const Vector& center, double radius)
  {
    if (center == m_center && radius == m_radius)
      return;
    m_center = center;
    m_radius = radius;
    m_band.search.query(center, radius, m_ball);
  }

  void collect(const Vector& center, double radius)
  {
    query(center, radius);
    m_samples.clear();
    for (std::size_t i : m_ball)
      m_samples.push_back(sample(i,
                                 1. / growth_of_variance(m_band.distances[i])
                                   * kernel((m_band.points[i] - center).squaredNorm() / (radius * radius))));
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_FIT_H
