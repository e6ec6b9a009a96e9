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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_READ_JSON_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_READ_JSON_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

#include <istream>
#include <string>

// A compiled core that was built without nlohmann_json leaves the reader to who includes it.
#if defined(CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY) || !defined(CGAL_WIREFRAME_EXTRACTION_COMPILED_JSON)
#define CGAL_WIREFRAME_EXTRACTION_JSON_INLINE inline
#define CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY_JSON
#else
#define CGAL_WIREFRAME_EXTRACTION_JSON_INLINE
#endif

namespace CGAL {
namespace IO {
namespace internal {

// Reads a wireframe of wireframe JSON, version 1 or 2, which is valid then, and where it comes from; else says what is
// wrong.
bool read_json(std::istream& stream, Plain_wireframe& wireframe, Wireframe_provenance& provenance, std::string& error);

} // namespace internal
} // namespace IO
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY_JSON
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/read_json_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_READ_JSON_H
