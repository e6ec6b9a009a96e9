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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_DOUBT_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_DOUBT_H

#include <string>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// A reason to look at a curve of a wireframe before it is relied on.
enum class Wireframe_doubt
{
  FREE_END,       ///< no other curve goes on where it ends
  SHORT,          ///< it is shorter than errors of the field can be wide: 5 sampling distances, and more with noise
  LITTLE_SUPPORT, ///< fewer points support it than its length and the cloud's density there ask for
  MISFIT,         ///< its residuals are larger than the noise of the field explains
  NO_FOLD,        ///< the surface does not clearly show a fold along it
  BESIDE_ANOTHER, ///< it runs beside another curve, so close that one may be an error
  UNCERTAIN_TYPE  ///< it is a spline, but a line, circle or ellipse would fit it nearly well enough
};

/// \ingroup PkgWireframeExtractionFunctions
/// returns the name of a reason as all files have it: "free_end", "short", "little_support", "misfit", "no_fold",
/// "beside_another" or "uncertain_type". Constant time.
///
/// \param doubt the reason
inline std::string to_string(Wireframe_doubt doubt)
{
  switch (doubt)
  {
  case Wireframe_doubt::FREE_END: return "free_end";
  case Wireframe_doubt::SHORT: return "short";
  case Wireframe_doubt::LITTLE_SUPPORT: return "little_support";
  case Wireframe_doubt::MISFIT: return "misfit";
  case Wireframe_doubt::NO_FOLD: return "no_fold";
  case Wireframe_doubt::BESIDE_ANOTHER: return "beside_another";
  default: return "uncertain_type";
  }
}

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_DOUBT_H
