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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_NEIGHBOR_SCAN_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_NEIGHBOR_SCAN_H

#include <CGAL/Wireframe_extraction/internal/base/cell_key.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/position_search_traits.h>
#include <CGAL/Wireframe_extraction/internal/cloud/sampling_distance.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Finds the nearest different neighbors of some points of a cloud, by being shown all points of the cloud once, in
// whatever order.
class Neighbor_scan
{
  struct Neighbor
  {
    double squared_distance;
    Vector position;
    double field; // its distance to the nearest feature
  };

  struct Query
  {
    Vector position;
    double field;
    std::vector<Neighbor> neighbors; // the nearest ones so far, ascending

    // no point that is as far belongs to the neighbors
    double squared_reach() const
    {
      return neighbors.size() < density_neighbors ? (std::numeric_limits<double>::infinity)()
                                                  : neighbors.back().squared_distance;
    }

    void add(const Vector& p, double distance)
    {
      const double squared_distance = (p - position).squaredNorm();
      if (!(squared_distance < squared_reach()) || squared_distance == 0.)
        return;
      std::size_t i = neighbors.size();
      while (i > 0 && neighbors[i - 1].squared_distance > squared_distance)
        --i;
      for (std::size_t k = i; k > 0 && neighbors[k - 1].squared_distance == squared_distance; --k)
        if (neighbors[k - 1].position == p)
          return; // a duplicate
      if (neighbors.size() == density_neighbors)
        neighbors.pop_back();
      neighbors.insert(neighbors.begin() + static_cast<std::ptrdiff_t>(i), Neighbor{squared_distance, p, distance});
    }
  };

  // Cells of one size, and the queries whose balls reach into them: a hash table with open addressing, whose size is a
  // power of two.
  class Level
  {
    struct Entry
    {
      std::uint64_t key;
      std::uint32_t query, is_used;
    };

    static constexpr std::size_t first_size = 1024;
    static constexpr double largest_index = 1e15; // cells farther away are one: doubles count no farther exactly

    double m_per_cell;
    std::vector<Entry> m_entries;
    std::size_t m_size = 0;

  public:
    // `cell` is a power of two
    explicit Level(double cell) : m_per_cell(1. / cell), m_entries(first_size, Entry{0, 0, 0}) {}

    void add(std::uint32_t query, const Vector& p, double radius)
    {
      std::int64_t low[3], high[3];
      for (int k = 0; k < 3; ++k)
      {
        low[k] = index(p[k] - radius);
        high[k] = index(p[k] + radius);
      }
      for (std::int64_t i = low[0]; i <= high[0]; ++i)
        for (std::int64_t j = low[1]; j <= high[1]; ++j)
          for (std::int64_t k = low[2]; k <= high[2]; ++k)
            insert(cell_key(i, j, k), query);
    }

    // calls `use(query)` for the queries whose balls reach into the cell of a point, and for some whose cells have the
    // same key by chance
    template <class Use>
    void visit(const Vector& p, const Use& use) const
    {
      const std::uint64_t wanted = cell_key(index(p.x()), index(p.y()), index(p.z()));
      for (std::size_t slot = home(wanted); m_entries[slot].is_used; slot = (slot + 1) & (m_entries.size() - 1))
        if (m_entries[slot].key == wanted)
          use(m_entries[slot].query);
    }

  private:
    std::int64_t index(double x) const
    {
      const double k = std::floor(x * m_per_cell);
      return static_cast<std::int64_t>((std::max)(-largest_index, (std::min)(largest_index, k)));
    }

    std::size_t home(std::uint64_t key) const
    {
      const std::uint64_t mixed = key * 0x9e3779b97f4a7c15u;
      return static_cast<std::size_t>(mixed ^ (mixed >> 32)) & (m_entries.size() - 1);
    }

    void insert(std::uint64_t key, std::uint32_t query)
    {
      if (2 * (m_size + 1) > m_entries.size())
      {
        std::vector<Entry> entries(2 * m_entries.size(), Entry{0, 0, 0});
        entries.swap(m_entries);
        for (const Entry& entry : entries)
          if (entry.is_used)
            place(entry);
      }
      place(Entry{key, query, 1});
      ++m_size;
    }

    void place(const Entry& entry)
    {
      std::size_t slot = home(entry.key);
      while (m_entries[slot].is_used)
        slot = (slot + 1) & (m_entries.size() - 1);
      m_entries[slot] = entry;
    }
  };

  std::vector<Query> m_queries;
  std::vector<Level> m_levels; // each with cells twice as large as those of the one before, or larger

public:
  void add_query(const Vector& position, double distance) { m_queries.push_back(Query{position, distance, {}}); }

  // Starts with the neighbors within a sample of the cloud, which bound the distances. The sample holds all positions,
  // or more than there are neighbors.
  void start(const std::vector<Vector>& positions, const std::vector<double>& distances)
  {
    typedef Position_search_traits Traits;
    typedef CGAL::Orthogonal_k_neighbor_search<Traits> Search;
    typedef typename Search::Tree Tree;
    if (positions.empty())
      return;
    const Position_map map{positions.data()};
    Tree tree(boost::counting_iterator<std::size_t>(0), boost::counting_iterator<std::size_t>(positions.size()),
              typename Tree::Splitter(), Traits(map));
    tree.build();
    const typename Search::Distance metric(map);
    const unsigned int wanted =
      static_cast<unsigned int>((std::min)(density_neighbors + 1, positions.size())); // one may be the query itself
    std::map<int, Level> levels;
    for (std::size_t q = 0; q < m_queries.size(); ++q)
    {
      Query& query = m_queries[q];
      const Search search(tree, query.position, wanted, 0., true, metric);
      for (const auto& neighbor : search)
        query.add(positions[neighbor.first], distances[neighbor.first]);
      const double radius = std::sqrt(query.squared_reach());
      if (!std::isfinite(radius))
        continue; // so few positions: the sample has them all
      const int exponent = std::ilogb(radius) + 1;
      levels.emplace(exponent, Level(std::ldexp(1., exponent)))
        .first->second.add(static_cast<std::uint32_t>(q), query.position, radius);
    }
    for (auto& level : levels)
      m_levels.push_back(std::move(level.second));
  }

  // shows it a point of the cloud
  void add(const Vector& p, double distance)
  {
    for (const Level& level : m_levels)
      level.visit(p, [&](std::uint32_t q) { m_queries[q].add(p, distance); });
  }

  // shows it all points of the cloud; which may be neighbors is found out at the same time, block by block
  void add(const std::vector<Vector>& positions, const std::vector<double>& distances)
  {
    static constexpr std::size_t block = 16384; // points of a thread: they fit into its cache
    struct Hit
    {
      std::uint32_t query;
      std::size_t point;
    };
    const std::size_t at_once = block * concurrency();
    std::vector<std::vector<Hit>> hits(concurrency());
    for (std::size_t first = 0; first < positions.size(); first += at_once)
    {
      for_each_piece(
        hits.size(),
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t k = begin; k < end; ++k)
          {
            hits[k].clear();
            const std::size_t beyond = (std::min)(positions.size(), first + (k + 1) * block);
            for (std::size_t i = first + k * block; i < beyond; ++i)
              for (const Level& level : m_levels)
                level.visit(positions[i], [&](std::uint32_t q) {
                  if ((positions[i] - m_queries[q].position).squaredNorm() < m_queries[q].squared_reach())
                    hits[k].push_back({q, i});
                });
          }
        },
        1);
      for (const std::vector<Hit>& of_block : hits)
        for (const Hit& hit : of_block)
          m_queries[hit.query].add(positions[hit.point], distances[hit.point]);
    }
  }

  // what follows, once it was shown the cloud
  Cloud_scale scale() const
  {
    Density_measures measures;
    std::vector<std::pair<Vector, double>> field_around;
    for (const Query& query : m_queries)
    {
      if (query.neighbors.empty())
        continue;
      double slope = 0.;
      field_around.clear();
      for (const Neighbor& neighbor : query.neighbors)
      {
        slope = (std::max)(slope, std::abs(query.field - neighbor.field) / std::sqrt(neighbor.squared_distance));
        field_around.emplace_back(neighbor.position - query.position, neighbor.field);
      }
      measures.add_field(query.field, field_around);
      measures.add(query.neighbors.front().squared_distance, query.neighbors.back().squared_distance,
                   query.neighbors.size(), slope);
    }
    return measures.scale();
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_NEIGHBOR_SCAN_H
