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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CERES_SUPPORT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CERES_SUPPORT_H

// Ceres is included here only: its headers are heavy and not free of warnings.

#if defined(__GNUC__)
#pragma GCC system_header
#endif

#include <ceres/ceres.h>

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CERES_SUPPORT_H
