// From a cloud in a file to a wireframe in a file.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/extract_wireframe.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::pair<Kernel::Point_3, Kernel::FT> Point_with_distance;

namespace parameters = CGAL::Wireframe_extraction::parameters;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : "data/box_with_hole.ply";

  std::vector<Point_with_distance> cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(filename, cloud, parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }

  // All thresholds have defaults in multiples of the sampling distance, which is estimated from the cloud.
  // The report is optional; it tells why a wireframe is empty.
  CGAL::Wireframe_extraction_report report;
  const CGAL::Wireframe<Kernel> wireframe =
    CGAL::extract_wireframe(cloud, parameters::extraction_report(std::ref(report)));
  if (wireframe.is_empty())
  {
    std::cerr << report.message << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << cloud.size() << " points, " << wireframe.vertices.size() << " vertices, " << wireframe.curves.size()
            << " curves" << std::endl;

  // The extension decides on the format.
  for (const std::string output : {"wireframe.json", "wireframe.obj"})
  {
    if (!CGAL::IO::write_wireframe(output, wireframe, parameters::error_message(&error)))
    {
      std::cerr << error << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << "written: " << output << std::endl;
  }
  return EXIT_SUCCESS;
}
