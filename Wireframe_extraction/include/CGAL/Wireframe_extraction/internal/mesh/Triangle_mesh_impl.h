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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGLE_MESH_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGLE_MESH_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/cell_key.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Triangle_mesh.h>
#include <CGAL/Wireframe_extraction/internal/mesh/triangulate_polygon.h>

#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE std::string check_soup(const Polygon_soup& soup)
{
  static constexpr double most_coordinate = 1e150; // squares have to be finite
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (!soup.points[i].allFinite() || soup.points[i].cwiseAbs().maxCoeff() > most_coordinate)
      return "vertex " + std::to_string(i) + " (counted from 0) has a coordinate that is not finite, or too large";
  for (std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    const std::vector<std::size_t>& polygon = soup.polygons[i];
    if (polygon.size() < 3)
      return "face " + std::to_string(i) + " (counted from 0) has only "
        + CGAL::IO::internal::plural(polygon.size(), "vertex", "vertices");
    for (std::size_t v : polygon)
      if (v >= soup.points.size())
        return "face " + std::to_string(i) + " (counted from 0) has a vertex that does not exist; there are "
          + std::to_string(soup.points.size()) + " vertices";
  }
  if (soup.polygons.empty())
    return "there are no faces";
  return std::string();
}

// Makes a triangle mesh of a soup, step by step.
class Triangle_mesh_maker
{
public:
  explicit Triangle_mesh_maker(const Polygon_soup& soup) { add_triangles(soup); }

  Triangle_mesh make()
  {
    find_edges();
    split_edges_at_t_junctions();
    orient();
    return std::move(m_mesh);
  }

private:
  typedef Triangle_mesh::Edge Edge;
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;

  // a triangle is degenerate if its height is below this times the longest side: what rounding of
  // single precision makes
  static constexpr double least_height = 1e-7;
  // vertices that are no farther from an edge, times the diagonal, end on it: rounding of single precision
  static constexpr double junction_tolerance = 1e-6;

  void add_triangles(const Polygon_soup& soup)
  {
    std::vector<Point> points;
    for (const Vector& p : soup.points)
      points.emplace_back(p.x() + 0., p.y() + 0., p.z() + 0.); // -0 becomes 0
    std::vector<std::vector<std::size_t>> polygons = soup.polygons;
    CGAL::Polygon_mesh_processing::merge_duplicate_points_in_polygon_soup(points, polygons);
    for (const Point& p : points)
      m_mesh.points.emplace_back(p.x(), p.y(), p.z());
    std::vector<Triangle_mesh::Triangle> triangles;
    for (const std::vector<std::size_t>& polygon : polygons)
      triangulate_polygon(m_mesh.points, polygon, triangles);
    add_once(triangles);
    measure_diagonal();
  }

  // of what has an area: points may be there without a triangle, anywhere
  void measure_diagonal()
  {
    if (m_mesh.triangles.empty())
      return;
    Vector low = m_mesh.points[m_mesh.triangles.front()[0]], high = low;
    for (const Triangle_mesh::Triangle& triangle : m_mesh.triangles)
      for (std::uint32_t v : triangle)
      {
        low = low.cwiseMin(m_mesh.points[v]);
        high = high.cwiseMax(m_mesh.points[v]);
      }
    m_mesh.diagonal = (high - low).norm();
  }

  // leaves out what has no area, and all but one of those with the same vertices
  void add_once(const std::vector<Triangle_mesh::Triangle>& triangles)
  {
    std::vector<std::pair<Triangle_mesh::Triangle, std::size_t>> sorted;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      Triangle_mesh::Triangle key = triangles[i];
      std::sort(key.begin(), key.end());
      sorted.emplace_back(key, i);
    }
    std::sort(sorted.begin(), sorted.end());
    std::vector<bool> is_duplicate(triangles.size(), false);
    for (std::size_t i = 1; i < sorted.size(); ++i)
      is_duplicate[sorted[i].second] = sorted[i].first == sorted[i - 1].first;
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      const Triangle_mesh::Triangle& t = triangles[i];
      const Vector a = m_mesh.points[t[0]], b = m_mesh.points[t[1]], c = m_mesh.points[t[2]];
      const Vector cross = (b - a).cross(c - a);
      const double side = (std::max)({(b - a).norm(), (c - b).norm(), (a - c).norm()});
      if (!(cross.norm() > least_height * side * side))
        ++m_mesh.number_of_degenerate;
      else if (is_duplicate[i])
        ++m_mesh.number_of_duplicates;
      else
      {
        m_mesh.triangles.push_back(t);
        m_mesh.normals.push_back(cross.normalized());
        m_mesh.areas.push_back(0.5 * cross.norm());
        m_mesh.area += 0.5 * cross.norm();
      }
    }
  }

  static void add_face(Edge& edge, std::uint32_t face)
  {
    if (edge.number_of_faces < 2)
      edge.faces[edge.number_of_faces] = face;
    ++edge.number_of_faces;
  }

  void find_edges()
  {
    typedef std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t> Side; // vertices, triangle, place
    std::vector<Side> sides;
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
      for (std::uint32_t k = 0; k < 3; ++k)
      {
        const std::uint32_t a = m_mesh.triangles[i][k], b = m_mesh.triangles[i][(k + 1) % 3];
        sides.emplace_back((std::min)(a, b), (std::max)(a, b), static_cast<std::uint32_t>(i), k);
      }
    std::sort(sides.begin(), sides.end());
    m_mesh.edges_of_triangles.resize(m_mesh.triangles.size());
    for (const Side& side : sides)
    {
      if (m_mesh.edges.empty() || m_mesh.edges.back().source != std::get<0>(side)
          || m_mesh.edges.back().target != std::get<1>(side))
      {
        m_mesh.edges.emplace_back();
        m_mesh.edges.back().source = std::get<0>(side);
        m_mesh.edges.back().target = std::get<1>(side);
      }
      add_face(m_mesh.edges.back(), std::get<2>(side));
      m_mesh.edges_of_triangles[std::get<2>(side)][std::get<3>(side)] =
        static_cast<std::uint32_t>(m_mesh.edges.size() - 1);
    }
  }

  // ---- T-junctions ----

  struct Junction
  {
    double parameter;
    std::uint32_t vertex;
    bool operator<(const Junction& other) const
    {
      return std::tie(parameter, vertex) < std::tie(other.parameter, other.vertex);
    }
  };

  // Boundary edges on which vertices of other boundary edges lie become the pieces between these, and what coincides
  // then is one edge of both faces.
  void split_edges_at_t_junctions()
  {
    std::vector<std::uint32_t> boundary;
    for (std::size_t i = 0; i < m_mesh.edges.size(); ++i)
      if (m_mesh.is_boundary(m_mesh.edges[i]))
        boundary.push_back(static_cast<std::uint32_t>(i));
    if (boundary.empty())
      return;
    const Vertex_grid grid(m_mesh, boundary);
    std::unordered_map<std::uint64_t, std::uint32_t> pieces;
    for (std::uint32_t i : boundary)
    {
      std::vector<Junction> junctions = junctions_of(m_mesh.edges[i], grid);
      if (junctions.empty())
        continue;
      m_mesh.edges[i].is_split = true;
      ++m_mesh.number_of_t_junctions;
      std::sort(junctions.begin(), junctions.end());
      junctions.push_back({1., m_mesh.edges[i].target});
      std::uint32_t from = m_mesh.edges[i].source;
      for (const Junction& junction : junctions)
      {
        add_piece(pieces, from, junction.vertex, m_mesh.edges[i].faces[0]);
        from = junction.vertex;
      }
    }
    join_pieces(boundary, pieces);
  }

  static std::uint64_t key_of(std::uint32_t a, std::uint32_t b)
  {
    return static_cast<std::uint64_t>((std::min)(a, b)) << 32 | (std::max)(a, b);
  }

  void add_piece(std::unordered_map<std::uint64_t, std::uint32_t>& pieces, std::uint32_t a, std::uint32_t b,
                 std::uint32_t face)
  {
    if (a == b)
      return;
    const auto found = pieces.emplace(key_of(a, b), static_cast<std::uint32_t>(m_mesh.edges.size()));
    if (found.second)
    {
      m_mesh.edges.emplace_back();
      m_mesh.edges.back().source = (std::min)(a, b);
      m_mesh.edges.back().target = (std::max)(a, b);
    }
    add_face(m_mesh.edges[found.first->second], face);
  }

  // whole edges that coincide with a piece become one with it
  void join_pieces(const std::vector<std::uint32_t>& boundary,
                   const std::unordered_map<std::uint64_t, std::uint32_t>& pieces)
  {
    for (std::uint32_t i : boundary)
    {
      Edge& edge = m_mesh.edges[i];
      const auto found = edge.is_split ? pieces.end() : pieces.find(key_of(edge.source, edge.target));
      if (found == pieces.end())
        continue;
      add_face(m_mesh.edges[found->second], edge.faces[0]);
      edge.is_split = true;
    }
  }

  // the vertices of boundary edges, in cells of the size of a usual edge
  class Vertex_grid
  {
  public:
    Vertex_grid(const Triangle_mesh& mesh, const std::vector<std::uint32_t>& boundary) : m_mesh(mesh)
    {
      std::vector<double> lengths;
      std::vector<std::uint32_t> vertices;
      for (std::uint32_t i : boundary)
      {
        const Edge& edge = mesh.edges[i];
        lengths.push_back((mesh.points[edge.source] - mesh.points[edge.target]).norm());
        vertices.push_back(edge.source);
        vertices.push_back(edge.target);
      }
      static constexpr double least_cell = 1e-4; // diagonals: most edges may have no length
      m_cell = (std::max)(median(lengths), least_cell * mesh.diagonal);
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      for (std::uint32_t v : vertices)
        m_cells[key(mesh.points[v])].push_back(v);
    }

    // calls `visit(vertex)` for all vertices in cells near a segment, some of them more than once
    template <class Visit>
    void visit(const Vector& from, const Vector& to, const Visit& visit) const
    {
      const std::size_t steps = 1 + static_cast<std::size_t>((to - from).norm() / m_cell);
      std::uint64_t last = 0;
      bool is_first = true;
      for (std::size_t i = 0; i <= steps; ++i)
      {
        const Vector middle = from + (to - from) * (double(i) / double(steps));
        const std::uint64_t here = key(middle);
        if (!is_first && here == last)
          continue;
        is_first = false;
        last = here;
        for (int x = -1; x <= 1; ++x)
          for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
            {
              const auto found = m_cells.find(key(middle + m_cell * Vector(x, y, z)));
              if (found != m_cells.end())
                for (std::uint32_t v : found->second)
                  visit(v);
            }
      }
    }

  private:
    std::uint64_t key(const Vector& p) const
    {
      return cell_key(static_cast<std::int64_t>(std::floor(p.x() / m_cell)),
                      static_cast<std::int64_t>(std::floor(p.y() / m_cell)),
                      static_cast<std::int64_t>(std::floor(p.z() / m_cell)));
    }

    const Triangle_mesh& m_mesh;
    double m_cell = 1.;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;
  };

  std::vector<Junction> junctions_of(const Edge& edge, const Vertex_grid& grid) const
  {
    const Vector from = m_mesh.points[edge.source], to = m_mesh.points[edge.target], step = to - from;
    const double tolerance = junction_tolerance * m_mesh.diagonal, length = step.norm();
    std::vector<Junction> result;
    if (length <= 2. * tolerance)
      return result;
    grid.visit(from, to, [&](std::uint32_t v) {
      const double parameter = (m_mesh.points[v] - from).dot(step) / (length * length);
      if (v == edge.source || v == edge.target || parameter * length < tolerance
          || (1. - parameter) * length < tolerance || (m_mesh.points[v] - from - parameter * step).norm() > tolerance)
        return;
      for (const Junction& junction : result)
        if (junction.vertex == v)
          return;
      result.push_back({parameter, v});
    });
    return result;
  }

  // ---- orientation ----

  // whether a triangle has an edge in the direction from its source to its target
  bool is_along(std::uint32_t face, const Edge& edge) const
  {
    const Triangle_mesh::Triangle& t = m_mesh.triangles[face];
    const Vector direction = m_mesh.points[edge.target] - m_mesh.points[edge.source];
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == edge.source && t[(k + 1) % 3] == edge.target)
        return true;
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == edge.target && t[(k + 1) % 3] == edge.source)
        return false;
    // a piece of an edge: the third vertex is on the left, seen along the normal
    Vector farthest = Vector::Zero();
    for (std::uint32_t v : t)
    {
      const Vector d = m_mesh.points[v] - m_mesh.points[edge.source];
      const Vector across = d - d.dot(direction) / direction.squaredNorm() * direction;
      if (across.norm() > farthest.norm())
        farthest = across;
    }
    return m_mesh.normals[face].dot(direction.cross(farthest)) > 0.;
  }

  void flip(std::uint32_t face)
  {
    std::swap(m_mesh.triangles[face][1], m_mesh.triangles[face][2]);
    std::swap(m_mesh.edges_of_triangles[face][0], m_mesh.edges_of_triangles[face][2]);
    m_mesh.normals[face] = -m_mesh.normals[face];
  }

  void orient()
  {
    std::vector<std::vector<std::uint32_t>> edges_of_faces(m_mesh.triangles.size());
    for (std::size_t i = 0; i < m_mesh.edges.size(); ++i)
      if (m_mesh.edges[i].number_of_faces == 2)
        for (std::uint32_t face : m_mesh.edges[i].faces)
          edges_of_faces[face].push_back(static_cast<std::uint32_t>(i));
    std::vector<bool> is_done(m_mesh.triangles.size(), false);
    std::vector<std::uint32_t> stack;
    for (std::size_t first = 0; first < m_mesh.triangles.size(); ++first)
    {
      if (is_done[first])
        continue;
      is_done[first] = true;
      stack.push_back(static_cast<std::uint32_t>(first));
      while (!stack.empty())
      {
        const std::uint32_t face = stack.back();
        stack.pop_back();
        for (std::uint32_t i : edges_of_faces[face])
        {
          const Edge& edge = m_mesh.edges[i];
          const std::uint32_t other = edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
          if (is_done[other])
            continue;
          if (is_along(face, edge) == is_along(other, edge))
            flip(other);
          is_done[other] = true;
          stack.push_back(other);
        }
      }
    }
  }

  Triangle_mesh m_mesh;
};

CGAL_WIREFRAME_EXTRACTION_INLINE Triangle_mesh make_triangle_mesh(const Polygon_soup& soup)
{
  return Triangle_mesh_maker(soup).make();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_TRIANGLE_MESH_IMPL_H
