#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/IO/read_wireframe_json.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;

// a file of the current directory that is gone at the end of the test
struct Test_file
{
  std::string name;

  explicit Test_file(const std::string& suffix) : name("io_test_scratch" + suffix) {}
  Test_file(const std::string& suffix, const std::string& content) : Test_file(suffix) { write(content); }
  ~Test_file() { std::remove(name.c_str()); }

  void write(const std::string& content) const
  {
    std::ofstream(name, std::ios::binary) << content;
  }

  std::string read() const
  {
    std::ifstream stream(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
};

// ---- clouds ----

Cloud expected_cloud()
{
  return { { Point(1, 2, 3), 0.5 }, { Point(-4, 5.25, 100), 0 }, { Point(7, -8, 9), 1 } };
}

Cloud integer_cloud()
{
  return { { Point(1, 2, 3), 4 }, { Point(-4, 5, 100), 0 }, { Point(7, -8, 9), 1 } };
}

void check_reads(const std::string& suffix, const std::string& content,
                 const Cloud& expected = expected_cloud(),
                 const std::string& distance_property = "")
{
  const Test_file file(suffix, content);
  Cloud cloud = { { Point(9, 9, 9), 9 } };
  std::string error = "not cleared";
  std::size_t number_of_skipped = 99;
  const bool is_read = CGAL::IO::read_distance_cloud(file.name, cloud,
    parameters::error_message(&error).distance_property(distance_property)
                                     .number_of_skipped(&number_of_skipped));
  if(!is_read)
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(is_read && error.empty() && number_of_skipped == 0);
  assert(cloud == expected);
}

template <class Number>
void append(Number number, bool is_big_endian, std::string& bytes)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  const std::uint16_t one = 1;
  char first;
  std::memcpy(&first, &one, 1);
  if((first == 0) != is_big_endian)
    std::reverse(raw, raw + sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

std::string ply_start(const std::string& format)
{
  return "ply\nformat " + format + " 1.0\ncomment written by a test\nobj_info element vertex 77\n";
}

const std::string plain_vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                                   "property float distance\n";

template <class Number>
std::string binary_ply(bool is_big_endian, const std::string& type, const Cloud& cloud)
{
  std::string text = ply_start(is_big_endian ? "binary_big_endian" : "binary_little_endian")
                     + "element vertex " + std::to_string(cloud.size()) + "\nproperty " + type
                     + " x\nproperty " + type + " y\nproperty " + type + " z\nproperty " + type
                     + " distance\nend_header\n";
  for(const auto& sample : cloud)
    for(const double value : { sample.first.x(), sample.first.y(), sample.first.z(), sample.second })
      append(static_cast<Number>(value), is_big_endian, text);
  return text;
}

void test_ply_ascii()
{
  const std::string body = "1 2 3 0.5\n-4 5.25 1e2 0\n+7 -8.0 9 1\n";
  const std::string header = ply_start("ascii") + plain_vertices + "end_header\n";
  check_reads(".ply", header + body);
  check_reads(".PLY", header + "\n" + body + "\n\n");
  check_reads(".ply", header + "1 2 3 0.5\n-4 5.25 1e2 0\n+7 -8.0 9 1");
  std::string windows;
  std::string old_mac;
  for(const char c : header + body)
  {
    windows += (c == '\n') ? "\r\n" : std::string(1, c);
    old_mac += (c == '\n') ? '\r' : c;
  }
  check_reads(".ply", windows);
  check_reads(".ply", old_mac);

  // any order, other properties, lists before the vertices and among their properties, faces after them
  check_reads(".ply", ply_start("ascii")
    + "element face 2\nproperty list uchar int vertex_indices\nproperty uchar red\nelement empty 0\n"
      "property int nothing\nelement void 5\n"
      "element vertex 3\nproperty uchar red\nproperty list uchar int neighbors\nproperty double sharpness\n"
      "property double z\nproperty float nx\nproperty double x\nproperty double y\n"
      "element edge 1\nproperty int vertex1\nend_header\n"
      "3 0 1 2 9\n4 0 1 2 3 9\n"
      "255 2 1 2 0.5 3 0 1 2\n0 0 0 100 0 -4 5.25\n0 1 5 1 9 0 7 -8\n0\n");
}

void test_ply_binary()
{
  for(const bool is_big_endian : { false, true })
  {
    check_reads(".ply", binary_ply<float>(is_big_endian, "float", expected_cloud()));
    check_reads(".ply", binary_ply<float>(is_big_endian, "float32", expected_cloud()));
    check_reads(".ply", binary_ply<double>(is_big_endian, "double", expected_cloud()));
    check_reads(".ply", binary_ply<double>(is_big_endian, "float64", expected_cloud()));
    check_reads(".ply", binary_ply<std::int8_t>(is_big_endian, "char", integer_cloud()), integer_cloud());
    check_reads(".ply", binary_ply<std::int16_t>(is_big_endian, "short", integer_cloud()), integer_cloud());
    check_reads(".ply", binary_ply<std::int32_t>(is_big_endian, "int32", integer_cloud()), integer_cloud());
    check_reads(".ply", binary_ply<std::int64_t>(is_big_endian, "int64", integer_cloud()), integer_cloud());
    const Cloud natural = { { Point(200, 2, 3), 4 } };
    check_reads(".ply", binary_ply<std::uint8_t>(is_big_endian, "uchar", natural), natural);
    check_reads(".ply", binary_ply<std::uint16_t>(is_big_endian, "uint16", natural), natural);
    check_reads(".ply", binary_ply<std::uint32_t>(is_big_endian, "uint", natural), natural);
  }
}

void test_ply_binary_mixture()
{
  for(const bool is_big_endian : { false, true })
  {
    std::string text = ply_start(is_big_endian ? "binary_big_endian" : "binary_little_endian")
      + "element camera 2\nproperty double focus\nproperty uchar id\n"
        "element face 2\nproperty list uchar int vertex_indices\nproperty list ushort double texture\n"
        "element vertex 3\nproperty uchar red\nproperty double z\nproperty short y\nproperty float quality\n"
        "property float x\nelement face2 1\nproperty list uchar int vertex_indices\nend_header\r\n";
    for(int i = 0; i < 2; ++i)
    {
      append(10. + i, is_big_endian, text);
      append(std::uint8_t(10), is_big_endian, text);
    }
    for(int face = 0; face < 2; ++face)
    {
      append(std::uint8_t(3 + face), is_big_endian, text);
      for(int i = 0; i < 3 + face; ++i)
        append(std::int32_t(i), is_big_endian, text);
      append(std::uint16_t(300 * face), is_big_endian, text);
      for(int i = 0; i < 300 * face; ++i)
        append(0.5, is_big_endian, text);
    }
    Cloud expected = expected_cloud();
    expected[1].first = Point(-4, 5, 100);
    for(const auto& sample : expected)
    {
      append(std::uint8_t(10), is_big_endian, text);
      append(sample.first.z(), is_big_endian, text);
      append(std::int16_t(sample.first.y()), is_big_endian, text);
      append(float(sample.second), is_big_endian, text);
      append(float(sample.first.x()), is_big_endian, text);
    }
    append(std::uint8_t(0), is_big_endian, text);
    check_reads(".ply", text, expected);
  }
}

void test_ply_vertices_with_lists()
{
  for(const bool is_big_endian : { false, true })
  {
    std::string text = ply_start(is_big_endian ? "binary_big_endian" : "binary_little_endian")
      + "element vertex 3\nproperty float x\nproperty list uint float neighbors\nproperty float y\n"
        "property float z\nproperty float distance\nend_header\n";
    std::uint32_t size = 0;
    for(const auto& sample : expected_cloud())
    {
      append(float(sample.first.x()), is_big_endian, text);
      append(size, is_big_endian, text);
      for(std::uint32_t i = 0; i < size; ++i)
        append(1.5f, is_big_endian, text);
      append(float(sample.first.y()), is_big_endian, text);
      append(float(sample.first.z()), is_big_endian, text);
      append(float(sample.second), is_big_endian, text);
      size += 700000;
    }
    check_reads(".ply", text);
  }
}

// more than a chunk of the reader, so that entries lie across its borders
void test_many_points()
{
  Cloud cloud;
  std::mt19937 random(1);
  for(int i = 0; i < 100001; ++i)
    cloud.emplace_back(Point(random() % 1000, random() % 1000, random() % 1000), random() % 8);
  check_reads(".ply", binary_ply<double>(false, "double", cloud), cloud);
  check_reads(".ply", binary_ply<float>(true, "float", cloud), cloud);
  std::ostringstream text;
  text.precision(17);
  for(const auto& sample : cloud)
    text << sample.first << " " << sample.second << "\r\n";
  check_reads(".xyz", text.str(), cloud);
  check_reads(".ply", "ply\nformat ascii 1.0\nelement vertex 100001\nproperty int x\nproperty int y\n"
                      "property int z\nproperty int distance\nend_header\n" + text.str(), cloud);
}

void test_choice_of_property()
{
  const auto ply = [](const std::string& first, const std::string& second)
  {
    return ply_start("ascii") + "element vertex 1\nproperty float " + first
           + "\nproperty float x\nproperty float y\n"
           "property float z\nproperty float " + second + "\nend_header\n10 1 2 3 20\n";
  };
  const Cloud first = { { Point(1, 2, 3), 10 } }, second = { { Point(1, 2, 3), 20 } };
  check_reads(".ply", ply("quality", "distance"), second);
  check_reads(".ply", ply("scalar_Distance", "quality"), first);
  check_reads(".ply", ply("sharpness", "distances"), second);
  check_reads(".ply", ply("distance", "own"), second, "own");
  check_reads(".ply", ply("Own", "own"), second, "own");
  check_reads(".ply", ply("Own", "other"), first, "own");
  check_reads(".csv", "own,x,y,z,distance\n10,1,2,3,20\n", second);
  check_reads(".csv", "own,x,y,z,distance\n10,1,2,3,20\n", first, "own");

  // a C string will do
  const Test_file file(".ply", ply("distance", "own"));
  Cloud cloud;
  assert(CGAL::IO::read_distance_cloud(file.name, cloud, parameters::distance_property("own")));
  assert(cloud == second);
}

void test_text()
{
  check_reads(".xyz", "1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  check_reads(".asc", "1 2 3 0.5\r\n-4 5.25 1e2 0\r\n7 -8 9 1");
  check_reads(".txt", "1 2 3 0.5\r-4 5.25 1e2 0\r7 -8 9 1\r");
  check_reads(".txt", "  1\t2   3 0.5  \n\n\t-4 5.25 1.0E+2 0\n \n+7 -8. 9 1\n\n");
  check_reads(".csv", "1,2,3,0.5\n-4, 5.25 ,1e2, 0\n7,-8,9,1,\n");
  check_reads(".csv", "1;2;3;.5\n-4;5.25;100;0\n7;-8;9;1\n");
  check_reads(".txt", "# made by hand\n1 2 3 0.5 # first\n// second\n-4 5.25 1e2 0\n  # third\n7 -8 9 1\n");
  check_reads(".txt", "\xEF\xBB\xBF" "1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  check_reads(".pts", "3\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  // further columns, which need not be numbers
  check_reads(".txt", "1 2 3 0.5 a 1\n-4 5.25 1e2 0 b 2\n7 -8 9 1 c 3\n");
  check_reads(".txt", "1 2 3 0.5 1\n-4 5.25 1e2 0 2\n7 -8 9 1 3\n");
  // of three numbers and more it has to be said which is the distance
  check_reads(".txt", "1 2 3 0.5 0 1\n-4 5.25 1e2 0 0 1\n7 -8 9 1 0 1\n", expected_cloud(), "4");
  check_reads(".txt", "1 2 3 0 0 1 0.5\n-4 5.25 1e2 0 0 1 0\n7 -8 9 0 0 1 1\n", expected_cloud(), "7");
}

void test_text_with_names()
{
  check_reads(".csv", "x,y,z,distance\n1,2,3,0.5\n-4,5.25,1e2,0\n7,-8,9,1\n");
  check_reads(".csv", "\"x\";\"y\";\"z\";\"d\"\n1;2;3;0.5\n-4;5.25;1e2;0\n7;-8;9;1\n");
  check_reads(".csv", "d,z,y,x\n0.5,3,2,1\n0,1e2,5.25,-4\n1,9,-8,7\n");
  check_reads(".csv", "Label,Distance,Z,Y,X\na,0.5,3,2,1\nb,0,1e2,5.25,-4\nc,1,9,-8,7\n");
  check_reads(".csv", "east,north,up,far\n1,2,3,0.5\n-4,5.25,1e2,0\n7,-8,9,1\n");
  check_reads(".txt", "# x y z nx distance\n1,2,3,0,0.5\n-4,5.25,1e2,0,0\n7,-8,9,0,1\n");
  check_reads(".txt", "//X Y Z Quality\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  // a comment that only looks like a line of names
  check_reads(".txt", "# columns: x y z\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  check_reads(".txt", "# z is up, x y d\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
}

void test_separate_distances()
{
  const Test_file distances("_distances.dat", "# field\ndistance\n0.5\n\n0 # on the edge\n// last\n1\n");
  const auto check = [&distances](const std::string& suffix, const std::string& content)
  {
    const Test_file file(suffix, content);
    Cloud cloud;
    std::string error;
    assert(CGAL::IO::read_distance_cloud(file.name, distances.name, cloud,
                                         parameters::error_message(&error)));
    assert(error.empty() && cloud == expected_cloud());
  };
  check(".xyz", "1 2 3\n-4 5.25 1e2\n7 -8 9\n");
  check(".xyz", "1 2 3 77\n-4 5.25 1e2 77\n7 -8 9 77\n");
  check(".csv", "label,x,y,z\na,1,2,3\na,-4,5.25,1e2\na,7,-8,9\n");
  check(".ply", ply_start("ascii") + "element vertex 3\nproperty float x\nproperty float y\n"
                "property float z\nend_header\n1 2 3\n-4 5.25 1e2\n7 -8 9\n");
  check(".ply", binary_ply<double>(true, "double", expected_cloud()));
}

void test_skipping()
{
  const Cloud expected = { { Point(1, 2, 3), 0.5 }, { Point(7, -8, 9), 1 } };
  const auto check = [&expected](const std::string& suffix, const std::string& content, std::size_t number)
  {
    const Test_file file(suffix, content);
    Cloud cloud;
    std::size_t number_of_skipped = 0;
    assert(CGAL::IO::read_distance_cloud(file.name, cloud,
                                         parameters::skip_invalid(true)
                                           .number_of_skipped(&number_of_skipped)));
    assert(cloud == expected && number_of_skipped == number);
  };
  check(".xyz", "1 2 3 0.5\n1 nan 3 0.5\n1 2 3 -0.5\n1 2 3 inf\n1 2 1e999 1\n7 -8 9 1\n", 4);
  check(".ply", ply_start("ascii") + "element vertex 4\nproperty float x\nproperty float y\n"
                "property float z\nproperty float distance\nend_header\n1 2 3 0.5\nnan 0 0 0\n7 -8 9 1\n"
                "0 0 0 -1\n", 2);
  Cloud bad = { expected[0], { Point(0, HUGE_VAL, 0), 1 }, expected[1], { Point(0, 0, 0), std::nan("") } };
  check(".ply", binary_ply<double>(false, "double", bad), 2);
  check(".ply", binary_ply<float>(true, "float", bad), 2);

  // with distances of their own, the two stay in step
  const Test_file file(".xyz", "1 2 3\n0 0 nan\n0 0 0\n7 -8 9\n"),
    distances("_distances.dat", "0.5\n1\n-1\n1\n");
  Cloud cloud;
  assert(CGAL::IO::read_distance_cloud(file.name, distances.name, cloud, parameters::skip_invalid(true)));
  assert(cloud == expected);
}

// other number types, and a coordinate that only some of them can hold
void test_other_types()
{
  typedef CGAL::Simple_cartesian<float> Float_kernel;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
  const Test_file file(".xyz", "1 2 3 0.5\n1e300 0 0 1\n");
  std::vector<std::pair<Float_kernel::Point_3, float>> floats;
  std::vector<std::pair<Epick::Point_3, double>> doubles;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, floats, parameters::error_message(&error)));
  assert(error.find("point 1 ") != std::string::npos && floats.empty());
  assert(CGAL::IO::read_distance_cloud(file.name, floats, parameters::skip_invalid(true)));
  assert(floats.size() == 1 && floats[0].first == Float_kernel::Point_3(1, 2, 3) && floats[0].second == 0.5f);
  assert(CGAL::IO::read_distance_cloud(file.name, doubles));
  assert(doubles.size() == 2 && doubles[1].first == Epick::Point_3(1e300, 0, 0));
}

// ---- wireframes ----

// a model of the concept with nothing that the concept does not ask for
struct Lean_traits
{
  typedef double FT;
  struct Point_3 { std::array<double, 3> values; };
  struct Vector_3 { std::array<double, 3> values; };

  struct Construct_point_3
  {
    Point_3 operator()(FT x, FT y, FT z) const { return { { { x, y, z } } }; }
  };

  struct Construct_vector_3
  {
    Vector_3 operator()(FT x, FT y, FT z) const { return { { { x, y, z } } }; }
  };

  struct Construct_cartesian_const_iterator_3
  {
    const double* operator()(const Point_3& point) const { return point.values.data(); }
    const double* operator()(const Point_3& point, int) const { return point.values.data() + 3; }
    const double* operator()(const Vector_3& vector) const { return vector.values.data(); }
    const double* operator()(const Vector_3& vector, int) const { return vector.values.data() + 3; }
  };

  Construct_point_3 construct_point_3_object() const { return {}; }
  Construct_vector_3 construct_vector_3_object() const { return {}; }
  Construct_cartesian_const_iterator_3 construct_cartesian_const_iterator_3_object() const { return {}; }
};

template <class Traits>
class Random_wireframe
{
public:
  typedef typename Traits::Point_3 Point_3;
  typedef typename Traits::FT FT;
  typedef CGAL::Wireframe<Traits> Wireframe;
  typedef CGAL::Wireframe_curve<Traits> Curve;

  explicit Random_wireframe(unsigned seed) : random_(seed) {}

  Wireframe operator()()
  {
    Wireframe wireframe;
    wireframe.sampling_distance = number(0.01, 1);
    for(std::size_t i = 0; i < 5; ++i)
      wireframe.vertices.push_back(point());
    for(std::size_t i = 0; i < 20; ++i)
      wireframe.curves.push_back(curve(wireframe, i));
    return wireframe;
  }

private:
  FT number(double low, double high)
  {
    return FT(std::uniform_real_distribution<double>(low, high)(random_));
  }

  Point_3 point()
  {
    return Traits().construct_point_3_object()(number(-10, 10), number(-1e-5, 1e-5), number(-1e9, 1e9));
  }

  // a circle or an ellipse, or an arc of one, whose ends become vertices
  Curve conic(Wireframe& wireframe, CGAL::Wireframe_curve_type type)
  {
    typedef CGAL::Wireframe_curve_type Type;
    const double pi = CGAL_PI, tilt = CGAL::to_double(number(-pi, pi));
    Curve result;
    result.type = type;
    const Traits traits;
    result.conic.center = point();
    result.conic.axis = traits.construct_vector_3_object()(FT(std::sin(tilt)), FT(0), FT(std::cos(tilt)));
    result.conic.major_direction = traits.construct_vector_3_object()(FT(std::cos(tilt)), FT(0),
                                                                      FT(-std::sin(tilt)));
    result.conic.major_radius = number(2, 3);
    result.conic.minor_radius = type == Type::CIRCLE || type == Type::ARC ? result.conic.major_radius : number(1, 2);
    const bool is_full = type == Type::CIRCLE || type == Type::ELLIPSE;
    result.conic.start_angle = is_full ? FT(0) : number(0, 3);
    result.conic.end_angle = is_full ? FT(2 * pi) : FT(result.conic.start_angle + number(0.1, 6));
    result.spline = result.conic.to_spline(is_full);
    result.uncertainty.position = number(0, 1);
    result.uncertainty.direction = number(0, 1);
    result.uncertainty.major_radius = number(0, 1);
    result.uncertainty.minor_radius = number(0, 1);
    if(!is_full)
    {
      result.source = wireframe.vertices.size();
      result.target = result.source + 1;
      wireframe.vertices.push_back(result.spline.control_points().front());
      wireframe.vertices.push_back(result.spline.control_points().back());
    }
    return result;
  }

  Curve curve(Wireframe& wireframe, std::size_t i)
  {
    const CGAL::Wireframe_curve_type type = static_cast<CGAL::Wireframe_curve_type>(i % 6);
    if(CGAL::is_conic(type))
      return conic(wireframe, type);
    const bool is_closed = (i % 4 == 1), has_vertex = !is_closed || i % 8 == 1;
    const std::size_t degree = 1 + i % 5, count = degree + 2 + i % 7;
    std::vector<Point_3> points;
    for(std::size_t j = 0; j < count; ++j)
      points.push_back(point());
    Curve result;
    if(has_vertex)
    {
      result.source = i % 5;
      result.target = is_closed ? result.source : (i + 1) % 5;
      points.front() = wireframe.vertices[result.source];
    }
    points.back() = has_vertex ? wireframe.vertices[result.target] : points.front();
    std::vector<FT> knots(degree + 1, FT(-1) / FT(3)), weights;
    for(std::size_t j = degree + 1; j < count; ++j)
      knots.push_back(knots.back() + number(0.1, 1));
    knots.insert(knots.end(), degree + 1, knots.back() + number(0.1, 1));
    for(std::size_t j = 0; j < count && i % 3 == 0; ++j)
      weights.push_back(number(0.5, 2));
    result.type = type;
    result.spline = typename Curve::Spline(degree, knots, points, weights, is_closed);
    result.root_mean_square = number(0, 1);
    result.maximum_deviation = number(0, 1e-300);
    result.support = i * 1000;
    return result;
  }

  std::mt19937 random_;
};

// of points or vectors
template <class Traits, class Position>
std::vector<double> numbers_of(const std::vector<Position>& points)
{
  std::vector<double> numbers;
  const auto begin = Traits().construct_cartesian_const_iterator_3_object();
  for(const auto& point : points)
    for(auto iterator = begin(point); iterator != begin(point, 0); ++iterator)
      numbers.push_back(CGAL::to_double(*iterator));
  return numbers;
}

template <class Traits>
std::vector<double> conic_numbers(const CGAL::Wireframe_curve<Traits>& curve)
{
  const auto& c = curve.conic;
  const auto& u = curve.uncertainty;
  std::vector<double> numbers = numbers_of<Traits>(std::vector<typename Traits::Point_3>{ c.center });
  const std::vector<typename Traits::Vector_3> directions = { c.axis, c.major_direction };
  for(const double number : numbers_of<Traits>(directions))
    numbers.push_back(number);
  for(const auto& number : { c.major_radius, c.minor_radius, c.start_angle, c.end_angle, u.position, u.direction,
                             u.major_radius, u.minor_radius })
    numbers.push_back(CGAL::to_double(number));
  return numbers;
}

template <class Traits>
bool are_equal(const CGAL::Wireframe<Traits>& first, const CGAL::Wireframe<Traits>& second)
{
  bool is_equal = first.sampling_distance == second.sampling_distance
                  && numbers_of<Traits>(first.vertices) == numbers_of<Traits>(second.vertices)
                  && first.curves.size() == second.curves.size();
  for(std::size_t i = 0; i < first.curves.size() && is_equal; ++i)
  {
    const auto& a = first.curves[i];
    const auto& b = second.curves[i];
    is_equal = a.type == b.type && a.source == b.source && a.target == b.target && a.support == b.support
               && a.root_mean_square == b.root_mean_square && a.maximum_deviation == b.maximum_deviation
               && (!CGAL::is_conic(a.type) || conic_numbers(a) == conic_numbers(b))
               && a.is_closed() == b.is_closed() && a.spline.degree() == b.spline.degree()
               && a.spline.knots() == b.spline.knots() && a.spline.weights() == b.spline.weights()
               && numbers_of<Traits>(a.spline.control_points())
                  == numbers_of<Traits>(b.spline.control_points());
  }
  return is_equal;
}

template <class Traits>
void test_json_round_trip(unsigned seed)
{
  const CGAL::Wireframe<Traits> wireframe = Random_wireframe<Traits>(seed)();
  CGAL::Wireframe<Traits> result;
  std::string error = "not cleared";
  std::stringstream stream;
  // whatever state the stream is in
  stream.precision(2);
  stream.setf(std::ios::fixed | std::ios::showpos | std::ios::hex);
  assert(CGAL::IO::write_wireframe_json(stream, wireframe, parameters::error_message(&error)));
  assert(error.empty());
  const std::string text = stream.str();
  assert(CGAL::IO::read_wireframe_json(stream, result, parameters::error_message(&error)));
  assert(error.empty() && are_equal(wireframe, result));

  const Test_file file(".json");
  assert(CGAL::IO::write_wireframe(file.name, wireframe));
  assert(file.read() == text);
  assert(CGAL::IO::read_wireframe_json(file.name, result));
  assert(are_equal(wireframe, result));
}

void test_json_details()
{
  CGAL::Wireframe<Kernel> wireframe, result = Random_wireframe<Kernel>(1)();
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_json(stream, wireframe));
  assert(CGAL::IO::read_wireframe_json(stream, result));
  assert(result.is_empty() && result.vertices.empty() && result.sampling_distance == 0);

  // the sign of zero, the smallest and the largest numbers
  wireframe.vertices = { Point(-0., 5e-324, 1.7976931348623157e308),
                         Point(1e22, 123456789012345678., 1. / 3) };
  std::stringstream extreme;
  assert(CGAL::IO::write_wireframe_json(extreme, wireframe));
  assert(CGAL::IO::read_wireframe_json(extreme, result));
  assert(result.vertices == wireframe.vertices && std::signbit(result.vertices[0].x()));

  // unknown keys, keys that may be missing, a closed curve without vertex
  std::stringstream foreign("{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":0.5,\"by\":[{}],"
    "\"vertices\":[],\"curves\":[{\"type\":\"bspline\",\"closed\":true,\"degree\":1,\"radius\":null,"
    "\"knots\":[0,0,1,2,3,3],\"control_points\":[[0,0,0],[1,0,0],[0,1,0],[0,0,0]],\"source\":null}]}");
  assert(CGAL::IO::read_wireframe_json(foreign, result));
  assert(result.curves.size() == 1 && result.curves[0].is_closed() && result.curves[0].support == 0);
  assert(result.curves[0].source == CGAL::Wireframe_curve<Kernel>::no_vertex);
  std::stringstream again;
  assert(CGAL::IO::write_wireframe_json(again, result));
  assert(again.str().find("\"source\":null,\"target\":null") != std::string::npos);
  assert(again.str().find("weights") == std::string::npos);
}

// three curves that meet in two vertices, a closed one with a vertex, and a circle without
CGAL::Wireframe<Kernel> theta_wireframe()
{
  typedef CGAL::Wireframe_curve<Kernel> Curve;
  typedef Curve::Spline Spline;
  CGAL::Wireframe<Kernel> wireframe;
  wireframe.sampling_distance = 0.4;
  wireframe.vertices = { Point(0, 0, 0), Point(1, 0, 0) };
  const auto add = [&wireframe](CGAL::Wireframe_curve_type type, const Spline& spline, std::size_t source,
                                std::size_t target)
  {
    Curve curve;
    curve.type = type;
    curve.spline = spline;
    curve.source = source;
    curve.target = target;
    wireframe.curves.push_back(curve);
  };
  const Point p = wireframe.vertices[0], q = wireframe.vertices[1];
  add(CGAL::Wireframe_curve_type::LINE, Spline(1, { 0, 0, 1, 1 }, { p, q }), 0, 1);
  add(CGAL::Wireframe_curve_type::BSPLINE, Spline(2, { 0, 0, 0, 1, 1, 1 }, { q, Point(0.5, 1, 0), p }), 1, 0);
  add(CGAL::Wireframe_curve_type::ARC,
      Spline(2, { 0, 0, 0, 1, 1, 1 }, { p, Point(0.5, -0.5, 0), q }, { 1., std::sqrt(0.5), 1. }), 0, 1);
  add(CGAL::Wireframe_curve_type::BSPLINE,
      Spline(3, { 0, 0, 0, 0, 1, 1, 1, 1 }, { p, Point(0, 0, 3), Point(0, 3, 0), p }, true), 0, 0);
  const double w = std::sqrt(0.5);
  const std::size_t none = Curve::no_vertex;
  add(CGAL::Wireframe_curve_type::CIRCLE,
      Spline(2, { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 },
             { Point(6, 0, 0), Point(6, 1, 0), Point(5, 1, 0), Point(4, 1, 0), Point(4, 0, 0),
               Point(4, -1, 0),
               Point(5, -1, 0), Point(6, -1, 0), Point(6, 0, 0) }, { 1., w, 1., w, 1., w, 1., w, 1. }, true),
      none, none);
  typedef Kernel::Vector_3 Vector;
  wireframe.curves[2].conic = { Point(0.5, 0.5, 0), Vector(0, 0, 1), Vector(-w, -w, 0), w, w, 0, 0.5 * CGAL_PI };
  wireframe.curves[4].conic = { Point(5, 0, 0), Vector(0, 0, 1), Vector(1, 0, 0), 1, 1, 0, 2 * CGAL_PI };
  return wireframe;
}

// the parameters of a conic must be sound, and lead to the ends of its spline
void test_bad_conics()
{
  const auto fails = [](const CGAL::Wireframe<Kernel>& wireframe, const std::string& word)
  {
    std::ostringstream stream;
    std::string error;
    const bool is_written =
      CGAL::IO::write_wireframe_json(stream, wireframe, CGAL::Wireframe_extraction::parameters::error_message(&error));
    return !is_written && stream.str().empty() && error.find("curve 2") != std::string::npos
           && error.find(word) != std::string::npos;
  };
  const CGAL::Wireframe<Kernel> good = theta_wireframe();
  assert(!fails(good, ""));
  CGAL::Wireframe<Kernel> bad = good;
  bad.curves[2].conic.axis = Kernel::Vector_3(0, 0, 2);
  assert(fails(bad, "axis"));
  bad = good;
  bad.curves[2].conic.minor_radius = -1;
  assert(fails(bad, "radii"));
  bad = good;
  bad.curves[2].conic.end_angle = -1;
  assert(fails(bad, "angle"));
  bad = good;
  bad.curves[2].conic.center = Point(0, 0, 1);
  assert(fails(bad, "ends"));
  bad = good;
  bad.curves[2].uncertainty.position = std::numeric_limits<double>::quiet_NaN();
  assert(fails(bad, "uncertainty"));

  // the reader names what is missing
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_json(stream, good));
  std::string text = stream.str(), error;
  text.replace(text.find("\"center\""), 8, "\"centre\"");
  std::istringstream input(text);
  assert(!CGAL::IO::read_wireframe_json(input, bad, CGAL::Wireframe_extraction::parameters::error_message(&error)));
  assert(error.find("curve 2: \"center\" is missing") != std::string::npos);
}

struct Read_polylines
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polylines;
  std::vector<std::string> names;
};

Read_polylines parse_obj(std::istream& stream)
{
  Read_polylines result;
  for(std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if(kind == "v")
    {
      double x, y, z;
      const bool is_point = static_cast<bool>(words >> x >> y >> z);
      assert(is_point);
      result.points.emplace_back(x, y, z);
    }
    else if(kind == "g")
      result.names.push_back(line.substr(2));
    else if(kind == "l")
    {
      result.polylines.emplace_back();
      for(std::size_t index; words >> index;)
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
  for(std::size_t i = 0; i < polylines.polylines.size(); ++i)
  {
    const std::vector<std::size_t>& polyline = polylines.polylines[i];
    const double length = wireframe.curves[i].spline.length();
    assert(polyline.size() == std::size_t(std::ceil(length / step - 1e-9)) + 1);
    for(std::size_t j = 0; j + 1 < polyline.size(); ++j)
    {
      const Point& p = polylines.points.at(polyline[j]);
      const Point& q = polylines.points.at(polyline[j + 1]);
      assert(std::sqrt(CGAL::squared_distance(p, q)) <= step * (1 + 1e-9));
      assert(CGAL::to_double(wireframe.curves[i].spline.closest_point(q).distance) < 1e-9);
    }
    if(wireframe.curves[i].is_closed())
      assert(polyline.front() == polyline.back() && polyline.size() > 3);
    if(wireframe.curves[i].source < wireframe.vertices.size())
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
  const std::vector<std::string> names = { "curve_0_line", "curve_1_bspline", "curve_2_arc",
                                           "curve_3_bspline",
                                           "curve_4_circle" };
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
  std::istringstream content(file.read());
  check_spacing(parse_obj(content), wireframe, 0.3);
}

// without a sampling distance the longest curve decides
void test_default_step()
{
  CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  wireframe.sampling_distance = 0;
  double longest = 0;
  for(const auto& curve : wireframe.curves)
    longest = (std::max)(longest, curve.spline.length());
  std::stringstream stream;
  assert(CGAL::IO::write_wireframe_obj(stream, wireframe));
  check_spacing(parse_obj(stream), wireframe, longest / 100);
}

double load_double(const std::string& bytes, std::size_t& position)
{
  std::uint64_t bits = 0;
  for(int i = 0; i < 8; ++i)
    bits |= std::uint64_t(static_cast<unsigned char>(bytes.at(position++))) << (8 * i);
  double value;
  std::memcpy(&value, &bits, 8);
  return value;
}

std::uint32_t load_int(const std::string& bytes, std::size_t& position)
{
  std::uint32_t value = 0;
  for(int i = 0; i < 4; ++i)
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
  for(const auto& polyline : expected.polylines)
    number_of_edges += polyline.size() - 1;

  const Test_file file(".ply");
  assert(CGAL::IO::write_wireframe(file.name, wireframe, parameters::sampling_step(0.3)));
  assert(CGAL::IO::write_wireframe_ply(ascii, wireframe,
                                       parameters::sampling_step(0.3).use_binary_mode(false)));
  const std::string binary = file.read();
  const std::string header = "1.0\ncomment wireframe\nelement vertex "
    + std::to_string(expected.points.size())
    + "\nproperty double x\nproperty double y\nproperty double z\nelement edge "
      + std::to_string(number_of_edges)
    + "\nproperty int vertex1\nproperty int vertex2\nproperty int curve\nend_header\n";
  const std::string binary_start = "ply\nformat binary_little_endian " + header;
  const std::string ascii_start = "ply\nformat ascii " + header;
  assert(binary.compare(0, binary_start.size(), binary_start) == 0);
  assert(ascii.str().compare(0, ascii_start.size(), ascii_start) == 0);
  assert(binary.size() == binary_start.size() + 24 * expected.points.size() + 12 * number_of_edges);
  std::istringstream numbers(ascii.str().substr(ascii_start.size()));
  std::size_t position = binary_start.size();
  for(const Point& point : expected.points)
    for(int i = 0; i < 3; ++i)
    {
      double value = 0;
      numbers >> value;
      assert(value == point[i] && load_double(binary, position) == value);
    }
  for(std::size_t i = 0; i < expected.polylines.size(); ++i)
    for(std::size_t j = 0; j + 1 < expected.polylines[i].size(); ++j)
      for(const std::size_t index : { expected.polylines[i][j], expected.polylines[i][j + 1], i })
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
  for(const auto& polyline : expected.polylines)
  {
    std::string line;
    std::getline(stream, line);
    std::istringstream words(line);
    std::size_t size = 0;
    words >> size;
    assert(size == polyline.size());
    for(const std::size_t index : polyline)
    {
      double x, y, z;
      words >> x >> y >> z;
      assert(words && Point(x, y, z) == expected.points[index]);
    }
    assert((words >> std::ws).eof());
  }
  for(const char* const suffix : { ".polylines.txt", ".cgal" })
  {
    const Test_file file(suffix);
    assert(CGAL::IO::write_wireframe(file.name, wireframe));
    assert(file.read() == stream.str());
  }
}

void test_lean_traits()
{
  const CGAL::Wireframe<Lean_traits> wireframe = Random_wireframe<Lean_traits>(7)();
  for(const char* const suffix : { ".obj", ".ply", ".txt", ".json" })
  {
    const Test_file file(suffix);
    std::string error;
    assert(CGAL::IO::write_wireframe(file.name, wireframe,
      parameters::error_message(&error).sampling_step(1e8).geom_traits(Lean_traits())));
    assert(error.empty() && !file.read().empty());
  }
}

// a file that is there is replaced, keeps its permissions, and a link to it stays a link
void test_replacing()
{
  const CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  const Test_file file(".json", "old");
  const auto read_and_write = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(file.name, read_and_write);
  assert(CGAL::IO::write_wireframe(file.name, wireframe));
  CGAL::Wireframe<Kernel> result;
  assert(CGAL::IO::read_wireframe_json(file.name, result) && are_equal(wireframe, result));
  assert(std::filesystem::status(file.name).permissions() == read_and_write);

  const Test_file link("_link.json");
  std::error_code code;
  std::filesystem::create_symlink(file.name, link.name, code);
  if(code)
    return;
  assert(CGAL::IO::write_wireframe(link.name, CGAL::Wireframe<Kernel>()));
  assert(std::filesystem::is_symlink(link.name));
  assert(CGAL::IO::read_wireframe_json(file.name, result) && result.is_empty());
}

struct Comma : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// once more where decimals are written with a comma
void test_other_locale()
{
  std::ostringstream before;
  const CGAL::Wireframe<Kernel> wireframe = theta_wireframe();
  assert(CGAL::IO::write_wireframe_obj(before, wireframe, parameters::sampling_step(0.001)));
  assert(before.str().find("v 0.001 ") != std::string::npos);

  const std::locale old = std::locale::global(std::locale(std::locale::classic(), new Comma));
  for(const char* const name : { "de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8" })
    if(std::setlocale(LC_ALL, name) != nullptr)
      break;
  test_ply_ascii();
  test_text();
  test_text_with_names();
  test_separate_distances();
  test_json_round_trip<Kernel>(11);
  std::ostringstream after;
  assert(CGAL::IO::write_wireframe_obj(after, wireframe, parameters::sampling_step(0.001)));
  std::ostringstream json, ply;
  assert(CGAL::IO::write_wireframe_json(json, wireframe));
  assert(CGAL::IO::write_wireframe_ply(ply, wireframe,
                                       parameters::sampling_step(0.001).use_binary_mode(false)));
  std::setlocale(LC_ALL, "C");
  std::locale::global(old);
  assert(after.str() == before.str());
  assert(json.str().find("\"sampling_distance\":0.4,") != std::string::npos);
  assert(ply.str().find("\n0.001 ") != std::string::npos);
}

int main()
{
  test_bad_conics();
  test_ply_ascii();
  test_ply_binary();
  test_ply_binary_mixture();
  test_ply_vertices_with_lists();
  test_many_points();
  test_choice_of_property();
  test_text();
  test_text_with_names();
  test_separate_distances();
  test_skipping();
  test_other_types();
  for(unsigned seed = 0; seed < 10; ++seed)
  {
    test_json_round_trip<Kernel>(seed);
    test_json_round_trip<CGAL::Exact_predicates_inexact_constructions_kernel>(seed);
    test_json_round_trip<Lean_traits>(seed);
  }
  test_json_round_trip<CGAL::Simple_cartesian<float>>(3);
  test_json_details();
  test_obj();
  test_default_step();
  test_ply_edges();
  test_polylines();
  test_lean_traits();
  test_replacing();
  test_other_locale();
  return 0;
}
