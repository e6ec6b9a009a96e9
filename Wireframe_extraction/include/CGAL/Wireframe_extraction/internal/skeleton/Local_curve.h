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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A short piece of curve: a parabola through `point` with unit tangent `tangent` and second derivative `bend`,
// perpendicular to the tangent.
struct Local_curve
{
  Vector point = Vector::Zero();
  Vector tangent = Vector::UnitX();
  Vector bend = Vector::Zero();

  Vector at(double s) const { return point + s * tangent + (0.5 * s * s) * bend; }
  Vector tangent_at(double s) const { return (tangent + s * bend).normalized(); }
  double parameter(const Vector& p) const { return (p - point).dot(tangent); }
  double distance(const Vector& p) const { return (p - at(parameter(p))).norm(); }

  // the same curve, seen from its point at s
  Local_curve ahead(double s) const
  {
    Local_curve result;
    result.point = at(s);
    result.tangent = tangent_at(s);
    result.bend = bend - bend.dot(result.tangent) * result.tangent;
    return result;
  }

  // moves `point` to where the curve passes `p`
  void move_along_to(const Vector& p) { *this = ahead(parameter(p)); }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_LOCAL_CURVE_H
