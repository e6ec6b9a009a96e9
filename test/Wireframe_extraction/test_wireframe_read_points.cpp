// Clouds are read into whatever holds points, and out of streams.

#include "scratch_files.h"

#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>

#include <cassert>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <list>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::pair<Point, double> Sample;
typedef std::vector<Sample> Cloud;

namespace parameters = CGAL::Wireframe_extraction::parameters;

const Cloud expected = {{Point(1, 2, 3), 0.5}, {Point(4, 5, 6), 0.25}, {Point(7, 8, 9), 0.}};
const char* const text = "1 2 3 0.5\n4 5 6 0.25\n7 8 9 0\n";
const char* const bad_text = "1 2 3 0.5\n4 5 6 -1\n";

void test_output_iterators()
{
  const Test_file good("_good.xyz", text), bad("_bad.xyz", bad_text);
  std::list<Sample> list;
  assert(CGAL::IO::read_distance_cloud(good.name, std::back_inserter(list)));
  assert(Cloud(list.begin(), list.end()) == expected);
  Cloud cloud(3);
  assert(CGAL::IO::read_distance_cloud<Sample>(good.name, cloud.begin()) && cloud == expected);
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(bad.name, std::back_inserter(list), parameters::error_message(&error)));
  assert(list.size() == 3 && !error.empty());
  std::size_t skipped = 0;
  assert(CGAL::IO::read_distance_cloud(bad.name, std::back_inserter(list),
                                       parameters::skip_invalid(true).number_of_skipped(&skipped)));
  assert(list.size() == 4 && list.back() == expected[0] && skipped == 1);
}

void test_point_sets()
{
  const Test_file good("_good.xyz", text), bad("_bad.xyz", bad_text);
  CGAL::Point_set_3<Point> points;
  points.insert(Point(9, 9, 9));
  assert(!CGAL::IO::read_distance_cloud(bad.name, points) && points.size() == 1);
  assert(CGAL::IO::read_distance_cloud(good.name, points) && points.size() == 3);
  assert(points.has_property_map<double>("distance"));
  auto distances = points.add_property_map<double>("distance", -1.).first; // the one that is there
  std::size_t i = 0;
  for (const auto& index : points)
  {
    assert(points.point(index) == expected[i].first && get(distances, index) == expected[i].second);
    ++i;
  }
}

void test_streams()
{
  for (const std::string& format : std::vector<std::string>{"xyz", ".TXT", "csv"})
  {
    std::istringstream stream(text);
    Cloud cloud;
    assert(CGAL::IO::read_distance_cloud(stream, format, cloud) && cloud == expected);
  }
  std::istringstream ply("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                         "property float z\nproperty float distance\nend_header\n"
                         + std::string(text));
  Cloud cloud;
  assert(CGAL::IO::read_distance_cloud(ply, "ply", cloud) && cloud == expected);
  std::string error;
  for (const std::string& format : std::vector<std::string>{"h5", "jpg", ""})
  {
    std::istringstream stream(text);
    assert(!CGAL::IO::read_distance_cloud(stream, format, cloud, parameters::error_message(&error)));
    assert(error.find("unknown format") != std::string::npos && cloud == expected);
  }
  for (const std::string& content : std::vector<std::string>{"", bad_text})
  {
    std::istringstream stream(content);
    assert(!CGAL::IO::read_distance_cloud(stream, "xyz", cloud, parameters::error_message(&error)));
    assert(error.find("the stream") == 0 && cloud == expected);
  }
  std::ifstream missing("there/is/no/such.file");
  assert(!CGAL::IO::read_distance_cloud(missing, "xyz", cloud, parameters::error_message(&error)));
  assert(error == "the stream: cannot be read");
}

int main()
{
  test_output_iterators();
  test_point_sets();
  test_streams();
  return 0;
}
