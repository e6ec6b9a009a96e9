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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_CORNERS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_CORNERS_H

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
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
std::vector<Corner_group> find_corners(const Skeleton_data& skeleton, const Extraction_options& options,
                                       const std::function<bool(double)>& proceed);

template <class GeomTraits>
std::vector<Wireframe_corner<GeomTraits>> find_corners(const Wireframe_skeleton<GeomTraits>& skeleton,
                                                       const Extraction_options& options,
                                                       const std::function<bool(double)>& proceed)
{
  std::vector<Wireframe_corner<GeomTraits>> corners;
  for (const Corner_group& group : find_corners(skeleton.data(), options, proceed))
    corners.push_back(
      {skeleton.to_point(group.center), typename GeomTraits::FT(group.radius * skeleton.data().unit), group.members});
  return corners;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/network/find_corners_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIND_CORNERS_H
