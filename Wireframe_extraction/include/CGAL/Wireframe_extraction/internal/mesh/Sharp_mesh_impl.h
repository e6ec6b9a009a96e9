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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_MESH_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_MESH_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/cell_key.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Rounded_surface.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_mesh.h>
#include <CGAL/Wireframe_extraction/internal/mesh/round_polyline.h>

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/version.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// the number of samples on an area of one square sampling distance
static constexpr double mesh_sample_density = 0.62;

// ---- what a mesh is ----

// Whether the sharp edges of a mesh are those of a scan: they follow the triangles that happened to be there, thus
// break off, fork, and zigzag. Sharp edges of a shape form chains. Boundaries do not tell, whether they are sharp or
// not. (The thresholds lie in the gaps between what was measured: 0.57 and 0.62 of chains per sharp edge, 0 and 0.07 of
// loose ends, 0.2 and 0.8 of rough edges.)
inline bool is_scan(const Sharp_mesh& mesh)
{
  static constexpr double broken = 0.6; // chains per sharp edge, more in scans; or a coarse mesh, whose faces are flat
  static constexpr double loose = 0.04; // loose ends per vertex of sharp edges, more in scans
  static constexpr double rough = 0.5;  // of the other edges that are folded, more in scans
  static constexpr double flat = 2.;    // degrees
  const double edges = static_cast<double>(mesh.sharp.folded_edges.size());
  const Sharp_curves curves = find_sharp_curves(mesh.mesh, mesh.sharp.folded_edges, mesh.sharp.largest_turn);
  if (static_cast<double>(curves.lengths.size()) < broken * edges || mesh.sharp.folded_edges.empty())
    return false;
  std::size_t number_of_rough = 0;
  for (std::size_t i = 0; i < mesh.mesh.edges.size(); ++i)
  {
    const double fold = std::abs(mesh.sharp.folds[i]);
    number_of_rough += fold > flat && fold < mesh.sharp.minimum_fold ? 1 : 0;
  }
  const double others = static_cast<double>(mesh.mesh.edges.size()) - edges;
  return static_cast<double>(curves.number_of_loose_ends) > loose * static_cast<double>(curves.number_of_vertices)
    || static_cast<double>(number_of_rough) > rough * others;
}

// ---- the sampling distance ----

inline double sampling_distance_for(double area, double number_of_points)
{
  return std::sqrt(mesh_sample_density * area / number_of_points);
}

// The sampling distance at which most sharp curves are long enough to be found, if the number of points allows it.
inline double choose_sampling_distance(const Sharp_mesh& mesh, const Sharp_mesh_options& options)
{
  static constexpr double short_share = 0.05;    // of the curves may be shorter
  static constexpr double short_length = 12.;    // sampling distances: shorter curves are often missed
  static constexpr double least_points = 20000.; // fewer save no time that matters
  const double most_points = static_cast<double>(options.maximum_number_of_points);
  const double finest = sampling_distance_for(mesh.mesh.area, most_points);
  const double coarsest = sampling_distance_for(mesh.mesh.area, (std::min)(least_points, most_points));
  std::vector<double> lengths = mesh.curves.lengths;
  if (lengths.empty())
    return coarsest;
  std::sort(lengths.begin(), lengths.end());
  const double length = lengths[static_cast<std::size_t>(short_share * static_cast<double>(lengths.size() - 1))];
  return (std::min)(coarsest, (std::max)(finest, length / short_length));
}

// ---- points ----

// Throws darts on a mesh, and keeps those that are not closer to one on the same side of a sheet.
class Mesh_dart_thrower
{
public:
  Mesh_dart_thrower(const Triangle_mesh& mesh, const Sharp_edges& sharp, double radius, std::uint32_t seed)
    : m_mesh(mesh), m_surface(mesh, sharp), m_radius(radius), m_cell(2. * radius), m_random(seed)
  {
    double sum = 0.;
    for (double area : mesh.areas)
      m_sums.push_back(sum += area);
  }

  // no points if it was told to stop
  std::vector<Vector> throw_darts(std::size_t number, const std::function<bool(double)>& proceed)
  {
    static constexpr std::size_t darts_between_questions = 4096; // they take some milliseconds
    for (std::size_t i = 0; i < number; ++i)
    {
      if (i % darts_between_questions == 0 && !proceed(static_cast<double>(i) / static_cast<double>(number)))
        return {};
      throw_dart();
    }
    return std::move(m_points);
  }

private:
  // with one distribution of numbers everywhere, which that of the standard library has not
  double number() { return static_cast<double>(m_random() >> 11) * 0x1p-53; }

  void throw_dart()
  {
    const double target = number() * m_sums.back();
    const std::size_t face =
      (std::min)(static_cast<std::size_t>(std::upper_bound(m_sums.begin(), m_sums.end(), target) - m_sums.begin()),
                 m_sums.size() - 1);
    double u = number(), v = number();
    if (u + v > 1.)
    {
      u = 1. - u;
      v = 1. - v;
    }
    const Vector p = m_surface(face, {{1. - u - v, u, v}});
    if (has_neighbor(p, m_mesh.normals[face]))
      return;
    m_cells[key(coordinate(p.x()), coordinate(p.y()), coordinate(p.z()))].push_back(
      static_cast<std::uint32_t>(m_points.size()));
    m_points.push_back(p);
    m_normals.push_back(m_mesh.normals[face]);
  }

  std::int64_t coordinate(double x) const { return static_cast<std::int64_t>(std::floor(x / m_cell)); }

  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) { return cell_key(x, y, z); }

  bool has_neighbor(const Vector& p, const Vector& normal) const
  {
    static constexpr double other_side = -0.5; // the cosine of normals of the two sides of a thin sheet is less
    for (std::int64_t x = coordinate(p.x() - m_radius); x <= coordinate(p.x() + m_radius); ++x)
      for (std::int64_t y = coordinate(p.y() - m_radius); y <= coordinate(p.y() + m_radius); ++y)
        for (std::int64_t z = coordinate(p.z() - m_radius); z <= coordinate(p.z() + m_radius); ++z)
        {
          const auto found = m_cells.find(key(x, y, z));
          if (found == m_cells.end())
            continue;
          for (std::uint32_t i : found->second)
            if ((m_points[i] - p).squaredNorm() < m_radius * m_radius && m_normals[i].dot(normal) > other_side)
              return true;
        }
    return false;
  }

  const Triangle_mesh& m_mesh;
  const Rounded_surface m_surface;
  const double m_radius, m_cell;
  std::mt19937_64 m_random; // the same numbers everywhere
  std::vector<double> m_sums;
  std::vector<Vector> m_points, m_normals;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> m_cells;
};

// ---- distances ----

// The distances of points to sharp edges, cut off; none if it was told to stop.
inline std::vector<double> distances_to_edges(const Sharp_mesh& mesh, const std::vector<Vector>& points, double cut,
                                              const std::function<bool(double)>& proceed)
{
  typedef CGAL::Simple_cartesian<double> Kernel;
  typedef std::vector<Kernel::Segment_3> Segments;
  typedef CGAL::AABB_segment_primitive<Kernel, Segments::const_iterator> Primitive;
#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_traits_3<Kernel, Primitive> Traits;
#else
  typedef CGAL::AABB_traits<Kernel, Primitive> Traits;
#endif

  std::vector<double> distances(points.size(), cut);
  if (mesh.curves.polylines.empty())
    return distances;
  const auto point = [](const Vector& p) { return Kernel::Point_3(p.x(), p.y(), p.z()); };
  Segments segments;
  for (const std::vector<std::uint32_t>& polyline : mesh.curves.polylines)
  {
    std::vector<Vector> places;
    for (std::uint32_t v : polyline)
      places.push_back(mesh.mesh.points[v]);
    places = round_polyline(places);
    for (std::size_t i = 1; i < places.size(); ++i)
      segments.emplace_back(point(places[i - 1]), point(places[i]));
  }
  CGAL::AABB_tree<Traits> tree(segments.begin(), segments.end());
  tree.accelerate_distance_queries();
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      distances[i] = (std::min)(cut, std::sqrt(tree.squared_distance(point(points[i]))));
  };
  if (!for_each_piece_or_cancel(points.size(), measure, proceed))
    distances.clear();
  return distances;
}

// ---- all of it ----

CGAL_WIREFRAME_EXTRACTION_INLINE std::string make_sharp_mesh(const Polygon_soup& soup,
                                                             const Sharp_mesh_options& options, Sharp_mesh& result)
{
  static constexpr double resolved = 0.5; // sampling distances: what is smaller is lost between the points
  static constexpr double most_samples = 5e7;
  const std::string error = check_soup(soup);
  if (!error.empty())
    return error;
  result.mesh = make_triangle_mesh(soup);
  if (result.mesh.triangles.empty())
    return "no face has an area; repair the mesh, or write it again";
  const double area = result.mesh.area, r = options.sampling_distance;
  if (r > 0. && mesh_sample_density * area / (r * r) > most_samples)
    return "a sampling distance of " + CGAL::IO::internal::number_to_string(r)
      + " takes more than 50 million points on "
        "an area of "
      + CGAL::IO::internal::number_to_string(area) + "; give a larger one, in the unit of the mesh";
  Sharp_edge_options sharp_options;
  sharp_options.minimum_fold = options.minimum_fold;
  sharp_options.maximum_facet_fold = options.maximum_facet_fold;
  sharp_options.use_boundaries = options.use_boundaries;
  sharp_options.resolution =
    resolved * (r > 0. ? r : sampling_distance_for(area, static_cast<double>(options.maximum_number_of_points)));
  result.sharp = find_sharp_edges(result.mesh, sharp_options);
  result.curves = find_sharp_curves(result.mesh, result.sharp.edges, result.sharp.largest_turn);
  result.kind = is_scan(result) ? Mesh_kind::SCAN : Mesh_kind::CAD;
  return std::string();
}

CGAL_WIREFRAME_EXTRACTION_INLINE Mesh_samples sample_mesh(const Sharp_mesh& mesh, const Sharp_mesh_options& options,
                                                          const std::function<bool(double)>& proceed)
{
  static constexpr double radius = 0.9;     // sampling distances: the mean distance to the nearest point is one then
  static constexpr double darts = 10.;      // for a point: with more of them, gaps hardly become fewer
  static constexpr double truncation = 50.; // sampling distances, as distances of regressors have it
  static constexpr double share_of_darts = 0.9; // of the work
  const auto part = [&proceed](double begin, double end) {
    return [&proceed, begin, end](double share) { return !proceed || proceed(begin + share * (end - begin)); };
  };
  Mesh_samples samples;
  const double r = options.sampling_distance > 0. ? options.sampling_distance : choose_sampling_distance(mesh, options);
  const double number = std::ceil(darts * mesh_sample_density * mesh.mesh.area / (r * r));
  samples.sampling_distance = r;
  samples.points = Mesh_dart_thrower(mesh.mesh, mesh.sharp, radius * r, options.random_seed)
                     .throw_darts(static_cast<std::size_t>(number) + 1, part(0., share_of_darts));
  samples.distances = distances_to_edges(mesh, samples.points, truncation * r, part(share_of_darts, 1.));
  if (samples.distances.empty())
    samples.points.clear();
  return samples;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_SHARP_MESH_IMPL_H
