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

#ifndef SAMPLE_SOLIDS_GEOMETRY_H
#define SAMPLE_SOLIDS_GEOMETRY_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

namespace Sample_solids {

typedef std::array<double, 3> Point;
typedef std::array<double, 2> Point_2;

constexpr double pi = 3.14159265358979323846;

inline Point operator+(const Point& a, const Point& b) { return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}}; }

inline Point operator-(const Point& a, const Point& b) { return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}}; }

inline Point operator*(double s, const Point& a) { return {{s * a[0], s * a[1], s * a[2]}}; }

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Point cross(const Point& a, const Point& b)
{
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

inline double norm(const Point& a) { return std::sqrt(dot(a, a)); }

inline double squared_distance(const Point& a, const Point& b)
{
  const Point v = a - b;
  return dot(v, v);
}

inline double distance(const Point& a, const Point& b) { return std::sqrt(squared_distance(a, b)); }

inline Point unit(const Point& a) { return (1. / norm(a)) * a; }

/// an orthonormal frame: a point and three directions.
struct Frame
{
  Point origin = {{0, 0, 0}};
  Point x = {{1, 0, 0}};
  Point y = {{0, 1, 0}};
  Point z = {{0, 0, 1}};

  Point operator()(double a, double b, double c) const { return origin + a * x + b * y + c * z; }
};

/// the frame at `origin` whose z-direction is `axis`.
inline Frame frame_along(const Point& origin, const Point& axis)
{
  Frame frame;
  frame.origin = origin;
  frame.z = unit(axis);
  const Point helper = std::abs(frame.z[0]) < 0.5 ? Point{{1, 0, 0}} : Point{{0, 1, 0}};
  frame.x = unit(cross(helper, frame.z));
  frame.y = cross(frame.z, frame.x);
  return frame;
}

/// A source of random numbers that is the same with every standard library: the engine is
/// specified by the standard, the distributions of `<random>` are not, so they are written out here.
class Random
{
public:
  /// Streams of one seed are independent of each other, so leaving one out does not change the others.
  explicit Random(std::uint64_t seed, std::uint64_t stream = 0)
    : m_engine(mix(mix(seed + 0x9e3779b97f4a7c15ull) ^ (stream * 0xd1b54a32d192ed03ull)))
  {}

  /// uniform in [0, 1)
  double uniform() { return static_cast<double>(m_engine() >> 11) * (1. / 9007199254740992.); }

  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// uniform in {0, ..., n-1}
  std::size_t index(std::size_t n)
  {
    return (std::min)(static_cast<std::size_t>(uniform() * static_cast<double>(n)), n - 1);
  }

  double normal()
  {
    const double u = 1. - uniform();
    const double v = uniform();
    return std::sqrt(-2. * std::log(u)) * std::cos(2. * pi * v);
  }

  /// Student's t with three degrees of freedom, by the polar method
  double student_3()
  {
    const double u = 1. - uniform();
    const double v = uniform();
    return std::sqrt(3. * (std::pow(u, -2. / 3.) - 1.)) * std::cos(2. * pi * v);
  }

private:
  static std::uint64_t mix(std::uint64_t x)
  {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
  }

  std::mt19937_64 m_engine;
};

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_GEOMETRY_H
