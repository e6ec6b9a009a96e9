// What the README's program does not do: a wireframe of points without distances, and one of a mesh.

#ifndef WRITE_OTHER_WIREFRAMES_H
#define WRITE_OTHER_WIREFRAMES_H

#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_mesh.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/sample_sharp_mesh.h>
#include <CGAL/extract_wireframe.h>

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// From the given cloud to a file that is compared; returns whether there are curves in it.
template <class Cloud>
bool write_wireframe_of(const Cloud& cloud, const std::string& filename)
{
  const auto wireframe = CGAL::extract_wireframe(cloud);
  return !wireframe.is_empty() && CGAL::IO::write_wireframe(filename, wireframe);
}

inline bool write_wireframe_of_scan()
{
  std::vector<CGAL::Simple_cartesian<double>::Point_3> points;
  return CGAL::IO::read_points("scan.ply", std::back_inserter(points)) && write_wireframe_of(points, "scan.json");
}

inline bool write_wireframe_of_mesh()
{
  typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  std::vector<std::pair<Point_3, double>> cloud;
  return CGAL::IO::read_mesh("part.stl", points, polygons)
    && CGAL::Wireframe_extraction::sample_sharp_mesh(points, polygons, cloud) && write_wireframe_of(cloud, "part.json");
}

#endif // WRITE_OTHER_WIREFRAMES_H
