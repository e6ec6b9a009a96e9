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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NPZ_FILE_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NPZ_FILE_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Array_file.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Cloud_libraries.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Inflater.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Npy_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/property_names.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// the check sum of the ZIP format
class Cyclic_redundancy_check
{
public:
  void add(const char* bytes, std::size_t size)
  {
    for (std::size_t i = 0; i < size; ++i)
      m_sum = table()[(m_sum ^ static_cast<unsigned char>(bytes[i])) & 0xFFu] ^ (m_sum >> 8);
  }

  std::uint32_t value() const { return ~m_sum; }

private:
  static const std::array<std::uint32_t, 256>& table()
  {
    static const std::array<std::uint32_t, 256> values = [] {
      std::array<std::uint32_t, 256> sums = {};
      for (std::uint32_t i = 0; i < 256; ++i)
      {
        sums[i] = i;
        for (int bit = 0; bit < 8; ++bit)
          sums[i] = (sums[i] >> 1) ^ ((sums[i] & 1u) != 0 ? 0xEDB88320u : 0u);
      }
      return sums;
    }();
    return values;
  }

  std::uint32_t m_sum = 0xFFFFFFFFu;
};

struct Zip_entry
{
  std::string name;
  unsigned flags = 0, method = 0;
  std::uint32_t check_sum = 0;
  std::uint64_t compressed_size = 0, size = 0, offset = 0;
};

// The bytes of one file of an archive, decompressed and checked against their sum.
class Zip_bytes : public Byte_source
{
public:
  static constexpr unsigned stored = 0, deflated = 8;

  // the stream stands at the first byte; an inflater is needed if the entry is deflated
  Zip_bytes(std::istream& stream, const Zip_entry& entry, std::unique_ptr<Inflater> inflater)
    : m_stream(stream), m_entry(entry), m_inflater(std::move(inflater))
  {
    m_compressed_rest = entry.compressed_size;
    // deflation makes data smaller by a factor of 1032 at best
    m_rest =
      entry.method == stored ? entry.compressed_size : (std::min)(entry.size, 1032 * entry.compressed_size + 1032);
    if (entry.method == deflated && !m_inflater->is_started())
      m_error = "zlib cannot be started";
  }

  std::size_t read(char* target, std::size_t size) override
  {
    if (!m_error.empty() || size == 0)
      return 0;
    const std::size_t count = (m_entry.method == stored) ? read_raw(target, size) : inflate_into(target, size);
    m_sum.add(target, count);
    m_done += count;
    m_rest -= (std::min)(m_rest, std::uint64_t(count));
    if (count < size && m_error.empty())
      check_end();
    return count;
  }

  std::uint64_t largest_rest() const override { return m_rest; }
  const std::string& error() const override { return m_error; }

private:
  std::size_t read_raw(char* target, std::size_t size)
  {
    const std::size_t wanted = static_cast<std::size_t>((std::min)(m_compressed_rest, std::uint64_t(size)));
    m_stream.read(target, static_cast<std::streamsize>(wanted));
    const std::size_t count = static_cast<std::size_t>(m_stream.gcount());
    if (count < wanted)
      m_error = "is truncated: the archive ends before it does; get a complete copy of the file";
    m_compressed_rest -= count;
    return count;
  }

  std::size_t inflate_into(char* target, std::size_t size)
  {
    std::size_t done = 0;
    while (done < size && !m_is_at_end)
    {
      if (m_inflater->is_hungry())
      {
        const std::size_t count = read_raw(m_input.data(), m_input.size());
        m_inflater->feed(m_input.data(), count);
        if (count == 0)
        {
          if (m_error.empty())
            m_error = "its compressed data ends too early: the file is damaged; get a complete copy of it";
          return done;
        }
      }
      std::size_t step = 0;
      const Inflater::Status status = m_inflater->inflate(target + done, size - done, step);
      done += step;
      m_is_at_end = (status == Inflater::Status::AT_END);
      if (status == Inflater::Status::DAMAGED)
      {
        m_error = "its compressed data is damaged; get a complete copy of the file";
        return done;
      }
    }
    return done;
  }

  void check_end()
  {
    if (m_done != m_entry.size || m_sum.value() != m_entry.check_sum)
      m_error = "its data is not what its check sum says: the file is damaged; get a complete copy of it";
  }

  std::istream& m_stream;
  const Zip_entry& m_entry;
  std::unique_ptr<Inflater> m_inflater;
  std::array<char, 65536> m_input;
  bool m_is_at_end = false;
  std::uint64_t m_compressed_rest = 0, m_rest = 0, m_done = 0;
  Cyclic_redundancy_check m_sum;
  std::string m_error;
};

// The arrays that numpy.savez() and numpy.savez_compressed() write: a ZIP archive of .npy files.
class Npz_file : public Array_file
{
public:
  Npz_file(std::istream& stream, const std::string& filename, const Cloud_libraries& libraries)
    : m_stream(stream), m_filename(filename), m_libraries(libraries)
  {}

  bool open(std::string& error)
  {
    const std::string reason = read_directory();
    if (!reason.empty())
      error = m_filename + ": " + reason;
    return reason.empty();
  }

  const std::string& filename() const override { return m_filename; }
  const char* word_for_array() const override { return "array"; }
  const std::vector<std::string>& names() const override { return m_names; }
  std::string contents_text() override { return join(m_names); }

  bool read(const std::string& name, Number_array& array, std::string& error) override
  {
    const Zip_entry& entry = m_entries[find_name(m_names, name)];
    const std::string full_name = m_filename + ": array " + quote(name);
    const std::string reason = go_to(entry);
    if (!reason.empty())
    {
      error = full_name + ": " + reason;
      return false;
    }
    Zip_bytes bytes(m_stream, entry,
                    entry.method == Zip_bytes::deflated ? m_libraries.make_inflater() : std::unique_ptr<Inflater>());
    Npy_reader reader(bytes, full_name);
    const bool is_read = reader.read(array);
    error = reader.error();
    return is_read;
  }

private:
  static constexpr std::size_t end_size = 22, longest_comment = 65535, entry_size = 46;

  static std::string damaged() { return "its directory is damaged; get a complete copy of the file"; }

  bool read_at(std::uint64_t offset, std::uint64_t size, std::string& bytes)
  {
    if (offset > m_file_size || size > m_file_size - offset)
      return false;
    bytes.resize(static_cast<std::size_t>(size));
    m_stream.clear();
    m_stream.seekg(static_cast<std::streamoff>(offset));
    return static_cast<bool>(m_stream.read(&bytes[0], static_cast<std::streamsize>(size)));
  }

  template <class Unsigned>
  static Unsigned number_at(const std::string& bytes, std::size_t offset)
  {
    return load_little_endian<Unsigned>(bytes.data() + offset);
  }

  std::string read_directory()
  {
    m_stream.seekg(0, std::ios::end);
    const std::istream::pos_type end = m_stream.tellg();
    if (!m_stream || end == std::istream::pos_type(-1))
      return "is no file in which one can go back, as the .npz format needs it";
    m_file_size = static_cast<std::uint64_t>(end);
    if (m_file_size == 0)
      return empty_file_text();
    const std::uint64_t tail_size = (std::min)(m_file_size, std::uint64_t(end_size + longest_comment));
    std::string tail;
    if (!read_at(m_file_size - tail_size, tail_size, tail))
      return "reading failed";
    const std::size_t position = tail.rfind("PK\5\6");
    if (position == std::string::npos || tail.size() - position < end_size)
      return "is no NumPy archive, or a truncated one: it has no ZIP directory at its end; copy it again, "
             "or write it with numpy.savez()";
    std::uint64_t count = number_at<std::uint16_t>(tail, position + 10);
    std::uint64_t size = number_at<std::uint32_t>(tail, position + 12);
    std::uint64_t offset = number_at<std::uint32_t>(tail, position + 16);
    if ((count == 0xFFFFu || size == 0xFFFFFFFFu || offset == 0xFFFFFFFFu)
        && !read_large_end(m_file_size - tail_size + position, count, size, offset))
      return damaged();
    std::string directory;
    if (!read_at(offset, size, directory) || count > size / entry_size)
      return damaged();
    return read_entries(directory, count);
  }

  // large archives have a second end with numbers of 64 bits
  bool read_large_end(std::uint64_t end, std::uint64_t& count, std::uint64_t& size, std::uint64_t& offset)
  {
    std::string locator, large_end;
    if (end < 20 || !read_at(end - 20, 20, locator) || locator.compare(0, 4, "PK\6\7") != 0
        || !read_at(number_at<std::uint64_t>(locator, 8), 56, large_end) || large_end.compare(0, 4, "PK\6\6") != 0)
      return false;
    count = number_at<std::uint64_t>(large_end, 32);
    size = number_at<std::uint64_t>(large_end, 40);
    offset = number_at<std::uint64_t>(large_end, 48);
    return true;
  }

  std::string read_entries(const std::string& directory, std::uint64_t count)
  {
    std::size_t position = 0;
    for (std::uint64_t i = 0; i < count; ++i)
    {
      if (directory.size() - position < entry_size || directory.compare(position, 4, "PK\1\2") != 0)
        return damaged();
      Zip_entry entry;
      entry.flags = number_at<std::uint16_t>(directory, position + 8);
      entry.method = number_at<std::uint16_t>(directory, position + 10);
      entry.check_sum = number_at<std::uint32_t>(directory, position + 16);
      entry.compressed_size = number_at<std::uint32_t>(directory, position + 20);
      entry.size = number_at<std::uint32_t>(directory, position + 24);
      entry.offset = number_at<std::uint32_t>(directory, position + 42);
      const std::size_t name_size = number_at<std::uint16_t>(directory, position + 28);
      const std::size_t extra_size = number_at<std::uint16_t>(directory, position + 30);
      const std::size_t comment_size = number_at<std::uint16_t>(directory, position + 32);
      position += entry_size;
      if (directory.size() - position < name_size + extra_size + comment_size)
        return damaged();
      entry.name = directory.substr(position, name_size);
      if (!read_large_sizes(directory.substr(position + name_size, extra_size), entry))
        return damaged();
      position += name_size + extra_size + comment_size;
      if (entry.compressed_size > m_file_size)
        return damaged();
      if (!ends_with(entry.name, ".npy"))
        continue; // no array
      m_entries.push_back(entry);
      m_names.push_back(entry.name.substr(0, entry.name.size() - 4));
    }
    return std::string();
  }

  // what does not fit into 32 bits stands in an extra field
  static bool read_large_sizes(const std::string& extra, Zip_entry& entry)
  {
    std::string large;
    for (std::size_t position = 0; extra.size() - position >= 4;)
    {
      const std::size_t size = number_at<std::uint16_t>(extra, position + 2);
      if (extra.size() - position - 4 < size)
        return false;
      if (number_at<std::uint16_t>(extra, position) == 1)
        large = extra.substr(position + 4, size);
      position += 4 + size;
    }
    std::size_t position = 0;
    for (std::uint64_t* const value : {&entry.size, &entry.compressed_size, &entry.offset})
      if (*value == 0xFFFFFFFFu)
      {
        if (large.size() - position < 8)
          return false;
        *value = number_at<std::uint64_t>(large, position);
        position += 8;
      }
    return true;
  }

  // moves the stream to the data of an entry; returns why that is impossible
  std::string go_to(const Zip_entry& entry)
  {
    if ((entry.flags & 1u) != 0)
      return "is encrypted; numpy.savez() writes plain archives";
    if (entry.method != Zip_bytes::stored && entry.method != Zip_bytes::deflated)
      return "is compressed by the method " + std::to_string(entry.method)
        + "; write it with numpy.savez() or numpy.savez_compressed()";
    if (entry.method == Zip_bytes::deflated && m_libraries.make_inflater == nullptr)
      return "is compressed, which needs zlib, without which this program was built; write it with numpy.savez() "
             "instead of numpy.savez_compressed(), or build with the CMake target "
             "CGAL::Wireframe_extraction_ZLIB (Debian: zlib1g-dev)";
    std::string header;
    if (!read_at(entry.offset, 30, header) || header.compare(0, 4, "PK\3\4") != 0)
      return damaged();
    const std::uint64_t begin =
      entry.offset + 30 + number_at<std::uint16_t>(header, 26) + number_at<std::uint16_t>(header, 28);
    if (begin > m_file_size || entry.compressed_size > m_file_size - begin)
      return "is truncated: the archive ends before it does; get a complete copy of the file";
    m_stream.clear();
    m_stream.seekg(static_cast<std::streamoff>(begin));
    return m_stream ? std::string() : std::string("reading failed");
  }

  std::istream& m_stream;
  std::string m_filename;
  Cloud_libraries m_libraries;
  std::uint64_t m_file_size = 0;
  std::vector<Zip_entry> m_entries;
  std::vector<std::string> m_names;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_NPZ_FILE_H
