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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_FORMATS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_FORMATS_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Polygon_soup.h>

#include <istream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

typedef CGAL::Wireframe_extraction::internal::Polygon_soup Polygon_soup;

enum class Mesh_format
{
  STL,
  OBJ,
  OFF,
  PLY,
  UNKNOWN
};

// by the extension, in lower case and with its dot
Mesh_format find_mesh_format(const std::string& extension);

// What a file is for who wants a mesh.
struct Mesh_file_content
{
  bool is_mesh = false;       // of a format for meshes only, or with faces
  bool has_distances = false; // its vertices have a property of a known name for them
};

// Looks at the beginning of a file; of what cannot be read, nothing is known.
Mesh_file_content look_at_mesh_file(const std::string& filename, Mesh_format format);

// Reads the vertices and faces of a file, whose format is what this extension stands for. Returns what is wrong, where,
// and what helps; nothing if all went well.
std::string read_mesh_file(const std::string& filename, const std::string& extension, Polygon_soup& soup);

// The same out of a stream. `name` is for messages.
std::string read_mesh_stream(std::istream& stream, Mesh_format format, const std::string& name, Polygon_soup& soup);

} // namespace internal
} // namespace IO
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/IO/internal/mesh/mesh_formats_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_FORMATS_H
