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

#ifndef WIREFRAME_BENCHMARK_CSV_H
#define WIREFRAME_BENCHMARK_CSV_H

#include <Wireframe_benchmark/Benchmark_row.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {
namespace internal {

inline std::string csv_field(const std::string& text)
{
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string result = "\"";
  for (char c : text)
    result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

// the fields of all lines
inline std::vector<std::vector<std::string>> parse_csv(const std::string& text)
{
  std::vector<std::vector<std::string>> lines;
  std::vector<std::string> line;
  std::string field;
  bool is_quoted = false;
  const auto end_line = [&] {
    line.push_back(std::move(field));
    field.clear();
    if (line.size() > 1 || !line.front().empty())
      lines.push_back(line);
    line.clear();
  };
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const char c = text[i];
    if (is_quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"')
      field += text[++i];
    else if (c == '"')
      is_quoted = !is_quoted;
    else if (!is_quoted && c == ',')
    {
      line.push_back(std::move(field));
      field.clear();
    }
    else if (!is_quoted && c == '\n')
      end_line();
    else if (is_quoted || c != '\r')
      field += c;
  }
  end_line();
  return lines;
}

} // namespace internal

/// writes rows as CSV, one line per row, and before them a line with the names of the columns.
inline void write_csv(std::ostream& out, const std::vector<Benchmark_row>& rows)
{
  out << "family,case,field,failure";
  for (const std::string& name : value_names())
    out << ',' << name;
  out << '\n';
  for (const Benchmark_row& row : rows)
  {
    out << internal::csv_field(row.family) << ',' << internal::csv_field(row.name) << ','
        << internal::csv_field(row.field) << ',' << internal::csv_field(row.failure);
    for (const std::string& name : value_names())
    {
      std::ostringstream number;
      number.precision(9);
      if (!std::isnan(row.value(name)))
        number << row.value(name);
      out << ',' << number.str();
    }
    out << '\n';
  }
}

/// reads rows from CSV as `write_csv()` writes it; columns that it does not know are values too. Throws
/// `std::runtime_error` if it cannot.
inline std::vector<Benchmark_row> read_csv(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw std::runtime_error(path + ": cannot be opened");
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  const std::vector<std::vector<std::string>> lines = internal::parse_csv(text);
  if (lines.empty() || lines[0].size() < 4 || lines[0][0] != "family" || lines[0][1] != "case" || lines[0][2] != "field"
      || lines[0][3] != "failure")
    throw std::runtime_error(path
                             + ": is not a table of this tool: its first line does not start with "
                               "family,case,field,failure");
  std::vector<Benchmark_row> rows;
  for (std::size_t i = 1; i < lines.size(); ++i)
  {
    const std::vector<std::string>& line = lines[i];
    if (line.size() != lines[0].size())
      throw std::runtime_error(path + ": row " + std::to_string(i) + " has " + std::to_string(line.size())
                               + " fields instead of " + std::to_string(lines[0].size()));
    Benchmark_row row;
    row.family = line[0];
    row.name = line[1];
    row.field = line[2];
    row.failure = line[3];
    for (std::size_t k = 4; k < line.size(); ++k)
    {
      if (line[k].empty())
        continue;
      char* end = nullptr;
      const double value = std::strtod(line[k].c_str(), &end);
      if (*end != '\0')
        throw std::runtime_error(path + ": row " + std::to_string(i) + ": '" + line[k] + "' in the column "
                                 + lines[0][k] + " is not a number");
      row.values[lines[0][k]] = value;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_CSV_H
