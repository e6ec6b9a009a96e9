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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A place where two smooth sheets explain the points of a ball better than one. Lengths are in sampling distances.
struct Fold
{
  Vector foot = Vector::Zero(); // of the ball's center on it
  double angle = 0.;            // between the sheets' normals, in radians
  double evidence = 0.;         // by how much it beats one sheet: the drop of chi square, less what chance explains
  double margin = 0.;           // by how much it beats a sheet that bends more: the difference of chi square
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_H
