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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_LZF_DECODER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_LZF_DECODER_H

#include <CGAL/config.h>

#include <cstddef>

namespace CGAL {
namespace IO {
namespace internal {

// Undoes the compression of LibLZF, which h5py has as `lzf`: runs of bytes that are stored as they are, and repetitions
// of some that came before. Nothing is written or read outside the given bytes, whatever is in them.
class Lzf_decoder
{
public:
  Lzf_decoder(const unsigned char* data, std::size_t size) : m_data(data), m_size(size) {}

  // Gets how many bytes will come out, at most 88 times those that are there; false if the data are damaged.
  bool find_size(std::size_t& size) const
  {
    size = 0;
    return walk([&size](const unsigned char*, std::size_t count) { size += count; },
                [&size](std::size_t back, std::size_t count) {
                  const bool is_there = back <= size;
                  size += count;
                  return is_there;
                });
  }

  // writes the bytes that `find_size()` announced
  void decode(unsigned char* target) const
  {
    walk(
      [&target](const unsigned char* source, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i)
          *target++ = source[i];
      },
      [&target](std::size_t back, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i, ++target) // one by one: it may repeat what it just wrote
          *target = *(target - back);
        return true;
      });
  }

private:
  // Calls `store(bytes, count)` for each run, and `repeat(how far back, count)` for each repetition.
  template <class Store, class Repeat>
  bool walk(const Store& store, const Repeat& repeat) const
  {
    const unsigned char* at = m_data;
    const unsigned char* const end = m_data + m_size;
    while (at != end)
    {
      const unsigned int control = *at++;
      const std::size_t left = static_cast<std::size_t>(end - at);
      if (control < 32) // the length less one
      {
        if (left < control + 1)
          return false;
        store(at, control + 1);
        at += control + 1;
        continue;
      }
      // three bits of the length, five of the way back; a full length goes on in a byte of its own
      const bool is_long = control >> 5 == 7;
      if (left < (is_long ? 2u : 1u))
        return false;
      const std::size_t count = (control >> 5) + 2 + (is_long ? *at++ : 0u);
      const std::size_t back = ((control & 31u) << 8) + *at++ + 1;
      if (!repeat(back, count))
        return false;
    }
    return true;
  }

  const unsigned char* m_data;
  std::size_t m_size;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_LZF_DECODER_H
