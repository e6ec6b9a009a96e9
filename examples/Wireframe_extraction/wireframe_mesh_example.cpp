#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_mesh.h>
#include <CGAL/Wireframe_extraction/sample_sharp_mesh.h>
#include <CGAL/extract_wireframe.h>

#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
namespace wireframe_extraction = CGAL::Wireframe_extraction;
namespace parameters = CGAL::Wireframe_extraction::parameters;

// From a mesh, as CAD programs export it, to its wireframe: the surface is sampled, and sharp edges give the distances.
int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : "data/rounded_plate.stl";
  std::string error;
  std::vector<Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  if (!CGAL::IO::read_mesh(filename, points, polygons, parameters::error_message(&error)))
  {
    std::cerr << error << '\n';
    return EXIT_FAILURE;
  }

  wireframe_extraction::Sharp_mesh_report report;
  std::vector<std::pair<Point_3, double>> cloud;
  if (!wireframe_extraction::sample_sharp_mesh(points, polygons, cloud,
                                               parameters::mesh_report(std::ref(report)).error_message(&error)))
  {
    std::cerr << filename << ": " << error << '\n';
    return EXIT_FAILURE;
  }
  if (report.kind == wireframe_extraction::Mesh_kind::SCAN)
    std::cerr << "its triangles join points that were measured: sharp edges are no edges of it\n";
  std::cout << report.number_of_triangles << " triangles, " << report.number_of_sharp_edges << " sharp edges in "
            << report.number_of_sharp_curves << " curves; " << cloud.size() << " points\n";

  const CGAL::Wireframe<Kernel> wireframe = CGAL::extract_wireframe(cloud);
  std::cout << wireframe.curves.size() << " curves, " << wireframe.vertices.size() << " vertices\n";
  return wireframe.is_empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
