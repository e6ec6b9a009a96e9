// Parts of the stages, on what is known in closed form or by trying all.

#include "drawn_curves.h"

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/different_positions.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Field_slopes.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_end_joiner.h>
#include <CGAL/Wireframe_extraction/internal/network/Fold_evidence.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/polyline_feet.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_curve.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

typedef std::vector<Vector> Polyline;

Vector random_vector(std::mt19937& random, double size)
{
  std::uniform_real_distribution<double> number(-size, size);
  const double x = number(random), y = number(random), z = number(random);
  return Vector(x, y, z);
}

Polyline circle(double radius, std::size_t count)
{
  Polyline points;
  for (std::size_t k = 0; k < count; ++k)
    points.push_back(radius * Vector(std::cos(2. * CGAL_PI * k / count), std::sin(2. * CGAL_PI * k / count), 0.));
  points.push_back(points.front());
  return points;
}

Polyline straight(const Vector& from, const Vector& to, std::size_t count)
{
  Polyline points;
  for (std::size_t k = 0; k <= count; ++k)
    points.push_back(from + (to - from) * (double(k) / double(count)));
  return points;
}

// A closed curve at which several others end falls into pieces between them: none of it is lost, and none runs twice.
void test_closed_curve_that_is_split_several_times()
{
  const double radius = 100.;
  for (const std::vector<double>& angles :
       {std::vector<double>{40.}, {40., 200.}, {200., 40.}, {10., 130., 131., 300.}})
  {
    std::vector<Traced_curve> traced(1);
    traced[0].points = circle(radius, 1200);
    traced[0].is_closed = true;
    for (double angle : angles)
    {
      const Vector outward(std::cos(angle * CGAL_PI / 180.), std::sin(angle * CGAL_PI / 180.), 0.);
      traced.push_back(open_curve(straight(radius * outward, (radius + 60.) * outward, 120)));
    }
    Curve_network network(traced);
    Curve_end_joiner(network, Joining_options()).join();
    double on_circle = 0.;
    std::size_t pieces = 0;
    for (const Network_curve& curve : network.curves)
    {
      if (!curve.is_alive || std::abs(curve.points[curve.points.size() / 2].norm() - radius) > 1.)
        continue;
      ++pieces;
      on_circle += polyline_length(curve.points);
      for (std::size_t k = 1; k < curve.points.size(); ++k)
        assert((curve.points[k] - curve.points[k - 1]).norm() < 2.);
    }
    assert(pieces == angles.size());
    assert(std::abs(on_circle - 2. * CGAL_PI * radius) < 1.);
  }
}

// places along a polyline that has a segment without length
void test_polyline_walk()
{
  const Polyline polyline{Vector(0., 0., 0.), Vector(2., 0., 0.), Vector(2., 0., 0.), Vector(2., 3., 0.)};
  const std::vector<double> lengths = arc_lengths(polyline);
  assert((lengths == std::vector<double>{0., 2., 2., 5.}));
  assert(polyline_length(polyline) == 5.);
  const std::vector<double> increasing = arc_lengths(polyline, 0.5);
  assert((increasing == std::vector<double>{0., 2., 2.5, 5.5}));
  Polyline_walk walk(polyline, lengths);
  assert(walk.advance_to(0.) == polyline[0]);
  assert(walk.advance_to(0.5) == Vector(0.5, 0., 0.));
  assert(walk.segment() == Vector(2., 0., 0.));
  assert(walk.advance_to(2.) == polyline[1]);
  assert(walk.advance_to(4.) == Vector(2., 2., 0.));
  assert(walk.segment() == Vector(0., 3., 0.));
  assert(walk.advance_to(5.) == polyline[3]);
}

// the nearest feet on several polylines, against trying every segment
void test_nearest_feet()
{
  std::mt19937 random(1);
  Field_band band;
  for (int k = 0; k < 3000; ++k)
    band.points.push_back(random_vector(random, 20.));
  band.search.build(band.points, band.points.size());
  std::vector<Polyline> polylines{circle(12., 150), straight(Vector(-18., 3., 1.), Vector(17., -2., 4.), 1),
                                  straight(Vector(0., 0., -15.), Vector(0., 0., 15.), 40)};
  Polyline walk{Vector(5., 5., 5.)};
  for (int k = 0; k < 60; ++k)
    walk.push_back(walk.back() + random_vector(random, 1.));
  walk.push_back(walk.back()); // a segment without length
  polylines.push_back(walk);
  const double radius = 4.;
  const std::vector<Polyline_foot> feet = nearest_feet(band, pointers_to(polylines), radius);
  std::size_t valid = 0;
  for (std::size_t i = 0; i < band.points.size(); ++i)
  {
    double nearest = radius * radius;
    for (const Polyline& polyline : polylines)
      for (std::size_t k = 1; k < polyline.size(); ++k)
        nearest = (std::min)(nearest, squared_distance_to_segment(band.points[i], polyline[k - 1], polyline[k]));
    assert(feet[i].is_valid() == (nearest < radius * radius));
    if (!feet[i].is_valid())
      continue;
    ++valid;
    assert(std::abs(feet[i].distance - std::sqrt(nearest)) < 1e-9);
    const Polyline& nearest_polyline = polylines[feet[i].curve];
    assert(std::abs(feet[i].interpolate(arc_lengths(nearest_polyline)) - arc_lengths(nearest_polyline)[feet[i].segment]
                    - (feet[i].point(nearest_polyline) - nearest_polyline[feet[i].segment]).norm())
           < 1e-9);
    assert(std::abs((feet[i].point(nearest_polyline) - band.points[i]).norm() - feet[i].distance) < 1e-9);
  }
  assert(valid > 300 && valid < 2700);
}

// Two half-planes that leave the x-axis, each turned down by half of `fold`; turned up where x is positive if it
// `changes_sides`.
Field_band folded_surface(double fold, double noise, double curvature, std::mt19937& random, bool changes_sides = false)
{
  std::normal_distribution<double> error(0., 1.);
  std::uniform_real_distribution<double> along(-12., 12.), across(-6., 6.);
  Field_band band;
  for (int k = 0; k < 24 * 12; ++k)
  {
    const double s = along(random), x = across(random);
    const double side = changes_sides && s > 0. ? -1. : 1.;
    band.points.push_back(
      Vector(s, x * std::cos(0.5 * fold), -side * std::abs(x) * std::sin(0.5 * fold) + 0.5 * curvature * x * x)
      + noise * Vector(error(random), error(random), error(random)));
  }
  band.search.build(band.points, band.points.size());
  return band;
}

void test_fold_evidence()
{
  std::mt19937 random(2);
  const Polyline curve = straight(Vector(-10., 0., 0.), Vector(10., 0., 0.), 40);
  for (double noise : {0., 0.05, 0.2})
    for (double degrees : {0., 20., 45., 90.})
      for (int k = 0; k < 10; ++k)
      {
        const double fold = degrees * CGAL_PI / 180.;
        const Field_band band = folded_surface(fold, noise, 0., random);
        const Fold_evidence::Fold found = Fold_evidence(band).folds({&curve, nullptr})[0];
        assert(found.is_known);
        assert(found.deviation < 0.05 + 0.5 * noise);
        // the plane under the heights follows the points, which matters where the slope is steep
        const double slope = std::tan(0.5 * fold);
        assert(std::abs(found.slope - slope) < 0.02 + 0.15 * slope + 4. * found.deviation);
      }
  // the edge of a thin wall is no smooth surface, even if there is nothing else
  for (double thickness : {1., 2., 3.})
  {
    std::uniform_real_distribution<double> share(0., 1.);
    std::normal_distribution<double> error(0., 0.25);
    Field_band wall;
    for (int k = 0; k < 24 * 14; ++k)
    {
      const double s = 24. * share(random) - 12., place = (12. + thickness) * share(random) - 6.;
      const double across = place < 0. ? -0.5 : place > thickness ? 0.5 : place / thickness - 0.5;
      const double along = place < 0. ? -place : place > thickness ? place - thickness : 0.;
      wall.points.push_back(Vector(s, across * thickness, -along)
                            + Vector(error(random), error(random), error(random)));
    }
    wall.search.build(wall.points, wall.points.size());
    const Fold_evidence::Fold found = Fold_evidence(wall).folds({&curve})[0];
    assert(!found.is_known || found.slope + found.deviation > 0.15);
  }
  // a fold up and a fold down do not make a smooth surface
  for (double degrees : {45., 90.})
  {
    const Field_band band = folded_surface(degrees * CGAL_PI / 180., 0.05, 0., random, true);
    const Fold_evidence::Fold found = Fold_evidence(band).folds({&curve})[0];
    assert(!found.is_known || found.slope > 0.15);
  }
  // what is folded sharply is not a graph over the plane of most of its points, but never smooth either
  for (double degrees : {120., 150., 165.})
  {
    const Field_band band = folded_surface(degrees * CGAL_PI / 180., 0.02, 0., random);
    const Fold_evidence::Fold found = Fold_evidence(band).folds({&curve})[0];
    assert(!found.is_known || found.slope + found.deviation > 0.15);
  }
  // a cylinder is not folded; a surface that is no graph over a plane says nothing
  const Field_band cylinder = folded_surface(0., 0.02, 0.1, random);
  const Fold_evidence::Fold found = Fold_evidence(cylinder).folds({&curve})[0];
  assert(found.is_known && found.slope < 0.1);
  Field_band cloud;
  for (int k = 0; k < 3000; ++k)
    cloud.points.push_back(random_vector(random, 11.));
  cloud.search.build(cloud.points, cloud.points.size());
  const Fold_evidence::Fold nothing = Fold_evidence(cloud).folds({&curve})[0];
  assert(!nothing.is_known || nothing.slope + nothing.deviation > 0.15);
  // nor does one without points
  Field_band empty;
  empty.search.build(empty.points, 0);
  assert(!Fold_evidence(empty).folds({&curve})[0].is_known);
}

// A short edge between two others that lead away from its ends at right angles: whether the surface is folded along it
// is told from few points, and not from those of a sheet that passes near.
void test_fold_of_edge()
{
  std::mt19937 random(5);
  const Vector from(-2.5, 0., 0.), to(2.5, 0., 0.);
  const auto found = [&](Field_band band, double noise, bool has_sheet) {
    if (has_sheet)
      for (double x : {-1.5, -0.5, 0.5, 1.5})
        band.points.push_back(Vector(x, 0., 2.));
    band.search.build(band.points, band.points.size());
    std::vector<double> to_others;
    for (const Vector& p : band.points)
      to_others.push_back((std::min)(std::abs(p.x() - from.x()), std::abs(p.x() - to.x())));
    return Fold_evidence(band).fold_of_edge(from, to, to_others, noise);
  };
  static constexpr int rounds = 200;
  for (double noise : {0.01, 0.2})
    for (bool has_sheet : {false, true})
    {
      int flat_as_folded = 0, cylinder_as_folded = 0, folded_as_folded = 0;
      for (int k = 0; k < rounds; ++k)
      {
        flat_as_folded += found(folded_surface(0., noise, 0., random), noise, has_sheet).is_folded_beyond_doubt();
        cylinder_as_folded += found(folded_surface(0., noise, 0.1, random), noise, has_sheet).is_folded_beyond_doubt();
        const Fold_evidence::Fold fold = found(folded_surface(CGAL_PI / 2., noise, 0., random), noise, has_sheet);
        folded_as_folded += fold.is_folded_beyond_doubt();
        assert(has_sheet || !fold.is_known || std::abs(fold.slope - 1.) < 0.1 + 5. * fold.deviation);
      }
      const int most = has_sheet ? rounds / 20 : rounds / 100;
      assert(flat_as_folded <= most && cylinder_as_folded <= most);
      assert(folded_as_folded > (noise < 0.1 ? 0.9 : 0.5) * rounds);
    }
  // of no points, nothing is known
  Field_band empty;
  empty.search.build(empty.points, 0);
  assert(!Fold_evidence(empty).fold_of_edge(from, to, {}, 0.1).is_known);
}

// In a thin part few points are away from features, and their slopes may happen to grow with the field as those of an
// exponential do: it is one only if all slopes do.
void test_slopes_of_thin_parts()
{
  for (bool is_exponential : {false, true})
  {
    Field_slopes slopes;
    std::mt19937 random(4);
    std::uniform_real_distribution<double> share(0., 1.);
    const auto add = [&](double field, double gradient, double step) {
      std::vector<std::pair<Vector, double>> neighbors;
      for (double x : {-step, step})
        for (double y : {-step, step})
          neighbors.emplace_back(Vector(x, y, 0.), field + gradient * x);
      slopes.add(field, neighbors);
    };
    for (int k = 0; k < 400; ++k)
    {
      const double field = 0.2 + share(random), error = 0.9 + 0.2 * share(random);
      if (k % 4 == 0)
      {
        add(field, 0.5 * error * field, 0.1);
        continue;
      }
      // the values around these are beyond twice their own
      const double near_feature = is_exponential ? 0.5 * error * field : 0.4 + 0.4 * share(random);
      add(field, near_feature, 1.5 * field / near_feature);
    }
    Cloud_scale scale;
    slopes.describe(scale);
    assert((scale.meaning == Field_meaning::EXPONENTIAL) == is_exponential);
  }
}

// derivatives of feet on lines and circles, against differences
void test_foot_derivatives()
{
  std::mt19937 random(3);
  for (Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE})
    for (int round = 0; round < 50; ++round)
    {
      Primitive_curve curve;
      curve.kind = kind;
      curve.center = random_vector(random, 5.);
      curve.axis = random_vector(random, 1.).normalized();
      curve.major = curve.axis.unitOrthogonal();
      curve.major_radius = curve.minor_radius = 3. + random_vector(random, 1.).norm();
      const Vector p = random_vector(random, 6.);
      std::array<Vector, Primitive_curve::most_parameters> columns;
      curve.foot_derivatives(p, columns);
      for (int i = 0; i < curve.number_of_parameters(); ++i)
      {
        double step[Primitive_curve::most_parameters] = {};
        step[i] = 1e-6;
        const Vector ahead = curve.moved(step).foot(p);
        step[i] = -1e-6;
        const Vector difference = (ahead - curve.moved(step).foot(p)) / 2e-6;
        assert((columns[i] - difference).norm() < 1e-4 * (1. + difference.norm()));
      }
    }
}

// what Eigen gives, to the last bit
void test_matrix()
{
  typedef Eigen::Matrix3d Expected;
  std::mt19937 random(5);
  const auto check = [](const Expected& expected, const Matrix_3& found) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        assert(found(i, j) == expected(i, j) && found.column(j)[i] == expected(i, j));
  };
  for (int round = 0; round < 500; ++round)
  {
    Expected a, b;
    Matrix_3 m, n;
    for (int i = 0; i < 3; ++i)
    {
      const Vector row = random_vector(random, 1.), other = random_vector(random, 1.);
      a.row(i) = row.transpose();
      b.row(i) = other.transpose();
      m.set_row(i, row);
      n.set_row(i, other);
    }
    const Vector v = random_vector(random, 1.), w = random_vector(random, 1.);
    const double s = v.dot(w);
    check(a + b * a, m + n * m);
    check(a * b * a.transpose(), m * n * m.transposed());
    check(a / s - s * Expected::Identity(), m / s - s * Matrix_3::Identity());
    check(s * v * w.transpose(), Matrix_3::outer(s * v, w));
    assert(m * v == Vector(a * v) && (s * m) * v == Vector(s * a * v));
    assert(m.transposed_times(v) == Vector(a.transpose() * v));
    assert(m.trace() == a.trace() && m.is_finite());
    m(round % 3, round / 3 % 3) = std::numeric_limits<double>::infinity();
    assert(!m.is_finite());
  }
}

void test_different_positions()
{
  std::mt19937 random(4);
  Polyline positions;
  for (int k = 0; k < 2000; ++k)
  {
    const Vector p = random_vector(random, 4.);
    positions.push_back(Vector(std::round(p.x()), std::round(p.y()), std::round(p.z())));
  }
  const std::vector<std::size_t> found = different_positions(positions);
  std::vector<std::size_t> expected;
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (std::find(positions.begin(), positions.begin() + i, positions[i]) == positions.begin() + i)
      expected.push_back(i);
  assert(found == expected);
  assert(found.size() < positions.size());
}

} // namespace

int main()
{
  test_closed_curve_that_is_split_several_times();
  test_polyline_walk();
  test_nearest_feet();
  test_fold_evidence();
  test_fold_of_edge();
  test_slopes_of_thin_parts();
  test_foot_derivatives();
  test_matrix();
  test_different_positions();
  return 0;
}
