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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUNDED_SURFACE_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUNDED_SURFACE_IMPL_H

#include <CGAL/Wireframe_extraction/internal/mesh/Rounded_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The normals at the corners of triangles around one vertex.
class Corner_normals
{
public:
  Corner_normals(const Triangle_mesh& mesh, const Sharp_edges& sharp) : m_mesh(mesh), m_sharp(sharp) {}

  // `corners` are three times the index of a triangle, plus that of its corner
  void set(const std::vector<std::uint32_t>& corners, std::vector<std::array<Vector, 3>>& normals)
  {
    m_corners = &corners;
    connect();
    // of each facet, whatever the number of its triangles, the largest one counts; those of a sheet are added up
    m_sums.assign(corners.size(), Vector::Zero());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::size_t facet = root(m_facets, i);
      double largest = 0.;
      std::size_t first = i;
      for (std::size_t j = 0; j < corners.size(); ++j)
        if (root(m_facets, j) == facet)
        {
          largest = (std::max)(largest, m_mesh.areas[corners[j] / 3]);
          first = (std::min)(first, j);
        }
      if (first == i)
        m_sums[root(m_sheets, i)] += largest * m_mesh.normals[corners[i] / 3];
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Vector flat = m_mesh.normals[corners[i] / 3], mean = m_sums[root(m_sheets, i)].normalized();
      normals[corners[i] / 3][corners[i] % 3] = mean.dot(flat) > least_cosine ? mean : flat;
    }
  }

private:
  static constexpr double flat_fold = 0.5;     // degrees: triangles of one facet
  static constexpr double least_cosine = 0.85; // of a facet and a mean normal: half of the largest fold, and some more

  static std::size_t root(std::vector<std::size_t>& parents, std::size_t i)
  {
    while (parents[i] != i)
      i = parents[i] = parents[parents[i]];
    return i;
  }

  // which triangles belong to one facet, and which to one sheet without a sharp edge
  void connect()
  {
    const std::vector<std::uint32_t>& corners = *m_corners;
    std::vector<std::pair<std::uint32_t, std::size_t>> sides;
    m_facets.resize(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const auto& edges = m_mesh.edges_of_triangles[corners[i] / 3];
      sides.emplace_back(edges[corners[i] % 3], i);
      sides.emplace_back(edges[(corners[i] % 3 + 2) % 3], i);
      m_facets[i] = i;
    }
    m_sheets = m_facets;
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 1; i < sides.size(); ++i)
    {
      const std::uint32_t edge = sides[i].first;
      if (edge != sides[i - 1].first || m_mesh.edges[edge].number_of_faces != 2)
        continue;
      const bool is_flat = std::abs(m_sharp.folds[edge]) < flat_fold;
      if (is_flat)
        m_facets[root(m_facets, sides[i].second)] = root(m_facets, sides[i - 1].second);
      if (is_flat || m_sharp.is_facet_edge[edge])
        m_sheets[root(m_sheets, sides[i].second)] = root(m_sheets, sides[i - 1].second);
    }
  }

  const Triangle_mesh& m_mesh;
  const Sharp_edges& m_sharp;
  const std::vector<std::uint32_t>* m_corners = nullptr;
  std::vector<std::size_t> m_facets, m_sheets; // as trees
  std::vector<Vector> m_sums;
};

CGAL_WIREFRAME_EXTRACTION_INLINE Rounded_surface::Rounded_surface(const Triangle_mesh& mesh, const Sharp_edges& sharp)
  : m_mesh(mesh)
{
  static constexpr std::size_t most_triangles = 100; // around a vertex; more are the hub of a flat face
  m_normals.reserve(mesh.triangles.size());
  for (const Vector& normal : mesh.normals)
    m_normals.push_back({normal, normal, normal});
  std::vector<bool> is_curved(mesh.points.size(), false);
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    if (sharp.is_facet_edge[i])
      is_curved[mesh.edges[i].source] = is_curved[mesh.edges[i].target] = true;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> corners; // vertices, and where they are corners
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (is_curved[mesh.triangles[i][k]])
        corners.emplace_back(mesh.triangles[i][k], static_cast<std::uint32_t>(3 * i + k));
  std::sort(corners.begin(), corners.end());
  Corner_normals at_corners(mesh, sharp);
  for (std::size_t first = 0, last = 0; first < corners.size(); first = last)
  {
    std::vector<std::uint32_t> around;
    for (; last < corners.size() && corners[last].first == corners[first].first; ++last)
      around.push_back(corners[last].second);
    if (around.size() < most_triangles)
      at_corners.set(around, m_normals);
  }
}

CGAL_WIREFRAME_EXTRACTION_INLINE Vector Rounded_surface::operator()(std::size_t triangle,
                                                                    const std::array<double, 3>& coordinates) const
{
  // half way to the mean of the projections onto the tangential planes at the corners: above a
  // chord, that is a parabola
  Vector flat = Vector::Zero(), shift = Vector::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    flat += coordinates[k] * m_mesh.points[m_mesh.triangles[triangle][k]];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector& normal = m_normals[triangle][k];
    shift -= coordinates[k] * (flat - m_mesh.points[m_mesh.triangles[triangle][k]]).dot(normal) * normal;
  }
  return flat + 0.5 * shift;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUNDED_SURFACE_IMPL_H
