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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_MISSING_EDGE_FOLDS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_MISSING_EDGE_FOLDS_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_evidence.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>
#include <CGAL/Wireframe_extraction/internal/network/Fold_evidence.h>

#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Whether the surface is folded along straight edges that a network lacks. What has to be known of its curves is
// found when it is asked for the first time, which it seldom is.
class Missing_edge_folds
{
  const Field_band& m_surroundings;
  const Curve_network& m_network;
  Progress& m_progress;
  Fold_evidence m_surface;
  Curve_evidence m_curves;
  bool m_is_prepared = false;
  std::vector<double> m_distances; // of the surroundings to the curves
  double m_noise = 0.;             // of the surface

public:
  // `surroundings` may be empty: then nothing is folded
  Missing_edge_folds(const Field_band& surroundings, double noise_of_field, const Curve_network& network,
                     Progress& progress)
    : m_surroundings(surroundings), m_network(network), m_progress(progress), m_surface(surroundings, &progress),
      m_curves(surroundings, noise_of_field, &progress)
  {}

  // beyond doubt; after cancelling, nothing is
  bool is_folded(const std::vector<Vector>& edge)
  {
    if (m_surroundings.size() == 0)
      return false;
    if (!m_is_prepared)
    {
      m_distances = m_curves.distances(m_network.polylines());
      m_noise = m_surface.noise_along(m_network.polylines());
      m_is_prepared = true;
    }
    return m_progress.goes_on()
      && m_surface.fold_of_edge(edge.front(), edge.back(), m_distances, m_noise).is_folded_beyond_doubt();
  }

  // the network has one curve more
  void add(const std::vector<Vector>& edge)
  {
    if (m_is_prepared)
      m_curves.add(edge, m_distances);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_MISSING_EDGE_FOLDS_H
