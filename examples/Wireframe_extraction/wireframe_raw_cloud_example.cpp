// From a scan, that is, points and nothing else, to a wireframe in a file.

#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/estimate_distance_field.h>
#include <CGAL/extract_wireframe.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;

namespace wireframe_extraction = CGAL::Wireframe_extraction;
namespace parameters = CGAL::Wireframe_extraction::parameters;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : "data/l_bracket_scan.ply";

  std::vector<Point> points;
  if (!CGAL::IO::read_points(filename, std::back_inserter(points)))
  {
    std::cerr << filename << ": cannot be read" << std::endl;
    return EXIT_FAILURE;
  }

  // Where there are no distances to sharp features, they are estimated from the points.
  CGAL::Wireframe_extraction_report report;
  const CGAL::Wireframe<Kernel> wireframe =
    CGAL::extract_wireframe(points, parameters::extraction_report(std::ref(report)));
  if (wireframe.is_empty())
  {
    std::cerr << report.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << points.size() << " points with a noise of " << report.point_noise / report.sampling_distance
            << " sampling distances, " << report.number_of_near_points << " of them near features\n"
            << wireframe.vertices.size() << " vertices, " << wireframe.curves.size() << " curves" << std::endl;
  if (!CGAL::IO::write_wireframe("l_bracket.json", wireframe))
    return EXIT_FAILURE;

  // The estimate is a stage of its own. What is sharp is up to the caller: here, folds of 60 degrees or more.
  const wireframe_extraction::Distance_field field =
    wireframe_extraction::estimate_distance_field(points, parameters::minimum_fold(60.));
  std::cout << field.number_of_near_points << " points are near folds of 60 degrees or more" << std::endl;
  return field.is_empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
