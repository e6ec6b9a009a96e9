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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ADD_DOUBTS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ADD_DOUBTS_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Adds the doubts about the curves of a finished wireframe to those that they have. Returns false after cancelling;
// then some are missing.
bool add_doubts(const Skeleton_data& skeleton, const Extraction_options& options, Wireframe<Plain_traits>& wireframe,
                const std::function<bool(double)>& proceed);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/pipeline/add_doubts_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ADD_DOUBTS_H
