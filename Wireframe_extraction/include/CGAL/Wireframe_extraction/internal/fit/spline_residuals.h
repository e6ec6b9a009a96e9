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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_SPLINE_RESIDUALS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_SPLINE_RESIDUALS_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/fit/Cauchy_factor.h>
#include <CGAL/Wireframe_extraction/internal/fit/ceres_support.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

inline void set_multiple_of_identity(double* jacobian, double factor)
{
  for (int k = 0; k < 9; ++k)
    jacobian[k] = k % 4 == 0 ? factor : 0.;
}

// The distances of points to the places of their feet on one span of a spline against those of the field, made robust
// one by one. Places and weights are fixed; the derivatives are by the four control points of the span. There are 12 of
// these, so that 13 residuals are as good as any number of them: with the Cholesky factor R of J^T J as Jacobian, y
// with R^T y = J^T e, and the length of what is left of e, the sum of squares, its gradient and the normal equations
// are those of all points, and the solver need not handle them one by one. They are prepared for all spans at the same
// time.
class Span_residual : public ceres::CostFunction
{
  struct Sample
  {
    Vector point;
    double distance, weight;
    std::array<double, 4> basis;
  };

  static constexpr int size = 12;
  typedef Eigen::Matrix<double, size, size> Matrix;
  typedef Eigen::Matrix<double, size, 1> Column;

  static constexpr double least_distance = 1e-12; // in r: closer points have no direction
  static constexpr double least_pivot = 1e-14;    // of the largest one: what is below is rounding error

  std::vector<Sample> m_samples;
  double m_scale;
  std::array<const double*, 4> m_controls{};
  std::array<double, size + 1> m_residuals{};
  Matrix m_jacobian = Matrix::Zero(); // the last residual has none

public:
  // `scale` is that of Cauchy's loss, or 0 for plain squares
  explicit Span_residual(double scale) : m_scale(scale)
  {
    mutable_parameter_block_sizes()->assign(4, 3);
    set_num_residuals(size + 1);
  }

  void set_controls(const std::array<double*, 4>& controls)
  {
    std::copy(controls.begin(), controls.end(), m_controls.begin());
  }

  void add(const Vector& point, double distance, double weight, const double* basis)
  {
    m_samples.push_back({point, distance, weight, {{basis[0], basis[1], basis[2], basis[3]}}});
  }

  // for the present control points
  void prepare(bool with_jacobian)
  {
    double squares = 0.;
    Normal_sums sums;
    for (const Sample& sample : m_samples)
    {
      Vector offset = sample.point;
      for (int j = 0; j < 4; ++j)
        offset -= sample.basis[j] * Vector(m_controls[j]);
      const double distance = offset.norm(), e = sample.weight * (sample.distance - distance);
      const Cauchy_factor factor = m_scale > 0. ? Cauchy_factor(e * e, m_scale * m_scale) : Cauchy_factor();
      const double residual = factor.value * e;
      squares += residual * residual;
      if (with_jacobian && distance > least_distance)
      {
        const double by_distance = sample.weight * (factor.value + 2. * factor.derivative * e * e);
        sums.add(sample.basis, offset * (by_distance / distance), residual);
      }
    }
    m_residuals.fill(0.);
    if (with_jacobian)
      squares -= reduce(sums);
    m_residuals[size] = std::sqrt((std::max)(0., squares));
  }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override
  {
    std::copy(m_residuals.begin(), m_residuals.end(), residuals);
    for (int j = 0; jacobians && j < 4; ++j)
    {
      if (!jacobians[j])
        continue;
      Eigen::Map<Eigen::Matrix<double, size + 1, 3, Eigen::RowMajor>> jacobian(jacobians[j]);
      jacobian << m_jacobian.middleCols<3>(3 * j), Eigen::RowVector3d::Zero();
    }
    return true;
  }

private:
  // for the normal equations: every derivative is a basis function times a direction
  struct Normal_sums
  {
    double blocks[10][6] = {}; // of pairs of control points
    double right[4][3] = {};

    void add(const std::array<double, 4>& basis, const Vector& direction, double residual)
    {
      const double x = direction[0], y = direction[1], z = direction[2];
      const double products[6] = {x * x, x * y, x * z, y * y, y * z, z * z};
      for (int j = 0, pair = 0; j < 4; ++j)
        for (int k = j; k < 4; ++k, ++pair)
          for (int i = 0; i < 6; ++i)
            blocks[pair][i] += basis[j] * basis[k] * products[i];
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i)
          right[j][i] += basis[j] * residual * direction[i];
    }

    void assemble(Matrix& matrix, Column& column) const
    {
      static constexpr int of[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
      for (int j = 0, pair = 0; j < 4; ++j)
        for (int k = j; k < 4; ++k, ++pair)
          for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b)
              matrix(3 * j + a, 3 * k + b) = matrix(3 * k + b, 3 * j + a) = blocks[pair][of[a][b]];
      for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i)
          column[3 * j + i] = right[j][i];
    }
  };

  // sets y and R, and returns the square of y
  double reduce(const Normal_sums& sums)
  {
    Matrix matrix;
    Column column;
    sums.assemble(matrix, column);
    const Symmetric_factorization factorization(matrix);
    double largest = factorization.pivot(0);
    for (int i = 1; i < size; ++i)
      largest = (std::max)(largest, factorization.pivot(i));
    const double least = least_pivot * largest;
    Column reduced = column;
    factorization.solve_lower(reduced.data());
    double square = 0.;
    for (int i = 0; i < size; ++i)
    {
      // what the points say nothing of has no derivative either
      const double root = factorization.pivot(i) > least ? std::sqrt(factorization.pivot(i)) : 0.;
      m_residuals[i] = root > 0. ? reduced[i] / root : 0.;
      for (int k = 0; k < size; ++k) // root times the row of L^T P
        m_jacobian(i, factorization.row_of_matrix(k)) = root * factorization.lower(k, i);
      square += m_residuals[i] * m_residuals[i];
    }
    return square;
  }
};

// Prepares the residuals of all spans when the solver has moved the control points. After cancelling they stay as they
// are: the solver ends soon.
class Span_preparer : public ceres::EvaluationCallback
{
  static constexpr std::size_t at_once = 4; // a span takes some microseconds

  std::vector<Span_residual*> m_spans;
  Progress& m_progress;

public:
  explicit Span_preparer(Progress& progress) : m_progress(progress) {}
  void add(Span_residual* span) { m_spans.push_back(span); }

  void PrepareForEvaluation(bool evaluate_jacobians, bool) override
  {
    for_each_piece(
      m_spans.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end && !m_progress.is_cancelled(); ++k)
          m_spans[k]->prepare(evaluate_jacobians);
      },
      at_once);
  }
};

// a linear combination of the four control points of a span that shall be small
class Roughness_residual : public ceres::SizedCostFunction<3, 3, 3, 3, 3>
{
  std::array<double, 4> m_factors;

public:
  explicit Roughness_residual(const std::array<double, 4>& factors) : m_factors(factors) {}

  bool Evaluate(double const* const* controls, double* residuals, double** jacobians) const override
  {
    for (int k = 0; k < 3; ++k)
    {
      residuals[k] = 0.;
      for (int j = 0; j < 4; ++j)
        residuals[k] += m_factors[j] * controls[j][k];
    }
    if (jacobians)
      for (int j = 0; j < 4; ++j)
        if (jacobians[j])
          set_multiple_of_identity(jacobians[j], m_factors[j]);
    return true;
  }
};

// keeps a vertex near its place where nothing else holds it
class Anchor_residual : public ceres::SizedCostFunction<3, 3>
{
  Vector m_place;
  double m_weight;

public:
  Anchor_residual(const Vector& place, double weight) : m_place(place), m_weight(weight) {}

  bool Evaluate(double const* const* position, double* residuals, double** jacobians) const override
  {
    for (int k = 0; k < 3; ++k)
      residuals[k] = m_weight * (position[0][k] - m_place[k]);
    if (jacobians && jacobians[0])
      set_multiple_of_identity(jacobians[0], m_weight);
    return true;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_SPLINE_RESIDUALS_H
