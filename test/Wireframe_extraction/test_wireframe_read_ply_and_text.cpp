// Clouds in PLY and text.

#include "Comma_locale.h"
#include "scratch_files.h"

#include <CGAL/Wireframe_extraction/IO/Distance_cloud_file.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;

Cloud expected_cloud() { return {{Point(1, 2, 3), 0.5}, {Point(-4, 5.25, 100), 0}, {Point(7, -8, 9), 1}}; }

Cloud integer_cloud() { return {{Point(1, 2, 3), 4}, {Point(-4, 5, 100), 0}, {Point(7, -8, 9), 1}}; }

void check_reads(const std::string& suffix, const std::string& content, const Cloud& expected = expected_cloud(),
                 const std::string& distance_property = "")
{
  const Test_file file(suffix, content);
  Cloud cloud = {{Point(9, 9, 9), 9}};
  std::string error = "not cleared";
  std::size_t number_of_skipped = 99;
  const bool is_read = CGAL::IO::read_distance_cloud(
    file.name, cloud,
    parameters::error_message(&error).distance_property(distance_property).number_of_skipped(&number_of_skipped));
  if (!is_read)
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(is_read && error.empty() && number_of_skipped == 0);
  assert(cloud == expected);
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
  std::string text = ply_start(is_big_endian ? "binary_big_endian" : "binary_little_endian") + "element vertex "
    + std::to_string(cloud.size()) + "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type
    + " z\nproperty " + type + " distance\nend_header\n";
  for (const auto& sample : cloud)
    for (const double value : {sample.first.x(), sample.first.y(), sample.first.z(), sample.second})
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
  for (const char c : header + body)
  {
    windows += (c == '\n') ? "\r\n" : std::string(1, c);
    old_mac += (c == '\n') ? '\r' : c;
  }
  check_reads(".ply", windows);
  check_reads(".ply", old_mac);

  // any order, other properties, lists before the vertices and among their properties, faces after them
  check_reads(".ply",
              ply_start("ascii")
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
  for (const bool is_big_endian : {false, true})
  {
    check_reads(".ply", binary_ply<float>(is_big_endian, "float", expected_cloud()));
    check_reads(".ply", binary_ply<float>(is_big_endian, "float32", expected_cloud()));
    check_reads(".ply", binary_ply<double>(is_big_endian, "double", expected_cloud()));
    check_reads(".ply", binary_ply<double>(is_big_endian, "float64", expected_cloud()));
    check_reads(".ply", binary_ply<std::int8_t>(is_big_endian, "char", integer_cloud()), integer_cloud());
    check_reads(".ply", binary_ply<std::int16_t>(is_big_endian, "short", integer_cloud()), integer_cloud());
    check_reads(".ply", binary_ply<std::int32_t>(is_big_endian, "int32", integer_cloud()), integer_cloud());
    check_reads(".ply", binary_ply<std::int64_t>(is_big_endian, "int64", integer_cloud()), integer_cloud());
    const Cloud natural = {{Point(200, 2, 3), 4}};
    check_reads(".ply", binary_ply<std::uint8_t>(is_big_endian, "uchar", natural), natural);
    check_reads(".ply", binary_ply<std::uint16_t>(is_big_endian, "uint16", natural), natural);
    check_reads(".ply", binary_ply<std::uint32_t>(is_big_endian, "uint", natural), natural);
  }
}

void test_ply_binary_mixture()
{
  for (const bool is_big_endian : {false, true})
  {
    std::string text = ply_start(is_big_endian ? "binary_big_endian" : "binary_little_endian")
      + "element camera 2\nproperty double focus\nproperty uchar id\n"
        "element face 2\nproperty list uchar int vertex_indices\nproperty list ushort double texture\n"
        "element vertex 3\nproperty uchar red\nproperty double z\nproperty short y\nproperty float quality\n"
        "property float x\nelement face2 1\nproperty list uchar int vertex_indices\nend_header\r\n";
    for (int i = 0; i < 2; ++i)
    {
      append(10. + i, is_big_endian, text);
      append(std::uint8_t(10), is_big_endian, text);
    }
    for (int face = 0; face < 2; ++face)
    {
      append(std::uint8_t(3 + face), is_big_endian, text);
      for (int i = 0; i < 3 + face; ++i)
        append(std::int32_t(i), is_big_endian, text);
      append(std::uint16_t(300 * face), is_big_endian, text);
      for (int i = 0; i < 300 * face; ++i)
        append(0.5, is_big_endian, text);
    }
    Cloud expected = expected_cloud();
    expected[1].first = Point(-4, 5, 100);
    for (const auto& sample : expected)
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
  for (const bool is_big_endian : {false, true})
  {
    std::string text = ply_start(is_big_endian ? "binary_big_endian" : "binary_little_endian")
      + "element vertex 3\nproperty float x\nproperty list uint float neighbors\nproperty float y\n"
        "property float z\nproperty float distance\nend_header\n";
    std::uint32_t size = 0;
    for (const auto& sample : expected_cloud())
    {
      append(float(sample.first.x()), is_big_endian, text);
      append(size, is_big_endian, text);
      for (std::uint32_t i = 0; i < size; ++i)
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
  for (int i = 0; i < 100001; ++i)
    cloud.emplace_back(Point(random() % 1000, random() % 1000, random() % 1000), random() % 8);
  check_reads(".ply", binary_ply<double>(false, "double", cloud), cloud);
  check_reads(".ply", binary_ply<float>(true, "float", cloud), cloud);
  std::ostringstream text;
  text.precision(17);
  for (const auto& sample : cloud)
    text << sample.first << " " << sample.second << "\r\n";
  check_reads(".xyz", text.str(), cloud);
  check_reads(".ply",
              "ply\nformat ascii 1.0\nelement vertex 100001\nproperty int x\nproperty int y\n"
              "property int z\nproperty int distance\nend_header\n"
                + text.str(),
              cloud);
}

void test_choice_of_property()
{
  const auto ply = [](const std::string& first, const std::string& second) {
    return ply_start("ascii") + "element vertex 1\nproperty float " + first
      + "\nproperty float x\nproperty float y\n"
        "property float z\nproperty float "
      + second + "\nend_header\n10 1 2 3 20\n";
  };
  const Cloud first = {{Point(1, 2, 3), 10}}, second = {{Point(1, 2, 3), 20}};
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
  check_reads(".csv", "\"1\",\"2\",\"3\",\"0.5\"\n-4,' 5.25','1e2',0\n\"7\",-8,9,\"1\"\n");
  check_reads(".csv", "sep=;\n1;2;3;0.5\n-4;5.25;1e2;0\n7;-8;9;1\n");
  check_reads(".csv", "SEP=,\r\nx,y,z,distance\r\n1,2,3,0.5\r\n-4,5.25,1e2,0\r\n7,-8,9,1\r\n");
  check_reads(".csv", "sep=\t\n1\t2\t3\t0.5\n-4\t5.25\t1e2\t0\n7\t-8\t9\t1\n");
  check_reads(".csv", "1;2;3;.5\n-4;5.25;100;0\n7;-8;9;1\n");
  check_reads(".txt", "# made by hand\n1 2 3 0.5 # first\n// second\n-4 5.25 1e2 0\n  # third\n7 -8 9 1\n");
  check_reads(".txt",
              "\xEF\xBB\xBF"
              "1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  check_reads(".pts", "3\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  // further columns, which need not be numbers
  check_reads(".txt", "1 2 3 0.5 a 1\n-4 5.25 1e2 0 b 2\n7 -8 9 1 c 3\n");
  check_reads(".txt", "1 2 3 0.5 1\n-4 5.25 1e2 0 2\n7 -8 9 1 3\n");
  // of three numbers and more it has to be said which is the distance
  check_reads(".txt", "1 2 3 0.5 0 1\n-4 5.25 1e2 0 0 1\n7 -8 9 1 0 1\n", expected_cloud(), "4");
  check_reads(".txt", "1 2 3 0 0 1 0.5\n-4 5.25 1e2 0 0 1 0\n7 -8 9 0 0 1 1\n", expected_cloud(), "7");
}

// what the tool reads: distances need not be there
void test_unnamed_columns()
{
  const auto check = [](const std::string& content, bool has_distances, const std::string& assumption) {
    const Test_file file(".xyz", content);
    CGAL::IO::Distance_cloud_file cloud(file.name,
                                        parameters::field_origin(CGAL::Wireframe_extraction::Field_origin::AUTOMATIC));
    const bool is_read = cloud.read([](const auto*, const auto*) { return true; });
    if (!is_read || cloud.has_distances() != has_distances || cloud.assumption().find(assumption) != 0)
      std::fprintf(stderr, "%s%s %s\n", content.c_str(), cloud.error_message().c_str(), cloud.assumption().c_str());
    assert(is_read && cloud.has_distances() == has_distances && cloud.assumption().find(assumption) == 0);
  };
  std::string many;
  for (int i = 0; i < 30000; ++i)
    many += "0 0 0 0.5 1 1\n";
  const std::string normal = "columns 4 to 6 are taken for a normal", colour = "columns 4 to 6 are taken for a colour",
                    fourth = "column 4 of 6 is taken for the distance";
  check("1 2 3 0 0 1\n1 2 3 1 0 0\n", false, normal);
  check("1 2 3 0 0 0\n1 2 3 0 -1 0\n1 2 3 nan nan nan\n", false, normal);
  check("1 2 3 0 0 1\n1 2 3 0 0 7\n1 2 3 1 255 3\n", false, colour);
  check("1 2 3 0 0 1\n1 2 3 0 0.5 7\n1 2 3 1 255 3\n", true, fourth);
  check("1 2 3 0 0 1\n1 2 3 0 0 7\n1 2 3 1 256 3\n", true, fourth);
  check("1 2 3 0.6 0.8 0\n1 2 3 0.6 0.9 a\n1 2 3 0.6 0.9 1\n", true, fourth);
  check("1 2 3 0 0 1\n" + many, true, fourth);
  check("1 2 3 9 8 7 0.6 0.8 0\n1 2 3 9 8 255 0.6 0.8 0\n", false, colour);
  check("1 2 3 -500 9 8 7\n1 2 3 -501 9 8 255\n", false, "columns 5 to 7 are taken for a colour");
  check("# x y z r g b\n1 2 3 9 8 7\n", false, "");
  check("1 2 3 0.5\n1 2 3 0\n", true, "");
}

void test_text_with_names()
{
  check_reads(".csv", "x,y,z,distance\n1,2,3,0.5\n-4,5.25,1e2,0\n7,-8,9,1\n");
  check_reads(".csv", "\"x\";\"y\";\"z\";\"d\"\n1;2;3;0.5\n-4;5.25;1e2;0\n7;-8;9;1\n");
  check_reads(".csv", "d,z,y,x\n0.5,3,2,1\n0,1e2,5.25,-4\n1,9,-8,7\n");
  check_reads(".csv", "Label,Distance,Z,Y,X\na,0.5,3,2,1\nb,0,1e2,5.25,-4\nc,1,9,-8,7\n");
  check_reads(".csv", "\"distance\",\"Points:0\",\"Points:1\",\"Points:2\"\n0.5,1,2,3\n0,-4,5.25,1e2\n1,7,-8,9\n");
  check_reads(".csv", "Points_0,Points_1,Points_2,sharpness,Ids\n1,2,3,0.5,0\n-4,5.25,1e2,0,0\n7,-8,9,1,0\n");
  check_reads(".txt", "X Y Z scalar_Sharpness Scalar_intensity\n1 2 3 0.5 7\n-4 5.25 1e2 0 7\n7 -8 9 1 7\n");
  check_reads(".txt", "X Y Z own scalar_own\n1 2 3 7 0.5\n-4 5.25 1e2 7 0\n7 -8 9 7 1\n", expected_cloud(),
              "scalar_own");
  check_reads(".txt", "X Y Z i scalar_own\n1 2 3 7 0.5\n-4 5.25 1e2 7 0\n7 -8 9 7 1\n", expected_cloud(), "own");
  check_reads(".txt", "# x y z nx distance\n1,2,3,0,0.5\n-4,5.25,1e2,0,0\n7,-8,9,0,1\n");
  check_reads(".txt", "//X Y Z Quality\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  check_reads(".txt", "% distance x y z\n0.5 1 2 3\n0 -4 5.25 1e2\n1 7 -8 9\n");
  check_reads(".txt", "# columns: distance x y z\n# in millimeters\n0.5 1 2 3\n0 -4 5.25 1e2\n1 7 -8 9\n");
  // a comment that only looks like a line of names
  check_reads(".txt", "# columns: x y z\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
  check_reads(".txt", "# z is up, x y d\n1 2 3 0.5\n-4 5.25 1e2 0\n7 -8 9 1\n");
}

void test_separate_distances()
{
  const Test_file distances("_distances.dat", "# field\ndistance\n0.5\n\n0 # on the edge\n// last\n1\n");
  const auto check = [&distances](const std::string& suffix, const std::string& content) {
    const Test_file file(suffix, content);
    Cloud cloud;
    std::string error;
    assert(CGAL::IO::read_distance_cloud(file.name, distances.name, cloud, parameters::error_message(&error)));
    assert(error.empty() && cloud == expected_cloud());
  };
  check(".xyz", "1 2 3\n-4 5.25 1e2\n7 -8 9\n");
  check(".xyz", "1 2 3 77\n-4 5.25 1e2 77\n7 -8 9 77\n");
  check(".csv", "label,x,y,z\na,1,2,3\na,-4,5.25,1e2\na,7,-8,9\n");
  check(".ply",
        ply_start("ascii")
          + "element vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nend_header\n1 2 3\n-4 5.25 1e2\n7 -8 9\n");
  check(".ply", binary_ply<double>(true, "double", expected_cloud()));
}

void test_skipping()
{
  const Cloud expected = {{Point(1, 2, 3), 0.5}, {Point(7, -8, 9), 1}};
  const auto check = [&expected](const std::string& suffix, const std::string& content, std::size_t number) {
    const Test_file file(suffix, content);
    Cloud cloud;
    std::size_t number_of_skipped = 0;
    assert(CGAL::IO::read_distance_cloud(file.name, cloud,
                                         parameters::skip_invalid(true).number_of_skipped(&number_of_skipped)));
    assert(cloud == expected && number_of_skipped == number);
  };
  check(".xyz", "1 2 3 0.5\n1 nan 3 0.5\n1 2 3 -0.5\n1 2 3 inf\n1 2 1e999 1\n7 -8 9 1\n", 4);
  check(".ply",
        ply_start("ascii")
          + "element vertex 4\nproperty float x\nproperty float y\n"
            "property float z\nproperty float distance\nend_header\n1 2 3 0.5\nnan 0 0 0\n7 -8 9 1\n"
            "0 0 0 -1\n",
        2);
  Cloud bad = {expected[0], {Point(0, HUGE_VAL, 0), 1}, expected[1], {Point(0, 0, 0), std::nan("")}};
  check(".ply", binary_ply<double>(false, "double", bad), 2);
  check(".ply", binary_ply<float>(true, "float", bad), 2);

  // with distances of their own, the two stay in step
  const Test_file file(".xyz", "1 2 3\n0 0 nan\n0 0 0\n7 -8 9\n"), distances("_distances.dat", "0.5\n1\n-1\n1\n");
  Cloud cloud;
  assert(CGAL::IO::read_distance_cloud(file.name, distances.name, cloud, parameters::skip_invalid(true)));
  assert(cloud == expected);
}

void test_coordinate_properties()
{
  const Cloud expected = {{Point(2, 3, 1), 4}, {Point(6, 7, 5), 8}};
  const Names by_name = {"", "", "", {"v", "w", "u"}}, by_number = {"", "", "", {"2", "3", "1"}};
  const std::string rows = "1 2 3 4\n5 6 7 8\n";
  const std::string ply = ply_start("ascii")
    + "element vertex 2\nproperty float u\nproperty float v\nproperty float w\nproperty float distance\nend_header\n"
    + rows;
  const Test_file ply_file(".ply", ply), numbered("_numbered.txt", rows),
    named("_named.txt", "u v w distance\n" + rows), comment("_comment.txt", "# u v w distance\n" + rows),
    five("_five.txt", "1 2 3 0 4\n5 6 7 0 8\n");
  for (const Test_file* const file : {&ply_file, &named, &comment})
    assert(read(file->name, by_name) == expected);
  assert(read(numbered.name, by_number) == expected);
  assert(read(five.name, {"", "", "5", {"2", "3", "1"}}) == expected);
  refuse(five, {":1:", "distance_property"}, by_number);
  refuse(five, {"\"3\"", "distance_property"}, {"", "", "3", {"2", "3", "1"}});
  refuse(numbered, {"\"5\"", "from 1 to 4"}, {"", "", "", {"1", "2", "5"}});
  refuse(named, {"\"q\"", "u, v, w, distance"}, {"", "", "", {"u", "v", "q"}});
  refuse(".ply", ply, {"no property \"x\"", "u, v, w, distance", "coordinate_properties"});
}

// what a regressor predicts near features
void test_negative_distances()
{
  const Test_file small(".xyz", "0 0 0 -0.001\n1 0 0 2\n"), text("_points.xyz", "0 0 0\n1 0 0\n"),
    distances("_distances.txt", "-0.001\n2\n"), signed_ones("_signed.xyz", "0 0 0 -0.5\n1 0 0 2\n2 0 0 3\n");
  const Cloud expected = {{Point(0, 0, 0), 0}, {Point(1, 0, 0), 2}};
  refuse(small, {"1 with a negative distance", "skip_invalid", "clamp_negative"});
  refuse("_nan.xyz", "0 0 0 nan\n1 0 0 2\n", {"skip_invalid(true)"});
  Cloud cloud;
  std::string error;
  const auto clamped = parameters::clamp_negative(true).error_message(&error);
  assert(CGAL::IO::read_distance_cloud(small.name, cloud, clamped) && cloud == expected);
  assert(CGAL::IO::read_distance_cloud(text.name, distances.name, cloud, clamped) && cloud == expected);
  assert(!CGAL::IO::read_distance_cloud(signed_ones.name, cloud, clamped));
  check_words(error, {"-0.5", "3", "signed"});
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

// once more where decimals are written with a comma
void test_other_locale()
{
  const Comma_locale locale;
  test_ply_ascii();
  test_text();
  test_text_with_names();
  test_separate_distances();
}

int main()
{
  test_ply_ascii();
  test_ply_binary();
  test_ply_binary_mixture();
  test_ply_vertices_with_lists();
  test_many_points();
  test_choice_of_property();
  test_text();
  test_unnamed_columns();
  test_text_with_names();
  test_separate_distances();
  test_skipping();
  test_coordinate_properties();
  test_negative_distances();
  test_other_types();
  test_other_locale();
  return 0;
}
