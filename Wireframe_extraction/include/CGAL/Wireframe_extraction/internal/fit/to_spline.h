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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_TO_SPLINE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_TO_SPLINE_H

#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/fit/Cubic_spline.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

template <class GeomTraits>
Spline_curve_3<GeomTraits> to_spline(const Cubic_spline& spline, bool is_closed,
                                     const Wireframe_skeleton<GeomTraits>& skeleton)
{
  typedef typename GeomTraits::FT FT;
  const Spline_data data = spline.to_data();
  std::vector<FT> knots;
  std::vector<typename GeomTraits::Point_3> points;
  for (double t : data.knots)
    knots.push_back(FT(t * skeleton.data().unit));
  for (const Spline_vector& p : data.points)
    points.push_back(skeleton.to_point(Vector(p.x, p.y, p.z)));
  return Spline_curve_3<GeomTraits>(data.degree, knots, points, is_closed, skeleton.traits());
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_TO_SPLINE_H
