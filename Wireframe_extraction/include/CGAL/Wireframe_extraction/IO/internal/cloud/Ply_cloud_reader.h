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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PLY_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PLY_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Ply_header.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/property_names.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <CGAL/config.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

inline double load_number(Ply_type type, const char* bytes, bool is_swapped)
{
  switch (type)
  {
  case Ply_type::INT8: return load_as<std::int8_t>(bytes, is_swapped);
  case Ply_type::UINT8: return load_as<std::uint8_t>(bytes, is_swapped);
  case Ply_type::INT16: return load_as<std::int16_t>(bytes, is_swapped);
  case Ply_type::UINT16: return load_as<std::uint16_t>(bytes, is_swapped);
  case Ply_type::INT32: return load_as<std::int32_t>(bytes, is_swapped);
  case Ply_type::UINT32: return load_as<std::uint32_t>(bytes, is_swapped);
  case Ply_type::INT64: return static_cast<double>(load_as<std::int64_t>(bytes, is_swapped));
  case Ply_type::UINT64: return static_cast<double>(load_as<std::uint64_t>(bytes, is_swapped));
  case Ply_type::FLOAT32: return load_as<float>(bytes, is_swapped);
  default: return load_as<double>(bytes, is_swapped);
  }
}

// Reads the points and distances of a PLY file and hands them out chunk by chunk, so that neither a huge
// file nor a header that promises one needs memory.
class Ply_cloud_reader : private Chunked_cloud_reader
{
public:
  Ply_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options)
    : Chunked_cloud_reader(stream, filename, options, "an ascii PLY file")
  {}

  // reads the header and checks it against the size of the file
  bool read_header()
  {
    if (!check_start())
      return false;
    if (!m_header.read(m_input, m_filename, m_error))
      return false;
    m_vertex_element = m_header.find_element("vertex");
    if (m_vertex_element == m_header.elements.size())
      return fail(m_filename + ": its PLY header has no element \"vertex\"; it has: " + join(m_header.element_names()));
    if (!find_wanted_properties())
      return false;
    const bool is_little_endian = (m_header.format == Ply_format::BINARY_LITTLE_ENDIAN);
    m_swaps_bytes = is_binary() && is_little_endian != is_host_little_endian();
    return !is_binary() || is_size_plausible();
  }

  // number of points the header promises
  std::uint64_t number_of_vertices() const { return m_header.elements[m_vertex_element].count; }

  // number of points that can be reserved: what the header promises if the size of the file supports it
  std::size_t trusted_number_of_vertices() const
  {
    return (is_binary() && m_input.is_size_known()) ? static_cast<std::size_t>(number_of_vertices()) : 0;
  }

  // reads all points after `read_header()`; `sink(first, last)` gets chunk after chunk of usable samples, and
  // stops the reading by returning `false`
  bool read(Sample_sink& sink)
  {
    const bool is_none_found = m_options.looks_for_distances() && m_number_of_wanted == 3;
    sink.describe(m_options.distances != nullptr || m_number_of_wanted == 4,
                  is_none_found ? no_distance_note(m_header.elements[m_vertex_element].property_names())
                                : std::string(),
                  m_number_of_wanted == 4
                    ? "the property " + quote(m_header.elements[m_vertex_element].properties[m_wanted[3].index].name)
                    : std::string());
    for (std::size_t i = 0; i < m_vertex_element; ++i)
      if (!skip_element(m_header.elements[i]))
        return fail_truncated("in the element " + quote(m_header.elements[i].name) + ", before the vertices");
    if (!(is_binary() ? read_binary_vertices(sink) : read_ascii_vertices(sink)))
      return false;
    return is_end_as_promised() && m_filter.is_cloud_usable(m_filename, m_error);
  }

  using Chunked_cloud_reader::filter;
  using Chunked_cloud_reader::error;

private:
  struct Wanted_property
  {
    std::size_t index = 0;  // among the properties
    std::size_t offset = 0; // in a binary entry without lists
    Ply_type type = Ply_type::FLOAT32;
  };

  bool is_binary() const { return m_header.format != Ply_format::ASCII; }

  bool find_wanted_properties()
  {
    const Ply_element& vertex = m_header.elements[m_vertex_element];
    const std::vector<std::string> names = vertex.property_names();
    m_number_of_wanted = m_options.looks_for_distances() ? 4 : 3;
    const std::vector<std::string>& wanted = m_options.coordinate_properties;
    for (std::size_t i = 0; i < m_number_of_wanted; ++i)
    {
      const std::size_t index =
        i < 3 ? find_coordinate_name(names, i, wanted) : find_distance_name(names, m_options.distance_property);
      if (index == names.size() && i == 3 && !m_options.needs_distances())
      {
        m_number_of_wanted = 3;
        break;
      }
      if (index == names.size())
        return fail(
          missing_property_text(i < 3 ? coordinate_name(i, wanted) : m_options.distance_property, i == 3, names));
      if (vertex.properties[index].is_list)
        return fail(m_filename + ": the vertex property " + quote(names[index])
                    + " is a list; a single number per point is needed");
      m_wanted[i].index = index;
      m_wanted[i].type = vertex.properties[index].type;
      m_wanted[i].offset = 0;
      for (std::size_t j = 0; j < index; ++j)
        m_wanted[i].offset += size_of(vertex.properties[j].type);
    }
    return true;
  }

  std::string missing_property_text(const std::string& name, bool is_distance,
                                    const std::vector<std::string>& names) const
  {
    std::string text = m_filename + ": its vertices have no property ";
    if (is_distance && name.empty())
      text += "for the distance (looked for: " + join(known_distance_names()) + ")";
    else
      text += quote(name);
    text += "; they have: " + join(names);
    if (!is_distance)
      text += ". Name those that hold the coordinates (coordinate_properties)";
    else
      text += ". Name the one that holds the distance (distance_property), or give the distances "
              "as a separate file"
        + m_options.estimate_text();
    return text;
  }

  bool is_size_plausible()
  {
    if (!m_input.is_size_known())
      return true;
    for (std::size_t i = 0; i <= m_vertex_element; ++i)
    {
      const Ply_element& element = m_header.elements[i];
      const std::uint64_t entry_size = element.entry_size();
      if (entry_size == 0 || element.count <= m_input.remaining() / entry_size)
        continue;
      const bool is_vertex = (i == m_vertex_element);
      std::string promise = "header promises " + std::to_string(element.count) + " "
        + (is_vertex ? "vertices" : quote(element.name) + " entries");
      if (element.count <= (std::numeric_limits<std::uint64_t>::max)() / entry_size)
        promise += " = " + std::string(element.has_list() ? "at least " : "")
          + std::to_string(element.count * entry_size) + " bytes";
      const std::uint64_t rest = m_input.remaining();
      std::string text = m_filename + ": " + promise + ", the file has " + std::to_string(rest) + " after the header";
      if (is_vertex && m_vertex_element == 0 && !element.has_list())
        text += " (" + std::to_string(rest / entry_size) + " of " + std::to_string(element.count) + " vertices)";
      return fail(text + ": it is truncated or its header is wrong; get a complete copy of the file");
    }
    return true;
  }

  // ---- what stands before the vertices ----

  bool skip_element(const Ply_element& element)
  {
    const std::uint64_t entry_size = element.entry_size();
    if (entry_size == 0)
      return true;
    if (!is_binary())
      return skip_lines(element.count);
    if (!element.has_list())
      return element.count <= (std::numeric_limits<std::uint64_t>::max)() / entry_size
        && m_input.skip(element.count * entry_size);
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const Ply_property& property : element.properties)
        if (!skip_property(property))
          return false;
    return true;
  }

  bool skip_lines(std::uint64_t count)
  {
    std::vector<std::string_view> words;
    for (std::uint64_t i = 0; i < count; ++i)
      if (!next_words(words, false))
        return false;
    return true;
  }

  bool skip_property(const Ply_property& property)
  {
    if (!property.is_list)
      return m_input.skip(size_of(property.type));
    const std::size_t count_size = size_of(property.count_type);
    if (m_input.require(count_size) < count_size)
      return false;
    const double count = load_number(property.count_type, m_input.data(), m_swaps_bytes);
    m_input.consume(count_size);
    if (count < 0. || count > 1e15)
      return fail(m_filename + ": the list " + quote(property.name) + " claims to have " + number_to_string(count)
                  + " entries: the file is damaged or its header is wrong; get a complete "
                    "copy of it");
    return m_input.skip(static_cast<std::uint64_t>(count) * size_of(property.type));
  }

  // ---- binary vertices ----

  bool read_binary_vertices(Sample_sink& sink)
  {
    return m_header.elements[m_vertex_element].has_list() ? read_binary_vertices_with_lists(sink)
                                                          : read_binary_vertices_of_fixed_size(sink);
  }

  bool read_binary_vertices_of_fixed_size(Sample_sink& sink)
  {
    const std::size_t entry_size = static_cast<std::size_t>(m_header.elements[m_vertex_element].entry_size());
    if (entry_size > Chunked_input::chunk_size)
      return fail(m_filename + ": a vertex of " + std::to_string(entry_size) + " bytes is too large");
    const std::size_t per_chunk =
      (std::max)(std::size_t(1), (std::min)(Sample_chunk::capacity, Chunked_input::chunk_size / entry_size));
    for (std::uint64_t left = number_of_vertices(); left > 0;)
    {
      const std::size_t wanted = static_cast<std::size_t>((std::min)(left, std::uint64_t(per_chunk)));
      const std::size_t count = m_input.require(wanted * entry_size) / entry_size;
      for (std::size_t i = 0; i < count; ++i)
        if (!keep(load_sample(m_input.data() + i * entry_size), 0, sink))
          return false;
      m_input.consume(count * entry_size);
      left -= count;
      if (count < wanted)
        return fail_truncated(after_vertices(number_of_vertices() - left));
    }
    return flush(sink);
  }

  Distance_sample load_sample(const char* entry) const
  {
    std::array<double, 4> values = {{0., 0., 0., 0.}};
    for (std::size_t i = 0; i < m_number_of_wanted; ++i)
      values[i] = load_number(m_wanted[i].type, entry + m_wanted[i].offset, m_swaps_bytes);
    return {values[0], values[1], values[2], values[3]};
  }

  bool read_binary_vertices_with_lists(Sample_sink& sink)
  {
    const std::vector<Ply_property>& properties = m_header.elements[m_vertex_element].properties;
    std::vector<double> values(properties.size(), 0.);
    for (std::uint64_t done = 0; done < number_of_vertices(); ++done)
    {
      for (std::size_t i = 0; i < properties.size(); ++i)
      {
        const std::size_t size = size_of(properties[i].type);
        if (!properties[i].is_list && m_input.require(size) == size)
          values[i] = load_number(properties[i].type, m_input.data(), m_swaps_bytes);
        if (!skip_property(properties[i]))
          return fail_truncated(after_vertices(done));
      }
      if (!keep_values(values, 0, sink))
        return false;
    }
    return flush(sink);
  }

  // ---- ascii vertices ----

  bool read_ascii_vertices(Sample_sink& sink)
  {
    const std::vector<Ply_property>& properties = m_header.elements[m_vertex_element].properties;
    std::vector<double> values(properties.size(), 0.);
    std::vector<std::string_view> words;
    for (std::uint64_t done = 0; done < number_of_vertices(); ++done)
    {
      if (!next_words(words, false))
        return fail_truncated(after_vertices(done));
      if (!parse_values(properties, words, values))
        return false;
      if (!keep_values(values, m_input.line_number(), sink))
        return false;
    }
    return flush(sink);
  }

  bool parse_values(const std::vector<Ply_property>& properties, const std::vector<std::string_view>& words,
                    std::vector<double>& values)
  {
    std::size_t position = 0;
    for (std::size_t i = 0; i < properties.size(); ++i)
    {
      if (position >= words.size())
        return fail_at_line("a vertex with only " + plural(words.size(), "value", "values") + "; the header promises "
                            + std::to_string(properties.size())
                            + " properties: complete the line, or correct the header");
      std::uint64_t list_size = 0;
      if (!properties[i].is_list ? !parse_number(words[position], values[i]) : !parse_count(words[position], list_size))
        return fail_at_line((properties[i].is_list ? "the number of entries of " : "the property ")
                            + quote(properties[i].name) + " is " + no_number_text(words[position]));
      ++position;
      if (list_size > words.size() - position)
        return fail_at_line("the list " + quote(properties[i].name) + " is shorter than it says; correct the line");
      position += static_cast<std::size_t>(list_size);
    }
    if (position < words.size())
      return fail_at_line("a vertex with " + plural(words.size(), "value", "values")
                          + ", more than the header promises; correct one of the two");
    return true;
  }

  // ---- common to all ----

  std::string after_vertices(std::uint64_t count) const
  {
    return "after " + std::to_string(count) + " of " + std::to_string(number_of_vertices()) + " vertices";
  }

  bool keep_values(const std::vector<double>& values, std::size_t line, Sample_sink& sink)
  {
    return keep({values[m_wanted[0].index], values[m_wanted[1].index], values[m_wanted[2].index],
                 m_number_of_wanted == 4 ? values[m_wanted[3].index] : 0.},
                line, sink);
  }

  // a header that promises too little would drop points silently
  bool is_end_as_promised()
  {
    for (std::size_t i = m_vertex_element + 1; i < m_header.elements.size(); ++i)
      if (m_header.elements[i].count > 0)
        return true;
    std::vector<std::string_view> words;
    const bool has_more = is_binary()
      ? m_input.require(static_cast<std::size_t>(m_header.elements[m_vertex_element].entry_size()))
        >= m_header.elements[m_vertex_element].entry_size()
      : next_words(words, false);
    if (!has_more)
      return m_error.empty();
    return fail(m_filename + ": holds more than the " + std::to_string(number_of_vertices())
                + " vertices its header promises; correct the number there");
  }

  Ply_header m_header;
  std::size_t m_vertex_element = 0;
  std::array<Wanted_property, 4> m_wanted;
  std::size_t m_number_of_wanted = 4;
  bool m_swaps_bytes = false;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PLY_CLOUD_READER_H
