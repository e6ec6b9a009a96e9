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

#ifndef SAMPLE_SOLIDS_GROUND_TRUTH_H
#define SAMPLE_SOLIDS_GROUND_TRUTH_H

#include <Sample_solids/Solid.h>

#include <cstddef>
#include <vector>

namespace Sample_solids {

/// A curve of the ground truth, sampled.
struct True_curve
{
  Curve_kind kind = Curve_kind::LINE;
  bool is_closed = false;
  double length = 0;
  std::vector<Point> points; ///< from end to end; a closed curve ends with its first point
};

/// The ground truth of a solid: `curves` are chains of sharp edges through vertices of degree 2 at which they
/// turn by less than 20 degrees, `segments` the single edges, `corners` the ends of the chains.
struct Ground_truth
{
  double sampling_distance = 0;
  std::vector<True_curve> curves;
  std::vector<True_curve> segments;
  std::vector<Point> corners;
};

namespace internal {

/// Joins the sharp edges of a solid to chains.
class Chains
{
public:
  Chains(const Solid& solid, double step)
    : m_solid(solid), m_step(step), m_incident(m_solid.vertices.size()), m_is_used(m_solid.curves.size(), false)
  {
    for (std::size_t edge : m_solid.sharp_curves())
      if (!m_solid.curves[edge].is_closed)
      {
        m_incident[m_solid.curves[edge].source].push_back(edge);
        m_incident[m_solid.curves[edge].target].push_back(edge);
      }
  }

  Ground_truth ground_truth()
  {
    Ground_truth result;
    for (std::size_t vertex = 0; vertex < m_solid.vertices.size(); ++vertex)
      if (!m_incident[vertex].empty() && !is_passed(vertex))
      {
        result.corners.push_back(m_solid.vertices[vertex]);
        for (std::size_t edge : m_incident[vertex])
          if (!m_is_used[edge])
            result.curves.push_back(chain_from(vertex, edge));
      }
    for (std::size_t edge : m_solid.sharp_curves())
    {
      const True_curve segment = segment_of(edge);
      result.segments.push_back(segment);
      if (m_is_used[edge])
        continue;
      const Curve& curve = m_solid.curves[edge];
      result.curves.push_back(curve.is_closed ? segment : chain_from(curve.source, edge));
    }
    return result;
  }

private:
  True_curve segment_of(std::size_t edge) const
  {
    const Curve& curve = m_solid.curves[edge];
    True_curve segment = {curve.kind, curve.is_closed, curve.length(), curve.sampled(m_step)};
    if (!curve.is_closed)
    {
      // the curves of a vertex end there to the last digit
      segment.points.front() = m_solid.vertices[curve.source];
      segment.points.back() = m_solid.vertices[curve.target];
    }
    return segment;
  }

  /// the direction in which an edge leaves a vertex
  Point leaving(std::size_t edge, std::size_t vertex) const
  {
    const Curve& curve = m_solid.curves[edge];
    return curve.source == vertex ? curve.tangent(0) : -1. * curve.tangent(1);
  }

  bool is_passed(std::size_t vertex) const
  {
    const std::vector<std::size_t>& edges = m_incident[vertex];
    return edges.size() == 2 && edges[0] != edges[1]
      && dot(leaving(edges[0], vertex), leaving(edges[1], vertex)) < -std::cos(20. * pi / 180.);
  }

  True_curve chain_from(std::size_t vertex, std::size_t edge)
  {
    True_curve chain;
    const std::size_t first = vertex;
    std::size_t count = 0;
    while (true)
    {
      m_is_used[edge] = true;
      append(chain, edge, vertex, count++);
      vertex = other_end(edge, vertex);
      if (!is_passed(vertex))
        break;
      edge = m_incident[vertex][0] == edge ? m_incident[vertex][1] : m_incident[vertex][0];
      if (m_is_used[edge])
        break;
    }
    chain.is_closed = vertex == first && is_passed(vertex);
    if (chain.is_closed)
      chain.points.back() = chain.points.front();
    return chain;
  }

  std::size_t other_end(std::size_t edge, std::size_t vertex) const
  {
    const Curve& curve = m_solid.curves[edge];
    return curve.source == vertex ? curve.target : curve.source;
  }

  void append(True_curve& chain, std::size_t edge, std::size_t vertex, std::size_t count) const
  {
    True_curve segment = segment_of(edge);
    if (m_solid.curves[edge].source != vertex)
      std::reverse(segment.points.begin(), segment.points.end());
    chain.kind = count == 0 ? segment.kind : Curve_kind::COMPOSITE;
    chain.length += segment.length;
    chain.points.insert(chain.points.end(), segment.points.begin() + (count == 0 ? 0 : 1), segment.points.end());
  }

  const Solid& m_solid;
  double m_step;
  std::vector<std::vector<std::size_t>> m_incident;
  std::vector<bool> m_is_used;
};

} // namespace internal

/// returns the ground truth of a solid, its curves sampled at a quarter of the sampling distance.
inline Ground_truth ground_truth(const Solid& solid, double sampling_distance)
{
  Ground_truth result = internal::Chains(solid, 0.25 * sampling_distance).ground_truth();
  result.sampling_distance = sampling_distance;
  return result;
}

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_GROUND_TRUTH_H
