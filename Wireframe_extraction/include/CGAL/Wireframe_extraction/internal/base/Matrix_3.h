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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_MATRIX_3_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_MATRIX_3_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A matrix of three rows and columns, for the same reason as Vector: Eigen makes a type of each expression, and dozens
// of functions for each type. What stands here gives the same to the last bit, for which sums of three are added in
// Eigen's order.
class Matrix_3
{
  std::array<double, 9> m_entries; // column after column

public:
  Matrix_3() = default; // of any entries

  static Matrix_3 Zero()
  {
    Matrix_3 result;
    result.m_entries.fill(0.);
    return result;
  }

  static Matrix_3 Identity()
  {
    Matrix_3 result = Zero();
    result(0, 0) = result(1, 1) = result(2, 2) = 1.;
    return result;
  }

  // of all products of an entry of a and one of b, a b^T
  static Matrix_3 outer(const Vector& a, const Vector& b)
  {
    Matrix_3 result;
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        result(i, j) = a[i] * b[j];
    return result;
  }

  static constexpr int rows() { return 3; }

  double& operator()(int i, int j) { return m_entries[3 * j + i]; }
  double operator()(int i, int j) const { return m_entries[3 * j + i]; }
  const double* data() const { return m_entries.data(); }
  double* column_data(int j) { return m_entries.data() + 3 * j; }

  Vector column(int j) const { return Vector(m_entries.data() + 3 * j); }

  void set_row(int i, const Vector& row)
  {
    for (int j = 0; j < 3; ++j)
      (*this)(i, j) = row[j];
  }

  double trace() const { return sum((*this)(0, 0), (*this)(1, 1), (*this)(2, 2)); }

  Matrix_3 transposed() const
  {
    Matrix_3 result;
    for (int i = 0; i < 3; ++i)
      result.set_row(i, column(i));
    return result;
  }

  Matrix_3& operator+=(const Matrix_3& other)
  {
    for (int k = 0; k < 9; ++k)
      m_entries[k] += other.m_entries[k];
    return *this;
  }

  Matrix_3& operator-=(const Matrix_3& other)
  {
    for (int k = 0; k < 9; ++k)
      m_entries[k] -= other.m_entries[k];
    return *this;
  }

  Matrix_3& operator*=(double factor)
  {
    for (double& entry : m_entries)
      entry *= factor;
    return *this;
  }

  Matrix_3& operator/=(double divisor)
  {
    for (double& entry : m_entries)
      entry /= divisor;
    return *this;
  }

  friend Matrix_3 operator+(Matrix_3 a, const Matrix_3& b) { return a += b; }
  friend Matrix_3 operator-(Matrix_3 a, const Matrix_3& b) { return a -= b; }
  friend Matrix_3 operator*(double factor, Matrix_3 a) { return a *= factor; }
  friend Matrix_3 operator/(Matrix_3 a, double divisor) { return a /= divisor; }

  Vector operator*(const Vector& v) const { return Vector(row_times(0, v), row_times(1, v), row_times(2, v)); }

  // the transposed matrix times a vector
  Vector transposed_times(const Vector& v) const
  {
    return Vector(column(0).dot(v), column(1).dot(v), column(2).dot(v));
  }

  Matrix_3 operator*(const Matrix_3& other) const
  {
    Matrix_3 result;
    for (int j = 0; j < 3; ++j)
    {
      const Vector product = *this * other.column(j);
      for (int i = 0; i < 3; ++i)
        result(i, j) = product[i];
    }
    return result;
  }

  bool is_finite() const
  {
    for (const double entry : m_entries)
      if (!std::isfinite(entry))
        return false;
    return true;
  }

private:
  static double sum(double a, double b, double c) { return a + (b + c); }

  // Eigen computes the first two rows at the same time, one column after the other, and the third one by itself.
  double row_times(int i, const Vector& v) const
  {
    const double products[3] = {(*this)(i, 0) * v[0], (*this)(i, 1) * v[1], (*this)(i, 2) * v[2]};
    return i < 2 ? products[0] + products[1] + products[2] : sum(products[0], products[1], products[2]);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_MATRIX_3_H
