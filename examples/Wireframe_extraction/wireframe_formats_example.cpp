// A wireframe need not come from a cloud. This one, of a cylinder, is made by hand and written in several formats:
// those that know circles and lines get circles and lines, the others polylines.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Wireframe<Kernel> Wireframe;

namespace parameters = CGAL::Wireframe_extraction::parameters;

// A circle about the z axis, which starts and ends at a vertex.
Wireframe::Curve circle(const Wireframe& wireframe, std::size_t vertex, double radius)
{
  Wireframe::Curve curve;
  curve.type = CGAL::Wireframe_curve_type::CIRCLE;
  CGAL::Wireframe_conic<Kernel> conic;
  conic.center = Point(0, 0, wireframe.vertices[vertex].z());
  conic.axis = Vector(0, 0, 1);
  conic.major_direction = Vector(1, 0, 0);
  conic.major_radius = conic.minor_radius = radius;
  conic.end_angle = 2. * CGAL_PI;
  curve.conic = conic;
  curve.spline = conic.to_spline(true); // whatever its type, a curve has its B-spline form, too
  curve.source = curve.target = vertex;
  return curve;
}

Wireframe::Curve line(const Wireframe& wireframe, std::size_t source, std::size_t target)
{
  Wireframe::Curve curve;
  curve.type = CGAL::Wireframe_curve_type::LINE;
  curve.spline = Wireframe::Curve::Spline(1, {0, 0, 1, 1}, {wireframe.vertices[source], wireframe.vertices[target]});
  curve.source = source;
  curve.target = target;
  return curve;
}

int main()
{
  Wireframe wireframe;
  wireframe.vertices = {Point(3, 0, 0), Point(3, 0, 10)};
  wireframe.curves = {circle(wireframe, 0, 3), circle(wireframe, 1, 3), line(wireframe, 0, 1)};

  // Coordinates are not converted, but the formats that have a word for the unit say that these are inches.
  const auto unit = CGAL::Wireframe_extraction::Length_unit::INCH;
  for (const char* const extension : {".json", ".dxf", ".obj", ".vtp", ".glb", ".svg", ".csv"})
  {
    const std::string name = std::string("cylinder") + extension;
    std::string error;
    if (!CGAL::IO::write_wireframe(name, wireframe, parameters::unit(unit).sampling_step(0.1).error_message(&error)))
    {
      std::cerr << error << std::endl;
      return EXIT_FAILURE;
    }
    std::cout << name << std::endl;
  }

  // OBJ has free-form curves, too, which fewer programs read.
  return CGAL::IO::write_wireframe("cylinder_splines.obj", wireframe, parameters::obj_splines(true)) ? EXIT_SUCCESS
                                                                                                     : EXIT_FAILURE;
}
