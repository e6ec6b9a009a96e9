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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_UNNAMED_COLUMNS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_UNNAMED_COLUMNS_H

#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Tells what stands behind the coordinates of a text without names, as far as the numbers of several rows do. One row
// does not: 0 0 1 is a normal as well as a colour or a distance and more.
class Unnamed_columns
{
public:
  explicit Unnamed_columns(std::size_t count) : m_may_be_colour(count, true) {}

  // rows of other lengths are for others to complain about
  void add(const std::vector<std::string_view>& fields)
  {
    if (fields.size() != m_may_be_colour.size())
      return;
    for (std::size_t i = 3; i < fields.size(); ++i)
    {
      std::size_t value;
      m_may_be_colour[i] = m_may_be_colour[i] && parse_count(fields[i], value) && value < 256;
    }
    if (fields.size() > 5)
      add_vector(fields);
  }

  // whether columns 4 to 6 are vectors of length 1
  bool have_normals() const
  {
    static constexpr double least_share = 0.9;
    return m_number_of_units > 0 && double(m_number_of_units) >= least_share * double(m_number_of_vectors);
  }

  // whether three columns are red, green and blue: whole numbers up to 255
  bool have_colours(std::size_t first) const
  {
    return first + 3 <= m_may_be_colour.size() && !have_normals()
      && std::all_of(m_may_be_colour.begin() + std::ptrdiff_t(first),
                     m_may_be_colour.begin() + std::ptrdiff_t(first) + 3, [](bool may_be) { return may_be; });
  }

private:
  // 0 0 0, and what is not finite, stand for a normal that is not known
  void add_vector(const std::vector<std::string_view>& fields)
  {
    double square = 0.;
    for (std::size_t i = 3; i < 6; ++i)
    {
      double value = 0.;
      if (!parse_number(fields[i], value))
      {
        ++m_number_of_vectors; // which it is not
        return;
      }
      square += value * value;
    }
    if (!std::isfinite(square) || square == 0.)
      return;
    ++m_number_of_vectors;
    static constexpr double tolerance = 0.02; // of the squared length: normals may be written with two digits
    m_number_of_units += std::abs(square - 1.) < tolerance ? 1 : 0;
  }

  std::vector<bool> m_may_be_colour; // of the columns
  std::size_t m_number_of_vectors = 0, m_number_of_units = 0;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_UNNAMED_COLUMNS_H
