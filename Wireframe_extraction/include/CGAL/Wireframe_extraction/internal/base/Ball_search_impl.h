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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_BALL_SEARCH_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_BALL_SEARCH_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/position_search_traits.h>

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Splitters.h>
#include <CGAL/tags.h>

#include <boost/iterator/counting_iterator.hpp>

#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

struct Ball_search::Tree
{
  typedef CGAL::Sliding_midpoint<Position_search_traits> Splitter;
  typedef CGAL::Kd_tree<Position_search_traits, Splitter, CGAL::Tag_true, CGAL::Tag_true> Kd_tree;
  typedef CGAL::Fuzzy_sphere<Position_search_traits> Ball;

  Kd_tree tree;

  Tree(const std::vector<Vector>& positions, std::size_t count)
    : tree(boost::counting_iterator<std::size_t>(0), boost::counting_iterator<std::size_t>(count), Splitter(),
           Position_search_traits(Position_map{positions.data()}))
  {
    tree.build();
  }
};

CGAL_WIREFRAME_EXTRACTION_INLINE Ball_search::Ball_search() {}
CGAL_WIREFRAME_EXTRACTION_INLINE Ball_search::Ball_search(const std::vector<Vector>& positions)
{
  build(positions, positions.size());
}
CGAL_WIREFRAME_EXTRACTION_INLINE Ball_search::Ball_search(Ball_search&&) = default;
CGAL_WIREFRAME_EXTRACTION_INLINE Ball_search& Ball_search::operator=(Ball_search&&) = default;
CGAL_WIREFRAME_EXTRACTION_INLINE Ball_search::~Ball_search() {}

CGAL_WIREFRAME_EXTRACTION_INLINE void Ball_search::build(const std::vector<Vector>& positions, std::size_t count)
{
  m_tree.reset();
  if (count > 0)
    m_tree = std::make_unique<Tree>(positions, count);
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::vector<std::size_t> Ball_search::spatial_order() const
{
  return m_tree ? std::vector<std::size_t>(m_tree->tree.begin(), m_tree->tree.end()) : std::vector<std::size_t>();
}

CGAL_WIREFRAME_EXTRACTION_INLINE void Ball_search::query(const Vector& center, double radius,
                                                         std::vector<std::size_t>& found) const
{
  found.clear();
  if (m_tree)
    m_tree->tree.search(std::back_inserter(found), Tree::Ball(center, radius, 0., m_tree->tree.traits()));
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_BALL_SEARCH_IMPL_H
