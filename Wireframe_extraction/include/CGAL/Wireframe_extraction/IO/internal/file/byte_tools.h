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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_BYTE_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_BYTE_TOOLS_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

inline bool is_host_little_endian()
{
  const std::uint16_t one = 1;
  char first_byte;
  std::memcpy(&first_byte, &one, 1);
  return first_byte == 1;
}

template <class Number>
Number load_as(const char* bytes, bool is_swapped)
{
  char ordered[sizeof(Number)];
  std::memcpy(ordered, bytes, sizeof(Number));
  if (is_swapped)
    std::reverse(ordered, ordered + sizeof(Number));
  Number number;
  std::memcpy(&number, ordered, sizeof(Number));
  return number;
}

template <class Number>
Number load_little_endian(const char* bytes)
{
  return load_as<Number>(bytes, !is_host_little_endian());
}

// a floating point number of 16 bits, as IEEE 754 has it
inline double half_to_double(std::uint16_t bits)
{
  const int exponent = (bits >> 10) & 31, fraction = bits & 1023;
  double value = std::ldexp(fraction, -24); // subnormal, or zero
  if (exponent == 31)
    value = fraction == 0 ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
  else if (exponent > 0)
    value = std::ldexp(1024 + fraction, exponent - 25);
  return (bits & 0x8000u) != 0 ? -value : value;
}

// A number of a kind, 'f' (floating point), 'i' (integer) or 'u' (natural number), and a size in bytes, as
// several formats name their types.
inline bool is_number_type(char kind, std::size_t size)
{
  return kind == 'f' ? size == 2 || size == 4 || size == 8
                     : (kind == 'i' || kind == 'u') && (size == 1 || size == 2 || size == 4 || size == 8);
}

inline double load_number(char kind, std::size_t size, const char* bytes, bool is_swapped)
{
  if (kind == 'f' && size == 2)
    return half_to_double(load_as<std::uint16_t>(bytes, is_swapped));
  if (kind == 'f')
    return size == 4 ? load_as<float>(bytes, is_swapped) : load_as<double>(bytes, is_swapped);
  const bool is_signed = (kind == 'i');
  switch (size)
  {
  case 1: return is_signed ? load_as<std::int8_t>(bytes, is_swapped) : load_as<std::uint8_t>(bytes, is_swapped);
  case 2: return is_signed ? load_as<std::int16_t>(bytes, is_swapped) : load_as<std::uint16_t>(bytes, is_swapped);
  case 4:
    return is_signed ? static_cast<double>(load_as<std::int32_t>(bytes, is_swapped))
                     : static_cast<double>(load_as<std::uint32_t>(bytes, is_swapped));
  default:
    return is_signed ? static_cast<double>(load_as<std::int64_t>(bytes, is_swapped))
                     : static_cast<double>(load_as<std::uint64_t>(bytes, is_swapped));
  }
}

// least significant byte first, whatever the machine
template <class Unsigned>
void append_little_endian(Unsigned bits, std::string& bytes)
{
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i)
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

// the digits of RFC 4648, with padding
inline std::string to_base64(const std::string& bytes)
{
  const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t bits = 0;
    for (std::size_t j = 0; j < 3; ++j)
      bits = (bits << 8) | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += (i + j > bytes.size()) ? '=' : digits[(bits >> (18 - 6 * j)) & 63u];
  }
  return text;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_BYTE_TOOLS_H
