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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_COURSE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_COURSE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What two curves may be near the place where they meet: two polylines with a corner between them,
// or a single smooth one.
struct Joint_course
{
  std::vector<std::vector<Vector>> polylines;
  double loss; // how badly they explain the points around
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_COURSE_H
