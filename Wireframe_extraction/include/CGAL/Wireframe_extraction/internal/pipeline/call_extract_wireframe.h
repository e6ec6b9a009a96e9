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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_EXTRACT_WIREFRAME_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_EXTRACT_WIREFRAME_H

#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Converting_visitor.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Extraction_request.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Plain_visitor.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/extract.h>
#include <CGAL/Wireframe_extraction/internal/spline/Wireframe_converter.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <functional>
#include <type_traits>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

template <class T>
T& referred(T& object)
{
  return object;
}
template <class T>
T& referred(std::reference_wrapper<T>& reference)
{
  return reference.get();
}

// The wireframe of a cloud, with the numbers and points of the traits; all between is calculated with plain numbers.
template <class ConcurrencyTag, class GeomTraits, class NamedParameters>
Wireframe<GeomTraits> call_extract_wireframe(Distance_cloud_source& source, const GeomTraits& traits,
                                             const NamedParameters& np, bool is_reading_timed)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  const Extraction_request request = extraction_request(np, is_reading_timed);
  Wireframe_extraction_report own_report;
  Wireframe_extraction_report& report =
    choose_parameter(get_parameter(np, internal_np::extraction_report), std::ref(own_report)).get();
  const auto run = [&](Plain_visitor& visitor) {
    return run_concurrently<ConcurrencyTag>([&] { return extract(source, request, visitor, report); });
  };
  const auto convert = [&](const Wireframe<Plain_traits>& wireframe) {
    const Plain_traits plain;
    return Wireframe_converter<Plain_traits, GeomTraits>(plain, traits)(wireframe);
  };
  auto given_visitor = choose_parameter(get_parameter(np, CGAL::internal_np::visitor), Default_visitor());
  auto& visitor = referred(given_visitor);
  typedef typename std::remove_reference<decltype(visitor)>::type Visitor;
  // which wants to see nothing, so that nothing is compiled to show it
  if constexpr (std::is_same<typename std::remove_const<Visitor>::type, Default_visitor>::value)
  {
    Plain_visitor no_visitor;
    return convert(run(no_visitor));
  }
  else
  {
    Converting_visitor<GeomTraits, Visitor> converting_visitor(visitor, traits);
    return convert(run(converting_visitor));
  }
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_CALL_EXTRACT_WIREFRAME_H
