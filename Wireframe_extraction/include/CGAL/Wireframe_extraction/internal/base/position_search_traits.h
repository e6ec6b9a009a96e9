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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POSITION_SEARCH_TRAITS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POSITION_SEARCH_TRAITS_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <CGAL/Search_traits.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

struct Construct_vector_coordinates
{
  typedef const double* result_type;
  const double* operator()(const Vector& p) const { return p.data(); }
  const double* operator()(const Vector& p, int) const { return p.data() + 3; }
};

struct Position_map
{
  typedef std::size_t key_type;
  typedef Vector value_type;
  typedef const Vector& reference;
  typedef boost::lvalue_property_map_tag category;

  const Vector* positions = nullptr;
  friend reference get(const Position_map& map, key_type i) { return map.positions[i]; }
  reference operator[](key_type i) const { return positions[i]; }
};

// Searches among positions, which are known by their indices.
typedef CGAL::Search_traits_adapter<
  std::size_t, Position_map,
  CGAL::Search_traits<double, Vector, const double*, Construct_vector_coordinates, CGAL::Dimension_tag<3>>>
  Position_search_traits;

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_POSITION_SEARCH_TRAITS_H
