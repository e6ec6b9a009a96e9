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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_LOCAL_SHAPE_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_LOCAL_SHAPE_IMPL_H

#include <CGAL/Wireframe_extraction/internal/spline/local_shape.h>
#include <CGAL/Wireframe_extraction/internal/spline/spline_basis.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE bool shape_on_span(const Spline_data& spline, std::size_t span, double u,
                                                    bool is_left_limit, Local_shape& shape)
{
  // below this fraction of the largest term a term is rounding
  const double negligible = 1e-12;
  const double width = spline.knots[span + 1] - spline.knots[span];

  // A curve whose first `degree` derivatives vanish is constant on the span; the curvature asks for twice as
  // many.
  const std::size_t order = 2 * spline.degree;
  boost::container::small_vector<Spline_vector, 16> terms(order + 1);
  evaluate_on_span(spline, span, u, order, terms.data());
  double scale = 1., largest = 0.;
  for (std::size_t k = 1; k <= order; ++k)
  {
    scale *= width / double(k);
    terms[k] = scale * terms[k];
    if (k <= spline.degree)
      largest = (std::max)(largest, norm(terms[k]));
  }
  if (!(largest > 0.))
    return false;

  std::size_t m = 1;
  while (!(norm(terms[m]) > negligible * largest))
    ++m;
  const double a = norm(terms[m]);
  shape.tangent = ((is_left_limit && m % 2 == 0 ? -1. : 1.) / a) * terms[m];

  shape.curvature = 0.;
  for (std::size_t n = m + 1; n <= 2 * m; ++n)
  {
    const double sine = norm(cross(shape.tangent, terms[n]));
    if (n < 2 * m && !(sine > negligible * largest))
      continue;
    shape.curvature = n < 2 * m ? (std::numeric_limits<double>::max)() : 2. * sine / (a * a);
    break;
  }
  return true;
}

CGAL_WIREFRAME_EXTRACTION_INLINE Local_shape local_shape(const Spline_data& spline, double u)
{
  Local_shape shape;
  const std::size_t start = find_span(spline.knots, spline.degree, u);
  const bool is_left_limit = u >= spline.back();
  if (shape_on_span(spline, start, u, is_left_limit, shape))
    return shape;

  // The curve stands still here. What comes next decides, and if nothing does, what came before.
  const auto is_empty = [&](std::size_t s) { return !(spline.knots[s] < spline.knots[s + 1]); };
  for (std::size_t s = start + 1; s < spline.points.size(); ++s)
    if (!is_empty(s) && shape_on_span(spline, s, spline.knots[s], false, shape))
      return shape;
  for (std::size_t s = start; s-- > spline.degree;)
    if (!is_empty(s) && shape_on_span(spline, s, spline.knots[s + 1], true, shape))
      return shape;
  return shape;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SPLINE_LOCAL_SHAPE_IMPL_H
