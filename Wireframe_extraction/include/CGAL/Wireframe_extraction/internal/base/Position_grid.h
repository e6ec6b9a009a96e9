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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POSITION_GRID_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POSITION_GRID_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/cell_key.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Which positions lie closer to a place than a radius that is always the same. They come and go at any time.
class Position_grid
{
  struct Entry
  {
    std::size_t index;
    Vector position;
  };

  double m_radius, m_cell;
  std::unordered_map<std::uint64_t, std::vector<Entry>> m_cells;

  std::int64_t coordinate(double x) const { return static_cast<std::int64_t>(std::floor(x / m_cell)); }
  std::uint64_t key(const Vector& p) const { return cell_key(coordinate(p.x()), coordinate(p.y()), coordinate(p.z())); }

public:
  explicit Position_grid(double radius) : m_radius(radius), m_cell((std::max)(radius, 1.)) {}

  void add(std::size_t index, const Vector& p) { m_cells[key(p)].push_back({index, p}); }

  // what was added as this index at this position
  void remove(std::size_t index, const Vector& p)
  {
    std::vector<Entry>& entries = m_cells[key(p)];
    entries.erase(
      std::remove_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.index == index; }),
      entries.end());
  }

  // calls visitor(index) for each, in no order
  template <class Visitor>
  void visit(const Vector& p, const Visitor& visitor) const
  {
    const std::int64_t x = coordinate(p.x()), y = coordinate(p.y()), z = coordinate(p.z());
    for (std::int64_t i = x - 1; i <= x + 1; ++i)
      for (std::int64_t j = y - 1; j <= y + 1; ++j)
        for (std::int64_t k = z - 1; k <= z + 1; ++k)
        {
          const auto found = m_cells.find(cell_key(i, j, k));
          if (found == m_cells.end())
            continue;
          for (const Entry& entry : found->second)
            if ((entry.position - p).norm() < m_radius)
              visitor(entry.index);
        }
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POSITION_GRID_H
