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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_VECTOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_VECTOR_H

#include <Eigen/Core>

#include <cmath>
#include <type_traits>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A vector in space, whose usual operations are plain functions. Those of Eigen are templates, of which every sum
// and every difference makes a new type; without these the library compiles in less time and memory. What stands here
// hides them where all operands are such vectors, and gives the same to the last bit. With matrices and parts of
// vectors it is Eigen's vector.
class Vector : public Eigen::Vector3d
{
  typedef Eigen::Vector3d Base;

public:
  Vector() = default;

  Vector(double x, double y, double z) : Base(x, y, z) {}

  template <class Expression>
  Vector(const Eigen::MatrixBase<Expression>& expression) : Base(expression)
  {}

  explicit Vector(const double* coordinates) : Base(coordinates[0], coordinates[1], coordinates[2]) {}

  template <class Expression>
  Vector& operator=(const Eigen::MatrixBase<Expression>& expression)
  {
    Base::operator=(expression);
    return *this;
  }

  static Vector Zero() { return Vector(0, 0, 0); }

  double& operator[](Eigen::Index i)
  {
    eigen_assert(i >= 0 && i < 3);
    return data()[i];
  }

  double operator[](Eigen::Index i) const
  {
    eigen_assert(i >= 0 && i < 3);
    return data()[i];
  }

  double& x() { return data()[0]; }
  double& y() { return data()[1]; }
  double& z() { return data()[2]; }
  double x() const { return data()[0]; }
  double y() const { return data()[1]; }
  double z() const { return data()[2]; }

  using Base::operator+;
  using Base::operator-;
  using Base::operator*;
  using Base::operator/;
  using Base::operator+=;
  using Base::operator-=;
  using Base::cross;
  using Base::dot;

  Vector operator-() const { return Vector(-x(), -y(), -z()); }
  Vector operator+(const Vector& v) const { return Vector(x() + v.x(), y() + v.y(), z() + v.z()); }
  Vector operator-(const Vector& v) const { return Vector(x() - v.x(), y() - v.y(), z() - v.z()); }

  template <class Number, class = typename std::enable_if<std::is_arithmetic<Number>::value>::type>
  Vector operator*(const Number& factor) const
  {
    const double f = static_cast<double>(factor);
    return Vector(x() * f, y() * f, z() * f);
  }

  template <class Number, class = typename std::enable_if<std::is_arithmetic<Number>::value>::type>
  friend Vector operator*(const Number& factor, const Vector& v)
  {
    const double f = static_cast<double>(factor);
    return Vector(f * v.x(), f * v.y(), f * v.z());
  }

  template <class Number, class = typename std::enable_if<std::is_arithmetic<Number>::value>::type>
  Vector operator/(const Number& divisor) const
  {
    const double d = static_cast<double>(divisor);
    return Vector(x() / d, y() / d, z() / d);
  }

  Vector& operator+=(const Vector& v) { return *this = *this + v; }
  Vector& operator-=(const Vector& v) { return *this = *this - v; }
  Vector& operator*=(double factor) { return *this = *this * factor; }
  Vector& operator/=(double divisor) { return *this = *this / divisor; }

  double dot(const Vector& v) const { return x() * v.x() + y() * v.y() + z() * v.z(); }

  Vector cross(const Vector& v) const
  {
    return Vector(y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x());
  }

  double squaredNorm() const { return dot(*this); }
  double norm() const { return std::sqrt(squaredNorm()); }

  // itself where it is zero
  Vector normalized() const
  {
    const double square = squaredNorm();
    return square > 0 ? *this / std::sqrt(square) : *this;
  }

  void normalize() { *this = normalized(); }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_VECTOR_H
