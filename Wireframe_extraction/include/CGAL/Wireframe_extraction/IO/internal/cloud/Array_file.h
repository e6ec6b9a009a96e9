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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ARRAY_FILE_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ARRAY_FILE_H

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// an array of numbers as it stands in a file, row by row
struct Number_array
{
  std::vector<std::uint64_t> shape;
  std::vector<double> values;
  bool is_ragged = false;               // rows of different lengths, as many as the shape says
  std::vector<std::uint64_t> row_sizes; // of a ragged array
  std::vector<std::string> columns;     // their names, if they have names
};

inline std::string shape_text(const std::vector<std::uint64_t>& shape)
{
  std::string text;
  for (const std::uint64_t size : shape)
    text += (text.empty() ? "" : " x ") + std::to_string(size);
  return text.empty() ? "of a single number" : text;
}

inline std::string shape_text(const Number_array& array)
{
  return shape_text(array.shape) + (array.is_ragged ? " rows of their own lengths" : "");
}

// returns whether the product could be computed
inline bool find_number_of_values(const std::vector<std::uint64_t>& shape, std::uint64_t& count)
{
  count = 1;
  for (const std::uint64_t size : shape)
  {
    if (size != 0 && count > (std::numeric_limits<std::uint64_t>::max)() / 16 / size)
      return false;
    count *= size;
  }
  return true;
}

// A file that holds arrays with names.
class Array_file
{
public:
  virtual ~Array_file() {}

  virtual const std::string& filename() const = 0;
  virtual const char* word_for_array() const = 0; // what the format calls an array
  virtual const std::vector<std::string>& names() const = 0;
  virtual std::string contents_text() = 0; // for messages
  virtual bool read(const std::string& name, Number_array& array, std::string& error) = 0;

  // whether an array is there that can be read by rows, and its shape
  virtual bool find_rows(const std::string&, std::vector<std::uint64_t>&) { return false; }
  virtual bool read_rows(const std::string&, std::uint64_t /*first*/, std::uint64_t /*count*/, std::vector<double>&,
                         std::string&)
  {
    return false;
  }
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_ARRAY_FILE_H
