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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SEGMENT_GRID_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SEGMENT_GRID_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/cell_key.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Which segments of the polylines pass near a position. Polylines can be added and removed at any time.
class Segment_grid
{
public:
  static constexpr std::size_t no_curve = static_cast<std::size_t>(-1);

private:
  struct Entry
  {
    std::size_t curve, segment;
    Vector from, to;
  };

  double m_cell;
  std::unordered_map<std::uint64_t, std::vector<Entry>> m_cells;

  std::array<std::int64_t, 3> cell_of(const Vector& p) const
  {
    return {static_cast<std::int64_t>(std::floor(p.x() / m_cell)),
            static_cast<std::int64_t>(std::floor(p.y() / m_cell)),
            static_cast<std::int64_t>(std::floor(p.z() / m_cell))};
  }

public:
  struct Hit
  {
    double distance = (std::numeric_limits<double>::infinity)();
    std::size_t curve = no_curve, segment = 0;
    Vector point = Vector::Zero(), direction = Vector::UnitX();
    bool is_valid() const { return curve != no_curve; }
  };

  // r, about the largest radius that is asked for: a query looks at few cells
  static constexpr double default_cell = 4.;
  explicit Segment_grid(double cell = default_cell) : m_cell(cell) {}

  // long segments are entered piece by piece, each in the cell of its middle
  void add(std::size_t curve, const std::vector<Vector>& points)
  {
    for (std::size_t k = 1; k < points.size(); ++k)
    {
      const Vector step = points[k] - points[k - 1];
      const std::size_t pieces = 1 + static_cast<std::size_t>(step.norm() / (0.5 * m_cell));
      for (std::size_t j = 0; j < pieces; ++j)
      {
        const Vector from = points[k - 1] + step * (double(j) / pieces);
        const Vector to = points[k - 1] + step * (double(j + 1) / pieces);
        const std::array<std::int64_t, 3> cell = cell_of(0.5 * (from + to));
        m_cells[cell_key(cell[0], cell[1], cell[2])].push_back({curve, k - 1, from, to});
      }
    }
  }

  // calls visitor(hit) for every piece of a segment closer than `radius` to `p`
  template <class Visitor>
  void visit(const Vector& p, double radius, const Visitor& visitor) const
  {
    const double reach = radius + 0.25 * m_cell; // a piece's middle may be that much farther away
    const std::array<std::int64_t, 3> low = cell_of(p - Vector::Constant(reach)),
                                      high = cell_of(p + Vector::Constant(reach));
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
        {
          const auto found = m_cells.find(cell_key(x, y, z));
          if (found == m_cells.end())
            continue;
          for (const Entry& entry : found->second)
          {
            const Vector direction = entry.to - entry.from;
            const double length = direction.norm();
            if (!(length > 0.))
              continue;
            const double s = (p - entry.from).dot(direction) / (length * length);
            Hit hit;
            hit.point = entry.from + (std::min)(1., (std::max)(0., s)) * direction;
            hit.distance = (p - hit.point).norm();
            if (hit.distance >= radius)
              continue;
            hit.curve = entry.curve;
            hit.segment = entry.segment;
            hit.direction = direction / length;
            visitor(hit);
          }
        }
  }

  // the nearest piece closer than `radius` among those that `accept` takes
  template <class Accept>
  Hit nearest(const Vector& p, double radius, const Accept& accept) const
  {
    Hit best;
    visit(p, radius, [&](const Hit& hit) {
      if (hit.distance < best.distance && accept(hit))
        best = hit;
    });
    return best;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_SEGMENT_GRID_H
