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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_VTP_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_VTP_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_vtp.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// a list of numbers; `attributes` are those of the element beside the name and the format
template <class Write_values>
void write_vtp_array(std::ostream& out, const std::string& type, const std::string& name, const std::string& attributes,
                     const Write_values& write_values)
{
  const std::string element = (type == "String" ? "Array" : "DataArray");
  out << "<" << element << " type=\"" << type << "\" Name=\"" << name << "\"" << attributes << " format=\"ascii\">\n";
  write_values();
  out << "</" << element << ">\n";
}

// VTK writes text as the codes of its characters, with a 0 at the end
inline std::string vtp_codes(const std::string& text)
{
  std::string codes;
  for (const char c : text)
    codes += std::to_string(static_cast<int>(c)) + " ";
  return codes + "0";
}

// An array with a value per cell: the vertices come first, then the curves.
template <class Curve, class Value>
void write_vtp_cell_data(std::ostream& out, const std::string& type, const std::string& name,
                         std::size_t number_of_vertices, const std::string& value_of_vertex,
                         const std::vector<Curve>& curves, const Value& value)
{
  write_vtp_array(out, type, name, "", [&]() {
    for (std::size_t i = 0; i < number_of_vertices; ++i)
      out << value_of_vertex << "\n";
    for (std::size_t i = 0; i < curves.size(); ++i)
      out << value(i, curves[i]) << "\n";
  });
}

inline void write_vtp_cells_data(std::ostream& out, const Plain_wireframe& wireframe)
{
  typedef Plain_curve Curve;
  typedef Plain_conic Conic;
  const auto add = [&](const std::string& type, const std::string& name, const std::string& of_vertex,
                       const auto& value) {
    write_vtp_cell_data(out, type, name, wireframe.vertices.size(), of_vertex, wireframe.curves, value);
  };
  const auto text = [](const auto& number) { return number_to_string(number); };
  const auto vertex = [](std::size_t index) {
    return index == Curve::no_vertex ? std::string("-1") : std::to_string(index);
  };
  const auto radius = [&](const Curve& curve, const auto member) {
    return curve.conic ? text((*curve.conic).*member) : std::string("0");
  };
  add("Int64", "index", "-1", [](std::size_t i, const Curve&) { return std::to_string(i); });
  add("Int32", "type", "-1", [](std::size_t, const Curve& c) { return std::to_string(static_cast<int>(c.type)); });
  add("String", "type_name", vtp_codes("vertex"),
      [](std::size_t, const Curve& c) { return vtp_codes(to_string(c.type)); });
  add("Int32", "closed", "0", [](std::size_t, const Curve& c) { return std::string(c.is_closed() ? "1" : "0"); });
  add("Int64", "source", "-1", [&](std::size_t, const Curve& c) { return vertex(c.source); });
  add("Int64", "target", "-1", [&](std::size_t, const Curve& c) { return vertex(c.target); });
  add("Float64", "length", "0", [&](std::size_t, const Curve& c) { return text(c.length()); });
  add("Float64", "radius", "0", [&](std::size_t, const Curve& c) { return radius(c, &Conic::major_radius); });
  add("Float64", "minor_radius", "0", [&](std::size_t, const Curve& c) { return radius(c, &Conic::minor_radius); });
  add("Float64", "rms", "0", [&](std::size_t, const Curve& c) { return text(c.rms); });
  add("Float64", "max", "0", [&](std::size_t, const Curve& c) { return text(c.max); });
  add("Int64", "support", "0", [](std::size_t, const Curve& c) { return std::to_string(c.support); });
}

// each vertex is a cell of one point
inline void write_vtp_vertices(std::ostream& out, std::size_t count)
{
  out << "<Verts>\n";
  write_vtp_array(out, "Int64", "connectivity", "", [&]() {
    for (std::size_t i = 0; i < count; ++i)
      out << std::to_string(i) << "\n";
  });
  write_vtp_array(out, "Int64", "offsets", "", [&]() {
    for (std::size_t i = 0; i < count; ++i)
      out << std::to_string(i + 1) << "\n";
  });
  out << "</Verts>\n";
}

inline void write_vtp_lines(std::ostream& out, const std::vector<std::vector<std::size_t>>& polylines)
{
  out << "<Lines>\n";
  write_vtp_array(out, "Int64", "connectivity", "", [&]() {
    for (const std::vector<std::size_t>& polyline : polylines)
    {
      for (const std::size_t index : polyline)
        out << std::to_string(index) << " ";
      out << "\n";
    }
  });
  write_vtp_array(out, "Int64", "offsets", "", [&]() {
    std::size_t offset = 0;
    for (const std::vector<std::size_t>& polyline : polylines)
      out << std::to_string(offset += polyline.size()) << "\n";
  });
  out << "</Lines>\n";
}

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_vtp(std::ostream& out, const Plain_wireframe& wireframe, const Curve_sampling& sampling,
               Wireframe_extraction::Length_unit unit, std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, sampling, sampled, error))
    return false;
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
         "<FieldData>\n";
  write_vtp_array(out, "Float64", "sampling_distance", " NumberOfTuples=\"1\"",
                  [&]() { out << number_to_string(wireframe.sampling_distance) << "\n"; });
  write_vtp_array(out, "String", "unit", " NumberOfTuples=\"1\"", [&]() { out << vtp_codes(symbol_of(unit)) << "\n"; });
  out << "</FieldData>\n<Piece NumberOfPoints=\"" << std::to_string(sampled.points.size()) << "\" NumberOfVerts=\""
      << std::to_string(wireframe.vertices.size()) << "\" NumberOfLines=\"" << std::to_string(wireframe.curves.size())
      << "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<CellData Scalars=\"type\">\n";
  write_vtp_cells_data(out, wireframe);
  out << "</CellData>\n<Points>\n";
  write_vtp_array(out, "Float64", "Points", " NumberOfComponents=\"3\"", [&]() {
    for (const Coordinates& point : sampled.points)
      out << to_text(point) << "\n";
  });
  out << "</Points>\n";
  write_vtp_vertices(out, wireframe.vertices.size());
  write_vtp_lines(out, sampled.polylines);
  out << "</Piece>\n</PolyData>\n</VTKFile>\n";
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_VTP_IMPL_H
