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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_REFINE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_REFINE_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Takes the distances of a contracted skeleton anew from the creases of the surface around it, if the field errs.
// Returns whether it was not cancelled; otherwise the skeleton is as it was before.
bool refine(Skeleton_data& skeleton, const Extraction_options& options, const std::function<bool(double)>& proceed);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/skeleton/refine_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_REFINE_H
