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

#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Wireframe_benchmark {

namespace fs = std::filesystem;

namespace internal {

/// a property of the vertices of a binary PLY file
struct Ply_column
{
  std::string type;
  std::size_t offset, size;
};

/// what a binary PLY file holds whose only element are vertices without lists
struct Ply_layout
{
  std::size_t number_of_vertices = 0, vertex_size = 0;
  std::map<std::string, Ply_column> columns;
};

inline Ply_layout read_ply_layout(std::istream& in, const std::string& name)
{
  static const std::map<std::string, std::size_t> sizes = {
    {"char", 1},   {"uchar", 1},   {"short", 2},  {"ushort", 2}, {"int", 4},    {"uint", 4},
    {"float", 4},  {"int8", 1},    {"uint8", 1},  {"int16", 2},  {"uint16", 2}, {"int32", 4},
    {"uint32", 4}, {"float32", 4}, {"double", 8}, {"float64", 8}};
  Ply_layout layout;
  bool is_binary = false;
  std::string line;
  while (std::getline(in, line) && line != "end_header")
  {
    std::istringstream words(line);
    std::string key, first, second;
    words >> key >> first >> second;
    if (key == "format")
      is_binary = first == "binary_little_endian";
    if (key == "element" && first == "vertex" && layout.number_of_vertices == 0)
      layout.number_of_vertices = std::stoul(second);
    else if (key == "element")
      throw std::runtime_error(name + ": has other elements than vertices, which --raw cannot leave out");
    if (key != "property")
      continue;
    if (sizes.count(first) == 0)
      throw std::runtime_error(name + ": has a property of the type " + first + ", which --raw cannot leave out");
    layout.columns[second] = {first, layout.vertex_size, sizes.at(first)};
    layout.vertex_size += sizes.at(first);
  }
  if (!in || !is_binary || layout.columns.count("x") + layout.columns.count("y") + layout.columns.count("z") != 3)
    throw std::runtime_error(name + ": --raw reads binary PLY files (little endian) with x, y and z only");
  return layout;
}

} // namespace internal

/*!
writes the positions of a cloud, bit by bit as they are, and nothing else that is known of its points. Throws
`std::runtime_error` if it cannot be read or written.

\param cloud a PLY file as the makers of cases write it
\param result the PLY file to write
*/
inline void write_bare_points(const fs::path& cloud, const fs::path& result)
{
  std::ifstream in(cloud, std::ios::binary);
  const internal::Ply_layout layout = internal::read_ply_layout(in, cloud.string());
  std::ofstream out(result, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << layout.number_of_vertices << '\n';
  const std::array<internal::Ply_column, 3> columns = {
    {layout.columns.at("x"), layout.columns.at("y"), layout.columns.at("z")}};
  static const char* const names[] = {"x", "y", "z"};
  for (std::size_t k = 0; k < 3; ++k)
    out << "property " << columns[k].type << ' ' << names[k] << '\n';
  out << "end_header\n";
  std::vector<char> vertex(layout.vertex_size);
  for (std::size_t i = 0; i < layout.number_of_vertices; ++i)
  {
    if (!in.read(vertex.data(), std::streamsize(vertex.size())))
      throw std::runtime_error(cloud.string() + ": is truncated");
    for (const internal::Ply_column& column : columns)
      out.write(vertex.data() + column.offset, std::streamsize(column.size));
  }
  if (!out.flush())
    throw std::runtime_error(result.string() + ": cannot be written; is the disk full?");
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_WRITE_BARE_POINTS_H
