#include "check_words.h"

#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/IO/read_wireframe_json.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>

#include <CGAL/Simple_cartesian.h>

#include <cassert>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_curve<Kernel> Curve;

// a file of the current directory that is gone at the end of the test
struct Test_file
{
  std::string name;

  Test_file(const std::string& suffix, const std::string& content) : name("io_bad_scratch" + suffix)
  {
    std::ofstream(name, std::ios::binary) << content;
  }

  ~Test_file() { std::remove(name.c_str()); }
};

// ---- clouds ----

void refuse_name(const std::string& name, const Words& words, const std::string& distance_property = "")
{
  const Cloud before = { { Point(1, 2, 3), 4 } };
  Cloud cloud = before;
  std::string error;
  std::size_t number_of_skipped = 99;
  assert(!CGAL::IO::read_distance_cloud(name, cloud,
    parameters::error_message(&error).distance_property(distance_property)
                                     .number_of_skipped(&number_of_skipped)));
  assert(cloud == before && number_of_skipped == 0);
  check_words(error, words);
  // nobody has to ask for the message
  assert(!CGAL::IO::read_distance_cloud(name, cloud, parameters::distance_property(distance_property)));
}

void refuse(const std::string& suffix, const std::string& content, const Words& words,
            const std::string& distance_property = "")
{
  const Test_file file(suffix, content);
  refuse_name(file.name, words, distance_property);
  refuse_name(file.name, { file.name }, distance_property);
}

void refuse_pair(const std::string& suffix, const std::string& content, const std::string& distances,
                 const Words& words)
{
  const Test_file file(suffix, content), distances_file("_distances.dat", distances);
  Cloud cloud;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, distances_file.name, cloud,
                                        parameters::error_message(&error)));
  assert(cloud.empty());
  check_words(error, words);
}

void test_files()
{
  refuse_name("io_bad_none.ply", { "io_bad_none.ply", "cannot be opened", "No such file", "check its name" });
  refuse_name("io_bad_none/x.xyz", { "io_bad_none/x.xyz", "cannot be opened" });
  refuse_name("", { "extension" });
  refuse_name("io_bad_none", { "unknown extension", ".ply", ".xyz", ".txt", ".csv", ".asc", ".pts" });
  refuse(".stl", "solid", { "unknown extension \".stl\"" });
  for(const char* const suffix : { ".ply", ".xyz", ".txt", ".csv", ".asc", ".pts" })
  {
    refuse(suffix, "", { "is empty", "get a complete copy" });
    const std::string name = std::string("io_bad_directory") + suffix;
    fs::create_directory(name);
    refuse_name(name, { name, "is a directory", "name a file in it" });
    fs::remove(name);
  }
}

std::string header(const std::string& format, const std::string& count = "2",
                   const std::string& type = "float")
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + count + "\nproperty " + type + " x\nproperty "
         + type
         + " y\nproperty " + type + " z\nproperty " + type + " distance\n";
}

// a header that has another element before the vertices
std::string header_with(const std::string& element, const std::string& format, const std::string& count = "2")
{
  std::string text = header(format, count);
  return text.insert(text.find("element"), element);
}

void test_ply_headers()
{
  const std::string end = "end_header\n1 2 3 4\n5 6 7 8\n";
  refuse(".ply", "1 2 3 4\n5 6 7 8\n", { ":1:", "\"ply\"", "\"1 2 3 4\"" });
  refuse(".ply", "ply\n", { "end_header", "truncated" });
  refuse(".ply", header("ascii"), { "end_header", "truncated" });
  refuse(".ply", header("text") + end, { ":2:", "\"text\"",
                                         "ascii, binary_little_endian, binary_big_endian" });
  refuse(".ply", "ply\nelement vertex 1\nproperty float x\n" + end, { "format" });
  refuse(".ply", header("ascii", "-1") + end, { ":3:", "\"-1\"", "number of vertex" });
  refuse(".ply", header("ascii", "many") + end, { ":3:", "\"many\"" });
  refuse(".ply", header("ascii", "1e3") + end, { ":3:", "\"1e3\"" });
  refuse(".ply", header("ascii", "99999999999999999999999") + end, { ":3:", "99999999999999999999999" });
  refuse(".ply", header("ascii", "2", "real") + end, { ":4:", "\"real\"" });
  refuse(".ply", header("ascii", "2 3") + end, { ":3:", "element NAME COUNT" });
  refuse(".ply", "ply\nformat ascii 1.0\nproperty float x\n" + end, { ":3:", "before the first element" });
  refuse(".ply", header("ascii") + "property float\n" + end, { ":8:", "property TYPE NAME" });
  refuse(".ply", header("ascii") + "property list float int ids\n" + end, { ":8:", "counted", "float" });
  refuse(".ply", header("ascii") + "property float x\n" + end, { ":8:", "\"x\"", "twice" });
  refuse(".ply", header("ascii") + "element vertex 2\n" + end, { ":8:", "\"vertex\"", "twice" });
  refuse(".ply", header("ascii") + "solid\x01 7\n" + end, { ":8:", "\"solid?\"" });
  refuse(".ply", "ply\nformat ascii 1.0\nelement point 1\nproperty float x\n" + end,
         { "no element \"vertex\"", "point" });
  refuse(".ply", "ply\nformat ascii 1.0\n" + end, { "no element \"vertex\"", "(none)" });
  refuse(".ply", "ply\n" + std::string(3000000, 'x'), { "end_header" });
}

void test_ply_properties()
{
  const auto ply = [](const std::string& properties)
  {
    return "ply\nformat ascii 1.0\nelement vertex 1\n" + properties + "end_header\n1 2 3 4\n";
  };
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  refuse(".ply", ply("property float x\nproperty float y\nproperty float distance\n"),
         { "no property \"z\"", "they have: x, y, distance" });
  refuse(".ply", ply(xyz + "property float nx\n"),
         { "for the distance", "sharpness", "they have: x, y, z, nx", "distance_property", "separate file" });
  refuse(".ply", ply(xyz + "property float distance\n"),
         { "no property \"own\"", "they have: x, y, z, distance" },
         "own");
  refuse(".ply", ply(xyz + "property list uchar float distance\n"), { "\"distance\"", "list" });
  refuse(".ply", ply("property list uchar float x\nproperty float y\nproperty float z\n"
                      "property float distance\n"),
         { "\"x\"", "list" });
}

void test_ply_ascii_bodies()
{
  const std::string start = header("ascii") + "end_header\n";
  refuse(".ply", header("ascii", "0") + "end_header\n", { "holds no points" });
  refuse(".ply", start, { "truncated", "after 0 of 2 vertices" });
  refuse(".ply", start + "1 2 3 4\n", { "truncated", "after 1 of 2 vertices" });
  refuse(".ply", start + "1 2 3 4\n5 6", { ":10:", "2 values", "4 properties" });
  refuse(".ply", start + "1 2 3 4\n5 6 7 8 9\n", { ":10:", "5 values", "more than" });
  refuse(".ply", start + "1 2 3 4\n5 6 seven 8\n", { ":10:", "\"seven\"", "\"z\"" });
  refuse(".ply", start + "1 2 3 4\n5,6,7,8\n", { ":10:", "\"5,6,7,8\"" });
  refuse(".ply", start + "1 2 3 4\n5 6 0x7 8\n", { ":10:", "\"0x7\"" });
  refuse(".ply", start + "1 2 3 4\n5 6 7 8\n9 9 9 9\n", { "more than the 2 vertices" });
  refuse(".ply", start + "1 2 3 4\n" + std::string(3000000, '1'), { ":10:", "too long" });
  refuse(".ply", header("ascii", "1000000000000") + "end_header\n1 2 3 4\n",
         { "after 1 of 1000000000000 vertices" });
  const std::string with_list = header("ascii", "1") + "property list uchar int ids\nend_header\n";
  refuse(".ply", with_list + "1 2 3 4 3 0 1\n", { ":10:", "\"ids\"", "shorter" });
  refuse(".ply", with_list + "1 2 3 4 -1\n", { ":10:", "\"-1\"", "\"ids\"" });
  refuse(".ply", with_list + "1 2 3 4\n", { ":10:", "4 values" });
  refuse(".ply", header_with("element face 3\nproperty list uchar int ids\n", "ascii")
                 + "end_header\n3 0 1 2\n", { "truncated", "\"face\"", "before the vertices" });
}

void test_ply_binary_bodies()
{
  for(const char* const format : { "binary_little_endian", "binary_big_endian" })
  {
    const std::string start = header(format) + "end_header\n";
    refuse(".ply", header(format, "0") + "end_header\n", { "holds no points" });
    refuse(".ply", start, { "header promises 2 vertices = 32 bytes", "the file has 0", "0 of 2",
                            "truncated" });
    refuse(".ply", start + std::string(31, '\0'),
           { "header promises 2 vertices = 32 bytes", "the file has 31", "1 of 2", "truncated" });
    refuse(".ply", start + std::string(48, '\0'), { "more than the 2 vertices" });
    const std::string face = header_with("element face 1\nproperty list int int ids\n", format, "1")
                             + "end_header\n";
    refuse(".ply", face + std::string(4, '\xff') + std::string(16, '\0'), { "\"ids\"", "-1", "damaged" });
    refuse(".ply", face + std::string(4, '\x7f') + std::string(16, '\0'),
           { "truncated", "\"face\"", "before the vertices" });
    refuse(".ply", face + std::string(4, '\0'), { "promises 1 vertices", "truncated" });
    const std::string list = header(format) + "property list int double ids\nend_header\n";
    refuse(".ply", list + std::string(20, '\0') + std::string(16, '\0') + std::string(4, '\x01'),
           { "truncated", "after 1 of 2 vertices" });
  }
}

// neither time nor memory goes to what only the header has
void test_promises()
{
  const auto begin = std::chrono::steady_clock::now();
  for(const char* const format : { "ascii", "binary_little_endian", "binary_big_endian" })
    for(const char* const count : { "1000000000000", "18446744073709551615" })
    {
      const std::string content = "1 2 3 4\n5 6 7 8\n";
      refuse(".ply", header(format, count) + "end_header\n" + content,
             { std::string(count) + " vertices", "truncated" });
      refuse(".ply", header_with(std::string("element other ") + count
                                 + "\nproperty double a\nproperty list uchar int b\n", format)
                     + "end_header\n" + content, { "\"other\"" });
      refuse(".ply", header(format, count)
             + "property list uint8 int ids\nend_header\n1 2 3 4 0\n5 6 7 8 0\n",
             { std::string(count) + " vertices", "truncated" });
    }
  refuse(".ply", header("binary_little_endian", "1000000000000") + "end_header\n",
         { "header promises 1000000000000 vertices = 16000000000000 bytes, the file has 0" });
  assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
}

void test_text()
{
  refuse(".xyz", "\n \n", { "holds no points", "write the cloud" });
  refuse(".xyz", "# nothing\n", { "holds no points" });
  refuse(".csv", "x,y,z,distance\n", { "holds no points" });
  refuse(".xyz", "1 2 3\n4 5 6\n", { ":1:", "3 columns", "x y z distance", "separate file" });
  refuse(".xyz", "1 2 3 4\n5 6 7\n", { ":2:", "3 columns", "4" });
  refuse(".xyz", "1 2 3 4\n\n# c\n5 6 7 8 9\n", { ":4:", "5 columns", "4" });
  refuse(".xyz", "1 2 3 4\n5 6 7 eight\n", { ":2:", "column 4", "\"eight\", no number", "write a number there", "leave the line out" });
  refuse(".csv", "1,2,3,4\n5,,7,8\n", { ":2:", "column 2", "empty" });
  refuse(".csv", "1,5;2,5;3,5;4,5\n", { ":1:", "\"1,5\"", "point, not a comma" });
  refuse(".csv", "1,5 2,5 3,5 4,5\n", { ":1:", "decimals need a point, not a comma" });
  refuse(".xyz", "0,0 1,0 2,0 0,5\n", { ":1:", "decimals need a point, not a comma" });
  refuse(".xyz", "1,5\t2 3 4\n", { ":1:", "decimals need a point, not a comma" });
  refuse(".ply", header("ascii") + "end_header\n1 2 3 4\n5,1 6 7 8\n", { ":10:", "\"5,1\"", "point, not a comma" });
  refuse(".csv", "1 2 3 4\n1,5 2 3 4\n", { ":2:", "\"1,5\"", "point, not a comma" });
  refuse(".csv", "x,y,z,distance\n1,2,3\n", { ":2:", "3 columns" });
  refuse(".csv", "x,y,z,distance\n1,2,3,4,5\n", { ":2:", "5 columns", "names has 4" });
  refuse(".csv", "x,y,z,distance\nx,y,z,distance\n1,2,3,4\n", { ":2:", "\"x\"" });
  refuse(".csv", "x,y,h,distance\n1,2,3,4\n", { "x, y and z", "x, y, h, distance" });
  refuse(".csv", "x,y,z,nx,d\n1,2,3,4,5\n", { "distance", "x, y, z, nx, d", "distance_property" });
  refuse(".csv", "x,y,z,distance\n1,2,3,4\n", { "\"own\"", "x, y, z, distance" }, "own");
  refuse(".csv", "1,2,3,4\n", { "\"own\"", "without names" }, "own");
  // three columns look like a normal before the distance
  for(const char* const row : { "0 0 0 0.6 0 -0.8\n", "0 0 0 0 0 1 0.5\n" })
  {
    refuse(".xyz", row, { ":1:", "columns without names", "distance_property", "line of names" });
    refuse(".xyz", row, { ":1:", "\"3\"", "from 4 to", "distance_property" }, "3");
    refuse(".xyz", row, { ":1:", "\"8\"", "from 4 to", "distance_property" }, "8");
  }
  refuse(".pts", "3\n1 2 3 4\n5 6 7 8\n", { "promises 3", "holds 2", "truncated" });
  refuse(".pts", "3\n3\n1 2 3 4\n", { ":2:", "1 column" });
  refuse(".txt", std::string("\x93NUMPY\x01\0\n\0\0\xff", 11), { ":1:", "no text" });
  refuse(".txt", std::string("\xff\xfe" "1\0 \0" "2\0", 8), { ":1:", "no text" });
  refuse(".txt", std::string(3000000, '7'), { ":1:", "text file" });
  refuse(".txt", "1 2 3 4\n" + std::string(3000000, ' '), { ":2:", "text file" });
}

void test_values()
{
  refuse(".xyz", "1 2 3 4\n# c\n5 nan 7 8\n5 6 7 inf\n5 6 7 -1\n5 6 7 -1\n",
         { "4 of 5 points", "1 with a coordinate", "1 with a distance", "2 with a negative", "point 1 ",
           "line 3",
           "5 nan 7", "skip_invalid(true)" });
  refuse(".xyz", "1 2 3 4\n5 6 7 -inf\n", { "1 of 2 points", "point 1 ", "line 2", "-inf" });
  refuse(".xyz", "1 2 3 -0.25\n", { "point 0 ", "-0.25", "negative" });
  refuse(".xyz", "1 2 3 -0.25 1\n", { "line 1", "its distance in column 4 is -0.25" });
  refuse(".csv", "x,y,z,nx,d\n1,2,3,4,-5\n", { "line 2", "its distance in column 5, \"d\", is -5" }, "d");
  refuse(".xyz", "1 1e999 3 0\n", { "point 0 ", "not finite" });
  refuse(".ply", header("ascii") + "end_header\n1 2 3 4\n1 2 3 NaN\n",
         { "1 of 2 points", "point 1 ", "line 10" });
  const float values[] = { 1, 2, 3, 4, 1, 2, -std::numeric_limits<float>::infinity(), 4 };
  refuse(".ply", header("binary_little_endian") + "end_header\n"
                 + std::string(reinterpret_cast<const char*>(values), sizeof(values)),
         { "1 of 2 points", "point 1 ", "-inf", "skip_invalid" });

  const Test_file file(".xyz", "nan 2 3 4\n1 2 3 -4\n");
  Cloud cloud;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, cloud,
                                        parameters::skip_invalid(true).error_message(&error)));
  check_words(error, { file.name, "no point is left", "2 of 2", "point 0 " });
}

void test_separate_distances()
{
  const std::string cloud = "1 2 3\n4 5 6\n";
  refuse_pair(".xyz", cloud, "1\n", { "2 points", "1 distance;", "_distances.dat" });
  refuse_pair(".xyz", cloud, "1\n2\n3\n", { "2 points", "3 distances", "_distances.dat" });
  refuse_pair(".xyz", cloud, "", { "_distances.dat", "is empty" });
  refuse_pair(".xyz", cloud, "# nothing\n", { "_distances.dat", "holds no distances" });
  refuse_pair(".xyz", cloud, "1\ntwo\n", { "_distances.dat:2:", "\"two\"", "write a number there" });
  refuse_pair(".xyz", cloud, "0,5\n1,5\n", { "_distances.dat:1:", "2 columns", "decimals with a point" });
  refuse_pair(".xyz", cloud, "a\nb\n1\n2\n", { "_distances.dat:2:", "\"b\"" });
  refuse_pair(".xyz", cloud, "1\n2 3\n", { "_distances.dat:2:", "2 columns" });
  refuse_pair(".xyz", cloud, "1\n\n-2\n", { "point 1 ", "negative", "_distances.dat:3" });
  refuse_pair(".xyz", cloud, "nan\n1\n", { "point 0 ", "nan", "_distances.dat:1" });
  refuse_pair(".xyz", "", "1\n2\n", { ".xyz", "is empty" });
  refuse_pair(".xyz", "1 2\n", "1\n", { ":1:", "2 columns", "3 (x y z)" });
  refuse_pair(".ply", header("ascii") + "end_header\n1 2 3 4\n5 6 7 8\n", "1\n",
              { "2 points", "1 distance;" });
  const Test_file file(".xyz", cloud);
  Cloud result;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, "io_bad_none.dat", result,
                                        parameters::error_message(&error)));
  check_words(error, { "io_bad_none.dat", "cannot be opened" });
  assert(!CGAL::IO::read_distance_cloud(file.name, ".", result, parameters::error_message(&error)));
  check_words(error, { "is a directory" });
}

// ---- wireframes ----

// a valid file, in which `from` is replaced by `to`
std::string json(const std::string& from = "", const std::string& to = "")
{
  std::string text =
    "{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":0.5,\"vertices\":[[0,0,0],[1,0,0]],"
    "\"curves\":[{\"type\":\"line\",\"closed\":false,\"source\":0,\"target\":1,\"degree\":1,"
    "\"knots\":[0,0,1,1],\"control_points\":[[0,0,0],[1,0,0]],\"rms\":0.1,\"max\":0.2,\"support\":10},"
    "{\"type\":\"bspline\",\"closed\":false,\"source\":1,\"target\":0,\"degree\":2,"
    "\"knots\":[0,0,0,0.5,1,1,1],\"control_points\":[[1,0,0],[1,1,0],[0,1,0],[0,0,0]],"
    "\"weights\":[1,2,3,4],\"rms\":0.3,\"max\":0.4,"
    "\"support\":30}]}";
  if(!from.empty())
  {
    const std::size_t position = text.find(from);
    assert(position != std::string::npos);
    text.replace(position, from.size(), to);
  }
  return text;
}

void refuse_json(const std::string& content, const Words& words)
{
  const Test_file file(".json", content);
  Wireframe wireframe;
  wireframe.vertices.push_back(Point(7, 7, 7));
  std::string error;
  assert(!CGAL::IO::read_wireframe_json(file.name, wireframe, parameters::error_message(&error)));
  assert(wireframe.vertices.size() == 1 && wireframe.curves.empty());
  check_words(error, words);
  check_words(error, { file.name });
  std::istringstream stream(content);
  assert(!CGAL::IO::read_wireframe_json(stream, wireframe));
}

void test_json_documents()
{
  std::istringstream valid(json());
  Wireframe wireframe;
  assert(CGAL::IO::read_wireframe_json(valid, wireframe) && wireframe.curves.size() == 2);

  refuse_json("", { "is empty" });
  refuse_json("{", { "JSON", "truncated", "line 1" });
  refuse_json(json().substr(0, 100), { "JSON", "truncated" });
  refuse_json(json() + "x", { "JSON" });
  refuse_json(std::string(1000000, '['), { "JSON" });
  refuse_json(std::string("\xff\xfe{\0", 4), { "JSON" });
  refuse_json("[]", { "no wireframe" });
  refuse_json("{}", { "no wireframe" });
  refuse_json(json("\"wireframe\"", "\"mesh\""), { "no wireframe" });
  refuse_json(json("\"version\":1", "\"version\":2"), { "version 2", "version 1" });
  refuse_json(json("\"version\":1", "\"version\":\"1\""), { "version" });
  refuse_json(json("\"version\":1,", ""), { "version" });
  refuse_json(json("\"sampling_distance\":0.5,", ""), { "sampling_distance", "missing" });
  refuse_json(json("0.5,", "null,"), { "sampling_distance", "null" });
  refuse_json(json("0.5,", "-0.5,"), { "sampling distance", "-0.5" });
  refuse_json(json("0.5,", "1e999,"), { "JSON" });
  refuse_json(json("\"vertices\":", "\"points\":"), { "vertices", "missing" });
  refuse_json(json("[[0,0,0],[1,0,0]],\"curves", "[[0,0,0],[1,0]],\"curves"), { "vertices", "index 1" });
  refuse_json(json("[[0,0,0],[1,0,0]],\"curves", "[[0,0,null],[1,0,0]],\"curves"), { "vertices", "index 0" });
  refuse_json(json("[[0,0,0],[1,0,0]],\"curves", "[3],\"curves"), { "vertices", "index 0" });
  refuse_json(json("\"curves\":", "\"edges\":"), { "curves", "missing" });
  refuse_json("{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":1,\"vertices\":[],"
              "\"curves\":{}}",
              { "curves", "array" });
  refuse_json("{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":1,\"vertices\":[],"
              "\"curves\":[1]}",
              { "curve 0", "object" });
}

void test_json_curves()
{
  refuse_json(json("\"bspline\"", "\"helix\""), { "curve 1", "helix", "elliptic_arc" });
  refuse_json(json("\"type\":\"bspline\",", ""), { "curve 1", "type", "missing" });
  refuse_json(json("\"closed\":false", "\"closed\":0"), { "curve 0", "closed" });
  refuse_json(json("\"source\":1", "\"source\":2"), { "curve 1", "vertex 2", "2 vertices" });
  refuse_json(json("\"source\":1", "\"source\":-1"), { "curve 1", "source", "-1" });
  refuse_json(json("\"source\":1", "\"source\":1.5"), { "curve 1", "source", "1.5" });
  refuse_json(json("\"source\":1", "\"source\":18446744073709551615"), { "curve 1", "source" });
  refuse_json(json("\"source\":1", "\"source\":null"), { "curve 1", "open" });
  refuse_json(json("\"target\":0,", ""), { "curve 1", "open" });
  refuse_json(json("\"closed\":false", "\"closed\":true"), { "curve 0", "closed", "differ" });
  refuse_json(json("\"degree\":2", "\"degree\":0"), { "curve 1", "degree" });
  refuse_json(json("\"degree\":2", "\"degree\":3"), { "curve 1", "knots", "8", "7" });
  refuse_json(json("\"degree\":2", "\"degree\":4"), { "curve 1", "degree 4" });
  refuse_json(json("\"degree\":2", "\"degree\":18446744073709551615"), { "curve 1", "18446744073709551615" });
  refuse_json(json("\"degree\":2", "\"degree\":\"2\""), { "curve 1", "degree" });
  refuse_json(json("\"degree\":2,", ""), { "curve 1", "degree", "missing" });
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,1,1,1]"), { "curve 1", "knots", "7", "6" });
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,2,1,1,1]"), { "curve 1", "Knot 4" });
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,null,1,1,1]"), { "curve 1", "knots", "index 3", "null" });
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0,0,0,0,0,0]"), { "curve 1", "knots" });
  refuse_json(json("[0,0,0,0.5,1,1,1]", "[0,0.1,0.2,0.5,1,1,1]"), { "curve 1", "clamped", "3 times" });
  refuse_json(json("[0,0,0,0.5,1,1,1]", "7"), { "curve 1", "knots", "array" });
  refuse_json(json("[1,1,0],", ""), { "curve 1", "knots" });
  refuse_json(json("[1,1,0],", "[1,1,0,0],"), { "curve 1", "control_points", "index 1" });
  refuse_json(json("[1,1,0],", "[1,1,\"0\"],"), { "curve 1", "control_points", "index 1" });
  refuse_json(json("[1,1,0],[0,1,0],[0,0,0]", "[1,1,0],[0,1,0],[0,0,1]"), { "curve 1", "end at its target" });
  refuse_json(json("[[1,0,0],[1,1,0]", "[[2,0,0],[1,1,0]"), { "curve 1", "start at its source" });
  refuse_json(json("\"closed\":false,\"source\":1,\"target\":0", "\"closed\":true"),
              { "curve 1", "closed", "where it starts" });
  refuse_json(json("[1,2,3,4]", "[1,2,3]"), { "curve 1", "weights", "3", "4" });
  refuse_json(json("[1,2,3,4]", "[1,2,3,0]"), { "curve 1", "Weight 3" });
  refuse_json(json("[1,2,3,4]", "[]"), { "curve 1", "weights", "empty" });
  refuse_json(json("\"rms\":0.3", "\"rms\":null"), { "curve 1", "rms", "null" });
  refuse_json(json("\"max\":0.4", "\"max\":-0.4"), { "curve 1", "residual" });
  refuse_json(json("\"support\":30", "\"support\":-1"), { "curve 1", "support", "-1" });

  Wireframe wireframe;
  std::string error;
  assert(!CGAL::IO::read_wireframe_json("io_bad_none.json", wireframe, parameters::error_message(&error)));
  check_words(error, { "io_bad_none.json", "cannot be opened" });
  assert(!CGAL::IO::read_wireframe_json(".", wireframe, parameters::error_message(&error)));
  check_words(error, { "is a directory" });
}

std::set<std::string> files_of(const std::string& directory)
{
  std::set<std::string> names;
  for(const fs::directory_entry& entry : fs::directory_iterator(directory))
    names.insert(entry.path().filename().string());
  return names;
}

// refused by every writer, before a byte is out, and a file that was there stays
void refuse_to_write(const Wireframe& wireframe, const Words& words)
{
  std::string error;
  fs::create_directory("io_bad_output");
  for(const char* const suffix : { ".json", ".obj", ".ply", ".polylines.txt", ".cgal" })
  {
    const std::string name = std::string("io_bad_output/x") + suffix;
    assert(!CGAL::IO::write_wireframe(name, wireframe, parameters::error_message(&error)));
    check_words(error, words);
    check_words(error, { name });
    assert(files_of("io_bad_output").empty());
    std::ofstream(name) << "old";
    assert(!CGAL::IO::write_wireframe(name, wireframe));
    std::ifstream stream(name);
    assert(std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()) == "old");
    assert(files_of("io_bad_output").size() == 1);
    fs::remove(name);
  }
  fs::remove_all("io_bad_output");
  std::ostringstream stream;
  assert(!CGAL::IO::write_wireframe_json(stream, wireframe));
  assert(!CGAL::IO::write_wireframe_obj(stream, wireframe));
  assert(!CGAL::IO::write_wireframe_ply(stream, wireframe));
  assert(!CGAL::IO::write_wireframe_polylines(stream, wireframe));
  assert(stream.str().empty());
}

Wireframe valid_wireframe()
{
  std::istringstream stream(json());
  Wireframe wireframe;
  assert(CGAL::IO::read_wireframe_json(stream, wireframe));
  return wireframe;
}

void test_bad_wireframes()
{
  const double nan = std::nan(""), infinity = HUGE_VAL;
  Wireframe wireframe = valid_wireframe();
  wireframe.sampling_distance = nan;
  refuse_to_write(wireframe, { "sampling distance", "nan" });
  wireframe = valid_wireframe();
  wireframe.vertices[1] = Point(1, infinity, 0);
  refuse_to_write(wireframe, { "vertex 1", "not finite" });
  wireframe = valid_wireframe();
  wireframe.curves[1].root_mean_square = nan;
  refuse_to_write(wireframe, { "curve 1", "residual" });
  wireframe = valid_wireframe();
  wireframe.curves[0].maximum_deviation = infinity;
  refuse_to_write(wireframe, { "curve 0", "residual" });
  wireframe = valid_wireframe();
  wireframe.curves[1].source = 5;
  refuse_to_write(wireframe, { "curve 1", "vertex 5", "2 vertices" });
  wireframe = valid_wireframe();
  wireframe.curves[1].source = Curve::no_vertex;
  refuse_to_write(wireframe, { "curve 1", "open" });
  wireframe = valid_wireframe();
  wireframe.vertices[1] = Point(2, 0, 0);
  refuse_to_write(wireframe, { "curve 0", "end at its target" });
  wireframe = valid_wireframe();
  wireframe.curves[1].spline = Curve::Spline();
  refuse_to_write(wireframe, { "curve 1", "degree" });
}

void test_bad_steps()
{
  const Wireframe wireframe = valid_wireframe();
  for(const double step : { 0., -1., HUGE_VAL, std::nan(""), 1e-12 })
  {
    std::string error;
    std::ostringstream stream;
    assert(!CGAL::IO::write_wireframe_obj(stream, wireframe,
                                          parameters::sampling_step(step).error_message(&error)));
    check_words(error, { "sampling_step" });
    assert(stream.str().empty());
  }
}

void refuse_target(const std::string& name, const Words& words)
{
  std::string error;
  assert(!CGAL::IO::write_wireframe(name, valid_wireframe(), parameters::error_message(&error)));
  check_words(error, words);
}

void test_bad_targets()
{
  const std::set<std::string> before = files_of(".");
  refuse_target("", { "extension" });
  refuse_target("io_bad.xyz", { "io_bad.xyz", "unknown extension \".xyz\"", ".json", ".dxf", ".obj", ".ply", ".txt",
                                ".cgal" });
  for(const std::string name : { "io_bad.step", "io_bad.stp", "io_bad.iges", "io_bad.igs", "io_bad.brep" })
    refuse_target(name, { name, "OpenCASCADE", "libocct-data-exchange-dev" }); // this test is built without
  refuse_target("io_bad_none/x.json", { "io_bad_none/x.json", "cannot be written", "directory" });
  assert(files_of(".") == before);
  fs::create_directory("io_bad_directory.obj");
  refuse_target("io_bad_directory.obj", { "is a directory" });
  assert(files_of("io_bad_directory.obj").empty());
  fs::remove("io_bad_directory.obj");
  {
    const Test_file file(".json", "old");
    refuse_target(file.name + "/x.ply", { file.name, "cannot be written" });
  }

  // protection counts for everyone but the superuser
  fs::create_directory("io_bad_protected");
  std::ofstream("io_bad_protected/old.json") << "old";
  fs::permissions("io_bad_protected/old.json", fs::perms::owner_read);
  fs::permissions("io_bad_protected", fs::perms::owner_read | fs::perms::owner_exec);
  if(!std::ofstream("io_bad_protected/probe"))
  {
    refuse_target("io_bad_protected/new.json", { "cannot be written", "directory" });
    refuse_target("io_bad_protected/old.json", { "cannot be overwritten" });
    assert(files_of("io_bad_protected").size() == 1);
  }
  fs::permissions("io_bad_protected", fs::perms::owner_all);
  fs::remove_all("io_bad_protected");
  assert(files_of(".") == before);
}

struct Full_buffer : std::streambuf
{
  int_type overflow(int_type) override { return traits_type::eof(); }
};

void test_full_disk()
{
  const Wireframe wireframe = valid_wireframe();
  std::string error;
  Full_buffer buffer;
  std::ostream stream(&buffer);
  assert(!CGAL::IO::write_wireframe_json(stream, wireframe, parameters::error_message(&error)));
  check_words(error, { "does not take the data" });
  if(fs::is_character_file("/dev/full"))
  {
    assert(!CGAL::IO::write_wireframe_json("/dev/full", wireframe, parameters::error_message(&error)));
    check_words(error, { "/dev/full", "cannot be written completely", "full" });
  }
  if(fs::is_character_file("/dev/null"))
  {
    assert(CGAL::IO::write_wireframe_obj("/dev/null", wireframe));
    assert(fs::is_character_file("/dev/null"));
  }
}

// what fails in the middle of writing leaves nothing, however it fails
void test_failing_writer()
{
  namespace internal = CGAL::IO::internal;
  const std::set<std::string> before = files_of(".");
  std::string error;
  assert(!internal::write_beside_and_rename("io_bad.out", [](std::ostream& stream, std::string& reason)
  {
    stream << "half of it";
    reason = "the rest is missing";
    return false;
  }, error));
  check_words(error, { "io_bad.out: the rest is missing" });
  assert(!internal::write_beside_and_rename("io_bad.out", [](std::ostream& stream, std::string&)
  {
    stream.setstate(std::ios::badbit);
    return true;
  }, error));
  check_words(error, { "io_bad.out: cannot be written completely" });
  bool is_caught = false;
  try
  {
    internal::write_beside_and_rename("io_bad.out", [](std::ostream&, std::string&) -> bool
    {
      throw std::runtime_error("stop");
    }, error);
  }
  catch(const std::runtime_error&)
  {
    is_caught = true;
  }
  assert(is_caught && files_of(".") == before);

  // somebody else's file is not touched
  const Test_file other(".out.partial0", "mine"), target(".out", "old");
  assert(internal::write_beside_and_rename(target.name, [](std::ostream& stream, std::string&)
  {
    stream << "new";
    return true;
  }, error));
  std::ifstream other_stream(other.name), target_stream(target.name);
  std::string other_text, target_text;
  other_stream >> other_text;
  target_stream >> target_text;
  assert(error.empty() && other_text == "mine" && target_text == "new");
}

int main()
{
  const std::set<std::string> before = files_of(".");
  test_files();
  test_ply_headers();
  test_ply_properties();
  test_ply_ascii_bodies();
  test_ply_binary_bodies();
  test_promises();
  test_text();
  test_values();
  test_separate_distances();
  test_json_documents();
  test_json_curves();
  test_bad_wireframes();
  test_bad_steps();
  test_bad_targets();
  test_full_disk();
  test_failing_writer();
  assert(files_of(".") == before);
  return 0;
}
