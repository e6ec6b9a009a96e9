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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_STEP_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_STEP_H

#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Section_sums.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A point that a local curve is fitted to.
struct Local_curve_sample
{
  Vector point;
  double distance, deviation, weight; // of the field, of that, and in the fit
  double to_others;                   // distance to the nearest of the other curves

  // whether another curve than one at `distance_to_curve` is nearer, explains the field here, and does so better
  bool belongs_to_other(double distance_to_curve) const
  {
    const double e = std::abs(distance - to_others);
    return to_others < distance_to_curve && e < std::abs(distance - distance_to_curve)
      && e < agreement_tolerance(deviation);
  }
};

// One robust Gauss-Newton step of `curve` on sum rho(d_i - |p_i - c(p_i)|), where residuals well above `scale` count as
// outliers, and curvatures above `bend_deviation` as unlikely. Returns how far it went.
inline double improve(Local_curve& curve, const std::vector<Local_curve_sample>& samples, double bend_deviation,
                      double scale)
{
  // steps beyond it, in r, leave what the linearisation knows
  static constexpr double longest_step = 1.;
  // on the curve itself, the direction to it is undefined: nearer than that, it counts for less, and in the end not
  static constexpr double near_curve = 0.05, on_curve = 1e-9;
  // keeps the equations solvable where no point tells
  static constexpr double least_damping = 1e-3, relative_damping = 0.5e-3;

  typedef Eigen::Matrix<double, 6, 6> Matrix6;
  typedef Eigen::Matrix<double, 6, 1> Vector6;
  const Vector normal = curve.tangent.unitOrthogonal();
  const Vector binormal = curve.tangent.cross(normal);
  Matrix6 hessian;
  Vector6 gradient;
  const double bend_x = curve.bend.dot(normal), bend_y = curve.bend.dot(binormal);
  Section_sums sums;
  for (const Local_curve_sample& sample : samples)
  {
    const Vector offset = sample.point - curve.point;
    const double s = offset.dot(curve.tangent), square = s * s;
    const double x = offset.dot(normal) - 0.5 * square * bend_x;
    const double y = offset.dot(binormal) - 0.5 * square * bend_y;
    const double distance = std::sqrt(x * x + y * y);
    if (distance < on_curve || sample.belongs_to_other(distance))
      continue;
    const double e = sample.distance - distance;
    const double own_scale = (std::max)(scale, exceeded_by_one_in_22 * sample.deviation);
    const double ratio = e / own_scale, worth = scale / own_scale, spread = 1. + ratio * ratio;
    const double weight = sample.weight * worth * worth / (spread * spread);
    // on the curve itself, the direction to it is undefined
    const double per_distance = 1. / (std::max)(distance, near_curve);
    const double powers[5] = {1., s, square, square * s, square * square};
    sums.add(powers, x * per_distance, y * per_distance, weight, e);
  }
  sums.assemble(hessian, gradient);
  // a prior on the curvature, and a little damping for the rest
  const double prior = scale * scale / (bend_deviation * bend_deviation);
  hessian(4, 4) += prior;
  hessian(5, 5) += prior;
  gradient(4) -= prior * bend_x;
  gradient(5) -= prior * bend_y;
  // the same for both normals, since their directions are arbitrary
  for (int k = 0; k < 6; k += 2)
  {
    const double damping = least_damping + relative_damping * (hessian(k, k) + hessian(k + 1, k + 1));
    hessian(k, k) += damping;
    hessian(k + 1, k + 1) += damping;
  }
  const Vector6 delta = Symmetric_factorization(hessian).solved(gradient);
  const double length = delta.head<2>().norm();
  const double shrink = length > longest_step ? longest_step / length : 1.;
  curve.point += shrink * (delta(0) * normal + delta(1) * binormal);
  curve.bend += shrink * (delta(4) * normal + delta(5) * binormal);
  curve.tangent = (curve.tangent + shrink * (delta(2) * normal + delta(3) * binormal)).normalized();
  curve.bend -= curve.bend.dot(curve.tangent) * curve.tangent;
  return length + delta.tail<4>().norm();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_STEP_H
