// Lines, circles and ellipses: their geometry, the fits, the test that takes or refuses them, the
// cuts, and the common fit.

#include <CGAL/Wireframe_extraction/internal/types/Curve_cutter.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_regularities.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_type_recognizer.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_curve.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_fit.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_network_fit.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_parts.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

const double pi = CGAL_PI;

std::mt19937 generator(7);

double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }
double normal() { return std::normal_distribution<double>()(generator); }
Vector random_direction() { return Vector(normal(), normal(), normal()).normalized(); }

Primitive_curve random_curve(Primitive_kind kind)
{
  Primitive_curve curve;
  curve.kind = kind;
  curve.center = Vector(uniform(-20., 20.), uniform(-20., 20.), uniform(-20., 20.));
  curve.axis = random_direction();
  curve.major = curve.axis.unitOrthogonal();
  curve.major_radius = uniform(4., 20.);
  curve.minor_radius = kind == Primitive_kind::ELLIPSE ? curve.major_radius * uniform(0.5, 0.9) : curve.major_radius;
  return curve;
}

Vector at(const Primitive_curve& curve, double parameter)
{
  return curve.kind == Primitive_kind::LINE ? Vector(curve.center + parameter * curve.axis) : curve.at(parameter);
}

// A station where a field with independent errors of this size has the curve.
Station station(const Vector& place, const Vector& tangent, double deviation)
{
  Station result;
  const Vector error(normal(), normal(), normal());
  result.followed = place;
  result.tangent = tangent;
  result.position = place + deviation * (error - error.dot(tangent) * tangent);
  result.information = (Matrix_3::Identity() - Matrix_3::outer(tangent, tangent)) / (deviation * deviation);
  result.support = 8;
  return result;
}

std::vector<Station> stations_on(const Primitive_curve& curve, double from, double to, std::size_t count,
                                 double deviation)
{
  std::vector<Station> result;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector place = at(curve, from + (to - from) * (double(i) + 0.5) / double(count));
    result.push_back(station(place, (to > from ? 1. : -1.) * curve.tangent(place), deviation));
  }
  return result;
}

// stations every 1.5 along a curve that is given by arc length
std::vector<Station> stations_along(const std::function<Vector(double)>& position, double length, double deviation)
{
  std::vector<Station> result;
  for (double s = 0.75; s < length; s += 1.5)
    result.push_back(station(position(s), (position(s + 1e-4) - position(s - 1e-4)).normalized(), deviation));
  return result;
}

std::vector<Curve_piece> cut(const std::vector<Station>& stations, bool is_closed = false, double density = 0.7)
{
  return Curve_cutter(stations, density, {{stations.front().position, stations.back().position}}, is_closed, 0.001)
    .run();
}

void test_feet()
{
  for (int round = 0; round < 300; ++round)
    for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
    {
      const Primitive_curve curve = random_curve(kind);
      const Vector p = curve.center + uniform(0.1, 30.) * random_direction();
      const Vector foot = curve.foot(p);
      assert((curve.foot(foot) - foot).norm() < 1e-9);
      assert((at(curve, curve.parameter(p)) - foot).norm() < 1e-9);
      assert(std::abs(curve.tangent(p).dot(p - foot)) < 1e-7 * (1. + (p - foot).norm()));
      for (int k = 0; k < 100; ++k)
        assert((p - foot).norm()
               <= (p - at(curve, kind == Primitive_kind::LINE ? uniform(-30., 30.) : 0.02 * pi * k)).norm() + 1e-9);
    }
}

void test_through_points()
{
  for (int round = 0; round < 300; ++round)
  {
    const Primitive_curve circle = random_curve(Primitive_kind::CIRCLE);
    const double start = uniform(-pi, pi);
    const Vector a = circle.at(start), b = circle.at(start + uniform(0.5, 1.5)), c = circle.at(start + uniform(2., 5.));
    const Primitive_curve same = Primitive_curve::circle(a, b, c);
    assert((same.center - circle.center).norm() < 1e-8 && std::abs(same.major_radius - circle.major_radius) < 1e-8);
    assert((same.axis - circle.axis).norm() < 1e-8); // from a through b to c is counterclockwise
    const Primitive_curve ellipse = random_curve(Primitive_kind::ELLIPSE);
    const double turn = uniform(-pi, pi);
    const Primitive_curve twin = Primitive_curve::ellipse(ellipse.center, ellipse.at(turn) - ellipse.center,
                                                          ellipse.at(turn + 0.5 * pi) - ellipse.center);
    assert(std::abs(twin.major_radius - ellipse.major_radius) < 1e-8);
    assert(std::abs(twin.minor_radius - ellipse.minor_radius) < 1e-8);
    for (int k = 0; k < 20; ++k)
      assert((twin.foot(ellipse.at(0.3 * k)) - ellipse.at(0.3 * k)).norm() < 1e-7);
  }
}

// The quantiles of the chi-square distribution that tables have: for 1, 5, 20 and 100 degrees of freedom.
void test_probability()
{
  const double table[4][3] = {{1., 10.828, 0.001}, {5., 15.086, 0.01}, {20., 28.412, 0.1}, {100., 99.334, 0.5}};
  for (const auto& row : table)
  {
    // half of the 2 n - 4 degrees of freedom, and half of the squares count
    const std::size_t n = std::size_t(row[0] + 2.);
    Misfit misfit;
    for (std::size_t i = 0; i < n; ++i)
      misfit.add(2. * row[1] / double(n));
    assert(std::abs(misfit.probability(4) / row[2] - 1.) < 0.25);
  }
  Misfit none;
  for (int i = 0; i < 10; ++i)
    none.add(0.);
  assert(none.probability(4) > 0.99 && none.probability(20) == 0.);
}

// Fits meet the true parameters, as closely as they claim; and true curves are refused as seldom as was asked for.
void test_fits()
{
  for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
  {
    const int rounds = 1000;
    int refused = 0;
    double position = 0., radius = 0.;
    for (int round = 0; round < rounds; ++round)
    {
      const Primitive_curve curve = random_curve(kind);
      const double deviation = uniform(0.005, 0.2);
      const double sweep = kind == Primitive_kind::LINE ? uniform(5., 50.) : uniform(pi, 2. * pi);
      const std::size_t count =
        std::size_t(kind == Primitive_kind::LINE ? sweep / 1.5 : sweep * curve.minor_radius / 1.5);
      if (count < 8)
        continue;
      const std::vector<Station> stations = stations_on(curve, -0.5 * sweep, 0.5 * sweep, count, deviation);
      const Primitive_fit fit(kind, Station_range(stations, 0, count));
      assert(fit.is_valid);
      const Primitive_fit::Covariance covariance = fit.covariance(Station_range(stations, 0, count));
      refused += fit.misfit.probability(curve.number_of_parameters()) < 0.001;
      if (kind == Primitive_kind::LINE)
      {
        position +=
          (fit.curve.center - curve.foot(fit.curve.center)).squaredNorm() / (covariance(0, 0) + covariance(1, 1));
        assert(std::abs(fit.curve.axis.dot(curve.axis)) > 1. - 1e-2);
      }
      else
      {
        position += (fit.curve.center - curve.center).squaredNorm() / covariance.topLeftCorner<3, 3>().trace();
        const int r = kind == Primitive_kind::CIRCLE ? 5 : 6;
        radius += std::pow(fit.curve.major_radius - curve.major_radius, 2) / covariance(r, r);
      }
    }
    assert(refused <= 5);
    // the mean of squared errors in units of their claimed variances
    assert(position / rounds > 0.5 && position / rounds < 2.);
    assert(kind == Primitive_kind::LINE || (radius / rounds > 0.5 && radius / rounds < 2.));
  }
}

// One plainly wrong station in twenty does not matter, or hardly ever.
void test_outliers()
{
  int found = 0;
  for (int round = 0; round < 100; ++round)
  {
    const Primitive_curve circle = random_curve(Primitive_kind::CIRCLE);
    std::vector<Station> stations = stations_on(circle, 0., 2. * pi, 40, 0.02);
    for (int k = 0; k < 2; ++k)
      stations[std::size_t(uniform(1., 38.))].position += 0.8 * random_direction();
    const std::vector<Curve_piece> pieces = cut(stations, true);
    if (pieces.size() == 1 && pieces[0].fit && pieces[0].fit->curve.kind == Primitive_kind::CIRCLE)
    {
      ++found;
      assert(std::abs(pieces[0].fit->curve.major_radius - circle.major_radius) < 0.1);
    }
  }
  assert(found >= 90);
}

void test_kinds()
{
  for (const double deviation : {0.008, 0.05, 0.15})
    for (int round = 0; round < 50; ++round)
      for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
      {
        Primitive_curve curve = random_curve(kind);
        curve.major_radius += 6.;
        curve.minor_radius = kind == Primitive_kind::ELLIPSE ? 0.6 * curve.major_radius : curve.major_radius;
        const bool is_closed = kind != Primitive_kind::LINE;
        const std::vector<Curve_piece> pieces =
          cut(stations_on(curve, 0., is_closed ? 2. * pi : 40., 40, deviation), is_closed);
        assert(pieces.size() == 1 && pieces[0].fit && pieces[0].fit->curve.kind == kind);
      }
}

// with too little support it is no guess
void test_support()
{
  const Primitive_curve line = random_curve(Primitive_kind::LINE);
  assert(!cut(stations_on(line, 0., 3., 2, 0.01))[0].fit);
  assert(cut(stations_on(line, 0., 4.5, 3, 0.01))[0].fit);
  std::vector<Station> stations = stations_on(line, 0., 30., 20, 0.01);
  for (std::size_t i = 4; i < 16; ++i)
    stations[i].support = 0;
  const std::vector<Curve_piece> pieces = cut(stations);
  assert(
    std::none_of(pieces.begin(), pieces.end(), [](const Curve_piece& piece) { return piece.fit && piece.size == 20; }));
}

// two lines of length 20 and two half circles of radius 6
Vector on_slot(double s)
{
  const double half = 6. * pi, period = 40. + 2. * half;
  s -= period * std::floor(s / period);
  const double sign = s < 20. + half ? 1. : -1.;
  s = sign > 0. ? s : s - 20. - half;
  const Vector p = s < 20. ? Vector(s - 10., -6., 0.)
                           : Vector(10. + 6. * std::sin((s - 20.) / 6.), -6. * std::cos((s - 20.) / 6.), 0.);
  return sign * p;
}

void test_cuts()
{
  for (const double deviation : {0.008, 0.1})
    for (int round = 0; round < 20; ++round)
    {
      const double start = uniform(0., 80.);
      const std::vector<Curve_piece> slot =
        cut(stations_along([&](double s) { return on_slot(s + start); }, 40. + 12. * pi, deviation), true);
      assert(slot.size() == 4);
      for (std::size_t i = 0; i < 4; ++i)
      {
        assert(slot[i].fit && slot[i].is_line() != slot[(i + 1) % 4].is_line());
        assert(slot[i].is_line() || std::abs(slot[i].fit->curve.major_radius - 6.) < 0.4);
      }
    }
  // a line that goes on in an arc
  const auto hook = [](double s) {
    return s < 20. ? Vector(s, 0., 0.)
                   : Vector(20. + 10. * std::sin(0.1 * (s - 20.)), 10. - 10. * std::cos(0.1 * (s - 20.)), 0.);
  };
  const std::vector<Curve_piece> pieces = cut(stations_along(hook, 40., 0.01));
  assert(pieces.size() == 2 && pieces[0].is_line() && pieces[1].fit && !pieces[1].is_line());
  assert(std::abs(double(pieces[0].size) - 20. / 1.5) < 2.);
  // what turns at once is no smooth curve: no vertex there, but a spline between
  const auto bent = [](double s) { return s < 20. ? Vector(s, 0., 0.) : Vector(20., s - 20., 0.); };
  const std::vector<Curve_piece> sharp = cut(stations_along(bent, 40., 0.01));
  for (std::size_t i = 1; i < sharp.size(); ++i)
    assert(!sharp[i].fit || !sharp[i - 1].fit);
}

void test_splines_stay()
{
  // a helix, a spiral and a wave
  const std::array<std::function<Vector(double)>, 3> curves = {
    {[](double s) { return Vector(8. * std::cos(0.1 * s), 8. * std::sin(0.1 * s), 0.6 * s); },
     [](double s) {
       const double a = std::sqrt(0.4 * s + 1.);
       return Vector(5. * a * std::cos(a), 5. * a * std::sin(a), 0.);
     },
     [](double s) { return Vector(s, 6. * std::sin(0.15 * s), 4. * std::cos(0.1 * s)); }}};
  for (const auto& curve : curves)
    for (int round = 0; round < 10; ++round)
      for (const Curve_piece& piece : cut(stations_along(curve, 90., 0.01), false, 0.5))
        assert(!piece.fit);
}

// positions along parts of a plane curve, each with a length and a curvature, from a place in some direction
std::function<Vector(double)> joined(std::vector<std::pair<double, double>> parts, Vector start = Vector::Zero(),
                                     double angle = 0., const std::vector<double>& kinks = {})
{
  return [=](double s) {
    Vector p = start;
    double a = angle;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
      const double length = i + 1 < parts.size() ? (std::min)(s, parts[i].first) : s, turn = length * parts[i].second;
      const double chord = std::abs(turn) > 1e-9 ? 2. * std::sin(0.5 * turn) / parts[i].second : length;
      p += chord * Vector(std::cos(a + 0.5 * turn), std::sin(a + 0.5 * turn), 0.);
      s -= length;
      if (!(s > 0.))
        break;
      a += turn + (i < kinks.size() ? kinks[i] : 0.);
    }
    return p;
  };
}

bool has_neighboring_primitives(const std::vector<Curve_piece>& pieces)
{
  for (std::size_t i = 1; i < pieces.size(); ++i)
    if (pieces[i].fit && pieces[i - 1].fit)
      return true;
  return false;
}

// Where two primitives would not go on from one to the other, there is a spline between: a step to the side, a kink,
// both between stations.
void test_no_steps_and_kinks()
{
  const auto step = [](double s) { return Vector(s, s < 19.5 ? 0. : 1., 0.); };
  const std::vector<Curve_piece> aside = cut(stations_along(step, 39., 0.01));
  assert(aside.size() > 1 && !has_neighboring_primitives(aside));
  for (const double kink : {0.45, 1.})
    for (const double curvature : {0., 0.08, -0.08})
    {
      const std::vector<Curve_piece> pieces =
        cut(stations_along(joined({{19.5, 0.}, {19.5, curvature}}, Vector::Zero(), 0., {kink}), 39., 0.01));
      assert(pieces.size() > 1 && pieces[0].is_line() && !has_neighboring_primitives(pieces));
    }
}

// Arcs in a row are no evidence of arcs.
void test_arcs_in_a_row()
{
  for (int round = 0; round < 10; ++round)
    for (const Curve_piece& piece :
         cut(stations_along(joined({{18., 1. / 8.}, {18., 1. / 14.}, {18., 1. / 6.}}), 54., 0.01)))
      assert(!piece.fit);
}

// The rounded end between two lines may be half an ellipse.
void test_ellipse_between_lines()
{
  const double major = 12., minor = 6.;
  std::vector<Vector> places; // at equal steps
  const auto add = [&](const Vector& p) {
    if (places.empty())
      places.push_back(p);
    while ((p - places.back()).norm() >= 1.5)
      places.push_back(places.back() + 1.5 * (p - places.back()).normalized());
  };
  for (double x = -20.; x < 0.; x += 0.01)
    add(Vector(x, -minor, 0.));
  for (double t = -0.5 * pi; t < 0.5 * pi; t += 0.001)
    add(Vector(major * std::cos(t), minor * std::sin(t), 0.));
  for (double x = 0.; x > -20.; x -= 0.01)
    add(Vector(x, minor, 0.));
  std::vector<Station> stations;
  for (std::size_t i = 0; i < places.size(); ++i)
    stations.push_back(station(
      places[i], (places[(std::min)(i + 1, places.size() - 1)] - places[i == 0 ? 0 : i - 1]).normalized(), 0.02));
  const std::vector<Curve_piece> pieces = cut(stations);
  assert(pieces.size() == 3 && pieces[0].is_line() && pieces[2].is_line());
  assert(pieces[1].fit && pieces[1].fit->curve.kind == Primitive_kind::ELLIPSE);
  assert(std::abs(pieces[1].fit->curve.major_radius - major) < 0.5);
}

// A station that errs, wherever it is, ends no piece.
void test_outliers_where_windows_end()
{
  for (std::size_t i = 2; i < 25; ++i)
  {
    std::vector<Station> stations = stations_along(joined({{20., 0.}, {20., 0.1}}), 40., 0.01);
    stations[i].position.z() += 0.2;
    const std::vector<Curve_piece> pieces = cut(stations);
    std::size_t on_primitives = 0;
    for (const Curve_piece& piece : pieces)
      on_primitives += piece.fit ? piece.size : 0;
    assert(on_primitives + 4 >= stations.size());
  }
}

// The slot once more: its pieces share vertices and tangents.
void test_common_fit()
{
  for (int round = 0; round < 20; ++round)
  {
    Primitive_network_fit network;
    const std::array<Vector, 4> corners = {
      {Vector(-10., -6., 0.), Vector(10., -6., 0.), Vector(10., 6., 0.), Vector(-10., 6., 0.)}};
    for (const Vector& corner : corners)
      network.vertices.push_back(corner + 0.3 * random_direction());
    const double half = 6. * pi;
    const std::array<double, 5> breaks = {{0., 20., 20. + half, 40. + half, 40. + 2. * half}};
    for (std::size_t i = 0; i < 4; ++i)
    {
      Primitive_edge edge;
      edge.kind = i % 2 == 0 ? Primitive_kind::LINE : Primitive_kind::CIRCLE;
      edge.vertices = {{i, (i + 1) % 4}};
      edge.stations = stations_along([&](double s) { return on_slot(breaks[i] + s); }, breaks[i + 1] - breaks[i], 0.05);
      edge.points[0] = edge.stations[edge.stations.size() / 2].position;
      network.edges.push_back(edge);
      network.tangencies.push_back({(i + 1) % 4, {{i, (i + 1) % 4}}});
    }
    network.run();
    for (std::size_t i = 0; i < 4; ++i)
    {
      const Vector& place = network.vertices[(i + 1) % 4];
      const Primitive_curve one = network.edges[i].curve(network.vertices);
      const Primitive_curve two = network.edges[(i + 1) % 4].curve(network.vertices);
      assert((one.foot(place) - place).norm() < 1e-9 && (two.foot(place) - place).norm() < 1e-9);
      assert(one.tangent(place).cross(two.tangent(place)).norm() < 1e-7);
      assert((place - corners[(i + 1) % 4]).norm() < 1.);
      if (i % 2 == 1)
        assert(std::abs(one.major_radius - 6.) < 0.15);
    }
  }
}

// A line and an arc that goes on from it, and an elliptic arc beside them, many times over, far from each other.
Primitive_network_fit network_of_parts(std::size_t number_of_hooks, bool has_tangencies)
{
  Primitive_network_fit network;
  for (std::size_t i = 0; i < number_of_hooks; ++i)
  {
    const Vector shift(0., 0., 50. * double(i));
    const std::size_t v = network.vertices.size(), e = network.edges.size();
    for (const Vector& place : {Vector(0., 0., 0.), Vector(20., 0., 0.), Vector(30., 10., 0.), Vector(30., 40., 0.)})
      network.vertices.push_back(place + shift + 0.2 * random_direction());
    Primitive_edge line, arc, ellipse;
    line.vertices = {{v, v + 1}};
    line.stations = stations_along([&](double s) { return Vector(Vector(s, 0., 0.) + shift); }, 20., 0.05);
    arc.kind = Primitive_kind::CIRCLE;
    arc.vertices = {{v + 1, v + 2}};
    arc.stations = stations_along(
      [&](double s) {
        return Vector(Vector(20. + 10. * std::sin(0.1 * s), 10. - 10. * std::cos(0.1 * s), 0.) + shift);
      },
      5. * pi, 0.05);
    arc.points[0] = arc.stations[arc.stations.size() / 2].position;
    ellipse.kind = Primitive_kind::ELLIPSE;
    ellipse.vertices = {{v + 2, v + 3}};
    Primitive_curve curve;
    curve.kind = Primitive_kind::ELLIPSE;
    curve.center = shift + Vector(30., 25., 0.);
    curve.axis = Vector::UnitZ();
    curve.major = Vector::UnitY();
    curve.major_radius = 15.;
    curve.minor_radius = 10.;
    ellipse.points = {{curve.center, curve.at(0.), curve.at(0.5 * pi)}};
    ellipse.stations = stations_on(curve, -pi, 0., 20, 0.05);
    for (const Primitive_edge& edge : {line, arc, ellipse})
      network.edges.push_back(edge);
    if (has_tangencies)
      network.tangencies.push_back({v + 1, {{e, e + 1}}});
    network.spline_ends.push_back({v, network.vertices[v], Vector::UnitY(), 0.2});
  }
  return network;
}

// the largest difference of vertices and shapes
double difference(Primitive_network_fit& one, Primitive_network_fit& two)
{
  double largest = 0.;
  for (std::size_t v = 0; v < one.vertices.size(); ++v)
    largest = (std::max)(largest, (one.vertices[v] - two.vertices[v]).norm());
  for (std::size_t k = 0; k < one.edges.size(); ++k)
  {
    assert(one.is_violated(k) == two.is_violated(k));
    for (const Station& station : one.edges[k].stations)
      largest = (std::max)(largest,
                           (one.edges[k].curve(one.vertices).foot(station.position)
                            - two.edges[k].curve(two.vertices).foot(station.position))
                             .norm());
  }
  return largest;
}

// What is not connected is fitted by itself, with the same result; and what was fitted before is not fitted again.
void test_parts()
{
  const double closeness = 1e-3; // of what the solver comes to: vertices that little holds matter little
  for (const bool has_tangencies : {false, true})
  {
    const Primitive_network_fit network = network_of_parts(5, has_tangencies);
    Primitive_network_fit whole = network, in_parts = network;
    whole.run();
    Primitive_parts parts;
    parts.run(in_parts, nullptr);
    assert(parts.number_of_fits() == 5);
    assert(difference(whole, in_parts) < closeness);
    Primitive_network_fit again = network;
    parts.run(again, nullptr);
    assert(parts.number_of_fits() == 5 && difference(again, in_parts) == 0.);
    // all that a part depends on tells it from another
    const std::array<std::function<void(Primitive_network_fit&)>, 5> changes = {
      {[](Primitive_network_fit& n) { n.vertices[4] += Vector(0.1, 0., 0.); },
       [](Primitive_network_fit& n) { n.edges[3].stations.pop_back(); },
       [](Primitive_network_fit& n) { n.spline_ends[1].deviation *= 2.; },
       [](Primitive_network_fit& n) { n.edges[4].points[0] += Vector(0.1, 0., 0.); },
       [](Primitive_network_fit& n) {
         if (n.tangencies.empty())
           n.tangencies.push_back({5, {{3, 4}}});
         else
           n.tangencies.erase(n.tangencies.begin() + 1);
       }}};
    for (const auto& change : changes)
    {
      Primitive_network_fit changed = network;
      change(changed);
      Primitive_network_fit reference = changed;
      const std::size_t before = parts.number_of_fits();
      parts.run(changed, nullptr);
      assert(parts.number_of_fits() == before + 1);
      reference.run();
      assert(difference(changed, reference) < closeness);
      assert((changed.vertices[0] - in_parts.vertices[0]).norm() == 0.);
    }
    // a regularity connects what it is about; the others are left as they are
    Primitive_network_fit regular = in_parts;
    regular.regularities.push_back({Regularity_kind::EQUAL_RADII, {{1, 7}}});
    const std::size_t before = parts.number_of_fits();
    parts.run(regular, nullptr, true);
    assert(parts.number_of_fits() == before + 1);
    const Primitive_curve one = regular.edges[1].curve(regular.vertices),
                          two = regular.edges[7].curve(regular.vertices);
    assert(std::abs(one.major_radius - two.major_radius) < 1e-8);
    assert((regular.vertices[4] - in_parts.vertices[4]).norm() == 0.);
  }
}

// A solver stops where it is told to.
void test_cancelled_fit()
{
  int calls = 0;
  const std::function<bool(double)> proceed = [&](double) { return ++calls < 4; };
  Progress progress(proceed);
  Primitive_network_fit network = network_of_parts(3, true);
  Primitive_parts().run(network, &progress);
  assert(progress.is_cancelled() && calls == 4);
}

// An elliptic arc between two vertices that lines hold passes through them.
void test_elliptic_arc()
{
  const Primitive_curve ellipse = random_curve(Primitive_kind::ELLIPSE);
  Primitive_network_fit network;
  network.vertices = {ellipse.at(0.2) + 0.1 * random_direction(), ellipse.at(2.5) + 0.1 * random_direction(),
                      ellipse.at(0.2) + 12. * ellipse.axis, ellipse.at(2.5) + 12. * ellipse.axis};
  Primitive_edge arc;
  arc.kind = Primitive_kind::ELLIPSE;
  arc.vertices = {{0, 1}};
  arc.points = {{ellipse.center, ellipse.at(0.), ellipse.at(0.5 * pi)}};
  arc.stations = stations_on(ellipse, 0.2, 2.5, 20, 0.02);
  network.edges.push_back(arc);
  for (std::size_t i = 0; i < 2; ++i)
  {
    Primitive_edge post;
    post.vertices = {{i, i + 2}};
    const Primitive_curve line = Primitive_curve::line(ellipse.at(i == 0 ? 0.2 : 2.5), network.vertices[i + 2]);
    post.stations = stations_on(line, -6., 6., 8, 0.02);
    network.edges.push_back(post);
  }
  network.run();
  for (std::size_t i = 0; i < 2; ++i)
  {
    const Vector& place = network.vertices[i];
    assert((network.edges[0].curve(network.vertices).foot(place) - place).norm() < 1e-8);
    assert((place - ellipse.at(i == 0 ? 0.2 : 2.5)).norm() < 0.2);
  }
}

std::size_t count(const std::vector<Regularity>& regularities, Regularity_kind kind)
{
  return std::size_t(std::count_if(regularities.begin(), regularities.end(),
                                   [kind](const Regularity& regularity) { return regularity.kind == kind; }));
}

// Three pairs of circles on axes that are nearly parallel, and a line that is nearly orthogonal to them.
std::vector<Measured_curve> nearly_regular(double error, double deviation)
{
  std::vector<Measured_curve> curves;
  for (int i = 0; i < 6; ++i)
  {
    Measured_curve circle;
    circle.curve.kind = Primitive_kind::CIRCLE;
    circle.curve.center = Vector(30. * (i / 2), 0., 10. * (i % 2)) + error * random_direction();
    circle.curve.axis = (Vector::UnitZ() + 0.05 * error * random_direction()).normalized();
    circle.curve.major = circle.curve.axis.unitOrthogonal();
    circle.curve.major_radius = circle.curve.minor_radius = 6. + error * uniform(-1., 1.);
    circle.position_deviation = circle.radius_deviation = deviation;
    circle.direction_deviation = 0.1 * deviation;
    curves.push_back(circle);
  }
  Measured_curve line;
  line.curve = Primitive_curve::line(Vector(0., 0., 20.), Vector(10., 0., 20. + 0.2 * error));
  line.position_deviation = deviation;
  line.direction_deviation = 0.1 * deviation;
  curves.push_back(line);
  return curves;
}

void test_regularities()
{
  for (int round = 0; round < 20; ++round)
  {
    const std::vector<Measured_curve> curves = nearly_regular(0.03, 0.06);
    const std::vector<Regularity> found = Regularity_finder(curves).run();
    assert(count(found, Regularity_kind::EQUAL_RADII) == 5 && count(found, Regularity_kind::COAXIAL) == 3);
    assert(count(found, Regularity_kind::PARALLEL) == 5 && count(found, Regularity_kind::ORTHOGONAL) == 1);
    // what is certain and differs is not regular
    std::vector<Measured_curve> different = nearly_regular(0., 0.001);
    for (std::size_t i = 0; i < 6; ++i)
      different[i].curve.major_radius += 0.1 * double(i);
    different[6].curve.axis = Vector(1., 0., 0.1).normalized();
    const std::vector<Regularity> fewer = Regularity_finder(different).run();
    assert(count(fewer, Regularity_kind::EQUAL_RADII) == 0 && count(fewer, Regularity_kind::ORTHOGONAL) == 0);
    assert(count(fewer, Regularity_kind::COAXIAL) == 3);

    Primitive_network_fit network;
    for (std::size_t i = 0; i < 6; ++i)
    {
      Primitive_edge edge;
      edge.kind = Primitive_kind::CIRCLE;
      edge.points = {{curves[i].curve.at(0.), curves[i].curve.at(2.), curves[i].curve.at(4.)}};
      edge.stations = stations_on(curves[i].curve, 0., 2. * pi, 24, 0.03);
      network.edges.push_back(edge);
    }
    for (const Regularity& regularity : found)
      if (regularity.curves[0] < 6 && regularity.curves[1] < 6)
        network.regularities.push_back(regularity);
    network.run();
    std::vector<Primitive_curve> fitted;
    for (Primitive_edge& edge : network.edges)
      fitted.push_back(edge.curve(network.vertices));
    for (std::size_t i = 0; i < 6; ++i)
    {
      assert(std::abs(fitted[i].major_radius - fitted[0].major_radius) < 1e-8);
      assert(fitted[i].axis.cross(fitted[0].axis).norm() < 1e-8);
      const Vector offset = fitted[i ^ 1].center - fitted[i].center;
      assert((offset - offset.dot(fitted[i].axis) * fitted[i].axis).norm() < 1e-8);
      assert((fitted[i].center - curves[i].curve.center).norm() < 0.1);
    }
  }
}

Measured_curve measured(const Primitive_curve& curve, double deviation)
{
  Measured_curve result;
  result.curve = curve;
  result.position_deviation = result.radius_deviation = deviation;
  result.direction_deviation = 0.1 * deviation;
  return result;
}

Primitive_curve circle_at(const Vector& center, const Vector& axis, double radius)
{
  Primitive_curve result;
  result.kind = Primitive_kind::CIRCLE;
  result.center = center;
  result.axis = axis.normalized();
  result.major = result.axis.unitOrthogonal();
  result.major_radius = result.minor_radius = radius;
  return result;
}

std::size_t count_between(const Primitive_curve& one, const Primitive_curve& two, double deviation,
                          Regularity_kind kind)
{
  const std::vector<Measured_curve> curves{measured(one, deviation), measured(two, deviation)};
  return count(Regularity_finder(curves).run(), kind);
}

// Three standard deviations of the difference decide, but never less than 0.02 r and 0.002 rad, or more than 0.3 r and
// 0.05 rad.
void test_bounds_of_regularities()
{
  struct Bound
  {
    double deviation, length, angle;
  };
  for (const Bound& bound :
       {Bound{0., 0.02, 0.002}, Bound{0.03, 0.09 * std::sqrt(2.), 0.009 * std::sqrt(2.)}, Bound{10., 0.3, 0.05}})
    for (const double factor : {0.97, 1.03})
    {
      const std::size_t holds = factor < 1. ? 1 : 0;
      const Primitive_curve circle = circle_at(Vector(1., 2., 3.), Vector(0., 0., 1.), 8.);
      const double length = factor * bound.length, angle = factor * bound.angle;
      const auto between = [&](const Primitive_curve& other, Regularity_kind kind) {
        return count_between(circle, other, bound.deviation, kind);
      };
      assert(between(circle_at(Vector(40., 0., 0.), Vector(0., 0., 1.), 8. + length), Regularity_kind::EQUAL_RADII)
             == holds);
      assert(between(circle_at(Vector(1., 2. + length, 30.), Vector(0., 0., 1.), 3.), Regularity_kind::COAXIAL)
             == holds);
      const Vector tilted(std::sin(angle), 0., std::cos(angle)), upright(std::cos(angle), 0., std::sin(angle));
      assert(between(circle_at(Vector(1., 2., 30.), tilted, 3.), Regularity_kind::COAXIAL) == holds);
      assert(between(circle_at(Vector(40., 0., 0.), tilted, 3.), Regularity_kind::PARALLEL) == holds);
      assert(between(circle_at(Vector(40., 0., 0.), -tilted, 3.), Regularity_kind::PARALLEL) == holds);
      assert(between(Primitive_curve::line(Vector::Zero(), 9. * tilted), Regularity_kind::PARALLEL) == holds);
      assert(between(circle_at(Vector(40., 0., 0.), upright, 3.), Regularity_kind::ORTHOGONAL) == holds);
      assert(between(Primitive_curve::line(Vector::Zero(), 9. * upright), Regularity_kind::ORTHOGONAL) == holds);
    }
}

void test_who_is_regular()
{
  // lines have no radii and ellipses nothing that others could have
  const Primitive_curve circle = circle_at(Vector::Zero(), Vector::UnitZ(), 8.);
  Primitive_curve ellipse = circle;
  ellipse.kind = Primitive_kind::ELLIPSE;
  const Primitive_curve line = Primitive_curve::line(Vector(0., 0., -1.), Vector(0., 0., 1.));
  for (const Regularity_kind kind :
       {Regularity_kind::EQUAL_RADII, Regularity_kind::COAXIAL, Regularity_kind::PARALLEL, Regularity_kind::ORTHOGONAL})
  {
    assert(count_between(circle, ellipse, 0.01, kind) == 0 && count_between(line, ellipse, 0.01, kind) == 0);
    assert(count_between(circle, line, 0.01, kind) == (kind == Regularity_kind::PARALLEL ? 1 : 0));
  }
  // all agree with the most certain of them, which comes first, and not in a chain
  std::vector<Measured_curve> chain;
  for (int i = 0; i < 4; ++i)
    chain.push_back(measured(circle_at(Vector(30. * i, 0., 0.), Vector::UnitZ(), 8. + 0.03 * i), 0.01));
  chain[1].radius_deviation = 0.001;
  std::vector<std::array<std::size_t, 2>> pairs;
  for (const Regularity& regularity : Regularity_finder(chain).run())
    if (regularity.kind == Regularity_kind::EQUAL_RADII)
      pairs.push_back(regularity.curves);
  std::sort(pairs.begin(), pairs.end());
  assert(pairs == (std::vector<std::array<std::size_t, 2>>{{{1, 0}}, {{1, 2}}}));
}

// Where the stations leave a curve for good at an end, turn back, or go round more than once, it is not the curve's.
void test_refused_courses()
{
  const Primitive_curve line = Primitive_curve::line(Vector::Zero(), Vector(1., 0., 0.));
  std::vector<Station> stations = stations_on(line, 0., 45., 30, 0.02);
  stations[15].position += Vector(0., 0.8, 0.);
  assert(cut(stations).size() == 1 && cut(stations)[0].is_line()); // an error in the middle
  stations.front().position += Vector(0., 1.5, 0.);
  const std::vector<Station> off = stations;
  const std::vector<Curve_piece> pieces =
    Curve_cutter(off, 0.7, {{off.front().position, off.back().position}}, false, 0.001).run();
  assert(pieces.size() > 1 || !pieces[0].fit); // its vertex is there, too
  // forth and back on one line
  const auto turning = [](double s) { return Vector(s < 20. ? s : 40. - s, 0., 0.); };
  for (const Curve_piece& piece : cut(stations_along(turning, 40., 0.02)))
    assert(!piece.fit || piece.size < 20);
  // one and a half times round
  const Primitive_curve circle = circle_at(Vector::Zero(), Vector::UnitZ(), 8.);
  for (const Curve_piece& piece : cut(stations_on(circle, 0., 3. * pi, 50, 0.02)))
    assert(!piece.fit || piece.size < 40);
}

} // namespace

int main()
{
  test_feet();
  test_through_points();
  test_probability();
  test_fits();
  test_outliers();
  test_kinds();
  test_support();
  test_cuts();
  test_splines_stay();
  test_common_fit();
  test_elliptic_arc();
  test_regularities();
  test_parts();
  test_cancelled_fit();
  test_bounds_of_regularities();
  test_who_is_regular();
  test_refused_courses();
  test_no_steps_and_kinks();
  test_arcs_in_a_row();
  test_ellipse_between_lines();
  test_outliers_where_windows_end();
  return 0;
}
