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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_CURVE_TOOLS_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_CURVE_TOOLS_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

typedef CGAL::Wireframe_extraction::internal::Spline_vector Spline_vector;

// of a point or a vector
template <class Position, class GeomTraits>
Spline_vector vector_of(const Position& position, const GeomTraits& traits)
{
  const Coordinates coordinates = coordinates_of(position, traits);
  return Spline_vector{coordinates[0], coordinates[1], coordinates[2]};
}

inline Spline_vector unit_vector(const Spline_vector& v) { return (1. / norm(v)) * v; }

// The parameters of a circle, an ellipse or an arc in double. Its axes are orthonormal to the last digit, which those
// of a wireframe need not be.
struct Orthonormal_conic
{
  Spline_vector center, x, axis; // the direction of the major axis, and the normal of the plane
  double major_radius, minor_radius, start_angle, sweep;
  bool is_full; // a whole turn, even if the curve is an arc that ends at its start
};

template <class GeomTraits>
Orthonormal_conic orthonormal_conic(const Wireframe_curve<GeomTraits>& curve, const GeomTraits& traits)
{
  const Wireframe_conic<GeomTraits>& conic = *curve.conic;
  Orthonormal_conic result;
  result.center = vector_of(conic.center, traits);
  result.axis = unit_vector(vector_of(conic.axis, traits));
  const Spline_vector x = vector_of(conic.major_direction, traits);
  result.x = unit_vector(x - dot(x, result.axis) * result.axis);
  result.major_radius = CGAL::to_double(conic.major_radius);
  result.minor_radius = (std::min)(CGAL::to_double(conic.minor_radius), result.major_radius);
  result.start_angle = CGAL::to_double(conic.start_angle);
  result.sweep = (std::min)(CGAL::to_double(conic.end_angle) - result.start_angle, 2. * CGAL_PI);
  result.is_full = curve.is_closed() || result.sweep > 2. * CGAL_PI - 1e-9;
  return result;
}

// the layer of a kind of curve, in the formats that have layers
inline const char* layer_of(Wireframe_curve_type type)
{
  switch (type)
  {
  case Wireframe_curve_type::LINE: return "LINES";
  case Wireframe_curve_type::CIRCLE: return "CIRCLES";
  case Wireframe_curve_type::ARC: return "ARCS";
  case Wireframe_curve_type::ELLIPSE: return "ELLIPSES";
  case Wireframe_curve_type::ELLIPTIC_ARC: return "ELLIPTIC_ARCS";
  default: return "SPLINES";
  }
}

// the colour in which a kind of curve is shown, the same in all formats that have colours
struct Colour
{
  int red, green, blue;
};

inline Colour colour_of(Wireframe_curve_type type)
{
  switch (type)
  {
  case Wireframe_curve_type::LINE: return {64, 64, 64};
  case Wireframe_curve_type::CIRCLE: return {214, 39, 40};
  case Wireframe_curve_type::ARC: return {255, 127, 14};
  case Wireframe_curve_type::ELLIPSE: return {31, 119, 180};
  case Wireframe_curve_type::ELLIPTIC_ARC: return {23, 162, 162};
  default: return {148, 60, 189};
  }
}

// as HTML and SVG have it
inline std::string hexadecimal(const Colour& colour)
{
  std::string text = "#";
  for (const int channel : {colour.red, colour.green, colour.blue})
    text += std::string(1, "0123456789abcdef"[channel / 16]) + "0123456789abcdef"[channel % 16];
  return text;
}

inline const std::array<Wireframe_doubt, 7>& all_doubts()
{
  static const std::array<Wireframe_doubt, 7> doubts = {
    {Wireframe_doubt::FREE_END, Wireframe_doubt::SHORT, Wireframe_doubt::LITTLE_SUPPORT, Wireframe_doubt::MISFIT,
     Wireframe_doubt::NO_FOLD, Wireframe_doubt::BESIDE_ANOTHER, Wireframe_doubt::UNCERTAIN_TYPE}};
  return doubts;
}

inline std::string names_of(const std::set<Wireframe_doubt>& doubts, const std::string& separator)
{
  std::string names;
  for (const Wireframe_doubt doubt : doubts)
    names += (names.empty() ? "" : separator) + to_string(doubt);
  return names;
}

inline const std::array<Wireframe_curve_type, 6>& all_curve_types()
{
  static const std::array<Wireframe_curve_type, 6> types = {
    {Wireframe_curve_type::BSPLINE, Wireframe_curve_type::LINE, Wireframe_curve_type::CIRCLE, Wireframe_curve_type::ARC,
     Wireframe_curve_type::ELLIPSE, Wireframe_curve_type::ELLIPTIC_ARC}};
  return types;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_CURVE_TOOLS_H
