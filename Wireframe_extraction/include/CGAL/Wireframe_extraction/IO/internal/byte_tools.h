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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_BYTE_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_BYTE_TOOLS_H

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// least significant byte first, whatever the machine
template <class Unsigned>
void append_little_endian(Unsigned bits, std::string& bytes)
{
  for(std::size_t i = 0; i < sizeof(Unsigned); ++i)
    bytes += static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
}

inline void append_little_endian(float value, std::string& bytes)
{
  std::uint32_t bits;
  static_assert(sizeof(bits) == sizeof(value), "a float has 32 bits");
  std::memcpy(&bits, &value, sizeof(bits));
  append_little_endian(bits, bytes);
}

inline void append_little_endian(double value, std::string& bytes)
{
  std::uint64_t bits;
  static_assert(sizeof(bits) == sizeof(value), "a double has 64 bits");
  std::memcpy(&bits, &value, sizeof(bits));
  append_little_endian(bits, bytes);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_BYTE_TOOLS_H
