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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_READ_SEPARATE_DISTANCES_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_READ_SEPARATE_DISTANCES_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Text_table.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cmath>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// reads a text file of one distance per line
inline bool read_separate_distances(std::istream& stream, const std::string& filename, Separate_distances& distances,
                                    std::string& error)
{
  Text_table table(stream, filename);
  std::vector<std::string_view> fields;
  distances.filename = filename;
  bool has_names = false;
  Text_table::Row row;
  while ((row = table.next_row(fields)) == Text_table::Row::DATA)
  {
    double value = 0.;
    if (fields.size() == 1 && parse_number(fields[0], value))
    {
      if (distances.first_bad_line == 0 && !(std::isfinite(value) && value >= 0.))
        distances.first_bad_line = table.line_number();
      distances.values.push_back(value);
    }
    else if (distances.values.empty() && !has_names && fields.size() == 1 && !looks_like_number(fields[0]))
      has_names = true;
    else
    {
      table.fail_at_line(fields.size() == 1
                           ? "the distance is " + no_number_text(fields[0])
                           : "a distances file has one number per line, this line has " + std::to_string(fields.size())
                             + " columns; remove all but the "
                               "distance, and write decimals with a point");
      break;
    }
  }
  error = table.error();
  if (error.empty() && distances.values.empty())
    error = filename + ": "
      + (table.is_empty_file() ? empty_file_text() : "holds no distances; write one for each point into it");
  return error.empty();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_READ_SEPARATE_DISTANCES_H
