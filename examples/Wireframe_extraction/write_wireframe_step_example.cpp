// A wireframe for a CAD program: a slot of two lines and two half circles, in a STEP file.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_step.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Wireframe<Kernel> Wireframe;

namespace parameters = CGAL::Wireframe_extraction::parameters;

void add_line(Wireframe& wireframe, std::size_t source, std::size_t target)
{
  Wireframe::Curve curve;
  curve.type = CGAL::Wireframe_curve_type::LINE;
  curve.spline = Wireframe::Curve::Spline(1, {0, 0, 1, 1}, {wireframe.vertices[source], wireframe.vertices[target]});
  curve.source = source;
  curve.target = target;
  wireframe.curves.push_back(curve);
}

void add_half_circle(Wireframe& wireframe, const Point_3& center, std::size_t source, std::size_t target)
{
  Wireframe::Curve curve;
  curve.type = CGAL::Wireframe_curve_type::ARC;
  CGAL::Wireframe_conic<Kernel> conic;
  conic.center = center;
  conic.axis = Vector_3(0, 0, 1);
  conic.major_direction = (wireframe.vertices[source] - center) / 0.25;
  conic.major_radius = conic.minor_radius = 0.25;
  conic.end_angle = CGAL_PI;
  curve.conic = conic;
  curve.spline = conic.to_spline();
  curve.source = source;
  curve.target = target;
  wireframe.curves.push_back(curve);
}

int main()
{
  Wireframe wireframe;
  wireframe.vertices = {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(1, 0.5, 0), Point_3(0, 0.5, 0)};
  add_line(wireframe, 0, 1);
  add_half_circle(wireframe, Point_3(1, 0.25, 0), 1, 2);
  add_line(wireframe, 2, 3);
  add_half_circle(wireframe, Point_3(0, 0.25, 0), 3, 0);

  // The coordinates are in inches; the file says so.
  std::string error;
  if (!CGAL::IO::write_wireframe_step("slot.step", wireframe,
                                      parameters::unit(CGAL::Wireframe_extraction::Length_unit::INCH)
                                        .step_schema(CGAL::Wireframe_extraction::Step_schema::AP242)
                                        .error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << "written: slot.step" << std::endl;
  return EXIT_SUCCESS;
}
