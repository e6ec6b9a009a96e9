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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ZLIB_INFLATER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ZLIB_INFLATER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Inflater.h>

#include <zlib.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace IO {
namespace internal {

class Zlib_inflater : public Inflater
{
public:
  Zlib_inflater()
  {
    m_stream.next_in = Z_NULL;
    m_stream.avail_in = 0;
    m_stream.zalloc = Z_NULL;
    m_stream.zfree = Z_NULL;
    m_stream.opaque = Z_NULL;
    m_is_started = inflateInit2(&m_stream, -15) == Z_OK;
  }

  Zlib_inflater(const Zlib_inflater&) = delete;
  Zlib_inflater& operator=(const Zlib_inflater&) = delete;

  ~Zlib_inflater() override
  {
    if (m_is_started)
      inflateEnd(&m_stream);
  }

  bool is_started() const override { return m_is_started; }
  bool is_hungry() const override { return m_stream.avail_in == 0; }

  void feed(char* bytes, std::size_t size) override
  {
    m_stream.avail_in = static_cast<uInt>(size);
    m_stream.next_in = reinterpret_cast<Bytef*>(bytes);
  }

  Status inflate(char* target, std::size_t size, std::size_t& done) override
  {
    const std::size_t step = (std::min)(size, std::size_t(1) << 20);
    m_stream.next_out = reinterpret_cast<Bytef*>(target);
    m_stream.avail_out = static_cast<uInt>(step);
    const int status = ::inflate(&m_stream, Z_NO_FLUSH);
    done = step - m_stream.avail_out;
    if (status == Z_STREAM_END)
      return Status::AT_END;
    return status == Z_OK || status == Z_BUF_ERROR ? Status::GOES_ON : Status::DAMAGED;
  }

private:
  z_stream m_stream;
  bool m_is_started = false;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ZLIB_INFLATER_H
