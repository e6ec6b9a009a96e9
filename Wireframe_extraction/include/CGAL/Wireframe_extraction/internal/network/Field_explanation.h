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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIELD_EXPLANATION_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIELD_EXPLANATION_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What the field says of curves: which of the band's points agree with them.
class Field_explanation
{
  // in sampling distances: points farther from all curves count as explained by none, whatever their distances, since
  // a band reaches no farther than about 3; and the length of the pieces whose points are looked up at once
  static constexpr double reach = 3.5, piece_length = 2.;

  const Field_band& m_band;
  std::vector<double> m_distances; // of each point of the band to the curves so far
  mutable std::vector<std::size_t> m_ball;

public:
  explicit Field_explanation(const Field_band& band)
    : m_band(band), m_distances(band.size(), (std::numeric_limits<double>::infinity)())
  {}

  void add(const std::vector<Vector>& polyline)
  {
    for (std::size_t k = 1; k < polyline.size(); ++k)
      add(polyline[k - 1], polyline[k]);
  }

  void add(const Vector& a, const Vector& b)
  {
    const std::size_t pieces = 1 + static_cast<std::size_t>((b - a).norm() / piece_length);
    for (std::size_t k = 0; k < pieces; ++k)
    {
      const Vector from = a + (b - a) * (double(k) / pieces), to = a + (b - a) * (double(k + 1) / pieces);
      m_band.search.query(0.5 * (from + to), reach + 0.5 * (to - from).norm(), m_ball);
      for (std::size_t i : m_ball)
        m_distances[i] = (std::min)(m_distances[i], std::sqrt(squared_distance_to_segment(m_band.points[i], from, to)));
    }
  }

  double distance(std::size_t i) const { return m_distances[i]; }
  const std::vector<double>& distances() const { return m_distances; }

  bool is_explained(std::size_t i, double noise) const
  {
    return m_band.distances[i] > m_distances[i] - agreement_tolerance(m_band.deviation(i, noise));
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_FIELD_EXPLANATION_H
