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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_EDGES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_EDGES_IMPL_H

#include <CGAL/Wireframe_extraction/internal/mesh/sharp_edges.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Measures how much the faces of a mesh are folded at its edges, and tells sharp edges from the facets by which a
// curved surface was approximated.
//
// Facets are seen as chords of an arc across them. At the ends of chords that turn the surface by the same angle each,
// folds are as large as that angle, and half of it where the arc meets a tangential plane. So a fold is that of a facet
// if the surface is folded by as much, in the same direction, at the next edges across the facets beside it, and these
// are as wide.
class Sharp_edge_finder
{
public:
  Sharp_edge_finder(const Triangle_mesh& mesh, const Sharp_edge_options& options) : m_mesh(mesh), m_options(options) {}

  Sharp_edges find()
  {
    m_result.minimum_fold = m_options.minimum_fold;
    m_result.largest_turn = (std::max)(usual_turn, m_options.maximum_facet_fold);
    measure_folds();
    mark_facet_edges();
    m_is_sharp.resize(m_mesh.edges.size());
    for (std::size_t i = 0; i < m_mesh.edges.size(); ++i)
    {
      m_is_sharp[i] = is_sharp(i);
      if (m_is_sharp[i] && m_mesh.edges[i].number_of_faces > 1)
        m_result.folded_edges.push_back(static_cast<std::uint32_t>(i));
    }
    follow_fading_edges();
    for (std::size_t i = 0; i < m_mesh.edges.size(); ++i)
      if (m_is_sharp[i])
        m_result.edges.push_back(static_cast<std::uint32_t>(i));
    return std::move(m_result);
  }

private:
  typedef Triangle_mesh::Edge Edge;

  // Of a fold, the parts by which the surface has to be turned on further beside it. On facets as wide as those beside
  // the fold it is turned by the whole fold; by half of it where an arc ends at a tangential plane.
  static constexpr double one_facet = 0.7, two_facets = 1.4, half_facet = 0.35;
  // what turns the surface by less than this part of the fold are the facets of something finer
  static constexpr double comparable = 0.3;
  // facets beside a fold are alike if their widths differ by at most this factor
  static constexpr double alike = 2.;
  // degrees: slivers of a tessellation are folded by no more
  static constexpr double largest_of_slivers = 70.;
  // degrees: facets of smaller folds are as good as the surface that they approximate
  static constexpr double least_facet_fold = 3.;
  static constexpr double faded = 0.3; // the part of the minimum fold down to which a sharp curve is followed
  // Degrees, by which the chords of a curve may always turn. A rim turns as the facets beside it do, so that it is as
  // round as they are only if it may turn by as much.
  static constexpr double usual_turn = 50.;
  static constexpr int most_steps = 64;                                // triangles that are crossed
  static constexpr std::array<double, 3> starts = {{0.5, 0.25, 0.75}}; // on the edge, from where one looks across

  static double degrees(double radians) { return radians * 180. / CGAL_PI; }

  // the direction in a face across one of its edges, away from it
  Vector inward(std::uint32_t face, const Edge& edge) const
  {
    const Vector origin = m_mesh.points[edge.source];
    const Vector along = (m_mesh.points[edge.target] - origin).normalized();
    Vector farthest = Vector::Zero();
    for (std::uint32_t v : m_mesh.triangles[face])
    {
      const Vector d = m_mesh.points[v] - origin;
      const Vector across = d - d.dot(along) * along;
      if (across.squaredNorm() > farthest.squaredNorm())
        farthest = across;
    }
    // exactly in the plane of the face, whose normal is more precise
    const Vector direction = m_mesh.normals[face].cross(along).normalized();
    return direction.dot(farthest) < 0. ? Vector(-direction) : direction;
  }

  void measure_folds()
  {
    m_result.folds.assign(m_mesh.edges.size(), 0.);
    for (std::size_t i = 0; i < m_mesh.edges.size(); ++i)
    {
      const Edge& edge = m_mesh.edges[i];
      if (m_mesh.is_boundary(edge))
        ++m_result.number_of_boundary_edges;
      if (edge.number_of_faces > 2)
        ++m_result.number_of_non_manifold_edges;
      if (edge.number_of_faces != 2)
        continue;
      const Vector one = inward(edge.faces[0], edge), other = inward(edge.faces[1], edge);
      m_result.folds[i] = degrees(std::atan2(-other.dot(m_mesh.normals[edge.faces[0]]), -other.dot(one)));
    }
  }

  bool is_sharp(std::size_t i) const
  {
    const Edge& edge = m_mesh.edges[i];
    if (edge.is_split)
      return false;
    if (edge.number_of_faces == 1)
      return m_options.use_boundaries;
    if (edge.number_of_faces > 2)
      return true; // where sheets meet
    return std::abs(m_result.folds[i]) >= m_options.minimum_fold && !m_result.is_facet_edge[i]
      && is_resolved(static_cast<std::uint32_t>(i));
  }

  // Slivers are turned this way and that, by large angles. What is of no size then is seen from farther away.
  bool is_resolved(std::uint32_t i) const
  {
    if (std::abs(m_result.folds[i]) > largest_of_slivers)
      return true;
    std::size_t votes = 0;
    for (double part : starts)
    {
      double fold = m_result.folds[i];
      for (std::uint32_t face : m_mesh.edges[i].faces)
        go_across(i, part, face, [&](const Crossing& crossing) {
          const bool is_near = crossing.way < m_options.resolution;
          fold += is_near ? crossing.turn : 0.;
          return is_near;
        });
      votes += std::abs(fold) >= m_options.minimum_fold ? 1 : 0;
    }
    return 2 * votes > starts.size();
  }

  // ---- facets ----

  // A place on the way straight across the mesh: where an edge is crossed.
  struct Crossing
  {
    double way = 0.;  // from the start
    double fold = 0.; // of the edge, degrees
    double turn = 0.; // the part of it in the direction of the way
    bool is_passable = true;
  };

  // Goes across a face from a place on one of its edges, straight on over the edges of the mesh; `visit(crossing)`
  // tells whether to go on.
  template <class Visit>
  void go_across(std::uint32_t start, double part, std::uint32_t face, const Visit& visit) const
  {
    const Edge& first = m_mesh.edges[start];
    Vector position = m_mesh.points[first.source] + part * (m_mesh.points[first.target] - m_mesh.points[first.source]);
    Vector direction = inward(face, first);
    std::uint32_t entry = start;
    Crossing crossing;
    for (int step = 0; step < most_steps; ++step)
    {
      std::uint32_t exit = 0;
      Vector end = Vector::Zero();
      if (!leave(face, entry, position, direction, exit, end))
        return;
      crossing.way += (end - position).norm();
      position = end;
      const Edge& edge = m_mesh.edges[exit];
      const Vector axis = (m_mesh.points[edge.target] - m_mesh.points[edge.source]).normalized();
      const double along = direction.dot(axis), across = std::sqrt((std::max)(0., 1. - along * along));
      crossing.fold = m_result.folds[exit];
      crossing.turn = across * crossing.fold;
      crossing.is_passable = edge.number_of_faces == 2 && !edge.is_split;
      if (!visit(crossing) || !crossing.is_passable)
        return;
      const std::uint32_t beyond = edge.faces[0] == face ? edge.faces[1] : edge.faces[0];
      direction = along * axis + across * inward(beyond, edge);
      face = beyond;
      entry = exit;
    }
  }

  // where a straight line leaves a triangle that it has entered
  bool leave(std::uint32_t face, std::uint32_t entry, const Vector& position, const Vector& direction,
             std::uint32_t& exit, Vector& end) const
  {
    const Triangle_mesh::Triangle& t = m_mesh.triangles[face];
    const Vector side = m_mesh.normals[face].cross(direction);
    double farthest = -1.;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (m_mesh.edges_of_triangles[face][k] == entry)
        continue;
      const Vector a = m_mesh.points[t[k]], b = m_mesh.points[t[(k + 1) % 3]];
      const double from = (a - position).dot(side), to = (b - position).dot(side);
      if ((from > 0.) == (to > 0.))
        continue;
      const Vector x = a + from / (from - to) * (b - a);
      const double way = (x - position).dot(direction);
      if (way > farthest)
      {
        farthest = way;
        exit = m_mesh.edges_of_triangles[face][k];
        end = x;
      }
    }
    return farthest > 0.;
  }

  // How the surface goes on across an edge, compared with the fold there.
  struct Side
  {
    double width = 0.;         // where it is turned by another facet, 0 if it never is
    double width_of_two = 0.;  // by two of them
    double width_of_half = 0.; // by half of one
    double free_width = 0.;    // where a sharp edge or a boundary comes, 0 if none does
  };

  Side look_across(std::uint32_t start, double part, std::uint32_t face) const
  {
    Side side;
    const double fold = m_result.folds[start];
    double turned = 0., largest = 0.;
    go_across(start, part, face, [&](const Crossing& crossing) {
      const double turn = crossing.turn / fold;
      if (!crossing.is_passable || std::abs(crossing.fold) > m_options.maximum_facet_fold || turn < -half_facet)
      {
        side.free_width = crossing.way;
        return false;
      }
      turned += turn;
      largest = (std::max)(largest, turn);
      if (largest < comparable)
        return true;
      if (turned >= half_facet && side.width_of_half == 0.)
        side.width_of_half = crossing.way;
      if (turned >= one_facet && side.width == 0.)
      {
        side.width = crossing.way;
        if (side.width > 2. * alike * side.width_of_half) // a plane lies between
          return false;
      }
      if (turned >= two_facets)
        side.width_of_two = crossing.way;
      return turned < two_facets;
    });
    return side;
  }

  static bool are_alike(double a, double b) { return a > 0. && b > 0. && a <= alike * b && b <= alike * a; }

  void mark_facet_edges()
  {
    m_result.is_facet_edge.assign(m_mesh.edges.size(), false);
    for (std::size_t i = 0; i < m_mesh.edges.size(); ++i)
    {
      const double fold = std::abs(m_result.folds[i]);
      if (m_mesh.edges[i].is_split || fold < least_facet_fold || fold > m_options.maximum_facet_fold)
        continue;
      std::size_t votes = 0;
      for (double part : starts)
        votes += is_between_facets(static_cast<std::uint32_t>(i), part) ? 1 : 0;
      if (2 * votes > starts.size())
      {
        m_result.is_facet_edge[i] = true;
        m_result.number_of_facet_edges += fold >= m_options.minimum_fold ? 1 : 0;
      }
    }
  }

  bool is_between_facets(std::uint32_t i, double part) const
  {
    const Edge& edge = m_mesh.edges[i];
    const Side one = look_across(i, part, edge.faces[0]), other = look_across(i, part, edge.faces[1]);
    return are_alike(one.width, other.width) || goes_on(one, other) || goes_on(other, one);
  }

  // whether an arc ends beside the edge on one side, and goes on for two facets on the other
  static bool goes_on(const Side& one, const Side& other)
  {
    return are_alike(one.width_of_two, 2. * one.width)
      && (are_alike(other.width_of_half, one.width) || are_alike(other.free_width, one.width));
  }

  // ---- edges that fade ----

  // whether an edge may be where a sharp curve goes on with a smaller fold
  bool may_fade(std::size_t i) const
  {
    const Edge& edge = m_mesh.edges[i];
    return !m_is_sharp[i] && !edge.is_split && edge.number_of_faces == 2 && !m_result.is_facet_edge[i]
      && std::abs(m_result.folds[i]) >= faded * m_options.minimum_fold;
  }

  std::uint32_t other_end(std::uint32_t i, std::uint32_t v) const
  {
    return m_mesh.edges[i].source == v ? m_mesh.edges[i].target : m_mesh.edges[i].source;
  }

  // An edge of a CAD model is sharp as a whole, also where its fold fades. So a sharp curve that ends within a face is
  // followed along smaller folds, for no longer than it is sharp.
  void follow_fading_edges()
  {
    std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> sharp_at, faded_at; // edges at vertices
    for (std::size_t i = 0; i < m_mesh.edges.size(); ++i)
      for (std::uint32_t v : {m_mesh.edges[i].source, m_mesh.edges[i].target})
        if (m_is_sharp[i])
          sharp_at[v].push_back(static_cast<std::uint32_t>(i));
        else if (may_fade(i))
          faded_at[v].push_back(static_cast<std::uint32_t>(i));
    std::vector<std::uint32_t> ends;
    for (const auto& vertex : sharp_at)
      if (vertex.second.size() == 1)
        ends.push_back(vertex.first);
    std::sort(ends.begin(), ends.end()); // in whatever order they were in the table
    for (std::uint32_t end : ends)
      if (sharp_at[end].size() == 1)
        follow(end, sharp_at, faded_at);
  }

  typedef std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> Edges_at;

  void follow(std::uint32_t v, Edges_at& sharp_at, const Edges_at& faded_at)
  {
    const double sharp_length = length_up_to(v, sharp_at);
    const double side = m_result.folds[sharp_at[v].front()];
    std::vector<std::uint32_t> way;
    std::uint32_t last = sharp_at[v].front();
    double length = 0.;
    for (std::size_t step = 0; step < m_mesh.edges.size(); ++step)
    {
      const auto candidates = faded_at.find(v);
      std::uint32_t best = Triangle_mesh::none;
      double straightest = std::cos(m_result.largest_turn * CGAL_PI / 180.);
      if (candidates != faded_at.end())
        for (std::uint32_t i : candidates->second)
        {
          const double cosine = (m_mesh.points[v] - m_mesh.points[other_end(last, v)])
                                  .normalized()
                                  .dot((m_mesh.points[other_end(i, v)] - m_mesh.points[v]).normalized());
          if (!m_is_sharp[i] && m_result.folds[i] * side > 0. && cosine > straightest)
          {
            straightest = cosine;
            best = i;
          }
        }
      if (best == Triangle_mesh::none)
        break;
      way.push_back(best);
      length += edge_length(best);
      last = best;
      v = other_end(best, v);
      const auto met = sharp_at.find(v);
      if ((met != sharp_at.end() && !met->second.empty()) || length > sharp_length)
        break;
    }
    if (length > sharp_length)
      return;
    for (std::uint32_t i : way)
    {
      m_is_sharp[i] = true;
      sharp_at[m_mesh.edges[i].source].push_back(i);
      sharp_at[m_mesh.edges[i].target].push_back(i);
    }
  }

  double edge_length(std::uint32_t i) const
  {
    return (m_mesh.points[m_mesh.edges[i].target] - m_mesh.points[m_mesh.edges[i].source]).norm();
  }

  // of the sharp curve that ends at a vertex, up to where others meet it
  double length_up_to(std::uint32_t v, const Edges_at& sharp_at) const
  {
    double length = 0.;
    std::uint32_t edge = sharp_at.at(v).front();
    for (std::size_t step = 0; step < m_mesh.edges.size(); ++step)
    {
      length += edge_length(edge);
      v = other_end(edge, v);
      const std::vector<std::uint32_t>& edges = sharp_at.at(v);
      if (edges.size() != 2)
        break;
      edge = edges[0] == edge ? edges[1] : edges[0];
    }
    return length;
  }

  const Triangle_mesh& m_mesh;
  const Sharp_edge_options& m_options;
  Sharp_edges m_result;
  std::vector<bool> m_is_sharp; // of the edges
};

CGAL_WIREFRAME_EXTRACTION_INLINE Sharp_edges find_sharp_edges(const Triangle_mesh& mesh,
                                                              const Sharp_edge_options& options)
{
  return Sharp_edge_finder(mesh, options).find();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_EDGES_IMPL_H
