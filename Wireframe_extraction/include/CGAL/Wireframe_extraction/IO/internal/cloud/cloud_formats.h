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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_FORMATS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_FORMATS_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Cloud_libraries.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

#include <cstddef>
#include <istream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// Reads a cloud; the sink gets chunk after chunk of usable samples. Returns what went wrong, nothing if all went well.
std::string read_cloud(const std::string& filename, const Cloud_reader_options& options,
                       const Cloud_libraries& libraries, Sample_sink& sink, std::size_t& number_of_skipped);

// Reads a cloud out of a stream; `extension` is that of files of its format, with or without the dot.
std::string read_cloud_stream(std::istream& stream, const std::string& extension, const Cloud_reader_options& options,
                              const Cloud_libraries& libraries, Sample_sink& sink, std::size_t& number_of_skipped);

// Reads distances that come in a file of their own: an array, or text with one per line. Returns what went wrong,
// nothing if all went well.
std::string read_distances_file(const std::string& filename, const Cloud_reader_options& options,
                                const Cloud_libraries& libraries, Separate_distances& distances);

} // namespace internal
} // namespace IO
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/IO/internal/cloud/cloud_formats_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_CLOUD_FORMATS_H
