// Whole shapes, of which the ground truth is known: as many curves and corners as there are, each where it is.

#include "sample_clouds.h"

#include <CGAL/extract_wireframe.h>

#include <CGAL/Simple_cartesian.h>

#include <Sample_solids/Sample_solids.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::vector<std::pair<Kernel::Point_3, double>> Cloud;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_extraction_report Report;

using Sample_solids::Field_kind;
using Sample_solids::Ground_truth;
using Sample_solids::Point;
using Sample_solids::Sampling;

namespace WP = CGAL::Wireframe_extraction::parameters;

const double r = 0.02;

struct Sampled_shape
{
  Sample_solids::Solid solid;
  Ground_truth truth;
  Cloud cloud;
};

Sampled_shape sampled(const std::string& name, Sampling sampling, Field_kind field)
{
  Sampled_shape shape;
  shape.solid = Sample_solids::make_solid(name);
  shape.truth = Sample_solids::ground_truth(shape.solid, r);
  Sample_solids::Sampling_options options;
  options.sampling_distance = r;
  options.sampling = sampling;
  options.field = field;
  shape.cloud = cloud_of_samples<Kernel::Point_3>(Sample_solids::sample(shape.solid, options));
  return shape;
}

// keeps the splines as well
struct Spline_keeper : CGAL::Wireframe_extraction::Default_visitor
{
  Wireframe splines;
  void curves_fitted(const Wireframe& wireframe) { splines = wireframe; }
};

struct Result
{
  Wireframe splines, typed;
};

Result extracted(const Sampled_shape& shape)
{
  Report report;
  Spline_keeper visitor;
  const Wireframe wireframe =
    CGAL::extract_wireframe(shape.cloud, WP::extraction_report(std::ref(report)).visitor(std::ref(visitor)));
  assert(report.status == Report::Status::SUCCESS && report.message.empty());
  assert(report.number_of_points == shape.cloud.size());
  assert(report.number_of_curves == wireframe.curves.size());
  assert(report.number_of_corners + report.number_of_free_ends == wireframe.vertices.size());
  assert(report.sampling_distance == wireframe.sampling_distance);
  assert(std::abs(report.sampling_distance / r - 1.) < 0.06);
  assert(report.skeleton_size > 100 && report.number_of_clusters > 0);
  assert(report.rms > 0. && report.rms <= report.max);
  assert(!report.seconds.empty());
  return {visitor.splines, wireframe};
}

std::vector<Point> samples_of(const Wireframe::Curve& curve, double step)
{
  std::vector<Kernel::Point_3> points;
  curve.spline.sample_by_distance(step, std::back_inserter(points));
  std::vector<Point> result;
  for (const Kernel::Point_3& p : points)
    result.push_back({{p.x(), p.y(), p.z()}});
  return result;
}

// The mean and the largest distance of positions, in sampling distances.
struct Deviation
{
  double mean, largest;
};

template <class Distance>
Deviation deviation(const std::vector<Point>& positions, const Distance& distance_of)
{
  Deviation result = {0., 0.};
  for (const Point& p : positions)
  {
    const double d = distance_of(p) / r;
    result.mean += d / double(positions.size());
    result.largest = (std::max)(result.largest, d);
  }
  return result;
}

Deviation deviation_from_truth(const Sampled_shape& shape, const Wireframe& wireframe)
{
  const Sample_solids::Curve_distance distance(shape.solid.curves, shape.solid.sharp_curves());
  std::vector<Point> positions;
  for (const Wireframe::Curve& curve : wireframe.curves)
    for (const Point& p : samples_of(curve, 0.5 * r))
      positions.push_back(p);
  return deviation(positions, [&](const Point& p) { return distance(p, 1e300); });
}

double distance_to_points(const Point& p, const std::vector<Point>& points)
{
  double best = 1e300;
  for (const Point& q : points)
    best = (std::min)(best, Sample_solids::squared_distance(p, q));
  return std::sqrt(best);
}

// how far the truth is from the wireframe
Deviation deviation_from_wireframe(const Sampled_shape& shape, const Wireframe& wireframe)
{
  Sample_solids::Point_grid grid(4. * r, 10000);
  for (const Wireframe::Curve& curve : wireframe.curves)
    for (const Point& p : samples_of(curve, 0.1 * r))
      grid.add(p);
  std::vector<Point> positions;
  for (const Sample_solids::True_curve& curve : shape.truth.curves)
    positions.insert(positions.end(), curve.points.begin(), curve.points.end());
  return deviation(positions, [&](const Point& p) {
    double squared = 400. * r * r;
    grid.visit_ball(p, 20. * r, [&](std::size_t, double d) {
      squared = (std::min)(squared, d);
      return true;
    });
    return std::sqrt(squared);
  });
}

// whether an extracted curve is a true one, from end to end
bool are_equal(const Wireframe::Curve& curve, const Sample_solids::True_curve& truth)
{
  if (curve.is_closed() != truth.is_closed
      || std::abs(curve.spline.length() - truth.length) > 0.02 * truth.length + 2. * r)
    return false;
  const Point& middle = truth.points[truth.points.size() / 2];
  if (curve.spline.closest_point(Kernel::Point_3(middle[0], middle[1], middle[2])).distance > r)
    return false;
  const std::vector<Point> samples = samples_of(curve, 0.25 * r);
  return deviation(samples, [&](const Point& p) { return distance_to_points(p, truth.points); }).largest < 1.
    && deviation(truth.points, [&](const Point& p) { return distance_to_points(p, samples); }).largest < 1.;
}

Sample_solids::Curve_kind kind_of(CGAL::Wireframe_curve_type type)
{
  typedef CGAL::Wireframe_curve_type Type;
  typedef Sample_solids::Curve_kind Kind;
  return type == Type::LINE ? Kind::LINE
    : type == Type::CIRCLE  ? Kind::CIRCLE
    : type == Type::ARC     ? Kind::ARC
    : type == Type::BSPLINE ? Kind::SPLINE
                            : Kind::ELLIPSE;
}

// as many lines, circles, ellipses and splines as there are, where they are, and of their size
void check_types(const Sampled_shape& shape, const Wireframe& wireframe)
{
  assert(wireframe.curves.size() == shape.truth.segments.size());
  for (const Sample_solids::True_curve& truth : shape.truth.segments)
    assert(std::count_if(wireframe.curves.begin(), wireframe.curves.end(),
                         [&](const Wireframe::Curve& curve) {
                           return kind_of(curve.type) == truth.kind && are_equal(curve, truth);
                         })
           == 1);
  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    assert(curve.support > 0 && curve.rms < 0.3 * r);
    assert(curve.source == curve.no_vertex
           || (curve.spline.control_points().front() == wireframe.vertices[curve.source]
               && curve.spline.control_points().back() == wireframe.vertices[curve.target]));
    if (curve.type == CGAL::Wireframe_curve_type::BSPLINE)
      continue;
    assert(curve.uncertainty.position > 0. && curve.uncertainty.position < 0.1 * r);
    assert(curve.uncertainty.direction > 0. && curve.uncertainty.direction < 0.1);
  }
  assert(deviation_from_truth(shape, wireframe).mean < 0.1);
}

// Where only two curves meet, and these are pieces of a smooth one, their tangents agree.
void check_tangent_joins(const Wireframe& wireframe, std::size_t expected)
{
  std::vector<std::vector<Kernel::Vector_3>> tangents(wireframe.vertices.size());
  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    const auto range = curve.spline.parameter_range();
    tangents[curve.source].push_back(curve.spline.tangent(range.first));
    tangents[curve.target].push_back(-curve.spline.tangent(range.second));
  }
  std::size_t joins = 0;
  for (const std::vector<Kernel::Vector_3>& pair : tangents)
    if (pair.size() == 2 && pair[0] * pair[1] < -0.9)
    {
      assert(std::sqrt(CGAL::cross_product(pair[0], pair[1]).squared_length()) < 1e-6);
      ++joins;
    }
  assert(joins == expected);
}

void check_exactly(const std::string& name, Sampling sampling)
{
  const Sampled_shape shape = sampled(name, sampling, Field_kind::EXACT);
  const Result result = extracted(shape);
  check_types(shape, result.typed);
  if (name == "slotted_plate")
    check_tangent_joins(result.typed, 8);
  const Wireframe& wireframe = result.splines;
  assert(wireframe.curves.size() == shape.truth.curves.size());
  assert(wireframe.vertices.size() == shape.truth.corners.size());
  for (const Sample_solids::True_curve& truth : shape.truth.curves)
    assert(std::count_if(wireframe.curves.begin(), wireframe.curves.end(),
                         [&](const Wireframe::Curve& curve) { return are_equal(curve, truth); })
           == 1);
  for (const Point& corner : shape.truth.corners)
    assert(std::count_if(wireframe.vertices.begin(), wireframe.vertices.end(),
                         [&](const Kernel::Point_3& p) {
                           return Sample_solids::distance(corner, Point{{p.x(), p.y(), p.z()}}) < 0.7 * r;
                         })
           == 1);
  assert(deviation_from_truth(shape, wireframe).mean < 0.1);
  assert(deviation_from_wireframe(shape, wireframe).mean < 0.3);
  for (const Wireframe::Curve& curve : wireframe.curves)
  {
    assert(curve.support > 0 && curve.rms < 0.3 * r);
    assert(!curve.spline.is_rational() && curve.spline.degree() == 3);
  }
}

// with errors like those of a regressor, pieces may be missing or too much, but what is there is nearly right
void check_with_errors(const std::string& name, Sampling sampling)
{
  const Sampled_shape shape = sampled(name, sampling, Field_kind::DEF);
  const Wireframe wireframe = extracted(shape).typed;
  assert(!wireframe.is_empty());
  assert(deviation_from_truth(shape, wireframe).mean < 0.6);
  assert(deviation_from_wireframe(shape, wireframe).mean < 0.6);
}

} // namespace

int main()
{
  for (const char* name : {"box", "cylinder", "frustum", "box_with_hole", "l_bracket", "nut", "wedge_30", "wedge_60",
                           "dimple", "crossing_cylinders", "u_channel", "slotted_plate", "torus", "elliptic_cut"})
    for (Sampling sampling : {Sampling::POISSON, Sampling::UNIFORM})
      check_exactly(name, sampling);
  for (const char* name : {"box", "frustum", "wedge_30", "wedge_60", "u_channel"})
    for (Sampling sampling : {Sampling::POISSON, Sampling::UNIFORM})
      check_with_errors(name, sampling);
  return 0;
}
