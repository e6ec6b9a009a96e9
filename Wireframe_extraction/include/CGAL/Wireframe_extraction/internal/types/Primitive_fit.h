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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_stations.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_curve.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Consecutive stations of a curve; those of a closed one may go on past its end.
class Station_range
{
  const std::vector<Station>* m_stations;
  std::size_t m_first, m_size;

public:
  Station_range(const std::vector<Station>& stations, std::size_t first, std::size_t size)
    : m_stations(&stations), m_first(first), m_size(size)
  {}

  std::size_t size() const { return m_size; }
  const Station& operator[](std::size_t i) const { return (*m_stations)[(m_first + i) % m_stations->size()]; }
};

// How well a curve explains stations. Squares of residuals are in units of the variance of a station.
class Misfit
{
  double m_capped = 0., m_robust = 0.;
  std::size_t m_size = 0;

public:
  static constexpr double cap = 16.; // what is farther off than four standard deviations is an outlier
  // Neighboring stations share errors of the field: about half as many are independent.
  static constexpr double share_of_independent = 0.5;

  void add(double square)
  {
    m_capped += (std::min)(square, cap);
    m_robust += cap * std::log1p(square / cap);
    ++m_size;
  }

  double capped() const { return m_capped; }
  double robust() const { return m_robust; } // what fits minimize

  // the probability that the field errs that much or more if the curve is the true one
  double probability(int number_of_parameters) const
  {
    const double k = share_of_independent * (2. * double(m_size) - double(number_of_parameters));
    return k > 0. ? chi_square_tail(share_of_independent * m_capped, k) : 0.;
  }

  static double weight(double square) { return 1. / (1. + square / cap); }

private:
  // The probability of a larger value of the chi-square distribution with k degrees of freedom, by the approximation of
  // Wilson and Hilferty (1931). Boost's function is not usable: where rounding modes are respected, as CGAL asks
  // compilers to, it returns values that are no probabilities.
  static double chi_square_tail(double x, double k)
  {
    const double variance = 2. / (9. * k);
    return 0.5 * std::erfc((std::cbrt(x / k) - 1. + variance) / std::sqrt(2. * variance));
  }
};

// Fits a line, a circle or an ellipse to stations, by robust least squares over its parameters.
class Primitive_fit
{
  // Of dynamic size, though bounded: unrolled loops over eight parameters take long to compile, and gain nothing here.
  static constexpr int most = Primitive_curve::most_parameters;
  typedef Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1> Parameters;
  typedef std::array<Vector, most> Foot_jacobian;

  // in the plane of a circle or an ellipse
  struct Plane_point
  {
    double x, y;
  };

  static constexpr double least_radius = 0.5 * Curve_stations::spacing;

  // The numbers below are those of a solver: what they leave of the minimum is far below the deviations of stations.
  static constexpr std::size_t few = 48;         // stations, which the first rounds take where there are many more
  static constexpr std::size_t many_per_few = 3; // below that, taking few of them gains nothing
  static constexpr double hopeless_share = 1e-6; // of the least probability: then the other stations cannot help
  static constexpr int most_rounds = 30;
  static constexpr double first_damping = 1e-6, least_damping = 1e-9, most_damping = 1e6, damping_increase = 10.,
                          damping_decrease = 0.1;
  static constexpr double relative_gain = 1e-6,
                          least_gain = 1e-9;        // in units of a squared deviation: the minimum is reached
  static constexpr double rounding = 1e-12;         // relative to the trace of a matrix, which may be singular
  static constexpr double negligible_extent = 1e-9; // r: then all stations are in one place

public:
  typedef Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, Primitive_curve::most_parameters,
                        Primitive_curve::most_parameters>
    Covariance;

  Primitive_curve curve;
  Misfit misfit;
  bool is_valid = false;

  // It is not valid if some of many stations already show that the probability is below the least one by far.
  Primitive_fit(Primitive_kind kind, const Station_range& stations, double least_probability = 0.)
  {
    curve.kind = kind;
    if (2 * stations.size() <= std::size_t(curve.number_of_parameters()) || !initialize(stations))
      return;
    is_valid = minimize(stations, least_probability) && curve.is_finite() && is_resolved();
  }

  static double square(const Primitive_curve& curve, const Station& station)
  {
    const Vector residual = curve.foot(station.position) - station.position;
    return residual.dot(station.information * residual);
  }

  // of every `stride`-th station
  static Misfit misfit_of(const Primitive_curve& curve, const Station_range& stations, std::size_t stride = 1)
  {
    Misfit result;
    for (std::size_t i = 0; i < stations.size(); i += stride)
      result.add(square(curve, stations[i]));
    return result;
  }

  // of the steps that Primitive_curve::moved() takes
  Covariance covariance(const Station_range& stations) const
  {
    const int n = curve.number_of_parameters();
    Covariance matrix;
    Parameters gradient;
    linearize(stations, 1, matrix, gradient);
    const Symmetric_factorization factorization(matrix);
    Covariance result = Covariance::Identity(n, n);
    for (int i = 0; i < n; ++i)
      factorization.solve(result.col(i).data());
    return result;
  }

private:
  // whether the curve bends so little that stations can show it
  bool is_resolved() const
  {
    return curve.kind == Primitive_kind::LINE
      || curve.minor_radius * curve.minor_radius > least_radius * curve.major_radius;
  }

  bool initialize(const Station_range& stations)
  {
    Vector mean = Vector::Zero();
    for (std::size_t i = 0; i < stations.size(); ++i)
      mean += stations[i].position / double(stations.size());
    Matrix_3 moments = Matrix_3::Zero();
    for (std::size_t i = 0; i < stations.size(); ++i)
      moments += Matrix_3::outer(stations[i].position - mean, stations[i].position - mean);
    const Principal_axes principal = principal_axes(moments);
    curve.center = mean;
    if (curve.kind == Primitive_kind::LINE)
    {
      curve.axis = principal.axes[2];
      return true;
    }
    curve.axis = principal.axes[0];
    curve.major = principal.axes[2];
    const double scale = std::sqrt(principal.values[2] / double(stations.size()));
    if (!(scale > negligible_extent))
      return false;
    std::vector<Plane_point> plane;
    for (std::size_t i = 0; i < stations.size(); ++i)
    {
      const Vector offset = (stations[i].position - mean) / scale;
      plane.push_back({offset.dot(curve.major), offset.dot(curve.minor())});
    }
    return curve.kind == Primitive_kind::CIRCLE ? start_circle(plane, scale) : start_ellipse(plane, scale);
  }

  // the algebraic circle of Kasa
  bool start_circle(const std::vector<Plane_point>& points, double scale)
  {
    Matrix_3 matrix = Matrix_3::Zero();
    Vector right_side = Vector::Zero();
    for (const Plane_point& p : points)
    {
      const Vector row(p.x, p.y, 1.);
      matrix += Matrix_3::outer(row, row);
      right_side += (p.x * p.x + p.y * p.y) * row;
    }
    const Vector x = Symmetric_factorization(matrix).solved(right_side);
    const Plane_point center{0.5 * x[0], 0.5 * x[1]};
    const double square = x[2] + (center.x * center.x + center.y * center.y);
    if (!(square > 0.) || !std::isfinite(square))
      return false;
    place(center, scale);
    curve.major_radius = curve.minor_radius = scale * std::sqrt(square);
    return true;
  }

  // the direct ellipse of Fitzgibbon, Pilu and Fisher (1999), by the stable elimination of Halir and Flusser (1998)
  bool start_ellipse(const std::vector<Plane_point>& points, double scale)
  {
    Matrix_3 s1 = Matrix_3::Zero(), s2 = s1, s3 = s1;
    for (const Plane_point& p : points)
    {
      const Vector quadratic(p.x * p.x, p.x * p.y, p.y * p.y), linear(p.x, p.y, 1.);
      s1 += Matrix_3::outer(quadratic, quadratic);
      s2 += Matrix_3::outer(quadratic, linear);
      s3 += Matrix_3::outer(linear, linear);
    }
    Matrix_3 t = -1. * s2.transposed();
    const Symmetric_factorization factorization(s3);
    for (int i = 0; i < 3; ++i)
      factorization.solve(t.column_data(i));
    // The form q of an ellipse has 4 a c - b^2 > 0. Among those with the value 1, the best one belongs to the only
    // positive eigenvalue of this form relative to the squared algebraic residuals, which exact points make singular.
    const Matrix_3 m = s1 + s2 * t + rounding * s1.trace() * Matrix_3::Identity();
    Matrix_3 constraint = Matrix_3::Zero();
    constraint(0, 2) = constraint(2, 0) = 2.;
    constraint(1, 1) = -1.;
    const Principal_axes of_residuals = principal_axes(m);
    if (!t.is_finite() || !(of_residuals.values[0] > 0.))
      return false;
    Matrix_3 inverse; // of a square root of m
    for (int i = 0; i < 3; ++i)
      inverse.set_row(i, of_residuals.axes[i] / std::sqrt(of_residuals.values[i]));
    const Principal_axes principal = principal_axes(inverse * constraint * inverse.transposed());
    const Vector quadratic = inverse.transposed_times(principal.axes[2]).normalized();
    return set_ellipse(quadratic, t * quadratic, scale);
  }

  // from a x^2 + b x y + c y^2 + d x + e y + f = 0
  bool set_ellipse(const Vector& quadratic, const Vector& linear, double scale)
  {
    const double a = quadratic[0], b = 0.5 * quadratic[1], c = quadratic[2], determinant = a * c - b * b;
    const Plane_point center{(b * linear[1] - c * linear[0]) / (2. * determinant),
                             (b * linear[0] - a * linear[1]) / (2. * determinant)};
    const double level = -(linear[2] + 0.5 * (linear[0] * center.x + linear[1] * center.y));
    const double mean = 0.5 * (a + c), difference = std::hypot(0.5 * (a - c), b);
    const double one = level / (mean - difference), two = level / (mean + difference); // squares of the radii
    if (!(determinant > 0.) || !(one > 0.) || !(two > 0.) || !std::isfinite(one) || !std::isfinite(two))
      return false;
    place(center, scale);
    // the form is least along the major axis
    const bool is_positive = mean > 0.;
    const double angle = 0.5 * std::atan2(b, 0.5 * (a - c)) + (is_positive ? 0.5 * CGAL_PI : 0.);
    curve.major = std::cos(angle) * curve.major + std::sin(angle) * curve.minor();
    curve.major_radius = scale * std::sqrt((std::max)(one, two));
    curve.minor_radius = scale * std::sqrt((std::min)(one, two));
    return true;
  }

  void place(const Plane_point& center, double scale)
  {
    curve.center += scale * (center.x * curve.major + center.y * curve.minor());
  }

  // The first rounds take some of many stations, which are enough to come close.
  bool minimize(const Station_range& stations, double least_probability)
  {
    if (stations.size() > many_per_few * few)
    {
      minimize(stations, stations.size() / few);
      if (misfit.probability(curve.number_of_parameters()) < hopeless_share * least_probability)
        return false;
    }
    minimize(stations, std::size_t(1));
    if (curve.kind == Primitive_kind::ELLIPSE && curve.major_radius < curve.minor_radius)
    {
      curve.major = curve.minor();
      std::swap(curve.major_radius, curve.minor_radius);
    }
    return true;
  }

  // Levenberg and Marquardt over every `stride`-th station
  void minimize(const Station_range& stations, std::size_t stride)
  {
    const int n = curve.number_of_parameters();
    misfit = misfit_of(curve, stations, stride);
    double damping = first_damping;
    for (int round = 0; round < most_rounds; ++round)
    {
      Covariance matrix;
      Parameters gradient;
      linearize(stations, stride, matrix, gradient);
      Covariance damped = matrix;
      for (int i = 0; i < n; ++i)
        damped(i, i) += damping * damped(i, i) + rounding * matrix.trace();
      const Parameters step = -Symmetric_factorization(damped).solved(gradient);
      const Primitive_curve candidate = curve.moved(step.data());
      const Misfit next = candidate.is_finite() ? misfit_of(candidate, stations, stride) : Misfit();
      if (candidate.is_finite() && next.robust() <= misfit.robust())
      {
        const bool is_done = misfit.robust() - next.robust() <= relative_gain * misfit.robust() + least_gain;
        curve = candidate;
        misfit = next;
        damping = (std::max)(+least_damping, damping_decrease * damping);
        if (is_done)
          break;
      }
      else
      {
        damping *= damping_increase;
        if (damping > most_damping)
          break;
      }
    }
  }

  void linearize(const Station_range& stations, std::size_t stride, Covariance& matrix, Parameters& gradient) const
  {
    const int n = curve.number_of_parameters();
    matrix = Covariance::Zero(n, n);
    gradient = Parameters::Zero(n);
    const Foot_derivatives derivatives(curve);
    Foot_jacobian jacobian;
    for (std::size_t k = 0; k < stations.size(); k += stride)
    {
      const Station& station = stations[k];
      const Vector residual = curve.foot(station.position) - station.position;
      const Vector pull = station.information * residual;
      const double weight = Misfit::weight(residual.dot(pull));
      const Matrix_3 information = weight * station.information;
      derivatives.at(station.position, jacobian);
      for (int i = 0; i < n; ++i)
      {
        gradient[i] += weight * jacobian[i].dot(pull);
        const Vector column = information * jacobian[i];
        for (int j = i; j < n; ++j)
          matrix(i, j) += column.dot(jacobian[j]);
      }
    }
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < i; ++j)
        matrix(i, j) = matrix(j, i);
  }

  // Of a curve's feet: central differences for an ellipse.
  class Foot_derivatives
  {
    const Primitive_curve& m_curve;
    std::array<Primitive_curve, most> m_ahead, m_behind;
    static constexpr double h = 1e-5;

  public:
    explicit Foot_derivatives(const Primitive_curve& curve) : m_curve(curve)
    {
      const int n = m_curve.number_of_parameters();
      for (int i = 0; i < n && m_curve.kind == Primitive_kind::ELLIPSE; ++i)
      {
        Parameters step = Parameters::Zero(n);
        step[i] = h;
        m_ahead[i] = m_curve.moved(step.data());
        step[i] = -h;
        m_behind[i] = m_curve.moved(step.data());
      }
    }

    void at(const Vector& p, Foot_jacobian& columns) const
    {
      if (m_curve.kind != Primitive_kind::ELLIPSE)
        m_curve.foot_derivatives(p, columns);
      else
        for (int i = 0; i < m_curve.number_of_parameters(); ++i)
          columns[i] = (m_ahead[i].foot(p) - m_behind[i].foot(p)) / (2. * h);
    }
  };
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_FIT_H
