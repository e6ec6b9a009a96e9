// Curves that touch each other: a line and an arc that cannot be told apart near the point of contact.

#include <CGAL/Wireframe_extraction/internal/network/Tangency_resolver.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using CGAL::Wireframe_extraction::internal::Curve_network;
using CGAL::Wireframe_extraction::internal::Joining_options;
using CGAL::Wireframe_extraction::internal::Network_curve;
using CGAL::Wireframe_extraction::internal::Tangency_resolver;
using CGAL::Wireframe_extraction::internal::Vector;

const double reach = 20.;

Vector on_line(double x) { return Vector(x, 0., 0.); }
Vector on_arc(double radius, double x) { return Vector(x, radius - std::sqrt(radius * radius - x * x), 0.); }

std::size_t add_node(Curve_network& network, const Vector& p)
{
  network.nodes.push_back(p);
  return network.nodes.size() - 1;
}

template <class Position>
void add_curve(Curve_network& network, const Position& position, double from, double to, std::size_t source,
               std::size_t target)
{
  Network_curve curve;
  const int count = std::max(2, int(2. * std::abs(to - from)));
  for (int k = 0; k <= count; ++k)
    curve.points.push_back(position(from + (to - from) * k / count));
  curve.points.front() = network.nodes[source];
  curve.points.back() = network.nodes[target];
  curve.nodes = {source, target};
  const std::size_t n = curve.points.size();
  curve.tips[0].point = curve.points.front();
  curve.tips[0].tangent = (curve.points[0] - curve.points[1]).normalized();
  curve.tips[1].point = curve.points.back();
  curve.tips[1].tangent = (curve.points[n - 1] - curve.points[n - 2]).normalized();
  network.curves.push_back(curve);
}

// Line and arc were taken for one curve between -half and half; for half = 0, they meet in one node.
Curve_network fused(double radius, double half)
{
  const auto arc = [radius](double x) { return on_arc(radius, x); };
  Curve_network network;
  const std::size_t left = add_node(network, on_line(-half)),
                    right = half > 0. ? add_node(network, on_line(half)) : left;
  add_curve(network, on_line, -reach, -half, add_node(network, on_line(-reach)), left);
  add_curve(network, arc, -half, -reach, left, add_node(network, arc(-reach)));
  if (half > 0.)
    add_curve(network, on_line, -half, half, left, right);
  add_curve(network, arc, half, reach, right, add_node(network, arc(reach)));
  add_curve(network, on_line, reach, half, add_node(network, on_line(reach)), right);
  return network;
}

std::vector<Network_curve> living(const Curve_network& network)
{
  std::vector<Network_curve> result;
  for (const Network_curve& curve : network.curves)
    if (curve.is_alive)
      result.push_back(curve);
  return result;
}

void test_line_and_arc()
{
  const Joining_options options;
  for (double radius : {21., 25., 40.})
    for (double half : {0., 3., 6.})
    {
      Curve_network network = fused(radius, half);
      Tangency_resolver(network, options).separate_tangent_curves();
      const std::vector<Network_curve> curves = living(network);
      assert(curves.size() == 2);
      for (const Network_curve& curve : curves)
      {
        // each leads through: from a far end on the left to the far end of the same kind on the right
        const Vector &p = curve.points.front(), &q = curve.points.back();
        assert(std::abs(std::abs(p.x()) - reach) < 1e-9 && std::abs(p.x() + q.x()) < 1e-9);
        assert(std::abs(p.y() - q.y()) < 1e-9);
        for (std::size_t k = 1; k < curve.points.size(); ++k)
          assert((curve.points[k] - curve.points[k - 1]).norm() < 2.);
      }
      assert(std::abs(curves[0].points.front().y() - curves[1].points.front().y()) > 1.);
    }
}

// a fork where only one curve goes on is no contact of two curves
void test_fork_is_left_alone()
{
  const Joining_options options;
  Curve_network network;
  const std::size_t middle = add_node(network, on_line(0.));
  const auto arc = [](double x) { return on_arc(25., x); };
  add_curve(network, on_line, -reach, 0., add_node(network, on_line(-reach)), middle);
  add_curve(network, on_line, 0., reach, middle, add_node(network, on_line(reach)));
  add_curve(network, arc, 0., reach, middle, add_node(network, arc(reach)));
  Tangency_resolver(network, options).separate_tangent_curves();
  assert(living(network).size() == 3);
}

// four curves that meet at right angles meet in a corner
void test_crossing_is_left_alone()
{
  const Joining_options options;
  Curve_network network;
  const std::size_t middle = add_node(network, on_line(0.));
  const auto across = [](double y) { return Vector(0., y, 0.); };
  for (double end : {-reach, reach})
  {
    add_curve(network, on_line, 0., end, middle, add_node(network, on_line(end)));
    add_curve(network, across, 0., end, middle, add_node(network, across(end)));
  }
  Tangency_resolver(network, options).separate_tangent_curves();
  assert(living(network).size() == 4);
}

// A curve that was followed up to the line it touches, from both sides, is one curve; the line is not cut.
void test_ends_at_a_passing_curve()
{
  const Joining_options options;
  const auto arc = [](double x) { return on_arc(60., x); };
  Curve_network network;
  add_curve(network, on_line, -reach, reach, add_node(network, on_line(-reach)), add_node(network, on_line(reach)));
  add_curve(network, arc, -reach, -5., add_node(network, arc(-reach)), add_node(network, arc(-5.)));
  add_curve(network, arc, 5., reach, add_node(network, arc(5.)), add_node(network, arc(reach)));
  Tangency_resolver(network, options).bridge_tangencies();
  const std::vector<Network_curve> curves = living(network);
  assert(curves.size() == 2);
  assert(std::abs(curves[1].points.front().x() + curves[1].points.back().x()) < 1e-9);
}

} // namespace

int main()
{
  test_line_and_arc();
  test_fork_is_left_alone();
  test_crossing_is_left_alone();
  test_ends_at_a_passing_curve();
  return 0;
}
