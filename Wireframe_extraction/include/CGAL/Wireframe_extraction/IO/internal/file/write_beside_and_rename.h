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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_WRITE_BESIDE_AND_RENAME_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_WRITE_BESIDE_AND_RENAME_H

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <system_error>

namespace CGAL {
namespace IO {
namespace internal {

// A file of our own beside the one that is to be written; it is gone at the end unless it was renamed.
class File_beside
{
public:
  explicit File_beside(const std::filesystem::path& target)
  {
    // "x" creates the file only if there is none, so no other file can be lost, nor two writers collide
    for (int i = 0; i < 1000; ++i)
    {
      m_path = target;
      m_path += ".partial" + std::to_string(i);
      errno = 0;
      std::FILE* const file = std::fopen(m_path.string().c_str(), "wbx");
      m_error_code = (file == nullptr) ? errno : 0;
      if (file != nullptr)
        std::fclose(file);
      if (m_error_code != EEXIST)
        break;
    }
    m_is_there = (m_error_code == 0);
  }

  File_beside(const File_beside&) = delete;
  File_beside& operator=(const File_beside&) = delete;

  ~File_beside()
  {
    std::error_code ignored;
    if (m_is_there)
      std::filesystem::remove(m_path, ignored);
  }

  bool is_there() const { return m_is_there; }
  int error_code() const { return m_error_code; }
  const std::filesystem::path& path() const { return m_path; }

  bool rename_to(const std::filesystem::path& target, std::string& reason)
  {
    std::error_code code;
    const std::filesystem::file_status status = std::filesystem::status(target, code);
    if (std::filesystem::is_regular_file(status))
      std::filesystem::permissions(m_path, status.permissions(), code);
    std::filesystem::rename(m_path, target, code);
    if (code)
      reason = code.message();
    else
      m_is_there = false;
    return !code;
  }

private:
  std::filesystem::path m_path;
  int m_error_code = 0;
  bool m_is_there = false;
};

// opens a file, lets `write(stream, error)` fill it, and closes it; returns whether every byte arrived
template <class Write>
bool write_and_close(const std::filesystem::path& path, const std::string& filename, Write&& write, std::string& error)
{
  errno = 0;
  std::ofstream stream(path, std::ios::out | std::ios::binary | std::ios::trunc);
  if (!stream)
  {
    error = filename + ": cannot be opened for writing: " + system_error_text(errno);
    return false;
  }
  const bool is_written = write(static_cast<std::ostream&>(stream), error);
  if (!is_written && error.empty() && stream)
    error = "nothing could be written";
  errno = 0;
  stream.close();
  if (!stream && error.empty())
    error = "cannot be written completely: " + system_error_text(errno) + " (is the disk full?)";
  if (!error.empty())
    error = filename + ": " + error;
  return error.empty();
}

// Writes a file as a whole or not at all: `write(stream, error)` fills a file beside the target, which takes
// the target's place only when all is on it. A failing `write` returns `false` and sets `error`, to which the
// name of the file is put. On failure the target is as before, and nothing else is left behind.
template <class Write>
bool write_beside_and_rename(const std::string& filename, Write&& write, std::string& error)
{
  namespace fs = std::filesystem;
  error.clear();
  if (filename.empty())
  {
    error = "the name of the file to write is empty";
    return false;
  }
  std::error_code code;
  fs::path target(filename);
  const fs::file_status status = fs::status(target, code);
  if (fs::is_directory(status))
  {
    error = filename + ": is a directory, not a file";
    return false;
  }
  // devices and pipes must be written to, not be replaced
  if (fs::exists(status) && !fs::is_regular_file(status))
    return write_and_close(target, filename, write, error);
  if (fs::exists(status))
  {
    // a link stays one, and a file that is protected against writing stays as it is
    target = fs::canonical(target, code);
    errno = 0;
    if (code || !std::ofstream(target, std::ios::out | std::ios::binary | std::ios::app))
    {
      error = filename + ": cannot be overwritten: " + (code ? code.message() : system_error_text(errno));
      return false;
    }
  }
  File_beside file(target);
  if (!file.is_there())
  {
    error =
      filename + ": cannot be written, its directory does not take a new file: " + system_error_text(file.error_code());
    return false;
  }
  if (!write_and_close(file.path(), filename, write, error))
    return false;
  std::string reason;
  if (!file.rename_to(target, reason))
    error = filename + ": cannot be replaced by the file written beside it: " + reason;
  return error.empty();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_WRITE_BESIDE_AND_RENAME_H
