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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CUBIC_SPLINE_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CUBIC_SPLINE_IMPL_H

#include <CGAL/Wireframe_extraction/internal/fit/Cubic_spline.h>

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE void Cubic_spline::interpolate(const std::vector<double>& parameters,
                                                                const std::vector<Vector>& positions)
{
  const std::size_t n = m_points.size();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(n, 3);
  const auto add = [&](const Basis& b, double weight, const Vector& p) {
    for (std::size_t j = 0; j < 4; ++j)
    {
      right.row(b.controls[j]) += weight * b.values[j] * p.transpose();
      for (std::size_t k = 0; k < 4; ++k)
        entries.emplace_back(b.controls[j], b.controls[k], weight * b.values[j] * b.values[k]);
    }
  };
  for (std::size_t i = 0; i < parameters.size(); ++i)
    add(basis(parameters[i]), 1., positions[i]);
  if (!m_is_periodic)
  {
    add(basis(front()), end_weight, positions.front());
    add(basis(back()), end_weight, positions.back());
  }
  // a control polygon without bends where there is no data
  for (std::size_t i = 0; i + 2 < n; ++i)
  {
    const double c[3] = {1., -2., 1.};
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        entries.emplace_back(i + j, i + k, bend_weight * c[j] * c[k]);
  }
  for (std::size_t i = 0; i < n; ++i)
    entries.emplace_back(i, i, regularization);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::MatrixX3d solution = solver.solve(right);
  for (std::size_t i = 0; i < n; ++i)
    m_points[i] = solution.row(i).transpose();
  if (!m_is_periodic)
  {
    m_points.front() = positions.front();
    m_points.back() = positions.back();
  }
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CUBIC_SPLINE_IMPL_H
