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

#ifndef CASE_MAKER_READ_ABC_SHAPE_H
#define CASE_MAKER_READ_ABC_SHAPE_H

#include <Case_maker/Annotated_shape.h>
#include <Case_maker/choose_scale.h>
#include <Case_maker/read_abc_features.h>
#include <Case_maker/read_obj_mesh.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Case_maker {

namespace internal {

/// Joins a mesh of the ABC dataset and its features. Curves are the polylines of their vertices, as the points of
/// the cloud are on the triangles: so the field is exactly zero where the cloud has its edge.
class Abc_shape_builder
{
public:
  Abc_shape_builder(const std::string& mesh_path, const std::string& features_path)
    : m_mesh_path(mesh_path), m_features_path(features_path), m_features(read_abc_features(m_features_path))
  {
    m_shape.mesh = read_obj_mesh(m_mesh_path);
  }

  Annotated_shape build(const Scale_rule& rule)
  {
    label_triangles();
    collect_mesh_edges();
    select_curves();
    std::vector<double> lengths;
    for (const Abc_curve* curve : m_selected)
      lengths.push_back(length_of(*curve));
    const double scale = choose_scale(lengths, m_shape.mesh.area(), rule, m_shape.remarks);
    for (Point& p : m_shape.mesh.points)
      p = scale * p;
    add_curves();
    return std::move(m_shape);
  }

private:
  /// An edge of a triangle.
  struct Mesh_edge
  {
    std::uint32_t low, high, patch;

    bool operator<(const Mesh_edge& other) const
    {
      return std::tie(low, high, patch) < std::tie(other.low, other.high, other.patch);
    }
  };

  void label_triangles()
  {
    const std::uint32_t none = 0xffffffffu;
    std::vector<std::uint32_t>& patches = m_shape.mesh.patches;
    patches.assign(m_shape.mesh.triangles.size(), none);
    for (std::size_t i = 0; i < m_features.surfaces.size(); ++i)
      for (std::uint32_t face : m_features.surfaces[i].faces)
      {
        if (face >= patches.size())
          fail(m_features.surfaces[i].line,
               "surface " + std::to_string(i) + " has the face " + std::to_string(face) + ", but '" + m_mesh_path
                 + "' has " + std::to_string(patches.size())
                 + " faces, counted from 0; do the two files belong together?");
        if (patches[face] != none && patches[face] != i)
          fail(m_features.surfaces[i].line,
               "face " + std::to_string(face) + " belongs to the surfaces " + std::to_string(patches[face]) + " and "
                 + std::to_string(i));
        patches[face] = static_cast<std::uint32_t>(i);
      }
    for (std::size_t i = 0; i < patches.size(); ++i)
      if (patches[i] == none && m_shape.mesh.area_of(i) > 0)
        throw bad_input("face " + std::to_string(i) + " of '" + m_mesh_path + "' belongs to no surface of '"
                        + m_features_path + "'; do the two files belong together?");
    std::replace(patches.begin(), patches.end(), none, std::uint32_t(0)); // these have no points
  }

  void collect_mesh_edges()
  {
    for (std::size_t i = 0; i < m_shape.mesh.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::uint32_t a = m_shape.mesh.triangles[i][k], b = m_shape.mesh.triangles[i][(k + 1) % 3];
        m_mesh_edges.push_back({(std::min)(a, b), (std::max)(a, b), m_shape.mesh.patches[i]});
      }
    std::sort(m_mesh_edges.begin(), m_mesh_edges.end());
    std::vector<std::set<std::size_t>> neighbors(m_features.surfaces.size());
    for (std::size_t i = 0, j = 0; i < m_mesh_edges.size(); i = j)
      for (j = i; j < m_mesh_edges.size() && is_same(m_mesh_edges[i], m_mesh_edges[j]); ++j)
        for (std::size_t k = i; k < j; ++k)
          if (m_mesh_edges[k].patch != m_mesh_edges[j].patch)
          {
            neighbors[m_mesh_edges[k].patch].insert(m_mesh_edges[j].patch);
            neighbors[m_mesh_edges[j].patch].insert(m_mesh_edges[k].patch);
          }
    for (const std::set<std::size_t>& list : neighbors)
      m_shape.adjacent_patches.emplace_back(list.begin(), list.end());
  }

  static bool is_same(const Mesh_edge& a, const Mesh_edge& b) { return a.low == b.low && a.high == b.high; }

  /// takes the sharp curves; once those that are there twice, and not those that are a point only.
  void select_curves()
  {
    std::set<std::vector<std::uint32_t>> known;
    for (std::size_t i = 0; i < m_features.curves.size(); ++i)
    {
      Abc_curve& curve = m_features.curves[i];
      if (!curve.is_sharp)
        continue;
      for (std::uint32_t v : curve.vertices)
        if (v >= m_shape.mesh.points.size())
          fail(curve.line,
               "curve " + std::to_string(i) + " has the vertex " + std::to_string(v) + ", but '" + m_mesh_path
                 + "' has " + std::to_string(m_shape.mesh.points.size())
                 + " vertices, counted from 0; do the two files belong together?");
      const auto is_at_same_place = [this](std::uint32_t a, std::uint32_t b) {
        return a == b || m_shape.mesh.points[a] == m_shape.mesh.points[b];
      };
      curve.vertices.erase(std::unique(curve.vertices.begin(), curve.vertices.end(), is_at_same_place),
                           curve.vertices.end());
      if (curve.vertices.size() < 2)
        continue;
      const std::vector<std::uint32_t> reversed(curve.vertices.rbegin(), curve.vertices.rend());
      if (known.insert((std::min)(curve.vertices, reversed)).second)
        m_selected.push_back(&curve);
    }
  }

  double length_of(const Abc_curve& curve) const
  {
    double sum = 0;
    for (std::size_t i = 1; i < curve.vertices.size(); ++i)
      sum += distance(m_shape.mesh.points[curve.vertices[i - 1]], m_shape.mesh.points[curve.vertices[i]]);
    return sum;
  }

  void add_curves()
  {
    std::vector<std::set<std::size_t>> curves_of_patches(m_features.surfaces.size());
    for (const Abc_curve* from : m_selected)
    {
      Curve curve;
      curve.source = vertex(from->vertices.front());
      curve.target = vertex(from->vertices.back());
      curve.kind = kind_of(from->type, curve.source == curve.target);
      std::vector<Point> points;
      for (std::uint32_t v : from->vertices)
        points.push_back(m_shape.mesh.points[v]);
      curve.set_polyline(points);
      for (std::size_t i = 1; i < from->vertices.size(); ++i)
        for (std::uint32_t patch : patches_at(*from, from->vertices[i - 1], from->vertices[i]))
          curves_of_patches[patch].insert(m_shape.edges.curves.size());
      m_shape.edges.curves.push_back(curve);
    }
    for (const std::set<std::size_t>& list : curves_of_patches)
      m_shape.curves_of_patches.emplace_back(list.begin(), list.end());
    settle_loops(m_shape.edges);
  }

  std::size_t vertex(std::uint32_t of_mesh)
  {
    const auto found = m_vertices.emplace(of_mesh, m_shape.edges.vertices.size());
    if (found.second)
      m_shape.edges.vertices.push_back(m_shape.mesh.points[of_mesh]);
    return found.first->second;
  }

  static Curve_kind kind_of(const std::string& type, bool is_loop)
  {
    if (type == "Line")
      return Curve_kind::LINE;
    if (type == "Circle")
      return is_loop ? Curve_kind::CIRCLE : Curve_kind::ARC;
    if (type == "Ellipse")
      return is_loop ? Curve_kind::ELLIPSE : Curve_kind::ELLIPTIC_ARC;
    return Curve_kind::SPLINE;
  }

  /// the patches on both sides of a piece of a curve
  std::vector<std::uint32_t> patches_at(const Abc_curve& curve, std::uint32_t a, std::uint32_t b) const
  {
    std::vector<std::uint32_t> result;
    const Mesh_edge edge = {(std::min)(a, b), (std::max)(a, b), 0};
    for (auto i = std::lower_bound(m_mesh_edges.begin(), m_mesh_edges.end(), edge);
         i != m_mesh_edges.end() && is_same(*i, edge); ++i)
      result.push_back(i->patch);
    if (result.empty())
      fail(curve.line,
           "curve " + std::to_string(&curve - m_features.curves.data()) + " goes from vertex " + std::to_string(a)
             + " to vertex " + std::to_string(b) + " (counted from 0), which no edge of '" + m_mesh_path
             + "' joins; do the two files belong together?");
    return result;
  }

  [[noreturn]] void fail(std::size_t line, const std::string& text) const
  {
    throw bad_input(m_features_path, line, text);
  }

  std::string m_mesh_path, m_features_path;
  Abc_features m_features;
  Annotated_shape m_shape;
  std::vector<const Abc_curve*> m_selected;        ///< the sharp curves
  std::vector<Mesh_edge> m_mesh_edges;             ///< sorted
  std::map<std::uint32_t, std::size_t> m_vertices; ///< from those of the mesh
};

} // namespace internal

/// reads a shape of the ABC dataset from its mesh (OBJ) and its features (YAML), and scales it by the rule.
/// Patches are the dataset's surfaces; two are adjacent if an edge of the mesh is part of both.
inline Annotated_shape read_abc_shape(const std::string& mesh_path, const std::string& features_path,
                                      const Scale_rule& rule)
{
  return internal::Abc_shape_builder(mesh_path, features_path).build(rule);
}

} // namespace Case_maker

#endif // CASE_MAKER_READ_ABC_SHAPE_H
