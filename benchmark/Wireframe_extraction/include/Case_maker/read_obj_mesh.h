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

#ifndef CASE_MAKER_READ_OBJ_MESH_H
#define CASE_MAKER_READ_OBJ_MESH_H

#include <Case_maker/Annotated_shape.h>
#include <Case_maker/Case_error.h>

#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace Case_maker {

/// returns what a file holds.
inline std::string read_file(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path))
    throw bad_input("cannot read '" + path + "'; is it a file, and may it be read?");
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (in.bad())
    throw bad_input("reading '" + path + "' failed");
  return text;
}

namespace internal {

/// Reads the vertices and triangles of a Wavefront OBJ file; all else in it is passed over.
class Obj_reader
{
public:
  explicit Obj_reader(const std::string& path) : m_path(path), m_text(read_file(m_path)) {}

  Labelled_mesh mesh()
  {
    Labelled_mesh result;
    std::vector<std::size_t> lines; // of the triangles
    const char* p = m_text.c_str();
    const char* const end = p + m_text.size();
    for (m_line = 1; p < end; ++m_line)
    {
      const char* next = p;
      while (next < end && *next != '\n')
        ++next;
      skip_blanks(p);
      if (p[0] == 'v' && is_blank(p[1]))
        result.points.push_back(vertex(p + 1));
      else if (p[0] == 'f' && is_blank(p[1]))
      {
        result.triangles.push_back(triangle(p + 1, result.points.size()));
        lines.push_back(m_line);
      }
      p = next + 1;
    }
    for (std::size_t i = 0; i < result.triangles.size(); ++i)
      for (std::uint32_t v : result.triangles[i])
        if (v >= result.points.size())
          throw bad_input(m_path, lines[i],
                          "vertex " + std::to_string(v + 1) + " does not exist; there are "
                            + std::to_string(result.points.size()));
    if (result.triangles.empty())
      throw bad_input("'" + m_path + "' has no faces; is it a mesh in OBJ format?");
    return result;
  }

private:
  static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  static bool is_end(char c) { return c == '\n' || c == '\r' || c == '\0' || c == '#'; }

  static void skip_blanks(const char*& p)
  {
    while (is_blank(*p))
      ++p;
  }

  Point vertex(const char* p) const
  {
    Point result;
    for (double& x : result)
    {
      skip_blanks(p);
      char* end = nullptr;
      x = is_end(*p) ? 0. : std::strtod(p, &end);
      if (end == p || end == nullptr || !std::isfinite(x) || !(is_blank(*end) || is_end(*end)))
        throw bad_input(m_path, m_line, "a vertex needs three finite numbers");
      p = end;
    }
    return result;
  }

  Triangle triangle(const char* p, std::size_t vertices) const
  {
    Triangle result = {{0, 0, 0}};
    std::size_t n = 0;
    for (skip_blanks(p); !is_end(*p); skip_blanks(p), ++n)
    {
      char* end = nullptr;
      long long index = std::strtoll(p, &end, 10);
      if (end == p || !(is_blank(*end) || is_end(*end) || *end == '/'))
        throw bad_input(m_path, m_line, "a face needs the numbers of its vertices");
      if (index < 0)
        index += static_cast<long long>(vertices) + 1;
      if (index < 1 || index > 0xffffffffll)
        throw bad_input(m_path, m_line, "a face names a vertex that cannot exist; the first has the number 1");
      if (n < 3)
        result[n] = static_cast<std::uint32_t>(index - 1);
      for (p = end; !is_blank(*p) && !is_end(*p);)
        ++p;
    }
    if (n != 3)
      throw bad_input(m_path, m_line,
                      "the face has " + std::to_string(n)
                        + " vertices; triangulate the mesh, "
                          "without changing the order of its faces");
    return result;
  }

  std::string m_path, m_text;
  std::size_t m_line = 0;
};

} // namespace internal

/// reads a triangle mesh from a Wavefront OBJ file. Its patches are empty.
inline Labelled_mesh read_obj_mesh(const std::string& path) { return internal::Obj_reader(path).mesh(); }

} // namespace Case_maker

#endif // CASE_MAKER_READ_OBJ_MESH_H
