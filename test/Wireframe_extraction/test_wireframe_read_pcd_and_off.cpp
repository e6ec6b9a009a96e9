// Clouds as PCL writes them, and vertices of meshes.

#include "cloud_file_checks.h"
#include "lzf.h"
#include "numpy_writers.h"

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

namespace fs = std::filesystem;

std::string pcd_header(const std::string& fields, const std::string& sizes, const std::string& types,
                       const std::string& counts, const std::string& number, const std::string& kind)
{
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS " + fields + "\nSIZE " + sizes + "\nTYPE "
    + types + "\nCOUNT " + counts + "\nWIDTH " + number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number
    + "\nDATA " + kind + "\n";
}

void test_pcd()
{
  const Cloud cloud = sample_cloud(5003);
  const std::string n = std::to_string(cloud.size());
  std::string ascii =
    pcd_header("normal x y z quality distance", "4 4 4 4 2 4", "F F F F U F", "3 1 1 1 1 1", n, "ascii");
  std::string binary = pcd_header("x _ y z rgb Distance", "8 1 4 4 4 8", "F U F F U F", "1 3 1 1 1 1", n, "binary");
  for (const auto& sample : cloud)
  {
    const Point& p = sample.first;
    ascii += "0 0 1 " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + " 3 "
      + std::to_string(sample.second) + "\n";
    append(p.x(), false, binary);
    binary += "\n\r\n";
    append(static_cast<float>(p.y()), false, binary);
    append(static_cast<float>(p.z()), false, binary);
    append(std::uint32_t(0xFFFFFFFFu), false, binary);
    append(sample.second, false, binary);
  }
  const Test_file ascii_file("_ascii.pcd", ascii), binary_file("_binary.PCD", binary);
  assert(read(ascii_file.name) == cloud);
  assert(read(binary_file.name) == cloud);
  assert(read(ascii_file.name, {"", "", "quality"})[5].second == 3.);
  const Test_file distances("_distances.npy", npy(std::vector<double>(cloud.size(), 2.), {cloud.size()}));
  assert(read_pair(binary_file.name, distances.name)[9].second == 2.);
  const Test_file no_points(".pcd",
                            "FIELDS x y z distance\nWIDTH 2\nHEIGHT 2\nDATA ascii\n"
                            "0 0 0 0\n1 1 1 1\n2 2 2 2\n3 3 3 3");
  assert(read(no_points.name).size() == 4);

  const auto header = [](const std::string& number, const std::string& kind) {
    return pcd_header("x y z distance", "4 4 4 4", "F F F F", "1 1 1 1", number, kind);
  };
  refuse(".pcd", "", {"is empty", "get a complete copy"});
  refuse(".pcd", "ply\n", {":1:", "\"ply\" starts no PCD file"});
  refuse(".pcd", "VERSION 0.7\nCOLOUR 1\n", {":2:", "\"COLOUR\""});
  refuse(".pcd", "VERSION 0.7\nFIELDS x y z\n", {"truncated", "DATA"});
  refuse(".pcd", "DATA ascii\n", {"no FIELDS"});
  refuse(".pcd", "FIELDS x y z distance\nDATA ascii\n", {"POINTS", "WIDTH"});
  refuse(".pcd", "FIELDS x y z distance\nSIZE 4 4 4\n", {":2:", "SIZE has 3 entries", "FIELDS 4"});
  refuse(".pcd", "FIELDS x y z distance\nSIZE 4 4 4 9\n", {":2:", "\"9\"", "size"});
  refuse(".pcd", "FIELDS x y z distance\nCOUNT 1 1 1 9999999\n", {":2:", "\"9999999\"", "count"});
  refuse(".pcd", "FIELDS x y z distance\nTYPE F F F D\n", {":2:", "\"D\"", "type"});
  refuse(".pcd", "FIELDS x y z distance\nPOINTS many\n", {":2:", "POINTS", "number"});
  refuse(".pcd", "FIELDS x y z distance\nPOINTS 5\nWIDTH 2\nHEIGHT 3\nDATA ascii\n", {"5 POINTS", "WIDTH 2", "3"});
  refuse(".pcd", "FIELDS x y z distance\nWIDTH 18446744073709551615\nHEIGHT 3\nDATA binary\n0123456789abcdef",
         {"promises", "truncated"});
  refuse(".pcd", header("1", "text"), {":11:", "ascii, binary or binary_compressed", "\"text\""});
  refuse(".pcd", header("1", "ascii"), {"truncated", "after 0 of 1 points"});
  refuse(".pcd", header("1", "ascii") + "1 2 3\n", {":12:", "3 values", "4"});
  refuse(".pcd", header("1", "ascii") + "1 2 3 far\n", {":12:", "\"far\""});
  refuse(".pcd", header("1", "ascii") + "1 2 nan 4\n", {"point 0", "line 12", "skip_invalid"});
  refuse(".pcd", header("1", "ascii") + "1 2 3 4\n5 6 7 8\n", {"more than the 1 points"});
  refuse(".pcd", header("0", "ascii"), {"holds no points"});
  refuse(".pcd", header("2", "binary") + std::string(31, '\0'), {"promises 2 points of 16 bytes", "31", "truncated"});
  refuse(".pcd", header("1000000000000", "binary") + std::string(31, '\0'), {"1000000000000", "truncated"});
  refuse(".pcd", header("18446744073709551615", "ascii") + "1 2 3 4\n", {"after 1 of 18446744073709551615"});
  refuse(".pcd", header("1", "binary") + std::string(32, '\1'), {"more than the 1 points"});
  refuse(".pcd", pcd_header("x y z rgb", "4 4 4 4", "F F F U", "1 1 1 1", "1", "ascii") + "1 2 3 4\n",
         {"no field for the distance", "sharpness", "x, y, z, rgb", "distance_property", "separate file"});
  refuse(".pcd", header("1", "ascii") + "1 2 3 4\n", {"no field \"own\"", "x, y, z, distance"}, {"", "", "own"});
  refuse(".pcd", pcd_header("x y distance", "4 4 4", "F F F", "1 1 1", "1", "ascii"), {"no field \"z\""});
  refuse(".pcd", pcd_header("x y z distance", "4 4 4 4", "F F F F", "1 1 1 2", "1", "ascii"),
         {"\"distance\" has 2 numbers"});
  refuse(".pcd", pcd_header("x y z distance", "4 4 4 3", "F F F F", "1 1 1 1", "1", "ascii"),
         {"\"distance\"", "F of size 3"});
  refuse(".pcd", pcd_header("x y z distance", "0 0 0 0", "F F F F", "0 0 0 0", "9", "binary"), {"0 numbers"});
}

// what PCL writes: a block in which each field has all its numbers, one behind the other
std::string compressed(const Cloud& cloud, std::size_t* size_of_block = nullptr)
{
  std::string fields;
  for (const auto& sample : cloud)
    append(static_cast<float>(sample.first.x()), false, fields);
  for (const auto& sample : cloud)
    append(sample.second, false, fields);
  fields += std::string(3 * 4 * cloud.size(), '\7'); // three numbers per point that are not looked at
  for (const auto& sample : cloud)
    append(static_cast<float>(sample.first.y()), false, fields);
  for (const auto& sample : cloud)
    append(static_cast<float>(sample.first.z()), false, fields);
  const std::vector<unsigned char> packed = lzf(reinterpret_cast<const unsigned char*>(fields.data()), fields.size());
  std::string block;
  append(static_cast<std::uint32_t>(packed.size()), false, block);
  append(static_cast<std::uint32_t>(fields.size()), false, block);
  block.append(packed.begin(), packed.end());
  if (size_of_block != nullptr)
    *size_of_block = block.size();
  return pcd_header("x distance normal _ y z", "4 8 4 1 4 4", "F F F U F F", "1 1 3 4 1 1",
                    std::to_string(cloud.size()), "binary_compressed")
    + block;
}

void test_pcd_of_pcl()
{
  const Cloud cloud = sample_cloud(70000); // more than one chunk
  std::size_t size_of_block = 0;
  const std::string good = compressed(cloud, &size_of_block);
  const std::size_t begin = good.size() - size_of_block;
  const Test_file file(".pcd", good), padded("_padded.pcd", good + std::string(5000, '\0'));
  assert(read(file.name) == cloud);
  assert(read(padded.name) == cloud);
  refuse(".pcd", good + std::string(5000, '\0') + "x", {"more than the 70000 points"});
  refuse(".pcd", good.substr(0, begin), {"truncated", "before its compressed points"});
  refuse(".pcd", good.substr(0, begin + 7), {"truncated", "before its compressed points"});
  for (const std::size_t size : {begin + 8, begin + 9, good.size() / 2, good.size() - 1})
    refuse(".pcd", good.substr(0, size), {"truncated", "bytes of compressed points", "complete copy"});
  std::string other_size = good, other_count = good, damaged = good;
  other_size[begin + 4] = static_cast<char>(other_size[begin + 4] ^ 1);
  refuse(".pcd", other_size, {"compressed points are damaged"});
  damaged[begin + 8] = '\x7f'; // repeats what never was
  refuse(".pcd", damaged, {"compressed points are damaged"});
  while (other_count.find("70000") != std::string::npos)
    other_count.replace(other_count.find("70000"), 5, "70001");
  refuse(".pcd", other_count, {"promises 70001 points of 32 bytes", "2240000 bytes", "header is wrong"});

  const std::string header = pcd_header("x y z distance", "4 4 4 4", "F F F F", "1 1 1 1", "1", "binary");
  const Test_file page("_page.pcd", header + std::string(16, '\1') + std::string(4080, '\0'));
  assert(read(page.name).size() == 1);
}

void test_pcd_coordinates()
{
  const std::string text = pcd_header("u v w distance", "4 4 4 4", "F F F F", "1 1 1 1", "1", "ascii") + "1 2 3 4\n";
  const Test_file file(".pcd", text);
  assert((read(file.name, {"", "", "", {"v", "w", "u"}}) == Cloud{{Point(2, 3, 1), 4}}));
  refuse(".pcd", text, {"no field \"x\"", "u, v, w, distance", "coordinate_properties"});
  refuse(".pcd", text, {"no field \"q\"", "u, v, w, distance"}, {"", "", "", {"v", "w", "q"}});
}

void test_off()
{
  const Cloud expected = {{Point(0, 0, 0), 0.5}, {Point(1, 0, 0), 1}, {Point(0, 1.5, -2), 0}};
  const Test_file distances("_distances.txt", "0.5\n1\n0\n");
  for (const char* const text :
       {"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1.5 -2\n3 0 1 2\n",
        "OFF 3 1 0 # a comment\n\n# another\n0 0 0\n1 0 0 # 7\n0 1.5 -2\n3 0 1 2\n",
        "COFF\r\n3 1 0\r\n0 0 0 255 0 0 255\r\n1 0 0 255 0 0 255\r\n0 1.5 -2 0 0 0 0\r\n",
        "NOFF\n3 0 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1.5 -2 0 0 1\n", "STCNOFF\n3 0\n0 0 0 1\n1 0 0 1\n0 1.5 -2 1"})
  {
    const Test_file file(".off", text);
    assert(read_pair(file.name, distances.name) == expected);
    refuse(file, {"no distances", "separate file", "PLY"});
  }
  const auto refuse_off = [&](const std::string& text, const Words& words) {
    const Test_file file(".off", text);
    refuse_pair(file.name, distances.name, words);
    refuse_pair(file.name, distances.name, {file.name});
  };
  refuse_off("", {"is empty", "get a complete copy"});
  refuse_off("# nothing\n", {"truncated", "header"});
  refuse_off("solid\n", {":1:", "\"solid\"", "COFF"});
  refuse_off("4OFF\n1 0 0\n0 0 0 0\n", {":1:", "\"4OFF\"", "three coordinates"});
  refuse_off("OFF BINARY\n", {":1:", "binary", "PLY"});
  refuse_off("OFF\n", {"truncated", "number of vertices"});
  refuse_off("OFF\nmany 1 0\n", {":2:", "\"many\""});
  refuse_off("OFF\n1 0 0 0\n", {":2:", "numbers of vertices"});
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0 0\n", {"truncated", "after 2 of 3 vertices"});
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0\n0 0 1\n", {":4:", "2 values"});
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0 x\n0 0 1\n", {":4:", "\"x\""});
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0 inf\n0 0 1\n", {"point 1", "line 4"});
  refuse_off("OFF\n4 1 0\n0 0 0\n1 0 0\n0 0 1\n0 0 2\n", {"4 points", "3 distances"});
  refuse_off("OFF\n0 0 0\n", {"holds no points"});
  refuse_off("OFF\n1000000000000 1 0\n0 0 0\n", {"promises 1000000000000 vertices", "truncated"});
  refuse_off("OFF\n18446744073709551615 1 0\n0 0 0\n", {"promises 18446744073709551615 vertices"});
}

void test_mesh_in_ply()
{
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\nproperty float quality\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n0 0 0 0.5\n1 0 0 1\n0 1.5 -2 0\n";
  const Test_file file(".ply", vertices + "3 0 1 2\n");
  const Cloud expected = {{Point(0, 0, 0), 0.5}, {Point(1, 0, 0), 1}, {Point(0, 1.5, -2), 0}};
  assert(read(file.name) == expected);
  std::string binary = vertices.substr(0, vertices.find("end_header"));
  binary.replace(binary.find("ascii"), 5, "binary_big_endian");
  binary += "end_header\n";
  for (const float value : {0.f, 0.f, 0.f, .5f, 1.f, 0.f, 0.f, 1.f, 0.f, 1.5f, -2.f, 0.f})
    append(value, true, binary);
  binary += '\3';
  for (const std::int32_t index : {0, 1, 2})
    append(index, true, binary);
  const Test_file binary_file(".ply", binary);
  assert(read(binary_file.name) == expected);
}

int main()
{
  const auto count_files = [] { return std::distance(fs::directory_iterator("."), fs::directory_iterator()); };
  const auto before = count_files();
  test_pcd();
  test_pcd_of_pcl();
  test_pcd_coordinates();
  test_off();
  test_mesh_in_ply();
  assert(count_files() == before);
  return 0;
}
