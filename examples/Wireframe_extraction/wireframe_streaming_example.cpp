#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/Distance_cloud_filter.h>
#include <CGAL/Wireframe_extraction/IO/Distance_cloud_file.h>
#include <CGAL/extract_wireframe.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <utility>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
namespace parameters = CGAL::Wireframe_extraction::parameters;

// Two ways for clouds that are too large for the memory: a file that is read several times, and
// points that pass by once.
int main(int argc, char* argv[])
{
  const char* filename = argc > 1 ? argv[1] : "data/box_with_hole.ply";
  CGAL::IO::Distance_cloud_file file(filename);
  CGAL::Wireframe_extraction_report report;
  const CGAL::Wireframe<Kernel> wireframe = CGAL::extract_wireframe_from_source<Kernel>(
    file, parameters::points_in_memory(2000).extraction_report(std::ref(report)));
  if (report.status != CGAL::Wireframe_extraction_report::Status::SUCCESS)
  {
    std::cerr << report.message << '\n';
    return EXIT_FAILURE;
  }
  std::cout << report.number_of_points << " points, " << wireframe.curves.size() << " curves\n";

  // the same points as they may come from a device, in whatever order
  CGAL::Wireframe_extraction::Distance_cloud_filter<Point_3> filter(parameters::points_in_memory(2000));
  const bool is_read = file.read([&](const auto* first, const auto* beyond) {
    for (; first != beyond; ++first)
      filter.insert(Point_3(first->x, first->y, first->z), first->distance);
    return true;
  });
  if (!is_read || !filter.is_complete())
  {
    std::cerr << (is_read ? "the density varies too much: points near features were lost" : file.error_message())
              << '\n';
    return EXIT_FAILURE;
  }
  const double sampling_distance = filter.sampling_distance();
  const CGAL::Wireframe<Kernel> same =
    CGAL::extract_wireframe(filter.cloud(), parameters::sampling_distance(sampling_distance));
  std::cout << filter.cloud().size() << " of " << filter.number_of_points() << " points kept, " << same.curves.size()
            << " curves\n";
  return EXIT_SUCCESS;
}
