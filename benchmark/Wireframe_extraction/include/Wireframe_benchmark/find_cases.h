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

#ifndef WIREFRAME_BENCHMARK_FIND_CASES_H
#define WIREFRAME_BENCHMARK_FIND_CASES_H

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace Wireframe_benchmark {

namespace fs = std::filesystem;

/// A cloud and its true wireframe.
struct Benchmark_case
{
  std::string family, name, field;
  fs::path cloud, truth;
};

namespace internal {

class Case_finder
{
public:
  explicit Case_finder(const fs::path& root) : m_root(fs::canonical(root)) {}

  std::vector<Benchmark_case> run()
  {
    visit(m_root, fs::path());
    return std::move(m_cases);
  }

private:
  // `place` is the folder's path seen from the root
  void visit(const fs::path& folder, const fs::path& place)
  {
    if (!m_visited.insert(fs::canonical(folder)).second) // links may lead in circles
      return;
    std::vector<fs::path> entries;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      entries.push_back(entry.path());
    std::sort(entries.begin(), entries.end());
    const bool is_case = fs::is_regular_file(folder / "truth.json");
    for (const fs::path& path : entries)
    {
      std::error_code ignored; // of links that lead nowhere
      if (fs::is_directory(path, ignored))
        visit(path, place / path.filename());
      else if (is_case && path.extension() == ".ply")
        m_cases.push_back({family(place), name(place), path.stem().string(), path, folder / "truth.json"});
    }
  }

  std::string name(const fs::path& place) const
  {
    return place.empty() ? m_root.filename().string() : place.filename().string();
  }

  std::string family(const fs::path& place) const
  {
    if (place.empty())
      return m_root.parent_path().filename().string();
    return place.has_parent_path() ? place.parent_path().generic_string() : m_root.filename().string();
  }

  const fs::path m_root;
  std::set<fs::path> m_visited;
  std::vector<Benchmark_case> m_cases;
};

} // namespace internal

/*!
returns all cases under a folder, in the order of their paths: each is a folder with a file `truth.json` and one cloud
`FIELD.ply` per field. The folder around such a folder is its family.
*/
inline std::vector<Benchmark_case> find_cases(const fs::path& root) { return internal::Case_finder(root).run(); }

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_FIND_CASES_H
