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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_FORMATS_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_FORMATS_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Ply_header.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/property_names.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/mesh/Mesh_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/mesh/mesh_formats.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <istream>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE Mesh_format find_mesh_format(const std::string& extension)
{
  return extension == ".stl" ? Mesh_format::STL
    : extension == ".obj"    ? Mesh_format::OBJ
    : extension == ".off"    ? Mesh_format::OFF
    : extension == ".ply"    ? Mesh_format::PLY
                             : Mesh_format::UNKNOWN;
}

// what the header of a PLY file says
inline Mesh_file_content look_at_ply(Chunked_input& input, const std::string& filename)
{
  Mesh_file_content content;
  Ply_header header;
  std::string error;
  if (!header.read(input, filename, error))
    return content;
  for (const Ply_element& element : header.elements)
  {
    const std::vector<std::string> names = element.property_names();
    if (element.name == "face" || element.name == "faces")
      content.is_mesh = element.count > 0;
    if (element.name == "vertex" || element.name == "vertices")
      content.has_distances = find_distance_name(names, std::string()) < names.size();
  }
  return content;
}

// whether the header of an OFF file promises faces
inline bool promises_faces(Chunked_input& input)
{
  std::string_view line;
  std::vector<std::string_view> words;
  std::vector<std::uint64_t> counts;
  for (bool is_keyword = true; counts.size() < 2;)
  {
    if (input.next_line(line) != Chunked_input::Line_status::LINE)
      return false;
    split_at_blanks(line.substr(0, line.find('#')), words);
    for (std::size_t i = 0; i < words.size(); ++i, is_keyword = false)
    {
      std::uint64_t count = 0;
      if (is_keyword)
        continue;
      if (!parse_count(words[i], count))
        return false;
      counts.push_back(count);
    }
  }
  return counts[1] > 0;
}

CGAL_WIREFRAME_EXTRACTION_INLINE Mesh_file_content look_at_mesh_file(const std::string& filename, Mesh_format format)
{
  Mesh_file_content content;
  content.is_mesh = format == Mesh_format::STL || format == Mesh_format::OBJ;
  std::ifstream stream;
  std::string error;
  if (content.is_mesh || format == Mesh_format::UNKNOWN || !open_input_file(filename, stream, error))
    return content;
  Chunked_input input(stream);
  if (format == Mesh_format::PLY)
    return look_at_ply(input, filename);
  content.is_mesh = promises_faces(input);
  return content;
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::string read_mesh_stream(std::istream& stream, Mesh_format format,
                                                              const std::string& name, Polygon_soup& soup)
{
  try
  {
    Polygon_soup result;
    Mesh_reader reader(stream, name, result);
    if (!reader.read(format))
      return reader.error();
    soup = std::move(result);
    return std::string();
  }
  catch (const std::bad_alloc&)
  {
    return name + ": there is not enough memory for its mesh";
  }
  catch (const std::length_error&)
  {
    return name + ": there is not enough memory for its mesh";
  }
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::string read_mesh_file(const std::string& filename, const std::string& extension,
                                                            Polygon_soup& soup)
{
  const Mesh_format format = find_mesh_format(extension);
  if (format == Mesh_format::UNKNOWN)
    return filename + ": unknown extension " + quote(lower_extension(filename))
      + " of a mesh; known are .stl .obj .off .ply";
  std::ifstream stream;
  std::string error;
  if (!open_input_file(filename, stream, error))
    return error;
  return read_mesh_stream(stream, format, filename, soup);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_FORMATS_IMPL_H
