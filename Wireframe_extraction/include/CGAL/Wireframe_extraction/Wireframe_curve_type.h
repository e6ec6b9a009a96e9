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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CURVE_TYPE_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CURVE_TYPE_H

#include <string>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// The kind of a curve of a wireframe. Whatever its kind, a curve has its B-spline form.
enum class Wireframe_curve_type
{
  BSPLINE,     ///< a B-spline that is none of the others
  LINE,        ///< a line segment
  CIRCLE,      ///< a full circle
  ARC,         ///< an arc of a circle
  ELLIPSE,     ///< a full ellipse
  ELLIPTIC_ARC ///< an arc of an ellipse
};

/// \ingroup PkgWireframeExtractionFunctions
/// returns whether curves of this kind have a `Wireframe_curve::conic`. Constant time.
///
/// \param type the kind
inline bool is_conic(Wireframe_curve_type type)
{
  return type != Wireframe_curve_type::BSPLINE && type != Wireframe_curve_type::LINE;
}

/// \ingroup PkgWireframeExtractionFunctions
/// returns the name of a kind of curves as all files have it: "bspline", "line", "circle", "arc", "ellipse" or
/// "elliptic_arc". Constant time.
///
/// \param type the kind
inline std::string to_string(Wireframe_curve_type type)
{
  switch (type)
  {
  case Wireframe_curve_type::LINE: return "line";
  case Wireframe_curve_type::CIRCLE: return "circle";
  case Wireframe_curve_type::ARC: return "arc";
  case Wireframe_curve_type::ELLIPSE: return "ellipse";
  case Wireframe_curve_type::ELLIPTIC_ARC: return "elliptic_arc";
  default: return "bspline";
  }
}

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CURVE_TYPE_H
