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

#include <CGAL/Wireframe_extraction/IO/internal/cloud/cloud_formats_impl.h>
#ifdef CGAL_WIREFRAME_EXTRACTION_COMPILED_JSON
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/read_json_impl.h>
#endif
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_csv_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_dxf_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_gltf_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_json_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_obj_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_ply_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_polylines_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_svg_impl.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_vtp_impl.h>
