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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_PAIR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_PAIR_H

#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Sheet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Two sheets, and the curve in which they meet. Lengths are in sampling distances.
class Sheet_pair
{
  const Sheet& m_a;
  const Sheet& m_b;
  double m_tolerance; // points farther from a sheet are not on it
  Vector m_foot = Vector::Zero(), m_direction = Vector::Zero(), m_normal_of_a = Vector::Zero(),
         m_normal_of_b = Vector::Zero();
  double m_angle = 0.;

  // Between their normals, 12 degrees: their errors move the curve in which they meet by five times as much.
  static constexpr double least_sine = 0.2;
  static constexpr int number_of_steps = 4; // of Newton's method; the sheets are nearly plane
  // in r: beyond the balls that they were fitted in, sheets are not known
  static constexpr double farthest = 4.;
  static constexpr int least_degrees_of_freedom = 3; // with fewer, a variance is an accident

public:
  Sheet_pair(const Sheet& a, const Sheet& b, double tolerance) : m_a(a), m_b(b), m_tolerance(tolerance) {}

  const Vector& foot() const { return m_foot; }
  // Of the fold, in radians: 0 where the sheets go on into one another, nearly pi at the edge of a
  // knife. Known where both end.
  double angle() const { return m_angle; }

  // finds where they meet, as near to a place as possible; returns whether they do
  bool meet_near(const Vector& place)
  {
    m_foot = place;
    for (int step = 0; step < number_of_steps; ++step)
    {
      const double fa = m_a.offset(m_foot, &m_normal_of_a), fb = m_b.offset(m_foot, &m_normal_of_b);
      m_direction = m_normal_of_a.cross(m_normal_of_b);
      const double sine = m_direction.norm();
      if (sine < least_sine)
        return false;
      m_direction /= sine;
      const double cosine = m_normal_of_a.dot(m_normal_of_b), determinant = 1. - cosine * cosine;
      m_foot += ((cosine * fb - fa) * m_normal_of_a + (cosine * fa - fb) * m_normal_of_b) / determinant;
      m_foot += m_direction * m_direction.dot(place - m_foot);
      if ((m_foot - place).norm() > farthest)
        return false;
    }
    return true;
  }

  enum class Ends
  {
    BOTH,
    NOT_BOTH,
    UNKNOWN // of one of them there are too few points
  };

  // Whether each ends where it meets the other, by the points around that place: then nearly all of its points are on
  // one side of the other.
  Ends find_ends(const std::vector<Vector>& around)
  {
    static constexpr int least_points = 2;     // of each sheet: one may be an outlier
    static constexpr double clear_share = 0.5; // of the tolerance: 1.5 standard deviations of the points
    static constexpr double most_beyond = 0.2; // the share of them, since points next to the fold may be on either side
    int sides[2][2] = {};
    for (const Vector& p : around)
    {
      const double from_a = m_a.offset(p), from_b = m_b.offset(p);
      const double to_a = std::abs(from_a), to_b = std::abs(from_b);
      // what is near both tells nothing
      if (to_a < m_tolerance && to_a < to_b && to_b > clear_share * m_tolerance)
        ++sides[0][from_b > 0.];
      else if (to_b < m_tolerance && to_b < to_a && to_a > clear_share * m_tolerance)
        ++sides[1][from_a > 0.];
    }
    for (const int(&side)[2] : sides)
      if (side[0] + side[1] < least_points)
        return Ends::UNKNOWN;
    for (const int(&side)[2] : sides)
      if ((std::min)(side[0], side[1]) > most_beyond * (side[0] + side[1]))
        return Ends::NOT_BOTH;
    measure_angle(sides[0][1] > sides[0][0], sides[1][1] > sides[1][0]);
    return Ends::BOTH;
  }

  // By how much the pair explains its points better than a smooth sheet that bends across the fold, a quadric and t^3
  // and t^4: the difference of chi square, for points with this standard deviation.
  double margin(const std::vector<Vector>& around, double deviation) const
  {
    static constexpr int least_points =
      10; // the smooth sheet has eight parameters: fewer tell nothing, and forbid nothing
    const double sign = m_normal_of_a.dot(m_normal_of_b) < 0. ? -1. : 1.;
    double best = (std::numeric_limits<double>::infinity)(), of_pair = 0.;
    int count = 0;
    for (double side : {sign, -sign}) // sheets have no sides, so the fold's may be either
    {
      const Vector mean = m_normal_of_a + side * m_normal_of_b;
      count = collect(around, mean.normalized(), of_pair);
      if (count < least_points)
        return (std::numeric_limits<double>::infinity)();
      best = (std::min)(best, squares_of_smooth_sheet());
    }
    return (best - of_pair)
      / (std::max)(deviation * deviation, of_pair / (std::max)(+least_degrees_of_freedom, count - parameters - 1));
  }

private:
  // by which side of the other sheet the points of each lie on
  void measure_angle(bool is_a_above_b, bool is_b_above_a)
  {
    Vector from_fold_on_a = m_direction.cross(m_normal_of_a), from_fold_on_b = m_direction.cross(m_normal_of_b);
    if ((m_normal_of_b.dot(from_fold_on_a) > 0.) != is_a_above_b)
      from_fold_on_a = -from_fold_on_a;
    if ((m_normal_of_a.dot(from_fold_on_b) > 0.) != is_b_above_a)
      from_fold_on_b = -from_fold_on_b;
    m_angle = std::acos((std::max)(-1., (std::min)(1., -from_fold_on_a.dot(from_fold_on_b))));
  }

  static constexpr int parameters = 8;            // of the smooth sheet
  typedef std::array<double, parameters + 1> Row; // and the height
  mutable std::vector<Row> m_rows;

  int collect(const std::vector<Vector>& around, const Vector& normal, double& squares) const
  {
    static constexpr double scale = 3.; // so that monomials are no larger than 1
    const Vector across = m_direction.cross(normal).normalized();
    m_rows.clear();
    squares = 0.;
    for (const Vector& p : around)
    {
      const double e = (std::min)(std::abs(m_a.offset(p)), std::abs(m_b.offset(p)));
      if (e > m_tolerance)
        continue;
      squares += e * e;
      const Vector d = p - m_foot;
      const double t = d.dot(across) / scale, s = d.dot(m_direction) / scale;
      m_rows.push_back({1., t, s, t * t, t * s, s * s, t * t * t, t * t * t * t, d.dot(normal)});
    }
    return static_cast<int>(m_rows.size());
  }

  double squares_of_smooth_sheet() const
  {
    static constexpr double ridge = 1e-6; // keeps the equations regular; far below one point's weight
    double matrix[parameters * parameters] = {}, column[parameters] = {};
    for (const Row& row : m_rows)
      for (int i = 0; i < parameters; ++i)
      {
        for (int j = 0; j < parameters; ++j)
          matrix[i * parameters + j] += row[i] * row[j];
        column[i] += row[i] * row[parameters];
      }
    for (int i = 0; i < parameters; ++i)
      matrix[i * parameters + i] += ridge;
    Symmetric_factorization(matrix, parameters).solve(column);
    double squares = 0.;
    for (const Row& row : m_rows)
    {
      double e = row[parameters];
      for (int i = 0; i < parameters; ++i)
        e -= column[i] * row[i];
      squares += e * e;
    }
    return squares;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_SHEET_PAIR_H
