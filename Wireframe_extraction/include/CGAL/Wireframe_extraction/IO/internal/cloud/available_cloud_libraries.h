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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_AVAILABLE_CLOUD_LIBRARIES_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_AVAILABLE_CLOUD_LIBRARIES_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Cloud_libraries.h>

#include <CGAL/config.h>

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Hdf5_file.h>
#endif
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Zlib_inflater.h>
#endif

#include <memory>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// the libraries that the program is built with
inline Cloud_libraries available_cloud_libraries()
{
  Cloud_libraries libraries;
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  libraries.make_inflater = [] { return std::unique_ptr<Inflater>(new Zlib_inflater); };
#endif
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
  libraries.open_hdf5 = [](const std::string& filename, std::string& error) {
    std::unique_ptr<Hdf5_file> file(new Hdf5_file(filename));
    return std::unique_ptr<Array_file>(file->open(error) ? file.release() : nullptr);
  };
#endif
  return libraries;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_AVAILABLE_CLOUD_LIBRARIES_H
