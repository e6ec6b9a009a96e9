// How curves are traced, what the field says of them, and that all of it stops at once: against what each promises, on
// fields that are known in closed form.

#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/fit/fit_splines.h>
#include <CGAL/Wireframe_extraction/internal/network/Bend_sharpener.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_end_joiner.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_evidence.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_tracer.h>
#include <CGAL/Wireframe_extraction/internal/network/Joint_fit.h>
#include <CGAL/Wireframe_extraction/internal/network/build_graph.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/complete_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/contract.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/polyline_feet.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

typedef std::vector<Vector> Polyline;

Polyline straight(const Vector& from, const Vector& to)
{
  const std::size_t count = (std::max)(std::size_t(1), static_cast<std::size_t>(2. * (to - from).norm()));
  Polyline points;
  for (std::size_t k = 0; k <= count; ++k)
    points.push_back(from + (to - from) * (double(k) / double(count)));
  return points;
}

struct Field_points
{
  std::vector<Vector> points;
  std::vector<double> distances;
};

Field_band band_of(const Field_points& field)
{
  std::vector<std::size_t> order(field.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return field.distances[a] < field.distances[b]; });
  Field_band band;
  for (std::size_t i : order)
  {
    band.points.push_back(field.points[i]);
    band.distances.push_back(field.distances[i]);
    band.indices.push_back(i);
    band.skeleton_size += field.distances[i] < 1.5;
  }
  band.search.build(band.points, band.size());
  return band;
}

// Two half-planes, at right angles, that meet in the line from `first` to `last` on the x-axis, about one point for
// each square; distances are those to the line.
Field_points fold(double first, double last, std::mt19937& random)
{
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  Field_points field;
  for (double s = first + 0.5; s < last; ++s)
    for (double t = -3.5; t < 4.; ++t)
    {
      const double x = s + jitter(random), d = std::abs(t + jitter(random));
      field.points.push_back(t > 0. ? Vector(x, d, 0.) : Vector(x, 0., -d));
      field.distances.push_back(d);
    }
  return field;
}

// the rim of a cylinder
Field_points rim(double radius, std::mt19937& random)
{
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  const double around = std::floor(2. * CGAL_PI * radius);
  Field_points field;
  for (double k = 0.; k < around; ++k)
    for (double t = -3.5; t < 4.; ++t)
    {
      const double angle = 2. * CGAL_PI * (k + jitter(random)) / around, d = std::abs(t + jitter(random));
      const double r = t > 0. ? radius - d : radius;
      field.points.push_back(Vector(r * std::cos(angle), r * std::sin(angle), t > 0. ? 0. : -d));
      field.distances.push_back(d);
    }
  return field;
}

// A step of height `h` whose edges are the x-axis and the line above it.
Field_points step(double h, std::mt19937& random)
{
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  Field_points field;
  for (double s = -20.; s < 20.; ++s)
    for (double t = -4.; t < h + 4.; ++t)
    {
      const double x = s + jitter(random), u = t + jitter(random);
      const double z = (std::min)(h, (std::max)(0., u));
      const Vector p(x, u - z, z);
      field.points.push_back(p);
      field.distances.push_back((std::min)(std::hypot(p.y(), p.z()), std::hypot(p.y(), p.z() - h)));
    }
  return field;
}

// The edge of a plate from (-12, 0) over its corner at the origin, rounded by `radius`, to (0, 12).
Polyline rounded_edge(double radius)
{
  Polyline edge{Vector(-12., 0., 0.)};
  for (int k = 0; k <= 200; ++k)
  {
    const double angle = 0.5 * CGAL_PI * k / 200.;
    edge.push_back(Vector(radius * (std::sin(angle) - 1.), radius * (1. - std::cos(angle)), 0.));
  }
  edge.push_back(Vector(0., 12., 0.));
  return edge;
}

double distance_to(const Polyline& line, const Vector& p)
{
  double square = (std::numeric_limits<double>::infinity)();
  for (std::size_t k = 1; k < line.size(); ++k)
    square = (std::min)(square, squared_distance_to_segment(p, line[k - 1], line[k]));
  return std::sqrt(square);
}

// Shows the points of a plate: those of its faces at these heights, and of the side from its edge down to a depth.
template <class Add>
void visit_plate(double radius, const std::vector<double>& faces, double depth, std::mt19937& random, const Add& add)
{
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  const Polyline edge = rounded_edge(radius);
  for (double z : faces)
    for (double x = -11.5; x < 0.; ++x)
      for (double y = 0.5; y < 12.; ++y)
      {
        const Vector p(x + jitter(random), y + jitter(random), z);
        const bool is_cut_off =
          p.x() > -radius && p.y() < radius && std::hypot(p.x() + radius, p.y() - radius) > radius;
        if (!is_cut_off)
          add(p);
      }
  const std::vector<double> lengths = arc_lengths(edge);
  Polyline_walk walk(edge, lengths);
  for (double s = 0.5; s < lengths.back(); ++s)
  {
    const Vector p = walk.advance_to(s);
    for (double z = -0.5; z > -depth; --z)
      add(p + (z + jitter(random)) * Vector::UnitZ());
  }
}

// the plate's upper face, and the side below its edge
Field_points plate(double radius, std::mt19937& random)
{
  const Polyline edge = rounded_edge(radius);
  Field_points field;
  visit_plate(radius, {0.}, 4., random, [&](const Vector& p) {
    const double d = distance_to(edge, p);
    if (d > 4.)
      return;
    field.points.push_back(p);
    field.distances.push_back(d);
  });
  return field;
}

Local_curve along_x(double x)
{
  Local_curve curve;
  curve.point = Vector(x, 0., 0.);
  return curve;
}

// Contraction -----------------------------------------------------------------------------------------

Contraction contracted(const Field_band& band)
{
  Contraction contraction;
  assert(contract(
    band, 4., [](double) { return true; }, contraction));
  return contraction;
}

// Feet lie on the nearest of two edges whose balls always hold the other one, and not between them.
void test_contraction_between_close_edges()
{
  std::mt19937 random(21);
  for (double h : {1.5, 2., 3.})
  {
    const Field_band band = band_of(step(h, random));
    const Contraction contraction = contracted(band);
    assert(contraction.has_several_curves && contraction.noise < 0.02);
    std::size_t on_edge = 0, all = 0;
    for (std::size_t i = 0; i < band.skeleton_size; ++i)
    {
      const Vector &p = band.points[i], &foot = contraction.curves[i].point;
      if (std::abs(p.x()) > 17.)
        continue;
      ++all;
      const double z = std::hypot(p.y(), p.z()) < std::hypot(p.y(), p.z() - h) ? 0. : h;
      on_edge += std::hypot(foot.y(), foot.z() - z) < 0.1 && std::abs(contraction.curves[i].tangent.x()) > 0.98;
    }
    assert(100 * on_edge >= 95 * all);
  }
}

// A field whose errors are larger than what it could tell apart is left to single fits.
void test_contraction_of_a_noisy_field()
{
  std::mt19937 random(22);
  std::normal_distribution<double> error(0., 0.3);
  Field_points field = fold(-20., 20., random);
  for (double& distance : field.distances)
    distance = std::abs(distance + error(random));
  const Contraction contraction = contracted(band_of(field));
  assert(!contraction.has_several_curves && contraction.residuals == contraction.own_residuals);
}

// Both edges of a step are traced to their ends, also where one seed is all that is known of each.
void test_traces_of_close_edges()
{
  std::mt19937 random(23);
  for (double h : {1.5, 2., 3.})
  {
    const Field_band band = band_of(step(h, random));
    const Contraction contraction = contracted(band);
    Curve_tracer tracer(band, Tracing_options(), nullptr, nullptr, &contraction);
    for (double z : {0., h})
    {
      Local_curve seed = along_x(1.);
      seed.point.z() = z;
      const Traced_curve curve = tracer.trace(seed);
      assert(!curve.is_closed && std::abs(curve.length() - 40.) < 3.);
      for (const Vector& p : curve.points)
        assert(std::hypot(p.y(), p.z() - z) < 0.15);
    }
  }
}

// Curve_tracer ----------------------------------------------------------------------------------------

double distance_from_x_axis(const Polyline& polyline)
{
  double largest = 0.;
  for (const Vector& p : polyline)
    largest = (std::max)(largest, std::hypot(p.y(), p.z()));
  return largest;
}

// an open curve ends where the points do, and says so; which way the seed looks does not matter
void test_trace_of_a_line()
{
  std::mt19937 random(1);
  const Field_band band = band_of(fold(-20., 20., random));
  for (double x : {-15., 0., 12.})
    for (double side : {-1., 1.})
    {
      Local_curve seed = along_x(x);
      seed.tangent *= side;
      const Traced_curve curve = Curve_tracer(band, Tracing_options()).trace(seed);
      assert(!curve.is_closed && curve.ends_in_void[0] && curve.ends_in_void[1]);
      assert(std::abs(curve.length() - 40.) < 2.);
      assert(distance_from_x_axis(curve.points) < 0.1);
      assert(curve.typical_residual() < 0.05);
      for (int e = 0; e < 2; ++e)
      {
        const Vector& end = e == 0 ? curve.points.front() : curve.points.back();
        assert((curve.tips[e].point - end).norm() < 1e-9);
        assert(curve.tips[e].tangent.x() * end.x() > 0.99 * 19.);
      }
    }
}

void test_trace_of_a_circle()
{
  std::mt19937 random(2);
  for (double radius : {5., 30.})
  {
    const Field_band band = band_of(rim(radius, random));
    Local_curve seed;
    seed.point = Vector(0., radius, 0.);
    const Traced_curve curve = Curve_tracer(band, Tracing_options()).trace(seed);
    assert(curve.is_closed && curve.points.front() == curve.points.back());
    assert(std::abs(curve.length() / (2. * CGAL_PI * radius) - 1.) < 0.02);
    for (const Vector& p : curve.points)
      assert(std::hypot(std::hypot(p.x(), p.y()) - radius, p.z()) < 0.15);
  }
}

// a field that says that there is no curve is no void
void test_trace_stops_at_a_contradiction()
{
  std::mt19937 random(3);
  Field_points field = fold(-30., 30., random);
  for (std::size_t i = 0; i < field.points.size(); ++i)
    if (field.points[i].x() > 0.)
      field.distances[i] += field.points[i].x();
  const Field_band band = band_of(field);
  const Traced_curve curve = Curve_tracer(band, Tracing_options()).trace(along_x(-10.));
  assert(!curve.is_closed && curve.ends_in_void[0] && !curve.ends_in_void[1]);
  assert(std::abs(curve.points.back().x()) < 1.5 && curve.points.front().x() < -28.5);
}

// short gaps are crossed, long ones end a curve
void test_trace_across_gaps()
{
  std::mt19937 random(4);
  for (double gap : {2., 10.})
  {
    Field_points field = fold(-20., 0., random);
    const Field_points other = fold(gap, 20., random);
    field.points.insert(field.points.end(), other.points.begin(), other.points.end());
    field.distances.insert(field.distances.end(), other.distances.begin(), other.distances.end());
    const Field_band band = band_of(field);
    const Traced_curve curve = Curve_tracer(band, Tracing_options()).trace(along_x(-10.));
    assert(curve.ends_in_void[1]);
    assert(std::abs(curve.points.back().x() - (gap < 3. ? 20. : 0.)) < 1.5);
  }
}

// no curve runs along one that is kept
void test_kept_curves_are_not_traced_again()
{
  std::mt19937 random(5);
  const Field_band band = band_of(fold(-20., 20., random));
  Curve_tracer tracer(band, Tracing_options());
  assert(!tracer.is_traced(along_x(10.)));
  Traced_curve kept;
  kept.points = straight(Vector(5., 0., 0.), Vector(20., 0., 0.));
  tracer.keep(kept);
  assert(tracer.is_traced(along_x(10.)) && !tracer.is_traced(along_x(0.)));
  Local_curve crossing = along_x(10.);
  crossing.tangent = Vector::UnitY();
  assert(!tracer.is_traced(crossing));
  const Traced_curve curve = tracer.trace(along_x(-10.));
  assert(std::abs(curve.points.back().x() - 5.) < 1.5 && curve.points.front().x() < -18.5);
}

// A curve that was followed further is kept as far as it now reaches, at both ends.
void test_extended_curves_are_not_traced_again()
{
  std::mt19937 random(6);
  const Field_band band = band_of(fold(-30., 30., random));
  Field_explanation explanation(band);
  Curve_tracer tracer(band, Tracing_options(), &explanation);
  const auto share_explained = [&](double from, double to) {
    std::size_t explained = 0, all = 0;
    for (std::size_t i = 0; i < band.size(); ++i)
      if (band.points[i].x() > from && band.points[i].x() < to && band.distances[i] < 3.)
      {
        ++all;
        explained += explanation.is_explained(i, 0.);
      }
    return double(explained) / double(all);
  };
  Traced_curve other; // far away: the curve that is extended is not the first one
  other.points = straight(Vector(0., 100., 0.), Vector(20., 100., 0.));
  tracer.keep(other);
  Traced_curve curve;
  curve.points = straight(Vector(-5., 0., 0.), Vector(8., 0., 0.));
  curve.tips[0] = along_x(-5.);
  curve.tips[0].tangent = -Vector::UnitX();
  curve.tips[1] = along_x(8.);
  tracer.keep(curve);
  assert(share_explained(-4., 7.) > 0.99 && share_explained(13., 28.) == 0. && share_explained(-28., -10.) == 0.);
  tracer.extend(curve, 1);
  assert(share_explained(-28., -10.) > 0.99 && share_explained(13., 28.) > 0.99);
  assert(std::abs(curve.points.front().x() + 30.) < 1.5 && std::abs(curve.points.back().x() - 30.) < 1.5);
  assert(distance_from_x_axis(curve.points) < 0.1);
  assert(curve.ends_in_void[0] && curve.ends_in_void[1]);
  for (std::size_t k = 1; k < curve.points.size(); ++k)
  {
    const double step = curve.points[k].x() - curve.points[k - 1].x(); // nothing is doubled
    assert(step > 0.1 && step < 1.);
  }
  for (double x = -29.; x < 30.; ++x)
    assert(tracer.is_traced(along_x(x)));
  for (double x : {-20., 20.})
    assert(tracer.trace(along_x(x)).length() < 2.);

  // two that face each other meet, instead of running along each other
  Curve_tracer two(band, Tracing_options());
  Traced_curve halves[2];
  halves[0].points = straight(Vector(-28., 0., 0.), Vector(-15., 0., 0.));
  halves[1].points = straight(Vector(15., 0., 0.), Vector(28., 0., 0.));
  for (Traced_curve& half : halves)
  {
    half.tips[0] = along_x(half.points.front().x());
    half.tips[0].tangent = -Vector::UnitX();
    half.tips[1] = along_x(half.points.back().x());
    two.keep(half);
  }
  two.extend(halves[0], 0);
  two.extend(halves[1], 1);
  assert(std::abs(halves[0].points.back().x() - 15.) < 1.5);
  assert(std::abs(halves[1].points.front().x() - 15.) < 1.5);
}

// without points there is no evidence, and what other curves explain does not contradict
void test_evidence_at_a_front()
{
  std::mt19937 random(7);
  Field_points field; // dense, or a front would now and then be without points
  for (int k = 0; k < 4; ++k)
  {
    const Field_points layer = fold(-20., 20., random);
    field.points.insert(field.points.end(), layer.points.begin(), layer.points.end());
    field.distances.insert(field.distances.end(), layer.distances.begin(), layer.distances.end());
  }
  const Field_band band = band_of(field);
  Curve_tracer tracer(band, Tracing_options());
  assert(tracer.evidence(along_x(0.)) == Curve_tracer::SUPPORT);
  assert(tracer.evidence(along_x(50.)) == Curve_tracer::NOTHING);
  Local_curve beside = along_x(0.);
  beside.point.y() = 2.;
  assert(tracer.evidence(beside) == Curve_tracer::CONTRADICTION);

  // curves so close on both sides that only what is next to the edge is not theirs
  Field_points crowded = field;
  for (std::size_t i = 0; i < crowded.points.size(); ++i)
    crowded.distances[i] = (std::min)(crowded.distances[i], std::abs(crowded.distances[i] - 0.6));
  const Field_band crowded_band = band_of(crowded);
  Field_explanation explanation(crowded_band);
  explanation.add(straight(Vector(-20., 0.6, 0.), Vector(20., 0.6, 0.)));
  explanation.add(straight(Vector(-20., 0., -0.6), Vector(20., 0., -0.6)));
  Curve_tracer ignorant(crowded_band, Tracing_options()), knowing(crowded_band, Tracing_options(), &explanation);
  std::size_t hidden = 0, supported = 0;
  for (double x = -15.; x < 15.; ++x)
  {
    assert(knowing.evidence(along_x(x)) != Curve_tracer::CONTRADICTION);
    supported += knowing.evidence(along_x(x)) == Curve_tracer::SUPPORT;
    hidden += ignorant.evidence(along_x(x)) == Curve_tracer::CONTRADICTION;
  }
  assert(hidden > 15 && supported > 25);
}

// Curve_evidence --------------------------------------------------------------------------------------

// by trying everything
struct Slow_evidence
{
  const Field_band& band;
  double tolerance;

  double distance(std::size_t i, const std::vector<const Polyline*>& polylines) const
  {
    double nearest = 4.;
    for (const Polyline* polyline : polylines)
      for (std::size_t k = 1; polyline && k < polyline->size(); ++k)
        nearest = (std::min)(
          nearest, std::sqrt(squared_distance_to_segment(band.points[i], (*polyline)[k - 1], (*polyline)[k])));
    return nearest;
  }

  double loss(const std::vector<const Polyline*>& polylines, const Vector& center, double radius) const
  {
    double sum = 0.;
    for (std::size_t i = 0; i < band.size(); ++i)
      if ((band.points[i] - center).norm() < radius)
      {
        const double ratio = (band.distances[i] - distance(i, polylines)) / tolerance;
        sum += (std::min)(1., ratio * ratio);
      }
    return sum;
  }

  double loss(const std::vector<const Polyline*>& polylines) const { return loss(polylines, Vector::Zero(), 1e9); }
};

void test_gains_of_curves()
{
  std::mt19937 random(8);
  Field_points field = fold(-15., 15., random);
  std::normal_distribution<double> error(0., 0.15);
  for (double& d : field.distances)
    d = std::abs(d + error(random));
  const Field_band band = band_of(field);
  for (double noise : {0.05, 0.15})
  {
    const Curve_evidence evidence(band, noise);
    const Slow_evidence slow{band, (std::max)(0.2, 2.5 * noise)};
    const Polyline line = straight(Vector(-14., 0., 0.), Vector(3., 0., 0.)),
                   rest = straight(Vector(1., 0.2, 0.), Vector(14., 0., 0.)),
                   aside = straight(Vector(-14., 1., -1.), Vector(14., -0.5, 0.3));
    const std::vector<const Polyline*> all{&line, nullptr, &rest, &aside};
    const Curve_evidence::Scores scores = evidence.scores(all);
    assert(scores.gains[1] == 0. && scores.neighbors[1].empty());
    for (std::size_t c : {0, 2, 3})
    {
      std::vector<const Polyline*> others = all;
      others[c] = nullptr;
      const double gain = slow.loss(others) - slow.loss(all);
      assert(std::abs(scores.gains[c] - gain) < 1e-6);
      const std::vector<double> distances = evidence.distances(others);
      for (std::size_t i = 0; i < band.size(); ++i)
        assert(std::abs(distances[i] - slow.distance(i, others)) < 1e-9);
      // one that makes it worse for some points is not given to them: they stay with the nearest
      std::vector<double> with = distances;
      evidence.add(*all[c], with);
      assert(std::abs(evidence.gain_of(*all[c], distances) - gain) < 1e-6);
      for (std::size_t i = 0; i < band.size(); ++i)
        assert(std::abs(with[i] - slow.distance(i, all)) < 1e-9);
      // who would take over points, and from whom, are neighbors of each other
      for (std::size_t other : scores.neighbors[c])
      {
        const std::vector<std::size_t>& back = scores.neighbors[other];
        assert(other != c && std::find(back.begin(), back.end(), c) != back.end());
      }
    }
    for (double x : {-20., -5., 2., 9.})
      for (double radius : {2., 4.})
        assert(std::abs(evidence.loss_around(Vector(x, 0.3, 0.), radius, {&line, &rest})
                        - slow.loss({&line, &rest}, Vector(x, 0.3, 0.), radius))
               < 1e-6);
  }
}

// a curve must be worth its price, and one that the field denies goes
void test_prune_by_gain()
{
  std::mt19937 random(9);
  const Field_band band = band_of(fold(-20., 20., random));
  const Curve_evidence evidence(band, 0.1);
  const Polyline line = straight(Vector(-20., 0., 0.), Vector(20., 0., 0.)),
                 wrong = straight(Vector(-20., 2., 0.), Vector(20., 2., 0.));
  const double gain = evidence.scores({&line}).gains[0];
  assert(gain > 40.);
  assert(evidence.prune({&line}, gain - 1e-6, 0.) == std::vector<char>{1});
  assert(evidence.prune({&line}, gain + 1e-6, 0.) == std::vector<char>{0});
  assert(evidence.prune({&line}, 0., (gain - 1e-6) / 40.) == std::vector<char>{1});
  assert(evidence.prune({&line}, 0., (gain + 1e-6) / 40.) == std::vector<char>{0});
  assert((evidence.prune({&wrong, nullptr, &line}, 2., 0.7) == std::vector<char>{0, 0, 1}));
}

// Of several curves that explain the same points one stays, the first one; without any, the points would be lost.
void test_prune_keeps_one_of_equal_curves()
{
  std::mt19937 random(10);
  Field_points field;
  std::vector<Polyline> lines;
  for (std::size_t k = 0; k < 40; ++k)
  {
    const Vector place(0., 20. * double(k), 0.);
    const Field_points one = fold(-8., 8., random);
    for (std::size_t i = 0; i < one.points.size(); ++i)
    {
      field.points.push_back(one.points[i] + place);
      field.distances.push_back(one.distances[i]);
    }
    lines.push_back(straight(place - 8. * Vector::UnitX(), place + 8. * Vector::UnitX()));
  }
  const Field_band band = band_of(field);
  for (std::size_t copies : {2, 3})
  {
    std::vector<const Polyline*> polylines;
    for (std::size_t copy = 0; copy < copies; ++copy)
      for (const Polyline& line : lines)
        polylines.push_back(&line);
    const std::vector<char> keep = Curve_evidence(band, 0.1).prune(polylines, 2., 0.7);
    for (std::size_t c = 0; c < keep.size(); ++c)
      assert(bool(keep[c]) == (c < lines.size()));
  }
}

// The same where one of them is the nearest for all points, as along the border of a surface: the other one has no
// point of its own, and yet there is none left if both go.
void test_prune_at_a_border()
{
  std::mt19937 random(11);
  Field_points field = fold(-20., 20., random);
  for (std::size_t i = 0; i < field.points.size(); ++i) // all on one side
    field.points[i] = Vector(field.points[i].x(), field.distances[i], 0.);
  const Field_band band = band_of(field);
  const Polyline inner = straight(Vector(-20., 0., 0.), Vector(20., 0., 0.)),
                 outer = straight(Vector(-20., -0.03, 0.), Vector(20., -0.03, 0.)),
                 longer = straight(Vector(-21., -0.05, 0.), Vector(21., -0.05, 0.));
  const Curve_evidence evidence(band, 0.1);
  assert((evidence.prune({&inner, &outer}, 2., 0.7) == std::vector<char>{1, 0}));
  assert((evidence.prune({&outer, &inner}, 2., 0.7) == std::vector<char>{0, 1}));
  assert((evidence.prune({&longer, &outer, &inner}, 2., 0.7) == std::vector<char>{0, 0, 1}));
}

// the worst goes first, and what it leaves may be enough for the others
void test_prune_worst_first()
{
  std::mt19937 random(12);
  const Field_band band = band_of(fold(-20., 20., random));
  const Polyline whole = straight(Vector(-20., 0., 0.), Vector(20., 0., 0.));
  std::vector<Polyline> pieces;
  for (double x = -20.; x < 20.; x += 8.)
    pieces.push_back(straight(Vector(x, 0.05, 0.), Vector(x + 8., 0.05, 0.)));
  std::vector<const Polyline*> polylines = pointers_to(pieces);
  polylines.push_back(&whole);
  const std::vector<char> keep = Curve_evidence(band, 0.1).prune(polylines, 2., 0.7);
  double covered = 0.;
  for (std::size_t c = 0; c < keep.size(); ++c)
    if (keep[c])
      covered += polyline_length(*polylines[c]);
  assert(std::abs(covered - 40.) < 1e-6); // all of the line, once
}

// Corners and round courses ---------------------------------------------------------------------------

// two straight curves that meet in the origin, where the edge is rounded or not
Curve_network corner_network()
{
  Curve_network network;
  network.nodes = {Vector(-12., 0., 0.), Vector(0., 0., 0.), Vector(0., 12., 0.)};
  for (std::size_t k = 0; k < 2; ++k)
  {
    Network_curve curve;
    curve.points = straight(network.nodes[k], network.nodes[k + 1]);
    curve.nodes = {k, k + 1};
    for (int e = 0; e < 2; ++e)
    {
      curve.tips[e].point = network.nodes[k + std::size_t(e)];
      curve.tips[e].tangent = (e == 0 ? -1. : 1.) * (network.nodes[k + 1] - network.nodes[k]).normalized();
    }
    network.curves.push_back(curve);
  }
  return network;
}

// Both courses are fitted before they are compared: an exact field tells a corner from a rounding with a radius of one
// and a half distances between its points, whatever these are.
void test_rounded_corners()
{
  const std::function<bool(double)> uninterrupted;
  Progress progress(uninterrupted);
  Joining_options options;
  options.noise = 0.01;
  Extraction_options extraction;
  for (unsigned seed = 0; seed < 10; ++seed)
    for (double radius : {0., 1.5, 2., 3.})
    {
      std::mt19937 random(seed);
      const Field_band band = band_of(plate(radius, random));
      Curve_network network = corner_network();
      const Segment_grid grid = network.segments();
      Curve_end_joiner(network, options)
        .round_off(
          [&](const Vector& center, const std::vector<Polyline>& lines) {
            return Joint_fit(band, options.noise, extraction, center, 4., 9., 0.06, grid, lines);
          },
          1., progress);
      std::size_t number_of_curves = 0;
      double farthest = 0.;
      for (const Network_curve& curve : network.curves)
        if (curve.is_alive)
        {
          ++number_of_curves;
          for (const Vector& p : curve.points)
            farthest = (std::max)(farthest, distance_to(rounded_edge(radius), p));
        }
      assert(number_of_curves == (radius > 0. ? 1u : 2u));
      assert(farthest < 0.05);
    }
}

// A slab of some thickness below the plane z = 0, whose edge is that of a plate above and below: all points near its
// edges, with errors of the distances. Where it is not rounded, a third edge leads from corner to corner.
Field_points slab(double radius, double thickness, double deviation, std::mt19937& random)
{
  std::normal_distribution<double> error(0., deviation);
  const Polyline edge = rounded_edge(radius);
  Field_points field;
  visit_plate(radius, {0., -thickness}, thickness, random, [&](const Vector& p) {
    const Vector opposite(p.x(), p.y(), -thickness - p.z());
    double d = (std::min)(distance_to(edge, p), distance_to(edge, opposite));
    if (radius == 0.)
      d = (std::min)(d, distance_to({Vector(0., 0., 0.), Vector(0., 0., -thickness)}, p));
    if (d > 4.)
      return;
    field.points.push_back(p);
    field.distances.push_back(std::abs(d + error(random)));
  });
  return field;
}

// the edges of a slab above and below, rounded by `radius`
Curve_network edges_of_slab(double radius, double thickness)
{
  const Polyline edge = rounded_edge(radius);
  const std::vector<double> lengths = arc_lengths(edge);
  Curve_network network;
  for (double z : {0., -thickness})
  {
    Network_curve curve;
    Polyline_walk walk(edge, lengths);
    for (double s = 0.; s <= lengths.back(); s += 0.5)
      curve.points.push_back(walk.advance_to(s) + z * Vector::UnitZ());
    for (int e = 0; e < 2; ++e)
    {
      curve.nodes[e] = network.nodes.size();
      network.nodes.push_back(e == 0 ? curve.points.front() : curve.points.back());
      curve.tips[e].point = network.nodes.back();
      curve.tips[e].tangent = e == 0 ? Vector(-1., 0., 0.) : Vector(0., 1., 0.);
    }
    network.curves.push_back(curve);
  }
  return network;
}

bool sharpen(Curve_network& network, const Field_band& band, double noise)
{
  const std::function<bool(double)> uninterrupted;
  Progress progress(uninterrupted);
  Joining_options options;
  options.noise = noise;
  const Extraction_options extraction;
  const Segment_grid grid = network.segments();
  return Bend_sharpener(network, options, &progress)
    .run(
      [&](const Vector& center, const std::vector<Polyline>& lines) {
        return Joint_fit(band, noise, extraction, center, 4., 9., 0.06, grid, lines);
      },
      Curve_evidence(band, noise), 1.);
}

// Where traces have come around the corners of a slab, in a field with errors, the third edge tells that these are
// corners. Where its edge is rounded no third edge is there, and the curves stay as they are.
void test_bends()
{
  const double noise = 0.2, thickness = 6.;
  for (unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    const Field_band sharp = band_of(slab(0., thickness, noise, random));
    Curve_network network = edges_of_slab(1.5, thickness);
    assert(sharpen(network, sharp, noise));
    assert(network.curves.size() == 4);
    for (double z : {0., -thickness})
    {
      std::size_t number_of_ends = 0;
      for (const Network_curve& curve : network.curves)
        for (int e = 0; e < 2; ++e)
        {
          const Vector& end = e == 0 ? curve.points.front() : curve.points.back();
          assert(network.nodes[curve.nodes[e]] == end && curve.tips[e].point == end);
          number_of_ends += (end - Vector(0., 0., z)).norm() < 1.;
        }
      assert(number_of_ends == 2);
    }
    // fits of splines show corners and roundings of a precise field
    Curve_network unchanged = edges_of_slab(1.5, thickness);
    assert(!sharpen(unchanged, sharp, 0.05) && unchanged.curves.size() == 2);
    for (double radius : {1.5, 2., 3.})
    {
      const Field_band rounded = band_of(slab(radius, thickness, noise, random));
      Curve_network network = edges_of_slab(radius, thickness);
      const Polyline before = network.curves[0].points;
      assert(!sharpen(network, rounded, noise));
      assert(network.curves.size() == 2 && network.nodes.size() == 4 && network.curves[0].points == before);
    }
  }
}

// a circle has no bend, wherever it starts; and a closed curve with one starts at its corner in the end
void test_bends_of_closed_curves()
{
  const double noise = 0.2, thickness = 6., size = 24.;
  std::mt19937 random(1);
  std::normal_distribution<double> error(0., noise);
  Field_points field = rim(5., random);
  for (double& d : field.distances)
    d = std::abs(d + error(random));
  Curve_network circle;
  circle.curves.resize(1);
  for (int k = 0; k <= 60; ++k)
    circle.curves[0].points.push_back(
      5. * Vector(std::cos(2. * CGAL_PI * (k % 60) / 60.), std::sin(2. * CGAL_PI * (k % 60) / 60.), 0.));
  assert(!sharpen(circle, band_of(field), noise) && circle.curves.size() == 1);

  const Field_band band = band_of(slab(0., thickness, noise, random));
  Curve_network closed = edges_of_slab(1.5, thickness);
  // the upper edge goes on where there are no points, over the other corners of a square, which are blunt
  Polyline& points = closed.curves[0].points;
  const Vector middle(-0.5 * size, 0.5 * size, 0.);
  for (int k = 1; k < 96; ++k)
  {
    const double angle = 1.5 * CGAL_PI * k / 96.;
    points.push_back(middle + 0.5 * size * Vector(std::cos(angle), std::sin(angle), 0.));
  }
  points.push_back(points.front());
  closed.curves[0].nodes = {no_node, no_node};
  assert(sharpen(closed, band, noise));
  const Network_curve& result = closed.curves[0];
  assert(result.nodes[0] == result.nodes[1] && result.nodes[0] != no_node);
  assert(closed.nodes[result.nodes[0]].norm() < 1.);
  assert(result.points.front() == result.points.back());
}

// Cancelling ------------------------------------------------------------------------------------------

// boxes in a row, the points near their edges, with errors
Skeleton_data boxes(std::size_t number, double size, std::mt19937& random)
{
  std::uniform_real_distribution<double> jitter(-0.4, 0.4);
  std::normal_distribution<double> error(0., 0.1);
  Field_points field;
  for (std::size_t k = 0; k < number; ++k)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side)
        for (double u = 0.5; u < size; ++u)
          for (double v = 0.5; v < size; ++v)
          {
            const double a = u + jitter(random), b = v + jitter(random);
            const double d = (std::min)((std::min)(a, size - a), (std::min)(b, size - b));
            if (d > 4.)
              continue;
            Vector p;
            p[axis] = side * size;
            p[(axis + 1) % 3] = a;
            p[(axis + 2) % 3] = b;
            field.points.push_back(p + Vector(2. * size * double(k), 0., 0.));
            field.distances.push_back(std::abs(d + error(random)));
          }
  Skeleton_data skeleton;
  skeleton.band = std::make_shared<Field_band>(band_of(field));
  skeleton.surroundings = std::make_shared<Field_band>(band_of(field));
  const bool is_contracted = contract(skeleton, Extraction_options(), [](double) { return true; });
  assert(is_contracted && !skeleton.contraction->is_precise());
  return skeleton;
}

// Runs `work(proceed)` to its end, then cancels it after every so many calls. There must be calls all the time; after
// the refusal none, and nothing but a small share of the work. Time is that of the processor, since others use it too.
// On a busy machine a thread that waits for one which is not running uses it as well: a refusal may be tried again.
template <class Work, class Check>
void check_cancelling(const Work& work, const Check& check)
{
  static constexpr int attempts = 3;
  const auto now = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
  std::size_t calls = 0;
  double longest_pause = 0., last_share = 0., last_call = now();
  const double begin = last_call;
  check(work([&](double share) {
          assert(share >= last_share && share <= 1.);
          last_share = share;
          ++calls;
          longest_pause = (std::max)(longest_pause, now() - last_call);
          last_call = now();
          return true;
        }),
        true);
  const double all = now() - begin;
  longest_pause = (std::max)(longest_pause, now() - last_call);
  assert(calls > 100 && last_share > 0.6);
  assert(longest_pause < 0.1 * all);
  for (std::size_t k = 0; k <= 12; ++k)
  {
    const std::size_t most = 1 + k * (calls - 2) / 12;
    double shortest_return = all;
    for (int attempt = 0; attempt < attempts && !(shortest_return < 0.1 * all); ++attempt)
    {
      std::size_t made = 0;
      double refused = 0.;
      const auto result = work([&](double) {
        assert(made < most);
        if (++made < most)
          return true;
        refused = now();
        return false;
      });
      shortest_return = (std::min)(shortest_return, now() - refused);
      assert(made == most);
      check(result, false);
    }
    assert(shortest_return < 0.1 * all);
  }
}

std::vector<std::size_t> skeleton_indices(const Skeleton_data& skeleton)
{
  std::vector<std::size_t> indices(skeleton.size());
  std::iota(indices.begin(), indices.end(), std::size_t(0));
  return indices;
}

std::vector<Fitted_curve> curves_of(const Curve_network& network)
{
  std::vector<Fitted_curve> curves;
  for (const Network_curve& curve : network.curves)
    if (curve.is_alive)
    {
      Fitted_curve fitted;
      fitted.path = curve.points;
      fitted.vertices = curve.nodes;
      curves.push_back(fitted);
    }
  return curves;
}

// Splines and the points that support them -----------------------------------------------------------

// a polyline that starts in some direction and turns in a plane, now more, now less
Polyline winding(double length, double turn, const Vector& start, const Vector& direction, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  Polyline result{start};
  Vector forward = direction.normalized();
  const Vector axis = Vector(normal(random), normal(random), normal(random)).normalized();
  double curvature = turn * normal(random);
  for (double s = 0.; s < length; s += 0.5)
  {
    curvature = (std::max)(-0.25, (std::min)(0.25, curvature + 0.3 * turn * normal(random)));
    forward = (forward + 0.5 * curvature * axis.cross(forward)).normalized();
    result.push_back(result.back() + 0.5 * forward);
  }
  return result;
}

// What the field says is not what the curve was traced along: another curve from the same start, one beside it, a part
// of it, or one across it. Wherever the fit takes it, no place of it is farther from both the points and its trace than
// a point that supports it may be.
void test_no_spline_leaves_its_points()
{
  for (unsigned int seed = 0; seed < 400; ++seed)
  {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::normal_distribution<double> normal;
    const double noise = uniform(0.01, 0.6);
    const Polyline trace = winding(uniform(4., 50.), 0.05, Vector::Zero(), Vector::UnitX(), random);
    Polyline feature = trace;
    if (seed % 4 == 0)
      feature =
        winding(uniform(4., 50.), 0.1, Vector::Zero(), Vector(1., 0.2 * normal(random), 0.2 * normal(random)), random);
    else if (seed % 4 == 1)
      for (Vector& p : feature)
        p.y() += 2.5;
    else if (seed % 4 == 2)
      feature.resize((std::max)(std::size_t(3), trace.size() / 3));
    else
      feature = winding(uniform(4., 50.), 0.1, trace[trace.size() / 2],
                        Vector(normal(random), normal(random), normal(random)), random);
    auto band = std::make_shared<Field_band>();
    const double density = uniform(0.5, 4.);
    for (double k = 0.; k < density * double(feature.size()); ++k)
    {
      const Vector& foot = feature[std::size_t(uniform(0., double(feature.size())))];
      const Vector p = foot + Vector(uniform(-3., 3.), uniform(-3., 3.), uniform(-3., 3.));
      const double d = std::abs(distance_to(feature, p) + noise * normal(random));
      if (d > 3.)
        continue;
      band->points.push_back(p);
      band->distances.push_back(d);
      band->indices.push_back(band->indices.size());
    }
    if (band->size() == 0)
      continue;
    complete_band(*band, 1.5);
    Skeleton_data skeleton;
    skeleton.band = band;
    Extraction_options options;
    options.noise_level = noise;
    std::vector<Fitted_curve> curves(1);
    curves[0].path = trace;
    curves[0].vertices = {{0, 1}};
    std::vector<Vector> vertices{trace.front(), trace.back()};
    assert(fit_splines(skeleton, options, vertices, curves, std::function<bool(double)>()));
    const Cubic_spline& spline = curves[0].spline;
    const double reach = options.support_distance + 1., error_of_start = 0.1 + 2. * noise;
    for (int k = 0; k <= 400; ++k)
    {
      const Vector p = spline.at(spline.front() + (spline.back() - spline.front()) * k / 400.);
      std::vector<std::size_t> near;
      band->search.query(p, reach, near);
      assert(!near.empty() || distance_to(trace, p) < reach + error_of_start);
    }
  }
}

void test_cancelling()
{
  std::mt19937 random(13);
  const std::size_t number = 3;
  const Skeleton_data skeleton = boxes(number, 30., random);
  const Extraction_options options;
  Curve_network network;
  check_cancelling(
    [&](const std::function<bool(double)>& proceed) {
      return build_network(skeleton, {}, {skeleton_indices(skeleton)}, options, proceed);
    },
    [&](const Curve_network& result, bool is_complete) {
      for (const Network_curve& curve : result.curves)
        if (curve.is_alive)
        {
          assert(curve.points.size() >= 2);
          for (const Vector& p : curve.points)
            assert(p.allFinite());
        }
      if (!is_complete)
        return;
      assert(curves_of(result).size() == 12 * number);
      network = result;
    });
  check_cancelling(
    [&](const std::function<bool(double)>& proceed) {
      std::vector<Fitted_curve> curves = curves_of(network);
      std::vector<Vector> vertices = network.nodes;
      const bool is_complete = fit_splines(skeleton, options, vertices, curves, proceed);
      return std::make_pair(is_complete, curves);
    },
    [&](const std::pair<bool, std::vector<Fitted_curve>>& result, bool is_complete) {
      assert(result.first == is_complete);
      for (const Fitted_curve& curve : result.second)
      {
        assert((curve.support > 50) == is_complete);
        for (double share = 0.; share <= 1.; share += 0.25) // near the box's edges, and the same in between
        {
          Vector p = curve.spline.at(curve.spline.front() + share * (curve.spline.back() - curve.spline.front()));
          p.x() = std::fmod(p.x() + 10., 60.) - 10.;
          std::size_t on_planes = 0;
          for (int axis = 0; axis < 3; ++axis)
            on_planes += (std::min)(std::abs(p[axis]), std::abs(p[axis] - 30.)) < 0.5;
          assert(on_planes >= 2);
        }
      }
    });
}

} // namespace

int main()
{
  test_contraction_between_close_edges();
  test_contraction_of_a_noisy_field();
  test_traces_of_close_edges();
  test_trace_of_a_line();
  test_trace_of_a_circle();
  test_trace_stops_at_a_contradiction();
  test_trace_across_gaps();
  test_kept_curves_are_not_traced_again();
  test_extended_curves_are_not_traced_again();
  test_evidence_at_a_front();
  test_gains_of_curves();
  test_prune_by_gain();
  test_prune_keeps_one_of_equal_curves();
  test_prune_at_a_border();
  test_prune_worst_first();
  test_rounded_corners();
  test_bends();
  test_bends_of_closed_curves();
  test_no_spline_leaves_its_points();
  test_cancelling();
  return 0;
}
