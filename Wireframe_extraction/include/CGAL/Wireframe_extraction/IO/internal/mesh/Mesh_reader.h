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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Ply_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Ply_header.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/property_names.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/mesh/mesh_formats.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Reads vertices and faces of STL, OBJ, OFF and PLY. Neither a header that promises too much nor a locale has a say,
// for which the readers of CGAL are not made; and what is wrong is told with its place.
class Mesh_reader : private Chunked_cloud_reader
{
public:
  Mesh_reader(std::istream& stream, const std::string& filename, Polygon_soup& soup)
    : Chunked_cloud_reader(stream, filename, no_options(), "a mesh"), m_soup(soup)
  {}

  bool read(Mesh_format format) { return check_start() && read_format(format) && check_soup(); }

  using Chunked_cloud_reader::error;

private:
  typedef CGAL::Wireframe_extraction::internal::Vector Vector;

  static constexpr std::size_t most_vertices_of_face = 10000; // more than that is damage, or takes ages to triangulate

  static const Cloud_reader_options& no_options()
  {
    static const Cloud_reader_options options;
    return options;
  }

  bool read_format(Mesh_format format)
  {
    switch (format)
    {
    case Mesh_format::STL: return is_binary_stl() ? read_binary_stl() : read_ascii_stl();
    case Mesh_format::OBJ: return read_obj();
    case Mesh_format::OFF: return read_off();
    default: return read_ply();
    }
  }

  // ---- what all formats have ----

  // `line` is 0 in binary files
  bool add_point(const Vector& p, std::size_t line)
  {
    static constexpr double largest = 1e150; // such that areas are finite
    if (p.allFinite() && p.cwiseAbs().maxCoeff() < largest)
    {
      m_soup.points.push_back(p);
      return true;
    }
    return fail(place(line) + "vertex " + std::to_string(m_soup.points.size()) + " (counted from 0) is at "
                + number_to_string(p.x()) + " " + number_to_string(p.y()) + " " + number_to_string(p.z())
                + "; coordinates have to be finite: repair the mesh, or write it again");
  }

  bool add_face(const std::vector<std::size_t>& face, std::size_t line)
  {
    if (face.size() < 3)
      return fail(place(line) + "a face with " + plural(face.size(), "vertex", "vertices")
                  + "; three are needed: repair the mesh, or write it again");
    if (face.size() > most_vertices_of_face)
      return fail(place(line) + "a face with " + std::to_string(face.size()) + " vertices; at most "
                  + std::to_string(most_vertices_of_face) + " are read: triangulate the mesh");
    m_soup.polygons.push_back(face);
    m_lines.push_back(line);
    return true;
  }

  std::string place(std::size_t line) const
  {
    return m_filename + (line > 0 ? ":" + std::to_string(line) : std::string()) + ": ";
  }

  // once all is there, as faces may come before their vertices
  bool check_soup()
  {
    const std::size_t number = m_soup.points.size();
    for (std::size_t i = 0; i < m_soup.polygons.size(); ++i)
      for (std::size_t v : m_soup.polygons[i])
        if (v >= number)
          return fail(place(m_lines[i]) + "face " + std::to_string(i) + " (counted from 0) has the vertex "
                      + std::to_string(v) + " (counted from 0), but there are only " + std::to_string(number)
                      + ": the file is truncated or damaged; get a complete copy of it");
    if (!m_soup.polygons.empty())
      return true;
    return fail(m_filename + ": holds "
                + (number == 0 ? "no faces; write the mesh into it again"
                               : plural(number, "vertex", "vertices")
                       + " and no faces, so it is a cloud of points and no mesh; write these points as .ply or .xyz "
                         "(x y z in each line) to have them read as a cloud, or write the mesh into it again"));
  }

  bool parse_point(const std::vector<std::string_view>& words, std::size_t first, Vector& p)
  {
    if (words.size() < first + 3)
      return fail_at_line("a vertex with only " + plural(words.size() - first, "value", "values")
                          + "; x, y and z are needed");
    for (std::size_t i = 0; i < 3; ++i)
      if (!parse_number(words[first + i], p[static_cast<int>(i)]))
        return fail_at_line("a coordinate is " + no_number_text(words[first + i]));
    return true;
  }

  bool fail_at_face()
  {
    return fail_at_line("the face needs the numbers of its vertices; repair the line, or write the mesh again");
  }

  // ---- STL ----

  static constexpr std::size_t stl_header = 84, stl_facet = 50; // bytes

  // A file of the right size is binary, whatever it starts with, as some headers start with "solid". Otherwise it is
  // text if it is one.
  bool is_binary_stl()
  {
    const std::size_t size = m_input.require(1024);
    const std::string_view begin(m_input.data(), size);
    if (size >= stl_header && m_input.is_size_known()
        && m_input.size() == stl_header + stl_facet * std::uint64_t(stl_count()))
      return true;
    const bool is_text = std::all_of(begin.begin(), begin.end(), [](char c) {
      return static_cast<unsigned char>(c) >= 32 || c == '\n' || c == '\r' || c == '\t';
    });
    const std::size_t word = begin.find_first_not_of(" \t\r\n");
    return !is_text || word == std::string_view::npos || to_lower(begin.substr(word, 5)) != "solid";
  }

  std::uint32_t stl_count() { return load_little_endian<std::uint32_t>(m_input.data() + 80); }

  bool read_binary_stl()
  {
    if (m_input.require(stl_header) < stl_header)
      return fail(m_filename
                  + ": is no STL file: one starts with \"solid\", or with 84 bytes before its facets; get a "
                    "complete copy of the file");
    const std::uint32_t count = stl_count();
    if (m_input.is_size_known() && m_input.size() != stl_header + stl_facet * std::uint64_t(count))
      return fail(m_filename + ": its header promises " + plural(count, "facet", "facets") + " = "
                  + std::to_string(stl_header + stl_facet * std::uint64_t(count)) + " bytes, but the file has "
                  + std::to_string(m_input.size())
                  + ": it is truncated or its header is wrong; get a complete copy of the file, or write it again");
    m_input.consume(stl_header);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      if (m_input.require(stl_facet) < stl_facet)
        return fail_truncated("after " + std::to_string(i) + " of " + std::to_string(count) + " facets");
      std::vector<std::size_t> face;
      for (int k = 0; k < 3; ++k)
      {
        Vector p;
        for (int j = 0; j < 3; ++j)
          p[j] = load_little_endian<float>(m_input.data() + 12 + 12 * k + 4 * j);
        face.push_back(m_soup.points.size());
        if (!add_point(p, 0))
          return false;
      }
      if (!add_face(face, 0))
        return false;
      m_input.consume(stl_facet);
    }
    return true;
  }

  bool read_ascii_stl()
  {
    std::vector<std::string_view> words;
    std::vector<std::size_t> face;
    bool is_in_facet = false, is_ended = false;
    while (next_words(words, false))
    {
      const std::string word = to_lower(words[0]);
      if (word == "vertex")
      {
        Vector p;
        face.push_back(m_soup.points.size());
        if (!parse_point(words, 1, p) || !add_point(p, m_input.line_number()))
          return false;
      }
      else if (word == "facet")
      {
        face.clear();
        is_in_facet = true;
      }
      else if (word == "endfacet")
      {
        if (!is_in_facet || !add_face(face, m_input.line_number()))
          return is_in_facet ? false : fail_at_line("\"endfacet\" without \"facet\"; repair the mesh");
        is_in_facet = false;
      }
      else if (word == "endsolid" || word == "solid")
        is_ended = word == "endsolid";
      else if (word != "outer" && word != "endloop")
        return fail_at_line("unknown word " + quote(words[0]) + " in a text STL file; repair it, or write it again");
    }
    return (!is_in_facet && is_ended && error().empty())
      || fail_truncated("after " + plural(m_soup.polygons.size(), "facet", "facets") + ", without \"endsolid\"");
  }

  // ---- OBJ ----

  bool read_obj()
  {
    std::vector<std::string_view> words;
    std::vector<std::size_t> face;
    while (next_words(words, true))
    {
      if (words.back() == "\\")
        return fail_at_line("a line that goes on in the next one, which is not read; write the mesh again without");
      if (words[0] == "v")
      {
        Vector p;
        if (!parse_point(words, 1, p) || !add_point(p, m_input.line_number()))
          return false;
      }
      else if (words[0] == "f" || words[0] == "fo")
      {
        face.clear();
        for (std::size_t i = 1; i < words.size(); ++i)
          if (!parse_obj_index(words[i].substr(0, words[i].find('/')), face))
            return false;
        if (!add_face(face, m_input.line_number()))
          return false;
      }
    }
    return error().empty();
  }

  // counted from 1, or backwards from the last one
  bool parse_obj_index(std::string_view text, std::vector<std::size_t>& face)
  {
    long long index = 0;
    const char* const last = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), last, index);
    if (text.empty() || result.ptr != last || result.ec != std::errc())
      return fail_at_face();
    if (index < 0)
      index += static_cast<long long>(m_soup.points.size()) + 1;
    if (index < 1)
      return fail_at_line("the face has a vertex before the first one; the first has the number 1: repair the line");
    face.push_back(static_cast<std::size_t>(index - 1));
    return true;
  }

  // ---- OFF ----

  // the counts of vertices and faces in the words that follow the keyword
  bool read_off_header(std::uint64_t& vertices, std::uint64_t& faces)
  {
    std::vector<std::string_view> words;
    if (!next_words(words, true))
      return fail_truncated("before its header");
    const std::string_view keyword = words[0];
    if (keyword.size() < 3 || keyword.substr(keyword.size() - 3) != "OFF" || keyword.find('4') == 0
        || keyword.find('n') == 0)
      return fail_at_line("an OFF file starts with OFF, COFF, NOFF or the like, this one with " + quote(keyword)
                          + "; vertices with more than three coordinates are not read");
    if (words.size() > 1 && words[1] == "BINARY")
      return fail_at_line("binary OFF files are not read; write it as ascii OFF, or as PLY");
    words.erase(words.begin());
    if (words.empty() && !next_words(words, true))
      return fail_truncated("before its number of vertices");
    if (words.size() < 2 || !parse_count(words[0], vertices) || !parse_count(words[1], faces))
      return fail_at_line("the numbers of vertices, faces and edges are expected, found " + quote(words[0])
                          + "; write them there");
    return true;
  }

  bool read_off()
  {
    std::uint64_t vertices = 0, faces = 0;
    if (!read_off_header(vertices, faces))
      return false;
    std::vector<std::string_view> words;
    for (std::uint64_t i = 0; i < vertices; ++i)
    {
      Vector p;
      if (!next_words(words, true))
        return fail_truncated("after " + std::to_string(i) + " of " + std::to_string(vertices) + " vertices");
      if (!parse_point(words, 0, p) || !add_point(p, m_input.line_number()))
        return false;
    }
    std::vector<std::size_t> face;
    for (std::uint64_t i = 0; i < faces; ++i)
    {
      std::size_t number = 0;
      if (!next_words(words, true))
        return fail_truncated("after " + std::to_string(i) + " of " + std::to_string(faces) + " faces");
      if (!parse_count(words[0], number) || number >= words.size())
        return fail_at_face();
      face.resize(number);
      for (std::size_t k = 0; k < number; ++k)
        if (!parse_count(words[1 + k], face[k]))
          return fail_at_face();
      if (!add_face(face, m_input.line_number()))
        return false;
    }
    return true;
  }

  // ---- PLY ----

  bool read_ply()
  {
    Ply_header header;
    if (!header.read(m_input, m_filename, m_error))
      return false;
    const bool is_swapped = (header.format == Ply_format::BINARY_LITTLE_ENDIAN) != is_host_little_endian();
    for (const Ply_element& element : header.elements)
      if (!read_ply_element(element, header.format == Ply_format::ASCII, is_swapped))
        return false;
    return !m_soup.points.empty() || fail(m_filename + ": holds no vertices; write the mesh into it again");
  }

  bool read_ply_element(const Ply_element& element, bool is_ascii, bool is_swapped)
  {
    const bool is_vertex = element.name == "vertex" || element.name == "vertices";
    const bool is_face = element.name == "face" || element.name == "faces";
    const std::vector<std::string> names = element.property_names();
    std::array<std::size_t, 3> wanted = {{0, 0, 0}};
    static const char* const coordinates[] = {"x", "y", "z"};
    for (std::size_t k = 0; is_vertex && k < 3; ++k)
    {
      wanted[k] = find_name(names, coordinates[k]);
      if (wanted[k] == names.size() || element.properties[wanted[k]].is_list)
        return fail(m_filename + ": its vertices have no property " + quote(coordinates[k])
                    + "; they have: " + join(names));
    }
    std::size_t list = names.size();
    for (const char* const name : {"vertex_index", "vertex_indices"})
      if (is_face && find_name(names, name) < names.size())
        list = find_name(names, name);
    if (is_face && (list == names.size() || !element.properties[list].is_list))
      return fail(m_filename + ": its faces have no list \"vertex_indices\"; they have: " + join(names));
    if (element.properties.empty())
      return true;
    std::vector<double> values(names.size());
    std::vector<std::size_t> face;
    for (std::uint64_t i = 0; i < element.count; ++i)
    {
      face.clear();
      if (is_ascii ? !read_ply_line(element, list, values, face)
                   : !read_ply_bytes(element, list, is_swapped, values, face))
        return fail_truncated("after " + std::to_string(i) + " of " + std::to_string(element.count) + " entries of "
                              + quote(element.name));
      const std::size_t line = is_ascii ? m_input.line_number() : 0;
      if (is_vertex && !add_point(Vector(values[wanted[0]], values[wanted[1]], values[wanted[2]]), line))
        return false;
      if (is_face && !add_face(face, line))
        return false;
    }
    return true;
  }

  bool add_ply_index(double value, std::vector<std::size_t>& face)
  {
    if (!(value >= 0. && value < 1e15) || value != std::floor(value))
      return fail((m_input.line_number() > 0 ? place(m_input.line_number()) : place(0)) + "face "
                  + std::to_string(m_soup.polygons.size()) + " (counted from 0) has the vertex "
                  + number_to_string(value) + ", which cannot exist; repair the mesh, or write it again");
    face.push_back(static_cast<std::size_t>(value));
    return true;
  }

  bool read_ply_line(const Ply_element& element, std::size_t list, std::vector<double>& values,
                     std::vector<std::size_t>& face)
  {
    std::vector<std::string_view> words;
    if (!next_words(words, false))
      return false;
    std::size_t position = 0;
    for (std::size_t i = 0; i < element.properties.size(); ++i)
    {
      if (position >= words.size())
        return fail_at_line("a line of " + quote(element.name) + " with too few values; complete it");
      std::uint64_t count = 1;
      if (element.properties[i].is_list && !parse_count(words[position++], count))
        return fail_at_line("the number of entries of " + quote(element.properties[i].name) + " is "
                            + no_number_text(words[position - 1]));
      if (count > words.size() - position)
        return fail_at_line("the list " + quote(element.properties[i].name)
                            + " is shorter than it says; correct the "
                              "line");
      for (std::uint64_t k = 0; k < count; ++k)
      {
        if (!parse_number(words[position++], values[i]))
          return fail_at_line("the property " + quote(element.properties[i].name) + " is "
                              + no_number_text(words[position - 1]));
        if (i == list && !add_ply_index(values[i], face))
          return false;
      }
    }
    return true;
  }

  bool read_ply_bytes(const Ply_element& element, std::size_t list, bool is_swapped, std::vector<double>& values,
                      std::vector<std::size_t>& face)
  {
    for (std::size_t i = 0; i < element.properties.size(); ++i)
    {
      const Ply_property& property = element.properties[i];
      double count = 1.;
      if (property.is_list && !next_number(property.count_type, is_swapped, count))
        return false;
      if (!(count >= 0.) || (i == list && count > double(most_vertices_of_face)))
        return fail(m_filename + ": the list " + quote(property.name) + " of " + quote(element.name)
                    + " claims to have " + number_to_string(count)
                    + " entries: the file is damaged or its header is wrong; get a complete copy of it");
      for (double k = 0.; k < count; ++k)
      {
        if (!next_number(property.type, is_swapped, values[i]))
          return false;
        if (i == list && !add_ply_index(values[i], face))
          return false;
      }
    }
    return true;
  }

  bool next_number(Ply_type type, bool is_swapped, double& value)
  {
    const std::size_t size = size_of(type);
    if (m_input.require(size) < size)
      return false;
    value = load_number(type, m_input.data(), is_swapped);
    m_input.consume(size);
    return true;
  }

  Polygon_soup& m_soup;
  std::vector<std::size_t> m_lines; // of the faces, 0 in binary files
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_MESH_MESH_READER_H
