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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_READ_MESH_H
#define CGAL_WIREFRAME_EXTRACTION_IO_READ_MESH_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/mesh/mesh_formats.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {

/// \ingroup PkgWireframeExtractionIO
/// reads the vertices and faces of a mesh, as `CGAL::IO::read_polygon_soup()` does. But what is wrong with a
/// file is told, with its place, memory is only taken for what is there, and no locale has a say.
///
/// The extension of the file, in upper or lower case, decides on the format:
/// - `.stl`: ascii or binary. Each triangle has vertices of its own.
/// - `.obj`: the vertices and faces; all else is passed over.
/// - `.off`: ascii.
/// - `.ply`: ascii or binary of either byte order, with a list `vertex_indices` or `vertex_index`
/// of the element `face`.
///
/// \tparam Point a type constructible from three `double` coordinates
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param points the vertices, in the order of the file
/// \param polygons the faces: the indices of their vertices in `points`. What both held before is replaced; it is
///   left as it was if reading fails.
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong, where in the file, and what helps; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if the mesh was read and has at least one face, else `false`: the file does not exist or cannot be
///   read, its extension is unknown, it is malformed, truncated or empty, a coordinate is not finite, or a face has
///   fewer than three vertices, more than 10,000, or one that does not exist.
///
/// Reading takes time linear in the size of the file.
template <class Point, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_mesh(const std::string& filename, std::vector<Point>& points, std::vector<std::vector<std::size_t>>& polygons,
               const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  internal::Polygon_soup soup;
  if (!internal::report(np, internal::read_mesh_file(filename, internal::lower_extension(filename), soup)))
    return false;
  points.clear();
  for (const auto& p : soup.points)
    points.push_back(Point(p.x(), p.y(), p.z()));
  polygons.swap(soup.polygons);
  return true;
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_READ_MESH_H
