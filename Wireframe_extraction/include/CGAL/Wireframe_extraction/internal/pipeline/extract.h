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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACT_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Extraction_request.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Plain_visitor.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Runs all stages on a cloud, and reports how it went. The wireframe is empty if the report has something to say.
Wireframe<Plain_traits> extract(Distance_cloud_source& source, const Extraction_request& request,
                                Plain_visitor& visitor, Wireframe_extraction_report& report);

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/pipeline/extract_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACT_H
