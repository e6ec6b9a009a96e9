// Wireframes as polylines, in OBJ, PLY and text.

#include <CGAL/Wireframe_extraction/IO/write_wireframe_polylines.h>

#include "Comma_locale.h"
#include "scratch_files.h"
#include "theta_wireframe.h"

#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

namespace parameters = CGAL::Wireframe_extraction::parameters;

struct Read_polylines
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polylines;
  std::vector<std::string> names;
};

Read_polylines parse_obj(std::istream& stream)
{
  Read_polylines result;
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v")
    {
      double x, y, z;
      const bool is_point = static_cast<bool>(words >> x >> y >> z);
      assert(is_point);
      result.points.emplace_back(x, y, z);
    }
    else if (kind == "g")
      result.names.push_back(line.substr(2));
    else if (kind == "l")
    {
      result.polylines.emplace_back();
      for (std::size_t index; words >> index;)
        result.polylines.back().push_back(index - 1);
    }
    else
      assert(kind == "#");
  }
  return result;
}

void check_spacing(const Read_polylines& polylines, const CGAL::Wireframe<Kernel>& wireframe, double step)
{
  assert(polylines.polylines.size() == wireframe.curves.size());
  for (std::size_t i = 0; i < polylines.polylines.size(); ++i)
  {
    const std::vector<std::size_t>& polyline = polylines.polylines[i];
    const double length = wireframe.curves[i].spline.length();
    assert(polyline.size() == std::size_t(std::ceil(length / step - 1e-9)) + 1);
    for (std::size_t j = 0; j + 1 < polyline.size(); ++j)
    {
      const Point& p = polylines.points.at(polyline[j]);
      const Point& q = polylines.points.at(polyline[j + 1]);
      assert(std::sqrt(CGAL::squared_distance(p, q)) <= step * (1 + 1e-9));
      assert(CGAL::to_double(wireframe.curves[i].spline.closest_point(q).distance) < 1e-9);
    }
    if (wireframe.curves[i].is_closed())
      assert(polyline.front() == polyline.back() && polyline.size() > 3);
    if (wireframe.curves[i].source < wireframe.vertices.size())
      assert(polyline.front() == wireframe.curves[i].source && polyline.back() == wireframe.curves[i].target);
  }
}

void test_obj()
{
  const CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_obj(stream, wireframe));
  const Read_polylines result = parse_obj(stream);
  check_spacing(result, wireframe, 0.1);
  const std::vector<std::string> names = {"curve_0_line", "curve_1_bspline", "curve_2_arc", "curve_3_bspline",
                                          "curve_4_circle"};
  assert(result.names == names);
  assert(result.points[0] == wireframe.vertices[0] && result.points[1] == wireframe.vertices[1]);
  std::vector<Point> sorted = result.points;
  std::sort(sorted.begin(), sorted.end());
  assert(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());

  std::stringstream coarse;
  assert(CGAL::IO::write_wireframe_obj(coarse, wireframe, parameters::sampling_step(100)));
  const Read_polylines least = parse_obj(coarse);
  assert(least.polylines[0].size() == 2 && least.polylines[4].size() == 4);
  assert(least.polylines[4].front() == least.polylines[4].back());

  const Test_file file(".OBJ");
  assert(CGAL::IO::write_wireframe(file.name, wireframe, parameters::sampling_step(0.3)));
  std::istringstream content(file.content());
  check_spacing(parse_obj(content), wireframe, 0.3);
}

// without a sampling distance the longest curve decides
void test_default_step()
{
  CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  wireframe.sampling_distance = 0;
  double longest = 0;
  for (const auto& curve : wireframe.curves)
    longest = (std::max)(longest, curve.spline.length());
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_obj(stream, wireframe));
  check_spacing(parse_obj(stream), wireframe, longest / 100);
}

double load_double(const std::string& bytes, std::size_t& position)
{
  std::uint64_t bits = 0;
  for (int i = 0; i < 8; ++i)
    bits |= std::uint64_t(static_cast<unsigned char>(bytes.at(position++))) << (8 * i);
  double value;
  std::memcpy(&value, &bits, 8);
  return value;
}

std::uint32_t load_int(const std::string& bytes, std::size_t& position)
{
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i)
    value |= std::uint32_t(static_cast<unsigned char>(bytes.at(position++))) << (8 * i);
  return value;
}

void test_ply_edges()
{
  const CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  std::stringstream obj_stream, ascii;
  assert(CGAL::IO::write_wireframe_obj(obj_stream, wireframe, parameters::sampling_step(0.3)));
  const Read_polylines expected = parse_obj(obj_stream);
  std::size_t number_of_edges = 0;
  for (const auto& polyline : expected.polylines)
    number_of_edges += polyline.size() - 1;

  const Test_file file(".ply");
  assert(CGAL::IO::write_wireframe(file.name, wireframe, parameters::sampling_step(0.3)));
  assert(CGAL::IO::write_wireframe_ply(ascii, wireframe, parameters::sampling_step(0.3).use_binary_mode(false)));
  const std::string binary = file.content();
  const std::string header = "1.0\ncomment wireframe\nelement vertex " + std::to_string(expected.points.size())
    + "\nproperty double x\nproperty double y\nproperty double z\nelement edge " + std::to_string(number_of_edges)
    + "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\nend_header\n";
  const std::string binary_start = "ply\nformat binary_little_endian " + header;
  const std::string ascii_start = "ply\nformat ascii " + header;
  assert(binary.compare(0, binary_start.size(), binary_start) == 0);
  assert(ascii.str().compare(0, ascii_start.size(), ascii_start) == 0);
  assert(binary.size() == binary_start.size() + 24 * expected.points.size() + 12 * number_of_edges);
  std::istringstream numbers(ascii.str().substr(ascii_start.size()));
  std::size_t position = binary_start.size();
  for (const Point& point : expected.points)
    for (int i = 0; i < 3; ++i)
    {
      double value = 0;
      numbers >> value;
      assert(value == point[i] && load_double(binary, position) == value);
    }
  for (std::size_t i = 0; i < expected.polylines.size(); ++i)
    for (std::size_t j = 0; j + 1 < expected.polylines[i].size(); ++j)
      for (const std::size_t index : {expected.polylines[i][j], expected.polylines[i][j + 1], i})
      {
        std::size_t value = 0;
        numbers >> value;
        assert(value == index && load_int(binary, position) == value);
      }
  assert(numbers && position == binary.size());
}

void test_polylines()
{
  const CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  std::stringstream obj_stream, stream;
  assert(CGAL::IO::write_wireframe_obj(obj_stream, wireframe));
  const Read_polylines expected = parse_obj(obj_stream);
  assert(CGAL::IO::write_wireframe_polylines(stream, wireframe));
  for (const auto& polyline : expected.polylines)
  {
    std::string line;
    std::getline(stream, line);
    std::istringstream words(line);
    std::size_t size = 0;
    words >> size;
    assert(size == polyline.size());
    for (const std::size_t index : polyline)
    {
      double x, y, z;
      words >> x >> y >> z;
      assert(words && Point(x, y, z) == expected.points[index]);
    }
    assert((words >> std::ws).eof());
  }
  for (const char* const suffix : {".polylines.txt", ".cgal"})
  {
    const Test_file file(suffix);
    assert(CGAL::IO::write_wireframe(file.name, wireframe));
    assert(file.content() == stream.str());
  }
}

// once more where decimals are written with a comma
void test_other_locale()
{
  const auto write_obj = [](std::ostream& stream) {
    return CGAL::IO::write_wireframe_obj(stream, theta_wireframe(), parameters::sampling_step(0.001));
  };
  std::ostringstream before, after, ply;
  assert(write_obj(before));
  assert(before.str().find("v 0.001 ") != std::string::npos);
  {
    const Comma_locale locale;
    assert(write_obj(after));
    assert(
      CGAL::IO::write_wireframe_ply(ply, theta_wireframe(), parameters::sampling_step(0.001).use_binary_mode(false)));
  }
  assert(after.str() == before.str());
  assert(ply.str().find("\n0.001 ") != std::string::npos);
}

int main()
{
  test_obj();
  test_default_step();
  test_ply_edges();
  test_polylines();
  test_other_locale();
  return 0;
}
