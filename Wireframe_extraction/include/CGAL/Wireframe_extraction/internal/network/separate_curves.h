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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SEPARATE_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SEPARATE_CURVES_H

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Connected components of the points of the skeleton that are in no corner.
// `proceed(share)` returns whether to go on; after cancelling, there is none
std::vector<std::vector<std::size_t>> separate_curves(const Skeleton_data& skeleton,
                                                      const std::vector<char>& is_in_corner,
                                                      const Extraction_options& options,
                                                      const std::function<bool(double)>& proceed);

template <class GeomTraits>
std::vector<std::vector<std::size_t>> separate_curves(const Wireframe_skeleton<GeomTraits>& skeleton,
                                                      const std::vector<Wireframe_corner<GeomTraits>>& corners,
                                                      const Extraction_options& options,
                                                      const std::function<bool(double)>& proceed)
{
  std::vector<char> is_in_corner(skeleton.size(), 0);
  for (const Wireframe_corner<GeomTraits>& corner : corners)
    for (std::size_t i : corner.members)
    {
      CGAL_precondition(i < skeleton.size());
      is_in_corner[i] = 1;
    }
  return separate_curves(skeleton.data(), is_in_corner, options, proceed);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/network/separate_curves_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SEPARATE_CURVES_H
