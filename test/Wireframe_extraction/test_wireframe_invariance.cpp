// The wireframe moves and scales with the cloud, and depends neither on the order of the points nor on the threads.

#include "sample_clouds.h"

#include <CGAL/extract_wireframe.h>

#include <CGAL/Simple_cartesian.h>

#include <Sample_solids/Sample_solids.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe<Kernel> Wireframe;

const double r = 0.02;

Cloud cloud_of(const std::string& name, Sample_solids::Sampling sampling, Sample_solids::Field_kind field,
               std::uint64_t seed)
{
  Sample_solids::Sampling_options options;
  options.sampling_distance = r;
  options.sampling = sampling;
  options.field = field;
  options.seed = seed;
  return cloud_of_samples<Point>(Sample_solids::sample(Sample_solids::make_solid(name), options));
}

// p -> scale * rotation * p + translation
struct Similarity
{
  std::array<std::array<double, 3>, 3> rotation = {{{{1., 0., 0.}}, {{0., 1., 0.}}, {{0., 0., 1.}}}};
  double scale = 1.;
  std::array<double, 3> translation = {{0., 0., 0.}};

  // by a unit quaternion made of four numbers
  static Similarity of_quaternion(double w, double x, double y, double z)
  {
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    w /= n;
    x /= n;
    y /= n;
    z /= n;
    Similarity result;
    result.rotation = {{{{1. - 2. * (y * y + z * z), 2. * (x * y - z * w), 2. * (x * z + y * w)}},
                        {{2. * (x * y + z * w), 1. - 2. * (x * x + z * z), 2. * (y * z - x * w)}},
                        {{2. * (x * z - y * w), 2. * (y * z + x * w), 1. - 2. * (x * x + y * y)}}}};
    return result;
  }

  Point operator()(const Point& p) const
  {
    std::array<double, 3> q;
    for (int k = 0; k < 3; ++k)
      q[k] = scale * (rotation[k][0] * p.x() + rotation[k][1] * p.y() + rotation[k][2] * p.z()) + translation[k];
    return Point(q[0], q[1], q[2]);
  }
};

Cloud transformed(Cloud cloud, const Similarity& similarity)
{
  for (auto& sample : cloud)
  {
    sample.first = similarity(sample.first);
    sample.second *= similarity.scale;
  }
  return cloud;
}

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

// the largest distance of control points, of the first curve moved along; infinite if they do not correspond
double deviation(const Wireframe::Curve& a, const Wireframe::Curve& b, const Similarity& similarity)
{
  const std::vector<Point>& p = a.spline.control_points();
  const std::vector<Point>& q = b.spline.control_points();
  double best = (std::numeric_limits<double>::infinity)();
  if (p.size() != q.size() || a.is_closed() != b.is_closed())
    return best;
  for (bool is_reversed : {false, true})
  {
    double largest = 0.;
    for (std::size_t i = 0; i < p.size(); ++i)
      largest = (std::max)(largest, distance(similarity(p[i]), q[is_reversed ? q.size() - 1 - i : i]));
    best = (std::min)(best, largest);
  }
  return best;
}

void check_same(const Wireframe& a, const Wireframe& b, const Similarity& similarity, double tolerance)
{
  assert(!a.is_empty());
  assert(a.curves.size() == b.curves.size() && a.vertices.size() == b.vertices.size());
  assert(std::abs(b.sampling_distance - similarity.scale * a.sampling_distance) < 1e-9 * b.sampling_distance);
  for (const Wireframe::Curve& curve : a.curves)
  {
    double best = (std::numeric_limits<double>::infinity)();
    for (const Wireframe::Curve& other : b.curves)
      best = (std::min)(best, deviation(curve, other, similarity));
    assert(best < tolerance * r * similarity.scale);
  }
}

bool are_identical(const Wireframe& a, const Wireframe& b)
{
  if (a.vertices != b.vertices || a.curves.size() != b.curves.size())
    return false;
  for (std::size_t c = 0; c < a.curves.size(); ++c)
    if (a.curves[c].spline.control_points() != b.curves[c].spline.control_points()
        || a.curves[c].spline.knots() != b.curves[c].spline.knots() || a.curves[c].rms != b.curves[c].rms)
      return false;
  return true;
}

// the share of samples of one wireframe that lie farther than r from the other one
double share_astray(const Wireframe& a, const Wireframe& b)
{
  std::size_t count = 0, astray = 0;
  for (const Wireframe::Curve& curve : a.curves)
  {
    std::vector<Point> samples;
    curve.spline.sample_by_distance(r, std::back_inserter(samples));
    for (const Point& p : samples)
    {
      double nearest = (std::numeric_limits<double>::infinity)();
      for (const Wireframe::Curve& other : b.curves)
        nearest = (std::min)(nearest, other.spline.closest_point(p).distance);
      ++count;
      astray += nearest > r;
    }
  }
  return double(astray) / double(count);
}

void test_exact_fields()
{
  using namespace Sample_solids;
  std::mt19937_64 engine(3);
  std::normal_distribution<double> normal;
  for (const char* name : {"box_with_hole", "wedge", "u_channel"})
    for (Sampling sampling : {Sampling::POISSON, Sampling::UNIFORM})
    {
      const Cloud cloud = cloud_of(name, sampling, Field_kind::EXACT, 11);
      const Wireframe wireframe = CGAL::extract_wireframe(cloud);
      check_same(wireframe, CGAL::extract_wireframe(shuffled(cloud, 7)), Similarity(), 1e-3);
      for (double scale : {1e-3, 1., 1e4})
      {
        Similarity similarity =
          Similarity::of_quaternion(normal(engine), normal(engine), normal(engine), normal(engine));
        similarity.scale = scale;
        similarity.translation = {{3. * scale, -5. * scale, 2. * scale}};
        check_same(wireframe, CGAL::extract_wireframe(transformed(cloud, similarity)), similarity, 1e-3);
      }
    }
}

// With noise, a decision at its threshold may tip over by rounding, but only here and there; without any rounding, by
// powers of two, nothing may change.
void test_noisy_fields()
{
  using namespace Sample_solids;
  for (const char* name : {"box_with_hole", "slotted_plate"})
  {
    const Cloud cloud = cloud_of(name, Sampling::POISSON, Field_kind::DEF, 5);
    const Wireframe wireframe = CGAL::extract_wireframe(cloud);
    Similarity doubled;
    doubled.scale = 1024.;
    check_same(wireframe, CGAL::extract_wireframe(transformed(cloud, doubled)), doubled, 1e-9);
    const Wireframe other = CGAL::extract_wireframe(shuffled(cloud, 7));
    assert(share_astray(wireframe, other) < 0.05 && share_astray(other, wireframe) < 0.05);
  }
}

void test_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  using namespace Sample_solids;
  for (Field_kind field : {Field_kind::EXACT, Field_kind::DEF})
  {
    const Cloud cloud = cloud_of("box_with_hole", Sampling::UNIFORM, field, 2);
    Wireframe results[2];
    for (int k = 0; k < 2; ++k)
    {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, k + 1);
      results[k] = CGAL::extract_wireframe(cloud);
    }
    assert(!results[0].is_empty() && are_identical(results[0], results[1]));
  }
#endif
  const Cloud cloud = cloud_of("box", Sample_solids::Sampling::POISSON, Sample_solids::Field_kind::DEF, 1);
  assert(are_identical(CGAL::extract_wireframe(cloud), CGAL::extract_wireframe(cloud)));
}

} // namespace

int main()
{
  test_exact_fields();
  test_noisy_fields();
  test_threads();
  return 0;
}
