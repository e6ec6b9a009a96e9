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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_SVG_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_SVG_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// Writes a wireframe as SVG, with the radii of circles and arcs if they are wanted; says what went wrong.
bool write_svg(std::ostream& out, const Plain_wireframe& wireframe, Wireframe_extraction::Length_unit unit,
               bool has_dimensions, std::string& error);

} // namespace internal
} // namespace IO
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_svg_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_SVG_H
