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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_MEDIAN_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_MEDIAN_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// the upper one of an even number of values, 0 of none
inline double median(std::vector<double> values)
{
  if (values.empty())
    return 0.;
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

// the median of each coordinate: a few points, however far away, hardly move it
inline Vector median_position(const std::vector<Vector>& points)
{
  Vector result = Vector::Zero();
  std::vector<double> coordinates(points.size());
  for (int k = 0; k < 3; ++k)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      coordinates[i] = points[i][k];
    result[k] = median(coordinates);
  }
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_MEDIAN_H
