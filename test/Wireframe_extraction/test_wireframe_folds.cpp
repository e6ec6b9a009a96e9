// What finds folds of a surface in bare points, piece by piece, against closed forms.

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_fit.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_scales.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_votes.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Sheet_fit.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Sheet_pair.h>
#include <CGAL/Wireframe_extraction/internal/estimate/estimate_field.h>
#include <CGAL/Wireframe_extraction/internal/estimate/point_noise.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

typedef std::vector<Vector> Points;

const double density = 0.82; // points per squared sampling distance

class Sampler
{
  std::mt19937 m_engine;

public:
  explicit Sampler(unsigned int seed) : m_engine(seed) {}

  // std::uniform_real_distribution differs between libraries
  double uniform(double least, double most) { return least + (most - least) * double(m_engine()) / 4294967296.; }

  double gaussian()
  {
    const double u = uniform(1e-12, 1.);
    return std::sqrt(-2. * std::log(u)) * std::cos(2. * CGAL_PI * uniform(0., 1.));
  }

  // Half-planes that meet in the y axis, folded by `angle` (radians) against each other, each `width` wide and 2
  // `length` long, moved by noise across.
  Points folded_plane(double angle, double width, double length, double noise)
  {
    Points points;
    const double tilt = angle / 2.;
    for (double side : {-1., 1.})
      for (std::size_t n = 0; n < std::size_t(density * width * 2. * length); ++n)
      {
        const double t = uniform(0., width), e = noise * gaussian();
        const Vector along(side * std::cos(tilt), 0., -std::sin(tilt)),
          across(side * std::sin(tilt), 0., std::cos(tilt));
        points.push_back(t * along + Vector(0., uniform(-length, length), 0.) + e * across);
      }
    return points;
  }

  Points sphere(double radius, double noise)
  {
    Points points;
    for (std::size_t n = 0; n < std::size_t(density * 4. * CGAL_PI * radius * radius); ++n)
    {
      const Vector d(gaussian(), gaussian(), gaussian());
      points.push_back(d.normalized() * (radius + noise * gaussian()));
    }
    return points;
  }
};

Points tube(Sampler& sampler, double radius, double noise)
{
  static constexpr double large_radius = 25.;
  Points points;
  const double area = 4. * CGAL_PI * CGAL_PI * large_radius * radius;
  while (points.size() < std::size_t(density * area))
  {
    const double around = sampler.uniform(0., 2. * CGAL_PI), along = sampler.uniform(0., 2. * CGAL_PI);
    // the inner side has less area
    if (sampler.uniform(0., large_radius + radius) > large_radius + radius * std::cos(around))
      continue;
    const double r = radius + noise * sampler.gaussian(), distance = large_radius + r * std::cos(around);
    points.push_back(Vector(distance * std::cos(along), distance * std::sin(along), r * std::sin(around)));
  }
  return points;
}

Points ball(const Points& points, const Vector& center, double radius)
{
  Points result;
  for (const Vector& p : points)
    if ((p - center).norm() < radius)
      result.push_back(p - center);
  return result;
}

const auto go_on = [](double) { return true; };

double median_of(const std::vector<double>& values)
{
  assert(!values.empty());
  return median(values);
}

void test_fold_of_a_height_function()
{
  Sampler sampler(1);
  for (double degrees : {45., 60., 90.})
  {
    const double angle = degrees * CGAL_PI / 180.;
    const Points points = sampler.folded_plane(angle, 20., 20., 0.);
    const Fold_scales scales(0.);
    Fold_fit fit;
    std::vector<double> errors, angles, margins;
    for (double x = -1.5; x <= 1.5; x += 0.25)
    {
      const Vector center(x * std::cos(angle / 2.), 4. * x, -std::abs(x) * std::sin(angle / 2.));
      const double variance = scales.deviation * scales.deviation;
      const Fold_fit_result result = fit.fit(ball(points, center, 4.), 4., variance, 0.85 * variance);
      assert(result.number_of_folds >= 1 && !result.is_smooth);
      const Fold& fold = result.folds[0];
      assert(fold.evidence > scales.strong_evidence);
      const Vector foot = center + fold.foot;
      errors.push_back(std::hypot(foot.x(), foot.z()));
      angles.push_back(fold.angle);
      margins.push_back(fold.margin);
    }
    assert(median_of(errors) < 0.05);
    assert(std::abs(median_of(angles) - angle) < 0.1 * angle);
    assert(median_of(margins) > scales.large.strong_margin);
  }
}

void test_no_fold_on_a_smooth_surface()
{
  Sampler sampler(2);
  const Points points = sampler.sphere(15., 0.);
  Fold_fit fit;
  const double variance = Fold_scales::least_deviation * Fold_scales::least_deviation;
  for (std::size_t i = 0; i < 200; ++i)
    assert(fit.fit(ball(points, points[i], 4.), 4., variance, 0.85 * variance).is_smooth);
  assert(!std::isfinite(fit.residual_of_sheet(Points(3, Vector::Zero())))); // too few points
}

void test_noise_of_points()
{
  Sampler sampler(3);
  for (double noise : {0., 0.1, 0.25, 0.5})
  {
    const Points points = sampler.folded_plane(1.5, 25., 25., noise);
    const double found = point_noise(points, Ball_search(points));
    assert(std::abs(found - noise) < 0.01 + 0.1 * noise);
  }
  // a wall of two sheets 1.5 apart: no large ball holds one sheet only
  Points wall = sampler.folded_plane(0., 25., 25., 0.1);
  for (const Vector& p : sampler.folded_plane(0., 25., 25., 0.1))
    wall.push_back(p + Vector(0., 0., 2.5));
  assert(point_noise(wall, Ball_search(wall)) < 0.2);
}

// the sheet of a point next to a fold is its own face, whatever else the ball holds
void test_sheets_next_to_a_fold()
{
  Sampler sampler(4);
  const double angle = CGAL_PI / 2.;
  const Points points = sampler.folded_plane(angle, 12., 12., 0.);
  const Ball_search search(points);
  Sheet_fit fit(Fold_scales::least_deviation);
  const Vector normals[2] = {Vector(-std::sin(angle / 2.), 0., std::cos(angle / 2.)),
                             Vector(std::sin(angle / 2.), 0., std::cos(angle / 2.))};
  std::vector<Sheet> sheets(2);
  std::size_t known = 0, looked_at = 0;
  for (const Vector& p : points)
  {
    if (std::abs(p.x()) > 1. || std::abs(p.y()) > 6.)
      continue;
    std::vector<Plane_of_points> planes;
    Points around;
    for (const Vector& q : points)
    {
      const double distance = (q - p).norm();
      if (distance < 3.)
        around.push_back(q - p);
      if (distance < 2.5) // those of the faces, and one that is neither
        planes.push_back({q, normals[q.x() > 0.]});
    }
    planes.push_back({p, Vector(0., 0., 1.)});
    ++looked_at;
    const Sheet sheet = fit.fit(p, around, planes);
    if (!sheet.is_known)
      continue;
    ++known;
    Vector normal;
    assert(std::abs(sheet.offset(p, &normal)) < fit.tolerance());
    if (std::abs(p.x()) > 0.2)
      assert(std::abs(normal.dot(normals[p.x() > 0.])) > 0.99);
  }
  assert(looked_at > 10 && known > 0.9 * double(looked_at));
}

// the axes in the plane of a sheet are arbitrary
void test_sheets_turn_with_their_points()
{
  const auto saddle = [](double turn) {
    Points points;
    const Eigen::AngleAxisd rotation(turn, Vector::UnitZ());
    for (double x = -2.; x <= 2.; x += 0.5)
      for (double y = -2.; y <= 2.; y += 0.5)
        points.push_back(rotation * Vector(x, y, 0.05 * x * y));
    const Plane_of_points plane{Vector::Zero(), Vector::UnitZ()};
    const Sheet sheet = Sheet_fit(0.3).fit(Vector::Zero(), points, {plane});
    assert(sheet.is_known);
    return sheet.offset(rotation * Vector(1.5, 1.5, 0.));
  };
  for (double turn : {0.3, 0.8})
    assert(std::abs(saddle(turn) - saddle(0.)) < 1e-6);
}

Sheet plane(const Vector& through, const Vector& normal)
{
  Sheet sheet;
  sheet.set_plane(through, normal.normalized());
  sheet.is_known = true;
  return sheet;
}

void test_pairs_of_sheets()
{
  static constexpr double tolerance = 0.12;
  const Sheet a = plane(Vector(1., 0., 0.), Vector(0., 0., 1.)), b = plane(Vector(0., 0., 1.), Vector(1., 0., 0.));
  Sheet_pair pair(a, b, tolerance);
  assert(pair.meet_near(Vector(0.8, 0.3, 0.)));
  assert((pair.foot() - Vector(0., 0.3, 0.)).norm() < 1e-9);
  // planes that are parallel, or meet far away, do not meet
  const Sheet c = plane(Vector(0., 0., 2.), Vector(0., 0., 1.));
  assert(!Sheet_pair(a, c, tolerance).meet_near(Vector(0.8, 0.3, 0.)));
  const Sheet d = plane(Vector(9., 0., 0.), Vector(1., 0., 0.));
  assert(!Sheet_pair(a, d, tolerance).meet_near(Vector(0.8, 0.3, 0.)));

  Points corner, crossing;
  for (double t = 0.2; t < 2.; t += 0.3)
    for (double y = -1.5; y <= 1.5; y += 0.5)
    {
      for (double side : {1., -1.})
        crossing.push_back(Vector(side * t, y, 0.));
      corner.push_back(Vector(t, y, 0.));
      corner.push_back(Vector(0., y, t));
      crossing.push_back(Vector(0., y, t));
    }
  assert(pair.find_ends(crossing) == Sheet_pair::Ends::NOT_BOTH); // one of the sheets goes on
  assert(pair.find_ends(Points(1, corner[0])) == Sheet_pair::Ends::UNKNOWN);
  assert(pair.find_ends(corner) == Sheet_pair::Ends::BOTH);
  assert(std::abs(pair.angle() - CGAL_PI / 2.) < 1e-9);
  assert(pair.margin(corner, 0.04) > 30.);

  // a cylinder is no fold, though the tangent planes of two of its places meet
  const double radius = 6.;
  Points round;
  for (double t = -0.4; t <= 0.4; t += 0.05)
    for (double y = -2.; y <= 2.; y += 0.5)
      round.push_back(Vector(radius * std::sin(t), y, radius * std::cos(t)));
  const auto tangent = [&](double t) {
    return plane(Vector(radius * std::sin(t), 0., radius * std::cos(t)), Vector(std::sin(t), 0., std::cos(t)));
  };
  const Sheet left = tangent(-0.15), right = tangent(0.15);
  Sheet_pair smooth(left, right, tolerance);
  assert(smooth.meet_near(Vector(0., 0., radius)));
  assert(smooth.margin(round, 0.04) < 15.);
}

// The same two planes are folded a little if their points lie to both sides of where they meet, and the edge of a knife
// if they lie to one side.
void test_angles_of_folds()
{
  for (double degrees : {15., 25., 60., 90., 120., 155., 165.})
  {
    const double fold = degrees * CGAL_PI / 180., tilt = fold / 2.;
    Points points;
    for (double side : {1., -1.})
      for (double t = 0.5; t < 2.; t += 0.25)
        for (double y = -1.5; y <= 1.5; y += 0.5)
          points.push_back(Vector(side * t * std::cos(tilt), y, -t * std::sin(tilt)));
    const auto sheet = [&](double side, double sign) {
      return plane(Vector(side * std::cos(tilt), 0., -std::sin(tilt)),
                   sign * Vector(side * std::sin(tilt), 0., std::cos(tilt)));
    };
    for (double sign : {1., -1.}) // sheets have no sides
    {
      const Sheet a = sheet(1., 1.), b = sheet(-1., sign);
      Sheet_pair pair(a, b, 0.12);
      assert(pair.meet_near(Vector(0.1, 0.2, 0.)));
      assert(pair.find_ends(points) == Sheet_pair::Ends::BOTH);
      assert(std::abs(pair.angle() - fold) < 1e-6);
    }
  }
}

void test_votes()
{
  const Fold_scales scales(0.);
  std::vector<Fold_vote> votes;
  Sampler sampler(5);
  for (std::size_t n = 0; n < 400; ++n) // along the x axis, with errors across it
    votes.push_back({Vector(sampler.uniform(-10., 10.), 0.1 * sampler.gaussian(), 0.1 * sampler.gaussian()), true});
  for (std::size_t n = 0; n < 60; ++n) // here nobody is sure
    votes.push_back({Vector(sampler.uniform(-10., 10.), 8., 0.), false});
  votes.push_back({Vector(0., -8., 0.), true}); // and this one is alone
  const Fold_votes agreed(votes, scales);
  assert(agreed.feet().size() > 300);
  double squares = 0.;
  for (const Vector& foot : agreed.feet())
  {
    assert(std::abs(foot.y()) < 1.);
    squares += foot.y() * foot.y() + foot.z() * foot.z();
  }
  assert(std::sqrt(squares / double(agreed.feet().size())) < 0.06); // of 0.14
  assert(Fold_votes({}, scales).feet().empty());
}

// most folds do not end where their votes do, so that points beyond do not know how far they are
void test_ends_of_folds()
{
  std::vector<Fold_vote> votes;
  for (int n = 0; n <= 100; ++n)
    votes.push_back({Vector(-0.1 * n, 0., 0.), true});
  const Fold_votes agreed(votes, Fold_scales(0.));
  std::vector<std::size_t> found;
  const double all = Field_estimate::truncation;
  assert(std::abs(agreed.known_distance(Vector(-5., 1., 0.), all, found) - 1.) < 0.05);
  assert(std::abs(agreed.known_distance(Vector(-0.5, 1., 0.), all, found) - 1.) < 0.05);
  assert(std::isinf(agreed.known_distance(Vector(2., 0.5, 0.), all, found)));
  assert(agreed.known_distance(Vector(-5., 3., 0.), 2., found) == 2.);
}

// noise hides weak folds in small balls
void test_weak_folds_with_noise()
{
  for (unsigned int seed = 20; seed < 23; ++seed)
  {
    Sampler sampler(seed);
    const Points points = sampler.folded_plane(40. * CGAL_PI / 180., 12., 15., 0.2);
    Field_estimate estimate;
    assert(estimate_field(points, 20., go_on, estimate));
    std::size_t near = 0, seen = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (std::abs(points[i].y()) < 11. && std::hypot(points[i].x(), points[i].z()) < 1.2)
      {
        ++near;
        seen += estimate.distances[i] < 2.;
      }
    assert(double(seen) > 0.85 * double(near));
  }
}

// a fold along the y axis, of faces that are 15 wide and 2 `length` long there
void test_distances_from_a_fold(double degrees, double length, double noise, double most_error)
{
  Sampler sampler(6);
  const Points points = sampler.folded_plane(degrees * CGAL_PI / 180., 15., length, noise);
  Field_estimate estimate;
  assert(estimate_field(points, 20., go_on, estimate));
  assert(estimate.distances.size() == points.size() && estimate.deviations.size() == points.size());
  std::vector<double> errors;
  std::size_t far = 0, seen_as_near = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double truth = std::hypot(points[i].x(), points[i].z());
    if (std::abs(points[i].y()) > (std::min)(11., length - 1.) || truth > 11.)
      continue; // the border of the cloud
    if (truth < 3.)
      errors.push_back(std::abs(estimate.distances[i] - truth));
    else if (truth > 5.)
    {
      ++far;
      seen_as_near += estimate.distances[i] < 1.5;
    }
    assert(estimate.distances[i] >= 0. && estimate.distances[i] <= Field_estimate::truncation);
  }
  assert(median_of(errors) < most_error);
  assert(far > 40 && double(seen_as_near) <= 0.02 * double(far));
}

void test_distances_from_folds()
{
  for (double degrees : {60., 90.})
  {
    test_distances_from_a_fold(degrees, 15., 0., 0.05);
    test_distances_from_a_fold(degrees, 15., 0.25, 0.35);
  }
  for (double degrees : {150., 156., 160.}) // knives, of which the faces tell less well where they meet
    test_distances_from_a_fold(degrees, 15., 0., 0.25);
  for (double degrees : {45., 60., 90.}) // across a narrow face
    test_distances_from_a_fold(degrees, 3.5, 0., 0.05);
}

void test_smooth_surfaces_have_no_features()
{
  for (double noise : {0., 0.1, 0.25})
    for (unsigned int seed = 10; seed < 13; ++seed)
    {
      Sampler sampler(seed);
      for (const Points& points : {sampler.sphere(12., noise), sampler.folded_plane(0., 15., 15., noise),
                                   tube(sampler, 3., noise), tube(sampler, 4., noise)})
      {
        Field_estimate estimate;
        assert(estimate_field(points, 20., go_on, estimate));
        const auto near = std::count_if(estimate.distances.begin(), estimate.distances.end(),
                                        [](double d) { return d < Field_estimate::truncation; });
        assert(double(near) <= 0.03 * double(points.size())); // a few points in a row by chance
      }
    }
}

void test_degenerate_clouds_and_cancelling()
{
  Field_estimate estimate;
  assert(estimate_field({}, 20., go_on, estimate) && estimate.distances.empty());
  assert(estimate_field({Vector::Zero()}, 20., go_on, estimate) && estimate.distances.size() == 1);
  Points line;
  for (int i = 0; i < 500; ++i)
    line.push_back(Vector(0.5 * i, 0., 0.));
  assert(estimate_field(line, 20., go_on, estimate));
  for (double d : estimate.distances)
    assert(std::isfinite(d));

  Sampler sampler(7);
  const Points points = sampler.folded_plane(1., 40., 40., 0.);
  int asked = 0;
  assert(!estimate_field(
    points, 20., [&](double share) { return assert(share >= 0. && share <= 1.), ++asked < 2; }, estimate));
  assert(asked == 2);
}

} // namespace

int main()
{
  test_fold_of_a_height_function();
  test_no_fold_on_a_smooth_surface();
  test_noise_of_points();
  test_sheets_next_to_a_fold();
  test_sheets_turn_with_their_points();
  test_pairs_of_sheets();
  test_angles_of_folds();
  test_votes();
  test_ends_of_folds();
  test_weak_folds_with_noise();
  test_distances_from_folds();
  test_smooth_surfaces_have_no_features();
  test_degenerate_clouds_and_cancelling();
  return 0;
}
