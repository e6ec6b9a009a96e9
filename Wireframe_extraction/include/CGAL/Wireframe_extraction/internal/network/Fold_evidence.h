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
#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FOLD_EVIDENCE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FOLD_EVIDENCE_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/network/find_two_faces.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/polyline_feet.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Tells whether the surface is folded along a curve. In windows along the curve, the points that are nearer to it than
// to any other curve are heights over a plane: a smooth surface gives a paraboloid, a fold adds a multiple of the
// distance to the curve. Where the field wants a curve but the surface is smooth beyond doubt, there is none.
class Fold_evidence
{
  // of the heights by x across the curve and s along it: 1, x, s, |x|, x^2, x s
  static constexpr int size = 6, slope = 3;
  typedef Eigen::Matrix<double, size, 1> Row;
  typedef Eigen::Matrix<double, size, size> Matrix;

  struct Sample
  {
    double s;
    Vector offset;
  }; // from the middle of the window, from the curve

  struct Window
  {
    std::vector<Sample> samples;
    Vector direction = Vector::Zero();
    Vector across = Vector::Zero(); // of the fold, or zero if the samples shall tell
    Vector normal = Vector::Zero();
    double slope = 0., deviation = 1., residual = 1.;
    bool is_known = false;
  };

  const Field_band& m_surroundings;
  Progress* m_progress;

  // in r: a window has some 18 points, three for each coefficient
  static constexpr double reach = 3., window_length = 3.;
  static constexpr std::size_t least_samples = 10;
  // of the samples: with fewer on one side, the fold and the slope across are one
  static constexpr std::size_t least_share_of_side = 4; // one in four
  // Of an edge between two corners, this share of the length at each end has points of the curves that meet there. And
  // points belong to the edge's faces up to this many times their distance to the nearest other curve: straight beside
  // the edge, where those curves lead away at right angles, half of the face.
  static constexpr double disturbed_share_of_edge = 0.1, distance_per_other = 2.;
  // Its two corners are known, in r, up to so much; points so far from it show the directions of its faces; where more
  // than a quarter of the points lie on neither face, it is no edge of two faces. With two points more than there are
  // coefficients, its fold is known.
  static constexpr double error_of_corners = 0.15, arm = 1.2, least_share_on_faces = 0.75;
  static constexpr std::size_t least_samples_of_edge = size + 2;
  // in 1/r: what curvatures are expected, of a surface that is no fold (radius 8 r)
  static constexpr double curvature_deviation = 0.06;
  // keeps the equations regular; far below one sample's weight
  static constexpr double regularization = 1e-6;
  // in r: positions in files are seldom more exact
  static constexpr double least_noise = 0.01;
  // a window with a residual beyond this many times the noise, and what a paraboloid misses (in r), is no graph
  static constexpr double residual_per_noise = 2., least_residual = 0.04;
  // no noise of positions is larger; points of thin walls spread as much
  static constexpr double most_residual = 0.45;

public:
  // tangent of half the angle by which the surface folds, and its standard deviation
  struct Fold
  {
    double slope = 0., deviation = 0.;
    bool is_known = false; // else the surface is no graph over a plane there

    // below it, the surface turns by less than 17 degrees
    static constexpr double least_slope = 0.15;
    // in standard deviations: one flat edge in 700 seems folded beyond them
    static constexpr double deviations_beyond_doubt = 3.;
    bool is_folded_beyond_doubt() const
    {
      return is_known && slope - deviations_beyond_doubt * deviation > least_slope;
    }
    bool is_flat() const { return is_known && slope < least_slope; }
    bool is_flat_beyond_doubt() const { return is_known && slope + deviation < least_slope; }
  };

  // `surroundings` has points up to a distance of `reach` from all curves
  explicit Fold_evidence(const Field_band& surroundings, Progress* progress = nullptr)
    : m_surroundings(surroundings), m_progress(progress)
  {}

  // of the polylines that are not null; after cancelling, nothing is known
  std::vector<Fold> folds(const std::vector<const std::vector<Vector>*>& polylines) const
  {
    std::vector<std::vector<Window>> windows = collect(polylines);
    const std::vector<Fold> unknown(polylines.size());
    const std::optional<double> noise = noise_of(windows);
    if (!noise)
      return unknown;
    std::vector<Fold> result = unknown;
    for (std::size_t c = 0; c < windows.size() && goes_on(m_progress); ++c)
      result[c] = combine(windows[c], *noise);
    return m_progress && m_progress->is_cancelled() ? unknown : result;
  }

  // the typical error of the positions, in r, by what is left of them along the curves
  double noise_along(const std::vector<const std::vector<Vector>*>& polylines) const
  {
    std::vector<std::vector<Window>> windows = collect(polylines);
    return noise_of(windows).value_or(most_residual);
  }

  // Of a short straight edge between two corners, as one window. The points beside it belong to its faces unless
  // another curve is much nearer, or they lie on no face that meets the edge: `to_others` are the distances of the
  // surroundings to the curves there are.
  Fold fold_of_edge(const Vector& from, const Vector& to, const std::vector<double>& to_others, double noise) const
  {
    const std::vector<Vector> edge{from, to};
    const double length = (to - from).norm(), least = disturbed_share_of_edge * length;
    std::vector<Sample> samples;
    std::vector<Vector> offsets;
    visit_feet(m_surroundings, 0, edge, reach, [&](std::size_t i, const Polyline_foot& foot) {
      const double s = foot.share * length;
      if ((std::min)(s, length - s) < least || foot.distance > distance_per_other * to_others[i])
        return;
      offsets.push_back(m_surroundings.points[i] - foot.point(edge));
      samples.push_back({s - 0.5 * length, offsets.back()});
    });
    const Two_faces faces = find_two_faces(offsets, error_of_corners + residual_per_noise * noise, arm);
    std::vector<Window> window(1);
    window[0].direction = to - from;
    window[0].across = (faces.arms[0] - faces.arms[1]).normalized();
    for (std::size_t k = 0; k < samples.size(); ++k)
      if (faces.holds[k])
        window[0].samples.push_back(samples[k]);
    if (double(window[0].samples.size()) < least_share_on_faces * double(samples.size()))
      return Fold();
    return combine(window, noise, least_samples_of_edge);
  }

private:
  // what is left of the points in each window is known from now on
  std::optional<double> noise_of(std::vector<std::vector<Window>>& windows) const
  {
    std::vector<double> residuals;
    for (std::size_t c = 0; c < windows.size() && goes_on(m_progress); ++c)
      for (Window& window : windows[c])
        if (fit(window, 0.))
          residuals.push_back(window.residual);
    if (residuals.empty())
      return std::nullopt;
    return (std::max)(least_noise, median(residuals));
  }

  std::vector<std::vector<Window>> collect(const std::vector<const std::vector<Vector>*>& polylines) const
  {
    std::vector<std::vector<double>> lengths(polylines.size());
    std::vector<std::vector<Window>> windows(polylines.size());
    for (std::size_t c = 0; c < polylines.size(); ++c)
    {
      if (!polylines[c])
        continue;
      lengths[c] = arc_lengths(*polylines[c]);
      windows[c].resize((std::max)(std::size_t(1), static_cast<std::size_t>(lengths[c].back() / window_length + 0.5)));
    }
    const std::vector<Polyline_foot> feet = nearest_feet(m_surroundings, polylines, reach, m_progress);
    for (std::size_t i = 0; i < feet.size(); ++i)
    {
      if (!feet[i].is_valid())
        continue;
      const std::vector<Vector>& points = *polylines[feet[i].curve];
      std::vector<Window>& curve = windows[feet[i].curve];
      const Vector foot = feet[i].point(points), direction = points[feet[i].segment + 1] - points[feet[i].segment];
      const double length = lengths[feet[i].curve].back(), s = feet[i].interpolate(lengths[feet[i].curve]);
      if (is_at_end(s, length))
        continue;
      const double share = s / length * double(curve.size());
      const std::size_t k = (std::min)(curve.size() - 1, static_cast<std::size_t>(share));
      curve[k].samples.push_back({(share - double(k) - 0.5) * window_length, m_surroundings.points[i] - foot});
      curve[k].direction += direction.normalized();
    }
    return windows;
  }

  // of the samples' offsets, at right angles to a direction
  static Vector widest_direction(const std::vector<Sample>& samples, const Vector& direction)
  {
    Vector mean = Vector::Zero();
    for (const Sample& sample : samples)
      mean += sample.offset;
    mean /= double(samples.size());
    Matrix_3 moments = Matrix_3::Zero();
    for (const Sample& sample : samples)
    {
      Vector offset = sample.offset - mean;
      offset -= offset.dot(direction) * direction;
      moments += Matrix_3::outer(offset, offset);
    }
    return principal_axes(moments).axes[2];
  }

  // with `noise` of the surface, prior knowledge about curvatures counts
  static bool fit(Window& window, double noise, std::size_t least = least_samples)
  {
    window.is_known = false;
    if (window.samples.size() < least || !(window.direction.norm() > 0.))
      return false;
    const Vector direction = window.direction.normalized();
    const Vector across = window.across.isZero() ? widest_direction(window.samples, direction) : window.across;
    window.normal = direction.cross(across).normalized();
    Matrix normal_matrix = Matrix::Zero();
    Row right = Row::Zero();
    std::size_t left = 0;
    for (const Sample& sample : window.samples)
    {
      const Row row = row_of(sample, across);
      const double height = sample.offset.dot(window.normal);
      normal_matrix += row * row.transpose();
      right += height * row;
      left += row[1] < 0.;
    }
    const std::size_t right_side = window.samples.size() - left;
    if (least_share_of_side * (std::min)(left, right_side) < window.samples.size())
      return false;
    static constexpr double deviations[size] = {0., 0., 0., 0., curvature_deviation, curvature_deviation};
    for (int k = 0; k < size; ++k)
      normal_matrix(k, k) +=
        regularization + (deviations[k] > 0. ? noise * noise / (deviations[k] * deviations[k]) : 0.);
    const Symmetric_factorization factorization(normal_matrix);
    const Row solution = factorization.solved(right);
    double squares = 0.;
    for (const Sample& sample : window.samples)
    {
      const double e = sample.offset.dot(window.normal) - row_of(sample, across).dot(solution);
      squares += e * e;
    }
    window.residual = std::sqrt(squares / double(window.samples.size() - size));
    window.slope = solution[slope];
    window.deviation =
      (std::max)(noise, window.residual) * std::sqrt(factorization.solved(Row(Row::Unit(slope)))[slope]);
    window.is_known = true;
    return true;
  }

  static Row row_of(const Sample& sample, const Vector& across)
  {
    const double x = sample.offset.dot(across);
    Row row;
    row << 1., x, sample.s, std::abs(x), x * x, x * sample.s;
    return row;
  }

  static Fold combine(std::vector<Window>& windows, double noise, std::size_t least = least_samples)
  {
    Fold fold;
    double sum = 0., sum_of_sizes = 0., sum_of_deviations = 0., total = 0.;
    std::size_t known = 0;
    Vector previous = Vector::Zero();
    for (Window& window : windows)
    {
      if (!fit(window, noise, least)
          || window.residual > (std::min)(residual_per_noise * noise + least_residual, most_residual))
        continue;
      const double sign = window.normal.dot(previous) < 0. ? -1. : 1.;
      previous = sign * window.normal;
      const double weight = 1. / (window.deviation * window.deviation);
      sum += weight * sign * window.slope;
      sum_of_sizes += weight * std::abs(window.slope);
      sum_of_deviations += weight * window.deviation;
      total += weight;
      ++known;
    }
    fold.is_known = known > 0 && 2 * known >= windows.size();
    if (fold.is_known)
    {
      // Where the surface is smooth, the slopes are errors, and their mean size is that of a normal distribution; a
      // fold that is convex in some windows and concave in others shows in the sizes only.
      const double beyond_errors = (sum_of_sizes - std::sqrt(2. / CGAL_PI) * sum_of_deviations) / total;
      fold.slope = (std::max)(std::abs(sum / total), beyond_errors);
      fold.deviation = std::sqrt(1. / total);
    }
    return fold;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FOLD_EVIDENCE_H
