// Lines, circles and ellipses have parameters, and standard deviations that say how far these may be off.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/extract_wireframe.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_curve_type Type;

namespace parameters = CGAL::Wireframe_extraction::parameters;

int main(int argc, char** argv)
{
  std::vector<std::pair<Kernel::Point_3, double>> cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(argc > 1 ? argv[1] : "data/slotted_plate.ply", cloud,
                                     parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }
  // With a larger significance, fewer curves are taken for lines and circles.
  const Wireframe wireframe = CGAL::extract_wireframe(cloud, parameters::type_significance(0.01));

  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    std::cout << to_string(curve.type) << " of length " << curve.length();
    if (curve.conic)
      std::cout << ", center " << curve.conic->center << ", radius " << curve.conic->major_radius << " +- "
                << curve.uncertainty.major_radius;
    else if (curve.type == Type::LINE)
      std::cout << ", direction certain to " << curve.uncertainty.direction << " rad";
    std::cout << std::endl;
  }
  return wireframe.is_empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
