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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_POINTS_IN_MEMORY_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_POINTS_IN_MEMORY_H

#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// up to how many points of a cloud are copied
template <class NamedParameters>
std::size_t points_in_memory(const NamedParameters& np)
{
  return static_cast<std::size_t>(CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::points_in_memory), std::size_t(1) << 20));
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_POINTS_IN_MEMORY_H
