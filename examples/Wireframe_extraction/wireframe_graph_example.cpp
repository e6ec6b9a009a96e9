// A wireframe is a graph of the Boost Graph Library, and so is the topological graph that it comes from: all of the
// algorithms of that library run on them.

#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/extract_wireframe.h>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_graph<Kernel> Graph;
typedef boost::graph_traits<Graph>::vertex_descriptor Vertex;
typedef boost::graph_traits<Graph>::edge_descriptor Edge;

namespace parameters = CGAL::Wireframe_extraction::parameters;

// Keeps the graph, which extract_wireframe() makes on its way.
struct Graph_keeper : CGAL::Wireframe_extraction::Default_visitor
{
  void graph_built(const Graph& g) { graph = g; }

  Graph graph;
};

// The lengths of the shortest ways along the wireframe from one vertex to all others.
std::vector<double> ways_from(Vertex start, const Graph& graph)
{
  const auto points = get(CGAL::vertex_point, graph);
  const auto length = boost::make_function_property_map<Edge, double>([&](const Edge& e) {
    return std::sqrt(CGAL::squared_distance(points[source(e, graph)], points[target(e, graph)]));
  });
  std::vector<double> ways(num_vertices(graph));
  boost::dijkstra_shortest_paths(graph, start, boost::weight_map(length).distance_map(ways.data()));
  return ways;
}

int main(int argc, char** argv)
{
  std::vector<std::pair<Kernel::Point_3, double>> cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(argc > 1 ? argv[1] : "data/box_with_hole.ply", cloud,
                                     parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }
  Graph_keeper keeper;
  const Wireframe wireframe = CGAL::extract_wireframe(cloud, parameters::visitor(std::ref(keeper)));
  const Graph& graph = keeper.graph;
  if (num_vertices(graph) == 0)
    return EXIT_FAILURE;

  // Pieces that hang together, and, with the formula of Euler, independent cycles.
  std::vector<std::size_t> component(num_vertices(graph));
  const std::size_t pieces = boost::connected_components(graph, component.data());
  std::cout << num_vertices(graph) << " vertices and " << num_edges(graph) << " edges in " << pieces << " pieces, with "
            << num_edges(graph) + pieces - num_vertices(graph) << " cycles" << std::endl;

  // In the graph of the wireframe, each curve that has a vertex is an edge.
  const Graph curves = wireframe_graph(wireframe);
  for (const Edge& edge : CGAL::make_range(edges(curves)))
  {
    const Wireframe::Curve& curve = wireframe.curves[curves[edge].curve_id];
    std::cout << to_string(curve.type) << " of length " << curve.length() << " from a vertex of degree "
              << degree(source(edge, curves), curves) << " to one of degree " << degree(target(edge, curves), curves)
              << std::endl;
  }

  // For each corner, how far it is along the curves to the vertex farthest from it.
  for (const Vertex start : CGAL::make_range(vertices(graph)))
  {
    if (!graph[start].is_corner)
      continue;
    double farthest = 0;
    for (const double way : ways_from(start, graph))
      if (way < (std::numeric_limits<double>::max)())
        farthest = (std::max)(farthest, way);
    std::cout << "corner at " << get(CGAL::vertex_point, graph, start) << ": the longest way from it is " << farthest
              << std::endl;
  }
  return EXIT_SUCCESS;
}
