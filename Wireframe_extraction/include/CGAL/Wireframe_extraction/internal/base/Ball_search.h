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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_BALL_SEARCH_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_BALL_SEARCH_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Ball queries over a vector of positions that stays where it is. Answers are indices.
class Ball_search
{
  struct Tree; // CGAL's kd-tree, which is costly to compile
  std::unique_ptr<Tree> m_tree;

public:
  Ball_search();
  explicit Ball_search(const std::vector<Vector>& positions);
  Ball_search(Ball_search&&);
  Ball_search& operator=(Ball_search&&);
  ~Ball_search();

  // indexes the first `count` positions; few of them may be equal
  void build(const std::vector<Vector>& positions, std::size_t count);

  // the indices of all positions, those of neighbors close to each other: who visits them in this order finds the
  // memory around them in the caches
  std::vector<std::size_t> spatial_order() const;

  // writes the indices of the positions closer than `radius` to `center` into `found`
  void query(const Vector& center, double radius, std::vector<std::size_t>& found) const;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/base/Ball_search_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_BALL_SEARCH_H
