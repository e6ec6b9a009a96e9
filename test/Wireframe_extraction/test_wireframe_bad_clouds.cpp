// Clouds that are no good: each ends with a wireframe that can be trusted, or with none and a reason.

#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/extract_wireframe.h>

#include "sample_clouds.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/assertions.h>

#include <Sample_solids/Sample_solids.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_extraction_report Report;
typedef Report::Status Status;
typedef Sample_solids::Random Random;

namespace WE = CGAL::Wireframe_extraction;
namespace WP = CGAL::Wireframe_extraction::parameters;

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();
const double r = 0.04;

bool is_finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()); }

// what holds for every result
void check(const Wireframe& wireframe, const Report& report)
{
  assert(wireframe.is_empty() == (report.status != Status::SUCCESS));
  assert(report.message.empty() == (report.status == Status::SUCCESS));
  assert(report.message.find('\n') == std::string::npos);
  assert(!wireframe.is_empty() || wireframe.vertices.empty());
  for (const Point& p : wireframe.vertices)
    assert(is_finite(p));
  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    assert(
      Wireframe::Curve::Spline::is_valid(curve.spline.degree(), curve.spline.knots(), curve.spline.control_points()));
    assert(std::isfinite(curve.rms) && std::isfinite(curve.max));
    const auto range = curve.spline.parameter_range();
    const Point first = curve.spline.point(range.first), last = curve.spline.point(range.second);
    assert(is_finite(first) && is_finite(last));
    if (curve.source == Wireframe::Curve::no_vertex)
      assert(first == last);
    else
      assert(first == wireframe.vertices.at(curve.source) && last == wireframe.vertices.at(curve.target));
  }
}

struct Result
{
  Wireframe wireframe;
  Report report;
};

template <class NamedParameters>
Result run(const Cloud& cloud, const NamedParameters& np)
{
  Result result;
  result.wireframe = CGAL::extract_wireframe(cloud, np.extraction_report(std::ref(result.report)));
  check(result.wireframe, result.report);
  // what is wrong with a parameter is said before the cloud is looked at
  const bool is_refused = result.report.message.find("it must be") != std::string::npos;
  assert(result.report.number_of_points == (is_refused ? 0 : cloud.size()));
  return result;
}

Result run(const Cloud& cloud) { return run(cloud, WP::skip_invalid(false)); }

bool says(const Report& report, const std::string& part) { return report.message.find(part) != std::string::npos; }

// the cloud ends with an error whose text holds the given part
void check_refused(const Cloud& cloud, Status status, const std::string& part)
{
  const Result result = run(cloud);
  assert(result.report.status == status);
  assert(says(result.report, part));
}

const Cloud& box()
{
  static const Cloud result = [] {
    Sample_solids::Sampling_options options;
    options.sampling_distance = r;
    return cloud_of_samples<Point>(Sample_solids::sample(Sample_solids::make_solid("box"), options));
  }();
  return result;
}

bool is_box(const Result& result)
{
  return result.report.status == Status::SUCCESS && result.wireframe.curves.size() == 12
    && result.wireframe.vertices.size() == 8;
}

Cloud scaled(Cloud cloud, double of_points, double of_distances)
{
  for (auto& sample : cloud)
  {
    sample.first = Point(of_points * sample.first.x(), of_points * sample.first.y(), of_points * sample.first.z());
    sample.second *= of_distances;
  }
  return cloud;
}

// random points in a unit cube, with a constant field
Cloud random_points(std::size_t n, double distance)
{
  Random random(1);
  Cloud cloud;
  for (std::size_t i = 0; i < n; ++i)
  {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    cloud.emplace_back(Point(x, y, z), distance);
  }
  return cloud;
}

// ---- too few dimensions

void test_few_points()
{
  check_refused(Cloud(), Status::INVALID_INPUT, "no points");
  check_refused(random_points(1, 0.), Status::INVALID_INPUT, "coincide; a wireframe needs points of a surface");
  check_refused(random_points(2, 0.), Status::INVALID_INPUT, "line; a wireframe needs points of a surface");
  check_refused(Cloud(1000, std::make_pair(Point(0.1, 0.2, 0.3), 0.)), Status::INVALID_INPUT, "coincide");
  check_refused(Cloud(1000, std::make_pair(Point(0, 0, 0), 0.)), Status::INVALID_INPUT, "coincide");
  const Result one = run(Cloud(1, std::make_pair(Point(1, 2, 3), 0.)));
  assert(one.report.number_of_points == 1 && one.report.number_of_curves == 0);
}

void test_collinear_points()
{
  Random random(2);
  for (double shift : {0., 1., 1e6})
  {
    Cloud cloud;
    for (int i = 0; i < 1000; ++i)
    {
      const double t = random.uniform();
      cloud.emplace_back(Point(shift + 0.1 * t, shift - 0.3 * t, 0.77 * t), 0.01 * random.uniform());
    }
    check_refused(cloud, Status::INVALID_INPUT, "line");
  }
}

void test_coplanar_points()
{
  Random random(3);
  Cloud square, far;
  for (int i = 0; i < 5000; ++i)
  {
    const double x = random.uniform(), y = random.uniform();
    const Point p(x, y, 0.3 * x - 0.7 * y);
    const double to_x = (std::min)(x, 1. - x) / std::hypot(1., 0.3 / std::sqrt(1.49));
    const double to_y = (std::min)(y, 1. - y) / std::hypot(1., 0.7 / std::sqrt(1.09));
    square.emplace_back(p, (std::min)(to_x, to_y));
    far.emplace_back(p, 0.5 + 0.4 * x);
  }
  // a sheet may have features, though nothing but its outline can be one
  const Result result = run(square);
  assert(result.report.status == Status::SUCCESS && result.wireframe.curves.size() >= 4);
  assert(result.report.warnings.size() == 1 && result.report.warnings[0].find("plane") != std::string::npos);
  check_refused(far, Status::NO_FEATURE, "smallest distance");
}

// ---- invalid values

void test_values_that_are_not_finite()
{
  for (double bad : {nan, infinity, -infinity})
    for (int coordinate = 0; coordinate < 4; ++coordinate)
    {
      Cloud cloud = box();
      for (std::size_t i : {std::size_t(17), std::size_t(2711)})
        if (coordinate == 3)
          cloud[i].second = bad;
        else
          cloud[i].first = Point(coordinate == 0 ? bad : 0., coordinate == 1 ? bad : 0., coordinate == 2 ? bad : 0.);
      const Result refused = run(cloud);
      assert(refused.report.status == Status::INVALID_INPUT);
      assert(says(refused.report, "17") && says(refused.report, "2 points") && says(refused.report, "finite"));
      assert(refused.report.number_of_skipped_points == 2);
      assert(says(refused.report, "skip_invalid(true)"));
      if (coordinate < 2)
        continue; // to save time
      const Result skipped = run(cloud, WP::skip_invalid(true));
      assert(is_box(skipped) && skipped.report.number_of_skipped_points == 2);
    }
}

void test_negative_distances()
{
  Cloud cloud = box();
  cloud[19].second = -1e-12;
  check_refused(cloud, Status::INVALID_INPUT, "negative");
  check_refused(cloud, Status::INVALID_INPUT, "19");
  const Result skipped = run(cloud, WP::skip_invalid(true));
  assert(is_box(skipped) && skipped.report.number_of_skipped_points == 1);
  cloud[19].second = -0.; // is no negative number
  assert(is_box(run(cloud)));

  for (auto& sample : cloud)
    sample.second = nan;
  const Result nothing = run(cloud, WP::skip_invalid(true));
  assert(nothing.report.status == Status::INVALID_INPUT);
  assert(nothing.report.number_of_skipped_points == cloud.size());
}

// ---- fields that do not fit

void test_no_feature()
{
  Cloud cloud = box();
  for (auto& sample : cloud)
    sample.second += 0.25;
  const double smallest = std::min_element(cloud.begin(), cloud.end(), [](const auto& a, const auto& b) {
                            return a.second < b.second;
                          })->second;
  const Result result = run(cloud);
  assert(result.report.status == Status::NO_FEATURE);
  assert(says(result.report, "smallest distance is " + std::to_string(smallest).substr(0, 5)));
  assert(says(result.report, "1.5 times"));
  assert(result.report.skeleton_size == 0 && result.report.sampling_distance > 0.);
}

void test_units()
{
  for (double factor : {1000., 25.4, 1. / 25.4, 1. / 1000.})
  {
    check_refused(scaled(box(), 1., factor), Status::INVALID_INPUT, "unit");
    // a sampling distance in the unit of the points does not hide that, nor one in that of the distances
    const Result given = run(scaled(box(), 1., factor), WP::sampling_distance(r));
    assert(given.report.status == Status::INVALID_INPUT && says(given.report, "unit"));
    assert(run(scaled(box(), 1., factor), WP::sampling_distance(factor * r)).report.status == Status::INVALID_INPUT);
    assert(is_box(run(scaled(box(), factor, factor))));
  }
}

void test_sampling_distance_that_does_not_fit()
{
  for (double factor : {1000., 100., 0.01, 0.001, 1e12, 1e-12})
  {
    const Result result = run(box(), WP::sampling_distance(factor * r));
    assert(result.report.status == Status::INVALID_INPUT && says(result.report, "sampling distance"));
  }
  for (double bad : {-1., -r, nan, infinity, -infinity})
  {
    const Result result = run(box(), WP::sampling_distance(bad));
    assert(result.report.status == Status::INVALID_INPUT && says(result.report, "sampling distance"));
  }
  assert(is_box(run(box(), WP::sampling_distance(r))));
  assert(is_box(run(box(), WP::sampling_distance(0.)))); // stands for the estimate
}

void test_constant_fields()
{
  for (double value : {0., 0.01, 1., 1e300})
  {
    Cloud cloud = box();
    for (auto& sample : cloud)
      sample.second = value;
    const Result result = run(cloud);
    assert(result.report.status == Status::INVALID_INPUT || result.report.status == Status::NO_FEATURE);
  }
}

void test_random_field()
{
  Random random(4);
  Cloud cloud = box();
  for (auto& sample : cloud)
    sample.second = 0.1 * random.uniform();
  run(cloud); // whatever it finds is finite
}

// ---- duplicates and outliers

void check_same(const Result& a, const Result& b)
{
  assert(a.wireframe.curves.size() == b.wireframe.curves.size());
  assert(a.wireframe.vertices.size() == b.wireframe.vertices.size());
  for (const Point& p : a.wireframe.vertices)
    assert(std::count_if(b.wireframe.vertices.begin(), b.wireframe.vertices.end(),
                         [&](const Point& q) { return CGAL::squared_distance(p, q) < 1e-6 * r * r; })
           == 1);
}

void test_duplicates()
{
  const Result once = run(box());
  assert(is_box(once) && once.report.number_of_duplicates == 0 && once.report.warnings.empty());
  Cloud twice = box(), in_turn;
  twice.insert(twice.end(), box().begin(), box().end());
  for (const auto& sample : box())
    in_turn.insert(in_turn.end(), 3, sample);
  for (const Cloud& cloud : {twice, in_turn})
  {
    const Result result = run(cloud);
    check_same(once, result);
    assert(result.report.skeleton_size == once.report.skeleton_size);
    assert(result.report.number_of_duplicates > once.report.skeleton_size);
    assert(result.report.warnings.size() == 1);
  }
}

void test_equal_points_with_different_distances()
{
  Cloud cloud = box();
  for (std::size_t i = 0; i < 1000; ++i)
    cloud.emplace_back(box()[i].first, box()[i].second + 0.5 * r);
  const Result result = run(cloud);
  assert(result.report.status == Status::SUCCESS);
  // a hundred distances at one place
  cloud = box();
  for (int i = 0; i < 100; ++i)
    cloud.emplace_back(Point(0.1, 0.1, 0.8), 0.001 * i);
  assert(run(cloud).report.status == Status::SUCCESS);
}

void test_outliers()
{
  for (double x : {10., 1e6, 1e9})
  {
    Cloud cloud = box();
    cloud.emplace_back(Point(x, -x, x), 0.);
    assert(is_box(run(cloud)));
  }
  Random random(5);
  Cloud cloud = box();
  for (int i = 0; i < 100; ++i)
    cloud.emplace_back(Point(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)), 0.5 * r);
  const Result result = run(cloud);
  assert(result.report.status == Status::SUCCESS && result.wireframe.curves.size() >= 12);
}

// ---- sizes and places

void test_huge_coordinates()
{
  for (double offset : {1e4, 1e6, 1e8})
  {
    Cloud cloud = box();
    for (auto& sample : cloud)
      sample.first = Point(sample.first.x() + offset, sample.first.y() - offset, sample.first.z() + offset);
    const Result result = run(cloud);
    assert(is_box(result));
    for (const Point& p : result.wireframe.vertices)
      assert(std::abs(std::abs(p.x() - offset) - 0.6) < r && std::abs(std::abs(p.y() + offset) - 0.5) < r);
  }
}

void test_other_sizes()
{
  for (double factor : {1e-100, 1e-9, 1e9, 1e100})
    assert(is_box(run(scaled(box(), factor, factor))));
  // beyond the range of double squares, anything but a crash
  for (double factor : {1e-320, 1e-200, 1e160, 1e300})
    run(scaled(box(), factor, factor));
}

void test_tiny_clouds()
{
  std::size_t number_of_successes = 0, number_of_failures = 0;
  for (int n = 3; n <= 50; ++n)
    for (std::uint64_t seed = 0; seed < 12; ++seed)
    {
      Random random(seed, std::uint64_t(n));
      Cloud cloud;
      for (int i = 0; i < n; ++i)
      {
        double x = random.uniform(), y = random.uniform(), z = random.uniform(), d = random.uniform();
        switch (seed % 6)
        {
        case 0: break;
        case 1: z = 0.1 * x; break;
        case 2: d *= 1e-3; break;
        case 3: // on a lattice, with duplicates and ties
          x = std::floor(4. * x);
          y = std::floor(4. * y);
          z = std::floor(4. * z);
          d = std::floor(3. * d);
          break;
        case 4:
          y *= 1e-5;
          z *= 1e-5;
          d *= 0.1;
          break;
        case 5:
          y = x * x;
          z = 0.2 * z;
          d *= 0.2;
          break;
        }
        cloud.emplace_back(Point(x, y, z), d);
      }
      const Result result = run(cloud);
      ++(result.report.status == Status::SUCCESS ? number_of_successes : number_of_failures);
      switch ((std::uint64_t(n) + seed) % 3)
      {
      case 0: run(cloud, WP::paper_defaults()); break;
      case 1: run(cloud, WP::sampling_distance(0.4)); break;
      case 2: run(cloud, WP::graph_method(WE::Graph_method::SUBDIVIDED)); break;
      }
    }
  assert(number_of_successes > 0 && number_of_failures > 0); // both ways were tried
}

// ---- parameters out of their ranges

template <class NamedParameters>
void refuse_parameter(const NamedParameters& np, const std::string& name)
{
  const Result result = run(box(), np);
  assert(result.report.status == Report::Status::INVALID_INPUT && result.wireframe.is_empty());
  assert(says(result.report, name + " is ") && says(result.report, "it must be finite"));
}

void test_parameters_out_of_range()
{
  const double nan = (std::numeric_limits<double>::quiet_NaN)(), infinity = (std::numeric_limits<double>::infinity)();
  for (double x : {-1., 0., nan, infinity})
  {
    refuse_parameter(WP::skeleton_distance(x), "skeleton_distance");
    refuse_parameter(WP::support_distance(x), "support_distance");
    refuse_parameter(WP::fitting_radius(x), "fitting_radius");
    refuse_parameter(WP::corner_radius(x), "corner_radius");
    refuse_parameter(WP::corner_sampling_ratio(x), "corner_sampling_ratio");
    refuse_parameter(WP::connection_radius(x), "connection_radius");
    refuse_parameter(WP::split_threshold(x), "split_threshold");
    refuse_parameter(WP::type_significance(x), "type_significance");
  }
  for (double x : {-1., nan, infinity})
  {
    refuse_parameter(WP::corner_reach(x), "corner_reach");
    refuse_parameter(WP::maximum_gap(x), "maximum_gap");
    refuse_parameter(WP::minimum_evidence(x), "minimum_evidence");
  }
  refuse_parameter(WP::smooth_angle(181.), "smooth_angle");
  refuse_parameter(WP::connection_angle(91.), "connection_angle");
  refuse_parameter(WP::noise_level(1.1), "noise_level");
  refuse_parameter(WP::number_of_rounds(0), "number_of_rounds");
}

// ---- a field that was cut off, and points that are far away

void test_truncated_fields()
{
  const double r = WE::estimate_sampling_distance(box());
  const auto cut_off = [&](double bound) {
    Cloud cloud = box();
    for (auto& sample : cloud)
      sample.second = (std::min)(sample.second, bound * r);
    return cloud;
  };
  const Result early = run(cut_off(1.2));
  assert(early.report.status == Report::Status::INVALID_INPUT && says(early.report, "cut off"));
  const Result tight = run(cut_off(2.));
  assert(is_box(tight) && tight.report.warnings.size() == 1
         && tight.report.warnings[0].find("cut off") != std::string::npos);
  assert(run(cut_off(3.5)).report.warnings.empty());
}

void test_points_far_away()
{
  for (double x : {1e12, 1e16, 1e18, 1e30, 3.4028235e38, 1e300})
  {
    Cloud cloud = box();
    cloud.emplace_back(Point(x, 0., 0.), 0.);
    const Result result = run(cloud);
    assert(is_box(result) && result.report.warnings.size() == 1
           && result.report.warnings[0].find("away from the others: 1") != std::string::npos);
    assert(result.report.number_of_strays == 1);
  }
}

// ---- parameters at their limits

void test_odd_parameters()
{
  for (double x : {0., 1e-9})
  {
    run(box(), WP::skeleton_distance(x));
    run(box(), WP::support_distance(x));
    run(box(), WP::connection_radius(x));
    run(box(), WP::fitting_radius(x));
    run(box(), WP::corner_reach(x));
    run(box(), WP::maximum_gap(x));
    run(box(), WP::smooth_angle(x));
    run(box(), WP::noise_level(x));
    run(box(), WP::minimum_evidence(x));
    run(box(), WP::paper_defaults().corner_sampling_ratio(x));
    run(box(), WP::paper_defaults().corner_radius(x));
    run(box(), WP::number_of_rounds(int(x)));
  }
  run(box(), WP::maximum_gap(1e6).corner_reach(1e3));
  run(box(), WP::smooth_angle(180.).connection_angle(180.));
  run(box(), WP::noise_level(10.));
  run(box(), WP::paper_defaults().split_threshold(0.5));
}

} // namespace

int main()
{
  test_few_points();
  test_collinear_points();
  test_coplanar_points();
  test_values_that_are_not_finite();
  test_negative_distances();
  test_no_feature();
  test_units();
  test_sampling_distance_that_does_not_fit();
  test_constant_fields();
  test_random_field();
  test_duplicates();
  test_equal_points_with_different_distances();
  test_outliers();
  test_huge_coordinates();
  test_other_sizes();
  test_tiny_clouds();
  test_parameters_out_of_range();
  test_truncated_fields();
  test_points_far_away();
  test_odd_parameters();
  return 0;
}
