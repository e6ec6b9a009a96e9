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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TRACE_NETWORK_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TRACE_NETWORK_H

#include <CGAL/Wireframe_extraction/internal/Contraction.h>
#include <CGAL/Wireframe_extraction/internal/Curve_end_joiner.h>
#include <CGAL/Wireframe_extraction/internal/Curve_evidence.h>
#include <CGAL/Wireframe_extraction/internal/Extraction_options.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Traces curves from the seeds, best first, and joins them to a network.
class Network_tracer
{
  const Field_band& m_band;
  const Contraction& m_contraction;
  const Extraction_options& m_options;
  Tracing_options m_tracing;
  Joining_options m_joining;

public:
  Network_tracer(const Field_band& band, const Contraction& contraction, const Extraction_options& options)
    : m_band(band), m_contraction(contraction), m_options(options)
  {
    m_tracing.noise = contraction.noise;
    m_tracing.radius = options.fitting_radius;
    m_joining.noise = contraction.noise;
    m_joining.reach = options.corner_reach;
    m_joining.maximum_bridge = options.maximum_gap;
    m_joining.smooth_turn = options.smooth_angle * CGAL_PI / 180.;
  }

  // `proceed(share)` returns whether to go on
  Curve_network run(std::vector<std::size_t> seeds, const std::function<bool(double)>& proceed) const
  {
    const std::vector<Traced_curve> curves = trace(std::move(seeds), proceed);
    Curve_end_joiner joiner(curves, m_joining);
    const double least_gain = m_options.minimum_evidence;
    const Curve_evidence evidence(m_band, m_tracing.tolerance());
    const auto prune = [&](const std::vector<const std::vector<Vector>*>& polylines) {
      return evidence.prune(polylines, least_gain, 0.35 * least_gain);
    };
    joiner.prune(prune);
    joiner.join();
    joiner.prune(prune);
    joiner.drop_spurs(4. + 5. * m_contraction.noise, 2. + 4. * m_contraction.noise);
    return joiner.network();
  }

private:
  std::vector<Traced_curve> trace(std::vector<std::size_t> seeds, const std::function<bool(double)>& proceed) const
  {
    const std::vector<double>& residuals = m_contraction.residuals;
    std::sort(seeds.begin(), seeds.end(), [&](std::size_t a, std::size_t b) {
      return residuals[a] < residuals[b] || (residuals[a] == residuals[b] && a < b);
    });
    const double noise = m_contraction.noise;
    std::vector<Traced_curve> curves;
    Curve_tracer tracer(m_band, m_tracing);
    Field_explanation explanation(m_band);
    std::size_t done = 0;
    for (std::size_t i : seeds) {
      if (++done % 256 == 0 && !proceed(double(done) / double(seeds.size())))
        break;
      if (residuals[i] > 0.1 + 1.3 * noise)
        break;
      const Local_curve& seed = m_contraction.curves[i];
      if (explanation.is_explained(i, m_tracing.tolerance())
          || std::abs(m_band.distances[i] - seed.distance(m_band.points[i])) > m_tracing.tolerance()
          || tracer.is_traced(seed))
        continue;
      const Traced_curve curve = tracer.trace(seed);
      if (curve.length() < 3. + 5. * noise || curve.typical_residual() > 0.1 + 1.6 * noise)
        continue;
      explanation.add(curve.points);
      tracer.keep(curve);
      curves.push_back(curve);
    }
    return curves;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TRACE_NETWORK_H
