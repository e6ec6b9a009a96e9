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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PRINCIPAL_AXES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PRINCIPAL_AXES_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

#include <array>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The eigenvalues of a symmetric matrix, ascending, and its unit eigenvectors.
struct Principal_axes
{
  Vector values = Vector::Zero();
  std::array<Vector, 3> axes;
};

// One function, since the solver takes long to compile.
Principal_axes principal_axes(const Matrix_3& matrix);

// The mean of some points, and the sum of the products of their offsets from it.
struct Scatter
{
  Vector mean = Vector::Zero();
  Matrix_3 matrix = Matrix_3::Zero();
};

// of `position(i)` with the weight `weight(i)`, for each i of a range that is not empty
template <class Range, class Position, class Weight>
Scatter scatter(const Range& range, const Position& position, const Weight& weight)
{
  Scatter result;
  double total = 0.;
  for (const auto& i : range)
  {
    result.mean += weight(i) * position(i);
    total += weight(i);
  }
  result.mean /= total;
  for (const auto& i : range)
  {
    const Vector offset = position(i) - result.mean;
    result.matrix += Matrix_3::outer(weight(i) * offset, offset);
  }
  return result;
}

template <class Range, class Position>
Scatter scatter(const Range& range, const Position& position)
{
  return scatter(range, position, [](const auto&) { return 1.; });
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/base/principal_axes_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PRINCIPAL_AXES_H
