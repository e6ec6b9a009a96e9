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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_VTP_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_VTP_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_utils.h>

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

template <class GeomTraits>
void write_vtp_cells_data(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe)
{
  typedef Wireframe_curve<GeomTraits> Curve;
  typedef Wireframe_conic<GeomTraits> Conic;
  const auto add = [&](const std::string& type, const std::string& name, const std::string& of_vertex,
                       const auto& value) {
    write_vtp_cell_data(out, type, name, wireframe.vertices.size(), of_vertex, wireframe.curves, value);
  };
  const auto text = [](const auto& number) { return number_to_string(CGAL::to_double(number)); };
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

template <class GeomTraits, class NamedParameters>
bool write_vtp(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
               std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, np, sampled, error))
    return false;
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n"
         "<FieldData>\n";
  write_vtp_array(out, "Float64", "sampling_distance", " NumberOfTuples=\"1\"",
                  [&]() { out << number_to_string(CGAL::to_double(wireframe.sampling_distance)) << "\n"; });
  write_vtp_array(out, "String", "unit", " NumberOfTuples=\"1\"",
                  [&]() { out << vtp_codes(symbol_of(get_length_unit(np))) << "\n"; });
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

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the XML format of VTK for polygonal data (ascii), for instance for
/// ParaView.
///
/// Every vertex of the wireframe is a cell of one point, and every curve a polyline; the vertices come first,
/// and are the first points, in their order. Curves that share a vertex share its point, and a closed
/// polyline ends with the point it starts with. Each cell has the data `index` (of the curve), `type` (the
/// value of `Wireframe_curve_type` as an integer, from 0 for a B-spline to 5 for an elliptic arc),
/// `type_name`, `closed`, `source`, `target`, `length`, `radius` (the major one of an ellipse) and
/// `minor_radius`, `rms`, `max` and `support`. Where there is no index or type it is -1, where there is no
/// radius it is 0, and a vertex has the `type_name` "vertex". The sampling distance and the unit are field
/// data. Numbers have all digits.
///
/// The format does not hold the curves themselves, nor center, axis, angles and uncertainty of circles and
/// ellipses.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{sampling_step}
///     \cgalParamDescription{the largest arc length between two neighbouring points of a curve}
///     \cgalParamType{`GeomTraits::FT`}
///     \cgalParamDefault{0.25 times the sampling distance of the wireframe; one hundredth of the longest
///                       curve if that is 0}
///     \cgalParamExtra{in the unit of the wireframe; has to be positive. A curve is split evenly into as few
///                     pieces as that allows, a closed one into three at least.}
///   \cgalParamNEnd
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; its symbol, such as "mm", is written as the
///                           field `unit`}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the stream cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_vtp(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_vtp(out, wireframe, np, error); });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the XML format of VTK for polygonal data (ascii), for instance for
/// ParaView.
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{sampling_step}
///     \cgalParamDescription{the largest arc length between two neighbouring points of a curve}
///     \cgalParamType{`GeomTraits::FT`}
///     \cgalParamDefault{0.25 times the sampling distance of the wireframe; one hundredth of the longest
///                       curve if that is 0}
///     \cgalParamExtra{in the unit of the wireframe; has to be positive. A curve is split evenly into as few
///                     pieces as that allows, a closed one into three at least.}
///   \cgalParamNEnd
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; its symbol, such as "mm", is written as the
///                           field `unit`}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_vtp(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_vtp(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_VTP_H
