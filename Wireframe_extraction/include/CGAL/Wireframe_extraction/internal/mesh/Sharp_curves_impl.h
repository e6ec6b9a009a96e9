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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_CURVES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_CURVES_IMPL_H

#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_curves.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Follows sharp edges from vertex to vertex.
class Sharp_curve_finder
{
public:
  Sharp_curve_finder(const Triangle_mesh& mesh, const std::vector<std::uint32_t>& sharp_edges, double largest_turn)
    : m_mesh(mesh), m_edges(sharp_edges), m_largest_turn(largest_turn)
  {
    for (std::uint32_t i : sharp_edges)
      for (std::uint32_t v : {mesh.edges[i].source, mesh.edges[i].target})
        m_around[v].push_back(i);
    for (const Triangle_mesh::Edge& edge : mesh.edges)
      if (mesh.is_boundary(edge))
        m_is_on_boundary.insert({edge.source, edge.target});
  }

  Sharp_curves find()
  {
    Sharp_curves result;
    result.number_of_vertices = m_around.size();
    for (const auto& vertex : m_around)
    {
      const std::vector<std::uint32_t>& edges = vertex.second;
      result.number_of_corners += edges.size() > 2 ? 1 : 0;
      // at the boundary, curves may end, and it may have corners of its own
      const bool is_within = m_is_on_boundary.count(vertex.first) == 0;
      const bool is_loose = edges.size() == 1 || (edges.size() == 2 && turns(vertex.first, edges));
      result.number_of_loose_ends += is_within && is_loose ? 1 : 0;
    }
    for (std::uint32_t first : m_edges)
      if (m_is_done.insert(first).second)
      {
        result.polylines.push_back(polyline_from(first));
        result.lengths.push_back(length(result.polylines.back()));
      }
    return result;
  }

private:
  std::uint32_t other_end(std::uint32_t edge, std::uint32_t v) const
  {
    return m_mesh.edges[edge].source == v ? m_mesh.edges[edge].target : m_mesh.edges[edge].source;
  }

  // whether two edges meet at an angle, instead of being chords of one curve
  bool turns(std::uint32_t v, const std::vector<std::uint32_t>& edges) const
  {
    const Vector in = (m_mesh.points[v] - m_mesh.points[other_end(edges[0], v)]).normalized();
    const Vector out = (m_mesh.points[other_end(edges[1], v)] - m_mesh.points[v]).normalized();
    return std::acos((std::max)(-1., (std::min)(1., in.dot(out)))) * 180. / CGAL_PI > m_largest_turn;
  }

  double length(const std::vector<std::uint32_t>& polyline) const
  {
    double sum = 0.;
    for (std::size_t i = 1; i < polyline.size(); ++i)
      sum += (m_mesh.points[polyline[i]] - m_mesh.points[polyline[i - 1]]).norm();
    return sum;
  }

  std::vector<std::uint32_t> polyline_from(std::uint32_t first)
  {
    std::vector<std::uint32_t> behind = vertices_beyond(first, m_mesh.edges[first].source);
    std::vector<std::uint32_t> result(behind.rbegin(), behind.rend());
    const std::vector<std::uint32_t> before = vertices_beyond(first, m_mesh.edges[first].target);
    result.insert(result.end(), before.begin(), before.end());
    return result;
  }

  // the vertices from one end of an edge on
  std::vector<std::uint32_t> vertices_beyond(std::uint32_t edge, std::uint32_t v)
  {
    std::vector<std::uint32_t> result = {v};
    for (;;)
    {
      const std::vector<std::uint32_t>& edges = m_around[v];
      if (edges.size() != 2 || turns(v, edges))
        return result;
      edge = edges[0] == edge ? edges[1] : edges[0];
      if (!m_is_done.insert(edge).second)
        return result;
      v = other_end(edge, v);
      result.push_back(v);
    }
  }

  const Triangle_mesh& m_mesh;
  const std::vector<std::uint32_t>& m_edges;
  const double m_largest_turn;                                            // degrees
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> m_around; // edges at vertices
  std::unordered_set<std::uint32_t> m_is_on_boundary, m_is_done;
};

CGAL_WIREFRAME_EXTRACTION_INLINE Sharp_curves find_sharp_curves(const Triangle_mesh& mesh,
                                                                const std::vector<std::uint32_t>& sharp_edges,
                                                                double largest_turn)
{
  return Sharp_curve_finder(mesh, sharp_edges, largest_turn).find();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_CURVES_IMPL_H
