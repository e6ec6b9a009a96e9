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
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
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

// Reads the points and distances of a file of the Point Cloud Library, ascii or binary, and hands them out chunk
// by chunk.
class Pcd_cloud_reader : private Chunked_cloud_reader
{
public:
  Pcd_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options)
    : Chunked_cloud_reader(stream, filename, options, "a PCD file")
  {}

  // reads all points; `sink(first, last)` gets chunk after chunk of usable samples, and stops the reading by
  // returning `false`
  template <class Sink>
  bool read(Sink&& sink)
  {
    if (!check_start())
      return false;
    return read_header() && find_wanted_fields() && (is_binary_ ? read_binary(sink) : read_ascii(sink))
      && filter_.is_cloud_usable(filename_, error_);
  }

  using Chunked_cloud_reader::filter;
  using Chunked_cloud_reader::error;

private:
  struct Field
  {
    std::size_t size = 4, count = 1;
    char type = 'F';
    std::size_t offset = 0, column = 0; // in a binary point, and among the words of an ascii one
  };

  static constexpr std::size_t largest_count = 1000000;

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
        names_.assign(words.begin() + 1, words.end());
        fields_.assign(names_.size(), Field());
      }
      else if (key == "SIZE" || key == "TYPE" || key == "COUNT")
      {
        if (!read_properties(words))
          return false;
      }
      else if (key == "WIDTH" || key == "HEIGHT" || key == "POINTS")
      {
        std::uint64_t& value = key == "WIDTH" ? width : key == "HEIGHT" ? height : number_of_points_;
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
    if (fields_.empty())
      return fail_at_line("its header has no FIELDS");
    if (!has_points && !has_width)
      return fail_at_line("its header has neither POINTS nor WIDTH, so the number of points is unknown");
    const bool is_area_known = height == 0 || width <= (std::numeric_limits<std::uint64_t>::max)() / height;
    if (has_points && has_width && (!is_area_known || width * height != number_of_points_))
      return fail(filename_ + ": its header promises " + std::to_string(number_of_points_) + " POINTS, but WIDTH "
                  + std::to_string(width) + " times HEIGHT " + std::to_string(height) + "; correct the header");
    if (!has_points)
      number_of_points_ = is_area_known ? width * height : (std::numeric_limits<std::uint64_t>::max)();
    return read_kind(words);
  }

  bool read_kind(const std::vector<std::string_view>& words)
  {
    const std::string_view kind = words.size() == 2 ? words[1] : std::string_view();
    is_binary_ = (kind == "binary");
    if (kind == "binary_compressed")
      return fail_at_line("compressed PCD files are not read; pcl_convert_pcd_ascii_binary (Debian: pcl-tools) "
                          "writes binary ones: pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1");
    return is_binary_ || kind == "ascii"
      || fail_at_line("DATA is to be followed by ascii or binary, found " + quote(kind));
  }

  bool read_properties(const std::vector<std::string_view>& words)
  {
    if (words.size() != fields_.size() + 1)
      return fail_at_line(std::string(words[0]) + " has " + plural(words.size() - 1, "entry", "entries") + ", FIELDS "
                          + std::to_string(fields_.size()));
    for (std::size_t i = 0; i < fields_.size(); ++i)
    {
      const std::string_view word = words[i + 1];
      bool is_fine = true;
      if (words[0] == "TYPE")
      {
        is_fine = (word == "F" || word == "I" || word == "U");
        fields_[i].type = word[0];
      }
      else
        is_fine = parse_count(word, words[0] == "SIZE" ? fields_[i].size : fields_[i].count);
      if (!is_fine || fields_[i].size > 8 || fields_[i].count > largest_count)
        return fail_at_line(quote(word) + " is no " + to_lower(words[0]) + " of a field");
    }
    return true;
  }

  bool find_wanted_fields()
  {
    for (std::size_t i = 0; i < fields_.size(); ++i)
    {
      fields_[i].offset = point_size_;
      fields_[i].column = number_of_columns_;
      point_size_ += fields_[i].size * fields_[i].count;
      number_of_columns_ += fields_[i].count;
    }
    number_of_wanted_ = (options_.distances == nullptr) ? 4 : 3;
    static const char* const coordinates[] = {"x", "y", "z"};
    for (std::size_t i = 0; i < number_of_wanted_; ++i)
    {
      const std::size_t index =
        i < 3 ? find_name(names_, coordinates[i]) : find_distance_name(names_, options_.distance_property);
      if (index == names_.size())
        return fail(missing_field_text(i < 3 ? coordinates[i] : options_.distance_property, i == 3));
      const Field& field = fields_[index];
      if (field.count != 1)
        return fail(filename_ + ": the field " + quote(names_[index]) + " has " + std::to_string(field.count)
                    + " numbers; a single one per point is needed");
      if (!is_number_type(to_lower(std::string_view(&field.type, 1))[0], field.size))
        return fail(filename_ + ": the field " + quote(names_[index]) + " has the type " + std::string(1, field.type)
                    + " of size " + std::to_string(field.size) + ", which is no number");
      wanted_[i] = field;
    }
    return true;
  }

  std::string missing_field_text(const std::string& name, bool is_distance) const
  {
    std::string text = filename_ + ": has no field ";
    if (is_distance && name.empty())
      text += "for the distance (looked for: " + join(known_distance_names()) + ")";
    else
      text += quote(name);
    text += "; it has: " + join(names_);
    if (is_distance)
      text += ". Name the one that holds the distance (distance_property), or give the distances as a separate file";
    return text;
  }

  template <class Sink>
  bool read_ascii(Sink& sink)
  {
    std::vector<std::string_view> words;
    for (std::uint64_t done = 0; done < number_of_points_; ++done)
    {
      if (!next_words(words, false))
        return fail_truncated(after_points(done));
      if (words.size() != number_of_columns_)
        return fail_at_line("a point with " + plural(words.size(), "value", "values") + "; the header promises "
                            + std::to_string(number_of_columns_) + ": correct one of the two");
      std::array<double, 4> values = {{0., 0., 0., 0.}};
      for (std::size_t i = 0; i < number_of_wanted_; ++i)
        if (!parse_number(words[wanted_[i].column], values[i]))
          return fail_at_line("column " + std::to_string(wanted_[i].column + 1) + " is "
                              + no_number_text(words[wanted_[i].column]));
      if (!keep({values[0], values[1], values[2], values[3]}, input_.line_number(), sink))
        return false;
    }
    return flush(sink) && (!next_words(words, false) ? error_.empty() : fail_at_end());
  }

  template <class Sink>
  bool read_binary(Sink& sink)
  {
    if (point_size_ > Chunked_input::chunk_size)
      return fail(filename_ + ": a point of " + std::to_string(point_size_) + " bytes is too large");
    if (input_.is_size_known() && number_of_points_ > input_.remaining() / point_size_)
      return fail(filename_ + ": header promises " + std::to_string(number_of_points_) + " points of "
                  + std::to_string(point_size_) + " bytes, the file has " + std::to_string(input_.remaining())
                  + " bytes after the header: it is truncated or its header is wrong; get a complete copy of the file");
    for (std::uint64_t done = 0; done < number_of_points_; ++done)
    {
      if (input_.require(point_size_) < point_size_)
        return fail_truncated(after_points(done));
      std::array<double, 4> values = {{0., 0., 0., 0.}};
      for (std::size_t i = 0; i < number_of_wanted_; ++i)
        values[i] = load_number(to_lower(std::string_view(&wanted_[i].type, 1))[0], wanted_[i].size,
                                input_.data() + wanted_[i].offset, !is_host_little_endian());
      input_.consume(point_size_);
      if (!keep({values[0], values[1], values[2], values[3]}, 0, sink))
        return false;
    }
    return flush(sink) && (input_.require(point_size_) < point_size_ || fail_at_end());
  }

  // a header that promises too little would drop points silently
  bool fail_at_end()
  {
    return fail(filename_ + ": holds more than the " + std::to_string(number_of_points_)
                + " points its header promises; correct the number there");
  }

  std::string after_points(std::uint64_t count) const
  {
    return "after " + std::to_string(count) + " of " + std::to_string(number_of_points_) + " points";
  }

  std::vector<std::string> names_;
  std::vector<Field> fields_;
  std::array<Field, 4> wanted_;
  std::size_t number_of_wanted_ = 4, point_size_ = 0, number_of_columns_ = 0;
  std::uint64_t number_of_points_ = 0;
  bool is_binary_ = false;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_PCD_CLOUD_READER_H
