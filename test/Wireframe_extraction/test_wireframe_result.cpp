// What a wireframe can be asked.

#include <CGAL/Wireframe_extraction/Wireframe_graph.h>

#include "theta_wireframe.h"

#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <boost/graph/connected_components.hpp>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_curve_type Type;

bool is_near(double a, double b) { return std::abs(a - b) < 1e-9; }

void test_curves()
{
  const Wireframe wireframe = theta_wireframe();
  const Wireframe::Curve& arc = wireframe.curves[2];
  assert(arc.type == Type::ARC && is_near(arc.radius(), arc.conic->major_radius));
  assert(is_near(arc.length(), 0.5 * CGAL_PI * arc.radius()));
  const Wireframe::Curve& circle = wireframe.curves[4];
  assert(circle.type == Type::CIRCLE && circle.radius() == 1. && is_near(circle.length(), 2. * CGAL_PI));
  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    assert(bool(curve.conic) == CGAL::is_conic(curve.type));
    const auto range = curve.spline.parameter_range();
    const double middle = 0.5 * (range.first + range.second);
    assert(curve.point(middle) == curve.spline.point(middle));
    if (curve.source != Wireframe::Curve::no_vertex)
      assert(curve.point(range.first) == wireframe.vertices[curve.source]);
  }
}

void test_names()
{
  const std::vector<std::string> names = {"bspline", "line", "circle", "arc", "ellipse", "elliptic_arc"};
  for (std::size_t i = 0; i < names.size(); ++i)
    assert(to_string(static_cast<Type>(i)) == names[i]);
}

void test_incident_curves()
{
  const Wireframe wireframe = theta_wireframe();
  std::size_t ends = 0;
  for (std::size_t v = 0; v < wireframe.vertices.size(); ++v)
    for (const std::size_t c : wireframe.incident_curves(v))
    {
      const Wireframe::Curve& curve = wireframe.curves[c];
      assert(curve.source == v || curve.target == v);
      ends += (curve.source == v) + (curve.target == v);
    }
  // three curves between two vertices, a closed one with a vertex, and a circle without
  assert(ends == 8);
  assert((wireframe.incident_curves(0) == std::vector<std::size_t>{0, 1, 2, 3}));
  assert((wireframe.incident_curves(1) == std::vector<std::size_t>{0, 1, 2}));
  assert(wireframe.incident_curves(wireframe.vertices.size()).empty());
}

// `change` spoils the wireframe, and the reason has the word
template <class Change>
void test_invalid(const std::string& word, const Change& change)
{
  Wireframe wireframe = theta_wireframe();
  std::string why = "before";
  assert(wireframe.is_valid(&why) && why.empty());
  change(wireframe);
  assert(!wireframe.is_valid() && !wireframe.is_valid(&why));
  assert(why.find(word) != std::string::npos);
}

void test_validity()
{
  assert(Wireframe().is_valid());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  test_invalid("sampling distance", [&](Wireframe& w) { w.sampling_distance = nan; });
  test_invalid("vertex 1", [&](Wireframe& w) { w.vertices[1] = Point(0, nan, 0); });
  test_invalid("curve 0: It does not start at its source", [](Wireframe& w) { w.vertices[0] = Point(9, 9, 9); });
  test_invalid("curve 1: Its vertex 77 does not exist", [](Wireframe& w) { w.curves[1].target = 77; });
  test_invalid("curve 3: A residual", [](Wireframe& w) { w.curves[3].max = -1.; });
  test_invalid("does not have a conic", [](Wireframe& w) { w.curves[4].conic.reset(); });
  test_invalid("but has a conic", [](Wireframe& w) { w.curves[4].type = Type::BSPLINE; });
}

// parallel edges and loops are kept, and what has no vertex is no edge
void test_graph()
{
  typedef CGAL::Wireframe_graph<Kernel> Graph;
  Wireframe wireframe = theta_wireframe();
  wireframe.vertices.push_back(Point(9, 9, 9));
  const Graph graph = wireframe_graph(wireframe);
  assert(num_vertices(graph) == 3 && num_edges(graph) == 4);
  for (std::size_t v = 0; v < 3; ++v)
    assert(get(CGAL::vertex_point, graph, v) == wireframe.vertices[v] && graph[v].is_corner == (v < 2));
  assert(degree(0, graph) == 5 && degree(1, graph) == 3 && degree(2, graph) == 0);
  std::size_t number = 0;
  for (auto range = edges(graph); range.first != range.second; ++range.first, ++number)
  {
    const Wireframe::Curve& curve = wireframe.curves[graph[*range.first].curve_id];
    assert(graph[*range.first].curve_id == number);
    assert(source(*range.first, graph) == curve.source && target(*range.first, graph) == curve.target);
  }
  std::vector<std::size_t> component(num_vertices(graph));
  assert(boost::connected_components(graph, component.data()) == 2);
  assert(num_vertices(wireframe_graph(Wireframe())) == 0);
}

int main()
{
  test_graph();
  test_curves();
  test_names();
  test_incident_curves();
  test_validity();
  return 0;
}
