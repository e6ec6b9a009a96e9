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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_EVIDENCE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_EVIDENCE_H

#include <CGAL/Wireframe_extraction/internal/Curve_network.h>
#include <CGAL/Wireframe_extraction/internal/Segment_grid.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How much worse the field would be explained without a curve. The loss of a point is its squared residual in units
// of the tolerance, at most 1; the gain of a curve is what the losses of its points would grow by without it.
class Curve_evidence
{
  const Field_band& m_band;
  double m_noise, m_least_tolerance;

  static constexpr double farthest = 4.;

  double loss(std::size_t i, double distance) const
  {
    const double tolerance = (std::max)(m_least_tolerance, 2.5 * m_band.deviation(i, m_noise));
    const double ratio = (m_band.distances[i] - distance) / tolerance;
    return (std::min)(1., ratio * ratio);
  }

  // calls visitor(i, distance) for the points near a polyline
  template <class Visitor>
  void visit_around(const std::vector<Vector>& polyline, const Visitor& visitor) const
  {
    Segment_grid grid;
    grid.add(0, polyline);
    Eigen::AlignedBox3d box;
    for (const Vector& p : polyline)
      box.extend(p);
    std::vector<std::size_t> ball;
    m_band.search.query(box.center(), 0.5 * box.diagonal().norm() + farthest, ball);
    for (std::size_t i : ball) {
      const Segment_grid::Hit hit = grid.nearest(m_band.points[i], farthest,
                                                 [](const Segment_grid::Hit&) { return true; });
      if (hit.is_valid())
        visitor(i, hit.distance);
    }
  }

public:
  struct Scores
  {
    std::vector<double> gains;                          // per curve
    std::vector<std::vector<std::size_t> > neighbors;   // curves that would take over its points
  };

  Curve_evidence(const Field_band& band, double noise, double least_tolerance = 0.2)
    : m_band(band), m_noise(noise), m_least_tolerance(least_tolerance)
  {}

  // polylines[c] may be empty: no such curve
  Scores scores(const std::vector<const std::vector<Vector>*>& polylines) const
  {
    Segment_grid grid;
    for (std::size_t c = 0; c < polylines.size(); ++c)
      if (polylines[c])
        grid.add(c, *polylines[c]);
    Scores result;
    result.gains.assign(polylines.size(), 0.);
    result.neighbors.resize(polylines.size());
    const double far = farthest;
    for (std::size_t i = 0; i < m_band.size(); ++i) {
      std::size_t first = Segment_grid::no_curve, second = Segment_grid::no_curve;
      double d1 = far, d2 = far;
      grid.visit(m_band.points[i], far, [&](const Segment_grid::Hit& hit) {
        if (hit.curve == first)
          d1 = (std::min)(d1, hit.distance);
        else if (hit.distance < d1) {
          d2 = d1; second = first;
          d1 = hit.distance; first = hit.curve;
        } else if (hit.distance < d2) {
          d2 = hit.distance; second = hit.curve;
        }
      });
      if (first == Segment_grid::no_curve)
        continue;
      result.gains[first] += loss(i, d2) - loss(i, d1);
      if (second != Segment_grid::no_curve && loss(i, d2) < 1.)
        result.neighbors[first].push_back(second);
    }
    return result;
  }

  // of every point of the band to the nearest polyline, at most 4
  std::vector<double> distances(const std::vector<const std::vector<Vector>*>& polylines) const
  {
    Segment_grid grid;
    for (std::size_t c = 0; c < polylines.size(); ++c)
      if (polylines[c])
        grid.add(c, *polylines[c]);
    std::vector<double> result(m_band.size(), farthest);
    for (std::size_t i = 0; i < m_band.size(); ++i)
      grid.visit(m_band.points[i], farthest,
                 [&](const Segment_grid::Hit& hit) { result[i] = (std::min)(result[i], hit.distance); });
    return result;
  }

  // lowers the distances to those with one more polyline
  void add(const std::vector<Vector>& polyline, std::vector<double>& distances) const
  {
    visit_around(polyline, [&](std::size_t i, double distance) {
      distances[i] = (std::min)(distances[i], distance);
    });
  }

  // how much better the field would be explained with one more polyline; `others` are the distances without it
  double gain_of(const std::vector<Vector>& polyline, const std::vector<double>& others) const
  {
    double gain = 0.;
    visit_around(polyline, [&](std::size_t i, double distance) {
      gain += loss(i, others[i])
        - loss(i, (std::min)(others[i], distance));
    });
    return gain;
  }

  // the loss of the points around `center` if there were only these polylines
  double loss_around(const Vector& center, double radius,
                     const std::vector<const std::vector<Vector>*>& polylines) const
  {
    Segment_grid grid;
    for (std::size_t c = 0; c < polylines.size(); ++c)
      grid.add(c, *polylines[c]);
    std::vector<std::size_t> ball;
    m_band.search.query(center, radius, ball);
    double sum = 0.;
    for (std::size_t i : ball) {
      const Segment_grid::Hit hit = grid.nearest(m_band.points[i], farthest,
                                                 [](const Segment_grid::Hit&) { return true; });
      sum += loss(i, (hit.is_valid() ? hit.distance : farthest));
    }
    return sum;
  }

  // Returns which of the curves to keep: without the others, worst first, the field is explained about as well.
  std::vector<char> prune(std::vector<const std::vector<Vector>*> polylines, double least_gain,
                          double least_gain_per_length) const
  {
    std::vector<char> keep(polylines.size());
    for (std::size_t c = 0; c < polylines.size(); ++c)
      keep[c] = polylines[c] != nullptr;
    for (bool changed = true; changed; ) {
      changed = false;
      const Scores all = scores(polylines);
      std::vector<double> worth(polylines.size(), 0.);
      std::vector<std::size_t> order;
      for (std::size_t c = 0; c < polylines.size(); ++c)
        if (keep[c]) {
          worth[c] = all.gains[c] - least_gain - least_gain_per_length * polyline_length(*polylines[c]);
          if (worth[c] < 0.)
            order.push_back(c);
        }
      std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return worth[a] < worth[b]; });
      std::vector<char> is_affected(polylines.size(), 0);
      for (std::size_t c : order) {
        if (is_affected[c])
          continue;
        keep[c] = 0;
        polylines[c] = nullptr;
        changed = true;
        for (std::size_t other : all.neighbors[c])
          is_affected[other] = 1;
      }
    }
    return keep;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_EVIDENCE_H
