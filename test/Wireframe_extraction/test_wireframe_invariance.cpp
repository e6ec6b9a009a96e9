// The wireframe moves and scales with its cloud, and depends neither on the order of the points nor on the number of
// threads.

#include <CGAL/extract_wireframe.h>

#include <CGAL/Simple_cartesian.h>

#include <Sample_solids/Sample_solids.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

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
typedef std::vector<std::pair<Point, double> > Cloud;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef Sample_solids::Random Random;

namespace WP = CGAL::Wireframe_extraction::parameters;

const double r = 0.03;
const double tolerance = 1e-6 * r;

Cloud cloud_of(const std::string& name, Sample_solids::Field_kind field, Sample_solids::Sampling sampling,
               std::uint64_t seed)
{
  Sample_solids::Sampling_options options;
  options.sampling_distance = r;
  options.sampling = sampling;
  options.field = field;
  options.seed = seed;
  const Sample_solids::Cloud samples = Sample_solids::sample(Sample_solids::make_solid(name), options);
  Cloud cloud;
  for (std::size_t i = 0; i < samples.points.size(); ++i)
    cloud.emplace_back(Point(samples.points[i][0], samples.points[i][1], samples.points[i][2]),
                       samples.distances[i]);
  return cloud;
}

// A rotation, a scale, and a translation, in this order.
class Similarity
{
  double m_rows[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  double m_scale = 1., m_shift[3] = {0, 0, 0};

public:
  static Similarity translation(double x, double y, double z)
  {
    Similarity result;
    result.m_shift[0] = x;
    result.m_shift[1] = y;
    result.m_shift[2] = z;
    return result;
  }

  static Similarity scaling(double factor)
  {
    Similarity result;
    result.m_scale = factor;
    return result;
  }

  // by a unit quaternion
  static Similarity rotation(double w, double x, double y, double z)
  {
    const double n = std::sqrt(w * w + x * x + y * y + z * z);
    w /= n; x /= n; y /= n; z /= n;
    Similarity result;
    const double rows[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
                               {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
                               {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
    std::copy(&rows[0][0], &rows[0][0] + 9, &result.m_rows[0][0]);
    return result;
  }

  static Similarity random(Random& random)
  {
    Similarity result = rotation(random.normal(), random.normal(), random.normal(), random.normal());
    for (double& x : result.m_shift)
      x = random.uniform(-3, 3);
    return result;
  }

  double scale() const { return m_scale; }

  Point operator()(const Point& p) const
  {
    double q[3];
    for (int i = 0; i < 3; ++i)
      q[i] = m_scale * (m_rows[i][0] * p.x() + m_rows[i][1] * p.y() + m_rows[i][2] * p.z()) + m_shift[i];
    return Point(q[0], q[1], q[2]);
  }

  Point undo(const Point& p) const
  {
    double d[3], q[3];
    for (int i = 0; i < 3; ++i)
      d[i] = (p[i] - m_shift[i]) / m_scale;
    for (int i = 0; i < 3; ++i)
      q[i] = m_rows[0][i] * d[0] + m_rows[1][i] * d[1] + m_rows[2][i] * d[2];
    return Point(q[0], q[1], q[2]);
  }

  Cloud operator()(Cloud cloud) const
  {
    for (auto& sample : cloud) {
      sample.first = (*this)(sample.first);
      sample.second *= m_scale;
    }
    return cloud;
  }
};

// the largest distance of control points, in either direction of the second curve
double deviation(const Wireframe::Curve& a, const Wireframe::Curve& b, const Similarity& motion)
{
  const std::vector<Point>& p = a.spline.control_points();
  const std::vector<Point>& q = b.spline.control_points();
  const double infinity = std::numeric_limits<double>::infinity();
  if (p.size() != q.size() || a.is_closed() != b.is_closed() || a.support != b.support)
    return infinity;
  double best = infinity;
  for (bool is_reversed : {false, true}) {
    double worst = 0.;
    for (std::size_t i = 0; i < p.size(); ++i)
      worst = (std::max)(worst, CGAL::squared_distance(p[i], motion.undo(q[is_reversed ? q.size() - 1 - i : i])));
    best = (std::min)(best, std::sqrt(worst));
  }
  return best;
}

void check_equal(const Wireframe& a, const Wireframe& b, const Similarity& motion)
{
  assert(std::abs(b.sampling_distance / (motion.scale() * a.sampling_distance) - 1.) < 1e-9);
  assert(a.curves.size() == b.curves.size());
  assert(a.vertices.size() == b.vertices.size());
  std::vector<char> is_taken(b.curves.size(), 0);
  for (const Wireframe::Curve& curve : a.curves) {
    std::size_t partner = b.curves.size();
    for (std::size_t c = 0; c < b.curves.size() && partner == b.curves.size(); ++c)
      if (!is_taken[c] && deviation(curve, b.curves[c], motion) < tolerance)
        partner = c;
    assert(partner < b.curves.size());
    is_taken[partner] = 1;
    const Wireframe::Curve& other = b.curves[partner];
    assert(std::abs(curve.root_mean_square - other.root_mean_square / motion.scale()) < tolerance);
    assert(std::abs(curve.maximum_deviation - other.maximum_deviation / motion.scale()) < tolerance);
  }
  for (const Point& p : a.vertices)
    assert(std::count_if(b.vertices.begin(), b.vertices.end(), [&](const Point& q) {
      return CGAL::squared_distance(p, motion.undo(q)) < tolerance * tolerance;
    }) == 1);
}

bool are_same_bits(const Wireframe& a, const Wireframe& b)
{
  if (a.vertices != b.vertices || a.curves.size() != b.curves.size())
    return false;
  for (std::size_t c = 0; c < a.curves.size(); ++c)
    if (a.curves[c].spline.control_points() != b.curves[c].spline.control_points()
        || a.curves[c].spline.knots() != b.curves[c].spline.knots()
        || a.curves[c].root_mean_square != b.curves[c].root_mean_square)
      return false;
  return true;
}

void test_motions(const Cloud& cloud, const Wireframe& expected, std::uint64_t seed)
{
  Random random(seed, 1);
  std::vector<Similarity> motions;
  motions.push_back(Similarity::translation(1.3, -2.7, 0.41));
  motions.push_back(Similarity::rotation(1, 1, 1, 1));    // the axes change places
  motions.push_back(Similarity::random(random));
  motions.push_back(Similarity::random(random));
  motions.push_back(Similarity::scaling(1e-3));
  motions.push_back(Similarity::scaling(1e4));
  for (const Similarity& motion : motions)
    check_equal(expected, CGAL::extract_wireframe(motion(cloud)), motion);
  // powers of two do not even round
  const Similarity half = Similarity::scaling(0.5);
  const Wireframe halved = CGAL::extract_wireframe(half(cloud));
  assert(halved.curves.size() == expected.curves.size());
  for (std::size_t c = 0; c < halved.curves.size(); ++c)
    for (std::size_t i = 0; i < halved.curves[c].spline.control_points().size(); ++i)
      assert(half.undo(halved.curves[c].spline.control_points()[i]) == expected.curves[c].spline.control_points()[i]);
}

void test_orders(const Cloud& cloud, const Wireframe& expected, std::uint64_t seed)
{
  Random random(seed, 2);
  Cloud other(cloud.rbegin(), cloud.rend());
  for (int round = 0; round < 2; ++round) {
    check_equal(expected, CGAL::extract_wireframe(other), Similarity());
    for (std::size_t i = other.size(); i > 1; --i)
      std::swap(other[i - 1], other[random.index(i)]);
  }
}

void test_threads(const Cloud& cloud, const Wireframe& expected)
{
#ifdef CGAL_LINKED_WITH_TBB
  for (std::size_t threads : {1, 2, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    assert(are_same_bits(expected, CGAL::extract_wireframe(cloud)));
  }
#endif
  assert(are_same_bits(expected, CGAL::extract_wireframe(cloud)));   // and a second time
}

void test(const std::string& name, Sample_solids::Field_kind field, Sample_solids::Sampling sampling,
          std::uint64_t seed)
{
  const Cloud cloud = cloud_of(name, field, sampling, seed);
  const Wireframe expected = CGAL::extract_wireframe(cloud);
  assert(!expected.is_empty());
  assert(!are_same_bits(expected, Wireframe()));
  test_motions(cloud, expected, seed);
  test_orders(cloud, expected, seed);
  test_threads(cloud, expected);
}

} // namespace

int main()
{
  using Sample_solids::Field_kind;
  using Sample_solids::Sampling;
  test("cylinder", Field_kind::EXACT, Sampling::POISSON, 1);
  test("box_with_hole", Field_kind::EXACT, Sampling::UNIFORM, 2);
  test("slotted_plate", Field_kind::EXACT, Sampling::POISSON, 3);
  test("cylinder", Field_kind::DEF, Sampling::UNIFORM, 1);
  test("box", Field_kind::DEF, Sampling::POISSON, 2);
}
