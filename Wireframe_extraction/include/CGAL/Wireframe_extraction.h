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

#ifndef CGAL_WIREFRAME_EXTRACTION_H
#define CGAL_WIREFRAME_EXTRACTION_H

/// \file Wireframe_extraction.h
/// Includes all of the package but what reads and writes files, and `draw_wireframe.h`.

#include <CGAL/extract_wireframe.h>

#include <CGAL/Wireframe_extraction/Distance_cloud_filter.h>
#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Distance_patch.h>
#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/estimate_distance_field.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/Wireframe_extraction/find_doubts.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/fuse_distance_patches.h>
#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/recognize_curve_types.h>
#include <CGAL/Wireframe_extraction/refine_field.h>
#include <CGAL/Wireframe_extraction/sample_sharp_mesh.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>

#endif // CGAL_WIREFRAME_EXTRACTION_H
