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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CHUNKED_CLOUD_READER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CHUNKED_CLOUD_READER_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_chunk.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// What readers of point clouds have in common that hand out samples chunk by chunk: the input, the chunk, and how
// errors are told.
class Chunked_cloud_reader
{
public:
  const Sample_filter& filter() const { return m_filter; }
  const std::string& error() const { return m_error; }

protected:
  // `kind` is what lines that are too long are too long for
  Chunked_cloud_reader(std::istream& stream, const std::string& filename, const Cloud_reader_options& options,
                       const char* kind)
    : m_input(stream), m_filename(filename), m_options(options), m_filter(options), m_kind(kind)
  {}

  bool fail(const std::string& error)
  {
    m_error = error;
    return false;
  }

  bool fail_at_line(const std::string& what)
  {
    return fail(m_filename + ":" + std::to_string(m_input.line_number()) + ": " + what);
  }

  bool fail_truncated(const std::string& where)
  {
    if (!m_error.empty())
      return false;
    return fail(m_filename + (m_input.has_failed() ? ": reading failed " : ": is truncated: it ends ") + where
                + (m_input.has_failed() ? "" : "; get a complete copy of the file"));
  }

  // whether the file has content
  bool check_start()
  {
    return m_input.require(1) > 0
      || fail(m_filename + ": " + (m_input.has_failed() ? "cannot be read" : empty_file_text()));
  }

  // the words of the next line that has some; what follows a # is left out if lines have comments
  bool next_words(std::vector<std::string_view>& words, bool has_comments)
  {
    std::string_view line;
    for (;;)
    {
      const Chunked_input::Line_status status = m_input.next_line(line);
      if (status == Chunked_input::Line_status::TOO_LONG)
        return fail(m_filename + ":" + std::to_string(m_input.line_number() + 1) + ": the line is too long for "
                    + m_kind);
      if (status == Chunked_input::Line_status::END)
        return false;
      split_at_blanks(has_comments ? line.substr(0, line.find('#')) : line, words);
      if (!words.empty())
        return true;
    }
  }

  // takes a sample, and hands the chunk out if it is full
  bool keep(Distance_sample sample, std::size_t line, Sample_sink& sink)
  {
    return !m_filter(sample, line) || m_chunk.add(sample, sink) || fail_as_stopped();
  }

  bool flush(Sample_sink& sink) { return m_chunk.flush(sink) || fail_as_stopped(); }

  Chunked_input m_input;
  std::string m_filename;
  const Cloud_reader_options& m_options;
  Sample_filter m_filter;
  std::string m_error;

private:
  bool fail_as_stopped() { return fail(m_filename + ": " + Sample_chunk::stopped_text()); }

  const char* m_kind;
  Sample_chunk m_chunk;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CHUNKED_CLOUD_READER_H
