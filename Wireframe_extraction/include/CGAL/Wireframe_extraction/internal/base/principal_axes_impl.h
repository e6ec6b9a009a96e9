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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PRINCIPAL_AXES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PRINCIPAL_AXES_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>

#include <Eigen/Eigenvalues>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE Principal_axes principal_axes(const Matrix_3& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(Eigen::Matrix3d(matrix.data()));
  Principal_axes result;
  result.values = solver.eigenvalues();
  for (int k = 0; k < 3; ++k)
    result.axes[k] = solver.eigenvectors().col(k);
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PRINCIPAL_AXES_IMPL_H
