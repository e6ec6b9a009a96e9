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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_POLYLINES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_POLYLINES_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_polylines.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_polylines(std::ostream& out, const Plain_wireframe& wireframe, const Curve_sampling& sampling,
                     std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, sampling, sampled, error))
    return false;
  for (const std::vector<std::size_t>& polyline : sampled.polylines)
  {
    out << std::to_string(polyline.size());
    for (const std::size_t index : polyline)
      out << " " << to_text(sampled.points[index]);
    out << "\n";
  }
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_POLYLINES_IMPL_H
