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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CALL_RECOGNIZE_CURVE_TYPES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CALL_RECOGNIZE_CURVE_TYPES_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/types/recognize_types.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// recognize_types() for a stage that is called alone; empty after cancelling
template <class ConcurrencyTag, class GeomTraits>
Wireframe<GeomTraits> call_recognize_curve_types(const Wireframe_skeleton<GeomTraits>& skeleton,
                                                 const Wireframe<GeomTraits>& wireframe, Stage_call& call)
{
  call.report().regularities.clear();
  Wireframe<GeomTraits> result;
  if (!call.is_well())
    return result;
  const std::function<bool(double)> proceed = call.progress();
  run_concurrently<ConcurrencyTag>([&] {
    if (!recognize_types(skeleton, wireframe, call.options(), proceed, result, call.report().regularities))
      call.fail(Wireframe_extraction_report::Status::CANCELLED, "cancelled");
  });
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CALL_RECOGNIZE_CURVE_TYPES_H
