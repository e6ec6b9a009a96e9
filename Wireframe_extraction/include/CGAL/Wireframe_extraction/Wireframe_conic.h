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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CONIC_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CONIC_H

#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgWireframeExtractionClasses

The parameters of a circle or an ellipse in space, or of an arc of one:
\f[ p(\varphi) = c + a \cos\varphi \; x + b \sin\varphi \; y, \qquad y = n \times x, \f]
with the center \f$ c \f$, the unit normal \f$ n \f$ of its plane (`axis`), the unit direction \f$ x \f$ of the major
axis (`major_direction`), and the radii \f$ a \ge b \f$ (the semi-axes; of a circle both are equal). The curve runs
counterclockwise, seen from the tip of the axis, from `start_angle` to `end_angle`. These are the parameters of a
STEP `CIRCLE` or `ELLIPSE` and of the DXF entities of these names.

Of a circle and its arcs, `major_direction` points to where the curve starts, so that `start_angle` is zero.

\tparam GeomTraits a model of `WireframeExtractionTraits_3`
*/
template <class GeomTraits>
struct Wireframe_conic
{
  typedef GeomTraits Geom_traits;                 ///< the traits class
  typedef typename GeomTraits::FT FT;             ///< the number type
  typedef typename GeomTraits::Point_3 Point_3;   ///< the point type
  typedef typename GeomTraits::Vector_3 Vector_3; ///< the vector type

  Point_3 center;           ///< the center
  Vector_3 axis;            ///< the unit normal of the plane, about which the curve runs counterclockwise
  Vector_3 major_direction; ///< the unit direction of the major axis, orthogonal to `axis`
  FT major_radius = FT(0);  ///< half the length of the major axis, in the unit of the points
  FT minor_radius = FT(0);  ///< half the length of the minor axis, in the unit of the points
  FT start_angle = FT(0);   ///< where the curve starts, in radians
  FT end_angle = FT(0);     ///< where it ends, in radians; larger than `start_angle`, by at most a full turn

  /// returns the point at an angle. Constant time.
  /// \param angle the angle, in radians
  /// \param traits the traits object; the default is a default constructed one
  Point_3 point(FT angle, const GeomTraits& traits = GeomTraits()) const
  {
    const double phi = CGAL::to_double(angle);
    return combination(std::cos(phi), std::sin(phi), traits);
  }

  /// returns the same curve as a rational B-spline of degree two, exact up to rounding, whose knots are multiples of
  /// the angles. Constant time.
  /// \param is_closed whether the curve is marked as closed; it has to be a full circle or ellipse then
  /// \param traits the traits object; the default is a default constructed one
  Spline_curve_3<GeomTraits> to_spline(bool is_closed = false, const GeomTraits& traits = GeomTraits()) const
  {
    const double begin = CGAL::to_double(start_angle), sweep = CGAL::to_double(end_angle) - begin;
    // a quarter of a turn at most for each piece; the last digit must not make one more
    const std::size_t pieces = std::size_t((std::max)(1., std::ceil(sweep / (0.5 * CGAL_PI) * (1. - 1e-6))));
    const double half = 0.5 * sweep / double(pieces), weight = std::cos(half);
    const double scale = CGAL::to_double(major_radius);
    std::vector<FT> knots(1, FT(scale * begin)), weights;
    std::vector<Point_3> points;
    for (std::size_t i = 0; i <= 2 * pieces; ++i)
    {
      const double phi = begin + half * double(i), w = i % 2 == 0 ? 1. : weight;
      points.push_back(is_closed && i == 2 * pieces ? points.front()
                                                    : combination(std::cos(phi) / w, std::sin(phi) / w, traits));
      weights.push_back(FT(w));
      if (i % 2 == 0)
        knots.insert(knots.end(), 2, FT(scale * phi));
    }
    knots.push_back(knots.back());
    return Spline_curve_3<GeomTraits>(2, std::move(knots), std::move(points), std::move(weights), is_closed, traits);
  }

private:
  typedef Wireframe_extraction::internal::Spline_vector Spline_vector;

  // of a point or a vector
  template <class Position>
  static Spline_vector to_vector(const Position& position, const GeomTraits& traits)
  {
    auto it = traits.construct_cartesian_const_iterator_3_object()(position);
    Spline_vector v;
    v.x = CGAL::to_double(*it++);
    v.y = CGAL::to_double(*it++);
    v.z = CGAL::to_double(*it);
    return v;
  }

  // center + major_radius * c * x + minor_radius * s * y
  Point_3 combination(double c, double s, const GeomTraits& traits) const
  {
    const Spline_vector x = to_vector(major_direction, traits), y = cross(to_vector(axis, traits), x);
    const Spline_vector p =
      to_vector(center, traits) + (CGAL::to_double(major_radius) * c) * x + (CGAL::to_double(minor_radius) * s) * y;
    return traits.construct_point_3_object()(FT(p.x), FT(p.y), FT(p.z));
  }
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_CONIC_H
