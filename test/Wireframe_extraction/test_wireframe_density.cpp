// What the parts promise that measure the density of clouds which are not in memory, against sorting and trying all.

#include <CGAL/Wireframe_extraction/internal/cloud/Density_candidates.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Distance_histogram.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Neighbor_scan.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Position_sample.h>
#include <CGAL/Wireframe_extraction/internal/cloud/sampling_distance.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace {

using namespace CGAL::Wireframe_extraction::internal;

bool is_about(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance * std::abs(b); }

// random points of a square, with what `field` makes of their distances to one of its sides
Cloud_values square(std::size_t size, const std::function<double(double)>& field)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(0., 1.);
  Cloud_values values;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double x = number(random), y = number(random);
    values.add(Vector(x, y, 0.), field(x), i);
  }
  return values;
}

Cloud_values shuffled(const Cloud_values& values)
{
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(2));
  Cloud_values result;
  for (std::size_t k = 0; k < order.size(); ++k)
    result.add(values.positions[order[k]], values.distances[order[k]], k);
  return result;
}

// Distance_histogram ----------------------------------------------------------------------------------

void test_bins_of_the_histogram()
{
  typedef Distance_histogram Histogram;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-30., 30.);
  const double smallest = (std::numeric_limits<double>::denorm_min)(), largest = (std::numeric_limits<double>::max)();
  assert(Histogram::bin(0.) == 0 && Histogram::bin(-0.) == 0);
  assert(Histogram::bin(smallest) == 0 && Histogram::bin(largest) < Histogram::number_of_bins);
  std::vector<double> distances{0., largest};
  for (int k = 0; k < 10000; ++k)
    distances.push_back(std::exp2(exponent(random)));
  std::sort(distances.begin(), distances.end());
  for (std::size_t k = 1; k < distances.size(); ++k)
    assert(Histogram::bin(distances[k - 1]) <= Histogram::bin(distances[k]));
  // bins are narrow, and no narrower than they have to be
  for (double x : distances)
    if (x > 0. && x < largest)
    {
      assert(Histogram::bin(x * (1. + 1e-5)) > Histogram::bin(x));
      assert(Histogram::bin(x * (1. + 1e-5)) - Histogram::bin(x) <= 3);
    }
}

void test_counts_of_the_histogram()
{
  typedef Distance_histogram Histogram;
  const Cloud_values values = square(20000, [](double x) { return x < 0.1 ? 0. : x * x * x; });
  Histogram histogram;
  std::map<Histogram::Bin, std::uint64_t> expected;
  for (double distance : values.distances)
  {
    histogram.add(distance);
    ++expected[Histogram::bin(distance)];
  }
  std::uint64_t sum = 0;
  auto next = expected.begin();
  histogram.for_each_bin([&](Histogram::Bin bin, std::uint64_t smaller, std::uint64_t number) {
    assert(next != expected.end() && bin == next->first && number == next->second && smaller == sum);
    sum += number;
    ++next;
  });
  assert(next == expected.end() && sum == values.size());
}

// Position_sample -------------------------------------------------------------------------------------

void test_position_sample()
{
  const Cloud_values values = square(5000, [](double x) { return x; });
  Position_sample all(5000), some(1000), of_shuffled(1000), of_twice(1000);
  values.for_each([&](const Vector& p, double d, std::size_t i) {
    all.add(p, d, i);
    some.add(p, d, i);
    of_twice.add(p, d, 2 * i);
    of_twice.add(p, d, 2 * i + 1);
  });
  shuffled(values).for_each([&](const Vector& p, double d, std::size_t i) { of_shuffled.add(p, d, i); });
  assert(all.is_complete() && all.values().size() == 5000);
  const auto positions = [](Position_sample& sample) {
    assert(!sample.is_complete());
    sample.thin_out();
    assert(sample.values().size() == 500);
    std::set<std::pair<double, double>> result;
    for (const Vector& p : sample.values().positions)
      result.emplace(p.x(), p.y());
    assert(result.size() == 500);
    return result;
  };
  const auto expected = positions(some);
  assert(positions(of_shuffled) == expected && positions(of_twice) == expected);
  for (std::size_t i = 0; i < some.values().size(); ++i)
    assert(values.positions[some.values().index(i)] == some.values().positions[i]);
  // evenly: about half of them in each half of the square
  const auto left = std::count_if(expected.begin(), expected.end(), [](const auto& p) { return p.first < 0.5; });
  assert(left > 200 && left < 300);
}

// Density_candidates ----------------------------------------------------------------------------------

Density_candidates candidates_of(const Cloud_values& values, const std::vector<std::size_t>& ranks)
{
  Distance_histogram histogram;
  for (double distance : values.distances)
    histogram.add(distance);
  Density_candidates candidates(ranks);
  histogram.for_each_bin([&](Distance_histogram::Bin bin, std::uint64_t smaller, std::uint64_t number) {
    candidates.add_bin(bin, smaller, number);
  });
  values.for_each([&](const Vector& p, double distance, std::size_t i) { candidates.add(p, distance, i); });
  return candidates;
}

std::multiset<std::tuple<double, double, double>> set_of(const Cloud_values& values)
{
  std::multiset<std::tuple<double, double, double>> result;
  values.for_each([&](const Vector& p, double distance, std::size_t) { result.emplace(p.x(), p.y(), distance); });
  return result;
}

// In a field whose distances differ, those that are chosen have the wanted ranks.
void test_candidates_of_a_fine_field()
{
  const Cloud_values values = square(20000, [](double x) { return x; });
  const std::vector<std::size_t> ranks = spread_indices(values.size());
  const Density_candidates candidates = candidates_of(values, ranks);
  const Cloud_values chosen = candidates.chosen(64);
  std::vector<double> sorted = values.distances;
  std::sort(sorted.begin(), sorted.end());
  assert(chosen.size() == ranks.size());
  for (std::size_t k = 0; k < ranks.size(); ++k)
  {
    assert(chosen.distances[k] == sorted[ranks[k]]);
    assert(values.positions[chosen.index(k)] == chosen.positions[k]);
  }
  assert(set_of(candidates_of(shuffled(values), ranks).chosen(64)) == set_of(chosen));
}

// Of distances that several points have, none is chosen, as long as others are there.
void test_ambiguous_candidates()
{
  const Cloud_values values = square(20000, [](double x) {
    return x < 0.3 ? 0. : x < 0.5 ? x : std::round(1000. * x) / 1000.;
  });
  const std::vector<std::size_t> ranks = spread_indices(values.size());
  const Cloud_values chosen = candidates_of(values, ranks).chosen(64);
  assert(is_about(double(chosen.size()), 0.2 * double(ranks.size()), 0.1));
  for (double distance : chosen.distances)
    assert(distance >= 0.3 && distance < 0.501);
  const Cloud_values all = candidates_of(values, ranks).chosen(ranks.size());
  assert(all.size() == ranks.size());
  // evenly spread over the ranks and, among equal distances, over the cloud
  assert(is_about(double(std::count(all.distances.begin(), all.distances.end(), 0.)), 0.3 * double(ranks.size()), 0.1));
  double sum = 0.;
  std::set<std::pair<double, double>> different;
  all.for_each([&](const Vector& p, double, std::size_t) {
    sum += p.y() / double(all.size());
    different.emplace(p.x(), p.y());
  });
  assert(is_about(sum, 0.5, 0.05) && different.size() > 0.9 * double(all.size()));
}

// However many points a coarse field has, few are kept; which ones does not depend on their order.
void test_candidates_of_coarse_fields()
{
  for (double levels : {1., 10., 1000.})
    for (std::size_t size : {50000u, 400000u})
    {
      const Cloud_values values = square(size, [levels](double x) { return std::round(levels * x) / levels; });
      const std::vector<std::size_t> ranks = spread_indices(values.size());
      const Density_candidates candidates = candidates_of(values, ranks);
      assert(candidates.size() >= (std::min)(ranks.size(), size / 2) && candidates.size() <= 4 * most_density_samples);
      const Cloud_values chosen = candidates.chosen(64);
      assert(chosen.size() == ranks.size());
      assert(set_of(candidates_of(shuffled(values), ranks).chosen(64)) == set_of(chosen));
    }
  // so many different distances in a bin that some have to be left out
  const Cloud_values values = square(50000, [](double x) { return 1. + 1e-4 * x; });
  const std::vector<std::size_t> ranks = {100, 20000, 20001, 49000};
  const Density_candidates candidates = candidates_of(values, ranks);
  assert(candidates.size() <= 256 * ranks.size());
  const Cloud_values chosen = candidates.chosen(1);
  assert(set_of(candidates_of(shuffled(values), ranks).chosen(1)) == set_of(chosen));
  std::vector<double> sorted = values.distances;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < ranks.size(); ++k)
    assert(std::abs(chosen.distances[k] - sorted[ranks[k]]) < 1e-5);
}

// a position that occurs several times counts once
void test_candidates_that_occur_twice()
{
  const Cloud_values values = square(5000, [](double x) { return x; });
  Cloud_values twice = values;
  values.for_each([&](const Vector& p, double d, std::size_t i) { twice.add(p, d, values.size() + i); });
  const Cloud_values chosen = candidates_of(twice, spread_indices(twice.size())).chosen(1);
  assert(chosen.size() == most_density_samples);
  std::set<double> different(chosen.distances.begin(), chosen.distances.end());
  assert(different.size() > 0.8 * double(values.size()) * (1. - std::exp(-1.)));
}

// Of the points of one bin, the one with a distance of its own that is nearest to a place, on either side; a position
// that occurs again changes nothing; and there is no negative zero.
void test_similar_points()
{
  Similar_points points;
  points.ranks = {2};
  points.number_of_points = 3;
  points.add(Vector(1., 0., 0.), 0.5, 0);
  points.add(Vector(1., 0., 0.), 0.5, 7);
  assert(points.size() == 1 && points[0].index == 0 && points.nearest_clear_one(0) == 0);
  points.add(Vector(2., 0., 0.), 0.75, 1);
  points.add(Vector(3., 0., 0.), 0.75, 2);
  assert(points.size() == 3);
  for (std::size_t place = 0; place < 3; ++place)
    assert(points.nearest_clear_one(place) == 0);
  points.add(Vector(4., 0., 0.), 0.875, 3);
  assert(points.nearest_clear_one(1) == 0 && points.nearest_clear_one(2) == 3);

  Cloud_values zeros;
  for (int i = 0; i < 8; ++i)
    zeros.add(Vector(i, 0., 0.), i % 2 == 0 ? 0. : -0., std::size_t(i));
  const Cloud_values chosen = candidates_of(zeros, {0, 1, 2, 3, 4, 5, 6, 7}).chosen(1);
  assert(chosen.size() == 8);
  for (double distance : chosen.distances)
    assert(!std::signbit(distance));
}

// What was left out of a bin with many distances does not come back with another point: that would seem to be clear.
void test_distances_that_were_left_out()
{
  std::vector<std::pair<Vector, double>> samples;
  for (int i = 0; i < 600; ++i)
    for (int j = 0; j < 2; ++j)
      samples.emplace_back(Vector(i, j, 0.), 1. + 1e-9 * i);
  std::set<double> kept;
  for (int order = 0; order < 4; ++order)
  {
    Similar_points points;
    points.ranks = {5};
    points.number_of_points = samples.size();
    for (std::size_t i = 0; i < samples.size(); ++i)
      points.add(samples[i].first, samples[i].second, i);
    assert(points.size() > 250 && points.size() <= 256);
    assert(points.nearest_clear_one(points.size() / 2) == points.size());
    std::set<double> distances;
    for (std::size_t i = 0; i < points.size(); ++i)
      distances.insert(points[i].distance);
    assert(order == 0 || distances == kept);
    kept = distances;
    std::shuffle(samples.begin(), samples.end(), std::mt19937(unsigned(order)));
  }
}

// Neighbor_scan ---------------------------------------------------------------------------------------

// It finds what a search in a tree of all points finds, whatever it starts with and in whatever order points come.
void test_neighbor_scan()
{
  const Cloud_values values = square(20000, [](double x) { return x; });
  Cloud_values queries;
  for (std::size_t i = 0; i < values.size(); i += 17)
    queries.add(values.positions[i], values.distances[i], i);
  const Cloud_scale expected = cloud_scale(values.positions, values.distances, queries);
  assert(expected.sampling_distance > 0. && is_about(expected.slope, 1., 0.05));
  for (std::size_t start : {32u, 1000u, 20000u})
    for (const Cloud_values& order : {values, shuffled(values)})
      for (bool is_at_once : {false, true})
      {
        Neighbor_scan scan;
        for (std::size_t i = 0; i < queries.size(); ++i)
          scan.add_query(queries.positions[i], queries.distances[i]);
        scan.start({order.positions.begin(), order.positions.begin() + start},
                   {order.distances.begin(), order.distances.begin() + start});
        if (is_at_once)
          scan.add(order.positions, order.distances);
        else
          order.for_each([&](const Vector& p, double distance, std::size_t) { scan.add(p, distance); });
        const Cloud_scale found = scan.scale();
        assert(is_about(found.sampling_distance, expected.sampling_distance, 1e-12));
        assert(is_about(found.slope, expected.slope, 1e-12));
      }
}

// duplicates are no neighbors, and a cloud of a few positions has few of them
void test_neighbors_of_duplicates()
{
  Cloud_values values;
  for (std::size_t i = 0; i < 900; ++i)
    values.add(Vector(double(i % 3), 0., 0.), 2. * double(i % 3), i);
  Neighbor_scan scan;
  scan.add_query(values.positions[1], values.distances[1]);
  scan.start({values.positions.begin(), values.positions.begin() + 3},
             {values.distances.begin(), values.distances.begin() + 3});
  scan.add(values.positions, values.distances);
  Density_measures measures;
  measures.add(1., 1., 2, 2.);
  assert(is_about(scan.scale().sampling_distance, measures.scale().sampling_distance, 1e-12));
  assert(is_about(scan.scale().slope, 2., 1e-12));
  assert(Neighbor_scan().scale().sampling_distance == 0.);
}

} // namespace

int main()
{
  test_bins_of_the_histogram();
  test_counts_of_the_histogram();
  test_position_sample();
  test_candidates_of_a_fine_field();
  test_ambiguous_candidates();
  test_candidates_of_coarse_fields();
  test_candidates_that_occur_twice();
  test_similar_points();
  test_distances_that_were_left_out();
  test_neighbor_scan();
  test_neighbors_of_duplicates();
  return 0;
}
