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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_LIBRARIES_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_LIBRARIES_H

#include <memory>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

class Array_file;
class Inflater;

// What libraries do that programs may be built without. What is compiled once does not know them: whoever calls it
// hands over what there is.
struct Cloud_libraries
{
  // null without zlib
  std::unique_ptr<Inflater> (*make_inflater)() = nullptr;
  // opens a file, or returns nothing and says why; null without HDF5
  std::unique_ptr<Array_file> (*open_hdf5)(const std::string& filename, std::string& error) = nullptr;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_LIBRARIES_H
