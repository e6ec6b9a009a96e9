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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PCD_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PCD_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Lzf_decoder.h>
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

// Reads the points and distances of a file of the Point Cloud Library, ascii, binary or compressed, and hands them out
// chunk by chunk.
class Pcd_cloud_reader : private Chunked_cloud_reader
{
public:
  Pcd_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options)
    : Chunked_cloud_reader(stream, filename, options, "a PCD file")
  {}

  // reads all points; `sink(first, last)` gets chunk after chunk of usable samples, and stops the reading by
  // returning `false`
  bool read(Sample_sink& sink)
  {
    if (!check_start())
      return false;
    if (!read_header() || !find_wanted_fields())
      return false;
    const bool is_none_found = m_options.looks_for_distances() && m_number_of_wanted == 3;
    sink.describe(m_options.distances != nullptr || m_number_of_wanted == 4,
                  is_none_found ? no_distance_note(m_names) : std::string(), m_distance_place);
    return read_points(sink) && m_filter.is_cloud_usable(m_filename, m_error);
  }

  using Chunked_cloud_reader::filter;
  using Chunked_cloud_reader::error;

private:
  enum class Kind
  {
    ASCII,
    BINARY,
    COMPRESSED
  };

  struct Field
  {
    std::size_t size = 4, count = 1;
    char type = 'F';
    std::size_t offset = 0, column = 0; // in a binary point, and among the words of an ascii one
  };

  static constexpr std::size_t largest_count = 1000000;
  // the field that fills gaps between others; PCL leaves it out where it compresses
  static constexpr const char* padding_name = "_";

  bool read_header()
  {
    std::vector<std::string_view> words;
    std::uint64_t width = 0, height = 1;
    bool has_width = false, has_points = false;
    for (bool is_first = true;; is_first = false)
    {
      if (!next_words(words, true))
        return fail_truncated("in its header, which has no line DATA");
      const std::string_view key = words[0];
      if (key == "DATA")
        break;
      if (key == "FIELDS")
      {
        m_names.assign(words.begin() + 1, words.end());
        m_fields.assign(m_names.size(), Field());
      }
      else if (key == "SIZE" || key == "TYPE" || key == "COUNT")
      {
        if (!read_properties(words))
          return false;
      }
      else if (key == "WIDTH" || key == "HEIGHT" || key == "POINTS")
      {
        std::uint64_t& value = key == "WIDTH" ? width : key == "HEIGHT" ? height : m_number_of_points;
        has_width = has_width || key == "WIDTH";
        has_points = has_points || key == "POINTS";
        if (words.size() != 2 || !parse_count(words[1], value))
          return fail_at_line(std::string(key) + " is to be followed by a number");
      }
      else if (key != "VERSION" && key != "VIEWPOINT")
        return fail_at_line(quote(key)
                            + (is_first ? " starts no PCD file, which begins with VERSION and FIELDS"
                                        : " is no line of the header of a PCD file"));
    }
    if (m_fields.empty())
      return fail_at_line("its header has no FIELDS");
    if (!has_points && !has_width)
      return fail_at_line("its header has neither POINTS nor WIDTH, so the number of points is unknown");
    const bool is_area_known = height == 0 || width <= (std::numeric_limits<std::uint64_t>::max)() / height;
    if (has_points && has_width && (!is_area_known || width * height != m_number_of_points))
      return fail(m_filename + ": its header promises " + std::to_string(m_number_of_points) + " POINTS, but WIDTH "
                  + std::to_string(width) + " times HEIGHT " + std::to_string(height) + "; correct the header");
    if (!has_points)
      m_number_of_points = is_area_known ? width * height : (std::numeric_limits<std::uint64_t>::max)();
    return read_kind(words);
  }

  bool read_kind(const std::vector<std::string_view>& words)
  {
    const std::string_view kind = words.size() == 2 ? words[1] : std::string_view();
    m_kind = kind == "binary" ? Kind::BINARY : kind == "binary_compressed" ? Kind::COMPRESSED : Kind::ASCII;
    return m_kind != Kind::ASCII || kind == "ascii"
      || fail_at_line("DATA is to be followed by ascii, binary or binary_compressed, found " + quote(kind));
  }

  bool read_properties(const std::vector<std::string_view>& words)
  {
    if (words.size() != m_fields.size() + 1)
      return fail_at_line(std::string(words[0]) + " has " + plural(words.size() - 1, "entry", "entries") + ", FIELDS "
                          + std::to_string(m_fields.size()));
    for (std::size_t i = 0; i < m_fields.size(); ++i)
    {
      const std::string_view word = words[i + 1];
      bool is_fine = true;
      if (words[0] == "TYPE")
      {
        is_fine = (word == "F" || word == "I" || word == "U");
        m_fields[i].type = word[0];
      }
      else
        is_fine = parse_count(word, words[0] == "SIZE" ? m_fields[i].size : m_fields[i].count);
      if (!is_fine || m_fields[i].size > 8 || m_fields[i].count > largest_count)
        return fail_at_line(quote(word) + " is no " + to_lower(words[0]) + " of a field");
    }
    return true;
  }

  bool find_wanted_fields()
  {
    for (std::size_t i = 0; i < m_fields.size(); ++i)
    {
      m_fields[i].offset = m_point_size;
      m_fields[i].column = m_number_of_columns;
      if (m_kind != Kind::COMPRESSED || m_names[i] != padding_name)
        m_point_size += m_fields[i].size * m_fields[i].count;
      m_number_of_columns += m_fields[i].count;
    }
    m_number_of_wanted = m_options.looks_for_distances() ? 4 : 3;
    const std::vector<std::string>& wanted = m_options.coordinate_properties;
    for (std::size_t i = 0; i < m_number_of_wanted; ++i)
    {
      const std::size_t index =
        i < 3 ? find_coordinate_name(m_names, i, wanted) : find_distance_name(m_names, m_options.distance_property);
      if (index == m_names.size() && i == 3 && !m_options.needs_distances())
      {
        m_number_of_wanted = 3;
        break;
      }
      if (index == m_names.size())
        return fail(missing_field_text(i < 3 ? coordinate_name(i, wanted) : m_options.distance_property, i == 3));
      const Field& field = m_fields[index];
      if (field.count != 1)
        return fail(m_filename + ": the field " + quote(m_names[index]) + " has " + std::to_string(field.count)
                    + " numbers; a single one per point is needed");
      if (!is_number_type(to_lower(std::string_view(&field.type, 1))[0], field.size))
        return fail(m_filename + ": the field " + quote(m_names[index]) + " has the type " + std::string(1, field.type)
                    + " of size " + std::to_string(field.size) + ", which is no number");
      m_wanted[i] = field;
      if (i == 3)
        m_distance_place = "the field " + quote(m_names[index]);
    }
    return true;
  }

  std::string missing_field_text(const std::string& name, bool is_distance) const
  {
    std::string text = m_filename + ": has no field ";
    if (is_distance && name.empty())
      text += "for the distance (looked for: " + join(known_distance_names()) + ")";
    else
      text += quote(name);
    text += "; it has: " + join(m_names);
    if (!is_distance)
      text += ". Name those that hold the coordinates (coordinate_properties)";
    else
      text += ". Name the one that holds the distance (distance_property), or give the distances as a separate file"
        + m_options.estimate_text();
    return text;
  }

  bool read_points(Sample_sink& sink)
  {
    switch (m_kind)
    {
    case Kind::BINARY: return read_binary(sink);
    case Kind::COMPRESSED: return read_compressed(sink);
    default: return read_ascii(sink);
    }
  }

  bool read_ascii(Sample_sink& sink)
  {
    std::vector<std::string_view> words;
    for (std::uint64_t done = 0; done < m_number_of_points; ++done)
    {
      if (!next_words(words, false))
        return fail_truncated(after_points(done));
      if (words.size() != m_number_of_columns)
        return fail_at_line("a point with " + plural(words.size(), "value", "values") + "; the header promises "
                            + std::to_string(m_number_of_columns) + ": correct one of the two");
      std::array<double, 4> values = {{0., 0., 0., 0.}};
      for (std::size_t i = 0; i < m_number_of_wanted; ++i)
        if (!parse_number(words[m_wanted[i].column], values[i]))
          return fail_at_line("column " + std::to_string(m_wanted[i].column + 1) + " is "
                              + no_number_text(words[m_wanted[i].column]));
      if (!keep({values[0], values[1], values[2], values[3]}, m_input.line_number(), sink))
        return false;
    }
    return flush(sink) && (!next_words(words, false) ? m_error.empty() : fail_at_end());
  }

  bool read_binary(Sample_sink& sink)
  {
    if (m_point_size > Chunked_input::chunk_size)
      return fail(m_filename + ": a point of " + std::to_string(m_point_size) + " bytes is too large");
    if (m_input.is_size_known() && m_number_of_points > m_input.remaining() / m_point_size)
      return fail(m_filename + ": header promises " + std::to_string(m_number_of_points) + " points of "
                  + std::to_string(m_point_size) + " bytes, the file has " + std::to_string(m_input.remaining())
                  + " bytes after the header: it is truncated or its header is wrong; get a complete copy of the file");
    for (std::uint64_t done = 0; done < m_number_of_points; ++done)
    {
      if (m_input.require(m_point_size) < m_point_size)
        return fail_truncated(after_points(done));
      const char* const point = m_input.data();
      if (!keep(load_sample([&](const Field& field) { return point + field.offset; }), 0, sink))
        return false;
      m_input.consume(m_point_size);
    }
    return flush(sink) && (is_rest_padding() || fail_at_end());
  }

  // Compressed points are one block, in which each field has the numbers of all points, one behind the other.
  bool read_compressed(Sample_sink& sink)
  {
    std::string packed;
    std::uint64_t size = 0;
    if (!read_packed(packed, size))
      return false;
    const Lzf_decoder decoder(reinterpret_cast<const unsigned char*>(packed.data()), packed.size());
    std::size_t unpacked_size = 0;
    if (!decoder.find_size(unpacked_size) || unpacked_size != size)
      return fail(m_filename + ": its compressed points are damaged; get a complete copy of the file");
    if (m_point_size == 0 || size % m_point_size != 0 || size / m_point_size != m_number_of_points)
      return fail(m_filename + ": header promises " + std::to_string(m_number_of_points) + " points of "
                  + std::to_string(m_point_size) + " bytes, but " + std::to_string(size)
                  + " bytes were compressed: its header is wrong; correct it");
    std::vector<char> bytes(unpacked_size);
    decoder.decode(reinterpret_cast<unsigned char*>(bytes.data()));
    const std::size_t count = static_cast<std::size_t>(m_number_of_points);
    for (std::size_t k = 0; k < count; ++k)
      if (!keep(load_sample([&](const Field& field) { return bytes.data() + field.offset * count + k * field.size; }),
                0, sink))
        return false;
    return flush(sink) && (is_rest_padding() || fail_at_end());
  }

  // Gets the compressed bytes, and how many they were before. Memory goes to what is there.
  bool read_packed(std::string& packed, std::uint64_t& size)
  {
    constexpr std::size_t size_of_sizes = 8;
    if (m_input.require(size_of_sizes) < size_of_sizes)
      return fail_truncated("before its compressed points");
    const std::uint64_t packed_size = load_little_endian<std::uint32_t>(m_input.data());
    size = load_little_endian<std::uint32_t>(m_input.data() + 4);
    m_input.consume(size_of_sizes);
    while (packed.size() < packed_size)
    {
      const std::size_t step = m_input.require(
        static_cast<std::size_t>((std::min)(packed_size - packed.size(), std::uint64_t(Chunked_input::chunk_size))));
      if (step == 0)
        return fail_truncated("after " + std::to_string(packed.size()) + " of " + std::to_string(packed_size)
                              + " bytes of compressed points");
      packed.append(m_input.data(), step);
      m_input.consume(step);
    }
    return true;
  }

  // `place(field)` is where the number of a field starts
  template <class Place>
  Distance_sample load_sample(const Place& place) const
  {
    std::array<double, 4> values = {{0., 0., 0., 0.}};
    for (std::size_t i = 0; i < m_number_of_wanted; ++i)
      values[i] = load_number(to_lower(std::string_view(&m_wanted[i].type, 1))[0], m_wanted[i].size, place(m_wanted[i]),
                              !is_host_little_endian());
    return {values[0], values[1], values[2], values[3]};
  }

  // PCL fills its binary files with zero bytes, up to the end of a page of memory
  bool is_rest_padding()
  {
    for (std::size_t step; (step = m_input.require(Chunked_input::chunk_size)) > 0; m_input.consume(step))
      if (std::any_of(m_input.data(), m_input.data() + step, [](char byte) { return byte != 0; }))
        return false;
    return true;
  }

  // a header that promises too little would drop points silently
  bool fail_at_end()
  {
    return fail(m_filename + ": holds more than the " + std::to_string(m_number_of_points)
                + " points its header promises; correct the number there");
  }

  std::string after_points(std::uint64_t count) const
  {
    return "after " + std::to_string(count) + " of " + std::to_string(m_number_of_points) + " points";
  }

  std::vector<std::string> m_names;
  std::vector<Field> m_fields;
  std::array<Field, 4> m_wanted;
  std::string m_distance_place; // as words
  std::size_t m_number_of_wanted = 4, m_point_size = 0, m_number_of_columns = 0;
  std::uint64_t m_number_of_points = 0;
  Kind m_kind = Kind::ASCII;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PCD_CLOUD_READER_H
