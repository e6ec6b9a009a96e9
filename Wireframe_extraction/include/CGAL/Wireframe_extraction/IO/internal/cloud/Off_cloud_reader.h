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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_OFF_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_OFF_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_cloud_reader.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Reads the vertices of a mesh in an ascii OFF file, and hands them out chunk by chunk. Faces are not looked at,
// and the header is not believed: CGAL's own reader allocates what the header promises.
class Off_cloud_reader : private Chunked_cloud_reader
{
public:
  Off_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options)
    : Chunked_cloud_reader(stream, filename, options, "an ascii OFF file")
  {}

  // reads all vertices; `sink(first, last)` gets chunk after chunk of usable samples, and stops the reading by
  // returning `false`
  bool read(Sample_sink& sink)
  {
    std::uint64_t count = 0;
    if (!read_header(count))
      return false;
    sink.describe(m_options.distances != nullptr, std::string(), std::string());
    std::vector<std::string_view> words;
    for (std::uint64_t done = 0; done < count; ++done)
    {
      if (!next_words(words, true))
        return fail_truncated("after " + std::to_string(done) + " of " + std::to_string(count) + " vertices");
      if (!read_vertex(words, sink))
        return false;
    }
    return flush(sink) && m_filter.is_cloud_usable(m_filename, m_error);
  }

  using Chunked_cloud_reader::filter;
  using Chunked_cloud_reader::error;

private:
  // OFF with what the vertices have besides a point: texture (ST), colour (C), normal (N)
  bool is_known_keyword(std::string_view word)
  {
    if (word.size() < 3 || word.substr(word.size() - 3) != "OFF")
      return false;
    word.remove_suffix(3);
    for (const char* const prefix : {"ST", "C", "N"})
      if (starts_with(word, prefix))
        word.remove_prefix(std::string_view(prefix).size());
    return word.empty();
  }

  bool read_header(std::uint64_t& count)
  {
    if (!check_start())
      return false;
    std::vector<std::string_view> words;
    if (!next_words(words, true))
      return fail_truncated("before its header");
    if (!is_known_keyword(words[0]))
      return fail_at_line("an OFF file starts with OFF, COFF, NOFF, CNOFF, STOFF or the like, this one with "
                          + quote(words[0]) + "; vertices with more than three coordinates are not read");
    if (words.size() > 1 && words[1] == "BINARY")
      return fail_at_line("binary OFF files are not read; write it as ascii OFF, or as PLY");
    words.erase(words.begin());
    if (words.empty() && !next_words(words, true))
      return fail_truncated("before its number of vertices");
    if (!parse_count(words[0], count) || words.size() > 3)
      return fail_at_line("the numbers of vertices, faces and edges are expected, found " + quote(words[0])
                          + "; write them there");
    if (m_options.needs_distances())
      return fail(m_filename
                  + ": an OFF file has no distances; give them as a separate file, one per vertex, or "
                    "write a PLY file with a property of the vertices for them"
                  + m_options.estimate_text());
    // a vertex takes at least six bytes
    if (m_input.is_size_known() && count > m_input.remaining() / 6 + 1)
      return fail(m_filename + ": its header promises " + std::to_string(count) + " vertices, which "
                  + std::to_string(m_input.remaining())
                  + " bytes cannot hold: it is truncated or its header is "
                    "wrong; get a complete copy of the file");
    return true;
  }

  bool read_vertex(const std::vector<std::string_view>& words, Sample_sink& sink)
  {
    if (words.size() < 3)
      return fail_at_line("a vertex with only " + plural(words.size(), "value", "values")
                          + "; x, y and z are needed, one vertex per line");
    std::array<double, 3> values = {{0., 0., 0.}};
    for (std::size_t i = 0; i < 3; ++i)
      if (!parse_number(words[i], values[i]))
        return fail_at_line("a coordinate is " + no_number_text(words[i]));
    return keep({values[0], values[1], values[2], 0.}, m_input.line_number(), sink);
  }
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_OFF_CLOUD_READER_H
