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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PROJECTOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PROJECTOR_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_pieces.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Finds the globally closest point of a spline. A Bezier piece stays in the hull of its control points, hence
// no farther from its chord than they are: this bounds the distance from below, and what cannot hold the
// minimum is left out. The derivative of the squared distance has, in Bernstein form, at most as many roots
// as its coefficients change sign: a piece is halved until there is at most one, which a safeguarded Newton's
// method finds.
class Spline_projector
{
  typedef boost::container::small_vector<Weighted_control_point, 192> Stack;
  typedef boost::container::small_vector<double, 32> Coefficients;
  typedef boost::container::small_vector<Spline_vector, 32> Vectors;

  enum class Slope
  {
    NEVER_RISES_FROM_A_FALL,
    RISES_FROM_A_FALL_ONCE,
    UNKNOWN
  };

  struct Box
  {
    double bound;
    std::size_t piece;
  };

public:
  struct Result
  {
    double parameter;
    double distance;
  };

  explicit Spline_projector(const Spline_data& spline);

  Result operator()(const Spline_vector& query) const;

private:
  // two minima that are not told apart within 2^-20 of a span are the same up to rounding
  static constexpr std::size_t maximum_depth = 20;
  // far more than a piece needs, except where its distance to the query is the same all along up to rounding
  static constexpr std::size_t maximum_number_of_splits = 512;

  double lower_bound(const Weighted_control_point* points, const Spline_vector& query) const;

  static void consider(double u, const Spline_vector& point, const Spline_vector& query, Result& best);

  void search(const Weighted_control_point* points, std::size_t span, double begin, double end,
              Weighted_control_point* stack, std::size_t depth, std::size_t& splits, const Spline_vector& query,
              Result& best) const;

  // With c - query = a / w the slope has the sign of a * (a' w - a w'), which is a polynomial.
  Slope slope_of_distance(const Weighted_control_point* points, const Spline_vector& query) const;

  static Slope classify(const Coefficients& slope, double rounding);

  // Finds the root of the slope on an interval on which it goes from falling to rising.
  void refine(std::size_t span, double low, double high, const Spline_vector& query, Result& best) const;

  // The distance is flat at its minimum, where points beside it are as close up to rounding: among them the
  // stationary one is the most accurate.
  static void consider_stationary(double u, const Spline_vector& point, const Spline_vector& query, Result& best);

  const Spline_data& m_spline;
  std::vector<Bezier_piece> m_pieces;
  std::vector<double> m_binomials; // of degree - 1
  std::vector<double> m_binomials_of_degree;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/spline/Spline_projector_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_SPLINE_PROJECTOR_H
