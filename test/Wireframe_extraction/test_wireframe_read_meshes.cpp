// Meshes of all formats, and files that hold none.

#include "Comma_locale.h"
#include "check_words.h"
#include "sample_meshes.h"
#include "scratch_files.h"

#include <CGAL/Wireframe_extraction/IO/read_mesh.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Simple_cartesian.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef std::vector<std::vector<std::size_t>> Polygons;

Sample_mesh read(const Test_file& file)
{
  Sample_mesh mesh;
  std::string error;
  if (!CGAL::IO::read_mesh(file.name, mesh.points, mesh.polygons, parameters::error_message(&error)))
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty());
  return mesh;
}

void refuse(const std::string& suffix, const std::string& content, const Words& words)
{
  const Test_file file(suffix, content);
  std::vector<Point> points = {Point(1, 2, 3)};
  Polygons polygons = {{7}};
  std::string error;
  assert(!CGAL::IO::read_mesh(file.name, points, polygons, parameters::error_message(&error)));
  assert(points.size() == 1 && polygons == Polygons{{7}});
  assert(error.compare(0, file.name.size(), file.name) == 0);
  check_words(error, words);
}

// numbers that float holds exactly
Sample_mesh box() { return prism_mesh(rectangle_outline(2., 1.), 0., 0.75); }

std::string text(const Point& p)
{
  return std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z());
}

std::string ascii_stl(const Sample_mesh& mesh)
{
  std::string result = "solid a part\n";
  for (const auto& face : mesh.polygons)
  {
    result += "  facet normal 0 0 0\r\n    outer loop\r\n";
    for (std::size_t v : face)
      result += "      vertex " + text(mesh.points[v]) + "\r\n";
    result += "    endloop\n  endfacet\n";
  }
  return result + "endsolid a part\n";
}

std::string binary_stl(const Sample_mesh& mesh, const std::string& header = "made by hand")
{
  std::string result = header;
  result.resize(80, ' ');
  append(static_cast<std::uint32_t>(mesh.polygons.size()), false, result);
  for (const auto& face : mesh.polygons)
  {
    for (int i = 0; i < 3; ++i)
      append(0.f, false, result);
    for (std::size_t v : face)
      for (int i = 0; i < 3; ++i)
        append(static_cast<float>(mesh.points[v][i]), false, result);
    append(std::uint16_t(0), false, result);
  }
  return result;
}

std::string off(const Sample_mesh& mesh)
{
  std::string result =
    "OFF # a part\n\n" + std::to_string(mesh.points.size()) + " " + std::to_string(mesh.polygons.size()) + " 0\n";
  for (const Point& p : mesh.points)
    result += text(p) + "\n";
  for (const auto& face : mesh.polygons)
  {
    result += std::to_string(face.size());
    for (std::size_t v : face)
      result += " " + std::to_string(v);
    result += " 255 0 0\n"; // a colour
  }
  return result;
}

std::string obj(const Sample_mesh& mesh, bool is_relative)
{
  std::string result = "# a part\nmtllib x.mtl\n";
  for (const Point& p : mesh.points)
    result += "v\t" + text(p) + " 0.5 0.5 0.5\n";
  result += "vn 0 0 1\nvc 1 1 1\nvt 0 0\nl 1 2\n";
  for (const auto& face : mesh.polygons)
  {
    result += "f";
    for (std::size_t v : face)
      result += is_relative ? " -" + std::to_string(mesh.points.size() - v)
                            : "\t" + std::to_string(v + 1)
          + (v % 3 == 0     ? ""
               : v % 3 == 1 ? "/1"
                            : "//1");
    result += " # a face\n";
  }
  return result;
}

std::string ply_header(const std::string& format, std::size_t vertices, std::size_t faces, const std::string& list)
{
  return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices)
    + "\nproperty double x\nproperty float y\nproperty uchar red\nproperty float z\nelement face "
    + std::to_string(faces) + "\nproperty int material\nproperty list " + list + "\nend_header\n";
}

std::string ascii_ply(const Sample_mesh& mesh)
{
  std::string result = ply_header("ascii", mesh.points.size(), mesh.polygons.size(), "uchar int vertex_indices");
  for (const Point& p : mesh.points)
    result += std::to_string(p.x()) + " " + std::to_string(p.y()) + " 255 " + std::to_string(p.z()) + "\n";
  for (const auto& face : mesh.polygons)
  {
    result += "3 " + std::to_string(face.size());
    for (std::size_t v : face)
      result += " " + std::to_string(v);
    result += "\n";
  }
  return result;
}

template <class Count, class Index>
std::string binary_ply(const Sample_mesh& mesh, bool is_big, const std::string& types)
{
  std::string result = ply_header(is_big ? "binary_big_endian" : "binary_little_endian", mesh.points.size(),
                                  mesh.polygons.size(), types + " vertex_index");
  for (const Point& p : mesh.points)
  {
    append(p.x(), is_big, result);
    append(static_cast<float>(p.y()), is_big, result);
    append(std::uint8_t(7), is_big, result);
    append(static_cast<float>(p.z()), is_big, result);
  }
  for (const auto& face : mesh.polygons)
  {
    append(std::int32_t(3), is_big, result);
    append(static_cast<Count>(face.size()), is_big, result);
    for (std::size_t v : face)
      append(static_cast<Index>(v), is_big, result);
  }
  return result;
}

void check_same(const Sample_mesh& mesh, const Sample_mesh& expected)
{
  assert(mesh.points == expected.points && mesh.polygons == expected.polygons);
}

void test_formats()
{
  const Sample_mesh mesh = box(), triangles = mesh.triangulated();
  check_same(read(Test_file(".stl", ascii_stl(triangles))), triangles.exploded());
  check_same(read(Test_file(".STL", binary_stl(triangles))), triangles.exploded());
  check_same(read(Test_file(".stl", binary_stl(triangles, "solid though binary"))), triangles.exploded());
  check_same(read(Test_file(".off", off(mesh))), mesh);
  check_same(read(Test_file(".obj", obj(mesh, false))), mesh);
  check_same(read(Test_file(".obj", obj(mesh, true))), mesh);
  check_same(read(Test_file(".ply", ascii_ply(mesh))), mesh);
  check_same(read(Test_file(".ply", binary_ply<std::uint8_t, std::int32_t>(mesh, false, "uchar int"))), mesh);
  check_same(read(Test_file(".ply", binary_ply<std::uint32_t, std::uint16_t>(mesh, true, "uint ushort"))), mesh);
}

void test_bad_stl()
{
  const Sample_mesh mesh = box().triangulated();
  refuse(".stl", "", {"is empty", "get a complete copy"});
  refuse(".stl", "so", {"no STL file"});
  refuse(".stl", std::string("\0\1\2", 3), {"no STL file"});
  refuse(".stl", "solid\nendsolid\n", {"holds no faces"});
  const std::string ascii = ascii_stl(mesh), binary = binary_stl(mesh);
  refuse(".stl", ascii.substr(0, ascii.size() - 16), {"truncated", "after 12 facets", "endsolid"});
  refuse(".stl", ascii.substr(0, ascii.size() / 2), {"scratch.stl"});
  refuse(".stl", "solid\nfacet\nouter loop\nvertex 0 0\n", {":4:", "only 2 values"});
  refuse(".stl", "solid\nfacet\nouter loop\nvertex 0 0 far\n", {":4:", "\"far\", no number"});
  refuse(".stl", "solid\nfacet\nouter loop\nvertex 0 0 0,5\n", {":4:", "not a comma"});
  refuse(".stl", "solid\nfacet\nouter loop\nvertex 0 0 nan\n", {":4:", "vertex 0", "finite"});
  refuse(".stl", "solid\nfacet\nvertex 0 0 1\nendfacet\n", {":4:", "1 vertex", "three are needed"});
  refuse(".stl", "solid\nendfacet\n", {":2:", "without \"facet\""});
  refuse(".stl", "solid\ncolour red\n", {":2:", "\"colour\""});
  refuse(".stl", binary.substr(0, binary.size() - 1), {"12 facets = 684 bytes", "683", "truncated"});
  refuse(".stl", binary + "more", {"12 facets", "688"});
  std::string wrong = binary;
  for (std::size_t i = 80; i < 84; ++i)
    wrong[i] = '\xff';
  refuse(".stl", wrong, {"4294967295 facets", "truncated or its header is wrong"});
  Sample_mesh infinite = mesh;
  infinite.points[2] = Point(0., std::numeric_limits<double>::infinity(), 0.);
  refuse(".stl", binary_stl(infinite), {"finite", "inf"});
}

void test_bad_obj_and_off()
{
  refuse(".obj", "", {"is empty"});
  refuse(".obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", {"3 vertices and no faces", "cloud of points", ".xyz"});
  refuse(".obj", "# nothing\n", {"holds no faces"});
  refuse(".obj", "v 0 0\n", {":1:", "only 2 values"});
  refuse(".obj", "v 0 0 x\n", {":1:", "\"x\", no number"});
  refuse(".obj", "v 0 0 inf\n", {":1:", "finite"});
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  refuse(".obj", vertices + "f 1 2\n", {":4:", "2 vertices"});
  refuse(".obj", vertices + "f 1 2 b\n", {":4:", "the numbers of its vertices"});
  refuse(".obj", vertices + "f 1 2 0\n", {":4:", "the first has the number 1"});
  refuse(".obj", vertices + "f 1 2 -4\n", {":4:", "before the first"});
  refuse(".obj", vertices + "f 1 2 4\n", {":4:", "vertex 3", "only 3"});
  refuse(".obj", vertices + "f 1 2 99999999999999999999\n", {":4:"});
  refuse(".obj", vertices + "f 1 2 \\\n3\n", {":4:", "goes on"});
  std::string many = "f";
  for (int i = 0; i < 10001; ++i)
    many += " 1";
  refuse(".obj", vertices + many + "\n", {":4:", "10001 vertices", "triangulate"});

  refuse(".off", "ply\n", {":1:", "\"ply\""});
  refuse(".off", "OFF BINARY\n", {":1:", "binary"});
  refuse(".off", "OFF\n3 x 0\n", {":2:", "numbers of vertices, faces"});
  refuse(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", {"truncated", "after 2 of 3 vertices"});
  refuse(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", {"truncated", "after 0 of 1 faces"});
  refuse(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", {":6:", "the numbers of its vertices"});
  refuse(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", {":6:", "vertex 3", "only 3"});
  refuse(".off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n99999999999 0 1 2\n", {":6:"});
  refuse(".off", "OFF\n1000000000000 1 0\n0 0 0\n", {"after 1 of 1000000000000"});
  refuse(".off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", {"3 vertices and no faces"});
}

void test_bad_ply()
{
  const Sample_mesh mesh = box();
  const std::string ascii = ascii_ply(mesh), binary = binary_ply<std::uint32_t, std::int32_t>(mesh, false, "uint int");
  refuse(".ply", "plx\n", {":1:", "\"ply\""});
  refuse(".ply", ascii.substr(0, ascii.size() - 4), {":25:", "shorter than it says"});
  refuse(".ply", binary.substr(0, binary.size() - 1), {"truncated", "after 5 of 6", "\"face\""});
  std::string huge = binary;
  huge.replace(huge.size() - 20, 4, "\xff\xff\xff\x7f"); // the number of vertices of the last face
  refuse(".ply", huge, {"claims to have 2147483647 entries"});
  std::string far = binary;
  far.replace(far.size() - 4, 4, std::string("\x09\0\0\0", 4));
  refuse(".ply", far, {"face 5", "vertex 9", "only 8"});
  far.replace(far.size() - 4, 4, "\xff\xff\xff\xff");
  refuse(".ply", far, {"face 5", "vertex -1"});
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty ";
  refuse(".ply", vertices + "float w\nend_header\n0 0 0\n1 0 0\n0 1 0\n", {"no property \"z\"", "x, y, w"});
  refuse(".ply", vertices + "float z\nend_header\n0 0 0\n1 0 0\n0 1 0\n", {"3 vertices and no faces"});
  refuse(".ply",
         vertices + "float z\nelement face 1\nproperty list uchar int corners\nend_header\n0 0 0\n1 0 0\n0 1 0\n",
         {"vertex_indices", "corners"});
  refuse(
    ".ply",
    vertices
      + "float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n",
    {":13:", "1.5"});
  refuse(".ply",
         vertices
           + "float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 2\n",
         {":13:", "1 vertex"});
}

int main()
{
  test_formats();
  test_bad_stl();
  test_bad_obj_and_off();
  test_bad_ply();
  refuse(".xyz", "0 0 0\n", {"unknown extension \".xyz\"", ".stl .obj .off .ply"});
  std::vector<Point> points;
  Polygons polygons;
  std::string error;
  assert(!CGAL::IO::read_mesh("nowhere.stl", points, polygons, parameters::error_message(&error)));
  check_words(error, {"nowhere.stl", "check its name"});
  const std::string stl = ascii_stl(box().triangulated()); // whose numbers have points
  const Comma_locale locale;
  check_same(read(Test_file(".stl", stl)), box().triangulated().exploded());
  return 0;
}
