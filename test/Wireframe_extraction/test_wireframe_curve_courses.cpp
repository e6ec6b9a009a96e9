// No line, circle or ellipse leaves the points that it stands for, along its whole length; and
// cancelling the recognition.

#include <CGAL/Wireframe_extraction/internal/skeleton/complete_band.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_course.h>
#include <CGAL/Wireframe_extraction/internal/types/recognize_pieces.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

typedef std::vector<Vector> Polyline;

const double pi = CGAL_PI;

std::mt19937 generator(3);

double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(generator); }

// Two sides and the end that joins them, with rounded corners: far along, a very long ellipse fits the sides and leaves
// out the end.
Polyline u_shape(double half_width, double length, double rounding)
{
  const double step = 0.1, straight = half_width - rounding;
  Polyline half; // from the middle of the end to the end of a side
  for (double y = 0.; y < straight; y += step)
    half.push_back(Vector(0., y, 0.));
  for (double a = 0.; a < 0.5 * pi; a += step / rounding)
    half.push_back(Vector(rounding - rounding * std::cos(a), straight + rounding * std::sin(a), 0.));
  for (double x = rounding; x <= length; x += step)
    half.push_back(Vector(x, half_width, 0.));
  Polyline result;
  for (std::size_t i = half.size(); i-- > 1;)
    result.push_back(Vector(half[i].x(), -half[i].y(), 0.));
  result.insert(result.end(), half.begin(), half.end());
  return result;
}

double distance(const Vector& p, const Polyline& polyline)
{
  double nearest = (std::numeric_limits<double>::max)();
  for (const Vector& q : polyline)
    nearest = (std::min)(nearest, (p - q).norm());
  return nearest;
}

// The exact field around the edge of a plate of this outline: points on its plane and on its wall.
Skeleton_data field_around(const Polyline& outline)
{
  auto band = std::make_shared<Field_band>();
  const std::size_t count = 2 * outline.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector& foot = outline[std::size_t(uniform(0., double(outline.size())))];
    const Vector p =
      foot + (i % 2 == 0 ? Vector(uniform(-3., 3.), uniform(-3., 3.), 0.) : Vector(0., 0., -uniform(0., 3.)));
    const double d = distance(p, outline);
    if (d > 3.)
      continue;
    band->points.push_back(p);
    band->distances.push_back(d);
    band->indices.push_back(i);
  }
  complete_band(*band, 1.5);
  Skeleton_data result;
  result.band = band;
  return result;
}

Untyped_curve untyped(const Polyline& polyline)
{
  Untyped_curve result;
  result.polyline = polyline;
  result.vertices = {{0, 1}};
  result.number_of_parameters = 36.;
  return result;
}

Recognized_pieces recognized(const Skeleton_data& field, const Polyline& polyline, double noise, bool regularize,
                             const std::function<bool(double)>& proceed = {})
{
  Extraction_options options;
  options.noise_level = noise;
  options.regularize = regularize;
  std::vector<Untyped_curve> curves(1, untyped(polyline));
  return recognize_pieces(field, options, {polyline.front(), polyline.back()}, curves, proceed);
}

// of the piece, as it is written: from vertex through the middle to vertex
Polyline sampled(const Typed_piece& piece, const std::vector<Vector>& vertices)
{
  const Primitive_curve& shape = piece.shape;
  const Vector &source = vertices[piece.vertices[0]], &target = vertices[piece.vertices[1]];
  const double from = shape.parameter(source);
  const double size = shape.kind == Primitive_kind::LINE ? shape.parameter(target) - from
                                                         : shape.sweep(from, piece.middle, shape.parameter(target));
  Polyline result;
  for (int k = 0; k <= 200; ++k)
    result.push_back(shape.at_parameter(from + size * k / 200.));
  return result;
}

void test_nothing_runs_away()
{
  for (const double noise : {0.1, 0.3, 0.5})
    for (const double half_width : {6., 13.})
      for (const double length : {15., 25., 60.})
        for (const double rounding : {1., 0.5 * half_width, 0.9 * half_width})
        {
          const Polyline u = u_shape(half_width, length, rounding);
          const Skeleton_data field = field_around(u);
          for (const bool regularize : {false, true})
          {
            const Recognized_pieces found = recognized(field, u, noise, regularize);
            // where one curve for all runs away, the sides are lines
            assert(noise != 0.3 || half_width != 13. || length != 25. || rounding != 1. || found.pieces.size() > 1);
            for (const Typed_piece& piece : found.pieces)
              if (piece.is_primitive)
              {
                const Polyline samples = sampled(piece, found.vertices);
                for (const Vector& p : samples)
                  assert(distance(p, u) < 3.);
                // and nothing of what it stands for is left out
                const std::vector<double> lengths = arc_lengths(u);
                for (std::size_t i = 0; i < u.size(); ++i)
                  if (lengths[i] >= piece.range[0] && lengths[i] <= piece.range[1])
                    assert(distance(u[i], samples) < 3.5);
              }
          }
        }
}

// stations without errors, every 1.5 along a polyline
std::vector<Station> stations_on(const Polyline& polyline, double deviation = 0.05)
{
  std::vector<Station> result;
  const std::vector<double> lengths = arc_lengths(polyline);
  Polyline_walk walk(polyline, lengths);
  const std::size_t count = std::size_t(lengths.back() / 1.5);
  for (std::size_t i = 0; i < count; ++i)
  {
    Station station;
    station.parameter = lengths.back() * (double(i) + 0.5) / double(count);
    station.position = station.followed = walk.advance_to(station.parameter);
    station.tangent = walk.segment().normalized();
    station.information =
      (Matrix_3::Identity() - Matrix_3::outer(station.tangent, station.tangent)) / (deviation * deviation);
    station.support = 8;
    result.push_back(station);
  }
  return result;
}

Polyline sampled(const Primitive_curve& curve, double from, double to)
{
  Polyline result;
  const int count = int(std::abs(to - from) * (curve.kind == Primitive_kind::LINE ? 10. : 10. * curve.major_radius));
  for (int k = 0; k <= count; ++k)
    result.push_back(curve.at_parameter(from + (to - from) * k / count));
  return result;
}

Primitive_curve make(Primitive_kind kind)
{
  Primitive_curve result;
  result.kind = kind;
  result.center = Vector(1., 2., 3.);
  result.axis = Vector(1., 1., 2.).normalized();
  result.major = result.axis.unitOrthogonal();
  result.major_radius = 15.;
  result.minor_radius = kind == Primitive_kind::ELLIPSE ? 9. : 15.;
  return result;
}

bool follows(const Primitive_curve& curve, const std::vector<Station>& stations, const Polyline& polyline)
{
  return Primitive_course(curve).follows(Station_range(stations, 0, stations.size()),
                                         {curve.foot(polyline.front()), polyline.front()},
                                         {curve.foot(polyline.back()), polyline.back()});
}

// Whole curves and arcs of any size keep to themselves, and to what lies within the errors that are stated.
void test_right_courses()
{
  for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
    for (const double sweep : {-6., -4., -1., 0.5, 2., 3.3, 5., 6.2})
    {
      Primitive_curve curve = make(kind);
      const double factor = kind == Primitive_kind::LINE ? 10. : 1.;
      const Polyline polyline = sampled(curve, 0.3, 0.3 + factor * sweep);
      const std::vector<Station> stations = stations_on(polyline);
      assert(follows(curve, stations, polyline));
      assert(Primitive_course(curve).follows(Station_range(stations, 0, stations.size()), false));
      curve.center += 0.9 * Vector(1., 0., 0.);
      assert(follows(curve, stations, polyline));
    }
  for (const Primitive_kind kind : {Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
  {
    const Primitive_curve curve = make(kind);
    const Polyline polyline = sampled(curve, 0.3, 0.3 + 2. * pi);
    const std::vector<Station> stations = stations_on(polyline);
    const Station_range all(stations, 0, stations.size());
    assert(Primitive_course(curve).follows(all, true));
    assert(Primitive_course(curve).follows(all, {polyline.front(), polyline.front()}));
  }
}

void test_wrong_courses()
{
  // farther off than stations are known
  for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
  {
    Primitive_curve curve = make(kind);
    const Polyline polyline = sampled(curve, 0., kind == Primitive_kind::LINE ? 30. : 3.);
    const std::vector<Station> stations = stations_on(polyline), vague = stations_on(polyline, 0.3);
    curve.center += 1.8 * (kind == Primitive_kind::LINE ? curve.axis.unitOrthogonal() : curve.axis);
    assert(!follows(curve, stations, polyline));
    assert(follows(curve, vague, polyline));
  }
  // a half circle, and a long ellipse through both ends that goes round far away: all feet are near
  const Primitive_curve circle = make(Primitive_kind::CIRCLE);
  const Polyline half = sampled(circle, 0.5 * pi, 1.5 * pi);
  Primitive_curve ellipse = circle;
  ellipse.kind = Primitive_kind::ELLIPSE;
  ellipse.major_radius = 300.;
  assert(!follows(ellipse, stations_on(half), half));
  const Polyline u = u_shape(13., 25., 1.);
  Primitive_curve sides;
  sides.kind = Primitive_kind::ELLIPSE;
  sides.center = Vector(25., 0., 0.);
  sides.axis = Vector::UnitZ();
  sides.major = Vector::UnitX();
  sides.major_radius = 1500.;
  sides.minor_radius = 13.;
  assert(!follows(sides, stations_on(u), u));
  // the arc the other way round: the stations of one half, the middle of the other
  const Primitive_curve whole = make(Primitive_kind::CIRCLE);
  const Polyline two_rounds = sampled(whole, 0., 4. * pi + 1.);
  assert(!follows(whole, stations_on(two_rounds), two_rounds));
  // a circle that is not gone all round is not closed
  const std::vector<Station> most = stations_on(sampled(whole, 0., 1.4 * pi));
  assert(!Primitive_course(whole).follows(Station_range(most, 0, most.size()), true));
  // nor is one that is gone forth and back
  Polyline forth_and_back = sampled(whole, 0., 2.);
  forth_and_back.insert(forth_and_back.end(), forth_and_back.rbegin() + 1, forth_and_back.rend() - 1);
  const std::vector<Station> returning = stations_on(forth_and_back);
  assert(!Primitive_course(whole).follows(Station_range(returning, 0, returning.size()), true));
  // a vertex far from the end of the spline
  const std::vector<Station> at_half = stations_on(half);
  for (const double turn : {0.1, 0.3})
    assert(Primitive_course(whole).follows(Station_range(at_half, 0, at_half.size()),
                                           {whole.at(0.5 * pi - turn), half.front()}, {half.back(), half.back()})
           == (turn < 0.2));
  // what is not finite follows nothing
  Primitive_curve none = whole;
  none.major_radius = std::numeric_limits<double>::quiet_NaN();
  assert(!follows(none, stations_on(half), half));
}

// Over a gap a curve may differ from the spline that bridged it, but not go elsewhere.
void test_gaps()
{
  const Primitive_curve circle = make(Primitive_kind::CIRCLE);
  const Polyline arc = sampled(circle, 0., 4.);
  // the spline goes straight over a gap of 15 r; the circle goes round
  Polyline bridged = sampled(circle, 0., 1.5);
  const Polyline rest = sampled(circle, 2.5, 4.);
  const Vector from = bridged.back(), to = rest.front();
  for (int k = 1; k < 100; ++k)
    bridged.push_back(from + (to - from) * k / 100.);
  bridged.insert(bridged.end(), rest.begin(), rest.end());
  std::vector<Station> stations = stations_on(bridged);
  assert(!follows(circle, stations, bridged));
  for (Station& station : stations)
    if (std::abs((station.position - circle.center).norm() - 15.) > 0.05)
    {
      station.support = 0;
      station.information = Matrix_3::Zero();
    }
  assert(follows(circle, stations, bridged));
  // a gap between the sides of the long ellipse is none that it may leave the part over
  const Polyline u = u_shape(13., 25., 1.);
  std::vector<Station> open = stations_on(u);
  for (Station& station : open)
    if (station.position.x() < 1.)
    {
      station.support = 0;
      station.information = Matrix_3::Zero();
    }
  Primitive_curve sides;
  sides.kind = Primitive_kind::ELLIPSE;
  sides.center = Vector(25., 0., 0.);
  sides.axis = Vector::UnitZ();
  sides.major = Vector::UnitX();
  sides.major_radius = 1500.;
  sides.minor_radius = 13.;
  assert(!follows(sides, open, u));
}

// Wherever it is cancelled, nothing is asked afterwards, and nothing comes back.
void test_cancelling()
{
  const Polyline u = u_shape(13., 40., 6.);
  const Skeleton_data field = field_around(u);
  std::size_t calls = 0;
  double last = 0.;
  const Recognized_pieces all = recognized(field, u, 0.05, true, [&](double share) {
    assert(share >= last && share <= 1.);
    last = share;
    ++calls;
    return true;
  });
  assert(!all.is_cancelled && !all.pieces.empty());
  assert(calls > 20 && last > 0.5); // while the curve is cut, and in the common fit
  for (std::size_t most = 0; most < calls; most += most < 10 ? 1 : 7)
  {
    std::size_t count = 0;
    const Recognized_pieces none = recognized(field, u, 0.05, true, [&](double) { return ++count <= most; });
    assert(none.is_cancelled && none.pieces.empty() && none.regularities.empty());
    assert(count == most + 1);
  }
}

// Two lines of length 20 and two half circles of radius 6, from somewhere on.
Polyline slot(double start)
{
  Polyline result;
  const double half = 6. * pi, period = 40. + 2. * half;
  const int count = 800;
  for (int k = 0; k < count; ++k)
  {
    double s = std::fmod(start + period * k / count, period);
    const double sign = s < 20. + half ? 1. : -1.;
    s = sign > 0. ? s : s - 20. - half;
    result.push_back(sign
                     * (s < 20. ? Vector(s - 10., -6., 0.)
                                : Vector(10. + 6. * std::sin((s - 20.) / 6.), -6. * std::cos((s - 20.) / 6.), 0.)));
  }
  result.push_back(result.front());
  return result;
}

// A closed curve is cut where its pieces meet, wherever it starts: neighbors share vertices and tangents there. A
// vertex that only chance put on it is left out.
void test_closed_curve()
{
  for (const double start : {3., 10., 25., 47.})
    for (const bool has_vertex : {false, true})
    {
      const Polyline outline = slot(start);
      const Skeleton_data field = field_around(outline);
      Extraction_options options;
      options.noise_level = 0.02;
      std::vector<Untyped_curve> curves(1, untyped(outline));
      if (has_vertex)
        curves[0].vertices = {{0, 0}};
      else
        curves[0].vertices = {{Untyped_curve::no_vertex, Untyped_curve::no_vertex}};
      const Recognized_pieces found = recognize_pieces(field, options, {outline.front()}, curves, {});
      assert(found.pieces.size() == 4 && found.regularities.empty());
      std::size_t support = 0;
      for (const Typed_piece& piece : found.pieces)
        support += piece.support;
      for (std::size_t i = 0; i < 4; ++i)
      {
        // as much of the support as of the length, also of the piece in which the curve starts
        const double share = (found.pieces[i].range[1] - found.pieces[i].range[0]) / (40. + 12. * pi);
        assert(double(found.pieces[i].support) > 0.7 * share * double(support));
        const Typed_piece &piece = found.pieces[i], &next = found.pieces[(i + 1) % 4];
        assert(piece.is_primitive && !piece.is_whole && piece.curve == 0 && piece.support > 20);
        assert(piece.shape.kind != next.shape.kind && piece.vertices[1] == next.vertices[0]);
        assert(piece.vertices[0] != 0);
        const Vector& place = found.vertices[piece.vertices[1]];
        assert((piece.shape.foot(place) - place).norm() < 1e-6);
        assert(piece.shape.tangent(place).cross(next.shape.tangent(place)).norm() < 1e-5);
        if (piece.shape.kind == Primitive_kind::CIRCLE)
        {
          assert(std::abs(piece.shape.major_radius - 6.) < 0.1);
          assert(piece.major_radius_deviation > 0. && piece.major_radius_deviation < 0.1);
        }
        assert(piece.root_mean_square < 0.1 && piece.maximum_deviation >= piece.root_mean_square);
      }
    }
}

// Two circles of nearly the same radius, on one plane.
void test_regularizing()
{
  std::vector<Polyline> outlines;
  Polyline both;
  for (const double radius : {8., 8.012})
  {
    Primitive_curve circle;
    circle.kind = Primitive_kind::CIRCLE;
    circle.center = Vector(both.empty() ? 0. : 40., 0., 0.);
    circle.major_radius = circle.minor_radius = radius;
    outlines.push_back(sampled(circle, 0., 2. * pi));
    outlines.back().back() = outlines.back().front();
    both.insert(both.end(), outlines.back().begin(), outlines.back().end());
  }
  const Skeleton_data field = field_around(both);
  for (const bool regularize : {false, true})
  {
    Extraction_options options;
    options.noise_level = 0.05;
    options.regularize = regularize;
    std::vector<Untyped_curve> curves;
    for (const Polyline& outline : outlines)
    {
      curves.push_back(untyped(outline));
      curves.back().vertices = {{Untyped_curve::no_vertex, Untyped_curve::no_vertex}};
    }
    const Recognized_pieces found = recognize_pieces(field, options, {}, curves, {});
    assert(found.pieces.size() == 2);
    for (const Typed_piece& piece : found.pieces)
      assert(piece.is_primitive && piece.is_whole && piece.shape.kind == Primitive_kind::CIRCLE);
    const double difference = std::abs(found.pieces[0].shape.major_radius - found.pieces[1].shape.major_radius);
    assert(regularize ? difference < 1e-7 : difference > 1e-4);
    assert(regularize == !found.regularities.empty());
    if (regularize)
      assert(std::count(found.regularities.begin(), found.regularities.end(), "equal radii: curves 0, 1")
               + std::count(found.regularities.begin(), found.regularities.end(), "equal radii: curves 1, 0")
             == 1);
  }
}

// A line and an arc that goes on from it are tangent; a corner that the network has stays one.
void test_line_and_arc()
{
  Polyline hook;
  for (double s = 0.; s < 40.; s += 0.1)
    hook.push_back(s < 20. ? Vector(s, 0., 0.)
                           : Vector(20. + 10. * std::sin(0.1 * (s - 20.)), 10. - 10. * std::cos(0.1 * (s - 20.)), 0.));
  const Skeleton_data field = field_around(hook);
  const Recognized_pieces found = recognized(field, hook, 0.02, false);
  assert(found.pieces.size() == 2 && found.vertices.size() == 3);
  const Typed_piece &line = found.pieces[0], &arc = found.pieces[1];
  assert(line.is_primitive && line.shape.kind == Primitive_kind::LINE && line.vertices[0] == 0);
  assert(arc.is_primitive && arc.shape.kind == Primitive_kind::CIRCLE && arc.vertices[1] == 1);
  assert(line.vertices[1] == 2 && arc.vertices[0] == 2 && (found.vertices[2] - Vector(20., 0., 0.)).norm() < 2.);
  assert(line.shape.axis.cross(arc.shape.tangent(found.vertices[2])).norm() < 1e-5);
  assert(std::abs(arc.shape.major_radius - 10.) < 0.2);
}

// Points that the field is plainly wrong about say nothing of how well a curve fits.
void test_residuals_of_outliers()
{
  Polyline line;
  for (double x = 0.; x < 40.; x += 0.1)
    line.push_back(Vector(x, 0., 0.));
  const Skeleton_data field = field_around(line);
  auto band = std::make_shared<Field_band>();
  band->points = field.band->points;
  band->distances = field.band->distances;
  band->indices = field.band->indices;
  for (std::size_t i = 0; i < band->size(); i += 9)
    band->distances[i] = std::abs(2.5 - band->distances[i]);
  complete_band(*band, 1.5);
  Skeleton_data wrong;
  wrong.band = band;
  const Recognized_pieces found = recognized(wrong, line, 0.05, false);
  assert(found.pieces.size() == 1 && found.pieces[0].is_primitive);
  assert(found.pieces[0].support > 100 && found.pieces[0].maximum_deviation <= residual_cutoff(0.05));
}

// A spline that is cut from a line goes on in its direction, whichever way the curve runs.
void test_tangents_of_splines()
{
  Polyline curve;
  for (double s = 0.; s < 20.; s += 0.1)
    curve.push_back(Vector(s, 0., 0.));
  for (double s = 0.; s < 40.; s += 0.1) // turns more and more, out of the plane
    curve.push_back(Vector(20. + s - 0.004 * s * s, 0.004 * s * s * s / 3., 0.0006 * s * s * s));
  for (const bool is_reversed : {false, true})
  {
    if (is_reversed)
      std::reverse(curve.begin(), curve.end());
    const Recognized_pieces found = recognized(field_around(curve), curve, 0.02, false);
    std::size_t checked = 0;
    for (std::size_t i = 1; i < found.pieces.size(); ++i)
    {
      const Typed_piece &before = found.pieces[i - 1], &after = found.pieces[i];
      const Typed_piece &line = is_reversed ? after : before, &spline = is_reversed ? before : after;
      if (!line.is_primitive || line.shape.kind != Primitive_kind::LINE || spline.is_primitive)
        continue;
      ++checked;
      const Vector onward = is_reversed ? Vector(-Vector::UnitX()) : Vector(Vector::UnitX());
      assert(spline.end_tangents[is_reversed ? 1 : 0].dot(onward) > 0.99);
    }
    assert(checked == 1);
  }
}

} // namespace

int main()
{
  test_right_courses();
  test_wrong_courses();
  test_gaps();
  test_nothing_runs_away();
  test_closed_curve();
  test_regularizing();
  test_line_and_arc();
  test_cancelling();
  test_residuals_of_outliers();
  test_tangents_of_splines();
  return 0;
}
