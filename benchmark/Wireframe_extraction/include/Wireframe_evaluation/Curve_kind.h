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

#ifndef WIREFRAME_EVALUATION_CURVE_KIND_H
#define WIREFRAME_EVALUATION_CURVE_KIND_H

#include <string>

namespace Wireframe_evaluation {

/// The kinds of curves that are told apart: arcs count as circles, everything that is no primitive as spline.
enum class Curve_kind
{
  SPLINE,
  LINE,
  CIRCLE,
  ELLIPSE
};

/// returns the kind for a name as it stands in files.
inline Curve_kind curve_kind(const std::string& name)
{
  if (name == "line")
    return Curve_kind::LINE;
  if (name == "circle" || name == "arc")
    return Curve_kind::CIRCLE;
  if (name == "ellipse" || name == "elliptic_arc")
    return Curve_kind::ELLIPSE;
  return Curve_kind::SPLINE;
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_CURVE_KIND_H
