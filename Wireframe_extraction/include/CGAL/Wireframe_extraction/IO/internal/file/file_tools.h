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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_FILE_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_FILE_TOOLS_H

#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <istream>
#include <string>
#include <string_view>
#include <system_error>

namespace CGAL {
namespace IO {
namespace internal {

inline std::string system_error_text(int code)
{
  return code == 0 ? std::string("unknown reason") : std::generic_category().message(code);
}

// whether the next bytes are the first ones of what gzip writes; they are still to be read then
inline bool is_gzip(std::istream& stream)
{
  bool is_second_byte = false;
  if (stream.peek() == 0x1f)
  {
    stream.get();
    is_second_byte = stream.peek() == 0x8b;
    stream.clear();
    stream.unget();
  }
  stream.clear(); // there may be nothing at all
  return is_second_byte;
}

// opens a file for reading its bytes; says why if that is impossible
inline bool open_input_file(const std::string& filename, std::ifstream& stream, std::string& error)
{
  if (filename.empty())
  {
    error = "the name of the file to read is empty";
    return false;
  }
  std::error_code code;
  if (std::filesystem::is_directory(filename, code))
  {
    error = filename + ": is a directory, not a file; name a file in it";
    return false;
  }
  errno = 0;
  stream.open(filename, std::ios::in | std::ios::binary);
  if (!stream)
    error = filename + ": cannot be opened for reading: " + system_error_text(errno)
      + (errno == ENOENT ? "; check its name" : "");
  else if (is_gzip(stream))
  {
    error = filename + ": is compressed by gzip, whatever its name says; unpack it first, by \"gunzip\"";
    return false;
  }
  return stream.is_open();
}

inline bool ends_with(std::string_view text, std::string_view suffix)
{
  return text.size() >= suffix.size() && text.substr(text.size() - suffix.size()) == suffix;
}

// the extension in lower case, with its dot; empty if there is none
inline std::string lower_extension(const std::string& filename)
{
  return to_lower(std::filesystem::path(filename).extension().string());
}

// The extension that stands for a format, in lower case and with its dot: the one that is given, with or without the
// dot, else that of the file.
inline std::string format_extension(const std::string& format, const std::string& filename)
{
  return lower_extension(format.empty() ? filename : (format[0] == '.' ? "name" : "name.") + format);
}

// whether files with this extension, in lower case, are written by OpenCASCADE
inline bool is_cad_extension(std::string_view extension)
{
  for (const char* const known : {".step", ".stp", ".iges", ".igs", ".brep"})
    if (extension == known)
      return true;
  return false;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_FILE_TOOLS_H
