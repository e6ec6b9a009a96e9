#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Wireframe<Kernel> Wireframe;

// One line, in a file for CAD programs.
int main()
{
  Wireframe wireframe;
  wireframe.vertices = {Kernel::Point_3(0, 0, 0), Kernel::Point_3(1, 0, 0)};
  Wireframe::Curve curve;
  curve.type = CGAL::Wireframe_curve_type::LINE;
  curve.spline = Wireframe::Curve::Spline(1, {0, 0, 1, 1}, wireframe.vertices);
  curve.source = 0;
  curve.target = 1;
  wireframe.curves.push_back(curve);
  std::string error;
  namespace parameters = CGAL::Wireframe_extraction::parameters;
  if (!CGAL::IO::write_wireframe("line.step", wireframe, parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
