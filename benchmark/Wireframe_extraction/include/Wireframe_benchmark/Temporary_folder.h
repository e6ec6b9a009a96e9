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

#ifndef WIREFRAME_BENCHMARK_TEMPORARY_FOLDER_H
#define WIREFRAME_BENCHMARK_TEMPORARY_FOLDER_H

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

namespace Wireframe_benchmark {

/// A folder for files that are gone in the end.
class Temporary_folder
{
public:
  Temporary_folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "run_benchmark_XXXXXX").string();
    if (mkdtemp(&name[0]) == nullptr)
      throw std::runtime_error("no folder for temporary files can be made in '"
                               + std::filesystem::temp_directory_path().string() + "'");
    m_path = name;
  }

  ~Temporary_folder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
  }

  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  const std::filesystem::path& path() const { return m_path; }

private:
  std::filesystem::path m_path;
};

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_TEMPORARY_FOLDER_H
