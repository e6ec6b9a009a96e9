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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WIREFRAME_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WIREFRAME_TOOLS_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/coordinates.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <string>

namespace CGAL {
namespace IO {
namespace internal {

using Wireframe_extraction::internal::Coordinates;
using Wireframe_extraction::internal::coordinates_of;
using Wireframe_extraction::internal::is_finite_point;

// what is wrong with the wireframe, so that no reader passes it on and no writer puts it into a
// file; empty if nothing is
template <class GeomTraits>
std::string wireframe_problem(const CGAL::Wireframe<GeomTraits>& wireframe, const GeomTraits& traits)
{
  std::string problem;
  wireframe.is_valid(&problem, traits);
  return problem;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WIREFRAME_TOOLS_H
