// A visitor sees what every stage has found; a callback shows the progress and can end the work early.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/extract_wireframe.h>

#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::vector<std::pair<Kernel::Point_3, double>> Cloud;
typedef CGAL::Wireframe_extraction_report Report;

namespace parameters = CGAL::Wireframe_extraction::parameters;

// Only the functions of interest are there; the others are those of the base, which do nothing.
struct Talking_visitor : CGAL::Wireframe_extraction::Default_visitor
{
  template <class Skeleton>
  void skeleton_selected(const Skeleton& skeleton)
  {
    std::cout << "  skeleton of " << skeleton.size() << " points" << std::endl;
  }

  template <class Skeleton, class Corners>
  void corners_detected(const Skeleton&, const Corners& corners)
  {
    std::cout << "  " << corners.size() << " corners" << std::endl;
  }

  template <class Graph>
  void graph_built(const Graph& graph)
  {
    std::cout << "  graph with " << num_edges(graph) << " edges" << std::endl;
    has_graph = true;
  }

  bool has_graph = false;
};

// Runs until the work is done, or `stop_at` of it.
Report::Status extract(const Cloud& cloud, double stop_at)
{
  Talking_visitor visitor; // passed by reference, so that its members can be asked afterwards
  Report report;
  const std::function<bool(double)> go_on = [stop_at](double fraction) { return fraction < stop_at; };
  const CGAL::Wireframe<Kernel> wireframe = CGAL::extract_wireframe(
    cloud, parameters::visitor(std::ref(visitor)).extraction_report(std::ref(report)).callback(go_on));
  std::cout << "  " << wireframe.curves.size() << " curves; the graph was "
            << (visitor.has_graph ? "reached" : "not reached: ") << report.message << std::endl;
  return report.status;
}

int main(int argc, char** argv)
{
  Cloud cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(argc > 1 ? argv[1] : "data/box_with_hole.ply", cloud,
                                     parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }

  std::cout << "All of it:" << std::endl;
  const bool is_done = extract(cloud, 2.) == Report::Status::SUCCESS;
  std::cout << "Cancelled after a tenth:" << std::endl;
  const bool is_cancelled = extract(cloud, 0.1) == Report::Status::CANCELLED;
  return is_done && is_cancelled ? EXIT_SUCCESS : EXIT_FAILURE;
}
