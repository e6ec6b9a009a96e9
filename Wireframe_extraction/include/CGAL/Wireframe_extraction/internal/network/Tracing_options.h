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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACING_OPTIONS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACING_OPTIONS_H

#include <CGAL/Wireframe_extraction/internal/field/Field_band.h>

#include <algorithm>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

struct Tracing_options
{
  double noise = 0.1; // typical residual of the field near curves
  double step = 0.5;
  double radius = 4.;        // of the balls the local fits use
  double maximum_gap = 3.;   // bridged without any evidence
  double maximum_turn = 0.6; // per step, in radians

  double tolerance() const { return agreement_tolerance(noise); }
  double maximum_doubt() const { return 0.25 + 4. * noise; }
  double fit_scale() const { return (std::max)(0.15, 2. * noise); }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TRACING_OPTIONS_H
