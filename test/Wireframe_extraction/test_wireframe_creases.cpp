// What fits to creases of the surface and curves along them promise, on folded sheets that are known in closed form.

#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Crease_fit.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Crease_tracer.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_refinement.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

const double degree = CGAL_PI / 180.;

// Points of a sheet with the parameters s, along a crease, and t, across it, about one per unit area.
struct Sheet
{
  std::function<Vector(double s, double t)> point;
  std::function<double(double s, double t)> distance = [](double, double t) { return std::abs(t); };
  double first = -15., last = 15., width = 6.;
  double surface_noise = 0., field_noise = 0.;

  Field_band sampled(unsigned int seed = 1) const
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-0.35, 0.35);
    std::normal_distribution<double> error(0., 1.);
    Field_band band;
    for (double u = first + 0.5; u < last; u += 1.)
      for (double v = -width; v < width; v += 1.)
      {
        const double s = u + jitter(random), t = v + 0.5 + jitter(random);
        const double x = error(random), y = error(random), z = error(random);
        band.points.push_back(point(s, t) + surface_noise * Vector(x, y, z));
        band.distances.push_back((std::max)(0., distance(s, t) + field_noise * error(random)));
        band.indices.push_back(band.indices.size());
      }
    band.search.build(band.points, band.points.size());
    return band;
  }
};

// two half-planes that leave the x-axis; the normal turns by `fold`
Sheet folded(double fold)
{
  Sheet sheet;
  sheet.point = [fold](double s, double t) {
    return Vector(s, t * std::cos(0.5 * fold), -std::abs(t) * std::sin(0.5 * fold));
  };
  return sheet;
}

// the rim of a cylinder around the z-axis: its top, where t < 0, and its side
Sheet rim(double radius)
{
  Sheet sheet;
  sheet.first = 0.;
  sheet.last = 2. * CGAL_PI * radius;
  sheet.point = [radius](double s, double t) {
    const double r = radius + (std::min)(0., t);
    return Vector(r * std::cos(s / radius), r * std::sin(s / radius), -(std::max)(0., t));
  };
  return sheet;
}

Local_curve x_axis(double s = 0.)
{
  Local_curve curve;
  curve.point = Vector(s, 0., 0.);
  return curve;
}

// near the x-axis only
Local_curve first_guess()
{
  Local_curve curve;
  curve.point = Vector(0.2, 0.5, 0.3);
  curve.tangent = Vector(1., 0.15, -0.1).normalized();
  return curve;
}

double distance_from_x_axis(const Crease& crease) { return crease.curve.point.tail<2>().norm(); }

Crease_fit_options options_of(double surface_noise, double field_noise)
{
  Crease_fit_options options;
  options.surface_noise = (std::max)(0.01, surface_noise);
  options.field_noise = (std::max)(0.03, field_noise);
  return options;
}

// Crease_fit ------------------------------------------------------------------------------------------

void test_fit_finds_the_crease()
{
  for (double degrees : {25., 60., 90., 130.})
  {
    const double fold = degrees * degree;
    const Field_band band = folded(fold).sampled();
    const Local_curve start = first_guess();
    const Crease crease = Crease_fit(band).fit(start, start.point, options_of(0., 0.));
    assert(distance_from_x_axis(crease) < 0.01);
    assert(std::abs(crease.curve.tangent.x()) > 0.9999);
    assert(crease.curve.bend.norm() < 0.01);
    assert(std::abs(crease.fold - fold) < 0.02);
    assert(crease.residual < 0.01);
    assert(crease.is_sharp());
    for (double side : {-1., 1.})
    {
      const Vector expected(0., side * std::cos(0.5 * fold), -std::sin(0.5 * fold));
      assert((crease.strips[0] - expected).norm() < 0.02 || (crease.strips[1] - expected).norm() < 0.02);
    }
    assert((crease.strips[0] - crease.strips[1]).norm() > 0.5);
  }
}

void test_fit_follows_the_bend()
{
  const double radius = 8.;
  const Field_band band = rim(radius).sampled();
  Local_curve start;
  start.point = Vector(radius + 0.3, 0.1, 0.2);
  start.tangent = Vector::UnitY();
  const Crease crease = Crease_fit(band).fit(start, start.point, options_of(0., 0.));
  assert(std::abs(crease.curve.point.head<2>().norm() - radius) < 0.03);
  assert(std::abs(crease.curve.point.z()) < 0.03);
  assert((crease.curve.bend + Vector(1. / radius, 0., 0.)).norm() < 0.03);
  assert(std::abs(crease.curve.bend.dot(crease.curve.tangent)) < 1e-12);
}

// The deviations that are stated are those of the errors, roughly.
void test_fit_knows_its_errors()
{
  for (double noise : {0.05, 0.2})
  {
    double squares = 0., fold_squares = 0.;
    const int rounds = 40;
    for (int k = 0; k < rounds; ++k)
    {
      Sheet sheet = folded(90. * degree);
      sheet.surface_noise = noise;
      sheet.field_noise = 0.3;
      const Field_band band = sheet.sampled(static_cast<unsigned int>(k));
      const Crease crease = Crease_fit(band).fit(x_axis(), Vector::Zero(), options_of(noise, 0.3));
      squares += std::pow(distance_from_x_axis(crease) / crease.deviation, 2) / rounds;
      fold_squares += std::pow((crease.fold - 90. * degree) / crease.fold_deviation, 2) / rounds;
      assert(crease.residual > 0.5 * noise && crease.residual < 2. * noise);
    }
    assert(squares > 0.3 && squares < 4.);
    assert(fold_squares > 0.2 && fold_squares < 4.);
  }
}

// All distances may be too large or too small by the same.
void test_fit_corrects_the_bias_of_the_field()
{
  for (double bias : {-0.3, 0.3})
  {
    Sheet sheet = folded(90. * degree);
    sheet.distance = [bias](double, double t) { return std::abs(t) + bias; };
    const Field_band band = sheet.sampled();
    const Crease crease = Crease_fit(band).fit(first_guess(), first_guess().point, options_of(0., 0.3));
    assert(distance_from_x_axis(crease) < 0.05);
  }
}

// A flat sheet has no crease, even where the field wants one.
void test_fit_to_a_flat_sheet()
{
  for (double noise : {0., 0.1})
    for (unsigned int seed : {1u, 2u, 3u})
    {
      Sheet sheet = folded(0.);
      sheet.surface_noise = noise;
      const Field_band band = sheet.sampled(seed);
      const Crease crease = Crease_fit(band).fit(x_axis(), Vector::Zero(), options_of(noise, 0.1));
      assert(!crease.is_sharp());
      assert(crease.fold < 0.05 + 4. * crease.fold_deviation);
    }
}

void test_fit_to_hardly_any_points()
{
  Sheet sheet = folded(90. * degree);
  sheet.first = -1.;
  sheet.last = 1.;
  sheet.width = 2.;
  const Field_band band = sheet.sampled();
  const Local_curve start = first_guess();
  const Crease crease = Crease_fit(band).fit(start, start.point, options_of(0., 0.));
  assert(crease.curve.point == start.point && crease.curve.tangent == start.tangent);
  assert(crease.deviation == 1. && !crease.is_sharp());
}

// The strips of a crease close by go on, also where others would fit better: here those of the upper of two folds.
void test_fit_goes_on_with_previous_strips()
{
  const Field_band band = folded(90. * degree).sampled();
  Crease_fit fit(band);
  const Crease previous = fit.fit(x_axis(), Vector::Zero(), options_of(0., 0.));
  const Crease next = fit.fit(x_axis(0.5), Vector(0.5, 0., 0.), options_of(0., 0.), &previous);
  for (int k = 0; k < 2; ++k)
    assert((next.strips[k] - previous.strips[k]).norm() < 0.02);
}

// Where an edge ends at a corner, smaller balls, and those that lie behind, do not see what comes beyond.
void test_best_radius_at_the_end_of_an_edge()
{
  Sheet sheet = folded(90. * degree);
  sheet.last = 2.;
  Field_band band = sheet.sampled();
  const std::size_t count = band.points.size();
  // a face across the end of the edge
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(0., 6.);
  for (std::size_t k = 0; k < 36; ++k)
  {
    const double a = number(random), b = number(random);
    band.points.push_back(Vector(2., 0.7071 * (a - b), -0.7071 * (a + b)));
    band.distances.push_back((std::min)(a, b));
    band.indices.push_back(count + k);
  }
  band.search.build(band.points, band.points.size());
  Crease_fit fit(band);
  const Crease previous = fit.fit_with_best_radius(x_axis(-4.), options_of(0., 0.05));
  const Crease crease = fit.fit_with_best_radius(x_axis(1.), options_of(0., 0.05), &previous);
  const Crease large = fit.fit(x_axis(1.), Vector(1., 0., 0.), [] {
    Crease_fit_options options = options_of(0., 0.05);
    options.radius *= 1.5;
    return options;
  }());
  assert(distance_from_x_axis(crease) < 0.02);
  assert(crease.deviation <= large.deviation);
  assert(crease.residual <= large.residual);
}

void test_what_a_crease_holds()
{
  Crease crease;
  crease.strips[0] = Vector(0., 1., 0.);
  crease.strips[1] = Vector(0., 0., -1.);
  assert(crease.holds(Vector(3., 4., 0.05), 0.1));
  assert(crease.holds(Vector(-2., 0.05, -3.), 0.1));
  assert(crease.holds(Vector(0., -0.05, 0.), 0.1));  // just behind the crease
  assert(!crease.holds(Vector(0., -2., 0.), 0.1));   // far behind
  assert(!crease.holds(Vector(0., 1., 0.5), 0.1));   // above a strip
  assert(crease.holds(Vector(0., 4., 1.2), 0.1));    // which may be bent, more so farther away
  assert(!crease.holds(Vector(0., 1.5, -1.5), 0.1)); // between them
  // only what is beyond doubt is sharp
  crease.fold = 0.5;
  crease.fold_deviation = 0.1;
  assert(crease.is_sharp());
  crease.fold_deviation = 0.15;
  assert(!crease.is_sharp());
  crease.fold = 0.3;
  crease.fold_deviation = 0.01;
  assert(!crease.is_sharp());
}

// Crease_tracer ---------------------------------------------------------------------------------------

struct Tracing
{
  Field_band band;
  Crease_fit_options options;
  Traced_creases traced;

  Tracing(const Sheet& sheet, double surface_noise = 0., double field_noise = 0.1)
    : band(sheet.sampled()), options(options_of(surface_noise, field_noise))
  {}

  Crease_tracer tracer() const { return Crease_tracer(band, options, traced); }
  Crease seed(const Local_curve& start) const { return Crease_fit(band).fit_with_best_radius(start, options); }
  Crease_path trace(const Local_curve& start) const { return tracer().trace(seed(start)); }
};

double first_s(const Crease_path& path) { return path.creases.front().curve.point.x(); }
double last_s(const Crease_path& path) { return path.creases.back().curve.point.x(); }

double least_s(const Crease_path& path) { return (std::min)(first_s(path), last_s(path)); }
double largest_s(const Crease_path& path) { return (std::max)(first_s(path), last_s(path)); }

void test_trace_runs_to_both_ends()
{
  Sheet sheet = folded(90. * degree);
  sheet.first = -20.;
  const Tracing tracing(sheet);
  const Crease seed = tracing.seed(x_axis(3.));
  assert(tracing.tracer().may_start(seed) && tracing.tracer().goes_on(seed));
  const Crease_path path = tracing.tracer().trace(seed);
  assert(!path.is_closed);
  assert(least_s(path) < -18.5 && least_s(path) > -21.5);
  assert(largest_s(path) > 13.5 && largest_s(path) < 16.5);
  for (std::size_t k = 0; k < path.creases.size(); ++k)
  {
    assert(distance_from_x_axis(path.creases[k]) < 0.05);
    if (k > 0) // tangents point forward, and steps are small
    {
      const Vector step = path.creases[k].curve.point - path.creases[k - 1].curve.point;
      assert(step.norm() > 0.2 && step.norm() < 1.);
      assert(step.normalized().dot(path.creases[k].curve.tangent) > 0.95);
      assert(step.normalized().dot(path.creases[k - 1].curve.tangent) > 0.95);
    }
  }
  // the tips of the curve point outward
  const Traced_curve curve = tracing.tracer().curve_along(path);
  assert(!curve.is_closed && curve.points.size() == path.creases.size());
  for (int e = 0; e < 2; ++e)
  {
    const Vector inward = (e == 0 ? curve.points[1] : curve.points[curve.points.size() - 2]) - curve.tips[e].point;
    assert(inward.dot(curve.tips[e].tangent) < 0.);
  }
  assert(tracing.tracer().share_of_support(curve.points) > 0.9);
}

void test_trace_closes()
{
  const double radius = 8.;
  const Tracing tracing(rim(radius));
  Local_curve start;
  start.point = Vector(radius, 0., 0.);
  start.tangent = Vector::UnitY();
  const Crease_path path = tracing.trace(start);
  assert(path.is_closed);
  const Traced_curve curve = tracing.tracer().curve_along(path);
  assert(curve.is_closed && curve.points.front() == curve.points.back());
  assert(std::abs(polyline_length(curve.points) - 2. * CGAL_PI * radius) < 0.5);
  for (const Vector& p : curve.points)
    assert(std::abs(p.head<2>().norm() - radius) < 0.05 && std::abs(p.z()) < 0.05);
}

// a flat sheet, and one whose fold ends
void test_trace_ends_where_nothing_is_folded()
{
  const Tracing flat(folded(0.));
  assert(!flat.tracer().may_start(flat.seed(x_axis())));
  Sheet fading = folded(0.);
  fading.point = [](double s, double t) {
    const double fold = 90. * degree * (std::min)(1., (std::max)(0., 1. - s / 10.));
    return Vector(s, t * std::cos(0.5 * fold), -std::abs(t) * std::sin(0.5 * fold));
  };
  const Tracing tracing(fading);
  const Crease_path path = tracing.trace(x_axis(-5.));
  assert(least_s(path) < -13.5);
  assert(largest_s(path) > 2. && largest_s(path) < 9.);
}

// The field need not see a crease along its whole length, but it may deny only so much of it.
void test_gaps_in_the_field()
{
  const auto length_with_gap = [](double gap) {
    Sheet sheet = folded(90. * degree);
    sheet.first = -15.;
    sheet.last = gap + 15.;
    sheet.distance = [gap](double s, double t) { return s > 0. && s < gap ? std::abs(t) + 5. : std::abs(t); };
    const Crease_path path = Tracing(sheet).trace(x_axis(-8.));
    assert(least_s(path) < -13.);
    return largest_s(path);
  };
  assert(length_with_gap(10.) > 23.);
  assert(length_with_gap(30.) > 43.);
  // what lies beyond belongs to it no more, nor does the gap
  for (double gap : {50., 70.})
  {
    const double end = length_with_gap(gap);
    assert(end > -2. && end < 3.);
  }
}

// No curve runs along one that was kept.
void test_trace_ends_at_kept_curves()
{
  Tracing tracing(folded(90. * degree));
  const Crease seed = tracing.seed(x_axis(-8.));
  const std::vector<Vector> kept{Vector(2., 0.1, 0.), Vector(30., 0.1, 0.)};
  assert(!tracing.tracer().is_traced(x_axis(5.)));
  tracing.traced.add(kept);
  assert(tracing.tracer().is_traced(x_axis(5.)));
  assert(!tracing.tracer().is_traced(x_axis(-5.)));
  Local_curve across = x_axis(5.);
  across.tangent = Vector::UnitY();
  assert(!tracing.tracer().is_traced(across));
  Local_curve beside = x_axis(5.);
  beside.point.y() = 1.;
  assert(!tracing.tracer().is_traced(beside));
  const Crease_path path = tracing.tracer().trace(seed);
  assert(least_s(path) < -13.5);
  // not even by the steps that it takes to see that it is no crossing
  assert(largest_s(path) > 1. && largest_s(path) < 2.1);
}

// Two fifths of the fits along a curve are better than its residual, in whatever order they come.
void test_typical_residual()
{
  Traced_curve curve;
  assert(curve.typical_residual() >= 1.); // nothing speaks for it
  for (int i = 0; i < 10; ++i)
    curve.residuals.push_back(0.1 * ((7 * i) % 10));
  assert(std::abs(curve.typical_residual() - 0.4) < 1e-12);
  curve.residuals.assign(1, 0.25);
  assert(curve.typical_residual() == 0.25);
}

// Steps that were not sure are no part of the path: where they lead to a kept curve, nothing is taken off.
void test_unsure_steps_along_kept_curves()
{
  Sheet sheet = folded(90. * degree);
  sheet.last = 0.;
  Tracing tracing(sheet);
  const double end = largest_s(tracing.trace(x_axis(-8.)));
  assert(end > -1.5);
  bool was_stopped = false;
  for (double shift : {0.5, 0.6, 0.7, 0.8, 0.9})
  {
    Tracing with_kept(sheet); // beyond the reach of the last sure step
    with_kept.traced.add({Vector(end + shift, 0., 0.), Vector(30., 0., 0.)});
    const Crease_path path = with_kept.trace(x_axis(-8.));
    assert(std::abs(largest_s(path) - end) < 1e-9);
    const Local_curve& front =
      *std::max_element(path.fronts.begin(), path.fronts.end(),
                        [](const Local_curve& a, const Local_curve& b) { return a.point.x() < b.point.x(); });
    was_stopped |= with_kept.tracer().is_traced(front);
  }
  assert(was_stopped);
}

// What was traced without knowing of some curve holds if that one runs elsewhere only.
void test_paths_depend_on_curves_along_them()
{
  const Tracing tracing(folded(90. * degree));
  const Crease_path path = tracing.trace(x_axis());
  Traced_creases along, elsewhere, across, ahead;
  assert(!tracing.tracer().depends_on(along, path));
  along.add({Vector(5., 0.1, 0.), Vector(8., 0.1, 0.)});
  assert(tracing.tracer().depends_on(along, path));
  elsewhere.add({Vector(-30., 4., 0.), Vector(30., 4., 0.)});
  assert(!tracing.tracer().depends_on(elsewhere, path));
  across.add({Vector(0., -10., 0.), Vector(0., 10., 0.)});
  assert(!tracing.tracer().depends_on(across, path));
  // beyond the end of the path, where it was asked as well
  ahead.add({Vector(largest_s(path) + 0.6, 0., 0.), Vector(40., 0., 0.)});
  assert(tracing.tracer().depends_on(ahead, path));
}

// Field_refinement ------------------------------------------------------------------------------------

// the points of a sheet with the local curves that a contraction finds for those near its crease, the x-axis
struct Contracted
{
  Field_band band;
  Contraction contraction;

  explicit Contracted(const Sheet& sheet, double noise)
  {
    const Field_band sampled = sheet.sampled();
    std::vector<std::size_t> order = sampled.indices;
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return sampled.distances[a] < sampled.distances[b]; });
    for (std::size_t i : order)
    {
      band.points.push_back(sampled.points[i]);
      band.distances.push_back(sampled.distances[i]);
      band.indices.push_back(i);
      if (sampled.distances[i] >= 1.5)
        continue;
      contraction.curves.push_back(x_axis(sampled.points[i].x()));
      contraction.residuals.push_back(noise);
    }
    band.skeleton_size = contraction.curves.size();
    band.search.build(band.points, band.points.size());
    contraction.noise = noise;
  }
};

bool go_on(double) { return true; }

// A curve along a crease that the field denies for the most part is not kept. It is not followed
// from each of its places.
void test_rejected_curves_are_followed_once()
{
  Sheet sheet = folded(90. * degree);
  sheet.first = -30.;
  sheet.last = 30.;
  sheet.distance = [](double s, double t) { return std::abs(t) + (std::abs(s) < 6. ? 0. : 5.); };
  const Contracted contracted(sheet, 0.1);
  Field_refinement refinement(contracted.band, contracted.contraction, 4.);
  const bool is_complete = refinement.run(go_on);
  assert(is_complete && contracted.band.skeleton_size > 20);
  assert(refinement.curves().empty());
  assert(refinement.number_of_traces() > 0 && refinement.number_of_traces() < 5);
  // one that the field affirms is kept, and followed once as well
  sheet.distance = [](double, double t) { return std::abs(t); };
  const Contracted affirmed(sheet, 0.1);
  Field_refinement other(affirmed.band, affirmed.contraction, 4.);
  assert(other.run(go_on) && other.curves().size() == 1);
  assert(other.curves()[0].length() > 55.);
  assert(other.number_of_traces() < 5);
}

// A field with errors becomes better where the surface is folded; where it is flat, it has no crease.
void test_refined_distances()
{
  Sheet sheet = folded(90. * degree);
  sheet.field_noise = 0.3;
  std::vector<double> distances, deviations;
  std::vector<char> is_on_crease;
  const Contracted contracted(sheet, 0.3);
  Field_refinement refinement(contracted.band, contracted.contraction, 4.);
  assert(refinement.run(go_on));
  assert(refinement.compute_distances(go_on, distances, deviations, is_on_crease));
  assert(refinement.surface_noise() < 0.03 && refinement.typical_deviation() < 0.1);
  const auto true_distance = [&](std::size_t i) { return contracted.band.points[i].tail<2>().norm(); };
  for (std::size_t i = 0; i < contracted.band.size(); ++i)
    if (true_distance(i) < 1.5 && std::abs(contracted.band.points[i].x()) < 13.)
    {
      assert(std::abs(distances[i] - true_distance(i)) < 0.1);
      assert(is_on_crease[i]);
    }
  sheet.point = folded(0.).point;
  const Contracted flat(sheet, 0.3);
  Field_refinement of_flat(flat.band, flat.contraction, 4.);
  assert(of_flat.run(go_on));
  assert(of_flat.compute_distances(go_on, distances, deviations, is_on_crease));
  assert(of_flat.curves().empty());
  std::size_t folded_ones = 0;
  for (std::size_t i = 0; i < flat.band.skeleton_size; ++i)
    folded_ones += bool(is_on_crease[i]);
  assert(5 * folded_ones < flat.band.skeleton_size);
}

} // namespace

int main()
{
  test_fit_finds_the_crease();
  test_fit_follows_the_bend();
  test_fit_knows_its_errors();
  test_fit_corrects_the_bias_of_the_field();
  test_fit_to_a_flat_sheet();
  test_fit_to_hardly_any_points();
  test_fit_goes_on_with_previous_strips();
  test_best_radius_at_the_end_of_an_edge();
  test_what_a_crease_holds();
  test_trace_runs_to_both_ends();
  test_trace_closes();
  test_trace_ends_where_nothing_is_folded();
  test_gaps_in_the_field();
  test_trace_ends_at_kept_curves();
  test_typical_residual();
  test_unsure_steps_along_kept_curves();
  test_paths_depend_on_curves_along_them();
  test_rejected_curves_are_followed_once();
  test_refined_distances();
  return 0;
}
