#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Wireframe<Kernel> Wireframe;

// A quarter of the unit circle, exact as a rational curve of degree two.
Wireframe quarter_circle()
{
  Wireframe wireframe;
  wireframe.vertices = {Point_3(1, 0, 0), Point_3(0, 1, 0)};
  Wireframe::Curve curve;
  curve.type = CGAL::Wireframe_curve_type::ARC;
  const std::vector<double> knots = {0, 0, 0, 1, 1, 1};
  const std::vector<Point_3> control_points = {Point_3(1, 0, 0), Point_3(1, 1, 0), Point_3(0, 1, 0)};
  const std::vector<double> weights = {1, std::sqrt(0.5), 1};
  curve.spline = CGAL::Spline_curve_3<Kernel>(2, knots, control_points, weights);
  curve.source = 0;
  curve.target = 1;
  wireframe.curves.push_back(curve);
  return wireframe;
}

int main()
{
  const Wireframe wireframe = quarter_circle();
  const Point_3 middle = wireframe.curves.front().spline.point(0.5);
  const Point_3 expected(std::sqrt(0.5), std::sqrt(0.5), 0);
  if (!(CGAL::squared_distance(middle, expected) < 1e-24))
  {
    std::cerr << "the middle of the quarter circle is at " << middle << "\n";
    return EXIT_FAILURE;
  }
  // Our named parameters chain with CGAL's.
  namespace parameters = CGAL::Wireframe_extraction::parameters;
  const auto chain = parameters::sampling_distance(0.02).verbose(true);
  static_cast<void>(chain);
  return EXIT_SUCCESS;
}
