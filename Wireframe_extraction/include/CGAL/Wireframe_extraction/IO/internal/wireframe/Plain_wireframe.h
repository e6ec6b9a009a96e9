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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_PLAIN_WIREFRAME_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_PLAIN_WIREFRAME_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/spline/Wireframe_converter.h>

namespace CGAL {
namespace IO {
namespace internal {

using Wireframe_extraction::internal::Plain_traits;
using Wireframe_extraction::internal::Wireframe_converter;

typedef CGAL::Wireframe<Plain_traits> Plain_wireframe;
typedef CGAL::Wireframe_curve<Plain_traits> Plain_curve;
typedef CGAL::Wireframe_conic<Plain_traits> Plain_conic;
typedef CGAL::Spline_curve_3<Plain_traits> Plain_spline;

// for the writers
template <class GeomTraits>
Plain_wireframe plain_wireframe(const CGAL::Wireframe<GeomTraits>& wireframe, const GeomTraits& traits)
{
  const Plain_traits plain;
  return Wireframe_converter<GeomTraits, Plain_traits>(traits, plain)(wireframe);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_PLAIN_WIREFRAME_H
