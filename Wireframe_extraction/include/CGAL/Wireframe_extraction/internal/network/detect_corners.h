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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_DETECT_CORNERS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_DETECT_CORNERS_H

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/network/corner_groups.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

template <class GeomTraits>
std::vector<Wireframe_corner<GeomTraits>> detect_corners(const Wireframe_skeleton<GeomTraits>& skeleton,
                                                         const Extraction_options& options,
                                                         const std::function<bool(double)>& proceed)
{
  std::vector<Wireframe_corner<GeomTraits>> corners;
  for (const Corner_group& group : corner_groups(skeleton.data(), options, proceed))
    corners.push_back(
      {skeleton.to_point(group.center), typename GeomTraits::FT(group.radius * skeleton.data().unit), group.members});
  return corners;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_DETECT_CORNERS_H
