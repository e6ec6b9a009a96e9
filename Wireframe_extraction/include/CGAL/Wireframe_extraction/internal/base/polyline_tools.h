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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POLYLINE_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POLYLINE_TOOLS_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

inline double polyline_length(const std::vector<Vector>& polyline)
{
  double sum = 0.;
  for (std::size_t k = 1; k < polyline.size(); ++k)
    sum += (polyline[k] - polyline[k - 1]).norm();
  return sum;
}

// from the first point of a polyline to each of its points, where no segment counts for less than `least_step`
inline std::vector<double> arc_lengths(const std::vector<Vector>& polyline, double least_step = 0.)
{
  std::vector<double> lengths(polyline.size(), 0.);
  for (std::size_t k = 1; k < polyline.size(); ++k)
    lengths[k] = lengths[k - 1] + (std::max)(least_step, (polyline[k] - polyline[k - 1]).norm());
  return lengths;
}

// Goes along a polyline from its first point on.
class Polyline_walk
{
  const std::vector<Vector>& m_polyline;
  const std::vector<double>& m_lengths;
  std::size_t m_end = 1; // of the segment that was reached

public:
  // the polyline has at least two points, `lengths` are its arc lengths
  Polyline_walk(const std::vector<Vector>& polyline, const std::vector<double>& lengths)
    : m_polyline(polyline), m_lengths(lengths)
  {}

  // the point at the arc length s, which never decreases from call to call
  Vector advance_to(double s)
  {
    while (m_end + 1 < m_lengths.size() && m_lengths[m_end] < s)
      ++m_end;
    const double step = m_lengths[m_end] - m_lengths[m_end - 1];
    const double t = step > 0. ? (s - m_lengths[m_end - 1]) / step : 0.;
    return m_polyline[m_end - 1] + t * segment();
  }

  // the vector along the segment that was reached
  Vector segment() const { return m_polyline[m_end] - m_polyline[m_end - 1]; }
};

inline double squared_distance_to_segment(const Vector& p, const Vector& a, const Vector& b)
{
  const Vector direction = b - a;
  const double squared_length = direction.squaredNorm();
  const double s = squared_length > 0. ? (p - a).dot(direction) / squared_length : 0.;
  return (p - a - (std::min)(1., (std::max)(0., s)) * direction).squaredNorm();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POLYLINE_TOOLS_H
