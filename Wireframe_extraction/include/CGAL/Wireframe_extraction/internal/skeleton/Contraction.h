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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CONTRACTION_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CONTRACTION_H

#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Traced_curve.h>

#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// For every skeleton point the local curve that the field draws near it.
struct Contraction
{
  std::vector<Local_curve> curves;
  std::vector<double> residuals;     // of the field close to the foot, in sampling distances
  std::vector<double> own_residuals; // the same without the points that are other curves'
  bool has_several_curves = false;   // whether fits of several curves told which is whose
  double noise = 0.;                 // the median of the residuals
  std::vector<Traced_curve> creases; // curves along creases of the surface, where these were looked for

  // Residuals of exact fields are about 0.01 r, those of a regressor's 0.25 r: from here on the surface may know more.
  static constexpr double least_noise = 0.03;

  // whether the field is so good that the surface adds nothing
  bool is_precise() const { return noise < least_noise; }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CONTRACTION_H
