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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_COMPLETE_BAND_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_COMPLETE_BAND_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>

#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Sorts the points by distance, and takes out those that lie where another one does: the one with the smallest distance
// stays.
std::size_t sort_band(Field_band& band);

// Sorts the points, says which are the skeleton, and indexes all. Returns how many were left out.
std::size_t complete_band(Field_band& band, double skeleton_distance);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/skeleton/complete_band_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_COMPLETE_BAND_H
