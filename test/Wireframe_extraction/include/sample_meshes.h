// Meshes of closed form: polygons by the indices of their vertices.

#ifndef SAMPLE_MESHES_H
#define SAMPLE_MESHES_H

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

struct Sample_mesh
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point;
  typedef std::vector<std::size_t> Polygon;

  std::vector<Point> points;
  std::vector<Polygon> polygons;

  // with triangles instead of other polygons, which have to be convex
  Sample_mesh triangulated() const
  {
    Sample_mesh result;
    result.points = points;
    for (const Polygon& polygon : polygons)
      for (std::size_t i = 2; i < polygon.size(); ++i)
        result.polygons.push_back({polygon[0], polygon[i - 1], polygon[i]});
    return result;
  }

  // each face with vertices of its own, as in STL
  Sample_mesh exploded() const
  {
    Sample_mesh result;
    for (const Polygon& polygon : polygons)
    {
      result.polygons.emplace_back();
      for (std::size_t v : polygon)
      {
        result.polygons.back().push_back(result.points.size());
        result.points.push_back(points[v]);
      }
    }
    return result;
  }

  void add(const Sample_mesh& other)
  {
    const std::size_t first = points.size();
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (Polygon polygon : other.polygons)
    {
      for (std::size_t& v : polygon)
        v += first;
      polygons.push_back(polygon);
    }
  }
};

typedef std::vector<std::pair<double, double>> Outline;

// the outline between two heights
inline Sample_mesh prism_mesh(const Outline& outline, double low, double high)
{
  Sample_mesh mesh;
  const std::size_t n = outline.size();
  Sample_mesh::Polygon bottom, top;
  for (const double z : {low, high})
    for (const auto& p : outline)
      mesh.points.emplace_back(p.first, p.second, z);
  for (std::size_t i = 0; i < n; ++i)
  {
    mesh.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
    bottom.push_back(n - 1 - i);
    top.push_back(n + i);
  }
  mesh.polygons.push_back(bottom);
  mesh.polygons.push_back(top);
  return mesh;
}

inline Outline circle_outline(std::size_t n, double radius = 1.)
{
  Outline outline;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double angle = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

inline Outline rectangle_outline(double x, double y) { return {{0., 0.}, {x, 0.}, {x, y}, {0., y}}; }

// a rectangle of 2 x 1.4, whose corners are rounded by so many chords
inline Outline rounded_outline(std::size_t chords, double radius = 0.3)
{
  Outline outline;
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    const double x = (corner == 0 || corner == 3 ? 1. : -1.) * (1. - radius),
                 y = (corner < 2 ? 1. : -1.) * (0.7 - radius);
    for (std::size_t i = 0; i <= chords; ++i)
    {
      const double angle =
        0.5 * CGAL_PI * (static_cast<double>(corner) + static_cast<double>(i) / static_cast<double>(chords));
      outline.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
    }
  }
  return outline;
}

inline Outline gear_outline(std::size_t teeth)
{
  Outline outline;
  for (std::size_t i = 0; i < teeth; ++i)
    for (const auto& corner : Outline{{-0.25, 0.8}, {-0.15, 1.}, {0.15, 1.}, {0.25, 0.8}})
    {
      const double angle = 2. * CGAL_PI * (static_cast<double>(i) + corner.first) / static_cast<double>(teeth);
      outline.emplace_back(corner.second * std::cos(angle), corner.second * std::sin(angle));
    }
  return outline;
}

inline Sample_mesh cone_mesh(std::size_t n, double height)
{
  Sample_mesh mesh;
  Sample_mesh::Polygon bottom;
  for (const auto& p : circle_outline(n))
    mesh.points.emplace_back(p.first, p.second, 0.);
  mesh.points.emplace_back(0., 0., height);
  for (std::size_t i = 0; i < n; ++i)
  {
    mesh.polygons.push_back({i, (i + 1) % n, n});
    bottom.push_back(n - 1 - i);
  }
  mesh.polygons.push_back(bottom);
  return mesh;
}

// a torus, or, if `major_radius` is 0, a sphere, whose poles are circles of length zero
inline Sample_mesh torus_mesh(std::size_t around, std::size_t across, double major_radius, double minor_radius)
{
  Sample_mesh mesh;
  const bool is_sphere = major_radius == 0.;
  const std::size_t rows = is_sphere ? across + 1 : across;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < rows; ++j)
    {
      const double u = 2. * CGAL_PI * static_cast<double>(i) / static_cast<double>(around);
      const double v = (is_sphere ? CGAL_PI * (static_cast<double>(j) / static_cast<double>(across) - 0.5)
                                  : 2. * CGAL_PI * static_cast<double>(j) / static_cast<double>(across));
      const bool is_pole = is_sphere && (j == 0 || j == across);
      const double radius = is_pole ? 0. : major_radius + minor_radius * std::cos(v);
      mesh.points.emplace_back(radius * std::cos(u), radius * std::sin(u), minor_radius * std::sin(v));
    }
  const auto index = [&](std::size_t i, std::size_t j) { return (i % around) * rows + j % rows; };
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j)
      for (const Sample_mesh::Polygon& triangle :
           {Sample_mesh::Polygon{index(i, j), index(i + 1, j), index(i + 1, j + 1)},
            Sample_mesh::Polygon{index(i, j), index(i + 1, j + 1), index(i, j + 1)}})
        mesh.polygons.push_back(triangle);
  return mesh;
}

// The sides of the unit cube as grids of n x n squares; vertices are moved by a share of the side of a square, as
// those of a scan are.
inline Sample_mesh grid_box_mesh(std::size_t n, double noise)
{
  Sample_mesh mesh;
  std::mt19937 random(5);
  const double step = 1. / static_cast<double>(n);
  std::vector<std::size_t> indices((n + 1) * (n + 1) * (n + 1), static_cast<std::size_t>(-1));
  const auto uniform = [&random, noise, step] {
    return noise * step * std::sqrt(3.) * (2. * static_cast<double>(random()) / 4294967295. - 1.);
  };
  const auto vertex = [&](std::size_t axis, std::size_t side, std::size_t i, std::size_t j) {
    std::size_t place[3];
    place[axis] = side * n;
    place[(axis + 1) % 3] = i;
    place[(axis + 2) % 3] = j;
    std::size_t& index = indices[(place[0] * (n + 1) + place[1]) * (n + 1) + place[2]];
    if (index == static_cast<std::size_t>(-1))
    {
      index = mesh.points.size();
      const double x = uniform(), y = uniform(), z = uniform();
      mesh.points.emplace_back(static_cast<double>(place[0]) * step + x, static_cast<double>(place[1]) * step + y,
                               static_cast<double>(place[2]) * step + z);
    }
    return index;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (std::size_t side = 0; side < 2; ++side)
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          mesh.polygons.push_back({vertex(axis, side, i, j), vertex(axis, side, i + 1, j),
                                   vertex(axis, side, i + 1, j + 1), vertex(axis, side, i, j + 1)});
  return mesh;
}

#endif // SAMPLE_MESHES_H
