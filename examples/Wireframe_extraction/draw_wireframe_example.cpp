// A wireframe that was extracted before is drawn in a window, which takes no extraction.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_wireframe_json.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/draw_wireframe.h>

#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;

int main(int argc, char* argv[])
{
  const std::string filename = (argc > 1) ? argv[1] : "data/box_with_hole.json";
  CGAL::Wireframe<Kernel> wireframe;
  std::string error;
  if (!CGAL::IO::read_wireframe_json(filename, wireframe,
                                     CGAL::Wireframe_extraction::parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }
  // without Qt, this says that it cannot draw
  CGAL::draw(wireframe, filename.c_str());
  return EXIT_SUCCESS;
}
