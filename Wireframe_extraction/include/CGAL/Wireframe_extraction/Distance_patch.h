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

#ifndef CGAL_WIREFRAME_EXTRACTION_DISTANCE_PATCH_H
#define CGAL_WIREFRAME_EXTRACTION_DISTANCE_PATCH_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

/// \ingroup PkgWireframeExtractionClasses
/// A part of a cloud, with the distances that were estimated for its points from this part alone. Parts may overlap.
///
/// \tparam Point the type of the points
/// \tparam FT a model of `FieldNumberType` that is constructible from `double`
template <class Point, class FT>
struct Distance_patch
{
  /// the points of the patch, and their distances
  std::vector<std::pair<Point, FT>> samples;

  /// where the points are in the whole cloud; empty if that is not known, else one for each point
  std::vector<std::size_t> indices;
};

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_DISTANCE_PATCH_H
