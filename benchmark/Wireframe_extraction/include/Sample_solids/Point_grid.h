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

#ifndef SAMPLE_SOLIDS_POINT_GRID_H
#define SAMPLE_SOLIDS_POINT_GRID_H

#include <Sample_solids/geometry.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace Sample_solids {

/// Points in the cells of a hash grid: adding one takes constant time, visiting a ball the time of its cells.
/// The cells are kept in blocks of 4 x 4 x 4, so neighbouring cells are near in memory, too.
class Point_grid
{
public:
  /// \param cell_size  the side of a cell
  /// \param expected   the number of points to come (it may be exceeded)
  Point_grid(double cell_size, std::size_t expected) : m_inverse_cell(1. / cell_size), m_slots(64)
  {
    m_points.reserve(expected);
    m_next.reserve(expected);
  }

  std::size_t size() const { return m_points.size(); }
  const std::vector<Point>& get_points() const { return m_points; }

  void add(const Point& p)
  {
    if (2 * m_blocks.size() >= m_slots.size())
      grow();
    const std::int64_t i = coordinate(p[0]), j = coordinate(p[1]), k = coordinate(p[2]);
    Slot& slot = m_slots[find(key(i, j, k), m_slots)];
    if (slot.block == none)
    {
      slot = {key(i, j, k), static_cast<std::uint32_t>(m_blocks.size())};
      m_blocks.emplace_back();
      m_blocks.back().fill(none);
    }
    std::uint32_t& head = m_blocks[slot.block][cell_in_block(i, j, k)];
    m_next.push_back(head);
    head = static_cast<std::uint32_t>(m_points.size());
    m_points.push_back(p);
  }

  /// calls `visit(index, squared distance)` for all points nearer to `p` than `radius`, until that returns
  /// false; returns whether it did not.
  template <class Visitor>
  bool visit_ball(const Point& p, double radius, Visitor visit) const
  {
    std::array<std::int64_t, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k)
    {
      low[k] = coordinate(p[k] - radius);
      high[k] = coordinate(p[k] + radius);
    }
    std::uint64_t last = ~std::uint64_t(0);
    std::uint32_t block = none;
    for (std::int64_t i = low[0]; i <= high[0]; ++i)
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
        for (std::int64_t k = low[2]; k <= high[2]; ++k)
        {
          const std::uint64_t now = key(i, j, k);
          if (now != last)
            block = m_slots[find(now, m_slots)].block;
          last = now;
          if (block != none && !visit_cell(m_blocks[block][cell_in_block(i, j, k)], p, radius, visit))
            return false;
        }
    return true;
  }

  bool has_point_within(const Point& p, double radius) const
  {
    return !visit_ball(p, radius, [](std::size_t, double) { return false; });
  }

private:
  static constexpr std::uint32_t none = (std::numeric_limits<std::uint32_t>::max)();

  struct Slot
  {
    std::uint64_t key = 0;
    std::uint32_t block = none;
  };

  template <class Visitor>
  bool visit_cell(std::uint32_t head, const Point& p, double radius, Visitor& visit) const
  {
    for (std::uint32_t n = head; n != none; n = m_next[n])
    {
      const double d = squared_distance(m_points[n], p);
      if (d < radius * radius && !visit(n, d))
        return false;
    }
    return true;
  }

  std::int64_t coordinate(double x) const { return static_cast<std::int64_t>(std::floor(x * m_inverse_cell)); }

  /// the key of the block of a cell
  static std::uint64_t key(std::int64_t i, std::int64_t j, std::int64_t k)
  {
    const auto part = [](std::int64_t x) {
      return (static_cast<std::uint64_t>(x + (std::int64_t(1) << 22)) >> 2) & ((std::uint64_t(1) << 21) - 1);
    };
    return (part(i) << 42) | (part(j) << 21) | part(k);
  }

  static std::size_t cell_in_block(std::int64_t i, std::int64_t j, std::int64_t k)
  {
    return static_cast<std::size_t>(((i & 3) << 4) | ((j & 3) << 2) | (k & 3));
  }

  static std::size_t find(std::uint64_t key, const std::vector<Slot>& table)
  {
    std::size_t i = static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ull) >> 24) & (table.size() - 1);
    while (table[i].block != none && table[i].key != key)
      i = (i + 1) & (table.size() - 1);
    return i;
  }

  void grow()
  {
    std::vector<Slot> larger(2 * m_slots.size());
    for (const Slot& slot : m_slots)
      if (slot.block != none)
        larger[find(slot.key, larger)] = slot;
    m_slots.swap(larger);
  }

  double m_inverse_cell;
  std::vector<Slot> m_slots;
  std::vector<std::array<std::uint32_t, 64>> m_blocks; ///< per cell its last point
  std::vector<Point> m_points;
  std::vector<std::uint32_t> m_next; ///< per point the one before it in its cell
};

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_POINT_GRID_H
