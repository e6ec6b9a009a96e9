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

#ifndef SAMPLE_SOLIDS_FIELD_ERROR_H
#define SAMPLE_SOLIDS_FIELD_ERROR_H

#include <Sample_solids/Point_grid.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace Sample_solids {

enum class Field_kind
{
  EXACT,
  DEF,
  NOISY
};

inline const char* name_of(Field_kind kind)
{
  return kind == Field_kind::EXACT ? "exact" : kind == Field_kind::DEF ? "def" : "noisy";
}

/// returns the kind with the given name, which has to be one of these.
inline Field_kind field_kind_of(const std::string& name)
{
  return name == "exact" ? Field_kind::EXACT : name == "def" ? Field_kind::DEF : Field_kind::NOISY;
}

/// Points on a solid with the distance to its sharp curves.
struct Cloud
{
  double sampling_distance = 0;
  double truncation = 50; ///< upper bound of the field, in sampling distances
  std::vector<Point> points;
  std::vector<std::uint32_t> faces;    ///< on which face each point lies
  std::vector<double> distances;       ///< the field as it is given out
  std::vector<double> exact_distances; ///< of the points where they were sampled
};

/// How far a field is off.
struct Field_statistics
{
  double root_mean_square = 0; ///< of the error, in sampling distances
  double share_off = 0;        ///< of the points that are off by more than one sampling distance
};

inline Field_statistics field_statistics(const Cloud& cloud)
{
  Field_statistics result;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const double error = (cloud.distances[i] - cloud.exact_distances[i]) / cloud.sampling_distance;
    result.root_mean_square += error * error;
    result.share_off += std::abs(error) > 1 ? 1 : 0;
  }
  const double n = static_cast<double>((std::max)(std::size_t(1), cloud.points.size()));
  result.root_mean_square = std::sqrt(result.root_mean_square / n);
  result.share_off /= n;
  return result;
}

namespace internal {

/// The size of a kind of error; lengths are in sampling distances.
struct Error_level
{
  double bias;             ///< standard deviation of the smooth bias at the edge
  double noise;            ///< scale of the heavy-tailed noise at the edge
  double share_off;        ///< wanted share of the points that are off by more than one sampling distance
  double root_mean_square; ///< wanted, over all points
  double wrong_share;      ///< of the surface that is plainly wrong
};

inline Error_level error_level(Field_kind kind)
{
  return kind == Field_kind::NOISY ? Error_level{0.18, 0.25, 0.35, 1.9, 0.045}
                                   : Error_level{0.11, 0.14, 0.20, 1.1, 0.04};
}

/// A smooth random function with zero mean and unit variance: a few waves of 8 to 20 sampling distances.
class Smooth_random_function
{
public:
  explicit Smooth_random_function(Random& random)
  {
    for (Wave& wave : m_waves)
    {
      const double z = random.uniform(-1, 1), angle = random.uniform(0, 2 * pi);
      const double number = 2 * pi / random.uniform(8, 20), s = std::sqrt(1 - z * z);
      wave.vector = {{number * s * std::cos(angle), number * s * std::sin(angle), number * z}};
      wave.phase = random.uniform(0, 2 * pi);
    }
  }

  double operator()(const Point& p) const
  {
    double sum = 0;
    for (const Wave& wave : m_waves)
      sum += std::cos(dot(wave.vector, p) + wave.phase);
    return sum * std::sqrt(2. / static_cast<double>(m_waves.size()));
  }

private:
  struct Wave
  {
    Point vector;
    double phase;
  };

  std::array<Wave, 8> m_waves;
};

/// Makes the errors of one cloud. All is in sampling distances.
class Field_disturber
{
public:
  Field_disturber(Cloud& cloud, Field_kind kind, Random& random)
    : m_cloud(cloud), m_level(error_level(kind)), m_random(random), m_errors(m_cloud.points.size()),
      m_patches(m_cloud.points.size(), no_patch)
  {}

  void run()
  {
    draw_errors();
    draw_patches();
    // the far field and the wrong patches are what makes up a cloud's share and its mean square
    m_growth = solve(0.5, 14, m_level.share_off, [this](double x) {
      m_growth = x;
      return statistics().share_off;
    });
    m_depth = solve(1.5, 12, m_level.root_mean_square, [this](double x) {
      m_depth = x;
      return statistics().root_mean_square;
    });
    for (std::size_t i = 0; i < m_cloud.points.size(); ++i)
      m_cloud.distances[i] = m_cloud.sampling_distance * disturbed(i);
  }

private:
  static constexpr std::uint32_t no_patch = (std::numeric_limits<std::uint32_t>::max)();

  /// A ball in which the field is plainly wrong.
  struct Wrong_patch
  {
    Point center;
    double radius;
    bool is_spurious; ///< an edge is seen where there is none; else an edge is missed
    Point direction;  ///< of the spurious edge
  };

  double exact(std::size_t i) const { return m_cloud.exact_distances[i] / m_cloud.sampling_distance; }

  Point position(std::size_t i) const { return (1. / m_cloud.sampling_distance) * m_cloud.points[i]; }

  void draw_errors()
  {
    const Smooth_random_function bias(m_random);
    for (std::size_t i = 0; i < m_errors.size(); ++i)
    {
      const double noise = (std::min)(12., (std::max)(-12., m_random.student_3()));
      m_errors[i] = static_cast<float>(m_level.bias * bias(position(i)) + m_level.noise * noise);
    }
  }

  void draw_patches()
  {
    Point_grid grid(4, m_cloud.points.size());
    for (std::size_t i = 0; i < m_cloud.points.size(); ++i)
      grid.add(position(i));
    const double wanted = m_level.wrong_share * static_cast<double>(m_cloud.points.size());
    std::size_t missing = static_cast<std::size_t>(wanted);
    for (int i = 0; i < 1000000 && missing > 0; ++i)
      missing -= add_patch(grid, missing);
  }

  /// adds a ball about a random point: its points that are not yet wrong become so, the nearest at most.
  std::size_t add_patch(const Point_grid& grid, std::size_t most)
  {
    const std::size_t center = m_random.index(m_cloud.points.size());
    Wrong_patch patch;
    patch.center = grid.get_points()[center];
    patch.radius = m_random.uniform(5, 10);
    patch.is_spurious = m_random.uniform() < 0.5 && exact(center) > 4;
    std::vector<std::pair<double, std::uint32_t>> found;
    grid.visit_ball(patch.center, patch.radius, [&](std::size_t i, double d) {
      if (m_patches[i] == no_patch)
        found.emplace_back(d, static_cast<std::uint32_t>(i));
      return true;
    });
    if (found.size() < 4)
      return 0;
    std::sort(found.begin(), found.end());
    found.resize((std::min)(found.size(), most));
    // towards another point of the patch, so about along the surface
    const std::size_t half = found.size() / 2;
    const Point other = grid.get_points()[found[half + m_random.index(found.size() - half)].second];
    const Point v = other - patch.center;
    patch.direction = norm(v) > 0 ? unit(v) : Point{{1, 0, 0}};
    for (const std::pair<double, std::uint32_t>& f : found)
      m_patches[f.second] = static_cast<std::uint32_t>(m_wrong.size());
    m_wrong.push_back(patch);
    return found.size();
  }

  double disturbed(std::size_t i) const
  {
    const double d = exact(i);
    double value = d + m_errors[i] * grown(d);
    if (m_patches[i] != no_patch)
      value = wrong_value(m_wrong[m_patches[i]], position(i), value);
    return (std::min)(m_cloud.truncation, (std::max)(0., value));
  }

  /// how much larger the errors are at the distance `d` than at the edge
  double grown(double d) const { return 1. + m_growth * (1. - std::exp(-std::pow(d / 12., 1.5))); }

  double wrong_value(const Wrong_patch& patch, const Point& p, double value) const
  {
    const Point v = p - patch.center;
    if (!patch.is_spurious)
      return value + m_depth * (1. - 0.5 * dot(v, v) / (patch.radius * patch.radius));
    const double along = dot(v, patch.direction);
    const double to_line = std::sqrt((std::max)(0., dot(v, v) - along * along));
    return (std::min)(value, (std::max)(to_line, value - 1.5 * m_depth));
  }

  /// the statistics of a part of the points, for speed
  Field_statistics statistics() const
  {
    Field_statistics result;
    const std::size_t stride = 1 + m_cloud.points.size() / 50000;
    double n = 0;
    for (std::size_t i = 0; i < m_cloud.points.size(); i += stride, ++n)
    {
      const double error = disturbed(i) - exact(i);
      result.root_mean_square += error * error;
      result.share_off += std::abs(error) > 1 ? 1 : 0;
    }
    result.root_mean_square = std::sqrt(result.root_mean_square / (std::max)(1., n));
    result.share_off /= (std::max)(1., n);
    return result;
  }

  /// returns where an increasing function takes a value, or the end of the interval that comes nearest.
  template <class Function>
  static double solve(double low, double high, double value, Function f)
  {
    for (int i = 0; i < 16; ++i)
    {
      const double middle = 0.5 * (low + high);
      (f(middle) < value ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  Cloud& m_cloud;
  Error_level m_level;
  Random& m_random;
  double m_growth = 3, m_depth = 4;
  std::vector<float> m_errors;          // at the edge
  std::vector<std::uint32_t> m_patches; // the wrong patch of each point
  std::vector<Wrong_patch> m_wrong;
};

} // namespace internal

/// gives a cloud with an exact field the errors that published regressors make: a smooth bias, heavy-tailed
/// noise that grows with the distance to the curves, and a small part of the surface that is plainly wrong.
/// \param position_noise  by how much points move (standard deviation per coordinate, in sampling distances);
///                        if negative 0.25 for a noisy field, 0 for others
inline void disturb(Cloud& cloud, Field_kind kind, double position_noise, std::uint64_t seed)
{
  if (cloud.points.empty())
    return;
  Random random(seed, kind == Field_kind::DEF ? 1 : 2);
  if (kind != Field_kind::EXACT)
    internal::Field_disturber(cloud, kind, random).run();
  if (position_noise < 0)
    position_noise = kind == Field_kind::NOISY ? 0.25 : 0.;
  const double sigma = position_noise * cloud.sampling_distance;
  if (sigma > 0)
    for (Point& p : cloud.points)
      for (double& x : p)
        x += sigma * random.normal();
}

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_FIELD_ERROR_H
