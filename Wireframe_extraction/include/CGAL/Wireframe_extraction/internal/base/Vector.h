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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_VECTOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_VECTOR_H

#include <Eigen/Core>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

typedef Eigen::Vector3d Vector;

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_VECTOR_H
