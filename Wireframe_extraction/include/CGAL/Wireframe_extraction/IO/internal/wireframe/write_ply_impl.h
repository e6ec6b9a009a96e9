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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_PLY_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_PLY_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_ply.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

inline void write_ply_header(std::ostream& out, const Sampled_wireframe& sampled, std::size_t number_of_edges,
                             bool is_binary)
{
  out << "ply\nformat " << (is_binary ? "binary_little_endian" : "ascii") << " 1.0\ncomment wireframe\n"
      << "element vertex " << std::to_string(sampled.points.size())
      << "\nproperty double x\nproperty double y\nproperty double z\n"
      << "element edge " << std::to_string(number_of_edges)
      << "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\nend_header\n";
}

inline void write_ply_point(std::ostream& out, const Coordinates& point, bool is_binary)
{
  std::string text;
  if (is_binary)
    for (const double coordinate : point)
      append_little_endian(coordinate, text);
  else
    text = to_text(point) + "\n";
  out << text;
}

inline void write_ply_edge(std::ostream& out, std::size_t first, std::size_t second, std::size_t curve, bool is_binary)
{
  std::string text;
  if (is_binary)
    for (const std::size_t index : {first, second, curve})
      append_little_endian(static_cast<std::uint32_t>(index), text);
  else
    text = std::to_string(first) + " " + std::to_string(second) + " " + std::to_string(curve) + "\n";
  out << text;
}

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_ply(std::ostream& out, const Plain_wireframe& wireframe, const Curve_sampling& sampling, bool is_binary,
               std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, sampling, sampled, error))
    return false;
  if (sampled.points.size() > static_cast<std::size_t>((std::numeric_limits<std::int32_t>::max)()))
  {
    error = "there are more points than a PLY file can number; give a larger sampling_step";
    return false;
  }
  std::size_t number_of_edges = 0;
  for (const std::vector<std::size_t>& polyline : sampled.polylines)
    number_of_edges += polyline.size() - 1;
  write_ply_header(out, sampled, number_of_edges, is_binary);
  for (const Coordinates& point : sampled.points)
    write_ply_point(out, point, is_binary);
  for (std::size_t i = 0; i < sampled.polylines.size(); ++i)
    for (std::size_t j = 0; j + 1 < sampled.polylines[i].size(); ++j)
      write_ply_edge(out, sampled.polylines[i][j], sampled.polylines[i][j + 1], i, is_binary);
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_PLY_IMPL_H
