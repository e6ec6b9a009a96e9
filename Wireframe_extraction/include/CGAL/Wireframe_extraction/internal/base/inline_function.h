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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_INLINE_FUNCTION_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_INLINE_FUNCTION_H

// Functions that take nothing but plain values are declared in NAME.h and defined in NAME_impl.h. Who just includes
// gets both. Who links the compiled core, whose target defines CGAL_WIREFRAME_EXTRACTION_COMPILED, gets the
// declarations only, and need not compile them again.

#ifdef CGAL_WIREFRAME_EXTRACTION_COMPILED
#define CGAL_WIREFRAME_EXTRACTION_INLINE
#else
#define CGAL_WIREFRAME_EXTRACTION_INLINE inline
#define CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_INLINE_FUNCTION_H
