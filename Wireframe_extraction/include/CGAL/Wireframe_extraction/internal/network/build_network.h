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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_NETWORK_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_NETWORK_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>
#include <CGAL/Wireframe_extraction/internal/network/corner_groups.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The network of curves that explain the field, as polylines with few points. `proceed(share)` returns whether to go
// on; after cancelling, the network is what was found so far.
Curve_network build_network(const Skeleton_data& skeleton, const std::vector<Corner_group>& corners,
                            const std::vector<std::vector<std::size_t>>& clusters, const Extraction_options& options,
                            const std::function<bool(double)>& proceed);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/network/build_network_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BUILD_NETWORK_H
