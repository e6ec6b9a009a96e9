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
Principal_axes principal_axes(const Eigen::Matrix3d& matrix);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/base/principal_axes_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PRINCIPAL_AXES_H
