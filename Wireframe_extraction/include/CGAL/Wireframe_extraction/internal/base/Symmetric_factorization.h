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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SYMMETRIC_FACTORIZATION_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SYMMETRIC_FACTORIZATION_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

#include <array>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The factorization P A P^T = L D L^T of a small symmetric positive semidefinite matrix A, with pivots: P is a
// permutation, L lower triangular with ones on its diagonal, D diagonal. It does what Eigen::LDLT does, but is one
// function for matrices of all sizes, which Eigen instantiates for each (seconds of compile time).
class Symmetric_factorization
{
public:
  static constexpr int most = 13; // rows of the largest matrix

  // `matrix` has `size` rows and columns, one after the other
  Symmetric_factorization(const double* matrix, int size);

  // of a matrix of Eigen
  template <class Matrix>
  explicit Symmetric_factorization(const Matrix& matrix)
    : Symmetric_factorization(matrix.data(), static_cast<int>(matrix.rows()))
  {}

  int size() const { return m_size; }
  double pivot(int i) const { return m_lower[at(i, i)]; } // of D
  // of L
  double lower(int i, int k) const { return i == k ? 1. : i > k ? m_lower[at(i, k)] : 0.; }
  int row_of_matrix(int i) const { return m_order[i]; } // which row of A became row i

  // replaces x by the solution of A y = x; what A says nothing of becomes 0
  void solve(double* x) const;

  // the solution of A y = x, for a vector of Eigen
  template <class Column>
  Column solved(Column x) const
  {
    solve(x.data());
    return x;
  }

  // replaces x by L^-1 P x
  void solve_lower(double* x) const;

private:
  int m_size;
  std::array<int, most> m_order;
  std::array<double, most * most> m_lower; // row by row; D on its diagonal

  int at(int i, int k) const { return i * m_size + k; }
  void exchange(int k, int pivot);
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SYMMETRIC_FACTORIZATION_H
