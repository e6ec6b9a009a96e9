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

#include <CGAL/Wireframe_extraction/IO/internal/mesh/mesh_formats_impl.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Rounded_surface_impl.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_curves_impl.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_mesh_impl.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Triangle_mesh_impl.h>
#include <CGAL/Wireframe_extraction/internal/mesh/round_polyline_impl.h>
#include <CGAL/Wireframe_extraction/internal/mesh/sharp_edges_impl.h>
