// The curves are parametric: their curvature is there at any parameter, not only where there are points.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/extract_wireframe.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Wireframe<Kernel> Wireframe;

namespace parameters = CGAL::Wireframe_extraction::parameters;

// Curvatures at places that are evenly spaced along the curve, sorted.
std::vector<double> curvatures(const Wireframe::Curve::Spline& spline, std::size_t count)
{
  const double length = spline.length();
  std::vector<double> result;
  for (std::size_t i = 0; i < count; ++i)
  {
    // the middles of pieces of equal length; the parameter itself is not an arc length
    const double u = spline.parameter_at_length(length * (double(i) + 0.5) / double(count));
    result.push_back(spline.curvature(u));
  }
  std::sort(result.begin(), result.end());
  return result;
}

int main(int argc, char** argv)
{
  std::vector<std::pair<Kernel::Point_3, double>> cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(argc > 1 ? argv[1] : "data/crossing_cylinders.ply", cloud,
                                     parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }
  const Wireframe wireframe = CGAL::extract_wireframe(cloud);

  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
  {
    const Wireframe::Curve::Spline& spline = wireframe.curves[i].spline;
    const std::vector<double> values = curvatures(spline, 100);
    // On a circle of radius R all of them are 1 / R, on a straight line 0.
    std::cout << "curve " << i << (spline.is_closed() ? " (closed)" : " (open)") << ": length " << spline.length()
              << ", curvature " << values[10] << " (10 %), " << values[50] << " (median), " << values[90] << " (90 %)"
              << std::endl;
  }
  return wireframe.is_empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
