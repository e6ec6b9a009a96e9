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

#include <CGAL/Wireframe_extraction/internal/spline/Arc_length_table_impl.h>
#include <CGAL/Wireframe_extraction/internal/spline/Spline_projector_impl.h>
#include <CGAL/Wireframe_extraction/internal/spline/local_shape_impl.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis_impl.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_pieces_impl.h>
