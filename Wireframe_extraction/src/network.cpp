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

#include <CGAL/Wireframe_extraction/internal/network/build_graph_impl.h>
#include <CGAL/Wireframe_extraction/internal/network/find_corners_impl.h>
#include <CGAL/Wireframe_extraction/internal/network/separate_curves_impl.h>
