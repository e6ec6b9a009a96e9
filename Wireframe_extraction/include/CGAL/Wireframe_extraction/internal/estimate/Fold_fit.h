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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

struct Fold_fit_result
{
  double folded_residual = 0.; // with the folds
  bool is_smooth = false;      // whether one sheet leaves nothing to explain
  int number_of_folds = 0;
  std::array<Fold, 2> folds;
};

// Fits height functions over the main plane of a ball: a quadric alone, and with one or two folds max(0, u.x - c).
class Fold_fit
{
  // Where folds are tried first: every 15 degrees and three sixteenths of the radius, up to where a fourth of the
  // radius is left beyond them. Then around the best one, in steps that are halved where none is better: five make them
  // less than what the points tell, half a degree and 0.02 r.
  static constexpr int number_of_directions = 12, number_of_offsets = 9;
  static constexpr double reach = 0.75; // of the offsets, in radii
  static constexpr int number_of_refinements = 5;
  static constexpr int quadric_size = 6, parameters_of_fold = 3, most_columns = 8; // a fold: direction, offset, slope
  // two for each parameter of the quadric; and on each side of a fold more than its parameters
  static constexpr int least_points = 12, least_on_a_side = 4;
  // with fewer, a variance is an accident
  static constexpr int least_degrees_of_freedom = 3;
  // a column that others explain but for that share of its squares is one of them, by rounding
  static constexpr double rounding_of_squares = 1e-12;
  // a fold that a quadric explains but for that share of its squares, or so many squared r, is none to be measured
  static constexpr double least_share_of_hinge = 1e-6, least_hinge = 1e-9;
  // less of a column is left by rounding, where the points lie on few lines across the fold
  static constexpr double least_norm = 1e-6;
  // keeps the equations regular; far below one point's weight
  static constexpr double regularization = 1e-6;
  // the frame is turned so often, if it is farther from the middle of the fold than 15 degrees
  static constexpr int most_frames = 2;
  static constexpr double least_cosine = 0.966;

  std::vector<double> m_x, m_y, m_z, m_residuals, m_hinge;
  std::array<std::vector<double>, most_columns> m_basis;   // orthonormal columns
  std::array<std::vector<double>, most_columns> m_columns; // as they are
  int m_size = 0, m_number_of_columns = 0;
  bool m_turns_frames;
  Vector m_a, m_b, m_normal;  // the frame
  Vector m_bisector, m_along; // of the first fold: between the normals of its sheets, and along it

public:
  // `turns_frames`: whether a fold is fitted in a frame of its own
  explicit Fold_fit(bool turns_frames = true) : m_turns_frames(turns_frames) {}

  // `ball` are the offsets of the points from the place that is looked at.
  // `threshold`: variances of residuals below it leave nothing to explain
  Fold_fit_result fit(const std::vector<Vector>& ball, double radius, double variance, double threshold)
  {
    Fold_fit_result result;
    m_size = static_cast<int>(ball.size());
    if (m_size < least_points)
      return result;
    set_frame_by_main_axes(ball);
    fit_quadric();
    const double squares = sum_of_squares(m_residuals);
    result.is_smooth = squares / (m_size - quadric_size) < threshold;
    if (result.is_smooth)
      return result;
    fit_folds(radius, variance, result);
    // The main plane leans towards the larger sheet, so that the other one is steep. Between both, neither is.
    for (int n = 0;
         m_turns_frames && n < most_frames && result.number_of_folds > 0 && m_normal.dot(m_bisector) < least_cosine;
         ++n)
    {
      Fold_fit_result other = result;
      set_frame(ball, m_bisector, m_along.cross(m_bisector).normalized());
      fit_quadric();
      fit_folds(radius, variance, other);
      if (!(other.number_of_folds > 0 && other.folded_residual < result.folded_residual))
        break;
      result = other;
    }
    return result;
  }

  // What a quadric leaves, root mean square; infinite if there are too few points.
  double residual_of_sheet(const std::vector<Vector>& ball)
  {
    m_size = static_cast<int>(ball.size());
    if (m_size < least_points)
      return (std::numeric_limits<double>::infinity)();
    set_frame_by_main_axes(ball);
    fit_quadric();
    return std::sqrt(sum_of_squares(m_residuals) / (m_size - quadric_size));
  }

private:
  void fit_folds(double radius, double variance, Fold_fit_result& result)
  {
    result.number_of_folds = 0;
    double squares = sum_of_squares(m_residuals);
    std::array<std::array<double, 2>, 2> places{}; // direction, offset
    for (int n = 0; n < 2; ++n)
    {
      double angle = 0., offset = 0.;
      const double gain = find_hinge(radius, angle, offset);
      if (gain <= 0.)
        break;
      const double scale =
        (std::max)(variance, (squares - gain) / degrees_of_freedom(m_number_of_columns + parameters_of_fold));
      const double evidence = gain / scale - parameters_of_fold * std::log(double(m_size)); // Schwarz's criterion
      if (n > 0 && evidence <= 0.)
        break; // it would take from the first what is the first's
      Fold& fold = result.folds[n];
      fold.evidence = evidence;
      places[n] = {angle, offset};
      set_hinge(angle, offset);
      m_columns[quadric_size + n] = m_hinge;
      const std::vector<double> before = m_residuals;
      add_column(m_hinge);
      squares = sum_of_squares(m_residuals);
      fold.margin = n > 0 ? result.folds[0].margin
                          : (squares_of_bent_sheet(before, angle, radius) - squares)
          / (std::max)(variance, squares / degrees_of_freedom(quadric_size + parameters_of_fold));
      result.number_of_folds = n + 1;
      if (evidence <= 0.)
        break;
    }
    result.folded_residual =
      std::sqrt(squares / (std::max)(1, m_size - quadric_size - parameters_of_fold * result.number_of_folds));
    measure(places, result);
  }

  int degrees_of_freedom(int number_of_parameters) const
  {
    return (std::max)(+least_degrees_of_freedom, m_size - number_of_parameters);
  }

  void set_frame_by_main_axes(const std::vector<Vector>& ball)
  {
    const auto position = [](const Vector& p) -> const Vector& { return p; };
    const Principal_axes axes = principal_axes(scatter(ball, position).matrix);
    set_frame(ball, axes.axes[0], axes.axes[2]);
  }

  void set_frame(const std::vector<Vector>& ball, const Vector& normal, const Vector& first)
  {
    m_normal = normal;
    m_a = first;
    m_b = normal.cross(first);
    for (std::vector<double>* v : {&m_x, &m_y, &m_z, &m_hinge, &m_residuals})
      v->resize(m_size);
    for (std::vector<double>& v : m_basis)
      v.resize(m_size);
    for (std::vector<double>& v : m_columns)
      v.resize(m_size);
    for (int j = 0; j < m_size; ++j)
    {
      m_x[j] = ball[j].dot(m_a);
      m_y[j] = ball[j].dot(m_b);
      m_z[j] = ball[j].dot(m_normal);
    }
  }

  static double squared(double x) { return x * x; }

  static double dot(const std::vector<double>& a, const std::vector<double>& b, int size)
  {
    double s[4] = {0., 0., 0., 0.};
    int j = 0;
    for (; j + 4 <= size; j += 4)
      for (int l = 0; l < 4; ++l)
        s[l] += a[j + l] * b[j + l];
    for (; j < size; ++j)
      s[0] += a[j] * b[j];
    return (s[0] + s[1]) + (s[2] + s[3]);
  }

  double sum_of_squares(const std::vector<double>& v) const { return dot(v, v, m_size); }

  // takes out of a column what the first columns of the basis have of it
  void orthogonalize(std::vector<double>& column, int number_of_columns) const
  {
    for (int round = 0; round < 2; ++round)
      for (int l = 0; l < number_of_columns; ++l)
      {
        const double c = dot(m_basis[l], column, m_size);
        for (int j = 0; j < m_size; ++j)
          column[j] -= c * m_basis[l][j];
      }
  }

  void add_column(const std::vector<double>& column)
  {
    std::vector<double>& q = m_basis[m_number_of_columns];
    q = column;
    const double before = sum_of_squares(q);
    orthogonalize(q, m_number_of_columns);
    const double after = sum_of_squares(q);
    if (!(after > rounding_of_squares * before))
      std::fill(q.begin(), q.end(), 0.);
    else
      for (double& x : q)
        x /= std::sqrt(after);
    const double c = dot(q, m_residuals, m_size);
    for (int j = 0; j < m_size; ++j)
      m_residuals[j] -= c * q[j];
    ++m_number_of_columns;
  }

  void fit_quadric()
  {
    m_number_of_columns = 0;
    m_residuals = m_z;
    for (int k = 0; k < quadric_size; ++k)
    {
      std::vector<double>& column = m_columns[k];
      for (int j = 0; j < m_size; ++j)
      {
        const double x = m_x[j], y = m_y[j];
        const double monomials[quadric_size] = {1., x, y, x * x, x * y, y * y};
        column[j] = monomials[k];
      }
      add_column(column);
    }
  }

  int set_hinge(double angle, double offset)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    int above = 0;
    for (int j = 0; j < m_size; ++j)
    {
      const double t = c * m_x[j] + s * m_y[j] - offset;
      m_hinge[j] = (std::max)(0., t);
      above += t > 0.;
    }
    return above;
  }

  // by how much the fold reduces the sum of squares
  double gain(double angle, double offset)
  {
    const int above = set_hinge(angle, offset);
    if (above < least_on_a_side || m_size - above < least_on_a_side)
      return 0.;
    const double all = sum_of_squares(m_hinge);
    double rest = all;
    for (int l = 0; l < m_number_of_columns; ++l)
      rest -= squared(dot(m_basis[l], m_hinge, m_size));
    if (rest < least_share_of_hinge * all + least_hinge)
      return 0.;
    return squared(dot(m_hinge, m_residuals, m_size)) / rest;
  }

  double find_hinge(double radius, double& angle, double& offset)
  {
    double best = 0.;
    const auto look = [&](double a, double c) {
      const double g = gain(a, c);
      if (g <= best)
        return;
      best = g;
      angle = a;
      offset = c;
    };
    for (int k = 0; k < number_of_directions; ++k)
      for (int l = 0; l < number_of_offsets; ++l)
        look(CGAL_PI * k / number_of_directions, reach * radius * (2. * l / (number_of_offsets - 1) - 1.));
    if (best <= 0.)
      return 0.;
    double da = CGAL_PI / number_of_directions / 2., dc = reach * radius / (number_of_offsets - 1);
    for (int n = 0; n < number_of_refinements; ++n)
    {
      const double a = angle, c = offset;
      for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
          look(a + x * da, c + y * dc);
      if (a == angle && c == offset)
      {
        da /= 2.;
        dc /= 2.;
      }
    }
    return best;
  }

  // what a sheet leaves that bends more, across the fold, but has none
  double squares_of_bent_sheet(std::vector<double> residuals, double angle, double radius)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    // the hinge's column is the last; the two of this sheet take the places from there on
    std::vector<double> first, second;
    for (int k = 0; k < 2; ++k)
    {
      std::vector<double> column(m_size);
      for (int j = 0; j < m_size; ++j)
      {
        const double t = (c * m_x[j] + s * m_y[j]) / radius;
        column[j] = k ? t * t * t * t : t * t * t;
      }
      orthogonalize(column, quadric_size);
      if (k == 1)
      {
        const double d = dot(first, column, m_size);
        for (int j = 0; j < m_size; ++j)
          column[j] -= d * first[j];
      }
      const double norm = std::sqrt(sum_of_squares(column));
      for (double& x : column)
        x = norm > least_norm ? x / norm : 0.;
      const double d = dot(column, residuals, m_size);
      for (int j = 0; j < m_size; ++j)
        residuals[j] -= d * column[j];
      if (k == 0)
        first = column;
    }
    return sum_of_squares(residuals);
  }

  void measure(const std::array<std::array<double, 2>, 2>& places, Fold_fit_result& result)
  {
    const int n = result.number_of_folds;
    if (n == 0)
      return;
    const int size = quadric_size + n;
    double matrix[most_columns * most_columns] = {}, s[most_columns] = {};
    for (int k = 0; k < size; ++k)
    {
      for (int l = 0; l < size; ++l)
        matrix[k * size + l] = dot(m_columns[k], m_columns[l], m_size) + (k == l ? regularization : 0.);
      s[k] = dot(m_columns[k], m_z, m_size);
    }
    Symmetric_factorization(matrix, size).solve(s);
    for (int k = 0; k < n; ++k)
    {
      const double cu = std::cos(places[k][0]), su = std::sin(places[k][0]);
      const double x = places[k][1] * cu, y = places[k][1] * su;
      double z = s[0] + s[1] * x + s[2] * y + s[3] * x * x + s[4] * x * y + s[5] * y * y;
      double gx = s[1] + 2. * s[3] * x + s[4] * y, gy = s[2] + s[4] * x + 2. * s[5] * y;
      for (int l = 0; l < n; ++l)
        if (l != k)
        {
          const double cl = std::cos(places[l][0]), sl = std::sin(places[l][0]);
          const double t = cl * x + sl * y - places[l][1];
          if (t > 0.)
          {
            z += s[quadric_size + l] * t;
            gx += s[quadric_size + l] * cl;
            gy += s[quadric_size + l] * sl;
          }
        }
      Fold& fold = result.folds[k];
      const double slope = s[quadric_size + k];
      const Vector first(-gx, -gy, 1.), second(-gx - slope * cu, -gy - slope * su, 1.);
      fold.angle = std::acos((std::min)(1., first.dot(second) / (first.norm() * second.norm())));
      fold.foot = x * m_a + y * m_b + z * m_normal;
      if (k > 0)
        continue;
      const Vector sum = first.normalized() + second.normalized();
      m_bisector = (sum.x() * m_a + sum.y() * m_b + sum.z() * m_normal).normalized();
      const Vector along = first.cross(second);
      m_along = along.x() * m_a + along.y() * m_b + along.z() * m_normal;
    }
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_FIT_H
