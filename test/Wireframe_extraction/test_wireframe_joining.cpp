// What each step that joins, rounds, cuts and adds curves of a network promises, on networks drawn by hand.

#include "drawn_curves.h"

#include <CGAL/Wireframe_extraction/internal/network/Curve_end_joiner.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

typedef std::vector<Vector> Polyline;

const Joining_options options;
const std::function<bool(double)> uninterrupted;
const double quarter_turn = std::acos(0.);

Polyline straight(const Vector& from, const Vector& to, double spacing = 0.5)
{
  const std::size_t count =
    std::max(std::size_t(1), static_cast<std::size_t>(std::round((to - from).norm() / spacing)));
  Polyline points;
  for (std::size_t k = 0; k <= count; ++k)
    points.push_back(from + (to - from) * (double(k) / double(count)));
  return points;
}

Polyline operator+(Polyline head, const Polyline& tail)
{
  head.insert(head.end(), tail.begin() + 1, tail.end());
  return head;
}

// curves whose ends lie at the same place share a node
Curve_network network_of(const std::vector<Polyline>& polylines)
{
  Curve_network network;
  for (const Polyline& points : polylines)
  {
    const Traced_curve traced = open_curve(points);
    Network_curve curve;
    curve.points = traced.points;
    for (int e = 0; e < 2; ++e)
    {
      curve.tips[e] = traced.tips[e];
      const Vector& end = e == 0 ? points.front() : points.back();
      std::size_t node = 0;
      while (node < network.nodes.size() && network.nodes[node] != end)
        ++node;
      if (node == network.nodes.size())
        network.nodes.push_back(end);
      curve.nodes[e] = node;
    }
    network.curves.push_back(curve);
  }
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

std::vector<double> sorted_lengths(const Curve_network& network)
{
  std::vector<double> result;
  for (const Network_curve& curve : living(network))
    result.push_back(polyline_length(curve.points));
  std::sort(result.begin(), result.end());
  return result;
}

bool are_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance)
{
  return a.size() == b.size()
    && std::equal(a.begin(), a.end(), b.begin(), [&](double x, double y) { return std::abs(x - y) < tolerance; });
}

std::size_t number_of_ends_at(const Curve_network& network, const Vector& p, double tolerance)
{
  std::size_t result = 0;
  for (const Network_curve& curve : living(network))
    for (int e = 0; e < 2; ++e)
      if (curve.nodes[e] != no_node && (network.nodes[curve.nodes[e]] - p).norm() < tolerance)
        ++result;
  return result;
}

// every curve starts and ends where its nodes are
void check_ends(const Curve_network& network)
{
  for (const Network_curve& curve : living(network))
  {
    assert(curve.points.size() >= 2);
    if (curve.is_closed_without_node())
      continue;
    assert((network.nodes[curve.nodes[0]] - curve.points.front()).norm() < 1e-9);
    assert((network.nodes[curve.nodes[1]] - curve.points.back()).norm() < 1e-9);
  }
}

double largest_turn(const Polyline& points)
{
  double result = 0.;
  Vector last = Vector::Zero(); // direction
  for (std::size_t k = 1; k < points.size(); ++k)
    if ((points[k] - points[k - 1]).norm() > 1e-6)
    {
      const Vector next = (points[k] - points[k - 1]).normalized();
      if (last.norm() > 0.)
        result = std::max(result, std::acos(std::max(-1., std::min(1., last.dot(next)))));
      last = next;
    }
  return result;
}

// Ends that pass into other curves ------------------------------------------------------------------

// Curve 1 starts on curve 0, which changes its points; curve 2 ends on curve 1 all the same.
void test_split_of_a_curve_whose_end_splits_another_one()
{
  for (double start : {0.05, 0.6, 1., -1.2})
  {
    Curve_network network(std::vector<Traced_curve>{
      open_curve(straight(Vector(-30., 0., 0.), Vector(30., 0., 0.))),
      open_curve(straight(Vector(0., start, 0.), Vector(0., 30., 0.))),
      open_curve(straight(Vector(20., 15.25, 0.), Vector(0.2, 15.25, 0.))),
    });
    Corner_merger(network, options).attach_ends_to_passing_curves();
    check_ends(network);
    assert(are_near(sorted_lengths(network), {14.75, 15.25, 20., 30., 30.}, 1e-6));
    for (const Network_curve& curve : living(network))
      assert(largest_turn(curve.points) < 0.1);
  }
}

// Ends split a segment in the order of their places, whatever the order of their nodes.
void test_several_ends_on_one_segment()
{
  for (const std::vector<double>& places :
       {std::vector<double>{12., 18.}, {18., 12.}, {6., 24., 12., 18.}, {24., 6., 18., 12.}})
    for (double direction : {1., -1.})
    {
      const Vector end(15. * direction, 0., 0.);
      std::vector<Traced_curve> curves{open_curve({-end, end})};
      for (double place : places)
      {
        const Vector foot = -end + end * (place / 15.);
        curves.push_back(open_curve(straight(foot + Vector(0., 20., 0.), foot + Vector(0., 0.2, 0.))));
      }
      Curve_network network(curves);
      Corner_merger(network, options).attach_ends_to_passing_curves();
      check_ends(network);
      std::vector<double> expected(places.size(), 20.);
      for (std::size_t k = 0; k + 1 < places.size(); ++k)
        expected.push_back(6.);
      expected.push_back(30. - 6. * double(places.size()) + 6. - (places.size() == 2 ? 12. : 6.));
      expected.push_back(places.size() == 2 ? 12. : 6.);
      std::sort(expected.begin(), expected.end());
      assert(are_near(sorted_lengths(network), expected, 1e-6));
    }
}

// An end keeps its place also after the curve that it belongs to was split.
void test_end_of_a_curve_that_is_split()
{
  Curve_network network(std::vector<Traced_curve>{
    open_curve(straight(Vector(0., 0., 0.), Vector(0., 29.8, 0.))),
    open_curve(straight(Vector(-30., 30., 0.), Vector(30., 30., 0.))),
    open_curve(straight(Vector(20., 15.25, 0.), Vector(0.2, 15.25, 0.))),
  });
  Corner_merger(network, options).attach_ends_to_passing_curves();
  check_ends(network);
  assert(are_near(sorted_lengths(network), {14.75, 15.25, 20., 30., 30.}, 1e-6));
}

// Two splits at the same place of a curve are one node, and no piece without length lies between them.
void test_two_splits_at_one_place()
{
  const Vector place(0.25, 0., 0.);
  Curve_network network = network_of({straight(Vector(-20., 0., 0.), Vector(20., 0., 0.)),
                                      straight(Vector(0.25, 20., 0.), place), straight(Vector(0.25, -20., 0.), place)});
  network.nodes.push_back(network.nodes[network.curves[1].nodes[1]]); // not yet the same
  network.curves[2].nodes[1] = network.nodes.size() - 1;
  Corner_merger(network, options).attach_ends_to_passing_curves();
  check_ends(network);
  assert(are_near(sorted_lengths(network), {19.75, 20., 20., 20.25}, 1e-6));
  assert(network.curves[1].nodes[1] == network.curves[2].nodes[1]);
}

// Curves that pass through one place end there: straight ones, in any direction, and closed ones twice.
void test_crossings_are_vertices()
{
  for (double gap : {0., 0.15})
    for (double angle : {40., 90., 140.})
    {
      const Vector along(std::cos(angle * CGAL_PI / 180.), std::sin(angle * CGAL_PI / 180.), 0.);
      const Vector above(0.1, 0.2, gap);
      Curve_network network(std::vector<Traced_curve>{
        open_curve(straight(Vector(-20., 0., 0.), Vector(15., 0., 0.))),
        open_curve(straight(above - 10. * along, above + 12. * along)),
      });
      Corner_merger(network, options).split_crossings();
      check_ends(network);
      assert(living(network).size() == 4);
      assert(number_of_ends_at(network, Vector::Zero(), 1.) == 4);
    }
  Polyline circle;
  for (int k = 0; k <= 60; ++k)
    circle.push_back(10. * Vector(std::cos(k * CGAL_PI / 30.), std::sin(k * CGAL_PI / 30.), 0.));
  circle.back() = circle.front();
  Traced_curve closed;
  closed.points = circle;
  closed.is_closed = true;
  Curve_network network(
    std::vector<Traced_curve>{closed, open_curve(straight(Vector(-20., 1., 0.), Vector(20., 1., 0.)))});
  Corner_merger(network, options).split_crossings();
  check_ends(network);
  assert(living(network).size() == 5);
  for (double side : {-1., 1.})
    assert(number_of_ends_at(network, Vector(side * std::sqrt(99.), 1., 0.), 0.5) == 4);
}

// Curves that touch, pass at a distance or end where they meet do not cross.
void test_no_crossings()
{
  const Polyline line = straight(Vector(-20., 0., 0.), Vector(20., 0., 0.));
  Joining_options noisy;
  noisy.noise = 0.3;
  Curve_network crossed(
    std::vector<Traced_curve>{open_curve(line), open_curve(straight(Vector(0., -20., 0.), Vector(0., 20., 0.)))});
  Corner_merger(crossed, noisy).split_crossings();
  assert(living(crossed).size() == 2); // which may be one edge that was traced twice
  for (const Polyline& other :
       {straight(Vector(-20., 0.1, 0.), Vector(20., 0.1, 0.)), straight(Vector(-20., -4., 0.), Vector(20., 4., 0.)),
        straight(Vector(0., -20., 0.5), Vector(0., 20., 0.5)), straight(Vector(0., -20., 0.), Vector(0., 1., 0.)),
        straight(Vector(19., -20., 0.), Vector(19., 20., 0.))})
  {
    Curve_network network(std::vector<Traced_curve>{open_curve(line), open_curve(other)});
    Corner_merger(network, options).split_crossings();
    check_ends(network);
    assert(living(network).size() == 2);
  }
}

// Ends that meet in corners --------------------------------------------------------------------------

void test_ends_that_agree_become_one_corner()
{
  const Vector corner(1., 2., 3.);
  for (double shortfall : {0., 0.3, 1.})
  {
    std::vector<Traced_curve> curves;
    for (int axis = 0; axis < 3; ++axis)
      curves.push_back(
        open_curve(straight(corner + shortfall * Vector::Unit(axis), corner + 20. * Vector::Unit(axis))));
    curves.push_back(open_curve(straight(corner - Vector(8., 8., 8.), corner - Vector(20., 20., 20.))));
    Curve_network network(curves);
    Corner_merger(network, options).merge_nodes_that_agree();
    check_ends(network);
    assert(number_of_ends_at(network, corner, 0.2) == 3);
    assert(number_of_ends_at(network, corner, 12.) == 3);
  }
}

// ends that pass each other are no corner
void test_ends_that_disagree()
{
  for (double apart : {0.5, 2.})
  {
    Curve_network network(
      std::vector<Traced_curve>{open_curve(straight(Vector(20., 0., 0.), Vector(0.3, 0., 0.))),
                                open_curve(straight(Vector(0., 20., apart), Vector(0., 0.3, apart)))});
    Corner_merger(network, options).merge_nodes_that_agree();
    assert((network.curves[0].nodes[1] == network.curves[1].nodes[1]) == (apart < 1.));
  }
}

// joints that turn by less than 20 degrees are none
void test_smooth_joints()
{
  for (double turn : {0.3, 0.4, 1.5})
  {
    const Vector middle(0., 0., 0.);
    Curve_network network = network_of(
      {straight(Vector(-20., 0., 0.), middle), straight(middle, 20. * Vector(std::cos(turn), std::sin(turn), 0.))});
    Curve_end_joiner(network, options).prune([](const std::vector<const Polyline*>& lines) {
      return std::vector<char>(lines.size(), 1);
    });
    assert(living(network).size() == (turn < 0.35 ? 1u : 2u));
  }
}

// of many corners side by side, each keeps its own ends
void test_many_corners()
{
  std::vector<Traced_curve> curves;
  const std::size_t side = 12;
  for (std::size_t i = 0; i < side; ++i)
    for (std::size_t j = 0; j < side; ++j)
      for (int axis = 0; axis < 3; ++axis)
      {
        const Vector corner(30. * double(i), 30. * double(j), 0.);
        curves.push_back(
          open_curve(straight(corner + 0.4 * Vector::Unit(axis), corner + 10. * Vector::Unit(axis), 2.)));
      }
  Curve_network network(curves);
  Corner_merger(network, options).merge_nodes_that_agree();
  std::size_t corners = 0;
  for (const auto& ends : network.incidences())
  {
    assert(ends.size() == 0 || ends.size() == 1 || ends.size() == 3);
    corners += ends.size() == 3;
  }
  assert(corners == side * side);
}

void test_ends_of_a_short_curve_do_not_meet()
{
  for (double angle : {0.5, 1.})
    for (double length : {7., 9.})
    {
      // an arc that turns until its two ends nearly face each other
      Polyline points;
      const double radius = length / (4. * quarter_turn - 0.2 * angle);
      for (int k = 0; k <= 40; ++k)
      {
        const double at = (4. * quarter_turn - 0.2 * angle) * k / 40.;
        points.push_back(radius * Vector(std::cos(at), std::sin(at), 0.));
      }
      Curve_network network(std::vector<Traced_curve>{open_curve(points)});
      Corner_merger(network, options).merge_nodes_that_agree();
      assert((network.curves[0].nodes[0] == network.curves[0].nodes[1]) == (length > 8.));
    }
}

// Curves that come too close before they meet --------------------------------------------------------

// a fork of two curves that lead to a short one, the stem, at these angles to it
Curve_network fork(double length_of_stem, double first_angle, double second_angle, bool is_turned)
{
  const Vector middle(0., 0., 0.), end(length_of_stem, 0., 0.);
  const auto branch = [&](double angle) {
    const Vector from = -20. * Vector(std::cos(angle), std::sin(angle), 0.);
    return is_turned ? straight(middle, from) : straight(from, middle);
  };
  return network_of(
    {branch(first_angle), branch(second_angle), is_turned ? straight(end, middle) : straight(middle, end)});
}

// A short curve to which two lead belongs to both, if they come from behind it: then these meet at its end. The angle
// may be larger where the stem ends freely, as a trace may have gone astray there.
void test_acute_corners()
{
  const auto is_closed = [](Curve_network network, const Vector& end) {
    Tangency_resolver(network, options).close_acute_corners();
    check_ends(network);
    const std::size_t ends = number_of_ends_at(network, end, 1e-9);
    assert(living(network).size() == (ends == 2 ? 2u : network.curves.size()));
    return ends == 2;
  };
  for (bool is_turned : {false, true})
  {
    assert(is_closed(fork(4., 0.1, -0.1, is_turned), Vector(4., 0., 0.)));
    assert(is_closed(fork(5.5, 0.9, 0., is_turned), Vector(5.5, 0., 0.)));
    // too long, or a spur on a curve that hardly turns, or a corner of three edges
    assert(!is_closed(fork(8., 0.1, -0.1, is_turned), Vector(8., 0., 0.)));
    assert(!is_closed(fork(4., 1.5, -1.5, is_turned), Vector(4., 0., 0.)));
    assert(!is_closed(fork(4., 1.3, 0., is_turned), Vector(4., 0., 0.)));
    // a stem that ends in another vertex is an edge, unless both lead on smoothly
    for (double angle : {0.2, 0.9})
    {
      Curve_network network = fork(4., angle, 0., is_turned);
      Curve_network other = network_of({straight(Vector(4., 0., 0.), Vector(4., 20., 0.))});
      other.curves[0].nodes = {network.curves[2].nodes[is_turned ? 0 : 1], network.nodes.size()};
      network.nodes.push_back(other.nodes[1]);
      network.curves.push_back(other.curves[0]);
      Tangency_resolver(network, options).close_acute_corners();
      check_ends(network);
      assert(living(network).size() == (angle < 0.5 ? 3u : 4u));
    }
  }
}

// Joints that are rounded ----------------------------------------------------------------------------

double distance_to(const Vector& p, const std::vector<Polyline>& lines)
{
  double least = 1e9;
  for (const Polyline& line : lines)
    for (std::size_t k = 1; k < line.size(); ++k)
      least = std::min(least, std::sqrt(squared_distance_to_segment(p, line[k - 1], line[k])));
  return least;
}

// judges polylines as they are drawn by their distance to the corner
struct Drawn_joint
{
  Vector center;
  double loss_per_distance;

  double loss(const std::vector<Polyline>& lines) const { return loss_per_distance * distance_to(center, lines); }
  Joint_course smooth(const Polyline& line, Progress&) const { return {{line}, loss({line})}; }
  Joint_course corner(const Polyline& head, const Polyline& tail, Progress&) const
  {
    return {{head, tail}, loss({head, tail})};
  }
};

// Every joint of a chain is asked once, whatever the order and the directions of its curves, and where the field likes
// a rounded course better the chain is one smooth curve in the end.
void test_round_off_asks_at_every_joint()
{
  const std::vector<Vector> corners{Vector(0., 0., 0.), Vector(0., 20., 0.), Vector(20., 20., 0.), Vector(20., 0., 0.),
                                    Vector(40., 0., 0.)};
  std::vector<std::size_t> order{0, 1, 2, 3};
  do
    for (unsigned turned = 0; turned < 16; ++turned)
      for (bool is_rounded : {true, false})
      {
        std::vector<Polyline> lines;
        for (std::size_t k : order)
          lines.push_back(turned >> k & 1 ? straight(corners[k + 1], corners[k], 1.)
                                          : straight(corners[k], corners[k + 1], 1.));
        Curve_network network = network_of(lines);
        Progress progress(uninterrupted);
        std::vector<std::size_t> asked(corners.size(), 0);
        Curve_end_joiner(network, options)
          .round_off(
            [&](const Vector& center, const std::vector<Polyline>& lines) {
              assert(lines.size() == 2 && lines[0].back() == center && lines[1].front() == center);
              for (std::size_t k = 0; k < corners.size(); ++k)
                asked[k] += center == corners[k];
              return Drawn_joint{center, is_rounded ? -1. : 1.};
            },
            0.1, progress);
        assert((asked == std::vector<std::size_t>{0, 1, 1, 1, 0}));
        check_ends(network);
        const std::vector<Network_curve> curves = living(network);
        assert(curves.size() == (is_rounded ? 1u : 4u));
        if (!is_rounded)
          continue;
        assert(largest_turn(curves[0].points) < 0.35);
        assert(distance_to(corners[2], {curves[0].points}) > 1. && distance_to(corners[2], {curves[0].points}) < 2.5);
        for (const Vector& end : {corners.front(), corners.back()})
          assert((curves[0].points.front() - end).norm() < 1e-9 || (curves[0].points.back() - end).norm() < 1e-9);
      }
  while (std::next_permutation(order.begin(), order.end()));
}

// A field that does not care leaves corners sharp, and rounds joints that hardly turn; where three curves meet nothing
// is rounded, and nothing where a curve meets itself.
void test_round_off_in_doubt()
{
  const auto indifferent = [](const Vector& center, const std::vector<Polyline>&) { return Drawn_joint{center, 0.}; };
  const auto fond_of_arcs = [](const Vector& center, const std::vector<Polyline>&) { return Drawn_joint{center, -1.}; };
  Progress progress(uninterrupted);
  const Vector middle(0., 0., 0.), left(-20., 0., 0.);
  for (double turn : {0.5, 0.7, 0.9, 1.5, 2.5})
  {
    const Vector right = 20. * Vector(std::cos(turn), std::sin(turn), 0.);
    Curve_network network = network_of({straight(left, middle), straight(middle, right)});
    Curve_end_joiner(network, options).round_off(indifferent, 0.1, progress);
    assert(living(network).size() == (turn < 0.8 ? 1u : 2u));
    Curve_network fork =
      network_of({straight(left, middle), straight(middle, right), straight(middle, Vector(0., 0., 20.))});
    Curve_end_joiner(fork, options).round_off(fond_of_arcs, 0.1, progress);
    assert(living(fork).size() == 3);
  }
  Curve_network loop = network_of(
    {straight(middle, left) + straight(left, Vector(-20., 20., 0.)) + straight(Vector(-20., 20., 0.), middle)});
  Curve_end_joiner(loop, options).round_off(fond_of_arcs, 0.1, progress);
  assert(loop.curves[0].nodes[0] == loop.curves[0].nodes[1] && loop.curves[0].nodes[0] != no_node);
}

// Ends that are cut, pieces that go ------------------------------------------------------------------

void test_trim_free_ends()
{
  const Vector fork(0., 0., 0.);
  const std::vector<Polyline> rest{straight(Vector(0., 30., 0.), fork), straight(Vector(0., 0., 30.), fork)};
  const auto trimmed = [&](const Polyline& line, auto is_on_crease) {
    Curve_network network = network_of({line, rest[0], rest[1]});
    Curve_end_joiner(network, options)
      .trim_free_ends([&](const Vector& p) { return std::abs(p.x()) < 1e-9 || is_on_crease(p.x()); }, 25.);
    check_ends(network);
    return network;
  };
  const auto length = [](const Curve_network& network) { return polyline_length(network.curves[0].points); };
  for (bool is_outward : {true, false})
  {
    const auto line = [&](double to) {
      return is_outward ? straight(fork, Vector(to, 0., 0.)) : straight(Vector(to, 0., 0.), fork);
    };
    // up to where the crease ends, not farther; the end that others share is no free one
    Curve_network network = trimmed(line(40.), [](double x) { return x > 5. && x < 25.2; });
    assert(std::abs(length(network) - 25.) < 1e-9 && network.curves[0].is_alive);
    const int end = is_outward ? 1 : 0;
    assert((network.nodes[network.curves[0].nodes[end]] - Vector(25., 0., 0.)).norm() < 1e-9);
    assert((network.curves[0].tips[end].tangent - Vector::UnitX()).norm() < 1e-9);
    assert(number_of_ends_at(network, fork, 1e-9) == 3);
    // a place or two that seem to have a crease are none
    network = trimmed(line(40.), [](double x) { return x < 25.2 || std::abs(x - 33.25) < 0.3; });
    assert(std::abs(length(network) - 25.) < 1e-9);
    // all of it has one
    network = trimmed(line(40.), [](double) { return true; });
    assert(std::abs(length(network) - 40.) < 1e-9);
    // none of it: long ones are left alone
    const auto never = [](double) { return false; };
    assert(trimmed(line(26.), never).curves[0].is_alive && !trimmed(line(24.), never).curves[0].is_alive);
    assert(std::abs(length(trimmed(line(26.), never)) - 26.) < 1e-9);
    // what is left is too short
    assert(!trimmed(line(20.), [](double x) { return x < 2.6; }).curves[0].is_alive);
    assert(trimmed(line(20.), [](double x) { return x < 3.6; }).curves[0].is_alive);
  }
  // both ends
  Curve_network network = network_of({straight(Vector(-20., 0., 0.), Vector(20., 0., 0.))});
  Curve_end_joiner(network, options).trim_free_ends([](const Vector& p) { return p.x() > -10.2 && p.x() < 5.2; }, 25.);
  check_ends(network);
  assert(std::abs(polyline_length(network.curves[0].points) - 15.) < 1e-9);
}

void test_drop_spurs()
{
  const double free_length = 4.5, dangling_length = 2.4;
  const Vector middle(0., 0., 0.), left(-20., 0., 0.), right(20., 0., 0.);
  const auto dropped = [&](const std::vector<Polyline>& lines) {
    Curve_network network = network_of(lines);
    Curve_end_joiner(network, options).drop_spurs(free_length, dangling_length);
    check_ends(network);
    return sorted_lengths(network);
  };
  // with two free ends
  assert(dropped({straight(middle, Vector(4.4, 0., 0.), 0.2)}).empty());
  assert(dropped({straight(middle, Vector(4.6, 0., 0.), 0.2)}).size() == 1);
  // with one: what it hung on is one curve again
  assert(are_near(dropped({straight(left, middle), straight(middle, right), straight(middle, Vector(0., 2.3, 0.))}),
                  {40.}, 1e-6));
  assert(dropped({straight(left, middle), straight(middle, right), straight(middle, Vector(0., 2.5, 0.))}).size() == 3);
  // with none
  const Vector top(0., 2., 0.);
  assert(dropped({straight(left, middle), straight(middle, right), straight(middle, top),
                  straight(top, Vector(0., 2., 20.)), straight(top, Vector(0., 2., -20.))})
           .size()
         == 5);
  // what hung on a piece that went
  assert(are_near(dropped({straight(left, middle), straight(middle, right), straight(middle, top),
                           straight(top, Vector(2., 2., 0.)), straight(top, Vector(0., 2., 2.))}),
                  {40.}, 1e-6));
  // a closed curve has no ends
  Traced_curve closed;
  closed.is_closed = true;
  closed.points = straight(middle, Vector(1., 0., 0.)) + straight(Vector(1., 0., 0.), Vector(0., 1., 0.))
    + straight(Vector(0., 1., 0.), middle);
  Curve_network network(std::vector<Traced_curve>{closed});
  Curve_end_joiner(network, options).drop_spurs(free_length, dangling_length);
  assert(network.curves[0].is_alive);
}

// Curves that are added ------------------------------------------------------------------------------

// two forks, `distance` apart along x
std::vector<Polyline> two_forks(double distance)
{
  std::vector<Polyline> lines;
  for (double x : {0., distance})
    for (double z : {-20., 20.})
      lines.push_back(straight(Vector(x, 0., 0.), Vector(x, 20., z)));
  return lines;
}

bool is_never_folded(const Polyline&) { return false; }

void test_add_edges_between_nodes()
{
  for (double distance : {0.9, 1.1, 6., 9.9, 10.1})
    for (double gain : {1., 0., -1.})
    {
      Curve_network network = network_of(two_forks(distance));
      std::size_t accepted = 0;
      Curve_end_joiner(network, options)
        .add_edges_between_nodes(
          10., [&](const Polyline& line) { return line.front().y() == 0. && line.back().y() == 0. ? gain : -1.; },
          is_never_folded,
          [&](const Polyline& line) {
            ++accepted;
            assert(std::abs(polyline_length(line) - distance) < 1e-9);
          });
      const bool is_added = gain > 0. && distance > 1. && distance < 10.;
      assert(accepted == is_added && network.curves.size() == 4u + is_added);
      check_ends(network);
      if (!is_added)
        continue;
      const Network_curve& edge = network.curves.back();
      assert(edge.points.size() >= 5 && edge.is_alive);
      assert((edge.tips[0].tangent + edge.tips[1].tangent).norm() < 1e-9);
      assert((edge.tips[1].point - edge.points.back()).norm() < 1e-9);
      assert(edge.tips[1].tangent.dot(edge.points.back() - edge.points.front()) > 0.);
    }
}

// the best one first, and none whose evidence another one has taken
void test_added_edges_share_no_evidence()
{
  const std::vector<Vector> places{Vector(0., 0., 0.), Vector(6., 0., 0.), Vector(3., 3., 0.)};
  std::vector<Polyline> lines;
  for (const Vector& place : places)
    for (double z : {-20., 20.})
      lines.push_back(straight(place, place + Vector(0., z == 20. ? 1. : 2., z)));
  for (std::size_t best = 0; best < 3; ++best)
  {
    Curve_network network = network_of(lines);
    std::vector<Polyline> accepted;
    Curve_end_joiner(network, options)
      .add_edges_between_nodes(
        7.,
        [&](const Polyline& line) {
          if (!accepted.empty() || std::abs(line.front().z()) + std::abs(line.back().z()) > 0.)
            return -1.;
          return line.front() != places[best] && line.back() != places[best] ? 2. : 1.;
        },
        is_never_folded, [&](const Polyline& line) { accepted.push_back(line); });
    assert(accepted.size() == 1 && network.curves.size() == lines.size() + 1);
    assert(accepted[0].front() != places[best] && accepted[0].back() != places[best]);
  }
}

// An edge without evidence of the field is one of the surface: between corners of two edges each, that it is not beside
// a curve, and that are no longer corners of two edges when it is there.
void test_edges_of_the_surface()
{
  // of the free ends of the forks, the surface shows none
  const auto always = [](const Polyline& line) { return line.front().y() == 0. && line.back().y() == 0.; };
  const auto count_of_added = [&](const std::vector<Polyline>& lines, const auto& is_folded) {
    Curve_network network = network_of(lines);
    std::size_t accepted = 0;
    Curve_end_joiner(network, options)
      .add_edges_between_nodes(
        7., [](const Polyline&) { return -1.; }, is_folded, [&](const Polyline&) { ++accepted; });
    check_ends(network);
    assert(network.curves.size() == lines.size() + accepted);
    return accepted;
  };
  const std::vector<Polyline> forks = two_forks(6.);
  assert(count_of_added(forks, always) == 1);
  assert(count_of_added(forks, is_never_folded) == 0);
  assert(count_of_added(two_forks(7.1), always) == 0);
  // a corner of three edges lacks none
  std::vector<Polyline> lines = forks;
  lines.push_back(straight(Vector(0., 0., 0.), Vector(-20., 0., 0.)));
  assert(count_of_added(lines, always) == 0);
  // an edge there is already, and one that another curve runs along
  lines = forks;
  lines.push_back(straight(Vector(0., 0., 0.), Vector(6., 0., 0.)));
  assert(count_of_added(lines, always) == 0);
  for (double aside : {0.5, 1.5})
  {
    lines = forks;
    lines.push_back(straight(Vector(-20., aside, 0.), Vector(20., aside, 0.)));
    assert(count_of_added(lines, always) == (aside > 1.));
  }
  // of three corners in a row, the two that are nearer to each other
  lines = forks;
  for (double z : {-20., 20.})
    lines.push_back(straight(Vector(11., 0., 0.), Vector(11., 20., z)));
  assert(count_of_added(lines, always) == 1);
}

// Between free ends an arc is tried as well, one that leads on from both.
void test_arc_between_free_ends()
{
  const double radius = 10.;
  const auto at = [&](double angle) -> Vector { return radius * Vector(std::cos(angle), std::sin(angle), 0.); };
  for (bool is_free : {true, false})
  {
    Polyline before, after;
    for (int k = 0; k <= 20; ++k)
    {
      before.push_back(at(-1.4 + 0.05 * k));
      after.push_back(at(0.4 + 0.05 * k));
    }
    std::vector<Polyline> lines{before, after};
    if (!is_free)
      lines.push_back(straight(before.back(), before.back() + Vector(0., 0., 20.)));
    Curve_network network = network_of(lines);
    Curve_end_joiner(network, options)
      .add_edges_between_nodes(
        10.,
        [&](const Polyline& line) {
          double off = 0.;
          for (const Vector& p : line)
            off = std::max(off, std::abs(p.norm() - radius));
          return off < 0.2 ? 1. : -1.;
        },
        is_never_folded, [](const Polyline&) {});
    assert(network.curves.size() == lines.size() + is_free);
    check_ends(network);
  }
}

// Free ends that lead on -----------------------------------------------------------------------------

// which of the targets, in each of which two curves meet, a line along x that ends at the origin is extended to
std::size_t target_of_extension(const std::vector<Vector>& targets)
{
  std::vector<Polyline> lines{straight(Vector(-30., 0., 0.), Vector(0., 0., 0.))};
  for (const Vector& target : targets)
    for (double z : {-20., 20.})
      lines.push_back(straight(target, target + Vector(0., 1., z)));
  Curve_network network = network_of(lines);
  Curve_end_joiner(network, options).extend_free_ends();
  check_ends(network);
  for (std::size_t k = 0; k < targets.size(); ++k)
    if (network.nodes[network.curves[0].nodes[1]] == targets[k])
      return k;
  return targets.size();
}

void test_extension_of_free_ends()
{
  // a little ahead, behind, aside, or too far
  for (double ahead : {0.5, 4., 7.9, -0.8})
    assert(target_of_extension({Vector(ahead, 0.2, 0.)}) == 0);
  assert(target_of_extension({Vector(4., 2.5, 0.)}) == 1);
  assert(target_of_extension({Vector(8.1, 0., 0.)}) == 1);
  // the nearest one, which may lie ahead while another one lies behind
  assert(target_of_extension({Vector(5., 0., 0.), Vector(3., 0., 0.)}) == 1);
  assert(target_of_extension({Vector(-0.9, 0.2, 0.), Vector(0.3, 0., 0.)}) == 1);
  assert(target_of_extension({Vector(0.3, 0., 0.), Vector(-0.9, 0.2, 0.)}) == 0);
  assert(target_of_extension({Vector(-0.2, 0.2, 0.), Vector(6., 0., 0.)}) == 0);
  // not to the own other end
  Curve_network network =
    network_of({straight(Vector(5., 0., 0.), Vector(5., 30., 0.)) + straight(Vector(5., 30., 0.), Vector(-30., 0., 0.))
                  + straight(Vector(-30., 0., 0.), Vector(0., 0., 0.)),
                straight(Vector(5., 0., 0.), Vector(5., 0., 30.))});
  Curve_end_joiner(network, options).extend_free_ends();
  assert(network.curves[0].nodes[0] != network.curves[0].nodes[1]);
}

// ends that face each other over a gap, also when the last part of one has gone astray
void test_gaps()
{
  for (bool is_astray : {false, true})
    for (bool is_turned : {false, true})
    {
      const auto bridged = [&](double gap, double offset) {
        Polyline line = straight(Vector(-30., 0., 0.), Vector(0., 0., 0.));
        if (is_astray)
          line = line + straight(Vector(0., 0., 0.), Vector(1., 2., 0.));
        if (is_turned)
          std::reverse(line.begin(), line.end());
        Curve_network network = network_of({line, straight(Vector(gap, offset, 0.), Vector(gap + 30., offset, 0.))});
        Curve_end_joiner joiner(network, options);
        joiner.bridge_gaps();
        joiner.drop_spurs(0., 0.); // joins what is smooth
        check_ends(network);
        const std::size_t ends = number_of_ends_at(network, Vector(gap / 2., offset / 2., 0.), gap / 2. + 5.);
        assert(ends == 2 || ends == 0 || living(network).size() == 2);
        return ends == 2 && network.curves[0].nodes[is_turned ? 0 : 1] == network.curves[1].nodes[0];
      };
      assert(bridged(8., 0.) && bridged(12., 0.));
      assert(!bridged(19., 0.) && !bridged(8., 5.));
    }
}

// Where the data end, a trace stops farther before its corner, and less is known of where that is.
void test_ends_in_void()
{
  for (const bool is_in_void : {false, true})
  {
    Curve_network network = network_of(
      {straight(Vector(34., 0., 0.), Vector(4., 0., 0.)), straight(Vector(0., 34., 0.), Vector(0., 4., 0.))});
    for (Network_curve& curve : network.curves)
      curve.ends_in_void[1] = is_in_void;
    Corner_merger(network, options).merge_nodes_that_agree();
    check_ends(network);
    assert((network.curves[0].nodes[1] == network.curves[1].nodes[1]) == is_in_void);
    assert(!is_in_void || network.nodes[network.curves[0].nodes[1]].norm() < 0.5);
  }
}

// a polyline that starts at a place in some direction of the plane: angles in radians, turns by length
Polyline bent(Vector from, double angle, const std::vector<std::pair<double, double>>& lengths_and_curvatures)
{
  const double step = 0.25;
  Polyline points{from};
  for (const auto& part : lengths_and_curvatures)
    for (double s = 0.; s < part.first - 0.5 * step; s += step)
    {
      from += step * Vector(std::cos(angle + 0.5 * step * part.second), std::sin(angle + 0.5 * step * part.second), 0.);
      angle += step * part.second;
      points.push_back(from);
    }
  return points;
}

// A bridge turns by 69 degrees at most, however long the gap is.
void test_turn_of_bridges()
{
  for (const double turn : {1.1, 1.3})
  {
    const double half = 0.5 * turn;
    Curve_network network =
      network_of({straight(Vector(-30. * std::cos(half), -30. * std::sin(half), 0.), Vector(0., 0., 0.)),
                  straight(Vector(16., 0., 0.), Vector(16. + 30. * std::cos(half), -30. * std::sin(half), 0.))});
    Curve_end_joiner(network, options).bridge_gaps();
    check_ends(network);
    assert((network.curves[0].nodes[1] == network.curves[1].nodes[0]) == (turn < 1.2));
  }
}

// The direction behind a last part that went astray is that at its end, not that of the chord before it: on an arc,
// that is the difference between a bridge that turns too much and one that does not.
void test_bridges_of_arcs()
{
  const double radius = 12., gap = 4.5, turn = gap / radius;
  Joining_options exact;
  exact.noise = 0.02;
  Polyline arc = bent(Vector(0., 0., 0.), 2. * quarter_turn, {{25., -1. / radius}});
  std::reverse(arc.begin(), arc.end());
  const Vector next(radius * std::sin(turn), radius - radius * std::cos(turn), 0.);
  Curve_network network =
    network_of({arc + straight(Vector(0., 0., 0.), Vector(1., -2., 0.)), bent(next, turn, {{25., 1. / radius}})});
  network.curves[1].tips[0].tangent = -Vector(std::cos(turn), std::sin(turn), 0.);
  Curve_end_joiner(network, exact).bridge_gaps();
  check_ends(network);
  assert(network.curves[0].nodes[1] == network.curves[1].nodes[0]);
}

// Of two ends that one may lead to, it is the better one, whatever their order, and none other is touched.
void test_choice_of_bridges()
{
  const Polyline from = straight(Vector(-30., 0., 0.), Vector(0., 0., 0.));
  const Polyline better = straight(Vector(6., 0., 0.), Vector(36., 0., 0.));
  const Polyline worse = straight(Vector(8., 1., 0.), Vector(38., 5., 0.));
  for (const bool is_better_first : {false, true})
  {
    Curve_network network = network_of({from, is_better_first ? better : worse, is_better_first ? worse : better});
    Curve_end_joiner(network, options).bridge_gaps();
    check_ends(network);
    const std::size_t chosen = is_better_first ? 1 : 2;
    assert(network.curves[0].nodes[1] == network.curves[chosen].nodes[0]);
    assert(network.curves[0].nodes[1] != network.curves[3 - chosen].nodes[0]);
    assert((network.curves[3 - chosen].points.front() - worse.front()).norm() == 0.);
    assert(number_of_ends_at(network, Vector(3., 0., 0.), 3.5) == 2);
    assert(are_near(sorted_lengths(network), {30.26, 33., 33.}, 0.1));
  }
}

// Ends that lead on nearly as well as what lies behind them are not cut off.
void test_depth_of_bridges()
{
  for (const double off : {0.08, 0.2})
  {
    Curve_network network = network_of(
      {straight(Vector(-30., 0., 0.), Vector(0., 0., 0.)), straight(Vector(2., 0., 0.), Vector(32., 0., 0.))});
    network.curves[0].tips[1].tangent = Vector(std::cos(off), std::sin(off), 0.);
    Curve_end_joiner(network, options).bridge_gaps();
    check_ends(network);
    const std::size_t node = network.curves[0].nodes[1];
    assert(node == network.curves[1].nodes[0]);
    // in the middle of the gap, which is larger if the last part was cut off
    assert(std::abs(network.nodes[node].x() - (off < 0.1 ? 1. : -0.5)) < 0.3);
  }
}

// A closed curve that passes smoothly through its node has none.
void test_smooth_loops()
{
  const double radius = 10.;
  for (const bool is_smooth : {true, false})
  {
    Polyline loop = bent(Vector(0., 0., 0.), 0., {{4. * quarter_turn * radius, 1. / radius}});
    if (!is_smooth)
      loop.insert(loop.end() - 1, Vector(-1., -2., 0.));
    loop.back() = loop.front();
    Curve_network network = network_of({loop});
    assert(network.curves[0].nodes[0] == network.curves[0].nodes[1]);
    Curve_end_joiner(network, options).prune([](const std::vector<const Polyline*>& polylines) {
      return std::vector<char>(polylines.size(), 1);
    });
    assert(network.curves[0].is_alive && network.curves[0].is_closed_without_node() == is_smooth);
  }
}

// Two curves that leave a node side by side are no bridge from one to the other.
void test_tangent_curves_in_a_node()
{
  const Vector middle(0., 0., 0.);
  Curve_network network = network_of({straight(Vector(-20., 0., 0.), middle), straight(middle, Vector(20., 1.5, 0.)),
                                      straight(middle, Vector(20., -1.5, 0.))});
  Tangency_resolver(network, options).bridge_tangencies();
  check_ends(network);
  assert(living(network).size() == 3);
  for (const std::size_t c : {1, 2})
    assert(network.curves[c].nodes[0] == network.curves[0].nodes[1]);
}

// Curves that are one for a while are parted only if each leads on to another one: not where one
// of them comes from aside.
void test_tangent_curves_without_partners()
{
  for (const bool is_from_aside : {false, true})
  {
    const Vector left(0., 0., 0.), right(6., 0., 0.);
    const Polyline aside = bent(left, 2. * quarter_turn, {{6.5, 0.}, {is_from_aside ? 3. : 0., -0.35}, {15., 0.}});
    Curve_network network = network_of({aside, straight(left, Vector(-20., -4., 0.)), straight(left, right),
                                        straight(right, Vector(26., 3., 0.)), straight(right, Vector(26., -3., 0.))});
    Tangency_resolver(network, options).separate_tangent_curves();
    check_ends(network);
    assert(living(network).size() == (is_from_aside ? 5u : 2u));
  }
}

// What both ends of a short curve lead to, in a circle, is no acute corner.
void test_no_acute_corner_of_a_loop()
{
  const Vector start(0., 0., 0.), end(5., 0., 0.);
  for (const bool is_loop : {false, true})
  {
    const Polyline back = straight(start, Vector(-15., -3., 0.));
    const Polyline loop = back + straight(Vector(-15., -3., 0.), Vector(-15., -20., 0.))
      + straight(Vector(-15., -20., 0.), Vector(20., -20., 0.)) + straight(Vector(20., -20., 0.), end);
    Curve_network network =
      network_of({straight(Vector(-20., 3., 0.), start), is_loop ? loop : back, straight(start, end)});
    Tangency_resolver(network, options).close_acute_corners();
    check_ends(network);
    assert(network.curves[2].is_alive == is_loop);
  }
}

// Cancelling -------------------------------------------------------------------------------------------

// Cells far from each other, in each of which every step finds something: ends that agree, an end beside another curve,
// a crossing, a gap, a free end before a node, a fork that only one crease holds, and a spur.
Curve_network network_of_cells(std::size_t side)
{
  std::vector<Polyline> lines;
  const auto add = [&](const Vector& from, const Vector& to) { lines.push_back(straight(from, to)); };
  for (std::size_t i = 0; i < side; ++i)
    for (std::size_t j = 0; j < side; ++j)
    {
      const Vector cell(120. * double(i), 120. * double(j), 0.);
      const auto at = [&](double x, double y, double z) { return Vector(cell + Vector(x, y, z)); };
      for (int axis = 0; axis < 3; ++axis)
        add(cell + 0.4 * Vector::Unit(axis), cell + 10. * Vector::Unit(axis));
      add(at(30., 0., 0.), at(30., 30., 0.));
      add(at(30.4, 15., 0.), at(40., 15., 20.));
      add(at(45., 10., 0.), at(65., 10., 0.));
      add(at(55., 0., 0.1), at(55., 20., 0.1));
      add(at(40., 40., 0.), at(50., 40., 0.));
      add(at(58., 40., 0.), at(68., 40., 0.));
      add(at(0., 60., 0.), at(0., 80., 0.));
      add(at(0., 60., 0.), at(0., 60., 20.));
      add(at(5., 60., 0.), at(25., 60., 0.));
      add(at(60., 60., 0.), at(62., 60., 0.));
    }
  return network_of(lines);
}

// A step asks at least so often whether to go on. Wherever it is told not to, it asks no more, and leaves a network.
template <class Step>
void check_cancelling(const Curve_network& network, std::size_t least, const Step& step)
{
  std::size_t calls = 0;
  const std::function<bool(double)> count = [&](double) { return ++calls > 0; };
  Progress counting(count);
  Curve_network all = network;
  step(all, counting);
  check_ends(all);
  assert(calls >= least && !counting.is_cancelled());
  for (std::size_t most = 1; most < calls; most += 1 + calls / 12)
  {
    std::size_t made = 0;
    const std::function<bool(double)> stop = [&](double) { return ++made < most; };
    Progress stopping(stop);
    Curve_network some = network;
    step(some, stopping);
    assert(made == most && stopping.is_cancelled());
    check_ends(some);
  }
}

void test_cancelling()
{
  const Curve_network network = network_of_cells(6);
  const std::size_t nodes = network.nodes.size(), curves = network.curves.size(), cells = 36;
  const auto check_joiner = [&](std::size_t least, const auto& step) {
    check_cancelling(network, least, [&](Curve_network& n, Progress& progress) {
      Curve_end_joiner joiner(n, options, &progress);
      step(joiner);
    });
  };
  const auto check_corners = [&](std::size_t least, const auto& step) {
    check_cancelling(network, least, [&](Curve_network& n, Progress& progress) {
      Corner_merger merger(n, options, &progress);
      step(merger);
    });
  };
  const auto check_tangencies = [&](std::size_t least, const auto& step) {
    check_cancelling(network, least, [&](Curve_network& n, Progress& progress) {
      Tangency_resolver resolver(n, options, &progress);
      step(resolver);
    });
  };
  check_corners(nodes + 2 * cells, [](Corner_merger& m) { m.merge_nodes_that_agree(); });
  check_corners(nodes + cells, [](Corner_merger& m) { m.attach_ends_to_passing_curves(); });
  check_corners(curves + cells, [](Corner_merger& m) { m.split_crossings(); });
  // for each node, also where smooth joints are dissolved, and for each free end, which all nodes have but the forks
  check_tangencies(3 * nodes - cells, [](Tangency_resolver& t) { t.bridge_tangencies(); });
  check_tangencies(curves, [](Tangency_resolver& t) { t.close_acute_corners(); });
  check_tangencies(1, [](Tangency_resolver& t) { t.separate_tangent_curves(); });
  check_joiner(nodes, [](Curve_end_joiner& j) { j.bridge_gaps(); });
  check_joiner(nodes, [](Curve_end_joiner& j) { j.extend_free_ends(); });
  check_joiner(2 * nodes - cells, [](Curve_end_joiner& j) {
    j.trim_free_ends([](const Vector& p) { return std::abs(p.z()) < 5.; }, 25.);
  });
  check_joiner(nodes + 2, [](Curve_end_joiner& j) { j.drop_spurs(4., 2.); });
  check_joiner(nodes + cells, [](Curve_end_joiner& j) {
    j.add_edges_between_nodes(
      10., [](const Polyline&) { return 1.; }, is_never_folded, [](const Polyline&) {});
  });
  check_joiner(10 * nodes, [](Curve_end_joiner& j) { j.join(); });
}

} // namespace

int main()
{
  test_split_of_a_curve_whose_end_splits_another_one();
  test_several_ends_on_one_segment();
  test_end_of_a_curve_that_is_split();
  test_two_splits_at_one_place();
  test_crossings_are_vertices();
  test_no_crossings();
  test_ends_that_disagree();
  test_smooth_joints();
  test_ends_that_agree_become_one_corner();
  test_many_corners();
  test_ends_of_a_short_curve_do_not_meet();
  test_acute_corners();
  test_round_off_asks_at_every_joint();
  test_round_off_in_doubt();
  test_trim_free_ends();
  test_drop_spurs();
  test_add_edges_between_nodes();
  test_added_edges_share_no_evidence();
  test_edges_of_the_surface();
  test_arc_between_free_ends();
  test_extension_of_free_ends();
  test_gaps();
  test_ends_in_void();
  test_turn_of_bridges();
  test_bridges_of_arcs();
  test_choice_of_bridges();
  test_depth_of_bridges();
  test_smooth_loops();
  test_tangent_curves_in_a_node();
  test_tangent_curves_without_partners();
  test_no_acute_corner_of_a_loop();
  test_cancelling();
  return 0;
}
