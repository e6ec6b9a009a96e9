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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIND_SKELETON_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIND_SKELETON_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The points near features, in units of the sampling distance `unit`; none if that is 0.
Skeleton_data find_skeleton(const Surveyed_cloud& cloud, double unit, const Extraction_options& options);

// The points around the skeleton whatever their distances say: what the surface looks like there.
void find_surroundings(const Surveyed_cloud& cloud, const Extraction_options& options, Skeleton_data& skeleton);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/skeleton/find_skeleton_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_FIND_SKELETON_H
