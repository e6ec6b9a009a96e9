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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_WIREFRAME_CONVERTER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_WIREFRAME_CONVERTER_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/coordinates.h>

#include <CGAL/number_utils.h>

#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Copies a wireframe from one kind of numbers, points and vectors to another.
template <class From, class To>
class Wireframe_converter
{
  typedef typename To::FT FT;
  typedef typename To::Point_3 Point_3;
  typedef typename To::Vector_3 Vector_3;

public:
  Wireframe_converter(const From& from, const To& to) : m_from(from), m_to(to) {}

  CGAL::Wireframe<To> operator()(const CGAL::Wireframe<From>& wireframe) const
  {
    CGAL::Wireframe<To> result;
    result.sampling_distance = number(wireframe.sampling_distance);
    result.vertices = points(wireframe.vertices);
    result.curves.reserve(wireframe.curves.size());
    for (const CGAL::Wireframe_curve<From>& curve : wireframe.curves)
      result.curves.push_back(convert(curve));
    return result;
  }

  FT number(const typename From::FT& value) const { return FT(CGAL::to_double(value)); }

  std::vector<FT> numbers(const std::vector<typename From::FT>& values) const
  {
    std::vector<FT> result;
    result.reserve(values.size());
    for (const typename From::FT& value : values)
      result.push_back(number(value));
    return result;
  }

  std::vector<Point_3> points(const std::vector<typename From::Point_3>& values) const
  {
    std::vector<Point_3> result;
    result.reserve(values.size());
    for (const typename From::Point_3& value : values)
      result.push_back(point(value));
    return result;
  }

private:
  Point_3 point(const typename From::Point_3& value) const
  {
    const Coordinates c = coordinates_of(value, m_from);
    return m_to.construct_point_3_object()(FT(c[0]), FT(c[1]), FT(c[2]));
  }

  Vector_3 vector(const typename From::Vector_3& value) const
  {
    const Coordinates c = coordinates_of(value, m_from);
    return m_to.construct_vector_3_object()(FT(c[0]), FT(c[1]), FT(c[2]));
  }

  CGAL::Wireframe_curve<To> convert(const CGAL::Wireframe_curve<From>& curve) const
  {
    CGAL::Wireframe_curve<To> result;
    result.type = curve.type;
    const auto& spline = curve.spline;
    if (!spline.is_empty())
      result.spline =
        CGAL::Spline_curve_3<To>(spline.degree(), numbers(spline.knots()), points(spline.control_points()),
                                 numbers(spline.weights()), spline.is_closed(), m_to);
    result.source = curve.source;
    result.target = curve.target;
    if (curve.conic)
      result.conic = convert(*curve.conic);
    result.uncertainty.position = number(curve.uncertainty.position);
    result.uncertainty.direction = number(curve.uncertainty.direction);
    result.uncertainty.major_radius = number(curve.uncertainty.major_radius);
    result.uncertainty.minor_radius = number(curve.uncertainty.minor_radius);
    result.rms = number(curve.rms);
    result.max = number(curve.max);
    result.support = curve.support;
    result.doubts = curve.doubts;
    return result;
  }

  CGAL::Wireframe_conic<To> convert(const CGAL::Wireframe_conic<From>& conic) const
  {
    CGAL::Wireframe_conic<To> result;
    result.center = point(conic.center);
    result.axis = vector(conic.axis);
    result.major_direction = vector(conic.major_direction);
    result.major_radius = number(conic.major_radius);
    result.minor_radius = number(conic.minor_radius);
    result.start_angle = number(conic.start_angle);
    result.end_angle = number(conic.end_angle);
    return result;
  }

  const From& m_from;
  const To& m_to;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_WIREFRAME_CONVERTER_H
