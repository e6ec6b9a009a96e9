// Writes what NumPy writes: arrays, and archives of them.

#ifndef NUMPY_WRITERS_H
#define NUMPY_WRITERS_H

#include "scratch_files.h"

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
#include <zlib.h>
#endif

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

inline std::string npy_header(const std::string& dictionary, int version = 1)
{
  std::string bytes("\x93NUMPY", 6);
  bytes += static_cast<char>(version);
  bytes += '\0';
  if (version == 1)
    append(static_cast<std::uint16_t>(dictionary.size()), false, bytes);
  else
    append(static_cast<std::uint32_t>(dictionary.size()), false, bytes);
  return bytes + dictionary;
}

inline std::string dictionary(const std::string& type, const std::string& shape, bool is_fortran = false)
{
  return "{'descr': '" + type + "', 'fortran_order': " + (is_fortran ? "True" : "False") + ", 'shape': (" + shape
    + "), }      \n";
}

// a .npy file; the values are in C's order
inline std::string npy(const std::vector<double>& values, const std::vector<std::size_t>& shape,
                       const std::string& type = "<f8", bool is_fortran = false, int version = 1)
{
  std::string shape_text;
  for (const std::size_t& size : shape)
    shape_text += std::to_string(size) + (shape.size() == 1 ? "," : &size == &shape.back() ? "" : ", ");
  std::string bytes = npy_header(dictionary(type, shape_text, is_fortran), version);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    std::size_t index = i;
    if (is_fortran)
    {
      // the position of the i-th value of Fortran's order
      std::size_t rest = i;
      std::vector<std::size_t> position;
      for (const std::size_t size : shape)
      {
        position.push_back(rest % size);
        rest /= size;
      }
      index = 0;
      for (std::size_t axis = 0; axis < shape.size(); ++axis)
        index = index * shape[axis] + position[axis];
    }
    const double value = values[index];
    const bool is_big = (type[0] == '>');
    const std::string kind = type.substr(1);
    if (kind == "f8")
      append(value, is_big, bytes);
    else if (kind == "f4")
      append(static_cast<float>(value), is_big, bytes);
    else if (kind == "i8")
      append(static_cast<std::int64_t>(value), is_big, bytes);
    else if (kind == "u2")
      append(static_cast<std::uint16_t>(value), is_big, bytes);
    else
      assert(false);
  }
  return bytes;
}

inline std::uint32_t check_sum(const std::string& bytes)
{
  std::uint32_t sum = 0xFFFFFFFFu;
  for (const char c : bytes)
  {
    sum ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit)
      sum = (sum & 1u) != 0 ? (sum >> 1) ^ 0xEDB88320u : sum >> 1;
  }
  return ~sum;
}

inline std::string deflated(const std::string& bytes)
{
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  z_stream stream = z_stream();
  assert(deflateInit2(&stream, 9, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(&result[0]);
  stream.avail_out = static_cast<uInt>(result.size());
  assert(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
#else
  return bytes;
#endif
}

struct Member
{
  std::string name, content;
};

// with the numbers of 64 bits that numpy.savez() writes, or also with those of archives above 4 GB
inline std::string zip(const std::vector<Member>& members, unsigned method, bool is_large = false, unsigned flags = 0)
{
  std::string bytes, directory;
  for (const Member& member : members)
  {
    const std::string data = method == 8 ? deflated(member.content) : member.content;
    const std::uint32_t sum = check_sum(member.content);
    const std::uint64_t offset = bytes.size();
    const auto append_common = [&](std::string& target) {
      append(std::uint16_t(45), false, target);
      append(static_cast<std::uint16_t>(flags), false, target);
      append(static_cast<std::uint16_t>(method), false, target);
      append(std::uint32_t(0), false, target);
      append(sum, false, target);
    };
    const auto append_large = [&](bool has_offset, std::string& target) {
      append(std::uint16_t(1), false, target);
      append(std::uint16_t(has_offset ? 24 : 16), false, target);
      append(std::uint64_t(member.content.size()), false, target);
      append(std::uint64_t(data.size()), false, target);
      if (has_offset)
        append(offset, false, target);
    };
    bytes += "PK\3\4";
    append_common(bytes);
    append(0xFFFFFFFFu, false, bytes);
    append(0xFFFFFFFFu, false, bytes);
    append(static_cast<std::uint16_t>(member.name.size()), false, bytes);
    append(std::uint16_t(20), false, bytes);
    bytes += member.name;
    append_large(false, bytes);
    bytes += data;

    directory += "PK\1\2";
    append(std::uint16_t(45), false, directory);
    append_common(directory);
    append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(data.size()), false, directory);
    append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(member.content.size()), false, directory);
    append(static_cast<std::uint16_t>(member.name.size()), false, directory);
    append(std::uint16_t(is_large ? 28 : 0), false, directory);
    directory += std::string(10, '\0');
    append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(offset), false, directory);
    directory += member.name;
    if (is_large)
      append_large(true, directory);
  }
  const std::uint64_t begin = bytes.size(), size = directory.size(), count = members.size();
  bytes += directory;
  if (is_large)
  {
    const std::uint64_t large_end = bytes.size();
    bytes += "PK\6\6";
    append(std::uint64_t(44), false, bytes);
    bytes += std::string(12, '\0');
    append(count, false, bytes);
    append(count, false, bytes);
    append(size, false, bytes);
    append(begin, false, bytes);
    bytes += std::string("PK\6\7\0\0\0\0", 8);
    append(large_end, false, bytes);
    append(std::uint32_t(1), false, bytes);
  }
  bytes += std::string("PK\5\6\0\0\0\0", 8);
  append(static_cast<std::uint16_t>(is_large ? 0xFFFF : count), false, bytes);
  append(static_cast<std::uint16_t>(is_large ? 0xFFFF : count), false, bytes);
  append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(size), false, bytes);
  append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(begin), false, bytes);
  append(std::uint16_t(0), false, bytes);
  return bytes;
}

inline std::vector<unsigned> zip_methods()
{
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  return {0, 8};
#else
  return {0};
#endif
}

#endif // NUMPY_WRITERS_H
