// Clouds that stay in their files, or that come point by point, give the same skeleton as in memory.

#include <CGAL/Wireframe_extraction/Distance_cloud_filter.h>

#include "sample_clouds.h"

#include <CGAL/Wireframe_extraction/IO/Distance_cloud_file.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#include <Sample_solids/Sample_solids.h>

#include <sys/resource.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

namespace wireframe = CGAL::Wireframe_extraction;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe_skeleton<Kernel> Skeleton;

Sample_solids::Cloud samples_of(const std::string& name, Sample_solids::Sampling sampling,
                                Sample_solids::Field_kind field)
{
  Sample_solids::Sampling_options options;
  options.sampling_distance = 0.02;
  options.sampling = sampling;
  options.field = field;
  options.truncation = 20.;
  return Sample_solids::sample(Sample_solids::make_solid(name), options);
}

// in single precision many distances are equal
Cloud cloud_of(const Sample_solids::Cloud& samples, bool is_single)
{
  Cloud cloud = cloud_of_samples<Point>(samples);
  for (auto& sample : cloud)
    if (is_single)
    {
      const Point& p = sample.first;
      sample = {Point(float(p.x()), float(p.y()), float(p.z())), float(sample.second)};
    }
  return cloud;
}

// as a scanner writes it
Cloud sorted(Cloud cloud)
{
  std::sort(cloud.begin(), cloud.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return cloud;
}

bool is_about(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

std::set<std::tuple<double, double, double, double>> values_of(const Skeleton& skeleton)
{
  std::set<std::tuple<double, double, double, double>> result;
  for (std::size_t i = 0; i < skeleton.size(); ++i)
  {
    // up to the rounding of another origin, which depends on the order
    const auto key = [](double x) { return std::round(1e9 * x); };
    const Point p = skeleton.point(i);
    result.emplace(key(p.x()), key(p.y()), key(p.z()), key(skeleton.distance(i)));
  }
  return result;
}

void check_same(const Skeleton& a, const Skeleton& b)
{
  assert(is_about(a.sampling_distance(), b.sampling_distance(), 1e-12));
  assert(a.size() == b.size() && a.support_size() == b.support_size());
  assert(a.number_of_duplicates() == b.number_of_duplicates());
}

void check_identical(const Skeleton& a, const Skeleton& b)
{
  check_same(a, b);
  for (std::size_t i = 0; i < a.support_size(); ++i)
    assert(a.index(i) == b.index(i));
}

Skeleton skeleton_of(const Cloud& cloud, std::size_t points_in_memory)
{
  return wireframe::select_skeleton(cloud, wireframe::parameters::points_in_memory(points_in_memory));
}

void test_clouds_that_are_gone_over_several_times()
{
  using namespace Sample_solids;
  for (const char* name : {"box_with_hole", "cylinder"})
    for (Sampling sampling : {Sampling::POISSON, Sampling::UNIFORM})
      for (Field_kind field : {Field_kind::EXACT, Field_kind::DEF})
      {
        const Sample_solids::Cloud samples = samples_of(name, sampling, field);
        for (bool is_single : {false, true})
        {
          const Cloud cloud = cloud_of(samples, is_single);
          const Skeleton expected = skeleton_of(cloud, cloud.size());
          assert(expected.size() > 100 && cloud.size() > 5000);
          check_identical(expected, skeleton_of(cloud, cloud.size() - 1));
          check_identical(expected, skeleton_of(cloud, 3000));
          check_identical(expected, skeleton_of(cloud, 1));
          for (const Cloud& other : {sorted(cloud), shuffled(cloud, 5)})
          {
            const Skeleton skeleton = skeleton_of(other, 2000);
            check_same(expected, skeleton);
            assert(expected.data().surroundings->size() == skeleton.data().surroundings->size());
            assert(values_of(expected) == values_of(skeleton));
          }
        }
      }
}

void test_duplicates()
{
  using namespace Sample_solids;
  const Cloud cloud = cloud_of(samples_of("box", Sampling::POISSON, Field_kind::EXACT), false);
  Cloud twice = cloud;
  twice.insert(twice.end(), cloud.begin(), cloud.end());
  const Skeleton expected = skeleton_of(twice, twice.size());
  assert(expected.number_of_duplicates() > 0);
  check_identical(expected, skeleton_of(twice, 1500));
  assert(is_about(expected.sampling_distance(), skeleton_of(cloud, 1500).sampling_distance(), 0.01));
  // nothing but a few positions, many times
  Cloud few;
  for (int i = 0; i < 5000; ++i)
    few.emplace_back(Point(i % 7, (i * i) % 7, 0.1 * (i % 7)), 0.01 * (i % 7));
  check_identical(skeleton_of(few, 10000), skeleton_of(few, 200));
}

// coarse fields, and those that are known hardly anywhere
void test_equal_distances()
{
  using namespace Sample_solids;
  Cloud cloud = cloud_of(samples_of("box", Sampling::UNIFORM, Field_kind::EXACT), false);
  Cloud coarse = cloud, unknown = cloud;
  for (auto& value : coarse)
    value.second = 0.005 * std::round(value.second / 0.005);
  check_identical(skeleton_of(coarse, coarse.size()), skeleton_of(coarse, 1000));
  assert(is_about(skeleton_of(coarse, 1000).sampling_distance(), skeleton_of(cloud, 1000).sampling_distance(), 0.03));
  for (std::size_t i = 0; i < unknown.size(); ++i)
    unknown[i].second = i % 1000 == 0 ? 0.001 : 1.;
  const double r = skeleton_of(unknown, unknown.size()).sampling_distance();
  assert(is_about(skeleton_of(unknown, 9000).sampling_distance(), r, 1e-12));
  assert(is_about(skeleton_of(unknown, 1000).sampling_distance(), r, 0.1)); // from fewer points
}

// the largest amount of memory that was in use so far
double peak_in_megabytes()
{
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024.; // kilobytes with Linux
}

double in_half_precision(double x)
{
  int exponent;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::round(std::ldexp(mantissa, 11)), exponent - 11);
}

// Random points of a square, with their distances to its boundary. They are nowhere in memory.
class Square_source : public wireframe::Distance_cloud_source
{
  std::size_t m_size;
  bool m_is_coarse;

public:
  Square_source(std::size_t size, bool is_coarse) : m_size(size), m_is_coarse(is_coarse) {}

  bool read(const Sink& sink) override
  {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(0., 1.);
    std::vector<Sample> chunk;
    for (std::size_t k = 0; k < m_size; k += chunk.size())
    {
      chunk.clear();
      for (std::size_t i = k; i < m_size && i < k + 4096; ++i)
      {
        const double x = number(random), y = number(random);
        const double distance = (std::min)((std::min)(x, 1. - x), (std::min)(y, 1. - y));
        chunk.push_back({x, y, 0., m_is_coarse ? in_half_precision(distance) : distance});
      }
      if (!sink(chunk.data(), chunk.data() + chunk.size()))
        return true;
    }
    return true;
  }
};

// The memory that is taken does not grow with the cloud, also if many points have the same distance.
void test_memory_for_coarse_fields()
{
  const double before = peak_in_megabytes();
  double r[2];
  for (bool is_coarse : {false, true})
  {
    Square_source source(2000000, is_coarse);
    wireframe::internal::Surveyed_cloud cloud(source, 20000);
    const bool is_read = cloud.survey();
    assert(is_read && !cloud.is_in_memory());
    r[is_coarse] = cloud.scale().sampling_distance;
  }
  assert(is_about(r[1], r[0], 0.03));
  assert(peak_in_megabytes() - before < 60.);
}

void test_filter()
{
  using namespace Sample_solids;
  for (const char* name : {"box_with_hole", "flange"})
    for (Sampling sampling : {Sampling::POISSON, Sampling::UNIFORM})
    {
      const Cloud cloud = cloud_of(samples_of(name, sampling, Field_kind::EXACT), false);
      const double r = skeleton_of(cloud, cloud.size()).sampling_distance();
      for (const Cloud& other : {cloud, sorted(cloud), shuffled(cloud, 5)})
      {
        wireframe::Distance_cloud_filter<Point> filter(wireframe::parameters::points_in_memory(4000));
        filter.insert(other.begin(), other.end());
        assert(filter.number_of_points() == cloud.size() && filter.number_of_invalid() == 0);
        assert(is_about(filter.sampling_distance(), r, 0.02));
        assert(filter.is_complete());
        const double most = filter.width() * filter.sampling_distance();
        const auto is_near = [most](const auto& value) { return value.second < most; };
        assert(std::size_t(std::count_if(cloud.begin(), cloud.end(), is_near)) == filter.cloud().size());
        assert(std::all_of(filter.cloud().begin(), filter.cloud().end(), is_near));
        assert(filter.cloud().size() < cloud.size());
      }
    }
  wireframe::Distance_cloud_filter<Point> filter;
  assert(filter.cloud().empty() && filter.sampling_distance() == 0.);
  filter.insert(Point(0, 0, 0), -1.);
  filter.insert(Point(0, 0, 0), std::nan(""));
  filter.insert(Point((std::numeric_limits<double>::infinity)(), 0, 0), 1.);
  assert(filter.number_of_points() == 3 && filter.number_of_invalid() == 3 && filter.cloud().empty());
  filter.insert(Point(0, 0, 0), 1.);
  assert(filter.cloud().size() == 1 && filter.sampling_distance() == 0.);
}

template <class Source>
Skeleton skeleton_of_source(Source& source, std::size_t points_in_memory)
{
  wireframe::internal::Surveyed_cloud cloud(source, points_in_memory);
  const bool is_read = cloud.survey();
  assert(is_read);
  const Skeleton skeleton(wireframe::internal::find_skeleton(cloud, cloud.scale().sampling_distance,
                                                             wireframe::internal::Extraction_options()),
                          Kernel());
  assert(cloud.error().empty());
  return skeleton;
}

void test_files()
{
  using namespace Sample_solids;
  const Sample_solids::Cloud samples = samples_of("flange", Sampling::POISSON, Field_kind::EXACT);
  const Skeleton expected = skeleton_of(cloud_of(samples, true), 1000000);
  {
    std::ofstream ply("flange.ply", std::ios::binary), text("flange.xyz"), distances("flange_distances.txt");
    write_ply(ply, samples);
    text.precision(17);
    distances.precision(17);
    for (const auto& value : cloud_of(samples, true))
    {
      text << value.first << ' ' << value.second << '\n';
      distances << value.second << '\n';
    }
  }
  CGAL::IO::Distance_cloud_file ply("flange.ply"), text("flange.xyz"), both("flange.xyz", "flange_distances.txt");
  for (CGAL::IO::Distance_cloud_file* file : {&ply, &text, &both})
    for (std::size_t points_in_memory : {1000u, 1000000u})
    {
      check_identical(expected, skeleton_of_source(*file, points_in_memory));
      assert(file->error_message().empty() && file->number_of_skipped() == 0);
    }
  CGAL::IO::Distance_cloud_file missing("no_such_file.ply");
  assert(!missing.read([](const auto*, const auto*) { return true; }));
  assert(missing.error_message().find("no_such_file.ply") == 0);
  std::size_t count = 0;
  const bool is_read = ply.read([&count](const auto* first, const auto* beyond) {
    count += std::size_t(beyond - first);
    return false;
  });
  assert(is_read && count > 0 && count < samples.points.size());

  // a file that changes between two readings
  wireframe::internal::Surveyed_cloud cloud(text, 1000);
  assert(cloud.survey());
  std::ofstream("flange.xyz", std::ios::app) << "0 0 0 1\n";
  cloud.for_each([](const auto&, double, std::size_t) {});
  assert(cloud.error().find("unchanged") != std::string::npos);
  std::ofstream("flange.xyz", std::ios::app) << "0 0 0\n";
  wireframe::internal::Surveyed_cloud damaged(text, 1000);
  assert(!damaged.survey());
  assert(damaged.error().find("flange.xyz:" + std::to_string(samples.points.size() + 2)) == 0);
}

} // namespace

int main()
{
  test_memory_for_coarse_fields(); // first, before others have taken as much
  test_clouds_that_are_gone_over_several_times();
  test_duplicates();
  test_equal_distances();
  test_filter();
  test_files();
  return 0;
}
