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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PIECES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PIECES_IMPL_H

#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_pieces.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE Weighted_control_point interpolate(const Weighted_control_point& a,
                                                                    const Weighted_control_point& b, double t)
{
  if (t <= 0.)
    return a;
  if (t >= 1.)
    return b;
  if (a.weight == b.weight)
    return Weighted_control_point{a.point + t * (b.point - a.point), a.weight};
  const double weight = (1. - t) * a.weight + t * b.weight;
  return Weighted_control_point{a.point + (t * b.weight / weight) * (b.point - a.point), weight};
}

CGAL_WIREFRAME_EXTRACTION_INLINE Weighted_control_point weighted_control_point(const Spline_data& spline, std::size_t i)
{
  return Weighted_control_point{spline.points[i], spline.weights.empty() ? 1. : spline.weights[i]};
}

CGAL_WIREFRAME_EXTRACTION_INLINE void insert_knot_fully(Spline_data& spline, double u)
{
  const std::size_t degree = spline.degree;
  const std::size_t multiplicity = spline.multiplicity(u);
  if (multiplicity >= degree)
    return;
  const std::size_t count = degree - multiplicity;
  const std::size_t span =
    std::size_t(std::upper_bound(spline.knots.begin(), spline.knots.end(), u) - spline.knots.begin()) - 1;

  // Of the control points that act on u, each round of the corner cutting fixes the first and the last one.
  std::vector<Weighted_control_point> row, left, right;
  for (std::size_t i = span - degree; i <= span - multiplicity; ++i)
    row.push_back(weighted_control_point(spline, i));
  for (std::size_t round = 1; round <= count; ++round)
  {
    left.push_back(row.front());
    right.push_back(row.back());
    for (std::size_t j = 0; j + 1 < row.size(); ++j)
    {
      const std::size_t i = span - degree + round + j;
      const double begin = spline.knots[i];
      row[j] = interpolate(row[j], row[j + 1], (u - begin) / (spline.knots[i + degree - round + 1] - begin));
    }
    row.pop_back();
  }
  row.insert(row.begin(), left.begin(), left.end());
  row.insert(row.end(), right.rbegin(), right.rend());

  // the row is longer by `count` than the control points that it replaces
  const std::size_t first = span - degree;
  spline.points.insert(spline.points.begin() + first, count, Spline_vector());
  if (!spline.weights.empty())
    spline.weights.insert(spline.weights.begin() + first, count, 1.);
  for (std::size_t j = 0; j < row.size(); ++j)
  {
    spline.points[first + j] = row[j].point;
    if (!spline.weights.empty())
      spline.weights[first + j] = row[j].weight;
  }
  spline.knots.insert(spline.knots.begin() + span + 1, count, u);
}

CGAL_WIREFRAME_EXTRACTION_INLINE Spline_data clamped_part(Spline_data spline, double u0, double u1)
{
  insert_knot_fully(spline, u0);
  insert_knot_fully(spline, u1);
  const auto begin = std::upper_bound(spline.knots.begin(), spline.knots.end(), u0);
  const auto end = std::lower_bound(spline.knots.begin(), spline.knots.end(), u1);
  const std::size_t first = std::size_t(begin - spline.knots.begin()) - 1 - spline.degree;
  const std::size_t beyond = std::size_t(end - spline.knots.begin());

  Spline_data part;
  part.degree = spline.degree;
  part.knots.assign(spline.degree + 1, u0);
  part.knots.insert(part.knots.end(), begin, end);
  part.knots.insert(part.knots.end(), spline.degree + 1, u1);
  part.points.assign(spline.points.begin() + first, spline.points.begin() + beyond);
  if (!spline.weights.empty())
    part.weights.assign(spline.weights.begin() + first, spline.weights.begin() + beyond);
  return part;
}

CGAL_WIREFRAME_EXTRACTION_INLINE std::vector<Bezier_piece> bezier_pieces(const Spline_data& spline)
{
  const std::size_t degree = spline.degree;
  std::vector<Bezier_piece> pieces;
  std::vector<Weighted_control_point> row(degree + 1);
  for (std::size_t span = degree; span < spline.points.size(); ++span)
  {
    if (!(spline.knots[span] < spline.knots[span + 1]))
      continue;
    Bezier_piece piece{span, spline.knots[span], spline.knots[span + 1], {}};
    // control point k is the polar form at k times the end and degree - k times the begin of the span
    for (std::size_t k = 0; k <= degree; ++k)
    {
      for (std::size_t j = 0; j <= degree; ++j)
        row[j] = weighted_control_point(spline, span - degree + j);
      for (std::size_t round = 1; round <= degree; ++round)
      {
        const double u = round <= k ? piece.end : piece.begin;
        for (std::size_t j = 0; j + round <= degree; ++j)
        {
          const std::size_t i = span - degree + round + j;
          const double low = spline.knots[i];
          row[j] = interpolate(row[j], row[j + 1], (u - low) / (spline.knots[i + degree - round + 1] - low));
        }
      }
      piece.points.push_back(row[0]);
    }
    if (!pieces.empty())
      piece.points.front() = pieces.back().points.back();
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PIECES_IMPL_H
