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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PLY_HEADER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PLY_HEADER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

enum class Ply_format
{
  ASCII,
  BINARY_LITTLE_ENDIAN,
  BINARY_BIG_ENDIAN
};

enum class Ply_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  INT64,
  UINT64,
  FLOAT32,
  FLOAT64
};

inline std::size_t size_of(Ply_type type)
{
  switch (type)
  {
  case Ply_type::INT8:
  case Ply_type::UINT8: return 1;
  case Ply_type::INT16:
  case Ply_type::UINT16: return 2;
  case Ply_type::INT32:
  case Ply_type::UINT32:
  case Ply_type::FLOAT32: return 4;
  default: return 8;
  }
}

inline bool is_floating_point(Ply_type type) { return type == Ply_type::FLOAT32 || type == Ply_type::FLOAT64; }

struct Ply_property
{
  std::string name;
  Ply_type type = Ply_type::FLOAT32;
  bool is_list = false;
  Ply_type count_type = Ply_type::UINT8; // of a list
};

struct Ply_element
{
  std::string name;
  std::uint64_t count = 0;
  std::vector<Ply_property> properties;

  bool has_list() const
  {
    for (const Ply_property& property : properties)
      if (property.is_list)
        return true;
    return false;
  }

  // bytes of an entry in a binary file; the least number of them if there are lists
  std::uint64_t entry_size() const
  {
    std::uint64_t size = 0;
    for (const Ply_property& property : properties)
      size += size_of(property.is_list ? property.count_type : property.type);
    return size;
  }

  std::vector<std::string> property_names() const
  {
    std::vector<std::string> names;
    for (const Ply_property& property : properties)
      names.push_back(property.name);
    return names;
  }
};

// The header of a PLY file: its format and what its elements are made of.
class Ply_header
{
public:
  Ply_format format = Ply_format::ASCII;
  std::vector<Ply_element> elements;
  std::vector<std::string> comments; // without the word

  // reads up to the end of the header; errors name the file and the line
  bool read(Chunked_input& input, const std::string& filename, std::string& error)
  {
    std::string_view line;
    bool is_format_known = false;
    for (;;)
    {
      const Chunked_input::Line_status status = input.next_line(line);
      const std::string place = filename + ":" + std::to_string(input.line_number()) + ": ";
      if (status != Chunked_input::Line_status::LINE)
      {
        error = filename
          + ": its PLY header has no \"end_header\" line; the file is truncated or no "
            "PLY file; get a complete copy of it";
        return false;
      }
      std::string problem;
      if (input.line_number() == 1)
        problem = (trim(line) == "ply") ? "" : "a PLY file starts with the line \"ply\", this one with " + quote(line);
      else if (trim(line) == "end_header")
        break;
      else
        problem = read_line(line, is_format_known);
      if (!problem.empty())
      {
        error = place + problem + "; correct the header, or write the file again";
        return false;
      }
    }
    if (!is_format_known)
      error = filename + ": its PLY header has no \"format\" line; add one, such as \"format ascii 1.0\"";
    return is_format_known;
  }

  // index of an element; the number of elements if there is none of that name
  std::size_t find_element(const std::string& name) const
  {
    std::size_t index = 0;
    while (index < elements.size() && elements[index].name != name)
      ++index;
    return index;
  }

  std::vector<std::string> element_names() const
  {
    std::vector<std::string> names;
    for (const Ply_element& element : elements)
      names.push_back(element.name);
    return names;
  }

private:
  // returns what is wrong with the line, nothing if all is well
  std::string read_line(std::string_view line, bool& is_format_known)
  {
    std::vector<std::string_view> words;
    split_at_blanks(line, words);
    if (words.empty() || words[0] == "obj_info")
      return "";
    if (words[0] == "comment")
    {
      const std::string_view keyword = words[0];
      comments.emplace_back(trim(line.substr(static_cast<std::size_t>(keyword.data() - line.data()) + keyword.size())));
      return "";
    }
    if (words[0] == "format")
    {
      is_format_known = true;
      return read_format(words);
    }
    if (words[0] == "element")
      return read_element(words);
    if (words[0] == "property")
      return read_property(words);
    return "unknown word " + quote(words[0]) + " in the PLY header";
  }

  std::string read_format(const std::vector<std::string_view>& words)
  {
    const std::string_view name = words.size() > 1 ? words[1] : std::string_view();
    if (name == "ascii")
      format = Ply_format::ASCII;
    else if (name == "binary_little_endian")
      format = Ply_format::BINARY_LITTLE_ENDIAN;
    else if (name == "binary_big_endian")
      format = Ply_format::BINARY_BIG_ENDIAN;
    else
      return "unknown PLY format " + quote(name) + "; known are ascii, binary_little_endian, binary_big_endian";
    return "";
  }

  std::string read_element(const std::vector<std::string_view>& words)
  {
    Ply_element element;
    if (words.size() != 3)
      return "a PLY element is written as \"element NAME COUNT\"";
    if (!parse_count(words[2], element.count))
      return quote(words[2]) + " is no valid number of " + printable(words[1]) + " entries";
    element.name = std::string(words[1]);
    if (find_element(element.name) < elements.size())
      return "element " + quote(words[1]) + " is there twice";
    elements.push_back(element);
    return "";
  }

  std::string read_property(const std::vector<std::string_view>& words)
  {
    const bool is_list = words.size() > 1 && words[1] == "list";
    if (words.size() != (is_list ? 5u : 3u))
      return "a PLY property is written as \"property TYPE NAME\" or "
             "\"property list COUNT_TYPE TYPE NAME\"";
    if (elements.empty())
      return "a property stands before the first element";
    Ply_property property;
    property.is_list = is_list;
    property.name = std::string(words.back());
    const std::string_view type = words[is_list ? 3 : 1];
    if (!find_type(type, property.type))
      return "unknown PLY type " + quote(type);
    if (is_list && (!find_type(words[2], property.count_type) || is_floating_point(property.count_type)))
      return "a list cannot be counted by the type " + quote(words[2]);
    for (const Ply_property& other : elements.back().properties)
      if (other.name == property.name)
        return "property " + quote(property.name) + " is there twice";
    elements.back().properties.push_back(property);
    return "";
  }

  static bool find_type(std::string_view name, Ply_type& type)
  {
    struct Named_type
    {
      std::string_view name;
      Ply_type type;
    };
    static const Named_type types[] = {
      {"char", Ply_type::INT8},       {"int8", Ply_type::INT8},      {"uchar", Ply_type::UINT8},
      {"uint8", Ply_type::UINT8},     {"short", Ply_type::INT16},    {"int16", Ply_type::INT16},
      {"ushort", Ply_type::UINT16},   {"uint16", Ply_type::UINT16},  {"int", Ply_type::INT32},
      {"int32", Ply_type::INT32},     {"uint", Ply_type::UINT32},    {"uint32", Ply_type::UINT32},
      {"int64", Ply_type::INT64},     {"uint64", Ply_type::UINT64},  {"float", Ply_type::FLOAT32},
      {"float32", Ply_type::FLOAT32}, {"double", Ply_type::FLOAT64}, {"float64", Ply_type::FLOAT64}};
    for (const Named_type& known : types)
      if (known.name == name)
      {
        type = known.type;
        return true;
      }
    return false;
  }
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PLY_HEADER_H
