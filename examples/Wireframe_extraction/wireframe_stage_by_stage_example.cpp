// What extract_wireframe() does, one stage after the other. Any stage that returns its result can be replaced by a
// function of yours that returns the same type; contract_skeleton() and refine_field() change the skeleton instead.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/Wireframe_extraction/find_doubts.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/recognize_curve_types.h>
#include <CGAL/Wireframe_extraction/refine_field.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>

#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;

namespace stages = CGAL::Wireframe_extraction;
namespace parameters = CGAL::Wireframe_extraction::parameters;

int main(int argc, char** argv)
{
  const std::string filename = argc > 1 ? argv[1] : "data/slotted_plate.ply";
  std::vector<std::pair<Kernel::Point_3, double>> cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(filename, cloud, parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }

  // 1. The length in multiples of which all thresholds are given.
  const double r = stages::estimate_sampling_distance(cloud);
  std::cout << "sampling distance: " << r << std::endl;

  // 2. The points near the sharp curves, moved onto lines that are fitted to the field around them.
  auto skeleton = stages::select_skeleton(cloud, parameters::sampling_distance(r));
  stages::contract_skeleton(skeleton);
  stages::refine_field(skeleton);
  std::cout << "skeleton: " << skeleton.size() << " of " << cloud.size() << " points, noise of the field "
            << skeleton.noise() << std::endl;

  // 3. Where no line fits there is a corner.
  const auto corners = stages::detect_corners(skeleton);
  std::cout << "corners: " << corners.size() << std::endl;

  // 4. Without the corners, the skeleton falls into curves.
  const auto clusters = stages::segment_curves(skeleton, corners);
  std::cout << "clusters: " << clusters.size() << std::endl;

  // 5. Polylines through the clusters, joined at the corners: a graph for the Boost Graph Library.
  const auto graph = stages::build_topological_graph(skeleton, corners, clusters);
  std::cout << "graph: " << num_vertices(graph) << " vertices, " << num_edges(graph) << " edges" << std::endl;

  // 6. One spline for each path of the graph between two corners, all fitted to the field together.
  const auto wireframe = stages::fit_curves(skeleton, graph);
  std::cout << "splines: " << wireframe.vertices.size() << " vertices, " << wireframe.curves.size() << " curves"
            << std::endl;

  // 7. Lines, circles and ellipses in place of the splines that are none; some splines are cut.
  auto typed = stages::recognize_curve_types(skeleton, wireframe);
  std::cout << "types: " << typed.vertices.size() << " vertices, " << typed.curves.size() << " curves" << std::endl;

  // 8. What speaks against each curve.
  stages::find_doubts(skeleton, typed);
  for (std::size_t i = 0; i < typed.curves.size(); ++i)
    for (const CGAL::Wireframe_doubt doubt : typed.curves[i].doubts)
      std::cout << "curve " << i << " is doubtful: " << to_string(doubt) << std::endl;
  return wireframe.is_empty() ? EXIT_FAILURE : EXIT_SUCCESS;
}
