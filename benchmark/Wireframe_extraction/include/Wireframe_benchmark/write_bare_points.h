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

#ifndef WIREFRAME_BENCHMARK_WRITE_BARE_POINTS_H
#define WIREFRAME_BENCHMARK_WRITE_BARE_POINTS_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Ply_header.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>

namespace Wireframe_benchmark {

namespace fs = std::filesystem;

namespace internal {

/// the vertices of a binary PLY file that has nothing else, and where their coordinates are
struct Bare_points
{
  CGAL::IO::internal::Ply_element vertex;
  std::array<std::size_t, 3> offsets = {{0, 0, 0}}, sizes = {{0, 0, 0}}; // of x, y and z, in bytes

  /// reads the header of a file
  Bare_points(CGAL::IO::internal::Chunked_input& in, const std::string& name)
  {
    CGAL::IO::internal::Ply_header header;
    std::string error;
    if (!header.read(in, name, error))
      throw std::runtime_error(error);
    if (header.format != CGAL::IO::internal::Ply_format::BINARY_LITTLE_ENDIAN || header.elements.size() != 1
        || header.elements.front().name != "vertex" || header.elements.front().has_list())
      throw std::runtime_error(
        name
        + ": --raw reads binary PLY files (little endian) of vertices only, without lists; write "
          "the cloud as one");
    vertex = header.elements.front();
    for (std::size_t k = 0; k < 3; ++k)
      find(k, name);
  }

  std::string property(std::size_t k) const { return std::string(1, "xyz"[k]); }

private:
  void find(std::size_t k, const std::string& name)
  {
    for (const CGAL::IO::internal::Ply_property& p : vertex.properties)
    {
      sizes[k] = size_of(p.type);
      if (p.name == property(k) && is_floating_point(p.type))
        return;
      offsets[k] += sizes[k];
    }
    throw std::runtime_error(name + ": its vertices have no floating point number " + property(k) + "; add one");
  }
};

} // namespace internal

/*!
writes the positions of a cloud, bit by bit as they are, and nothing else that is known of its points. Throws
`std::runtime_error` if it cannot be read or written.

\param cloud a PLY file as the makers of cases write it
\param result the PLY file to write
*/
inline void write_bare_points(const fs::path& cloud, const fs::path& result)
{
  std::ifstream stream(cloud, std::ios::binary);
  CGAL::IO::internal::Chunked_input in(stream);
  const internal::Bare_points points(in, cloud.string());
  std::ofstream out(result, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << points.vertex.count << '\n';
  for (std::size_t k = 0; k < 3; ++k)
    out << "property " << (points.sizes[k] == 4 ? "float " : "double ") << points.property(k) << '\n';
  out << "end_header\n";
  const std::size_t size = static_cast<std::size_t>(points.vertex.entry_size());
  for (std::uint64_t i = 0; i < points.vertex.count; ++i)
  {
    if (in.require(size) < size)
      throw std::runtime_error(cloud.string() + ": is truncated; make the case again");
    for (std::size_t k = 0; k < 3; ++k)
      out.write(in.data() + points.offsets[k], std::streamsize(points.sizes[k]));
    in.consume(size);
  }
  if (!out.flush())
    throw std::runtime_error(result.string() + ": cannot be written; is the disk full?");
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_WRITE_BARE_POINTS_H
