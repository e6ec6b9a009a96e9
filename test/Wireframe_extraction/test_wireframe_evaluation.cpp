// Wireframe_evaluation: every score where its value is known in closed form.

#include "evaluated_curves.h"

#include <Wireframe_evaluation/evaluate_wireframe.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace {

// Distances ------------------------------------------------------------------------------------------

void test_parallel_segments()
{
  for (double e : {0., 0.05, 0.15, 0.25})
  {
    const Wireframe_scores s =
      scores_of({segment(Point(0, 0, 0), Point(10, 0, 0))}, {segment(Point(0, e, 0), Point(10, e, 0))});
    assert(s.failure.empty());
    check_near(s.chamfer_distance, e, 1e-12);
    check_near(s.hausdorff_distance, e, 1e-12);
    assert(s.recall_at_1r == (e < r) && s.precision_at_1r == (e < r) && s.f1_at_1r == (e < r));
    assert(s.recall_at_2r == (e < 2 * r) && s.precision_at_2r == (e < 2 * r) && s.f1_at_2r == (e < 2 * r));
    assert(s.curve_f1 == (e < 2 * r));
    // the side of 10 becomes one of 2; squares are added
    check_near(s.squared_chamfer_unit_cube, 2 * (e / 5) * (e / 5), 1e-12);
    check_near(s.averaged_hausdorff_unit_cube, e / 5, 1e-12);
    check_near(s.diagonal, 10, 1e-12);
    assert(s.sampling_distance == r);
  }
}

// A segment pushed along itself by a: on either side, the distances go from a to 0 on a part of length a.
void test_pushed_segment()
{
  const double a = 2, length = 10;
  const Wireframe_scores s =
    scores_of({segment(Point(0, 0, 0), Point(length, 0, 0))}, {segment(Point(a, 0, 0), Point(length + a, 0, 0))});
  check_near(s.chamfer_distance, a * a / 2 / length, 2e-3);
  check_near(s.hausdorff_distance, a, 1e-12);
  check_near(s.squared_chamfer_unit_cube, 2 * a * a * a / 3 / length / 25, 1e-3);
  check_near(s.averaged_hausdorff_unit_cube, a / 5, 1e-12);
  check_near(s.recall_at_1r, (length - a + r) / length, 2e-3);
  check_near(s.precision_at_2r, (length - a + 2 * r) / length, 2e-3);
  assert(s.curve_recall == 0 && s.curve_precision == 0 && s.curve_f1 == 0);
}

// A part only: one side is all right, the other not.
void test_one_sided()
{
  const Wireframe_scores s =
    scores_of({segment(Point(0, 0, 0), Point(10, 0, 0))}, {segment(Point(0, 0, 0), Point(6, 0, 0))});
  check_near(s.chamfer_distance, 0.5 * (16. / 2 / 10), 3e-3); // mean of 0.8 and 0
  check_near(s.hausdorff_distance, 4, 1e-12);
  check_near(s.averaged_hausdorff_unit_cube, 0.5 * 4 / 5, 1e-12); // where the larger one would be 0.8
  assert(s.precision_at_1r == 1);
  check_near(s.recall_at_1r, 0.61, 2e-3);
  check_near(s.f1_at_1r, 2 * 0.61 / 1.61, 2e-3);
}

void test_circles()
{
  const double e = 0.07;
  const Wireframe_scores s = scores_of({circle(3)}, {circle(3 + e)});
  check_near(s.chamfer_distance, e, 1e-4); // the circles are polygons
  check_near(s.hausdorff_distance, e, 1e-4);
  check_near(s.squared_chamfer_unit_cube, 2 * e * e / 9, 1e-4);
  check_near(s.averaged_hausdorff_unit_cube, e / 3, 1e-4);
  assert(s.curve_f1 == 1 && s.curve_count_ratio == 1);
}

// The mean is over the length, however the points are spread on a polyline.
void test_uneven_points()
{
  std::vector<Point> points;
  for (int i = 0; i <= 1000; ++i)
    points.emplace_back(i * 1e-3, 0, 0);
  points.emplace_back(10, 0, 0);
  const std::vector<Evaluated_curve> truth = {segment(Point(0, 0, 0), Point(10, 0, 0))};
  const Wireframe_scores even = scores_of(truth, {segment(Point(0, 0, 0), Point(10, 1, 0))});
  for (Point& p : points)
    p = Point(p.x(), p.x() / 10, 0);
  const Wireframe_scores uneven = scores_of(truth, {curve(points)});
  check_near(uneven.chamfer_distance, even.chamfer_distance, 1e-9);
  check_near(uneven.precision_at_1r, even.precision_at_1r, 2e-3);
}

// The unit of the cloud changes no share, and lengths in proportion.
void test_scale()
{
  const double factor = 1000;
  const auto scaled = [](double f) {
    True_wireframe truth = truth_of({segment(Point(0, 0, 0), Point(10 * f, 0, 0))});
    truth.sampling_distance = r * f;
    return evaluate_wireframe(truth, prediction_of({segment(Point(0, 0.05 * f, 0), Point(9 * f, 0.3 * f, 0))}));
  };
  const Wireframe_scores a = scaled(1), b = scaled(factor);
  check_near(b.chamfer_distance, factor * a.chamfer_distance, 1e-6);
  check_near(b.hausdorff_distance, factor * a.hausdorff_distance, 1e-6);
  check_near(b.f1_at_1r, a.f1_at_1r, 1e-2);
  check_near(b.squared_chamfer_unit_cube, a.squared_chamfer_unit_cube, 1e-9);
  check_near(b.averaged_hausdorff_unit_cube, a.averaged_hausdorff_unit_cube, 1e-9);
}

// Corners --------------------------------------------------------------------------------------------

// A right angle whose corner and ends are moved up by `shift`.
Wireframe_scores scores_of_angle(double shift)
{
  const std::vector<Point> corners = {Point(5, 0, 0), Point(0, 0, 0), Point(0, 5, 0)};
  std::vector<Point> vertices;
  for (const Point& p : corners)
    vertices.push_back(p + Vector(0, 0, shift));
  return evaluate_wireframe(
    truth_of({segment(corners[0], corners[1]), segment(corners[1], corners[2])}, corners),
    prediction_of({curve({vertices[0], vertices[1]}, 0, 1), curve({vertices[1], vertices[2]}, 1, 2)}, vertices));
}

void test_corners()
{
  const Wireframe_scores near = scores_of_angle(2.9 * r), far = scores_of_angle(3.1 * r);
  assert(near.true_corners == 3 && near.predicted_corners == 3);
  assert(near.corner_recall == 1 && near.corner_precision == 1);
  assert(far.corner_recall == 0 && far.corner_precision == 0);

  // no corners on either side is right, on one side it is not
  const Wireframe_scores none = scores_of({circle(2)}, {circle(2)});
  assert(none.corner_recall == 1 && none.corner_precision == 1 && none.predicted_corners == 0);
  const Wireframe_scores missing =
    evaluate_wireframe(truth_of({circle(2)}, {Point(2, 0, 0)}), prediction_of({circle(2)}));
  assert(missing.corner_recall == 0 && missing.corner_precision == 0);
  const std::vector<Point> half = {Point(2, 0, 0), Point(-2, 0, 0)};
  const Wireframe_scores extra =
    evaluate_wireframe(truth_of({circle(2)}), prediction_of({curve(arc(2, 0, pi), 0, 1)}, half));
  assert(extra.corner_recall == 1 && extra.corner_precision == 0 && extra.predicted_corners == 2);

  // a list of corners counts where there are no vertices
  Predicted_wireframe prediction = prediction_of({circle(2)});
  prediction.corners = {Point(2, 0, r), Point(7, 0, 0)};
  const Wireframe_scores listed = evaluate_wireframe(truth_of({circle(2)}, {Point(2, 0, 0)}), prediction);
  assert(listed.corner_recall == 1 && listed.corner_precision == 0.5);
}

void test_greedy()
{
  // the closest pair is taken first, though the other way round two pairs could be made
  const std::vector<Point> truth = {Point(0, 0, 0), Point(2, 0, 0)};
  const std::vector<Match> matches = match_corners(truth, {Point(1.2, 0, 0), Point(3.5, 0, 0)}, 3);
  assert(matches.size() == 1 && matches[0] == Match(1, 0));
  // each corner once
  assert(match_corners(truth, {Point(0.1, 0, 0), Point(0.2, 0, 0), Point(0.3, 0, 0)}, 3).size() == 2);
  // the bound itself is too far
  assert(match_corners({Point(0, 0, 0)}, {Point(3, 0, 0)}, 3).empty());
  assert(match_corners({}, truth, 3).empty() && match_corners(truth, {}, 3).empty());

  // curves, too: the closer one of two
  const std::vector<Evaluated_curve> curves = {segment(Point(0, 0.15, 0), Point(5, 0.15, 0)),
                                               segment(Point(0, 0.05, 0), Point(5, 0.05, 0))};
  const std::vector<Match> pairs = match_curves({segment(Point(0, 0, 0), Point(5, 0, 0))}, curves, 2 * r, 0.1 * r);
  assert(pairs.size() == 1 && pairs[0] == Match(0, 1));
}

// Curves ---------------------------------------------------------------------------------------------

void test_missing_and_extra_curves()
{
  const Evaluated_curve a = segment(Point(0, 0, 0), Point(10, 0, 0)), b = segment(Point(0, 5, 0), Point(10, 5, 0)),
                        c = segment(Point(0, 9, 0), Point(10, 9, 0)),
                        small = segment(Point(0, -3, 0), Point(0.5, -3, 0));
  const Wireframe_scores missing = scores_of({a, b, c}, {b, a});
  check_near(missing.curve_recall, 2. / 3, 1e-12);
  assert(missing.curve_precision == 1);
  check_near(missing.curve_f1, 0.8, 1e-12);
  check_near(missing.curve_count_ratio, 2. / 3, 1e-12);
  check_near(missing.long_curve_recall, 2. / 3, 1e-12);
  check_near(missing.hausdorff_distance, 4, 1e-12);

  const Wireframe_scores extra = scores_of({a}, {a, b});
  assert(extra.curve_recall == 1 && extra.curve_precision == 0.5 && extra.curve_count_ratio == 2);
  check_near(extra.hausdorff_distance, 5, 1e-12);
  check_near(extra.precision_at_1r, 0.5, 1e-12);
  assert(extra.recall_at_1r == 1);

  // twice the same curve is one too many
  const Wireframe_scores twice = scores_of({a}, {a, a});
  assert(twice.curve_recall == 1 && twice.curve_precision == 0.5);
  check_near(twice.chamfer_distance, 0, 1e-12);

  // a missing curve of 5 r is none of the long ones
  const Wireframe_scores without_small = scores_of({a, small}, {a});
  assert(without_small.curve_recall == 0.5 && without_small.long_curve_recall == 1);
  assert(scores_of({small}, {b}).long_curve_recall == 1);
}

// A curve cut in two at a vertex at which it turns.
Wireframe_scores scores_of_turn(double degrees)
{
  const double a = degrees * pi / 180;
  const std::vector<Point> p = {Point(-5, 0, 0), Point(0, 0, 0), Point(5 * std::cos(a), 5 * std::sin(a), 0)};
  return evaluate_wireframe(truth_of({curve(p)}, {p[0], p[2]}),
                            prediction_of({curve({p[0], p[1]}, 0, 1), curve({p[2], p[1]}, 2, 1)}, p));
}

void test_chaining()
{
  for (double degrees : {0., 10., 19.})
  {
    const Wireframe_scores s = scores_of_turn(degrees);
    assert(s.predicted_curves == 2 && s.predicted_chains == 1 && s.curve_f1 == 1 && s.curve_count_ratio == 1);
    assert(s.predicted_corners == 2 && s.corner_recall == 1 && s.corner_precision == 1);
  }
  for (double degrees : {21., 90.})
  {
    const Wireframe_scores s = scores_of_turn(degrees);
    assert(s.predicted_chains == 2 && s.curve_recall == 0 && s.curve_precision == 0);
    assert(s.predicted_corners == 3 && s.corner_recall == 1);
    check_near(s.corner_precision, 2. / 3, 1e-12);
  }

  // at a vertex of degree 3 nothing is joined
  const std::vector<Point> p = {Point(-5, 0, 0), Point(0, 0, 0), Point(5, 0, 0), Point(0, 5, 0)};
  const Chained_curves star =
    chain_curves({curve({p[0], p[1]}, 0, 1), curve({p[1], p[2]}, 1, 2), curve({p[1], p[3]}, 1, 3)}, 0.5 * r, 20);
  assert(star.curves.size() == 3 && star.vertices.size() == 4);
}

void test_cycles()
{
  // a circle of four arcs, passed in both directions, is one closed curve without corners
  std::vector<Point> vertices;
  for (int i = 0; i < 4; ++i)
    vertices.push_back(arc(2, i * pi / 2, (i + 1) * pi / 2).front());
  std::vector<Evaluated_curve> arcs;
  for (std::size_t i = 0; i < 4; ++i)
  {
    std::vector<Point> points = arc(2, double(i) * pi / 2, double(i + 1) * pi / 2);
    points.front() = vertices[i];
    points.back() = vertices[(i + 1) % 4];
    arcs.push_back(i % 2 == 0 ? curve(points, i, (i + 1) % 4)
                              : curve(std::vector<Point>(points.rbegin(), points.rend()), (i + 1) % 4, i));
  }
  const Chained_curves chained = chain_curves(arcs, 0.5 * r, 20);
  assert(chained.curves.size() == 1 && chained.vertices.empty() && chained.curves[0].is_closed);
  check_near(chained.curves[0].polyline.length(), 4 * pi, 1e-3);
  assert(chained.curves[0].polyline.front() == chained.curves[0].polyline.back());
  const Wireframe_scores s = evaluate_wireframe(truth_of({circle(2)}), prediction_of(arcs, vertices));
  assert(s.curve_f1 == 1 && s.predicted_chains == 1 && s.predicted_corners == 0 && s.corner_precision == 1);

  // so is one arc around that ends where it starts; with a kink there it is open, and has a corner
  const Chained_curves loop = chain_curves({curve(circle(2).polyline.points(), 0, 0)}, 0.5 * r, 20);
  assert(loop.curves.size() == 1 && loop.curves[0].is_closed && loop.vertices.empty());
  const Chained_curves drop =
    chain_curves({curve({Point(0, 0, 0), Point(3, 1, 0), Point(3, -1, 0), Point(0, 0, 0)}, 0, 0)}, 0.5 * r, 20);
  assert(drop.curves.size() == 1 && !drop.curves[0].is_closed && drop.vertices.size() == 1);

  // what is marked as closed has no ends, and its vertex is no corner
  Evaluated_curve marked = curve(circle(2).polyline.points(), 0, 0);
  marked.is_closed = true;
  const Chained_curves closed = chain_curves({marked}, 0.5 * r, 20);
  assert(closed.curves.size() == 1 && closed.curves[0].is_closed && closed.vertices.empty());

  // a square keeps its corners, whatever its curves are named first
  const std::vector<Point> q = {Point(0, 0, 0), Point(4, 0, 0), Point(4, 4, 0), Point(0, 4, 0)};
  const Chained_curves square = chain_curves(
    {curve({q[2], q[3]}, 2, 3), curve({q[0], q[1]}, 0, 1), curve({q[2], q[1]}, 2, 1), curve({q[3], q[0]}, 3, 0)},
    0.5 * r, 20);
  assert(square.curves.size() == 4 && square.vertices.size() == 4);
}

void test_end_gap()
{
  const std::vector<Point> vertices = {Point(0, 0, 0), Point(10, 0, 0.25)};
  const Evaluated_curve c = curve({Point(0, 0, 0), Point(10, 0, 0)}, 0, 1);
  check_near(evaluate_wireframe(truth_of({c}), prediction_of({c}, vertices)).end_gap, 0.25, 1e-12);
  Evaluated_curve open_circle = curve(arc(1, 0, pi));
  open_circle.is_closed = true;
  check_near(scores_of({circle(1)}, {open_circle}).end_gap, 2, 1e-12);
  assert(scores_of({circle(1)}, {circle(1)}).end_gap == 0);
}

// Types ----------------------------------------------------------------------------------------------

void test_types()
{
  const Evaluated_curve line = with_kind(segment(Point(0, 0, 0), Point(10, 0, 0)), Curve_kind::LINE);
  const Evaluated_curve ring = with_kind(circle(3, Point(20, 0, 0)), Curve_kind::CIRCLE);
  const Evaluated_curve free_form = curve(arc(4, 0, 1, Point(0, 20, 0)));
  True_wireframe truth = truth_of({line, ring, free_form});
  truth.segments = truth.curves;

  // no types at all: nothing to say
  const Wireframe_scores untyped = evaluate_wireframe(
    truth, prediction_of({with_kind(line, Curve_kind::SPLINE), with_kind(ring, Curve_kind::SPLINE)}));
  assert(std::isnan(untyped.typed_recall) && std::isnan(untyped.typed_precision));
  assert(std::isnan(untyped.splines_called_primitive) && std::isnan(untyped.radius_error));

  const Wireframe_scores right = evaluate_wireframe(truth, prediction_of(truth.curves));
  assert(right.typed_recall == 1 && right.typed_precision == 1 && right.splines_called_primitive == 0);
  check_near(right.radius_error, 0, 1e-9);

  const Wireframe_scores swapped = evaluate_wireframe(
    truth, prediction_of({with_kind(line, Curve_kind::CIRCLE), ring, with_kind(free_form, Curve_kind::CIRCLE)}));
  assert(swapped.typed_recall == 0.5 && swapped.splines_called_primitive == 1);
  check_near(swapped.typed_precision, 1. / 3, 1e-12);

  const Evaluated_curve larger = with_kind(circle(3.03, Point(20, 0, 0)), Curve_kind::CIRCLE);
  check_near(evaluate_wireframe(truth, prediction_of({larger})).radius_error, 0.03, 1e-6);
  assert(evaluate_wireframe(truth, prediction_of({larger})).typed_recall == 0.5);

  // a line in two pieces is one line; two lines that turn by 15 degrees are two
  const std::vector<Point> v = {Point(0, 0, 0), Point(4, 0, 0), Point(10, 0, 0)};
  const Evaluated_curve first = with_kind(curve({v[0], v[1]}, 0, 1), Curve_kind::LINE);
  const Evaluated_curve second = with_kind(curve({v[1], v[2]}, 1, 2), Curve_kind::LINE);
  const Wireframe_scores pieces = evaluate_wireframe(truth, prediction_of({first, second}, v));
  assert(pieces.typed_recall == 0.5 && pieces.typed_precision == 1);
  const Wireframe_scores mixed =
    evaluate_wireframe(truth, prediction_of({first, with_kind(second, Curve_kind::SPLINE)}, v));
  assert(mixed.typed_recall == 0);

  // the truth in pieces counts as one, too
  True_wireframe cut = truth_of({line});
  cut.segments = {with_kind(segment(v[0], v[1]), Curve_kind::LINE), with_kind(segment(v[2], v[1]), Curve_kind::LINE)};
  assert(evaluate_wireframe(cut, prediction_of({line})).typed_recall == 1);
  // two arcs of different circles do not
  cut.segments = {with_kind(curve(arc(3, 0, 1)), Curve_kind::CIRCLE),
                  with_kind(curve(arc(1, 1, 2.5, Point(2 * std::cos(1.), 2 * std::sin(1.), 0))), Curve_kind::CIRCLE)};
  cut.curves = cut.segments;
  assert(evaluate_wireframe(cut, prediction_of(cut.segments)).typed_recall == 1);

  // primitives shorter than 8 r need not be found
  True_wireframe tiny = truth_of({line});
  tiny.segments = {with_kind(segment(Point(0, 0, 0), Point(7 * r, 0, 0)), Curve_kind::LINE)};
  assert(evaluate_wireframe(tiny, prediction_of({line})).typed_recall == 1);

  assert(curve_kind("arc") == Curve_kind::CIRCLE && curve_kind("elliptic_arc") == Curve_kind::ELLIPSE);
  assert(curve_kind("bspline") == Curve_kind::SPLINE && curve_kind("anything") == Curve_kind::SPLINE);
}

void test_circle_through_polyline()
{
  const Circle c = circle_through_polyline(curve(arc(2, 0.3, 2, Point(1, 2, 3))).polyline, false);
  check_near(c.radius, 2, 1e-6);
  check_near(distance(c.center, Point(1, 2, 3)), 0, 1e-5);
  check_near(circle_through_polyline(circle(5).polyline, true).radius, 5, 1e-6);
  assert(std::isinf(circle_through_polyline(segment(Point(0, 0, 0), Point(1, 1, 1)).polyline, false).radius));
}

// Failures -------------------------------------------------------------------------------------------

void test_failures()
{
  const True_wireframe truth = truth_of({segment(Point(0, 0, 0), Point(3, 4, 0))}, {Point(0, 0, 0), Point(3, 4, 0)});
  check_failed(evaluate_wireframe(truth, Predicted_wireframe()), 5);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (double bad : {nan, infinity, 1e300})
  {
    check_failed(evaluate_wireframe(truth, prediction_of({segment(Point(0, 0, 0), Point(bad, -bad, 0))})), 5);
    if (bad != 1e300)
      check_failed(evaluate_wireframe(truth, prediction_of(truth.curves, {Point(bad, 0, 0)})), 5);
  }
  check_failed(evaluate_wireframe(truth, "no such file"), 5);

  // far off is no failure, and takes no time without end
  const Wireframe_scores huge = evaluate_wireframe(truth, prediction_of({segment(Point(0, 0, 0), Point(1e12, 0, 0))}));
  assert(huge.failure.empty() && huge.hausdorff_distance > 9e11);
  // a curve that is a point
  const Wireframe_scores point = evaluate_wireframe(truth, prediction_of({segment(Point(0, 0, 0), Point(0, 0, 0))}));
  assert(point.failure.empty());
  check_near(point.hausdorff_distance, 5, 1e-12);
}

// Parts ----------------------------------------------------------------------------------------------

void test_polyline()
{
  const Polyline p({Point(0, 0, 0), Point(1, 0, 0), Point(1, 0, 0), Point(1, 2, 0)});
  assert(p.points().size() == 3 && p.length() == 3);
  assert(p.point_at(0) == Point(0, 0, 0) && p.point_at(3) == Point(1, 2, 0) && p.point_at(99) == Point(1, 2, 0));
  check_near(distance(p.point_at(2), Point(1, 1, 0)), 0, 1e-12);
  const std::vector<Point> samples = p.sample(0.7); // five pieces of 0.6
  assert(samples.size() == 6 && samples.front() == p.front() && samples.back() == p.back());
  for (std::size_t i = 0; i < samples.size(); ++i)
    check_near(distance(samples[i], p.point_at(0.6 * double(i))), 0, 1e-12);
  assert(p.sample(100).size() == 2 && p.sample(1).size() == 4);
  check_near(distance(Point(0, 0, 0) + p.direction_from_end(true, 0.5), Point(0, -1, 0)), 0, 1e-12);
  const Vector d = p.direction_from_end(false, std::sqrt(2.)); // towards (1, 1, 0)
  check_near(d.x(), std::sqrt(0.5), 1e-12);
  check_near(d.y(), std::sqrt(0.5), 1e-12);
  check_near(p.direction_from_end(false, 10).y(), 2 / std::sqrt(5.), 1e-12); // to the other end
  assert(p.reversed().front() == p.back());
  const Polyline point({Point(1, 1, 1)});
  assert(point.length() == 0 && point.sample(1).size() == 2 && point.direction_from_end(false, 1) == Vector(0, 0, 0));
}

void test_bspline()
{
  // a quarter of a circle
  Bspline b;
  b.degree = 2;
  b.knots = {0, 0, 0, 1, 1, 1};
  b.control_points = {Point(2, 0, 0), Point(2, 2, 0), Point(0, 2, 0)};
  b.weights = {1, std::sqrt(0.5), 1};
  b.check();
  const Polyline p = b.polyline(0.01);
  for (const Point& q : p.points())
    check_near(distance(q, Point(0, 0, 0)), 2, 1e-12);
  check_near(p.length(), pi, 1e-5);
  assert(p.front() == Point(2, 0, 0) && p.back() == Point(0, 2, 0));
  for (std::size_t i = 1; i < p.points().size(); ++i)
    assert(distance(p.points()[i - 1], p.points()[i]) < 0.011);

  // of degree 1 it is its control polygon
  Bspline line;
  line.degree = 1;
  line.knots = {0, 0, 1, 3, 3};
  line.control_points = {Point(0, 0, 0), Point(1, 0, 0), Point(1, 5, 0)};
  assert(line.polyline(0.01).points() == line.control_points);

  // not clamped: a uniform cubic starts at a mean of three control points
  Bspline uniform;
  uniform.degree = 3;
  uniform.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  uniform.control_points = {Point(0, 0, 0), Point(1, 0, 0), Point(2, 6, 0), Point(3, 0, 0), Point(4, 0, 0)};
  const Polyline q = uniform.polyline(0.1);
  check_near(distance(q.front(), Point(1, 1, 0)), 0, 1e-12);
  check_near(distance(q.back(), Point(3, 1, 0)), 0, 1e-12);
}

} // namespace

int main()
{
  test_parallel_segments();
  test_pushed_segment();
  test_one_sided();
  test_circles();
  test_uneven_points();
  test_scale();
  test_corners();
  test_greedy();
  test_missing_and_extra_curves();
  test_chaining();
  test_cycles();
  test_end_gap();
  test_types();
  test_circle_through_polyline();
  test_failures();
  test_polyline();
  test_bspline();
  return 0;
}
