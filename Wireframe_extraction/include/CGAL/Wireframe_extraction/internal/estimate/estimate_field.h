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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_ESTIMATE_FIELD_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_ESTIMATE_FIELD_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Field_estimate.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Estimates the distances of points to the folds of the surface that they lie on. `points` are in sampling distances,
// near the origin; `minimum_fold` is in degrees. `proceed(share)` returns whether to go on; this
// returns whether it did.
bool estimate_field(const std::vector<Vector>& points, double minimum_fold, const std::function<bool(double)>& proceed,
                    Field_estimate& estimate);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/estimate/estimate_field_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_ESTIMATE_FIELD_H
