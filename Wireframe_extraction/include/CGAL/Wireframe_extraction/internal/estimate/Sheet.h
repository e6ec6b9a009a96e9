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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A vector orthogonal to a unit vector, of length 1.
inline Vector orthogonal_to(const Vector& normal)
{
  static constexpr double largest_component = 0.6; // one of three is smaller
  const Vector axis = std::abs(normal.x()) < largest_component ? Vector(1., 0., 0.) : Vector(0., 1., 0.);
  return (axis - axis.dot(normal) * normal).normalized();
}

// A piece of a smooth surface: a quadratic height over a plane.
struct Sheet
{
  static constexpr int size = 6;

  Vector origin = Vector::Zero();
  Vector normal = Vector::Zero(), first = Vector::Zero(), second = Vector::Zero(); // of the plane, and two axes in it
  std::array<double, size> coefficients{};                                         // of 1, x, y, x^2, xy, y^2
  bool is_known = false;

  // lays the plane
  void set_plane(const Vector& through, const Vector& unit_normal)
  {
    origin = through;
    normal = unit_normal;
    first = orthogonal_to(normal);
    second = normal.cross(first);
    coefficients.fill(0.);
  }

  static std::array<double, size> monomials(double x, double y) { return {1., x, y, x * x, x * y, y * y}; }

  // how far a point lies above the sheet, to first order, and the sheet's normal there
  double offset(const Vector& point, Vector* normal_there = nullptr) const
  {
    const std::array<double, size>& c = coefficients;
    const Vector d = point - origin;
    const double x = d.dot(first), y = d.dot(second);
    const double slope_x = c[1] + 2. * c[3] * x + c[4] * y, slope_y = c[2] + c[4] * x + 2. * c[5] * y;
    const double scale = 1. / std::sqrt(1. + slope_x * slope_x + slope_y * slope_y);
    if (normal_there)
      *normal_there = (normal - slope_x * first - slope_y * second) * scale;
    return (d.dot(normal) - (c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y)) * scale;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_H
