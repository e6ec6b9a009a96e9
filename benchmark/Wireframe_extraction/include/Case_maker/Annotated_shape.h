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

#ifndef CASE_MAKER_ANNOTATED_SHAPE_H
#define CASE_MAKER_ANNOTATED_SHAPE_H

#include <Sample_solids/Curve_distance.h>
#include <Sample_solids/Ground_truth.h>
#include <Sample_solids/Poisson_sampler.h>
#include <Sample_solids/sampling.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace Case_maker {

using namespace Sample_solids; // its operators on points, above all

typedef std::array<std::uint32_t, 3> Triangle;

/// A triangle mesh whose triangles know the surface patch that they are part of.
struct Labelled_mesh
{
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<std::uint32_t> patches; ///< per triangle

  double area_of(std::size_t triangle) const
  {
    const Triangle& t = triangles[triangle];
    return 0.5 * norm(cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]));
  }

  double area() const
  {
    double sum = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i)
      sum += area_of(i);
    return sum;
  }
};

/// A shape with its sharp curves, and which of them a point of each patch sees.
struct Annotated_shape
{
  Solid edges; ///< the vertices and the sharp curves; it has no faces
  Labelled_mesh mesh;
  std::vector<std::vector<std::size_t>> curves_of_patches; ///< the sharp curves that bound a patch
  std::vector<std::vector<std::size_t>> adjacent_patches;  ///< those that share an edge with a patch

  /// moves a point of a triangle to the true surface; empty if the mesh is the surface
  std::function<Point(const Labelled_mesh& mesh, std::size_t triangle, const Point& p)> move_to_surface;

  std::string remarks; ///< of who made it, for who uses it
};

/// decides which of the curves that begin where they end are closed curves without a vertex: those that pass
/// their vertex smoothly, and meet no other curve there.
inline void settle_loops(Solid& edges)
{
  std::vector<std::size_t> degrees(edges.vertices.size(), 0);
  for (const Curve& curve : edges.curves)
  {
    ++degrees[curve.source];
    ++degrees[curve.target];
  }
  for (Curve& curve : edges.curves)
    if (curve.source == curve.target && degrees[curve.source] == 2)
      curve.is_closed = dot(curve.tangent(0), curve.tangent(1)) > std::cos(20. * pi / 180.);
}

namespace internal {

/// The tiles of a triangle mesh: its triangles, each in a triangular grid. Where the grid of a thin triangle
/// would have many more tiles than its area needs, the triangle is cut first.
class Mesh_tiling
{
public:
  struct Tile
  {
    std::uint32_t piece, i, j;
    bool is_flipped; ///< its corners are (i+1, j+1), (i, j+1), (i+1, j) if so, else (i, j), (i+1, j), (i, j+1)
  };

  explicit Mesh_tiling(const Labelled_mesh& mesh) : m_mesh(mesh) {}

  std::vector<Tile> tiles(double side)
  {
    for (std::size_t i = 0; i < m_mesh.triangles.size(); ++i)
    {
      const Triangle& t = m_mesh.triangles[i];
      const std::uint32_t index = static_cast<std::uint32_t>(i);
      add_pieces(m_mesh.points[t[0]], m_mesh.points[t[1]], m_mesh.points[t[2]], index, side);
    }
    double heaviest = 0;
    for (const Piece& piece : m_pieces)
      heaviest = (std::max)(heaviest, piece.weight);
    std::vector<Tile> result;
    for (std::uint32_t k = 0; k < m_pieces.size(); ++k)
    {
      m_pieces[k].weight /= heaviest;
      const std::uint32_t n = static_cast<std::uint32_t>(m_pieces[k].rows);
      for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; i + j < n; ++j)
        {
          result.push_back({k, i, j, false});
          if (i + j + 1 < n)
            result.push_back({k, i, j, true});
        }
    }
    return result;
  }

  bool throw_dart(const Tile& tile, Random& random, Point& p) const
  {
    const Piece& piece = m_pieces[tile.piece];
    if (random.uniform() > piece.weight)
      return false;
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1)
    {
      u = 1. - u;
      v = 1. - v;
    }
    p = at(tile, u, v);
    return true;
  }

  bool is_on_surface(const Tile&, const Point&) const { return true; }
  bool is_off_surface(const Tile&) const { return false; }

  Point center(const Tile& tile) const { return at(tile, 1. / 3., 1. / 3.); }

  double extent(const Tile& tile) const { return m_pieces[tile.piece].extent / m_pieces[tile.piece].rows; }

  void halve()
  {
    for (Piece& piece : m_pieces)
      piece.rows *= 2;
  }

  Tile quarter(const Tile& tile, std::uint32_t k) const
  {
    const std::uint32_t f = tile.is_flipped ? 1 : 0, i = 2 * tile.i + f, j = 2 * tile.j + f;
    if (k == 3)
      return {tile.piece, i, j, !tile.is_flipped}; // the middle one
    if (!tile.is_flipped)
      return {tile.piece, i + k % 2, j + k / 2, false};
    return {tile.piece, i - k % 2, j - k / 2, true};
  }

  std::uint32_t face(const Tile& tile) const { return m_pieces[tile.piece].triangle; }

private:
  struct Piece
  {
    Point corner, u, v; ///< a corner and the sides from there
    std::uint32_t triangle;
    double rows;   ///< of the grid on the present level
    double weight; ///< of one tile relative to the heaviest: how likely a dart may hit it
    double extent; ///< largest distance of a corner to the centre
  };

  /// adds a triangle, in parts if it is thin.
  void add_pieces(const Point& a, const Point& b, const Point& c, std::uint32_t triangle, double side)
  {
    const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
    if (ab < bc || ab < ca) // ab is to be the longest side
    {
      if (bc >= ca)
        add_pieces(b, c, a, triangle, side);
      else
        add_pieces(c, a, b, triangle, side);
      return;
    }
    const double area = 0.5 * norm(cross(b - a, c - a)), height = 2. * area / ab;
    if (!(area > 0))
      return;
    const double rows = std::ceil(ab / side), needed = (std::max)(1., area / (0.43 * side * side));
    if (rows * rows <= 2.5 * needed)
    {
      add_piece(a, b, c, triangle, side);
      return;
    }
    const double foot = dot(c - a, b - a) / ab; // of the height, on ab
    if (foot > height && ab - foot > height)
    {
      const Point d = a + (foot / ab) * (b - a);
      add_slices(a, d, c, triangle, side);
      add_slices(b, d, c, triangle, side);
    }
    else if (foot < 0.5 * ab)
      add_slices(b, a, c, triangle, side);
    else
      add_slices(a, b, c, triangle, side);
  }

  /// cuts a needle across. Bisecting its longest side would also halve its width, to no use.
  void add_slices(const Point& tip, const Point& a, const Point& b, std::uint32_t triangle, double side)
  {
    const double length = (std::max)(distance(tip, a), distance(tip, b));
    const double n = (std::max)(1., std::ceil(length / (std::max)(side, distance(a, b))));
    Point a_last = tip, b_last = tip;
    for (double i = 1; i <= n; ++i)
    {
      const Point a_next = tip + (i / n) * (a - tip), b_next = tip + (i / n) * (b - tip);
      add_piece(a_last, a_next, b_next, triangle, side);
      if (i > 1)
        add_piece(a_last, b_last, b_next, triangle, side);
      a_last = a_next;
      b_last = b_next;
    }
  }

  void add_piece(const Point& a, const Point& b, const Point& c, std::uint32_t triangle, double side)
  {
    const double area = 0.5 * norm(cross(b - a, c - a));
    if (!(area > 0))
      return;
    const double longest = (std::max)({distance(a, b), distance(b, c), distance(c, a)});
    const double rows = (std::max)(1., std::ceil(longest / side));
    const Point center = (1. / 3.) * (a + b + c);
    const double extent = (std::max)({distance(a, center), distance(b, center), distance(c, center)});
    m_pieces.push_back({a, b - a, c - a, triangle, rows, area / (rows * rows), extent});
  }

  Point at(const Tile& tile, double u, double v) const
  {
    const Piece& piece = m_pieces[tile.piece];
    if (tile.is_flipped)
    {
      u = 1. - u;
      v = 1. - v;
    }
    return piece.corner + ((tile.i + u) / piece.rows) * piece.u + ((tile.j + v) / piece.rows) * piece.v;
  }

  const Labelled_mesh& m_mesh;
  std::vector<Piece> m_pieces;
};

} // namespace internal

/// What a cloud is made with.
struct Case_sampling
{
  double sampling_distance = 0.02;
  double truncation = 50; ///< upper bound of the field, in sampling distances
  Field_scope scope = Field_scope::ADJACENT;
  std::uint64_t seed = 1;
};

/// gives each point of a cloud its distance to the nearest sharp curve of its own patch and of those adjacent to
/// it, or to the nearest of all.
inline void annotate(const Annotated_shape& shape, const Case_sampling& options, Cloud& cloud)
{
  const bool is_all = options.scope == Field_scope::ALL;
  std::vector<Curve_distance> trees;
  if (is_all)
    trees.emplace_back(shape.edges.curves, shape.edges.sharp_curves());
  else
    for (const std::vector<std::size_t>& curves : shape.curves_of_patches)
      trees.emplace_back(shape.edges.curves, curves);
  const double bound = options.truncation * options.sampling_distance;
  cloud.exact_distances.clear();
  cloud.exact_distances.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    // one tree per patch, not one per patch and its neighbours: their sum would be quadratic around a plate
    // with many holes
    double d = trees[is_all ? 0 : cloud.faces[i]](cloud.points[i], bound);
    if (!is_all)
      for (std::size_t other : shape.adjacent_patches[cloud.faces[i]])
        d = trees[other](cloud.points[i], d);
    cloud.exact_distances.push_back(d);
  }
  cloud.distances = cloud.exact_distances;
}

/// samples a shape evenly, with an exact field. `Cloud::faces` becomes the patches. Takes a time linear in the
/// number of points, but for the depth of the trees of the curves.
inline Cloud sample_exactly(const Annotated_shape& shape, const Case_sampling& options)
{
  Cloud cloud;
  cloud.sampling_distance = options.sampling_distance;
  cloud.truncation = options.truncation;
  const std::size_t n = number_of_points(shape.mesh.area(), options.sampling_distance);
  Random random(options.seed);
  {
    internal::Mesh_tiling tiling(shape.mesh);
    Poisson_sampler<internal::Mesh_tiling>(tiling, options.sampling_distance, n, random, cloud).run();
  }
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    if (shape.move_to_surface)
      cloud.points[i] = shape.move_to_surface(shape.mesh, cloud.faces[i], cloud.points[i]);
    cloud.faces[i] = shape.mesh.patches[cloud.faces[i]];
  }
  annotate(shape, options, cloud);
  return cloud;
}

} // namespace Case_maker

#endif // CASE_MAKER_ANNOTATED_SHAPE_H
