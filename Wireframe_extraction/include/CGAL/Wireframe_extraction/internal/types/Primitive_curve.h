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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_CURVE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_CURVE_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <CGAL/number_type_basic.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

enum class Primitive_kind
{
  LINE,
  CIRCLE,
  ELLIPSE
};

// A whole line, circle or ellipse in space.
struct Primitive_curve
{
  static constexpr int most_parameters = 8;

  Primitive_kind kind = Primitive_kind::LINE;
  Vector center = Vector::Zero();
  Vector axis = Vector::UnitZ();  // of a line its direction, else the normal of the plane
  Vector major = Vector::UnitX(); // orthogonal to the axis; without meaning for a line
  double major_radius = 0., minor_radius = 0.;

  static Primitive_curve line(const Vector& from, const Vector& to)
  {
    Primitive_curve result;
    result.center = 0.5 * (from + to);
    result.axis = (to - from).normalized();
    return result;
  }

  // the circle that runs from `a` through `b` to `c`, counterclockwise about its axis
  static Primitive_curve circle(const Vector& a, const Vector& b, const Vector& c)
  {
    Primitive_curve result;
    result.kind = Primitive_kind::CIRCLE;
    const Vector u = b - a, v = c - a, n = u.cross(v);
    const double nn = (std::max)(n.squaredNorm(), 1e-30);
    const Vector to_center = (u.squaredNorm() * v.cross(n) + v.squaredNorm() * n.cross(u)) / (2. * nn);
    result.center = a + to_center;
    result.axis = n / std::sqrt(nn);
    result.major_radius = result.minor_radius = to_center.norm();
    result.major = -to_center / (std::max)(result.major_radius, 1e-30);
    return result;
  }

  // the ellipse through center + u and center + v whose tangents there are parallel to v and to u
  static Primitive_curve ellipse(const Vector& center, const Vector& u, const Vector& v)
  {
    Primitive_curve result;
    result.kind = Primitive_kind::ELLIPSE;
    result.center = center;
    const double twice = std::atan2(2. * u.dot(v), u.squaredNorm() - v.squaredNorm());
    const double c = std::cos(0.5 * twice), s = std::sin(0.5 * twice);
    const Vector x = c * u + s * v, y = c * v - s * u;
    result.major_radius = x.norm();
    result.minor_radius = y.norm();
    result.major = x / (std::max)(result.major_radius, 1e-30);
    result.axis = x.cross(y).normalized();
    return result;
  }

  int number_of_parameters() const { return kind == Primitive_kind::LINE ? 4 : kind == Primitive_kind::CIRCLE ? 6 : 8; }

  bool is_finite() const
  {
    return center.allFinite() && axis.allFinite() && major.allFinite() && std::isfinite(major_radius)
      && std::isfinite(minor_radius);
  }

  Vector minor() const { return axis.cross(major); }

  Vector at(double angle) const
  {
    return center + major_radius * std::cos(angle) * major + minor_radius * std::sin(angle) * minor();
  }

  // the parameter of the point nearest to `p`: an angle, or the position along a line
  double parameter(const Vector& p) const
  {
    const Vector offset = p - center;
    if (kind == Primitive_kind::LINE)
      return offset.dot(axis);
    const double x = offset.dot(major), y = offset.dot(minor());
    return kind == Primitive_kind::CIRCLE ? std::atan2(y, x) : ellipse_angle(x, y);
  }

  Vector at_parameter(double t) const { return kind == Primitive_kind::LINE ? Vector(center + t * axis) : at(t); }

  // from one parameter to the other the shorter way
  double step(double from, double to) const
  {
    return kind == Primitive_kind::LINE ? to - from : std::remainder(to - from, 2. * CGAL_PI);
  }

  // from one angle forward to the other, above 0
  static double turn(double from, double to)
  {
    const double angle = std::remainder(to - from, 2. * CGAL_PI);
    return angle > 0. ? angle : angle + 2. * CGAL_PI;
  }

  // The angle of the arc from one angle to the other that passes `middle`, negative if it runs clockwise.
  double sweep(double from, const Vector& middle, double to) const
  {
    const double forward = turn(from, to);
    return turn(from, parameter(middle)) > forward ? -turn(to, from) : forward;
  }

  Vector foot(const Vector& p) const
  {
    const Vector offset = p - center;
    if (kind == Primitive_kind::LINE)
      return center + offset.dot(axis) * axis;
    if (kind == Primitive_kind::ELLIPSE)
      return at(parameter(p));
    const Vector in_plane = offset - offset.dot(axis) * axis;
    const double length = in_plane.norm();
    return center + (length > 1e-12 ? Vector(in_plane * (major_radius / length)) : Vector(major_radius * major));
  }

  // unit tangent at the point nearest to `p`, in the direction of growing parameters
  Vector tangent(const Vector& p) const
  {
    if (kind == Primitive_kind::LINE)
      return axis;
    const double angle = parameter(p);
    return (minor_radius * std::cos(angle) * minor() - major_radius * std::sin(angle) * major).normalized();
  }

  // after a small change of the parameters: shifts across a line, or of the center; rotations; changes of the radii
  Primitive_curve moved(const double* step) const
  {
    Primitive_curve result = *this;
    if (kind == Primitive_kind::LINE)
    {
      const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
      result.center += step[0] * u + step[1] * v;
      result.axis = (axis + step[2] * u + step[3] * v).normalized();
      return result;
    }
    const Vector rotation = kind == Primitive_kind::CIRCLE
      ? Vector(step[3] * major + step[4] * minor())
      : Vector(step[3] * major + step[4] * minor() + step[5] * axis);
    result.center += Vector(step[0], step[1], step[2]);
    result.axis = (axis + rotation.cross(axis)).normalized();
    result.major = major + rotation.cross(major);
    result.major = (result.major - result.major.dot(result.axis) * result.axis).normalized();
    if (kind == Primitive_kind::CIRCLE)
      result.major_radius = result.minor_radius = std::abs(major_radius + step[5]);
    else
    {
      result.major_radius = std::abs(major_radius + step[6]);
      result.minor_radius = std::abs(minor_radius + step[7]);
    }
    return result;
  }

  // The derivatives of foot(p) by the steps that `moved` takes, one column for each; not of an ellipse.
  void foot_derivatives(const Vector& p, std::array<Vector, most_parameters>& columns) const
  {
    const Vector offset = p - center;
    if (kind == Primitive_kind::LINE)
    {
      const Vector u = axis.unitOrthogonal(), v = axis.cross(u);
      const double along = offset.dot(axis);
      columns[0] = u;
      columns[1] = v;
      columns[2] = offset.dot(u) * axis + along * u;
      columns[3] = offset.dot(v) * axis + along * v;
      return;
    }
    const Vector in_plane = offset - offset.dot(axis) * axis;
    const double length = (std::max)(in_plane.norm(), 1e-12), ratio = major_radius / length;
    const Vector outward = in_plane / length;
    const auto turned = [&](const Vector& change) { return Vector(ratio * (change - outward.dot(change) * outward)); };
    for (int k = 0; k < 3; ++k)
    {
      const Vector unit = Vector::Unit(k);
      columns[k] = unit - turned(unit - axis[k] * axis);
    }
    const Vector tilts[2] = {major.cross(axis), minor().cross(axis)}; // changes of the axis
    for (int k = 0; k < 2; ++k)
      columns[3 + k] = turned(-offset.dot(tilts[k]) * axis - offset.dot(axis) * tilts[k]);
    columns[5] = outward;
  }

private:
  // the angle of the point of the ellipse that is nearest to (x, y)
  double ellipse_angle(double x, double y) const
  {
    const double a = major_radius, b = minor_radius, u = std::abs(x), v = std::abs(y);
    // in the first quadrant, a u sin - b v cos - (a^2 - b^2) sin cos changes its sign once
    double low = 0., high = 0.5 * CGAL_PI, angle = std::atan2(a * v, b * u);
    for (int i = 0; i < 60 && high - low > 1e-15; ++i)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      const double value = a * u * s - b * v * c - (a * a - b * b) * s * c;
      const double slope = a * u * c + b * v * s - (a * a - b * b) * (c * c - s * s);
      (value < 0. ? low : high) = angle;
      const double next = slope > 0. ? angle - value / slope : low - 1.;
      if (std::abs(next - angle) < 1e-15)
        break;
      angle = next > low && next < high ? next : 0.5 * (low + high);
    }
    angle = x < 0. ? CGAL_PI - angle : angle;
    return y < 0. ? -angle : angle;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_CURVE_H
