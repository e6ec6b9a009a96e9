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

#ifndef WIREFRAME_BENCHMARK_FIND_PROGRAM_H
#define WIREFRAME_BENCHMARK_FIND_PROGRAM_H

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <system_error>

namespace Wireframe_benchmark {

/// tells whether there is a program at this path.
inline bool is_program(const std::filesystem::path& path)
{
  return std::filesystem::is_regular_file(path) && access(path.c_str(), X_OK) == 0;
}

/// tells whether a command is found, as the shell looks for it.
inline bool is_found(const std::string& program)
{
  if (program.find('/') != std::string::npos)
    return is_program(program);
  const char* const paths = std::getenv("PATH");
  std::istringstream folders(paths == nullptr ? "" : paths);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (is_program(std::filesystem::path(folder.empty() ? "." : folder) / program))
      return true;
  return false;
}

/// returns the folder of this program, whose name is that of the command line.
inline std::filesystem::path own_folder(const char* program)
{
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::absolute(program).parent_path() : self.parent_path();
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_FIND_PROGRAM_H
