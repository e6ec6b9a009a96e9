// Clouds without distances: these are estimated from the points alone.

#include <CGAL/Wireframe_extraction/estimate_distance_field.h>

#include "sample_clouds.h"

#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/find_doubts.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/recognize_curve_types.h>
#include <CGAL/Wireframe_extraction/refine_field.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>
#include <CGAL/extract_wireframe.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Simple_cartesian.h>

#include <Sample_solids/Sample_solids.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef std::vector<Point> Points;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_extraction_report Report;
typedef Report::Status Status;
typedef Sample_solids::Random Random;

namespace WE = CGAL::Wireframe_extraction;
namespace WP = CGAL::Wireframe_extraction::parameters;

using Sample_solids::Sampling;

const double r = 0.03;

struct Raw_shape
{
  Sample_solids::Solid solid;
  Sample_solids::Ground_truth truth;
  Cloud cloud; // with the true distances
  Points points;
};

Raw_shape raw_shape(const std::string& name, Sampling sampling = Sampling::POISSON)
{
  Raw_shape shape;
  shape.solid = Sample_solids::make_solid(name);
  shape.truth = Sample_solids::ground_truth(shape.solid, r);
  Sample_solids::Sampling_options options;
  options.sampling_distance = r;
  options.sampling = sampling;
  shape.cloud = cloud_of_samples<Point>(Sample_solids::sample(shape.solid, options));
  for (const auto& sample : shape.cloud)
    shape.points.push_back(sample.first);
  return shape;
}

const Raw_shape& box()
{
  static const Raw_shape shape = raw_shape("box");
  return shape;
}

// what many a test compares with
const Wireframe& wireframe_of_box()
{
  static const Wireframe wireframe = CGAL::extract_wireframe(box().points);
  return wireframe;
}

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

double median(std::vector<double> values)
{
  assert(!values.empty());
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// ---- the estimate

void test_distances()
{
  Report report;
  const Raw_shape& shape = box();
  const WE::Distance_field field = WE::estimate_distance_field(shape.points, WP::extraction_report(std::ref(report)));
  assert(report.status == Status::SUCCESS && report.message.empty());
  assert(field.distances.size() == shape.points.size() && field.deviations.size() == shape.points.size());
  assert(report.is_field_estimated && report.number_of_points == shape.points.size());
  assert(report.sampling_distance == field.sampling_distance && report.point_noise == field.point_noise);
  assert(report.number_of_near_points == field.number_of_near_points);
  assert(std::abs(field.sampling_distance / r - 1.) < 0.06);
  assert(field.point_noise >= 0. && field.point_noise < 0.05 * r);
  assert(field.noise_level > 0. && field.noise_level <= 1.);
  assert(field.truncation > 3. * r);
  std::vector<double> near_errors, far_errors;
  std::size_t near_points = 0;
  for (std::size_t i = 0; i < field.distances.size(); ++i)
  {
    const double truth = (std::min)(shape.cloud[i].second, field.truncation);
    assert(field.distances[i] >= 0. && field.distances[i] <= field.truncation && field.deviations[i] > 0.);
    near_points += field.distances[i] < field.truncation;
    (truth < 2. * r ? near_errors : far_errors).push_back(std::abs(field.distances[i] - truth));
  }
  assert(near_points == field.number_of_near_points);
  assert(median(near_errors) < 0.1 * r);
  assert(median(far_errors) < 0.1 * r);
}

struct Scan_point
{
  Point position;
  float distance, deviation;
};
struct Position_map
{
  typedef Scan_point key_type;
  typedef Point value_type;
  typedef const Point& reference;
  typedef boost::readable_property_map_tag category;
  friend const Point& get(const Position_map&, const Scan_point& p) { return p.position; }
};
struct Distance_map // that can only be written to
{
  typedef Scan_point key_type;
  typedef float value_type;
  typedef float reference;
  typedef boost::writable_property_map_tag category;
  friend void put(const Distance_map&, Scan_point& p, float distance) { p.distance = distance; }
};
struct Deviation_map
{
  typedef Scan_point key_type;
  typedef float value_type;
  typedef float reference;
  typedef boost::writable_property_map_tag category;
  friend void put(const Deviation_map&, Scan_point& p, float deviation) { p.deviation = deviation; }
};

// writes to maps, of ranges of any kind
void test_maps()
{
  const WE::Distance_field field = WE::estimate_distance_field(box().points);
  Cloud pairs;
  for (const Point& p : box().points)
    pairs.emplace_back(p, std::numeric_limits<double>::quiet_NaN());
  const WE::Distance_field of_pairs = WE::estimate_distance_field(pairs);
  assert(of_pairs.distances == field.distances);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    assert(pairs[i].second == field.distances[i]);

  // a constant range of pairs stays as it is
  Cloud other = pairs;
  for (auto& sample : other)
    sample.second = -1.;
  const Cloud& constant = other;
  assert(WE::estimate_distance_field(constant).distances == field.distances && constant.front().second == -1.);

  std::list<Scan_point> scan;
  for (const Point& p : box().points)
    scan.push_back({p, -1.f, -1.f});
  const WE::Distance_field of_scan = WE::estimate_distance_field(
    scan, WP::distance_map(Distance_map()).deviation_map(Deviation_map()).point_map(Position_map()));
  assert(of_scan.distances == field.distances);
  std::size_t i = 0;
  for (const Scan_point& p : scan)
  {
    assert(p.distance == float(field.distances[i]) && p.deviation == float(field.deviations[i]));
    ++i;
  }
}

// Every position counts once, and what lies far away not at all.
void test_duplicates_and_strays()
{
  const WE::Distance_field field = WE::estimate_distance_field(box().points, WP::sampling_distance(r));
  Points points = box().points;
  points.insert(points.end(), box().points.begin(), box().points.begin() + std::ptrdiff_t(box().points.size() / 2));
  const WE::Distance_field of_more = WE::estimate_distance_field(points, WP::sampling_distance(r));
  assert(of_more.distances.size() == points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    assert(of_more.distances[i] == field.distances[i % box().points.size()]);

  points = box().points;
  points.emplace_back(1e300, 0., 0.);
  const WE::Distance_field with_stray = WE::estimate_distance_field(points, WP::sampling_distance(r));
  assert(with_stray.distances.back() == with_stray.truncation);
  for (std::size_t i = 0; i < box().points.size(); ++i) // what rounding changes is little
    assert(std::abs(with_stray.distances[i] - field.distances[i]) < 0.1 * r);
}

void test_skipped()
{
  Points points = box().points;
  points.insert(points.begin() + 5, Point(std::numeric_limits<double>::quiet_NaN(), 0., 0.));
  Report report;
  assert(WE::estimate_distance_field(points, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::INVALID_INPUT && report.message.find("index 5") != std::string::npos);
  const WE::Distance_field field =
    WE::estimate_distance_field(points, WP::skip_invalid(true).extraction_report(std::ref(report)));
  assert(report.status == Status::SUCCESS && report.number_of_skipped_points == 1);
  assert(std::isnan(field.distances[5]) && std::isnan(field.deviations[5]));
  const WE::Distance_field without = WE::estimate_distance_field(box().points);
  for (std::size_t i = 0; i < box().points.size(); ++i)
    assert(field.distances[i + (i >= 5)] == without.distances[i]);
  const Wireframe wireframe =
    CGAL::extract_wireframe(points, WP::skip_invalid(true).extraction_report(std::ref(report)));
  assert(report.status == Status::SUCCESS && wireframe.curves.size() == 12);
}

void test_bad_input()
{
  Report report;
  const auto check_refused = [&report](const Points& points, const std::string& part) {
    assert(WE::estimate_distance_field(points, WP::extraction_report(std::ref(report))).is_empty());
    assert(report.status == Status::INVALID_INPUT && report.message.find(part) != std::string::npos);
    assert(CGAL::extract_wireframe(points, WP::extraction_report(std::ref(report))).is_empty());
    assert(report.status == Status::INVALID_INPUT && report.message.find(part) != std::string::npos);
  };
  check_refused(Points(), "no points");
  check_refused(Points(1, Point(1, 2, 3)), "coincide");
  check_refused(Points(1000, Point(1, 2, 3)), "coincide");
  Points line;
  for (int i = 0; i < 1000; ++i)
    line.emplace_back(i, 2 * i, 3 * i);
  check_refused(line, "on one line");
  check_refused(Points(10, Point(0, std::numeric_limits<double>::infinity(), 0)), "not finite");
  for (double fold : {0., -5., 181., std::numeric_limits<double>::quiet_NaN()})
  {
    const auto np = WP::minimum_fold(fold).extraction_report(std::ref(report));
    assert(WE::estimate_distance_field(box().points, np).is_empty());
    assert(report.status == Status::INVALID_INPUT && report.message.find("minimum_fold") != std::string::npos);
    assert(CGAL::extract_wireframe(box().points, np).is_empty());
    assert(report.status == Status::INVALID_INPUT && report.message.find("minimum_fold") != std::string::npos);
  }
  const auto np = WP::sampling_distance(1e3 * r).extraction_report(std::ref(report));
  assert(WE::estimate_distance_field(box().points, np).is_empty());
  assert(report.status == Status::INVALID_INPUT && report.message.find("another unit") != std::string::npos);
  assert(CGAL::extract_wireframe(box().points, np).is_empty() && report.status == Status::INVALID_INPUT);
  // few points are no error, but show nothing
  const Points few = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), Point(1, 1, 0)};
  assert(CGAL::extract_wireframe(few, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::NO_FEATURE);
}

// ---- whole shapes

std::vector<Point> samples_of(const Wireframe::Curve& curve)
{
  std::vector<Point> points;
  curve.spline.sample_by_distance(0.25 * r, std::back_inserter(points));
  return points;
}

double largest_distance(const std::vector<Point>& from, const std::vector<Point>& to)
{
  double result = 0.;
  for (const Point& p : from)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Point& q : to)
      nearest = (std::min)(nearest, distance(p, q));
    result = (std::max)(result, nearest);
  }
  return result;
}

bool are_equal(const Wireframe::Curve& curve, const Sample_solids::True_curve& truth)
{
  std::vector<Point> true_points;
  for (const Sample_solids::Point& p : truth.points)
    true_points.emplace_back(p[0], p[1], p[2]);
  const std::vector<Point> samples = samples_of(curve);
  return curve.is_closed() == truth.is_closed && largest_distance(samples, true_points) < r
    && largest_distance(true_points, samples) < r;
}

void check_shape(const std::string& name, Sampling sampling)
{
  const Raw_shape shape = raw_shape(name, sampling);
  Report report;
  const Wireframe wireframe = CGAL::extract_wireframe(shape.points, WP::extraction_report(std::ref(report)));
  assert(report.status == Status::SUCCESS && report.is_field_estimated);
  assert(wireframe.vertices.size() == shape.truth.corners.size());
  assert(wireframe.curves.size() == shape.truth.curves.size());
  for (const Sample_solids::Point& corner : shape.truth.corners)
    assert(std::count_if(wireframe.vertices.begin(), wireframe.vertices.end(),
                         [&](const Point& p) { return distance(p, Point(corner[0], corner[1], corner[2])) < 0.5 * r; })
           == 1);
  for (const Sample_solids::True_curve& truth : shape.truth.curves)
    assert(std::count_if(wireframe.curves.begin(), wireframe.curves.end(),
                         [&](const Wireframe::Curve& curve) { return are_equal(curve, truth); })
           == 1);
}

void check_no_feature(const Points& points)
{
  Report report;
  assert(CGAL::extract_wireframe(points, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::NO_FEATURE && report.is_field_estimated && report.number_of_curves == 0);
}

double gaussian(Random& random)
{
  double sum = -6.;
  for (int i = 0; i < 12; ++i)
    sum += random.uniform();
  return sum;
}

Vector direction(Random& random)
{
  const double z = 2. * random.uniform() - 1., angle = 2. * CGAL_PI * random.uniform(), radius = std::sqrt(1. - z * z);
  return Vector(radius * std::cos(angle), radius * std::sin(angle), z);
}

void test_no_feature()
{
  Random random(1);
  Points sphere, torus, plane;
  for (int i = 0; i < 10000; ++i)
  {
    sphere.push_back(CGAL::ORIGIN + direction(random));
    // as many points as there is area, which the inner side of a torus has less of
    double around, share;
    do
    {
      around = 2. * CGAL_PI * random.uniform();
      share = (1. + 0.4 * std::cos(around)) / 1.4;
    } while (random.uniform() > share);
    const double along = 2. * CGAL_PI * random.uniform(), radius = 1. + 0.4 * std::cos(around);
    torus.emplace_back(radius * std::cos(along), radius * std::sin(along), 0.4 * std::sin(around));
    plane.emplace_back(random.uniform(), random.uniform(), 0.002 * gaussian(random));
  }
  check_no_feature(sphere);
  check_no_feature(torus);
  check_no_feature(plane); // whose boundary is none
  // the noise that is there is seen
  const WE::Distance_field field = WE::estimate_distance_field(plane);
  assert(field.number_of_near_points == 0 && !field.is_empty());
  assert(std::all_of(field.distances.begin(), field.distances.end(), [&](double d) { return d == field.truncation; }));
  assert(std::abs(field.point_noise / 0.002 - 1.) < 0.2);
}

// a fold of 90 degrees is none where 100 are asked for
void test_minimum_fold()
{
  Report report;
  assert(CGAL::extract_wireframe(box().points, WP::minimum_fold(150.).extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::NO_FEATURE && report.message.find("150 degrees") != std::string::npos);
}

// ---- what must not matter

bool are_near(const Wireframe& a, const Wireframe& b, double tolerance)
{
  if (a.vertices.size() != b.vertices.size() || a.curves.size() != b.curves.size())
    return false;
  return std::all_of(a.curves.begin(), a.curves.end(), [&](const Wireframe::Curve& curve) {
    return std::any_of(b.curves.begin(), b.curves.end(), [&](const Wireframe::Curve& other) {
      const std::vector<Point> one = samples_of(curve), two = samples_of(other);
      return curve.type == other.type
        && std::all_of(one.begin(), one.end(),
                       [&](const Point& p) { return other.spline.closest_point(p).distance < tolerance; })
        && std::all_of(two.begin(), two.end(),
                       [&](const Point& p) { return curve.spline.closest_point(p).distance < tolerance; });
    });
  });
}

bool are_same(const Wireframe& a, const Wireframe& b)
{
  if (a.vertices != b.vertices || a.curves.size() != b.curves.size())
    return false;
  for (std::size_t i = 0; i < a.curves.size(); ++i)
    if (a.curves[i].type != b.curves[i].type
        || a.curves[i].spline.control_points() != b.curves[i].spline.control_points()
        || a.curves[i].spline.knots() != b.curves[i].spline.knots())
      return false;
  return true;
}

void test_invariance()
{
  const Points& points = box().points;
  assert(are_near(CGAL::extract_wireframe(shuffled(points, 7)), wireframe_of_box(), 1e-6 * r));

  // by a quarter turn and a power of two, rounding has little to say; the sample for r is another one after any motion
  const double scale = 4.;
  const CGAL::Aff_transformation_3<Kernel> motion(0, -scale, 0, 8., scale, 0, 0, -16., 0, 0, scale, 32.);
  Points moved;
  for (const Point& p : points)
    moved.push_back(motion.transform(p));
  const Wireframe of_moved = CGAL::extract_wireframe(moved, WP::sampling_distance(scale * r));
  Wireframe back = of_moved;
  const CGAL::Aff_transformation_3<Kernel> inverse = motion.inverse();
  for (Wireframe::Curve& curve : back.curves)
  {
    Points control_points;
    for (const Point& p : curve.spline.control_points())
      control_points.push_back(inverse.transform(p));
    curve.spline = curve.spline.is_rational()
      ? Wireframe::Curve::Spline(curve.spline.degree(), curve.spline.knots(), control_points, curve.spline.weights())
      : Wireframe::Curve::Spline(curve.spline.degree(), curve.spline.knots(), control_points);
  }
  assert(are_near(back, CGAL::extract_wireframe(points, WP::sampling_distance(r)), 0.05 * r));
}

void test_threads()
{
  const Wireframe& wireframe = wireframe_of_box();
  assert(are_same(CGAL::extract_wireframe<CGAL::Sequential_tag>(box().points), wireframe));
#ifdef CGAL_LINKED_WITH_TBB
  const std::vector<double> distances = WE::estimate_distance_field<CGAL::Sequential_tag>(box().points).distances;
  for (std::size_t count : {1, 3})
  {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, count);
    assert(are_same(CGAL::extract_wireframe(box().points), wireframe));
    assert(WE::estimate_distance_field(box().points).distances == distances);
  }
#endif
}

// a bound on the points in memory is no error, but is none for these clouds
void test_points_in_memory()
{
  assert(are_same(CGAL::extract_wireframe(box().points, WP::points_in_memory(1000)), wireframe_of_box()));
}

// ---- the one call

struct Field_keeper : WE::Default_visitor
{
  WE::Distance_field field;
  double sampling_distance = 0.;

  void sampling_distance_estimated(double value) { sampling_distance = value; }
  void field_estimated(const WE::Distance_field& f)
  {
    assert(sampling_distance > 0.);
    field = f;
  }
  template <class Skeleton>
  void skeleton_selected(const Skeleton&)
  {
    assert(!field.is_empty());
  }
};

void test_stage_by_stage()
{
  Report report;
  Field_keeper visitor;
  const Wireframe wireframe =
    CGAL::extract_wireframe(box().points, WP::extraction_report(std::ref(report)).visitor(std::ref(visitor)));
  const auto is_field = [](const std::pair<std::string, double>& stage) { return stage.first == "field"; };
  assert(std::count_if(report.seconds.begin(), report.seconds.end(), is_field) == 1);

  const WE::Distance_field field = WE::estimate_distance_field(box().points);
  assert(field.distances == visitor.field.distances && field.deviations == visitor.field.deviations);
  assert(field.noise_level == visitor.field.noise_level && field.sampling_distance == visitor.field.sampling_distance);
  assert(report.point_noise == field.point_noise && report.number_of_near_points == field.number_of_near_points);

  Cloud cloud;
  for (std::size_t i = 0; i < box().points.size(); ++i)
    cloud.emplace_back(box().points[i], field.distances[i]);
  const auto np = WP::sampling_distance(field.sampling_distance).noise_level(field.noise_level);
  auto skeleton = WE::select_skeleton(cloud, np);
  assert(WE::contract_skeleton(skeleton, np) && WE::refine_field(skeleton, np));
  const auto corners = WE::detect_corners(skeleton, np);
  const auto clusters = WE::segment_curves(skeleton, corners, np);
  const auto graph = WE::build_topological_graph(skeleton, corners, clusters, np);
  const Wireframe splines = WE::fit_curves(skeleton, graph, np);
  Wireframe typed = WE::recognize_curve_types(skeleton, splines, np);
  assert(are_same(typed, wireframe));
  assert(WE::find_doubts(skeleton, typed, np));
  for (std::size_t i = 0; i < typed.curves.size(); ++i)
    assert(typed.curves[i].doubts == wireframe.curves[i].doubts);
  assert(are_same(CGAL::extract_wireframe(cloud, np), wireframe));

  // which models the concept, so that it may stand for any visitor
  assert(are_same(CGAL::extract_wireframe(box().points, WP::visitor(WE::Default_visitor())), wireframe));

  // what the user knows better counts
  const Wireframe given = CGAL::extract_wireframe(box().points, WP::noise_level(0.1));
  assert(
    are_same(given, CGAL::extract_wireframe(cloud, WP::sampling_distance(field.sampling_distance).noise_level(0.1))));
}

// A cloud whose noise is larger than its spacing is looked at by means of its points.
void test_much_noise()
{
  Random random(3);
  Points points = box().points;
  for (Point& p : points)
    p = p + 1.5 * r * Vector(gaussian(random), gaussian(random), gaussian(random));
  Report report;
  const Wireframe wireframe = CGAL::extract_wireframe(points, WP::extraction_report(std::ref(report)));
  assert(report.status == Status::SUCCESS || report.status == Status::NO_FEATURE);
  assert(report.sampling_distance > 1.5 * r && report.warnings.size() == 1 && report.number_of_skipped_points == 0);
  assert(report.warnings.front().find("means") != std::string::npos);
  assert(report.number_of_points == points.size() && report.point_noise > 0.5 * r);
  // who names the scale gets it
  CGAL::extract_wireframe(points, WP::sampling_distance(r).extraction_report(std::ref(report)));
  assert(report.sampling_distance == r && report.warnings.empty());
}

// points with normals have no distances
void test_normals()
{
  std::vector<std::pair<Point, Vector>> points;
  for (const Point& p : box().points)
    points.emplace_back(p, Vector(0, 0, 1));
  const Wireframe& wireframe = wireframe_of_box();
  assert(are_same(CGAL::extract_wireframe(points), wireframe));
  const auto map = CGAL::First_of_pair_property_map<std::pair<Point, Vector>>();
  assert(are_same(CGAL::extract_wireframe(points, WP::point_map(map)), wireframe));
  assert(!WE::estimate_distance_field(points).is_empty());
}

class Bare_source : public WE::Distance_cloud_source
{
public:
  bool read(const Sink& sink) override
  {
    for (const Point& p : box().points)
    {
      const Sample sample = {p.x(), p.y(), p.z(), std::numeric_limits<double>::quiet_NaN()};
      if (!sink(&sample, &sample + 1))
        break;
    }
    return true;
  }
  bool has_distances() const override { return false; }
};

void test_source()
{
  Bare_source source;
  Report report;
  const Wireframe wireframe =
    CGAL::extract_wireframe_from_source<Kernel>(source, WP::extraction_report(std::ref(report)));
  assert(report.is_field_estimated && are_same(wireframe, wireframe_of_box()));
  assert(are_same(CGAL::extract_wireframe_from_source<Kernel>(source, WP::points_in_memory(1000)), wireframe));
}

// The share that is done grows, and the work stops wherever it is told to.
void test_cancelling()
{
  std::vector<double> shares;
  const auto record = [&shares](double share) {
    shares.push_back(share);
    return true;
  };
  Report report;
  const auto np = WP::extraction_report(std::ref(report));
  CGAL::extract_wireframe(box().points, np.callback(std::function<bool(double)>(record)));
  assert(std::is_sorted(shares.begin(), shares.end()) && shares.front() >= 0. && shares.back() == 1.);
  for (std::size_t last = 0; last < shares.size(); last += 1 + shares.size() / 12)
  {
    std::size_t calls = 0;
    const std::function<bool(double)> stop = [&](double) { return calls++ < last; };
    assert(CGAL::extract_wireframe(box().points, np.callback(stop)).is_empty());
    assert(report.status == Status::CANCELLED && calls == last + 1);
  }
  for (std::size_t last = 0; last < 3; ++last)
  {
    std::size_t calls = 0;
    const std::function<bool(double)> stop = [&](double) { return calls++ < last; };
    assert(WE::estimate_distance_field(box().points, np.callback(stop)).is_empty());
    assert(report.status == Status::CANCELLED && calls == last + 1);
  }
}

} // namespace

int main()
{
  test_distances();
  test_maps();
  test_duplicates_and_strays();
  test_skipped();
  test_bad_input();
  for (const char* const name : {"box", "cylinder", "box_with_hole"})
    for (Sampling sampling : {Sampling::POISSON, Sampling::UNIFORM})
      check_shape(name, sampling);
  test_no_feature();
  test_minimum_fold();
  test_invariance();
  test_threads();
  test_points_in_memory();
  test_stage_by_stage();
  test_much_noise();
  test_normals();
  test_source();
  test_cancelling();
  return 0;
}
