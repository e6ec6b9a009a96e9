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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_OFF_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_OFF_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/text_tools.h>

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
class Off_cloud_reader
{
public:
  Off_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options)
    : input_(stream), filename_(filename), options_(options), filter_(options)
  {}

  // reads all vertices; `sink(first, last)` gets chunk after chunk of usable samples, and stops the reading by
  // returning `false`
  template <class Sink>
  bool read(Sink&& sink)
  {
    std::uint64_t count = 0;
    if(!read_header(count))
      return false;
    std::vector<std::string_view> words;
    for(std::uint64_t done = 0; done < count; ++done)
    {
      if(!next_words(words))
        return fail_truncated("after " + std::to_string(done) + " of " + std::to_string(count) + " vertices");
      if(!read_vertex(words) || (chunk_.size() == samples_per_chunk && !flush(sink)))
        return false;
    }
    return flush(sink) && filter_.is_cloud_usable(filename_, error_);
  }

  const Sample_filter& filter() const { return filter_; }
  const std::string& error() const { return error_; }

private:
  static constexpr std::size_t samples_per_chunk = 4096;

  bool fail(const std::string& error)
  {
    error_ = error;
    return false;
  }

  bool fail_at_line(const std::string& what)
  {
    return fail(filename_ + ":" + std::to_string(input_.line_number()) + ": " + what);
  }

  bool fail_truncated(const std::string& where)
  {
    if(!error_.empty())
      return false;
    return fail(filename_ + (input_.has_failed() ? ": reading failed " : ": is truncated: it ends ") + where
                + (input_.has_failed() ? "" : "; get a complete copy of the file"));
  }

  // the words of the next line that has some; comments are left out
  bool next_words(std::vector<std::string_view>& words)
  {
    std::string_view line;
    for(;;)
    {
      const Chunked_input::Line_status status = input_.next_line(line);
      if(status == Chunked_input::Line_status::TOO_LONG)
        return fail(filename_ + ":" + std::to_string(input_.line_number() + 1)
                    + ": the line is too long for an ascii OFF file");
      if(status == Chunked_input::Line_status::END)
        return false;
      split_at_blanks(line.substr(0, line.find('#')), words);
      if(!words.empty())
        return true;
    }
  }

  // OFF with what the vertices have besides a point: texture (ST), colour (C), normal (N)
  bool is_known_keyword(std::string_view word)
  {
    if(word.size() < 3 || word.substr(word.size() - 3) != "OFF")
      return false;
    word.remove_suffix(3);
    for(const char* const prefix : { "ST", "C", "N" })
      if(starts_with(word, prefix))
        word.remove_prefix(std::string_view(prefix).size());
    return word.empty();
  }

  bool read_header(std::uint64_t& count)
  {
    if(input_.require(1) == 0)
      return fail(filename_ + (input_.has_failed() ? ": cannot be read" : ": is empty"));
    std::vector<std::string_view> words;
    if(!next_words(words))
      return fail_truncated("before its header");
    if(!is_known_keyword(words[0]))
      return fail_at_line("an OFF file starts with OFF, COFF, NOFF, CNOFF, STOFF or the like, this one with "
                          + quote(words[0]) + "; vertices with more than three coordinates are not read");
    if(words.size() > 1 && words[1] == "BINARY")
      return fail_at_line("binary OFF files are not read; write it as ascii OFF, or as PLY");
    words.erase(words.begin());
    if(words.empty() && !next_words(words))
      return fail_truncated("before its number of vertices");
    if(!parse_count(words[0], count) || words.size() > 3)
      return fail_at_line("the numbers of vertices, faces and edges are expected, found " + quote(words[0]));
    if(options_.distances == nullptr)
      return fail(filename_ + ": an OFF file has no distances; give them as a separate file, one per vertex, or "
                              "write a PLY file with a property of the vertices for them");
    // a vertex takes at least six bytes
    if(input_.is_size_known() && count > input_.remaining() / 6 + 1)
      return fail(filename_ + ": its header promises " + std::to_string(count) + " vertices, which "
                  + std::to_string(input_.remaining()) + " bytes cannot hold: it is truncated or its header is wrong");
    return true;
  }

  bool read_vertex(const std::vector<std::string_view>& words)
  {
    if(words.size() < 3)
      return fail_at_line("a vertex with only " + plural(words.size(), "value", "values")
                          + "; x, y and z are needed, one vertex per line");
    std::array<double, 3> values = {{ 0., 0., 0. }};
    for(std::size_t i = 0; i < 3; ++i)
      if(!parse_number(words[i], values[i]))
        return fail_at_line(quote(words[i]) + " is no number");
    Distance_sample sample = { values[0], values[1], values[2], 0. };
    if(filter_(sample, input_.line_number()))
      chunk_.push_back(sample);
    return true;
  }

  template <class Sink>
  bool flush(Sink& sink)
  {
    const bool goes_on = chunk_.empty() || sink(chunk_.data(), chunk_.data() + chunk_.size());
    chunk_.clear();
    return goes_on || fail(filename_ + ": reading was stopped");
  }

  Chunked_input input_;
  std::string filename_;
  const Cloud_reader_options& options_;
  Sample_filter filter_;
  std::vector<Distance_sample> chunk_;
  std::string error_;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_OFF_CLOUD_READER_H
