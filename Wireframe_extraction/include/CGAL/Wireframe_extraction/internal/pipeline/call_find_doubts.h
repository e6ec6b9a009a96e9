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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_FIND_DOUBTS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_FIND_DOUBTS_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/add_doubts.h>
#include <CGAL/Wireframe_extraction/internal/spline/Wireframe_converter.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// find_doubts() for a stage that is called alone, on a wireframe of any traits
template <class ConcurrencyTag, class GeomTraits>
bool call_find_doubts(const Wireframe_skeleton<GeomTraits>& skeleton, Wireframe<GeomTraits>& wireframe,
                      Stage_call& call)
{
  if (!call.is_well())
    return false;
  const std::function<bool(double)> proceed = call.progress();
  const Plain_traits plain_traits;
  Wireframe<Plain_traits> plain =
    Wireframe_converter<GeomTraits, Plain_traits>(skeleton.traits(), plain_traits)(wireframe);
  bool is_complete = false;
  run_concurrently<ConcurrencyTag>([&] { is_complete = add_doubts(skeleton.data(), call.options(), plain, proceed); });
  for (std::size_t c = 0; c < wireframe.curves.size(); ++c)
    wireframe.curves[c].doubts = plain.curves[c].doubts;
  return is_complete || call.fail(Wireframe_extraction_report::Status::CANCELLED, "cancelled");
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_FIND_DOUBTS_H
