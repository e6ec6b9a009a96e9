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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_CELL_KEY_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_CELL_KEY_H

#include <cstdint>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The key of a cell of a regular grid in a hash table: 21 bits of each index, so that cells far
// apart may have the same.
inline std::uint64_t cell_key(std::int64_t i, std::int64_t j, std::int64_t k)
{
  constexpr std::uint64_t mask = 0x1fffff;
  return (static_cast<std::uint64_t>(i) & mask) << 42 | (static_cast<std::uint64_t>(j) & mask) << 21
    | (static_cast<std::uint64_t>(k) & mask);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_CELL_KEY_H
