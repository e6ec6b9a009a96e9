// A cloud in a type of your own, which is read through property maps: nothing is copied or converted before.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/extract_wireframe.h>
#include <CGAL/property_map.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;

namespace parameters = CGAL::Wireframe_extraction::parameters;

// The point of some other library or program.
struct Scanned_point
{
  float position[3];
  float sharpness;
  unsigned char color[3];
};

// Says where the coordinates are. The point is made when it is asked for.
struct Position_map
{
  typedef Scanned_point key_type;
  typedef Point_3 value_type;
  typedef Point_3 reference;
  typedef boost::readable_property_map_tag category;

  friend Point_3 get(const Position_map&, const Scanned_point& p)
  {
    return Point_3(p.position[0], p.position[1], p.position[2]);
  }
};

// Says where the distance to the nearest sharp curve is, in the unit of the coordinates.
struct Distance_map
{
  typedef Scanned_point key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;

  friend double get(const Distance_map&, const Scanned_point& p) { return p.sharpness; }
};

// Your own data come from elsewhere; here they come from the bundled cloud.
std::vector<Scanned_point> scan(const std::string& filename)
{
  std::vector<std::pair<Point_3, double>> cloud;
  CGAL::IO::read_distance_cloud(filename, cloud);
  std::vector<Scanned_point> result;
  for (const auto& [p, distance] : cloud)
    result.push_back({{float(p.x()), float(p.y()), float(p.z())}, float(distance), {128, 128, 128}});
  return result;
}

int main(int argc, char** argv)
{
  const std::vector<Scanned_point> points = scan(argc > 1 ? argv[1] : "data/box_with_hole.ply");

  // Parameters of this package come first in the chain, those of CGAL itself (such as point_map) last.
  CGAL::Wireframe_extraction_report report;
  const CGAL::Wireframe<Kernel> wireframe = CGAL::extract_wireframe(
    points, parameters::distance_map(Distance_map()).extraction_report(std::ref(report)).point_map(Position_map()));
  if (wireframe.is_empty())
  {
    std::cerr << report.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << points.size() << " points, " << wireframe.curves.size() << " curves, " << wireframe.vertices.size()
            << " vertices:" << std::endl;
  for (const Point_3& vertex : wireframe.vertices)
    std::cout << "  " << vertex << std::endl;
  return EXIT_SUCCESS;
}
