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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_SCALE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_SCALE_H

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Positions farther than that from the middle of the others, in sampling distances, belong to no shape: scanners write
// such points where they saw nothing.
constexpr double farthest_in_units = 1e9;

// what a field that is given as distances may be instead
enum class Field_meaning
{
  DISTANCE,
  SQUARED,
  EXPONENTIAL
};

struct Cloud_scale
{
  double sampling_distance = 0.;
  double slope = 0.;    // of the field between neighbors: about 1 if points and distances have the same unit
  double gradient = 0.; // along the surface, the upper quartile; 0 if it is not known
  Field_meaning meaning = Field_meaning::DISTANCE;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_SCALE_H
