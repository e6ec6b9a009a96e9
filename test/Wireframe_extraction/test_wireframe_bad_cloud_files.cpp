// Files of clouds that are refused, and what is said.

#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>

#include "check_words.h"
#include "scratch_files.h"

#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Simple_cartesian.h>

#include <cassert>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;

void refuse_name(const std::string& name, const Words& words, const std::string& distance_property = "")
{
  const Cloud before = {{Point(1, 2, 3), 4}};
  Cloud cloud = before;
  std::string error;
  std::size_t number_of_skipped = 99;
  assert(!CGAL::IO::read_distance_cloud(
    name, cloud,
    parameters::error_message(&error).distance_property(distance_property).number_of_skipped(&number_of_skipped)));
  assert(cloud == before && number_of_skipped == 0);
  check_words(error, words);
  assert(error.find("field_origin") == std::string::npos); // which is no parameter of this function
  // nobody has to ask for the message
  assert(!CGAL::IO::read_distance_cloud(name, cloud, parameters::distance_property(distance_property)));
}

void refuse(const std::string& suffix, const std::string& content, const Words& words,
            const std::string& distance_property = "")
{
  const Test_file file(suffix, content);
  refuse_name(file.name, words, distance_property);
  refuse_name(file.name, {file.name}, distance_property);
}

void refuse_pair(const std::string& suffix, const std::string& content, const std::string& distances,
                 const Words& words)
{
  const Test_file file(suffix, content), distances_file("_distances.dat", distances);
  Cloud cloud;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, distances_file.name, cloud, parameters::error_message(&error)));
  assert(cloud.empty());
  check_words(error, words);
}

void test_files()
{
  for (const char* const suffix : {".ply", ".xyz", ".csv", ".pcd", ".npy", ".off"})
    refuse(suffix, "\x1f\x8b\x08 and more", {"compressed by gzip", "gunzip"});
  refuse_name("io_bad_none.ply", {"io_bad_none.ply", "cannot be opened", "No such file", "check its name"});
  refuse_name("io_bad_none/x.xyz", {"io_bad_none/x.xyz", "cannot be opened"});
  refuse_name("", {"extension"});
  refuse_name("io_bad_none", {"unknown extension", ".ply", ".xyz", ".txt", ".csv", ".asc", ".pts"});
  refuse(".stl", "solid", {"unknown extension \".stl\""});
  for (const char* const suffix : {".ply", ".xyz", ".txt", ".csv", ".asc", ".pts"})
  {
    refuse(suffix, "", {"is empty", "get a complete copy"});
    const std::string name = std::string("io_bad_directory") + suffix;
    fs::create_directory(name);
    refuse_name(name, {name, "is a directory", "name a file in it"});
    fs::remove(name);
  }
}

std::string header(const std::string& format, const std::string& count = "2", const std::string& type = "float")
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + count + "\nproperty " + type + " x\nproperty " + type
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
  refuse(".ply", "1 2 3 4\n5 6 7 8\n", {":1:", "\"ply\"", "\"1 2 3 4\""});
  refuse(".ply", "ply\n", {"end_header", "truncated"});
  refuse(".ply", header("ascii"), {"end_header", "truncated"});
  refuse(".ply", header("text") + end, {":2:", "\"text\"", "ascii, binary_little_endian, binary_big_endian"});
  refuse(".ply", "ply\nelement vertex 1\nproperty float x\n" + end, {"format"});
  refuse(".ply", header("ascii", "-1") + end, {":3:", "\"-1\"", "number of vertex"});
  refuse(".ply", header("ascii", "many") + end, {":3:", "\"many\""});
  refuse(".ply", header("ascii", "1e3") + end, {":3:", "\"1e3\""});
  refuse(".ply", header("ascii", "99999999999999999999999") + end, {":3:", "99999999999999999999999"});
  refuse(".ply", header("ascii", "2", "real") + end, {":4:", "\"real\""});
  refuse(".ply", header("ascii", "2 3") + end, {":3:", "element NAME COUNT"});
  refuse(".ply", "ply\nformat ascii 1.0\nproperty float x\n" + end, {":3:", "before the first element"});
  refuse(".ply", header("ascii") + "property float\n" + end, {":8:", "property TYPE NAME"});
  refuse(".ply", header("ascii") + "property list float int ids\n" + end, {":8:", "counted", "float"});
  refuse(".ply", header("ascii") + "property float x\n" + end, {":8:", "\"x\"", "twice"});
  refuse(".ply", header("ascii") + "element vertex 2\n" + end, {":8:", "\"vertex\"", "twice"});
  refuse(".ply", header("ascii") + "solid\x01 7\n" + end, {":8:", "\"solid?\""});
  refuse(".ply", "ply\nformat ascii 1.0\nelement point 1\nproperty float x\n" + end,
         {"no element \"vertex\"", "point"});
  refuse(".ply", "ply\nformat ascii 1.0\n" + end, {"no element \"vertex\"", "(none)"});
  refuse(".ply", "ply\n" + std::string(3000000, 'x'), {"end_header"});
}

void test_ply_properties()
{
  const auto ply = [](const std::string& properties) {
    return "ply\nformat ascii 1.0\nelement vertex 1\n" + properties + "end_header\n1 2 3 4\n";
  };
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  refuse(".ply", ply("property float x\nproperty float y\nproperty float distance\n"),
         {"no property \"z\"", "they have: x, y, distance"});
  refuse(".ply", ply(xyz + "property float nx\n"),
         {"for the distance", "sharpness", "they have: x, y, z, nx", "distance_property", "separate file"});
  refuse(".ply", ply(xyz + "property float distance\n"), {"no property \"own\"", "they have: x, y, z, distance"},
         "own");
  refuse(".ply", ply(xyz + "property list uchar float distance\n"), {"\"distance\"", "list"});
  refuse(".ply",
         ply("property list uchar float x\nproperty float y\nproperty float z\n"
             "property float distance\n"),
         {"\"x\"", "list"});
}

void test_ply_ascii_bodies()
{
  const std::string start = header("ascii") + "end_header\n";
  refuse(".ply", header("ascii", "0") + "end_header\n", {"holds no points"});
  refuse(".ply", start, {"truncated", "after 0 of 2 vertices"});
  refuse(".ply", start + "1 2 3 4\n", {"truncated", "after 1 of 2 vertices"});
  refuse(".ply", start + "1 2 3 4\n5 6", {":10:", "2 values", "4 properties"});
  refuse(".ply", start + "1 2 3 4\n5 6 7 8 9\n", {":10:", "5 values", "more than"});
  refuse(".ply", start + "1 2 3 4\n5 6 seven 8\n", {":10:", "\"seven\"", "\"z\""});
  refuse(".ply", start + "1 2 3 4\n5,6,7,8\n", {":10:", "\"5,6,7,8\""});
  refuse(".ply", start + "1 2 3 4\n5 6 0x7 8\n", {":10:", "\"0x7\""});
  refuse(".ply", start + "1 2 3 4\n5 6 7 8\n9 9 9 9\n", {"more than the 2 vertices"});
  refuse(".ply", start + "1 2 3 4\n" + std::string(3000000, '1'), {":10:", "too long"});
  refuse(".ply", header("ascii", "1000000000000") + "end_header\n1 2 3 4\n", {"after 1 of 1000000000000 vertices"});
  const std::string with_list = header("ascii", "1") + "property list uchar int ids\nend_header\n";
  refuse(".ply", with_list + "1 2 3 4 3 0 1\n", {":10:", "\"ids\"", "shorter"});
  refuse(".ply", with_list + "1 2 3 4 -1\n", {":10:", "\"-1\"", "\"ids\""});
  refuse(".ply", with_list + "1 2 3 4\n", {":10:", "4 values"});
  refuse(".ply", header_with("element face 3\nproperty list uchar int ids\n", "ascii") + "end_header\n3 0 1 2\n",
         {"truncated", "\"face\"", "before the vertices"});
}

void test_ply_binary_bodies()
{
  for (const char* const format : {"binary_little_endian", "binary_big_endian"})
  {
    const std::string start = header(format) + "end_header\n";
    refuse(".ply", header(format, "0") + "end_header\n", {"holds no points"});
    refuse(".ply", start, {"header promises 2 vertices = 32 bytes", "the file has 0", "0 of 2", "truncated"});
    refuse(".ply", start + std::string(31, '\0'),
           {"header promises 2 vertices = 32 bytes", "the file has 31", "1 of 2", "truncated"});
    refuse(".ply", start + std::string(48, '\0'), {"more than the 2 vertices"});
    const std::string face = header_with("element face 1\nproperty list int int ids\n", format, "1") + "end_header\n";
    refuse(".ply", face + std::string(4, '\xff') + std::string(16, '\0'), {"\"ids\"", "-1", "damaged"});
    refuse(".ply", face + std::string(4, '\x7f') + std::string(16, '\0'),
           {"truncated", "\"face\"", "before the vertices"});
    refuse(".ply", face + std::string(4, '\0'), {"promises 1 vertices", "truncated"});
    const std::string list = header(format) + "property list int double ids\nend_header\n";
    refuse(".ply", list + std::string(20, '\0') + std::string(16, '\0') + std::string(4, '\x01'),
           {"truncated", "after 1 of 2 vertices"});
  }
}

// neither time nor memory goes to what only the header has
void test_promises()
{
  const auto begin = std::chrono::steady_clock::now();
  for (const char* const format : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const char* const count : {"1000000000000", "18446744073709551615"})
    {
      const std::string content = "1 2 3 4\n5 6 7 8\n";
      refuse(".ply", header(format, count) + "end_header\n" + content, {std::string(count) + " vertices", "truncated"});
      refuse(
        ".ply",
        header_with(std::string("element other ") + count + "\nproperty double a\nproperty list uchar int b\n", format)
          + "end_header\n" + content,
        {"\"other\""});
      refuse(".ply", header(format, count) + "property list uint8 int ids\nend_header\n1 2 3 4 0\n5 6 7 8 0\n",
             {std::string(count) + " vertices", "truncated"});
    }
  refuse(".ply", header("binary_little_endian", "1000000000000") + "end_header\n",
         {"header promises 1000000000000 vertices = 16000000000000 bytes, the file has 0"});
  assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
}

void test_text()
{
  refuse(".xyz", "\n \n", {"holds no points", "write the cloud"});
  refuse(".xyz", "# nothing\n", {"holds no points"});
  refuse(".csv", "x,y,z,distance\n", {"holds no points"});
  refuse(".xyz", "1 2 3\n4 5 6\n", {":1:", "3 columns", "x y z distance", "separate file"});
  refuse(".xyz", "1 2 3 4\n5 6 7\n", {":2:", "3 columns", "4"});
  refuse(".xyz", "1 2 3 4\n\n# c\n5 6 7 8 9\n", {":4:", "5 columns", "4"});
  refuse(".xyz", "1 2 3 4\n5 6 7 eight\n",
         {":2:", "column 4", "\"eight\", no number", "write a number there", "leave the line out"});
  refuse(".csv", "1,2,3,4\n5,,7,8\n", {":2:", "column 2", "empty"});
  refuse(".csv", "1,5;2,5;3,5;4,5\n", {":1:", "\"1,5\"", "point, not a comma"});
  refuse(".csv", "1,5 2,5 3,5 4,5\n", {":1:", "decimals need a point, not a comma"});
  refuse(".xyz", "0,0 1,0 2,0 0,5\n", {":1:", "decimals need a point, not a comma"});
  refuse(".xyz", "1,5\t2 3 4\n", {":1:", "decimals need a point, not a comma"});
  refuse(".ply", header("ascii") + "end_header\n1 2 3 4\n5,1 6 7 8\n", {":10:", "\"5,1\"", "point, not a comma"});
  refuse(".csv", "1 2 3 4\n1,5 2 3 4\n", {":2:", "\"1,5\"", "point, not a comma"});
  refuse(".csv", "x,y,z,distance\n1,2,3\n", {":2:", "3 columns"});
  refuse(".csv", "x,y,z,distance\n1,2,3,4,5\n", {":2:", "5 columns", "names has 4"});
  refuse(".csv", "x,y,z,distance\nx,y,z,distance\n1,2,3,4\n", {":2:", "\"x\""});
  refuse(".csv", "x,y,h,distance\n1,2,3,4\n", {"x, y and z", "x, y, h, distance"});
  refuse(".csv", "east,north,up,far\n1,2,3,0.5\n",
         {"x, y and z", "name them", "coordinate_properties", "line of names", "east, north, up, far"});
  refuse(".csv", "\"distance\",\"P:0\",\"P:1\",\"P:2\"\n4,1,2,3\n", {"x, y and z", "distance, P:0, P:1, P:2"});
  refuse(".csv", "x,y,z,nx,d\n1,2,3,4,5\n", {"distance", "x, y, z, nx, d", "distance_property"});
  refuse(".csv", "x,y,z,distance\n1,2,3,4\n", {"\"own\"", "x, y, z, distance"}, "own");
  refuse(".csv", "1,2,3,4\n", {"\"own\"", "without names"}, "own");
  // what other programs write into the fourth column is no distance
  refuse(".csv", "x,y,z,intensity\n1,2,3,4\n", {"named as the distance", "x, y, z, intensity", "distance_property"});
  refuse(".txt", "//X Y Z R G B distance_to_edge\n1 2 3 4 5 6 7\n", {"X, Y, Z, R, G, B, distance_to_edge"});
  // three columns look like a normal or a colour before the distance; the first rows need not tell
  const std::string normals = "1 2 3 0 0 1 0\n", colours = "1 2 3 20 30 255 9\n";
  for (const std::string& row : {std::string("0 0 0 0.6 0 -0.8\n"), std::string("0 0 0 0 0 1 0.5\n"),
                                 "0 0 0 0 0 0 1\n" + normals + normals, "0 0 0 nan nan nan 1\n" + normals, colours})
  {
    refuse(".xyz", row, {":1:", "columns without names", "distance_property", "line of names"});
    refuse(".xyz", row, {":1:", "\"3\"", "from 4 to", "distance_property"}, "3");
    refuse(".xyz", row, {":1:", "\"8\"", "from 4 to", "distance_property"}, "8");
  }
  refuse(".pts", "3\n1 2 3 4\n5 6 7 8\n", {"promises 3", "holds 2", "truncated"});
  refuse(".pts", "3\n3\n1 2 3 4\n", {":2:", "1 column"});
  refuse(".txt", std::string("\x93NUMPY\x01\0\n\0\0\xff", 11), {":1:", "no text"});
  refuse(".txt",
         std::string("\xff\xfe"
                     "1\0 \0"
                     "2\0",
                     8),
         {":1:", "no text"});
  refuse(".txt", std::string(3000000, '7'), {":1:", "text file"});
  refuse(".txt", "1 2 3 4\n" + std::string(3000000, ' '), {":2:", "text file"});
}

void test_values()
{
  refuse(".xyz", "1 2 3 4\n# c\n5 nan 7 8\n5 6 7 inf\n5 6 7 -1\n5 6 7 -1\n",
         {"4 of 5 points", "1 with a coordinate", "1 with a distance", "2 with a negative", "point 1 ", "line 3",
          "5 nan 7", "skip_invalid(true)"});
  refuse(".xyz", "1 2 3 4\n5 6 7 -inf\n", {"1 of 2 points", "point 1 ", "line 2", "-inf"});
  refuse(".xyz", "1 2 3 -0.25\n", {"point 0 ", "-0.25", "negative"});
  refuse(".xyz", "1 2 3 -0.25 1\n", {"line 1", "its distance in column 4 is -0.25"});
  refuse(".csv", "x,y,z,nx,d\n1,2,3,4,-5\n", {"line 2", "its distance in column 5, \"d\", is -5"}, "d");
  refuse(".xyz", "1 1e999 3 0\n", {"point 0 ", "not finite"});
  refuse(".ply", header("ascii") + "end_header\n1 2 3 4\n1 2 3 NaN\n", {"1 of 2 points", "point 1 ", "line 10"});
  for (const std::string& value : Words{"1.#QNAN", "-1.#IND", "1.#INF", "-1.#INF00"})
  {
    refuse(".xyz", "1 2 3 4\n5 6 7 " + value + "\n", {"1 of 2 points", "line 2", "not finite"});
    refuse(".csv", "1,2," + value + ",4\n", {"1 of 1 point", "coordinate that is not finite"});
    refuse(".ply", header("ascii") + "end_header\n1 2 3 4\n1 2 3 " + value + "\n", {"1 of 2 points", "not finite"});
  }
  refuse(".xyz", "1 2 3 1.#X\n", {"\"1.#X\"", "no number"});
  const float values[] = {1, 2, 3, 4, 1, 2, -std::numeric_limits<float>::infinity(), 4};
  refuse(".ply",
         header("binary_little_endian") + "end_header\n"
           + std::string(reinterpret_cast<const char*>(values), sizeof(values)),
         {"1 of 2 points", "point 1 ", "-inf", "skip_invalid"});

  const Test_file file(".xyz", "nan 2 3 4\n1 2 3 -4\n");
  Cloud cloud;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, cloud, parameters::skip_invalid(true).error_message(&error)));
  check_words(error, {file.name, "no point is left", "2 of 2", "point 0 "});
}

void test_separate_distances()
{
  const std::string cloud = "1 2 3\n4 5 6\n";
  refuse_pair(".xyz", cloud, "1\n", {"2 points", "1 distance;", "_distances.dat"});
  refuse_pair(".xyz", cloud, "1\n2\n3\n", {"2 points", "3 distances", "_distances.dat"});
  refuse_pair(".xyz", cloud, "", {"_distances.dat", "is empty"});
  refuse_pair(".xyz", cloud, "# nothing\n", {"_distances.dat", "holds no distances"});
  refuse_pair(".xyz", cloud, "1\ntwo\n", {"_distances.dat:2:", "\"two\"", "write a number there"});
  refuse_pair(".xyz", cloud, "0,5\n1,5\n", {"_distances.dat:1:", "2 columns", "decimals with a point"});
  refuse_pair(".xyz", cloud, "a\nb\n1\n2\n", {"_distances.dat:2:", "\"b\""});
  refuse_pair(".xyz", cloud, "1\n2 3\n", {"_distances.dat:2:", "2 columns"});
  refuse_pair(".xyz", cloud, "1\n\n-2\n", {"point 1 ", "negative", "_distances.dat:3"});
  refuse_pair(".xyz", cloud, "nan\n1\n", {"point 0 ", "nan", "_distances.dat:1"});
  refuse_pair(".xyz", "", "1\n2\n", {".xyz", "is empty"});
  refuse_pair(".xyz", "1 2\n", "1\n", {":1:", "2 columns", "3 (x y z)"});
  refuse_pair(".ply", header("ascii") + "end_header\n1 2 3 4\n5 6 7 8\n", "1\n", {"2 points", "1 distance;"});
  const Test_file file(".xyz", cloud);
  Cloud result;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, "io_bad_none.dat", result, parameters::error_message(&error)));
  check_words(error, {"io_bad_none.dat", "cannot be opened"});
  assert(!CGAL::IO::read_distance_cloud(file.name, ".", result, parameters::error_message(&error)));
  check_words(error, {"is a directory"});
}

int main()
{
  const auto count_files = [] { return std::distance(fs::directory_iterator("."), fs::directory_iterator()); };
  const auto before = count_files();
  test_files();
  test_ply_headers();
  test_ply_properties();
  test_ply_ascii_bodies();
  test_ply_binary_bodies();
  test_promises();
  test_text();
  test_values();
  test_separate_distances();
  assert(count_files() == before);
  return 0;
}
