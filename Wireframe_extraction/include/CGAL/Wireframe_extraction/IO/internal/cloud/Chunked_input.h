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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CHUNKED_INPUT_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CHUNKED_INPUT_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <istream>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Reads a stream in chunks of 1 MiB and hands out bytes or lines from its buffer.
// Memory stays at the size of the buffer whatever the file promises or holds.
class Chunked_input
{
public:
  enum class Line_status
  {
    LINE,
    END,
    TOO_LONG
  };

  static constexpr std::size_t chunk_size = std::size_t(1) << 20;

  explicit Chunked_input(std::istream& stream) : m_stream(stream), m_buffer(chunk_size) { find_size(); }

  // makes `wanted` bytes (at most `chunk_size`) contiguous; returns how many there are, fewer only at the end
  std::size_t require(std::size_t wanted)
  {
    if (m_end - m_begin < wanted && !m_at_end)
      refill();
    return (std::min)(wanted, m_end - m_begin);
  }

  const char* data() const { return m_buffer.data() + m_begin; }

  void consume(std::size_t count)
  {
    m_begin += count;
    m_consumed += count;
  }

  // returns whether so many bytes were there to be skipped
  bool skip(std::uint64_t count)
  {
    while (count > 0)
    {
      const std::size_t step = require(std::size_t((std::min)(count, std::uint64_t(chunk_size))));
      if (step == 0)
        return false;
      consume(step);
      count -= step;
    }
    return true;
  }

  // the next line without its end, which is \n, \r\n or \r; the view holds until the next call
  Line_status next_line(std::string_view& line)
  {
    for (;;)
    {
      std::size_t line_size = 0, total_size = 0;
      if (find_line_end(line_size, total_size))
      {
        line = std::string_view(data(), line_size);
        consume(total_size);
        ++m_line_number;
        return Line_status::LINE;
      }
      if (m_at_end)
        return Line_status::END;
      if (m_end - m_begin == chunk_size)
        return Line_status::TOO_LONG;
      refill();
    }
  }

  // number of the line that was handed out last, counted from 1
  std::size_t line_number() const { return m_line_number; }

  // whether the stream told its size; pipes do not
  bool is_size_known() const { return m_is_size_known; }
  std::uint64_t size() const { return m_size; }
  std::uint64_t remaining() const { return m_size > m_consumed ? m_size - m_consumed : 0; }
  std::uint64_t consumed() const { return m_consumed; }

  // whether reading stopped for another reason than the end of the file
  bool has_failed() const { return m_has_failed; }

private:
  void find_size()
  {
    const std::istream::pos_type begin = m_stream.tellg();
    if (begin == std::istream::pos_type(-1) || !m_stream.seekg(0, std::ios::end))
    {
      m_stream.clear();
      return;
    }
    const std::istream::pos_type end = m_stream.tellg();
    m_stream.seekg(begin);
    if (!m_stream || end == std::istream::pos_type(-1) || end < begin)
    {
      m_stream.clear();
      return;
    }
    m_size = static_cast<std::uint64_t>(end - begin);
    // special files say zero and may still deliver
    m_is_size_known = (m_size > 0);
  }

  void refill()
  {
    std::memmove(m_buffer.data(), data(), m_end - m_begin);
    m_end -= m_begin;
    m_begin = 0;
    m_stream.read(m_buffer.data() + m_end, static_cast<std::streamsize>(chunk_size - m_end));
    m_end += static_cast<std::size_t>(m_stream.gcount());
    m_at_end = !m_stream;
    m_has_failed = m_stream.bad();
  }

  bool find_line_end(std::size_t& line_size, std::size_t& total_size) const
  {
    const std::size_t available = m_end - m_begin;
    if (available == 0)
      return false;
    const void* newline = std::memchr(data(), '\n', available);
    const std::size_t limit = newline ? std::size_t(static_cast<const char*>(newline) - data()) : available;
    const void* carriage_return = std::memchr(data(), '\r', limit);
    if (carriage_return != nullptr)
    {
      line_size = std::size_t(static_cast<const char*>(carriage_return) - data());
      if (line_size + 1 == available && !m_at_end)
        return false;
      total_size = line_size + 1;
      if (total_size < available && data()[total_size] == '\n')
        ++total_size;
      return true;
    }
    line_size = limit;
    total_size = newline ? limit + 1 : limit;
    return newline != nullptr || m_at_end;
  }

  std::istream& m_stream;
  std::vector<char> m_buffer;
  std::size_t m_begin = 0, m_end = 0;
  std::size_t m_line_number = 0;
  std::uint64_t m_consumed = 0;
  std::uint64_t m_size = 0;
  bool m_is_size_known = false;
  bool m_at_end = false;
  bool m_has_failed = false;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CHUNKED_INPUT_H
