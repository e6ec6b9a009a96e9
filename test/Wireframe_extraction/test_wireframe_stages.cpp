// The stages one by one, on clouds for which the right answer is known in closed form.

#include <CGAL/Wireframe_extraction/refine_field.h>

#include "sample_clouds.h"

#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/internal/base/farthest_point_sampling.h>
#include <CGAL/Wireframe_extraction/internal/network/second_variance_ratio.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>
#include <CGAL/extract_wireframe.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <Sample_solids/Sample_solids.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe_skeleton<Kernel> Skeleton;
typedef CGAL::Wireframe_corner<Kernel> Corner;
typedef CGAL::Wireframe_graph<Kernel> Graph;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef std::vector<std::vector<std::size_t>> Clusters;
typedef Sample_solids::Random Random;

namespace WE = CGAL::Wireframe_extraction;
namespace WP = CGAL::Wireframe_extraction::parameters;

const double r = 0.02;

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

double median(std::vector<double> values)
{
  assert(!values.empty());
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// ---- clouds

Cloud cloud_of(const std::string& name, double sampling_distance,
               Sample_solids::Sampling sampling = Sample_solids::Sampling::POISSON)
{
  Sample_solids::Sampling_options options;
  options.sampling_distance = sampling_distance;
  options.sampling = sampling;
  return cloud_of_samples<Point>(Sample_solids::sample(Sample_solids::make_solid(name), options));
}

// A function of the plane: the distance to some curves there, in sampling distances.
typedef std::function<double(double, double)> Plane_distance;

// Points on a surface that falls off to all sides of curves in the plane z = 0: at the distance d in the plane it is
// 0.7 d deep, so that its distance to the curves is sqrt(1.49) d exactly. One random point per cell of a square grid
// makes a cloud whose sampling distance is r. The points near the curves alone are kept.
Cloud roof(const Plane_distance& plane_distance, double x0, double y0, double x1, double y1, std::uint64_t seed = 1)
{
  Random random(seed);
  Cloud cloud;
  for (double i = x0; i < x1; ++i)
    for (double j = y0; j < y1; ++j)
    {
      const double x = i + random.uniform(), y = j + random.uniform(), d = plane_distance(x, y);
      if (d < 6.)
        cloud.emplace_back(Point(r * x, r * y, -0.7 * r * d), r * std::sqrt(1.49) * d);
    }
  return cloud;
}

double distance_to_segment(double x, double y, double x0, double y0, double x1, double y1)
{
  const double dx = x1 - x0, dy = y1 - y0;
  const double t = ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy);
  const double s = (std::min)(1., (std::max)(0., t));
  return std::hypot(x - x0 - s * dx, y - y0 - s * dy);
}

const double circle_radius = 15.;

double distance_to_circle(double x, double y) { return std::abs(std::hypot(x, y) - circle_radius); }

Cloud circle_cloud() { return roof(distance_to_circle, -24, -24, 24, 24); }

Cloud line_cloud()
{
  return roof([](double x, double y) { return distance_to_segment(x, y, -30, 0, 30, 0); }, -30, -8, 30, 8);
}

// two legs of 40 r, 16 r apart, and a half circle that joins them; the tips are at (-8, 40) and (8, 40)
double distance_to_u(double x, double y)
{
  if (y < 0.)
    return std::abs(std::hypot(x, y) - 8.);
  return (std::min)(distance_to_segment(x, y, -8, 0, -8, 40), distance_to_segment(x, y, 8, 0, 8, 40));
}

Cloud u_cloud() { return roof(distance_to_u, -16, -16, 16, 40); }

// a circle and its diameter
Cloud theta_cloud()
{
  return roof(
    [](double x, double y) {
      return (std::min)(distance_to_circle(x, y), distance_to_segment(x, y, -circle_radius, 0, circle_radius, 0));
    },
    -24, -24, 24, 24);
}

Cloud parallels_cloud()
{
  return roof(
    [](double x, double y) {
      return (std::min)(distance_to_segment(x, y, -30, -2, 30, -2), distance_to_segment(x, y, -30, 2, 30, 2));
    },
    -30, -9, 30, 9);
}

Cloud crossing_cloud()
{
  return roof(
    [](double x, double y) {
      return (std::min)(distance_to_segment(x, y, -20, 0, 20, 0), distance_to_segment(x, y, 0, -20, 0, 20));
    },
    -20, -20, 20, 20);
}

Skeleton contracted(const Cloud& cloud)
{
  Skeleton skeleton = WE::select_skeleton(cloud, WP::sampling_distance(r));
  assert(!skeleton.is_contracted());
  WE::contract_skeleton(skeleton);
  assert(skeleton.is_contracted());
  return skeleton;
}

struct Stages
{
  Skeleton skeleton;
  std::vector<Corner> corners;
  Clusters clusters;
  Graph graph;
};

template <class NamedParameters>
Stages stages_of(const Cloud& cloud, const NamedParameters& np)
{
  Stages stages;
  stages.skeleton = contracted(cloud);
  stages.corners = WE::detect_corners(stages.skeleton, np);
  stages.clusters = WE::segment_curves(stages.skeleton, stages.corners, np);
  stages.graph = WE::build_topological_graph(stages.skeleton, stages.corners, stages.clusters, np);
  return stages;
}

Stages stages_of(const Cloud& cloud) { return stages_of(cloud, WP::noise_level(-1.)); }

// ---- the sampling distance

void test_sampling_distance()
{
  for (const char* name : {"box", "cylinder", "nut"})
    for (Sample_solids::Sampling sampling : {Sample_solids::Sampling::POISSON, Sample_solids::Sampling::UNIFORM})
    {
      const Cloud cloud = cloud_of(name, 0.025, sampling);
      const double estimate = WE::estimate_sampling_distance(cloud);
      assert(std::abs(estimate / 0.025 - 1.) < 0.05);

      // duplicates carry no information
      Cloud twice = cloud;
      twice.insert(twice.end(), cloud.begin(), cloud.end());
      twice.insert(twice.end(), cloud.begin(), cloud.begin() + 500);
      assert(std::abs(WE::estimate_sampling_distance(twice) / estimate - 1.) < 0.01);

      // nor do a few points that are anywhere
      Cloud dirty = cloud;
      Random random(3);
      for (std::size_t i = 0; i < cloud.size() / 20; ++i)
        dirty.emplace_back(Point(random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)), 0.);
      assert(std::abs(WE::estimate_sampling_distance(dirty) / 0.025 - 1.) < 0.05);
    }
  // a cloud of bare points, in another unit
  std::vector<Point> points;
  for (const auto& sample : cloud_of("box", 0.025))
    points.emplace_back(1024. * sample.first.x(), 1024. * sample.first.y(), 1024. * sample.first.z());
  const double estimate = WE::estimate_sampling_distance(points);
  assert(std::abs(estimate / (1024. * WE::estimate_sampling_distance(cloud_of("box", 0.025))) - 1.) < 0.01);
  // the order does not matter
  Cloud cloud = cloud_of("box", 0.025);
  const double before = WE::estimate_sampling_distance(cloud);
  std::reverse(cloud.begin(), cloud.end());
  assert(WE::estimate_sampling_distance(cloud) == before);
}

void test_sampling_distance_of_few_points()
{
  assert(WE::estimate_sampling_distance(std::vector<Point>()) == 0.);
  assert(WE::estimate_sampling_distance(std::vector<Point>(1, Point(1, 2, 3))) == 0.);
  assert(WE::estimate_sampling_distance(std::vector<Point>(1000, Point(0.1, 0.2, 0.3))) == 0.);
  assert(WE::estimate_sampling_distance(std::vector<Point>{Point(0, 0, 0), Point(0, 0, 3)}) == 0.);
  // three points tell the scale at least
  const double three =
    WE::estimate_sampling_distance(std::vector<Point>{Point(0, 0, 0), Point(0, 0, 3), Point(0, 3, 0)});
  assert(three > 1. && three < 9.);
  Random random(1);
  std::vector<Point> ten;
  for (int i = 0; i < 10; ++i)
    ten.emplace_back(random.uniform(), random.uniform(), 0.);
  // ten points in a unit square have an area of about 0.1 each
  const double estimate = WE::estimate_sampling_distance(ten);
  assert(estimate > 0.1 && estimate < 0.9);
}

// ---- the skeleton

void check_skeleton(const Cloud& cloud, const Skeleton& skeleton, double spacing, double inner, double outer)
{
  std::size_t wanted = 0, wanted_support = 0;
  for (const auto& sample : cloud)
  {
    wanted += sample.second < inner * spacing;
    wanted_support += sample.second < (std::max)(inner, outer) * spacing;
  }
  assert(wanted > 0 && wanted_support > wanted);
  assert(skeleton.size() == wanted);
  assert(skeleton.support_size() == wanted_support);
  assert(skeleton.sampling_distance() == spacing);
  std::set<std::size_t> indices;
  for (std::size_t i = 0; i < skeleton.support_size(); ++i)
  {
    assert(indices.insert(skeleton.index(i)).second);
    const auto& sample = cloud[skeleton.index(i)];
    assert(distance(skeleton.point(i), sample.first) < 1e-12);
    assert(std::abs(skeleton.distance(i) - sample.second) < 1e-14);
    assert(i == 0 || skeleton.distance(i - 1) <= skeleton.distance(i));
  }
}

void test_skeleton()
{
  const Cloud cloud = cloud_of("cylinder", r);
  check_skeleton(cloud, WE::select_skeleton(cloud, WP::sampling_distance(r)), r, 1.5, 3.);
  check_skeleton(cloud,
                 WE::select_skeleton(cloud, WP::sampling_distance(r).skeleton_distance(0.7).support_distance(2.25)), r,
                 0.7, 2.25);
  const double estimate = WE::select_skeleton(cloud).sampling_distance();
  assert(std::abs(estimate / r - 1.) < 0.05);
  check_skeleton(cloud, WE::select_skeleton(cloud), estimate, 1.5, 3.);

  // a support narrower than the skeleton is as wide as that
  const Skeleton narrow = WE::select_skeleton(cloud, WP::sampling_distance(r).support_distance(0.5));
  assert(narrow.support_size() == narrow.size());
  assert(narrow.size() == WE::select_skeleton(cloud, WP::sampling_distance(r)).size());
}

void test_skeleton_thresholds()
{
  // in binary fractions: what lies on a threshold is not below it
  Cloud cloud;
  for (int i = 0; i < 16; ++i)
    cloud.emplace_back(Point(0.25 * i, 0.25 * (i % 3), 0.25 * (i % 5)), 0.125 * (15 - i));
  const Skeleton skeleton = WE::select_skeleton(cloud, WP::sampling_distance(0.25));
  assert(skeleton.size() == 3);         // 0, 0.125, 0.25, but not 0.375
  assert(skeleton.support_size() == 6); // up to 0.625, but not 0.75
  assert(skeleton.number_of_duplicates() == 0);
  for (std::size_t i = 0; i < 6; ++i)
  {
    assert(skeleton.index(i) == 15 - i);
    assert(skeleton.distance(i) == 0.125 * double(i));
  }
  Cloud twice = cloud;
  twice.insert(twice.end(), cloud.begin(), cloud.end());
  const Skeleton unique = WE::select_skeleton(twice, WP::sampling_distance(0.25));
  assert(unique.size() == 3 && unique.support_size() == 6 && unique.number_of_duplicates() == 6);
  for (std::size_t i = 0; i < 6; ++i)
    assert(unique.index(i) == 15 - i); // the first of equal ones stays

  assert(WE::select_skeleton(Cloud()).is_empty());
  assert(WE::select_skeleton(Cloud(9, std::make_pair(Point(1, 1, 1), 0.))).is_empty()); // there is no unit
  const Cloud far(1, std::make_pair(Point(1, 1, 1), 5.));
  assert(WE::select_skeleton(far, WP::sampling_distance(1.)).support_size() == 0);
}

struct Measurement
{
  int id;
  double value;
  Point where;
};

struct Where_map
{
  typedef Measurement key_type;
  typedef Point value_type;
  typedef const Point& reference;
  typedef boost::readable_property_map_tag category;
  friend reference get(Where_map, const Measurement& m) { return m.where; }
};

// in another unit than the points
struct Value_map
{
  typedef Measurement key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;
  double factor;
  friend reference get(const Value_map& map, const Measurement& m) { return map.factor * m.value; }
};

void test_skeleton_of_other_values()
{
  const Cloud cloud = cloud_of("cylinder", 0.03);
  std::vector<Measurement> measurements;
  for (const auto& sample : cloud)
    measurements.push_back({int(measurements.size()), 1024. * sample.second, sample.first});
  const Skeleton expected = WE::select_skeleton(cloud);
  const Skeleton skeleton =
    WE::select_skeleton(measurements, WP::distance_map(Value_map{1. / 1024.}).point_map(Where_map()));
  assert(skeleton.size() == expected.size() && skeleton.support_size() == expected.support_size());
  for (std::size_t i = 0; i < skeleton.support_size(); ++i)
  {
    assert(skeleton.index(i) == expected.index(i));
    assert(skeleton.point(i) == expected.point(i));
    assert(skeleton.distance(i) == expected.distance(i));
  }
}

// ---- contraction

void test_contraction_of_a_line()
{
  const Skeleton skeleton = contracted(line_cloud());
  std::vector<double> offsets, turns, residuals;
  for (std::size_t i = 0; i < skeleton.size(); ++i)
  {
    const Point foot = skeleton.foot(i);
    const Vector tangent = skeleton.tangent(i);
    assert(std::abs(tangent.squared_length() - 1.) < 1e-9);
    offsets.push_back(std::hypot(foot.y(), foot.z()) / r);
    turns.push_back(std::hypot(tangent.y(), tangent.z()));
    residuals.push_back(skeleton.residual(i) / r);
    // the foot is the point's own one, not just any point of the curve
    assert(std::abs(foot.x() - skeleton.point(i).x()) < 0.5 * r);
  }
  assert(offsets.size() > 100);
  assert(median(offsets) < 0.02);
  assert(*std::max_element(offsets.begin(), offsets.end()) < 0.3);
  assert(median(turns) < 0.01);
  assert(median(residuals) < 0.01);
  assert(std::abs(skeleton.noise() / r - median(residuals)) < 1e-9);
}

void test_contraction_of_a_circle()
{
  const Skeleton skeleton = contracted(circle_cloud());
  std::vector<double> offsets, turns, residuals;
  for (std::size_t i = 0; i < skeleton.size(); ++i)
  {
    const Point foot = skeleton.foot(i);
    const double radius = std::hypot(foot.x(), foot.y());
    offsets.push_back(std::hypot(radius - r * circle_radius, foot.z()) / r);
    // the tangent has neither a radial nor a vertical part
    const Vector radial(foot.x() / radius, foot.y() / radius, 0.);
    turns.push_back(std::hypot(skeleton.tangent(i) * radial, skeleton.tangent(i).z()));
    residuals.push_back(skeleton.residual(i) / r);
  }
  assert(offsets.size() > 100);
  assert(median(offsets) < 0.1);
  assert(median(turns) < 0.05);
  assert(median(residuals) < 0.1);
}

void test_noise_level()
{
  Skeleton skeleton = WE::select_skeleton(line_cloud(), WP::sampling_distance(r));
  WE::contract_skeleton(skeleton, WP::noise_level(0.375));
  assert(std::abs(skeleton.noise() - 0.375 * r) < 1e-15);
  Skeleton empty;
  WE::contract_skeleton(empty); // is no error
  assert(empty.is_empty() && !empty.is_contracted());
}

// ---- the refinement

// The ridge of a roof in a field with noise, which does not see it for 5 < x < 15.
Cloud wrong_roof()
{
  Random random(7);
  Cloud cloud;
  for (double i = -40; i < 40; ++i)
    for (double j = -14; j < 14; ++j)
    {
      const double x = i + random.uniform(), y = j + random.uniform();
      double d = std::sqrt(1.49) * std::abs(y) * (1. + 0.1 * random.normal()) + 0.2 * random.normal();
      if (x > 5 && x < 15)
        d += 6.;
      cloud.emplace_back(Point(r * x, r * y, -0.7 * r * std::abs(y)), r * std::abs(d));
    }
  return cloud;
}

std::size_t number_of_skeleton_points(const Skeleton& skeleton, double x0, double x1, double y0, double y1)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < skeleton.size(); ++i)
  {
    const Point& p = skeleton.point(i);
    count += p.x() > r * x0 && p.x() < r * x1 && p.y() > r * y0 && p.y() < r * y1;
  }
  return count;
}

double typical_error(const Skeleton& skeleton)
{
  std::vector<double> errors;
  for (std::size_t i = 0; i < skeleton.size(); ++i)
  {
    const double y = skeleton.point(i).y();
    errors.push_back(std::abs(skeleton.distance(i) - std::sqrt(1.49) * std::abs(y)) / r);
  }
  return median(errors);
}

void check_ends(const Wireframe& wireframe);

void test_refinement()
{
  Skeleton skeleton = contracted(wrong_roof());
  assert(typical_error(skeleton) > 0.1);
  assert(skeleton.noise() > 0.1 * r);
  assert(number_of_skeleton_points(skeleton, 6, 14, -2, 2) < 5);
  const double noise = skeleton.noise();
  WE::refine_field(skeleton);
  assert(skeleton.is_contracted());
  assert(typical_error(skeleton) < 0.02);
  assert(skeleton.noise() < 0.2 * noise);
  // the ridge is found where the field did not see it
  assert(number_of_skeleton_points(skeleton, 6, 14, -2, 2) > 12);
  for (std::size_t i = 1; i < skeleton.support_size(); ++i)
    assert(skeleton.distance(i - 1) <= skeleton.distance(i));
}

void test_refinement_that_changes_nothing()
{
  // a field that is exact
  Skeleton skeleton = contracted(line_cloud());
  const std::size_t size = skeleton.size();
  const double first = skeleton.distance(0), noise = skeleton.noise();
  WE::refine_field(skeleton);
  assert(skeleton.size() == size && skeleton.distance(0) == first && skeleton.noise() == noise);
  // a skeleton without its surroundings
  Skeleton bare = WE::select_skeleton(wrong_roof(), WP::sampling_distance(r).use_creases(false));
  WE::contract_skeleton(bare);
  const std::size_t bare_size = bare.size();
  WE::refine_field(bare);
  assert(bare.size() == bare_size && bare.noise() > 0.1 * r);
  // nothing
  Skeleton empty;
  WE::refine_field(empty);
  assert(empty.is_empty());
}

// the same by the one call, and without creases for comparison
void test_refinement_within_extraction()
{
  const Cloud cloud = wrong_roof();
  const auto length_in_gap = [](const Wireframe& wireframe) {
    std::size_t covered = 0;
    for (double x = 6.; x < 14.; x += 0.5)
    {
      double nearest = 1e9;
      for (const Wireframe::Curve& curve : wireframe.curves)
      {
        std::vector<Point> samples;
        curve.spline.sample_by_count(400, std::back_inserter(samples));
        for (const Point& p : samples)
          nearest = (std::min)(nearest, distance(p, Point(r * x, 0., 0.)));
      }
      covered += nearest < 0.2 * r;
    }
    return covered;
  };
  const Wireframe with = CGAL::extract_wireframe(cloud, WP::sampling_distance(r));
  assert(with.curves.size() == 1 && length_in_gap(with) == 16);
  check_ends(with);
  // without, that is a guess
  assert(!CGAL::extract_wireframe(cloud, WP::sampling_distance(r).use_creases(false)).is_empty());
}

// ---- corners

std::vector<Sample_solids::Point> true_corners(const std::string& name)
{
  return Sample_solids::ground_truth(Sample_solids::make_solid(name), r).corners;
}

// every true corner has exactly one center nearby, and there is no other
void check_corners(const std::vector<Corner>& corners, const std::vector<Sample_solids::Point>& truth, double bound,
                   const Skeleton& skeleton)
{
  assert(corners.size() == truth.size());
  for (const Sample_solids::Point& p : truth)
    assert(std::count_if(corners.begin(), corners.end(),
                         [&](const Corner& corner) { return distance(corner.center, Point(p[0], p[1], p[2])) < bound; })
           == 1);
  std::set<std::size_t> taken;
  for (const Corner& corner : corners)
  {
    assert(!corner.members.empty());
    assert(std::is_sorted(corner.members.begin(), corner.members.end()));
    double radius = 0.;
    for (std::size_t i : corner.members)
    {
      assert(i < skeleton.size());
      assert(taken.insert(i).second);
      radius = (std::max)(radius, distance(skeleton.point(i), corner.center));
    }
    assert(std::abs(corner.radius - radius) < 1e-9);
  }
}

void test_corners_by_residual()
{
  const Skeleton box = contracted(cloud_of("box", r));
  check_corners(WE::detect_corners(box), true_corners("box"), 2.5 * r, box);
  const Skeleton nut = contracted(cloud_of("nut", r));
  check_corners(WE::detect_corners(nut), true_corners("nut"), 2.5 * r, nut);
  assert(WE::detect_corners(contracted(cloud_of("cylinder", r))).empty());
  assert(WE::detect_corners(contracted(circle_cloud())).empty());
  assert(WE::detect_corners(contracted(crossing_cloud())).size() == 1);
  assert(WE::detect_corners(Skeleton()).empty());
  // the threshold is the caller's if there is one
  assert(WE::detect_corners(box, WP::corner_residual(10.)).empty());
}

// the ratio of points at plus and minus a, b, c on three orthogonal axes
double variance_ratio(double a, double b, double c)
{
  const WE::internal::Vector u = WE::internal::Vector(1, 2, -2) / 3., v = WE::internal::Vector(2, 1, 2) / 3.,
                             w = WE::internal::Vector(2, -2, -1) / 3., shift(7, -3, 5);
  const std::vector<WE::internal::Vector> points{shift + a * u, shift - a * u, shift + b * v,   shift - b * v,
                                                 shift + c * w, shift - c * w, shift + 100. * u};
  return WE::internal::second_variance_ratio(points, {0, 1, 2, 3, 4, 5}); // the last one is not in the ball
}

void test_variance_ratio()
{
  // variances are in proportion to the squares
  assert(std::abs(variance_ratio(1, 1, 1) - 1. / 3.) < 1e-12);
  assert(std::abs(variance_ratio(3, 2, 1) - 4. / 14.) < 1e-12);
  assert(std::abs(variance_ratio(1, 5, 3) - 9. / 35.) < 1e-12);
  assert(std::abs(variance_ratio(2, 2, 0) - 0.5) < 1e-8);
  assert(std::abs(variance_ratio(0, 4, 1) - 1. / 17.) < 1e-12);
  assert(std::abs(variance_ratio(0, 0, 6)) < 1e-12);
  const std::vector<WE::internal::Vector> two{WE::internal::Vector(0, 0, 0), WE::internal::Vector(1, 1, 1)};
  assert(WE::internal::second_variance_ratio(two, {0, 1}) == 0.);
  assert(WE::internal::second_variance_ratio(two, {}) == 0.);
}

void test_corners_by_variance()
{
  // the published measure wants clouds that are much denser than the sampling distance says
  const double spacing = 0.04;
  const Skeleton box = WE::select_skeleton(cloud_of("box", r), WP::sampling_distance(spacing));
  check_corners(WE::detect_corners(box, WP::corner_measure(WE::Corner_measure::VARIANCE)), true_corners("box"),
                2.5 * spacing, box);
  const Skeleton cylinder = WE::select_skeleton(cloud_of("cylinder", r), WP::sampling_distance(0.04));
  assert(WE::detect_corners(cylinder, WP::corner_measure(WE::Corner_measure::VARIANCE)).empty());
  // no ratio exceeds a half
  assert(WE::detect_corners(box, WP::corner_measure(WE::Corner_measure::VARIANCE).corner_variance(0.51)).empty());
  assert(!WE::detect_corners(box, WP::corner_measure(WE::Corner_measure::VARIANCE).corner_variance(0.)).empty());
}

// O(n k), straight from the definition
std::vector<std::size_t> farthest_points(const std::vector<WE::internal::Vector>& positions, std::size_t size,
                                         std::size_t count)
{
  std::vector<std::size_t> samples;
  if (size == 0 || count == 0)
    return samples;
  WE::internal::Vector centroid = WE::internal::Vector::Zero();
  for (std::size_t i = 0; i < size; ++i)
    centroid += positions[i];
  centroid /= double(size);
  std::vector<double> distances(size);
  std::size_t next = 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((positions[i] - centroid).squaredNorm() > (positions[next] - centroid).squaredNorm())
      next = i;
  std::fill(distances.begin(), distances.end(), (std::numeric_limits<double>::infinity)());
  while (true)
  {
    samples.push_back(next);
    for (std::size_t i = 0; i < size; ++i)
      distances[i] = (std::min)(distances[i], (positions[i] - positions[next]).norm());
    next = std::size_t(std::max_element(distances.begin(), distances.end()) - distances.begin());
    if (samples.size() == count || distances[next] == 0.)
      return samples;
  }
}

void test_farthest_point_sampling()
{
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
  {
    Random random(seed);
    const std::size_t n = 1 + random.index(600);
    std::vector<WE::internal::Vector> positions;
    for (std::size_t i = 0; i < n; ++i)
    {
      WE::internal::Vector p(random.uniform(), random.uniform(), random.uniform());
      if (seed % 3 == 0)
        p = (8. * p).array().floor().matrix(); // a lattice: ties and duplicates
      else if (seed % 3 == 1)
        p = p.array().pow(6.).matrix(); // dense in one corner
      positions.push_back(p);
    }
    for (std::size_t count : {std::size_t(1), n / 10, n, 2 * n})
      for (std::size_t size : {n, n / 2})
        assert(WE::internal::farthest_point_sampling(positions, size, count)
               == farthest_points(positions, size, count));
  }
  const std::vector<WE::internal::Vector> same(7, WE::internal::Vector(1, 2, 3));
  assert(WE::internal::farthest_point_sampling(same, 7, 5).size() == 1);
}

// ---- segmentation

// whether all points of the clusters are different ones of the skeleton, in order
void check_clusters(const Clusters& clusters, const Skeleton& skeleton, const std::vector<Corner>& corners)
{
  std::size_t number_of_members = 0;
  std::set<std::size_t> taken;
  for (const Corner& corner : corners)
  {
    number_of_members += corner.members.size();
    taken.insert(corner.members.begin(), corner.members.end());
  }
  for (std::size_t c = 0; c < clusters.size(); ++c)
  {
    assert(!clusters[c].empty() && std::is_sorted(clusters[c].begin(), clusters[c].end()));
    assert(c == 0 || clusters[c - 1].front() < clusters[c].front());
    number_of_members += clusters[c].size();
    for (std::size_t i : clusters[c])
      assert(taken.insert(i).second && i < skeleton.size());
  }
  assert(number_of_members == skeleton.size()); // nothing is lost
}

// of the points, those of larger clusters that are on the wrong side: `side` tells the curve, or 0 for either
template <class Side>
std::size_t number_of_mixed_clusters(const Clusters& clusters, const Skeleton& skeleton, const Side& side)
{
  std::size_t mixed = 0;
  for (const std::vector<std::size_t>& cluster : clusters)
  {
    bool has[2] = {false, false};
    for (std::size_t i : cluster)
    {
      const int s = side(skeleton.point(i));
      if (s != 0)
        has[s > 0] = true;
    }
    mixed += has[0] && has[1];
  }
  return mixed;
}

std::size_t largest(const Clusters& clusters)
{
  std::size_t result = 0;
  for (const std::vector<std::size_t>& cluster : clusters)
    result = (std::max)(result, cluster.size());
  return result;
}

void test_segmentation()
{
  const auto parallel = [](const Point& p) { return p.y() > 0. ? 1 : -1; };
  const Skeleton parallels = contracted(parallels_cloud());
  const Clusters lines = WE::segment_curves(parallels, std::vector<Corner>());
  check_clusters(lines, parallels, std::vector<Corner>());
  assert(number_of_mixed_clusters(lines, parallels, parallel) == 0);
  assert(largest(lines) > parallels.size() * 4 / 10); // and each is in one piece, more or less
  const Clusters fused = WE::segment_curves(parallels, std::vector<Corner>(), WP::use_tangents(false));
  check_clusters(fused, parallels, std::vector<Corner>());
  assert(number_of_mixed_clusters(fused, parallels, parallel) == 1);
  assert(fused.size() == 1);
  // a small enough radius separates them as well, and a tiny one all points
  assert(number_of_mixed_clusters(
           WE::segment_curves(parallels, std::vector<Corner>(), WP::use_tangents(false).connection_radius(1.2)),
           parallels, parallel)
         == 0);
  assert(WE::segment_curves(parallels, std::vector<Corner>(), WP::use_tangents(false).connection_radius(1e-9)).size()
         == parallels.size());

  const auto crossing = [](const Point& p) {
    return (std::min)(std::abs(p.x()), std::abs(p.y())) > 1.5 * r || std::hypot(p.x(), p.y()) < 4. * r ? 0
      : std::abs(p.x()) > std::abs(p.y())                                                              ? 1
                                                                                                       : -1;
  };
  const Skeleton cross = contracted(crossing_cloud());
  const Clusters arms = WE::segment_curves(cross, std::vector<Corner>());
  assert(number_of_mixed_clusters(arms, cross, crossing) == 0);
  assert(
    number_of_mixed_clusters(WE::segment_curves(cross, std::vector<Corner>(), WP::use_tangents(false)), cross, crossing)
    == 1);
  const std::vector<Corner> corners = WE::detect_corners(cross);
  check_clusters(WE::segment_curves(cross, corners), cross, corners);

  const Skeleton box = contracted(cloud_of("box", r));
  const std::vector<Corner> box_corners = WE::detect_corners(box);
  const Clusters edges = WE::segment_curves(box, box_corners);
  check_clusters(edges, box, box_corners);
  assert(std::count_if(edges.begin(), edges.end(), [](const std::vector<std::size_t>& e) { return e.size() > 50; })
         == 12);
  assert(WE::segment_curves(Skeleton(), std::vector<Corner>()).empty());
}

// ---- the graph

struct Polylines
{
  typedef boost::graph_traits<Graph>::vertex_descriptor Vertex;
  std::vector<std::vector<Vertex>> polylines;

  void start_new_polyline() { polylines.emplace_back(); }
  void add_node(Vertex v) { polylines.back().push_back(v); }
  void end_polyline() {}
};

struct Graph_summary
{
  std::size_t corners, curves, components, tips;
};

// what every graph has to fulfill, and what there is in it
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized" // a false one, about edges of Boost that CGAL collects
#endif

Graph_summary summary(const Graph& graph)
{
  typedef boost::graph_traits<Graph>::vertex_descriptor Vertex;
  Graph_summary result = {0, 0, 0, 0};
  std::set<std::size_t> ids;
  std::set<std::pair<Vertex, Vertex>> seen;
  for (const auto& edge : boost::make_iterator_range(boost::edges(graph)))
  {
    const Vertex a = (std::min)(boost::source(edge, graph), boost::target(edge, graph));
    const Vertex b = (std::max)(boost::source(edge, graph), boost::target(edge, graph));
    assert(a != b);                    // no loop
    assert(seen.emplace(a, b).second); // no parallel edges
    ids.insert(graph[edge].curve_id);
  }
  for (Vertex v : boost::make_iterator_range(boost::vertices(graph)))
  {
    const Point& p = get(CGAL::vertex_point, graph, v);
    assert(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
    result.corners += graph[v].is_corner;
    result.tips += boost::degree(v, graph) == 1;
    assert(boost::degree(v, graph) >= 1);
    assert(graph[v].is_corner || boost::degree(v, graph) == 2);
  }
  // the numbers of the curves are 0, 1, ...
  result.curves = ids.size();
  assert(ids.empty() || *ids.rbegin() + 1 == ids.size());
  std::vector<std::size_t> component(boost::num_vertices(graph));
  if (!component.empty())
    result.components = std::size_t(boost::connected_components(graph, component.data()));

  Polylines collector;
  CGAL::split_graph_into_polylines(graph, collector, [](Vertex v, const Graph& g) { return g[v].is_corner; });
  assert(collector.polylines.size() == result.curves);
  std::size_t number_of_edges = 0;
  for (const std::vector<Vertex>& polyline : collector.polylines)
  {
    number_of_edges += polyline.size() - 1;
    // all edges of a polyline are of one curve
    for (std::size_t k = 2; k < polyline.size(); ++k)
      assert(graph[boost::edge(polyline[k - 2], polyline[k - 1], graph).first].curve_id
             == graph[boost::edge(polyline[k - 1], polyline[k], graph).first].curve_id);
  }
  assert(number_of_edges == boost::num_edges(graph));
  return result;
}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

// the largest distance of a vertex to curves in the plane z = 0, in r
double largest_offset(const Graph& graph, const Plane_distance& plane_distance)
{
  double worst = 0.;
  for (auto v : boost::make_iterator_range(boost::vertices(graph)))
  {
    const Point& p = get(CGAL::vertex_point, graph, v);
    worst = (std::max)(worst, std::hypot(plane_distance(p.x() / r, p.y() / r), p.z() / r));
  }
  return worst;
}

void test_traced_graphs()
{
  const Graph u = stages_of(u_cloud()).graph;
  const Graph_summary of_u = summary(u);
  assert(of_u.curves == 1 && of_u.corners == 2 && of_u.tips == 2);
  assert(largest_offset(u, distance_to_u) < 0.6);

  const Graph circle = stages_of(circle_cloud()).graph;
  const Graph_summary of_circle = summary(circle);
  assert(of_circle.curves == 1 && of_circle.corners == 0 && of_circle.tips == 0);
  assert(boost::num_vertices(circle) == boost::num_edges(circle));
  assert(largest_offset(circle, distance_to_circle) < 0.3);

  const Graph theta = stages_of(theta_cloud()).graph;
  const Graph_summary of_theta = summary(theta);
  assert(of_theta.curves == 3 && of_theta.corners == 2 && of_theta.components == 1);
  for (auto v : boost::make_iterator_range(boost::vertices(theta)))
    if (theta[v].is_corner)
    {
      assert(boost::degree(v, theta) == 3);
      const Point& p = get(CGAL::vertex_point, theta, v);
      assert((std::min)(distance(p, Point(-r * circle_radius, 0, 0)), distance(p, Point(r * circle_radius, 0, 0)))
             < 0.6 * r);
    }

  const Graph box = stages_of(cloud_of("box", r)).graph;
  const Graph_summary of_box = summary(box);
  assert(of_box.curves == 12 && of_box.corners == 8 && of_box.components == 1 && of_box.tips == 0);
  for (auto v : boost::make_iterator_range(boost::vertices(box)))
    assert(boost::degree(v, box) == (box[v].is_corner ? 3u : 2u));

  assert(boost::num_vertices(WE::build_topological_graph(Skeleton(), std::vector<Corner>(), Clusters())) == 0);
}

double distance_to_tips(const Point& p)
{
  return (std::min)(distance(p, Point(-8 * r, 40 * r, 0)), distance(p, Point(8 * r, 40 * r, 0)));
}

void test_subdivided_graphs()
{
  const auto method = WP::graph_method(WE::Graph_method::SUBDIVIDED);
  const Graph circle = stages_of(circle_cloud(), method).graph;
  const Graph_summary of_circle = summary(circle);
  assert(of_circle.curves == 1 && of_circle.corners == 0 && of_circle.tips == 0);
  assert(boost::num_vertices(circle) >= 3);
  // a small threshold makes many segments
  const Graph fine = stages_of(circle_cloud(), method.split_threshold(1.)).graph;
  assert(boost::num_vertices(fine) > boost::num_vertices(circle));
  assert(largest_offset(fine, distance_to_circle) < 2.);

  // the ends of a U along the curve are its tips, those along its main axis are not
  Stages u;
  u.skeleton = contracted(u_cloud());
  u.clusters.resize(1);
  for (std::size_t i = 0; i < u.skeleton.size(); ++i)
    u.clusters[0].push_back(i);
  for (bool is_axis : {false, true})
  {
    const Graph graph = WE::build_topological_graph(
      u.skeleton, u.corners, u.clusters,
      method.end_detection(is_axis ? WE::End_detection::MAIN_AXIS : WE::End_detection::GRAPH_DISTANCE));
    const Graph_summary of_graph = summary(graph);
    assert(of_graph.curves == 1 && of_graph.tips == 2);
    double farthest = 0.;
    for (auto v : boost::make_iterator_range(boost::vertices(graph)))
      if (boost::degree(v, graph) == 1)
        farthest = (std::max)(farthest, distance_to_tips(get(CGAL::vertex_point, graph, v)));
    assert(is_axis ? farthest > 20. * r : farthest < 3. * r);
  }
}

// ---- the splines

Wireframe wireframe_of(const Cloud& cloud, Stages& stages)
{
  stages = stages_of(cloud);
  return WE::fit_curves(stages.skeleton, stages.graph);
}

// what every wireframe has to fulfill
void check_ends(const Wireframe& wireframe)
{
  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    const auto range = curve.spline.parameter_range();
    const Point first = curve.spline.point(range.first), last = curve.spline.point(range.second);
    if (curve.source == Wireframe::Curve::no_vertex)
    {
      assert(curve.target == Wireframe::Curve::no_vertex && curve.is_closed());
      assert(first == last);
      const double step = 1e-9 * (range.second - range.first);
      const Vector leaving = curve.spline.tangent(range.first);
      const Vector arriving = curve.spline.derivative(range.second - step);
      assert((leaving - arriving / std::sqrt(arriving.squared_length())).squared_length() < 1e-12);
      continue;
    }
    assert(curve.source < wireframe.vertices.size() && curve.target < wireframe.vertices.size());
    assert(first == wireframe.vertices[curve.source]);
    assert(last == wireframe.vertices[curve.target]);
  }
}

void test_fit_of_a_circle()
{
  Stages stages;
  const Wireframe wireframe = wireframe_of(circle_cloud(), stages);
  assert(wireframe.curves.size() == 1 && wireframe.vertices.empty());
  assert(wireframe.sampling_distance == r);
  check_ends(wireframe);
  std::vector<Point> samples;
  wireframe.curves[0].spline.sample_by_count(400, std::back_inserter(samples));
  double sum = 0., worst = 0.;
  for (const Point& p : samples)
  {
    const double radius = std::hypot(p.x(), p.y()) / r;
    sum += radius;
    worst = (std::max)(worst, std::hypot(radius - circle_radius, p.z() / r));
  }
  assert(std::abs(sum / 400. - circle_radius) < 0.02);
  assert(worst < 0.1);
  assert(std::abs(wireframe.curves[0].spline.length() / r - 2. * CGAL_PI * circle_radius) < 0.2);
  // nearly every point of the support is explained
  assert(wireframe.curves[0].support > stages.skeleton.support_size() * 9 / 10);
  assert(wireframe.curves[0].rms < 0.05 * r);
  assert(wireframe.curves[0].max >= wireframe.curves[0].rms);
}

void test_fit_of_a_line()
{
  Stages stages;
  const Wireframe wireframe = wireframe_of(line_cloud(), stages);
  assert(wireframe.curves.size() == 1 && wireframe.vertices.size() == 2);
  check_ends(wireframe);
  std::vector<Point> samples;
  wireframe.curves[0].spline.sample_by_count(100, std::back_inserter(samples));
  for (const Point& p : samples)
    assert(std::hypot(p.y(), p.z()) < 0.1 * r);
  // the line goes on to the end of the data
  for (const Point& p : wireframe.vertices)
    assert(std::abs(std::abs(p.x()) - 30. * r) < 2. * r);
}

void test_fit_of_a_box()
{
  Stages stages;
  const Wireframe wireframe = wireframe_of(cloud_of("box", r), stages);
  assert(wireframe.curves.size() == 12 && wireframe.vertices.size() == 8);
  check_ends(wireframe);
  // three edges share each corner
  std::vector<std::size_t> degrees(8, 0);
  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    ++degrees[curve.source];
    ++degrees[curve.target];
  }
  assert(degrees == std::vector<std::size_t>(8, 3));
  for (const Sample_solids::Point& p : true_corners("box"))
    assert(std::count_if(wireframe.vertices.begin(), wireframe.vertices.end(),
                         [&](const Point& q) { return distance(q, Point(p[0], p[1], p[2])) < 0.15 * r; })
           == 1);
}

void test_fixed_corners()
{
  Stages stages = stages_of(cloud_of("box", r));
  // corners a little off
  for (auto v : boost::make_iterator_range(boost::vertices(stages.graph)))
    if (stages.graph[v].is_corner)
    {
      const Point p = get(CGAL::vertex_point, stages.graph, v);
      put(CGAL::vertex_point, stages.graph, v, Point(p.x() + 0.3 * r, p.y() - 0.2 * r, p.z() + 0.1 * r));
    }
  const Wireframe fixed = WE::fit_curves(stages.skeleton, stages.graph, WP::move_corners(false));
  check_ends(fixed);
  assert(fixed.vertices.size() == 8);
  for (auto v : boost::make_iterator_range(boost::vertices(stages.graph)))
    if (stages.graph[v].is_corner)
      assert(
        std::count_if(fixed.vertices.begin(), fixed.vertices.end(),
                      [&](const Point& q) { return distance(q, get(CGAL::vertex_point, stages.graph, v)) < 1e-12; })
        == 1);
  // while free ones move to where the curves meet
  const Wireframe moved = WE::fit_curves(stages.skeleton, stages.graph);
  for (const Sample_solids::Point& p : true_corners("box"))
    assert(std::count_if(moved.vertices.begin(), moved.vertices.end(),
                         [&](const Point& q) { return distance(q, Point(p[0], p[1], p[2])) < 0.15 * r; })
           == 1);
}

// the stages are given what their caller made of it, whatever that is
void test_fit_of_an_own_graph()
{
  const Skeleton skeleton = contracted(line_cloud());
  Graph graph;
  for (int i = 0; i < 3; ++i)
  {
    const auto v = boost::add_vertex(graph);
    put(CGAL::vertex_point, graph, v, Point(r * (10. * i - 10.), 0.3 * r, 0.));
    graph[v].is_corner = i != 1;
    if (i > 0)
      boost::add_edge(v - 1, v, CGAL::Wireframe_edge{0}, graph);
  }
  for (bool is_adapting : {false, true})
  {
    const Wireframe wireframe = WE::fit_curves(skeleton, graph, WP::adapt_knots(is_adapting));
    assert(wireframe.curves.size() == 1 && wireframe.vertices.size() == 2);
    check_ends(wireframe);
    std::vector<Point> samples;
    wireframe.curves[0].spline.sample_by_count(50, std::back_inserter(samples));
    for (const Point& p : samples)
      assert(std::hypot(p.y(), p.z()) < 0.1 * r && std::abs(p.x()) < 12. * r);
  }
  assert(WE::fit_curves(skeleton, Graph()).is_empty());
  assert(WE::fit_curves(Skeleton(), graph).is_empty());
}

} // namespace

int main()
{
  test_sampling_distance();
  test_sampling_distance_of_few_points();
  test_skeleton();
  test_skeleton_thresholds();
  test_skeleton_of_other_values();
  test_contraction_of_a_line();
  test_contraction_of_a_circle();
  test_noise_level();
  test_refinement();
  test_refinement_that_changes_nothing();
  test_refinement_within_extraction();
  test_corners_by_residual();
  test_variance_ratio();
  test_corners_by_variance();
  test_farthest_point_sampling();
  test_segmentation();
  test_traced_graphs();
  test_subdivided_graphs();
  test_fit_of_a_circle();
  test_fit_of_a_line();
  test_fit_of_a_box();
  test_fixed_corners();
  test_fit_of_an_own_graph();
  return 0;
}
