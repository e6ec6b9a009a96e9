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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ADD_DOUBTS_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ADD_DOUBTS_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Doubt_finder.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/add_doubts.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE
bool add_doubts(const Skeleton_data& skeleton, const Extraction_options& options, Wireframe<Plain_traits>& wireframe,
                const std::function<bool(double)>& proceed)
{
  if (!skeleton.band)
    return true;
  Progress progress(proceed);
  Doubt_finder(skeleton, skeleton.noise(options), wireframe, progress).run();
  return !progress.is_cancelled();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_ADD_DOUBTS_IMPL_H
