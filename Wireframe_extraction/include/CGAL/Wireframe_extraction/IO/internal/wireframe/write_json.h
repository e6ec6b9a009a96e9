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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_JSON_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_JSON_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// Writes a wireframe as wireframe JSON; says what went wrong.
bool write_json(std::ostream& out, const Plain_wireframe& wireframe, const Wireframe_provenance& provenance,
                std::string& error);

} // namespace internal
} // namespace IO
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_json_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_JSON_H
