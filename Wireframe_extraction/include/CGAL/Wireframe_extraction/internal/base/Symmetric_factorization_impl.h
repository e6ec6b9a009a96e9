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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SYMMETRIC_FACTORIZATION_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SYMMETRIC_FACTORIZATION_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE Symmetric_factorization::Symmetric_factorization(const double* matrix, int size)
  : m_size(size)
{
  for (int i = 0; i < size; ++i)
    m_order[i] = i;
  std::copy(matrix, matrix + size * size, m_lower.begin());
  double scaled[most] = {}; // a row of L times D
  for (int k = 0; k < size; ++k)
  {
    int largest = k;
    for (int i = k + 1; i < size; ++i)
      if (std::abs(m_lower[at(i, i)]) > std::abs(m_lower[at(largest, largest)]))
        largest = i;
    exchange(k, largest);
    double& pivot = m_lower[at(k, k)];
    for (int j = 0; j < k; ++j)
    {
      scaled[j] = m_lower[at(j, j)] * m_lower[at(k, j)];
      pivot -= m_lower[at(k, j)] * scaled[j];
    }
    const bool is_divisor = std::abs(pivot) > (std::numeric_limits<double>::min)();
    for (int i = k + 1; i < size; ++i)
    {
      double& value = m_lower[at(i, k)];
      for (int j = 0; j < k; ++j)
        value -= m_lower[at(i, j)] * scaled[j];
      if (is_divisor)
        value /= pivot;
    }
  }
}

// rows and columns of what is not yet factorized, of which only the lower triangle counts
CGAL_WIREFRAME_EXTRACTION_INLINE void Symmetric_factorization::exchange(int k, int pivot)
{
  if (k == pivot)
    return;
  std::swap(m_order[k], m_order[pivot]);
  for (int j = 0; j < k; ++j)
    std::swap(m_lower[at(k, j)], m_lower[at(pivot, j)]);
  for (int i = pivot + 1; i < m_size; ++i)
    std::swap(m_lower[at(i, k)], m_lower[at(i, pivot)]);
  std::swap(m_lower[at(k, k)], m_lower[at(pivot, pivot)]);
  for (int i = k + 1; i < pivot; ++i)
    std::swap(m_lower[at(i, k)], m_lower[at(pivot, i)]);
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Symmetric_factorization::solve_lower(double* x) const
{
  double y[most];
  for (int i = 0; i < m_size; ++i)
  {
    y[i] = x[m_order[i]];
    for (int j = 0; j < i; ++j)
      y[i] -= m_lower[at(i, j)] * y[j];
  }
  std::copy(y, y + m_size, x);
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Symmetric_factorization::solve(double* x) const
{
  solve_lower(x);
  for (int i = 0; i < m_size; ++i)
    x[i] = std::abs(pivot(i)) > (std::numeric_limits<double>::min)() ? x[i] / pivot(i) : 0.;
  for (int i = m_size - 1; i >= 0; --i)
    for (int j = i + 1; j < m_size; ++j)
      x[i] -= m_lower[at(j, i)] * x[j];
  double y[most];
  for (int i = 0; i < m_size; ++i)
    y[m_order[i]] = x[i];
  std::copy(y, y + m_size, x);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SYMMETRIC_FACTORIZATION_IMPL_H
