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

#ifndef WIREFRAME_EVALUATION_BSPLINE_H
#define WIREFRAME_EVALUATION_BSPLINE_H

#include <Wireframe_evaluation/Polyline.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Wireframe_evaluation {

/*!
A B-spline curve as it stands in a file, rational if it has weights. The evaluation has its own, so that it does not
rest on the library that it judges.
*/
struct Bspline
{
  std::size_t degree = 0;
  std::vector<double> knots;
  std::vector<Point> control_points;
  std::vector<double> weights; ///< empty, or one per control point

  /// throws `std::runtime_error` with a sentence about the first fault if the data make no curve.
  void check() const
  {
    const std::size_t n = control_points.size();
    if (degree < 1)
      throw std::runtime_error("the degree is 0");
    if (degree > most_degree)
      throw std::runtime_error("the degree is " + std::to_string(degree) + ", more than the "
                               + std::to_string(most_degree) + " allowed");
    if (n <= degree)
      throw std::runtime_error(std::to_string(n) + " control points are too few for degree " + std::to_string(degree));
    if (knots.size() != n + degree + 1)
      throw std::runtime_error("there are " + std::to_string(knots.size()) + " knots; " + std::to_string(n)
                               + " control points of degree " + std::to_string(degree) + " need "
                               + std::to_string(n + degree + 1));
    if (!weights.empty() && weights.size() != n)
      throw std::runtime_error("there are " + std::to_string(weights.size()) + " weights for " + std::to_string(n)
                               + " control points");
    for (double weight : weights)
      if (!(weight > 0.))
        throw std::runtime_error("a weight is not positive");
    for (std::size_t i = 1; i < knots.size(); ++i)
      if (!(knots[i] >= knots[i - 1]))
        throw std::runtime_error("knot " + std::to_string(i) + " is smaller than the one before");
    if (!(knots[degree] < knots[n]))
      throw std::runtime_error("the range of parameters is empty");
  }

  /// returns the point at the parameter `u` on the span from `knots[span]` to `knots[span + 1]`, which must not be
  /// empty (algorithm of de Boor).
  Point point(std::size_t span, double u) const
  {
    double d[most_degree + 1][4];
    for (std::size_t j = 0; j <= degree; ++j)
    {
      const std::size_t i = span - degree + j;
      const double w = weights.empty() ? 1. : weights[i];
      for (int k = 0; k < 3; ++k)
        d[j][k] = w * control_points[i][k];
      d[j][3] = w;
    }
    for (std::size_t round = 1; round <= degree; ++round)
      for (std::size_t j = degree; j >= round; --j)
      {
        const double begin = knots[span - degree + j], end = knots[span + 1 + j - round];
        const double t = (u - begin) / (end - begin);
        for (int k = 0; k < 4; ++k)
          d[j][k] = (1. - t) * d[j - 1][k] + t * d[j][k];
      }
    const double* h = d[degree];
    return weights.empty() ? Point(h[0], h[1], h[2]) : Point(h[0] / h[3], h[1] / h[3], h[2] / h[3]);
  }

  /*!
  returns the curve as a polyline with all its knots among the points, and points about `step` apart at most.
  Throws `std::runtime_error` if a point is not finite.
  */
  Polyline polyline(double step) const
  {
    std::vector<Point> result;
    for (std::size_t span = degree; span < control_points.size(); ++span)
      if (knots[span] < knots[span + 1])
        append_span(span, step, result);
    if (knots[0] == knots[degree]) // clamped: without any rounding
      result.front() = control_points.front();
    if (knots[control_points.size()] == knots.back())
      result.back() = control_points.back();
    for (const Point& p : result)
      if (!is_finite(p))
        throw std::runtime_error("a point of the curve is not finite");
    return Polyline(result);
  }

private:
  static constexpr std::size_t most_degree = 25;
  static constexpr std::size_t most_pieces = 10000; // of a span, should a curve be of monstrous size

  void append_span(std::size_t span, double step, std::vector<Point>& result) const
  {
    if (degree == 1)
      return append_pieces(span, 1, result);
    std::vector<Point> coarse;
    append_pieces(span, 16, coarse);
    const double wanted = std::ceil(1.25 * Polyline(coarse).length() / step);
    const std::size_t n = wanted < double(most_pieces) ? static_cast<std::size_t>(wanted) : most_pieces;
    append_pieces(span, (std::max)(n, std::size_t(16)), result);
  }

  void append_pieces(std::size_t span, std::size_t n, std::vector<Point>& result) const
  {
    const double begin = knots[span], end = knots[span + 1];
    for (std::size_t i = result.empty() ? 0 : 1; i <= n; ++i)
      result.push_back(point(span, i == n ? end : begin + (end - begin) * (double(i) / double(n))));
  }
};

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_BSPLINE_H
