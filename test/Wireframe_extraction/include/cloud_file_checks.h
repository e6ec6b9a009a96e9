// Checks of what is read from files of clouds, and of what is refused.

#ifndef CLOUD_FILE_CHECKS_H
#define CLOUD_FILE_CHECKS_H

#include "check_words.h"
#include "scratch_files.h"

#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Simple_cartesian.h>

#include <cassert>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;

struct Names
{
  std::string points, distances, property;
  std::vector<std::string> coordinates = {};
};

inline auto name_parameters(const Names& names, std::string& error)
{
  return parameters::points_dataset(names.points)
    .distances_dataset(names.distances)
    .distance_property(names.property)
    .coordinate_properties(names.coordinates)
    .error_message(&error);
}

inline Cloud read(const std::string& name, const Names& names = Names())
{
  Cloud cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(name, cloud, name_parameters(names, error)))
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty() && !cloud.empty());
  return cloud;
}

inline Cloud read_pair(const std::string& name, const std::string& distances, const Names& names = Names())
{
  Cloud cloud;
  std::string error;
  if (!CGAL::IO::read_distance_cloud(name, distances, cloud, name_parameters(names, error)))
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty());
  return cloud;
}

inline void refuse(const Test_file& file, const Words& words, const Names& names = Names())
{
  const Cloud before = {{Point(1, 2, 3), 4}};
  Cloud cloud = before;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, cloud, name_parameters(names, error)));
  assert(cloud == before);
  check_words(error, words);
  assert(error.compare(0, file.name.size(), file.name) == 0);
}

inline void refuse(const std::string& suffix, const std::string& content, const Words& words,
                   const Names& names = Names())
{
  refuse(Test_file(suffix, content), words, names);
}

inline void refuse_pair(const std::string& name, const std::string& distances, const Words& words)
{
  Cloud cloud;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(name, distances, cloud, parameters::error_message(&error)));
  assert(cloud.empty());
  check_words(error, words);
}

// numbers that float holds exactly
inline Cloud sample_cloud(std::size_t count)
{
  Cloud cloud;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i);
    cloud.emplace_back(Point(t, 0.5 * t - 3., 100. - 0.25 * t), 0.125 * static_cast<double>(i % 17));
  }
  return cloud;
}

inline std::vector<double> points_of(const Cloud& cloud)
{
  std::vector<double> values;
  for (const auto& sample : cloud)
    values.insert(values.end(), {sample.first.x(), sample.first.y(), sample.first.z()});
  return values;
}

inline std::vector<double> distances_of(const Cloud& cloud)
{
  std::vector<double> values;
  for (const auto& sample : cloud)
    values.push_back(sample.second);
  return values;
}

inline std::vector<double> rows_of_four(const Cloud& cloud)
{
  std::vector<double> values;
  for (const auto& sample : cloud)
    values.insert(values.end(), {sample.first.x(), sample.first.y(), sample.first.z(), sample.second});
  return values;
}

#endif // CLOUD_FILE_CHECKS_H
