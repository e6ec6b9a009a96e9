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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CREASE_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CREASE_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Section_sums.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Two surface strips that meet along a local curve.
struct Crease
{
  Local_curve curve;
  double fold = 0.; // angle by which the normal turns across the curve
  double fold_deviation = 1.;
  double deviation = 1.;  // standard deviation of the curve's position, across it, where it is known worst
  double residual = 1.;   // of the points from the strips, root mean square
  bool is_traced = false; // part of a curve along the crease
  Vector strips[2];       // unit directions in which the strips leave the curve's point

  // what turns less, 20 degrees, is smooth, as it is where chains of edges pass a vertex
  static constexpr double least_sharp_fold = 0.35;
  // of the strips, per r: a radius of 5 r, about that of the ball of a fit
  static constexpr double largest_curvature = 0.2;

  // whether the surface is folded there beyond doubt
  bool is_sharp() const { return fold > (std::max)(least_sharp_fold, exceeded_by_one_in_16000 * fold_deviation); }

  // whether a point lies on one of the strips, up to `tolerance`
  bool holds(const Vector& p, double tolerance) const
  {
    const Vector offset = p - curve.at(curve.parameter(p));
    for (const Vector& strip : strips)
    {
      const double along = offset.dot(strip);
      if (along > -tolerance && (offset - along * strip).norm() < tolerance + 0.5 * largest_curvature * along * along)
        return true;
    }
    return false;
  }
};

struct Crease_fit_options
{
  double radius = 4.;
  double field_noise = 0.3;   // of the distances
  double surface_noise = 0.1; // of the points' positions
  int iterations = 8;         // at most; the scale of outliers reaches its end after four, unless points err by 0.2
};

// Fits a crease to the points themselves and to the field at once: the points shall lie on two strips, and their
// distances to the curve where the strips meet shall be the field's values but for a common bias. In the frame that
// moves along the curve, a strip is a parabola that leaves the curve; its direction may turn along the curve.
class Crease_fit
{
  // apex, its change and second change along the curve, directions of the strips, their curvatures, twists, bias
  static constexpr int size = 13;
  typedef Eigen::Matrix<double, size, size> Matrix;
  typedef Eigen::Matrix<double, size, 1> Parameters;

  struct Sample
  {
    double s, x, y, distance, weight;
  };

  const Field_band& m_band;
  std::vector<std::size_t> m_ball;
  std::vector<Sample> m_samples;
  std::vector<double> m_losses; // of the samples, for each direction

  // Thresholds. Lengths are in sampling distances, angles in radians.

  // the first guess, whose error the following steps correct: the directions are 11 degrees apart
  static constexpr int number_of_directions = 32;
  // points farther from both half-lines than that say nothing about them: half the spacing of the points
  static constexpr double guess_reach = 0.5;
  // Fewer points determine no crease. There are 13 parameters, but seven of them have expected sizes.
  static constexpr std::size_t least_samples = 10;
  // Residuals above the scale count as outliers. It starts where the first guess may be off, and shrinks from step to
  // step, but not below what one in 80 points exceeds.
  static constexpr double first_scale = 0.6, shrinking = 0.6;
  // A step beyond `longest_step` leaves what the linearisation knows; one below `settled_step` changes nothing.
  static constexpr double longest_step = 0.5, settled_step = 1e-4;
  // On the curve itself, the direction to it is undefined: nearer than that, it counts for less, and in the end not.
  static constexpr double near_curve = 0.05, on_curve = 1e-9;
  // Expected sizes, as standard deviations, per r: of the change of the curve's bend (a radius of 8 r), of the strips'
  // curvatures (12 r), of their twist. Without them, a few points on a side let the fit wind.
  static constexpr double bend_deviation = 0.12, strip_deviation = 0.08, twist_deviation = 0.06;
  // for the parameters of which nothing is expected: keeps the equations solvable where no point tells
  static constexpr double least_information = 1e-3, relative_information = 1e-4;
  // The residual is that of the points near the curve's point; none counts for more than `worst_miss`.
  static constexpr double residual_radius = 3., residual_length = 2., worst_miss = 0.5;
  // Balls are tried from large to small: large ones average more noise away, small ones follow small features.
  static constexpr double radius_factors[] = {1.5, 1., 0.6, 0.4};
  // balls behind the front by this share of their radii, where these are not the smallest ones
  static constexpr double shift_back = 0.6, least_factor_to_shift = 0.5;
  // The residual of a crease that is as expected exceeds the noise by no more than that: that of
  // fifty points is known to ten per cent.
  static constexpr double residual_inflation = 1.2;
  // below this noise a corner ahead shows in the residual
  static constexpr double least_noise_to_hide_corners = 0.05;
  // of the curve's position, when nothing was fitted: worse than any
  static constexpr double unknown_deviation = 10.;

public:
  explicit Crease_fit(const Field_band& band) : m_band(band) {}

  // `previous`, if given, is a crease close by whose strips go on
  Crease fit(const Local_curve& start, const Vector& center, const Crease_fit_options& options,
             const Crease* previous = nullptr)
  {
    Crease crease;
    crease.curve = start;
    const Vector normal = start.tangent.unitOrthogonal();
    const Vector binormal = start.tangent.cross(normal);
    collect(start, center, normal, binormal, options.radius);
    if (m_samples.size() < least_samples)
      return crease;
    Parameters q = Parameters::Zero();
    if (previous)
      for (int k = 0; k < 2; ++k)
        q[6 + k] = std::atan2(previous->strips[k].dot(binormal), previous->strips[k].dot(normal));
    else
      find_directions(q[6], q[7]);
    Matrix hessian;
    const double least_scale = exceeded_by_one_in_80 * options.surface_noise;
    double scale = (std::max)(least_scale, first_scale);
    for (int k = 0; k < options.iterations; ++k)
    {
      Parameters gradient;
      const double residual = accumulate(q, options, scale, hessian, gradient);
      const Parameters delta = Symmetric_factorization(hessian).solved(gradient);
      const double length = delta.head<2>().norm() + delta.segment<2>(6).norm();
      q += length > longest_step ? Parameters(longest_step / length * delta) : delta;
      if (length < settled_step && scale == least_scale)
        break;
      // the outliers leave gradually, or the first guess would decide alone; where there are none, all is settled
      scale = residual < least_scale ? least_scale : (std::max)(least_scale, shrinking * scale);
    }
    const double bend_x = start.bend.dot(normal), bend_y = start.bend.dot(binormal);
    crease.curve.point = start.point + q[0] * normal + q[1] * binormal;
    crease.curve.tangent = (start.tangent + q[2] * normal + q[3] * binormal).normalized();
    crease.curve.bend = (bend_x + q[4]) * normal + (bend_y + q[5]) * binormal;
    crease.curve.bend -= crease.curve.bend.dot(crease.curve.tangent) * crease.curve.tangent;
    for (int k = 0; k < 2; ++k)
    {
      Vector& strip = crease.strips[k];
      strip = std::cos(q[6 + k]) * normal + std::sin(q[6 + k]) * binormal;
      strip = (strip - strip.dot(crease.curve.tangent) * crease.curve.tangent).normalized();
    }
    crease.fold = CGAL_PI - std::acos((std::min)(1., (std::max)(-1., std::cos(q[6] - q[7]))));
    measure(q, options, crease, hessian);
    return crease;
  }

  // Fits with balls of several radii and keeps the crease that is known best. With a previous crease, balls that lie
  // behind are tried as well: they do not see what comes beyond a corner.
  Crease fit_with_best_radius(const Local_curve& start, const Crease_fit_options& options,
                              const Crease* previous = nullptr)
  {
    Crease best;
    best.deviation = unknown_deviation;
    // returns whether other balls may show more: where the surface is as it should be, they have less data only
    const auto try_ball = [&](double factor, double shift) {
      Crease_fit_options scaled = options;
      scaled.radius *= factor;
      const Crease crease = fit(start, start.point - shift * scaled.radius * start.tangent, scaled, previous);
      if (crease.deviation < best.deviation)
        best = crease;
      return crease.residual > residual_inflation * options.surface_noise;
    };
    // a corner ahead does not show in the residual where the points err more
    const bool tells_of_corners = options.surface_noise < least_noise_to_hide_corners;
    for (double factor : radius_factors)
    {
      const bool may_show_more = try_ball(factor, 0.);
      if (previous && factor > least_factor_to_shift && (may_show_more || !tells_of_corners))
        try_ball(factor, shift_back);
      if (!may_show_more)
        break;
    }
    return best;
  }

private:
  void collect(const Local_curve& start, const Vector& center, const Vector& normal, const Vector& binormal,
               double radius)
  {
    const double bend_x = start.bend.dot(normal), bend_y = start.bend.dot(binormal);
    m_band.search.query(center, radius, m_ball);
    m_samples.clear();
    for (std::size_t i : m_ball)
    {
      const Vector offset = m_band.points[i] - start.point;
      const double s = offset.dot(start.tangent);
      const double ratio = (m_band.points[i] - center).squaredNorm() / (radius * radius);
      m_samples.push_back({s, offset.dot(normal) - 0.5 * s * s * bend_x, offset.dot(binormal) - 0.5 * s * s * bend_y,
                           m_band.distances[i], (1. - ratio) * (1. - ratio)});
    }
  }

  // the pair of directions whose half-lines pass closest to the points
  void find_directions(double& first, double& second)
  {
    static const std::vector<std::pair<double, double>> directions = [] {
      std::vector<std::pair<double, double>> result;
      for (int k = 0; k < number_of_directions; ++k)
        result.emplace_back(std::cos(2. * CGAL_PI * k / number_of_directions),
                            std::sin(2. * CGAL_PI * k / number_of_directions));
      return result;
    }();
    // four sums at once, so that the compiler may use vector instructions; the samples are filled up with zeros
    static constexpr std::size_t lanes = 4;
    const std::size_t stride = (m_samples.size() + lanes - 1) / lanes * lanes;
    m_losses.assign(stride * number_of_directions, 0.);
    for (int k = 0; k < number_of_directions; ++k)
      for (std::size_t i = 0; i < m_samples.size(); ++i)
      {
        const Sample& p = m_samples[i];
        const double along = p.x * directions[k].first + p.y * directions[k].second;
        const double across = p.y * directions[k].first - p.x * directions[k].second;
        const double square = along > 0. ? across * across : p.x * p.x + p.y * p.y;
        m_losses[k * stride + i] = p.weight * (std::min)(1., square / (guess_reach * guess_reach));
      }
    double best = (std::numeric_limits<double>::infinity)();
    for (int j = 0; j < number_of_directions; ++j)
      for (int k = j + 1; k < number_of_directions; ++k)
      {
        const double *a = m_losses.data() + j * stride, *b = m_losses.data() + k * stride;
        double sums[lanes] = {};
        for (std::size_t i = 0; i < stride; i += lanes)
          for (std::size_t l = 0; l < lanes; ++l)
            sums[l] += (std::min)(a[i + l], b[i + l]);
        const double sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
        if (sum < best)
        {
          best = sum;
          first = 2. * CGAL_PI * j / number_of_directions;
          second = 2. * CGAL_PI * k / number_of_directions;
        }
      }
  }

  struct Offset
  {
    double x, y, along, across;
    double cosine, sine; // of the strip's direction there
    int strip;
    bool is_valid;
  };

  // a strip's direction, which turns along the curve
  struct Turning_direction
  {
    double cosine, sine, twist;

    Turning_direction(double angle, double twist) : cosine(std::cos(angle)), sine(std::sin(angle)), twist(twist) {}

    void at(double s, double& c, double& v) const
    {
      const double a = s * twist, aa = a * a;
      double sine_of_turn, cosine_of_turn;
      if (std::abs(a) > 0.5)
      {
        sine_of_turn = std::sin(a);
        cosine_of_turn = std::cos(a);
      }
      else
      {
        // most angles are small, so that a few terms of the series are as good as the functions themselves
        static constexpr double s3 = 1. / 6., s5 = s3 / 20., s7 = s5 / 42., s9 = s7 / 72., s11 = s9 / 110.;
        static constexpr double c2 = 1. / 2., c4 = c2 / 12., c6 = c4 / 30., c8 = c6 / 56., c10 = c8 / 90.,
                                c12 = c10 / 132.;
        sine_of_turn = a * (1. - aa * (s3 - aa * (s5 - aa * (s7 - aa * (s9 - aa * s11)))));
        cosine_of_turn = 1. - aa * (c2 - aa * (c4 - aa * (c6 - aa * (c8 - aa * (c10 - aa * c12)))));
      }
      c = cosine * cosine_of_turn - sine * sine_of_turn;
      v = sine * cosine_of_turn + cosine * sine_of_turn;
    }
  };

  // the directions of both strips for some parameters
  struct Strips
  {
    Turning_direction directions[2];
    explicit Strips(const Parameters& q) : directions{{q[6], q[10]}, {q[7], q[11]}} {}
  };

  // the strip that the sample is nearest to, and where it is on it
  static Offset locate(const Parameters& q, const Strips& strips, const Sample& p)
  {
    Offset best;
    best.x = p.x - q[0] - p.s * q[2] - 0.5 * p.s * p.s * q[4];
    best.y = p.y - q[1] - p.s * q[3] - 0.5 * p.s * p.s * q[5];
    best.is_valid = false;
    for (int k = 0; k < 2; ++k)
    {
      double c, s;
      strips.directions[k].at(p.s, c, s);
      const double along = best.x * c + best.y * s;
      const double across = best.y * c - best.x * s - 0.5 * q[8 + k] * along * along;
      if (along > 0. && (!best.is_valid || std::abs(across) < std::abs(best.across)))
      {
        best.along = along;
        best.across = across;
        best.cosine = c;
        best.sine = s;
        best.strip = k;
        best.is_valid = true;
      }
    }
    return best;
  }

  static double robust_weight(double ratio) { return 1. / ((1. + ratio * ratio) * (1. + ratio * ratio)); }

  // sums for the normal equations
  struct Normal_sums
  {
    Section_sums apex;
    struct Strip
    {
      double angle_angle[3] = {}, angle_curvature[2] = {}, curvature_curvature = 0.;
      double x_angle[4] = {}, y_angle[4] = {}, x_curvature[3] = {}, y_curvature[3] = {};
      double angle[2] = {}, curvature = 0.; // right-hand side
    } strips[2];
    double x_bias[3] = {}, y_bias[3] = {}, bias_bias = 0., bias = 0.;

    void add_strip(int i, const double* powers, double by_x, double by_y, double by_angle, double by_curvature,
                   double weight, double e)
    {
      Strip& strip = strips[i];
      const double wa = weight * by_angle, wc = weight * by_curvature;
      for (int k = 0; k < 3; ++k)
        strip.angle_angle[k] += wa * by_angle * powers[k];
      for (int k = 0; k < 2; ++k)
        strip.angle_curvature[k] += wa * by_curvature * powers[k];
      strip.curvature_curvature += wc * by_curvature;
      for (int k = 0; k < 4; ++k)
      {
        strip.x_angle[k] += wa * by_x * powers[k];
        strip.y_angle[k] += wa * by_y * powers[k];
      }
      for (int k = 0; k < 3; ++k)
      {
        strip.x_curvature[k] += wc * by_x * powers[k];
        strip.y_curvature[k] += wc * by_y * powers[k];
      }
      for (int k = 0; k < 2; ++k)
        strip.angle[k] -= wa * e * powers[k];
      strip.curvature -= wc * e;
    }

    void add_bias(const double* powers, double by_x, double by_y, double weight, double e)
    {
      for (int k = 0; k < 3; ++k)
      {
        x_bias[k] -= weight * by_x * powers[k];
        y_bias[k] -= weight * by_y * powers[k];
      }
      bias_bias += weight;
      bias += weight * e;
    }

    void assemble(Matrix& hessian, Parameters& gradient) const
    {
      static constexpr double factors[3] = {1., 1., 0.5};
      hessian.setZero();
      apex.assemble(hessian, gradient);
      for (int j = 0; j < 3; ++j)
      {
        hessian(2 * j, 12) = factors[j] * x_bias[j];
        hessian(2 * j + 1, 12) = factors[j] * y_bias[j];
        for (int i = 0; i < 2; ++i)
        {
          const Strip& strip = strips[i];
          hessian(2 * j, 6 + i) = factors[j] * strip.x_angle[j];
          hessian(2 * j + 1, 6 + i) = factors[j] * strip.y_angle[j];
          hessian(2 * j, 8 + i) = factors[j] * strip.x_curvature[j];
          hessian(2 * j + 1, 8 + i) = factors[j] * strip.y_curvature[j];
          hessian(2 * j, 10 + i) = factors[j] * strip.x_angle[j + 1];
          hessian(2 * j + 1, 10 + i) = factors[j] * strip.y_angle[j + 1];
        }
      }
      for (int i = 0; i < 2; ++i)
      {
        const Strip& strip = strips[i];
        hessian(6 + i, 6 + i) = strip.angle_angle[0];
        hessian(6 + i, 10 + i) = strip.angle_angle[1];
        hessian(10 + i, 10 + i) = strip.angle_angle[2];
        hessian(6 + i, 8 + i) = strip.angle_curvature[0];
        hessian(8 + i, 10 + i) = strip.angle_curvature[1];
        hessian(8 + i, 8 + i) = strip.curvature_curvature;
        gradient[6 + i] = strip.angle[0];
        gradient[10 + i] = strip.angle[1];
        gradient[8 + i] = strip.curvature;
      }
      hessian(12, 12) = bias_bias;
      gradient[12] = bias;
    }
  };

  // returns how far all points are from the strips, root mean square
  double accumulate(const Parameters& q, const Crease_fit_options& options, double scale, Matrix& hessian,
                    Parameters& gradient) const
  {
    double squares = 0., total = 0.;
    Normal_sums sums;
    const Strips strips(q);
    const double surface_weight = 1. / (options.surface_noise * options.surface_noise);
    const double field_weight = 1. / (options.field_noise * options.field_noise);
    const double per_scale = 1. / scale,
                 per_field_scale = 1. / (std::max)(exceeded_by_one_in_80 * options.field_noise, scale);
    for (const Sample& p : m_samples)
    {
      const Offset offset = locate(q, strips, p);
      const double square = p.s * p.s;
      const double powers[5] = {1., p.s, square, square * p.s, square * square};
      if (offset.is_valid)
      {
        const double curvature = q[8 + offset.strip];
        // derivatives of the residual `across` by the apex, and by the angle
        const double by_x = offset.sine + curvature * offset.along * offset.cosine,
                     by_y = curvature * offset.along * offset.sine - offset.cosine;
        const double by_angle = -offset.along * (1. + curvature * offset.across);
        const double weight = p.weight * surface_weight * robust_weight(offset.across * per_scale);
        sums.apex.add(powers, by_x, by_y, weight, offset.across);
        sums.add_strip(offset.strip, powers, by_x, by_y, by_angle, -0.5 * offset.along * offset.along, weight,
                       offset.across);
      }
      const double distance = std::sqrt(offset.x * offset.x + offset.y * offset.y);
      const double miss = offset.is_valid ? offset.across : distance;
      squares += p.weight * miss * miss;
      total += p.weight;
      if (distance > on_curve)
      {
        const double per_distance = 1. / (std::max)(distance, near_curve);
        const double e = p.distance - q[12] - distance;
        const double weight =
          p.weight * field_weight * robust_weight(e * per_field_scale) / growth_of_variance(p.distance);
        sums.apex.add(powers, offset.x * per_distance, offset.y * per_distance, weight, e);
        sums.add_bias(powers, offset.x * per_distance, offset.y * per_distance, weight, e);
      }
    }
    sums.assemble(hessian, gradient);
    static constexpr double b = bend_deviation, c = strip_deviation, t = twist_deviation;
    static constexpr double deviations[size] = {0., 0., 0., 0., b, b, 0., 0., c, c, t, t, 0.};
    for (int k = 0; k < size; ++k)
    {
      const double deviation = k == 12 ? options.field_noise : deviations[k];
      const double information =
        deviation > 0. ? 1. / (deviation * deviation) : least_information + relative_information * hessian(k, k);
      hessian(k, k) += information;
      if (deviation > 0.)
        gradient[k] -= information * q[k];
    }
    hessian = hessian.selfadjointView<Eigen::Upper>();
    return total > 0. ? std::sqrt(squares / total) : 0.;
  }

  void measure(const Parameters& q, const Crease_fit_options& options, Crease& crease, const Matrix& hessian) const
  {
    double squares = 0., total = 0.;
    const Strips strips(q);
    for (const Sample& p : m_samples)
    {
      const Offset offset = locate(q, strips, p);
      const double distance = std::sqrt(offset.x * offset.x + offset.y * offset.y);
      if (distance > residual_radius || std::abs(p.s) > residual_length)
        continue;
      const double e = offset.is_valid ? offset.across : distance;
      squares += p.weight * (std::min)(worst_miss * worst_miss, e * e);
      total += p.weight;
    }
    crease.residual = total > 0. ? std::sqrt(squares / total) : 1.;
    // the covariance of the apex, and of the strips' directions
    static constexpr int wanted[4] = {0, 1, 6, 7};
    const Symmetric_factorization factorization(hessian);
    Eigen::Matrix<double, size, 4> covariance = Eigen::Matrix<double, size, 4>::Zero();
    for (int k = 0; k < 4; ++k)
    {
      covariance(wanted[k], k) = 1.;
      factorization.solve(covariance.col(k).data());
    }
    // the larger eigenvalue of the apex's part
    const double middle = 0.5 * (covariance(0, 0) + covariance(1, 1));
    const double largest = middle + std::hypot(0.5 * (covariance(0, 0) - covariance(1, 1)), covariance(0, 1));
    const double inflation = (std::max)(1., crease.residual / options.surface_noise);
    crease.deviation = inflation * std::sqrt((std::max)(0., largest));
    crease.fold_deviation =
      inflation * std::sqrt((std::max)(0., covariance(6, 2) + covariance(7, 3) - 2. * covariance(6, 3)));
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CREASE_FIT_H
