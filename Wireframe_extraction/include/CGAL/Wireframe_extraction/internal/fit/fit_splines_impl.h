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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_SPLINES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_SPLINES_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/fit/Spline_network_fit.h>
#include <CGAL/Wireframe_extraction/internal/fit/fit_splines.h>

#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE bool fit_splines(const Skeleton_data& skeleton, const Extraction_options& options,
                                                  std::vector<Vector>& vertices, std::vector<Fitted_curve>& curves,
                                                  const std::function<bool(double)>& proceed)
{
  Spline_network_fit fit(*skeleton.band, skeleton.noise(options), options, vertices, curves);
  Progress progress(proceed);
  const bool is_complete = fit.run(progress);
  vertices = fit.vertices();
  curves = fit.curves();
  return is_complete;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_FIT_SPLINES_IMPL_H
