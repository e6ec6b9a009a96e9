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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_CURVE_SAMPLING_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_CURVE_SAMPLING_H

#include <optional>

namespace CGAL {
namespace IO {
namespace internal {

// How curves become polylines, as far as it is told: how long a piece may be, and how far from the curve.
struct Curve_sampling
{
  std::optional<double> step, chord_tolerance;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_CURVE_SAMPLING_H
