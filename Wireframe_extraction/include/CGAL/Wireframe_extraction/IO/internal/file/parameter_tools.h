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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_PARAMETER_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_PARAMETER_TOOLS_H

#include <CGAL/Wireframe_extraction/IO/internal/file/write_beside_and_rename.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// hands a text to the caller if the named parameter `error_message` was given
template <class NamedParameters>
void set_error_message(const NamedParameters& np, const std::string& text)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  std::string* const target = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::error_message), static_cast<std::string*>(nullptr));
  if (target != nullptr)
    *target = text;
}

// hands a text to the caller and returns whether it is empty, that is, whether all went well
template <class NamedParameters>
bool report(const NamedParameters& np, const std::string& error)
{
  set_error_message(np, error);
  return error.empty();
}

// the traits object that was given, else a default constructed one
template <class GeomTraits, class NamedParameters>
GeomTraits get_geom_traits(const NamedParameters& np)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::geom_traits),
                                            GeomTraits());
}

// where the wireframe comes from, if that is told
template <class NamedParameters>
Wireframe_provenance get_provenance(const NamedParameters& np)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  return CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::provenance),
                                            Wireframe_provenance());
}

// writes by `write(stream, error)` into a stream, tells the caller what went wrong, and returns whether all
// is there
template <class NamedParameters, class Write>
bool write_to_stream(std::ostream& stream, const NamedParameters& np, Write&& write)
{
  std::string error;
  if (write(stream, error) && !stream.flush())
    error = "the stream does not take the data";
  return report(np, error);
}

// the same into a file, which is written as a whole or not at all
template <class NamedParameters, class Write>
bool write_to_file(const std::string& filename, const NamedParameters& np, Write&& write)
{
  std::string error;
  write_beside_and_rename(filename, write, error);
  return report(np, error);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_FILE_PARAMETER_TOOLS_H
