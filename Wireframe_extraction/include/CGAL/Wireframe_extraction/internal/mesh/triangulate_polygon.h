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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGULATE_POLYGON_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGULATE_POLYGON_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Cuts a polygon, planar or nearly so, into triangles at its end of the list, by cutting off ears. It need not be
// convex. Of a quadrilateral the shorter diagonal is taken.
class Polygon_triangulator
{
public:
  typedef std::array<std::uint32_t, 3> Triangle;

  Polygon_triangulator(const std::vector<Vector>& points, const std::vector<std::size_t>& polygon) : m_points(points)
  {
    for (std::size_t v : polygon)
      m_rest.push_back(static_cast<std::uint32_t>(v));
    for (std::size_t i = 0; i < m_rest.size(); ++i)
      m_normal +=
        (points[m_rest[i]] - points[m_rest[0]]).cross(points[m_rest[(i + 1) % m_rest.size()]] - points[m_rest[0]]);
  }

  void triangulate(std::vector<Triangle>& triangles)
  {
    while (m_rest.size() > 3)
    {
      const std::size_t i = next_ear();
      triangles.push_back(ear(i));
      m_rest.erase(m_rest.begin() + static_cast<std::ptrdiff_t>(i));
    }
    triangles.push_back({m_rest[0], m_rest[1], m_rest[2]});
  }

private:
  Triangle ear(std::size_t i) const
  {
    const std::size_t n = m_rest.size();
    return {m_rest[(i + n - 1) % n], m_rest[i], m_rest[(i + 1) % n]};
  }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const
  {
    return (m_points[b] - m_points[a]).cross(m_points[c] - m_points[b]).dot(m_normal);
  }

  bool is_ear(const Triangle& t) const
  {
    if (!(turn(t[0], t[1], t[2]) > 0.))
      return false;
    return std::none_of(m_rest.begin(), m_rest.end(), [&](std::uint32_t v) {
      const bool is_of_ear = v == t[0] || v == t[1] || v == t[2];
      return !is_of_ear && turn(t[0], t[1], v) >= 0. && turn(t[1], t[2], v) >= 0. && turn(t[2], t[0], v) >= 0.;
    });
  }

  // the ear with the shortest diagonal; where there is none, as the polygon crosses itself, any
  std::size_t next_ear() const
  {
    std::size_t best = 0;
    double shortest = HUGE_VAL;
    for (std::size_t i = 0; i < m_rest.size(); ++i)
    {
      const Triangle t = ear(i);
      const double length = (m_points[t[0]] - m_points[t[2]]).squaredNorm();
      if (length < shortest && is_ear(t))
      {
        shortest = length;
        best = i;
        if (m_rest.size() > most_compared)
          break;
      }
    }
    return best;
  }

  // of polygons with more vertices the first ear is as good as any
  static constexpr std::size_t most_compared = 64;

  const std::vector<Vector>& m_points;
  std::vector<std::uint32_t> m_rest;
  Vector m_normal = Vector::Zero();
};

inline void triangulate_polygon(const std::vector<Vector>& points, const std::vector<std::size_t>& polygon,
                                std::vector<std::array<std::uint32_t, 3>>& triangles)
{
  Polygon_triangulator(points, polygon).triangulate(triangles);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGULATE_POLYGON_H
