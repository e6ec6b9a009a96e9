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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CORNER_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CORNER_H

#include <cstddef>
#include <vector>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// A place where curves of a wireframe presumably meet or end.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
struct Wireframe_corner
{
  typedef GeomTraits Geom_traits; ///< the traits class

  typename GeomTraits::Point_3 center; ///< where the corner is
  typename GeomTraits::FT radius;      ///< how far from the center the corner's points lie, in the cloud's unit
  std::vector<std::size_t> members;    ///< the points of the skeleton that belong to it, in ascending order
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CORNER_H
