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

  explicit Chunked_input(std::istream& stream) : stream_(stream), buffer_(chunk_size) { find_size(); }

  // makes `wanted` bytes (at most `chunk_size`) contiguous; returns how many there are, fewer only at the end
  std::size_t require(std::size_t wanted)
  {
    if (end_ - begin_ < wanted && !at_end_)
      refill();
    return (std::min)(wanted, end_ - begin_);
  }

  const char* data() const { return buffer_.data() + begin_; }

  void consume(std::size_t count)
  {
    begin_ += count;
    consumed_ += count;
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
        ++line_number_;
        return Line_status::LINE;
      }
      if (at_end_)
        return Line_status::END;
      if (end_ - begin_ == chunk_size)
        return Line_status::TOO_LONG;
      refill();
    }
  }

  // number of the line that was handed out last, counted from 1
  std::size_t line_number() const { return line_number_; }

  // whether the stream told its size; pipes do not
  bool is_size_known() const { return is_size_known_; }
  std::uint64_t size() const { return size_; }
  std::uint64_t remaining() const { return size_ > consumed_ ? size_ - consumed_ : 0; }
  std::uint64_t consumed() const { return consumed_; }

  // whether reading stopped for another reason than the end of the file
  bool has_failed() const { return has_failed_; }

private:
  void find_size()
  {
    const std::istream::pos_type begin = stream_.tellg();
    if (begin == std::istream::pos_type(-1) || !stream_.seekg(0, std::ios::end))
    {
      stream_.clear();
      return;
    }
    const std::istream::pos_type end = stream_.tellg();
    stream_.seekg(begin);
    if (!stream_ || end == std::istream::pos_type(-1) || end < begin)
    {
      stream_.clear();
      return;
    }
    size_ = static_cast<std::uint64_t>(end - begin);
    // special files say zero and may still deliver
    is_size_known_ = (size_ > 0);
  }

  void refill()
  {
    std::memmove(buffer_.data(), data(), end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    stream_.read(buffer_.data() + end_, static_cast<std::streamsize>(chunk_size - end_));
    end_ += static_cast<std::size_t>(stream_.gcount());
    at_end_ = !stream_;
    has_failed_ = stream_.bad();
  }

  bool find_line_end(std::size_t& line_size, std::size_t& total_size) const
  {
    const std::size_t available = end_ - begin_;
    if (available == 0)
      return false;
    const void* newline = std::memchr(data(), '\n', available);
    const std::size_t limit = newline ? std::size_t(static_cast<const char*>(newline) - data()) : available;
    const void* carriage_return = std::memchr(data(), '\r', limit);
    if (carriage_return != nullptr)
    {
      line_size = std::size_t(static_cast<const char*>(carriage_return) - data());
      if (line_size + 1 == available && !at_end_)
        return false;
      total_size = line_size + 1;
      if (total_size < available && data()[total_size] == '\n')
        ++total_size;
      return true;
    }
    line_size = limit;
    total_size = newline ? limit + 1 : limit;
    return newline != nullptr || at_end_;
  }

  std::istream& stream_;
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
  std::size_t line_number_ = 0;
  std::uint64_t consumed_ = 0;
  std::uint64_t size_ = 0;
  bool is_size_known_ = false;
  bool at_end_ = false;
  bool has_failed_ = false;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CHUNKED_INPUT_H
