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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_UNIT_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_UNIT_TOOLS_H

#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/policies.h>

namespace CGAL {
namespace IO {
namespace internal {

// the named parameter `unit`
template <class NamedParameters>
CGAL::Wireframe_extraction::Length_unit get_length_unit(const NamedParameters& np)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::unit),
                                            CGAL::Wireframe_extraction::Length_unit::MILLIMETER);
}

inline double meters_of(CGAL::Wireframe_extraction::Length_unit unit)
{
  typedef CGAL::Wireframe_extraction::Length_unit Length_unit;
  switch (unit)
  {
  case Length_unit::MICROMETER: return 1e-6;
  case Length_unit::CENTIMETER: return 0.01;
  case Length_unit::METER: return 1.;
  case Length_unit::INCH: return 0.0254;
  case Length_unit::FOOT: return 0.3048;
  default: return 0.001;
  }
}

// in ASCII
inline const char* symbol_of(CGAL::Wireframe_extraction::Length_unit unit)
{
  typedef CGAL::Wireframe_extraction::Length_unit Length_unit;
  switch (unit)
  {
  case Length_unit::MICROMETER: return "um";
  case Length_unit::CENTIMETER: return "cm";
  case Length_unit::METER: return "m";
  case Length_unit::INCH: return "in";
  case Length_unit::FOOT: return "ft";
  default: return "mm";
  }
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_UNIT_TOOLS_H
