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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PLAIN_TRAITS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PLAIN_TRAITS_H

#include <CGAL/double.h>

#include <array>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Traits whose points and vectors are three numbers. All calculation is in `double` anyway, so that what is compiled
// once for wireframes over these traits gives for all others what it would give for themselves.
struct Plain_traits
{
  typedef double FT;
  typedef std::array<double, 3> Point_3;
  typedef std::array<double, 3> Vector_3;

  struct Construct_point_3
  {
    Point_3 operator()(double x, double y, double z) const { return {{x, y, z}}; }
  };

  typedef Construct_point_3 Construct_vector_3;

  struct Construct_cartesian_const_iterator_3
  {
    const double* operator()(const Point_3& p) const { return p.data(); }
    const double* operator()(const Point_3& p, int) const { return p.data() + 3; }
  };

  Construct_point_3 construct_point_3_object() const { return Construct_point_3(); }
  Construct_vector_3 construct_vector_3_object() const { return Construct_vector_3(); }
  Construct_cartesian_const_iterator_3 construct_cartesian_const_iterator_3_object() const
  {
    return Construct_cartesian_const_iterator_3();
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PLAIN_TRAITS_H
