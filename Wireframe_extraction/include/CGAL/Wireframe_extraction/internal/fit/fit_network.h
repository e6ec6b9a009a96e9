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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_NETWORK_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_NETWORK_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/fit/Fitted_curve.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Fits the splines of all curves, and moves the vertices in which they meet. `proceed(share)` returns whether to go on;
// this returns whether it did.
bool fit_network(const Skeleton_data& skeleton, const Extraction_options& options, std::vector<Vector>& vertices,
                 std::vector<Fitted_curve>& curves, const std::function<bool(double)>& proceed);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/fit/fit_network_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_NETWORK_H
