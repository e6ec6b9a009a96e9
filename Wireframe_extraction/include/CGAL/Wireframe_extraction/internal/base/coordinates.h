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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_COORDINATES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_COORDINATES_H

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

typedef std::array<double, 3> Coordinates;

// of a point or a vector
template <class Position, class GeomTraits>
Coordinates coordinates_of(const Position& point, const GeomTraits& traits)
{
  Coordinates coordinates;
  auto iterator = traits.construct_cartesian_const_iterator_3_object()(point);
  for (double& coordinate : coordinates)
    coordinate = CGAL::to_double(*iterator++);
  return coordinates;
}

inline bool is_finite_point(const Coordinates& point)
{
  return std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_COORDINATES_H
