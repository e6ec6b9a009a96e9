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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_ARC_LENGTH_TABLE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_ARC_LENGTH_TABLE_H

#include <CGAL/Wireframe_extraction/internal/base/inline_function.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The arc length over a range of parameters, as a table of intervals on which one Gauss rule is accurate.
class Arc_length_table
{
  struct Interval
  {
    double begin, end; // parameters
    std::size_t span;
    double length_before; // from the start of the table to `begin`
    double length;
  };

public:
  Arc_length_table(const Spline_data& spline, double u0, double u1);

  double length() const { return m_length; }

  // Returns the parameter at which the length from the start of the table is s.
  double parameter(double s) const;

private:
  static constexpr double relative_tolerance = 1e-12;
  static constexpr int maximum_depth = 40;

  double integrate(std::size_t span, double begin, double end) const;

  void subdivide(const Interval& interval, double tolerance, int depth);

  void append(Interval interval);

  // Newton's method from linear interpolation, with bisection wherever it would leave the bracket or creep.
  double parameter_in(const Interval& interval, double s) const;

  const Spline_data& m_spline;
  double m_begin, m_end;
  double m_length = 0.;
  std::vector<Interval> m_intervals;
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#ifdef CGAL_WIREFRAME_EXTRACTION_HEADER_ONLY
#include <CGAL/Wireframe_extraction/internal/spline/Arc_length_table_impl.h>
#endif

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_ARC_LENGTH_TABLE_H
