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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CORNER_GROUPS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CORNER_GROUPS_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Points of the skeleton that make a corner.
struct Corner_group
{
  Vector center = Vector::Zero();
  double radius = 0.; // of the ball around the center that holds them
  std::vector<std::size_t> members;
};

// `proceed(share)` returns whether to go on; after cancelling, there is none
std::vector<Corner_group> corner_groups(const Skeleton_data& skeleton, const Extraction_options& options,
                                        const std::function<bool(double)>& proceed);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/network/corner_groups_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CORNER_GROUPS_H
