// Which points of the cloud are shown, and in which colours.

#ifndef EXTRACT_WIREFRAME_SHOWN_CLOUD_H
#define EXTRACT_WIREFRAME_SHOWN_CLOUD_H

#include "Kernel.h"
#include "open_input.h"

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace tool {

typedef std::vector<std::pair<Kernel::Point_3, double>> Cloud;

// more points than this make pages and pictures large, and none of them is missed
constexpr std::size_t most_shown_points = 1000000;

// Reads as many points as are shown: of more, evenly many from everywhere. Returns whether the cloud could be read. If
// the distances were estimated, they are those of `field`.
inline bool sample(Input_cloud& cloud, const CGAL::Wireframe_extraction::Distance_field& field, Cloud& result)
{
  std::size_t seen = 0;
  boost::random::mt19937_64 random(1);
  return cloud.read([&](const Input_cloud::Sample* first, const Input_cloud::Sample* beyond) {
    for (; first != beyond; ++first, ++seen)
    {
      const double distance = field.is_empty() ? first->distance : field.distances.at(seen);
      const Cloud::value_type value({first->x, first->y, first->z}, distance);
      if (result.size() < most_shown_points)
        result.push_back(value);
      else
      {
        const std::size_t place = boost::random::uniform_int_distribution<std::size_t>(0, seen)(random);
        if (place < most_shown_points)
          result[place] = value;
      }
    }
    return true;
  });
}

inline CGAL::IO::internal::Coordinates coordinates_of(const Kernel::Point_3& point)
{
  return {{point.x(), point.y(), point.z()}};
}

// from a feature to far away from it: the cloud is pale where nothing is
inline const std::array<CGAL::IO::internal::Colour, 5>& field_colours()
{
  static const std::array<CGAL::IO::internal::Colour, 5> colours = {
    {{53, 19, 107}, {47, 95, 174}, {79, 176, 179}, {181, 223, 174}, {241, 239, 207}}};
  return colours;
}

// what was read but is left out by --skip-invalid is not shown
inline bool is_valid(const Cloud::value_type& sample)
{
  return CGAL::IO::internal::is_finite_point(coordinates_of(sample.first)) && std::isfinite(sample.second)
    && sample.second >= 0.;
}

inline std::vector<std::size_t> indices_of_valid(const Cloud& cloud)
{
  std::vector<std::size_t> indices;
  indices.reserve(cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (is_valid(cloud[i]))
      indices.push_back(i);
  return indices;
}

// A random order, in which the first ones are an even thinning of all. It is the same in each run.
inline void shuffle(std::vector<std::size_t>& indices)
{
  std::mt19937_64 random;
  for (std::size_t i = 0; i < indices.size(); ++i)
    std::swap(indices[i], indices[i + static_cast<std::size_t>(random() % (indices.size() - i))]);
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_SHOWN_CLOUD_H
