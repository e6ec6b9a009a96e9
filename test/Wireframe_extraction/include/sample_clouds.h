// Clouds of the sample solids, as the library takes them.

#ifndef SAMPLE_CLOUDS_H
#define SAMPLE_CLOUDS_H

#include <Sample_solids/Sample_solids.h>

#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

template <class Point>
std::vector<std::pair<Point, double>> cloud_of_samples(const Sample_solids::Cloud& samples)
{
  std::vector<std::pair<Point, double>> cloud;
  for (std::size_t i = 0; i < samples.points.size(); ++i)
  {
    const Sample_solids::Point& p = samples.points[i];
    cloud.emplace_back(Point(p[0], p[1], p[2]), samples.distances[i]);
  }
  return cloud;
}

template <class Cloud>
Cloud shuffled(Cloud cloud, std::uint64_t seed)
{
  std::mt19937_64 engine(seed);
  for (std::size_t i = cloud.size(); i > 1; --i)
    std::swap(cloud[i - 1], cloud[engine() % i]);
  return cloud;
}

#endif // SAMPLE_CLOUDS_H
