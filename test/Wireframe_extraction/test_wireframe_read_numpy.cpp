// Clouds in arrays and archives of NumPy.

#include "cloud_file_checks.h"
#include "numpy_writers.h"

#include <cassert>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

void test_npy()
{
  const Cloud cloud = sample_cloud(10007); // more than one chunk
  const std::size_t n = cloud.size();
  for (const char* const type : {"<f8", ">f8", "<f4", ">f4"})
    for (const bool is_fortran : {false, true})
    {
      const Test_file all(".npy", npy(rows_of_four(cloud), {n, 4}, type, is_fortran));
      assert(read(all.name) == cloud);
      const Test_file points("_points.npy", npy(points_of(cloud), {n, 3}, type, is_fortran));
      const Test_file distances("_distances.npy", npy(distances_of(cloud), {n}, type, is_fortran));
      assert(read_pair(points.name, distances.name) == cloud);
      std::string lines;
      for (const double distance : distances_of(cloud))
        lines += std::to_string(distance) + "\n";
      const Test_file text("_distances.txt", lines);
      assert(read_pair(points.name, text.name) == cloud);
      // what is there once more is not looked at
      assert(read_pair(all.name, distances.name) == cloud);
      refuse(points, {"10007 x 3", "no distances", "separate file", "fourth column", ".npz"});
    }
  for (const int version : {2, 3})
  {
    const Test_file file(".NPY", npy(rows_of_four(cloud), {n, 4}, "<f8", false, version));
    assert(read(file.name) == cloud);
  }
  const Cloud small = sample_cloud(12);
  const Test_file patches(".npy", npy(rows_of_four(small), {3, 4, 4}));
  assert(read(patches.name) == small);
  const Test_file fortran_patches(".npy", npy(rows_of_four(small), {3, 4, 4}, ">f4", true));
  assert(read(fortran_patches.name) == small);
  // any text may be a cloud whose distances are an array
  const Test_file text(".xyz", "0 0 0\n1 2 3\n");
  const Test_file two("_two.npy", npy({5, 6}, {2, 1}, ">f4"));
  assert(read_pair(text.name, two.name) == (Cloud{{Point(0, 0, 0), 5}, {Point(1, 2, 3), 6}}));
}

// what has names, and half precision
void test_structures()
{
  const Cloud cloud = sample_cloud(9001);
  std::string bytes =
    npy_header("{'descr': [('name', '<U2'), ('sharpness', '>f8'), ('', '|V3'), ('x', '<f4'), ('n', '<f8', (2, 1)), "
               "('Y', '<f8'), ('z', '<f8')], 'fortran_order': True, 'shape': (9001,), }\n");
  std::string halves = npy_header(dictionary("<f2", "2, 4"));
  for (const auto& sample : cloud)
  {
    bytes += "abcdefgh";
    append(sample.second, true, bytes);
    bytes += "xyz";
    append(static_cast<float>(sample.first.x()), false, bytes);
    append(7., false, bytes);
    append(8., false, bytes);
    append(sample.first.y(), false, bytes);
    append(sample.first.z(), false, bytes);
  }
  const Test_file file(".npy", bytes);
  assert(read(file.name) == cloud);
  assert(read(file.name, {"", "", "n:1"})[3].second == 8.);
  assert(read(file.name, {"", "", "", {"z", "x", "y"}})[3].first
         == Point(cloud[3].first.z(), cloud[3].first.x(), cloud[3].first.y()));
  refuse(file, {"no field \"w\"", "sharpness, x, n:0, n:1, Y, z"}, {"", "", "", {"x", "y", "w"}});
  const Test_file archive(".npz", zip({{"anything.npy", bytes}}, 0));
  assert(read(archive.name) == cloud);
  refuse(".npy", bytes.substr(0, bytes.size() - 1), {"promises the shape 9001", "440 bit entries", "truncated"});
  refuse(".npy", bytes + "x", {"more than the shape"});

  for (const std::uint16_t bits : {0x3C00, 0xC000, 0x3555, 0x0001, 0x0000, 0x7BFF, 0x8000, 0x0400})
    append(bits, false, halves);
  const Test_file half(".npy", halves);
  const double third = 0.333251953125, least = std::ldexp(1., -24);
  assert((read(half.name) == Cloud{{Point(1, -2, third), least}, {Point(0, 65504, -0.), std::ldexp(1., -14)}}));
}

void test_columns()
{
  const Cloud cloud = sample_cloud(20);
  std::vector<double> rows;
  for (const auto& sample : cloud)
    rows.insert(rows.end(), {9., sample.first.z(), sample.first.y(), sample.first.x(), sample.second});
  const Names names = {"", "", "5", {"4", "3", "2"}};
  const std::string array = npy(rows, {20, 5});
  const Test_file file(".npy", array), archive(".npz", zip({{"arr_0.npy", array}}, 0));
  assert(read(file.name, names) == cloud);
  assert(read(archive.name, names) == cloud);
  refuse(file, {"shape 20 x 5", "coordinate_properties"});
  refuse(file, {"\"6\"", "from 1 to 5", "coordinate_properties"}, {"", "", "5", {"1", "2", "6"}});
  refuse(file, {"no distances"}, {"", "", "6", {"1", "2", "3"}});
}

void test_bad_npy()
{
  const auto with = [](const std::string& entries, std::size_t number_of_bytes = 32) {
    return npy_header(entries) + std::string(number_of_bytes, '\0');
  };
  refuse(".npy", "", {"is empty", "get a complete copy"});
  refuse(".npy", "1 2 3 4\n", {"no NumPy file", "\"1 2 3 4?\"", "numpy.save()"});
  refuse(".npy", std::string("\x93NUM", 4), {"no NumPy file"});
  refuse(".npy", std::string("\x93NUMPY\x01", 7), {"truncated", "header"});
  refuse(".npy", std::string("\x93NUMPY\x01\0\x40", 9), {"truncated", "header"});
  refuse(".npy", std::string("\x93NUMPY\x01\0\x40\0{'descr'", 18), {"truncated", "header"});
  refuse(".npy", npy({1, 2, 3, 4}, {1, 4}, "<f8", false, 4), {"version 4", "1 to 3"});
  refuse(".npy", std::string("\x93NUMPY\x02\0\xff\xff\xff\x7f{", 13), {"header", "2147483647 bytes"});
  refuse(".npy", with(dictionary("|O", "1, 4")), {"Python objects", "dtype=float", "numpy.asarray"});
  for (const char* const type :
       {"<f16", "<c16", "|b1", "<U7", "|V8", "f8", "<f", "<f99999999999999999999", "?f8", "|f8", ""})
    refuse(".npy", with(dictionary(type, "1, 4")), {"type", std::string("\"") + type + "\"", "dtype=float"});
  const auto with_fields = [&](const std::string& fields) {
    return with("{'descr': " + fields + ", 'fortran_order': False, 'shape': (1,)}");
  };
  refuse(".npy", with_fields("[('x', '<f8'), ('y', '<f8'), ('z', '<f8'), ('name', '|S8')]"),
         {"the fields x, y, z", "no distances"});
  refuse(".npy", with_fields("[('x', '<f8'), ('y', '<f8'), ('q', '<f8'), ('distance', '<f8')]"),
         {"no field \"z\"", "x, y, q, distance", "coordinate_properties"});
  refuse(".npy", with_fields("[('p', [('x', '<f8')])]"), {"within which", "numpy.asarray"});
  refuse(".npy", with_fields("[('p', '<q8')]"), {"\"p\"", "\"<q8\""});
  refuse(".npy", with_fields("[('name', '|S32')]"), {"without numbers"});
  refuse(".npy", with_fields("[]"), {"without numbers"});
  for (const char* const fields :
       {"[('x', '<f8', (3)]", "[('x', '<f8', (70000,))]", "[('x', '<f8', (256, 256, 256, 256))]", "['x']",
        "[('x' '<f8')]", "[('x', '<f8'", "[('x', '<f8')"})
    refuse(".npy", with_fields(fields), {"numpy."});
  refuse(".npy", with_fields("[('x', '<f8'), ('s', '|S65536')]"), {"too large"});
  for (const char* const entries :
       {"", "x", "{", "{}x", "{'descr' '<f8'}", "{'descr': '<f8', 'fortran_order': No}", "{'descr': '<f8' 'shape': ()}",
        "{'shape': (1, -4)}", "{'shape': (1 4)}", "{'shape': (99999999999999999999,)}", "{'shape': 4}", "{'descr': 4}",
        "{'descr': '<f8}", "{descr: '<f8'}", "{'shape': (1, 4), } trailing"})
    refuse(".npy", with(entries), {"header is malformed"});
  std::string deep = "{'shape': (";
  for (int i = 0; i < 1000; ++i)
    deep += "1, ";
  refuse(".npy", with(deep + ")}"), {"header is malformed"});
  refuse(".npy", with("{}"), {"lacks"});
  refuse(".npy", with("{'descr': '<f8', 'shape': (1, 4)}"), {"lacks"});
  refuse(".npy", with("{'descr': '<f8', 'descr': '<f8'}"), {"unexpected", "\"descr\""});
  refuse(".npy", with("{'descr': '<f8', 'other': 'x'}"), {"unexpected", "\"other\""});
  const std::string good = npy({1, 2, 3, 4, 5, 6, 7, 8}, {2, 4});
  refuse(".npy", good.substr(0, good.size() - 1), {"promises the shape 2 x 4", "64 bit", "63 bytes", "truncated"});
  refuse(".npy", good + "x", {"more than the shape 2 x 4"});
  refuse(".npy", npy({1, 2, 3, 4}, {4}), {"shape 4", "N x 3", "N x 4"});
  refuse(".npy", npy({1, 2, 3, 4}, {2, 2}), {"shape 2 x 2", "N x 3", "N x 4"});
  refuse(".npy", npy({1}, {}), {"single number"});
  refuse(".npy", npy({1, 2, 3, 4}, {1, 1, 1, 4}), {"shape 1 x 1 x 1 x 4"});
  refuse(".npy", npy({}, {0, 4}), {"holds no points"});
  refuse(".npy", npy({1, 2, 3, std::nan("")}, {1, 4}), {"point 0", "distance is nan", "skip_invalid"});
  const auto begin = std::chrono::steady_clock::now();
  for (const char* const shape : {"1000000000000, 4", "9223372036854775808, 4", "18446744073709551615, 4",
                                  "4611686018427387904, 4", "4294967296, 4294967296, 4"})
    refuse(".npy", with(dictionary("<f8", shape)), {"promises the shape", "at most 32 bytes", "truncated"});
  assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));

  const Test_file points("_points.npy", npy({1, 2, 3, 4, 5, 6}, {2, 3}));
  const Test_file one("_one.npy", npy({1}, {1})), none("_none.npy", npy({}, {0}));
  const std::string two = npy({1, 2}, {2});
  const Test_file bad("_bad.npy", npy({1, -2}, {2})), cut("_cut.npy", two.substr(0, two.size() - 1));
  refuse_pair(points.name, one.name, {"2 points", one.name, "1 distance;"});
  refuse_pair(points.name, none.name, {none.name, "no distances"});
  refuse_pair(points.name, bad.name, {points.name, "1 of 2", "distance is -2 (" + bad.name + ")"});
  refuse_pair(points.name, cut.name, {cut.name, "truncated"});
  refuse_pair(points.name, "input_none.npy", {"input_none.npy", "No such file"});
}

void test_npz()
{
  const Cloud cloud = sample_cloud(30011);
  const std::size_t n = cloud.size();
  const Member points = {"points.npy", npy(points_of(cloud), {n, 3}, "<f4", true)};
  const Member distances = {"distances.npy", npy(distances_of(cloud), {n}, ">f8")};
  const Member other = {"has_sharp.npy", npy({1}, {1}, "<i8")}, text = {"read.me", "no array"};
  for (const unsigned method : zip_methods())
    for (const bool is_large : {false, true})
    {
      const Test_file file(".npz", zip({other, points, text, distances}, method, is_large));
      assert(read(file.name) == cloud);
      assert(read(file.name, {"POINTS", "distances", ""}) == cloud);
      assert(read_pair(file.name, file.name) == cloud);
      refuse(file, {"no array \"xyz\"", "it has: has_sharp, points, distances.", "points_dataset"}, {"xyz", "", ""});
      refuse(file, {"no array \"d\"", "has_sharp, points, distances", "distances_dataset", "separate file"},
             {"", "d", ""});
      refuse(file, {"no array \"p\""}, {"", "", "p"});
      refuse(file, {"array \"has_sharp\" has the shape 1;", "N x 3"}, {"has_sharp", "", ""});
      refuse(file,
             {"array \"has_sharp\" has the shape 1,", "array \"points\" 30011 x 3", "exactly one distance",
              "distances_dataset"},
             {"", "has_sharp", ""});
    }
  // the usual names, in their order
  const Cloud small = sample_cloud(6);
  const Member xyz = {"xyz.npy", npy(points_of(small), {2, 3, 3})};
  const Member quality = {"quality.npy", npy(std::vector<double>(6, 9.), {6})};
  const Member sharpness = {"sharpness.npy", npy(distances_of(small), {2, 3, 1})};
  const Test_file patches(".npz", zip({quality, sharpness, xyz}, 0));
  assert(read(patches.name, {"xyz", "", ""}) == small);
  assert(read(patches.name, {"xyz", "", "sharpness"}) == small);
  assert(read(patches.name, {"xyz", "quality", "sharpness"})[3].second == 9.);
  refuse(".npz", zip({xyz, {"distance.npy", npy(distances_of(small), {3, 2})}}, 0),
         {"\"distance\" has the shape 3 x 2", "2 x 3 x 3"}, {"xyz", "", ""});
  refuse(".npz", zip({{"points.npy", npy(points_of(small), {6, 3})}}, 0),
         {"for the distances", "sharpness", "it has: points."});
}

// an archive of one array, or of points by any name and distances by a known one
void test_arrays_of_any_name()
{
  const Cloud cloud = sample_cloud(300);
  const Member four = {"cloud.npy", npy(rows_of_four(cloud), {300, 4})};
  const Member three = {"arr_0.npy", npy(points_of(cloud), {300, 3})};
  const Member distances = {"distances.npy", npy(distances_of(cloud), {300})};
  const Member zeros = {"quality.npy", npy(std::vector<double>(300, 0.), {300})};
  const Test_file one(".npz", zip({four}, 0)), two(".npz", zip({distances, three}, 0));
  assert(read(one.name) == cloud);
  assert(read(two.name) == cloud);
  const Test_file named(".npz", zip({four, three}, 0));
  assert(read(named.name, {"cloud", "", ""}) == cloud);
  refuse(named, {"no array \"points\"", "cloud, arr_0"});
  const Test_file both(".npz", zip({zeros, four}, 0)); // an array of distances counts more than a column
  assert(read(both.name)[5].second == 0.);
  refuse(".npz", zip({three}, 0), {"no array for the distances"});
}

void test_bad_npz()
{
  const Cloud cloud = sample_cloud(50);
  const Member points = {"points.npy", npy(points_of(cloud), {50, 3})};
  const Member distances = {"distances.npy", npy(distances_of(cloud), {50})};
  refuse(".npz", "", {"is empty", "get a complete copy"});
  refuse(".npz", "PK", {"no NumPy archive", "truncated", "numpy.savez()"});
  refuse(".npz", zip({}, 0), {"no array \"points\"", "(none)"});
  refuse(".npz", zip({points, distances}, 12), {"\"points\"", "method 12", "numpy.savez()"});
  refuse(".npz", zip({points, distances}, 0, false, 1), {"\"points\"", "encrypted"});
  refuse(".npz", zip({{"points.npy", "no array"}, distances}, 0), {"array \"points\": is no NumPy file"});
  refuse(".npz",
         zip({{"points.npy", npy_header(dictionary("<f8", "1000000000000, 3")) + std::string(48, '\0')}, distances}, 0),
         {"array \"points\"", "1000000000000 x 3", "at most 48 bytes"});
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  refuse(".npz",
         zip({{"points.npy", npy_header(dictionary("<f8", "1000000000000, 3")) + std::string(48, '\0')}, distances}, 8),
         {"array \"points\"", "1000000000000 x 3", "at most 48 bytes"});
#else
  refuse(".npz", zip({points, distances}, 8),
         {"\"points\"", "needs zlib", "without which this program was built", "numpy.savez()",
          "CGAL::Wireframe_extraction_ZLIB", "zlib1g-dev"});
#endif
  for (const unsigned method : zip_methods())
    for (const bool is_large : {false, true})
    {
      const std::string good = zip({points, distances}, method, is_large);
      // wherever it is cut, and whatever byte is wrong, there is an error or the right cloud
      for (std::size_t size = 0; size < good.size(); size += 7)
      {
        const Test_file file(".npz", good.substr(0, size));
        refuse(file, {file.name});
      }
      std::mt19937 random(7);
      std::size_t number_of_refused = 0;
      for (int i = 0; i < 400; ++i)
      {
        std::string bad = good;
        bad[random() % bad.size()] = static_cast<char>(random());
        const Test_file file(".npz", bad);
        Cloud result;
        std::string error;
        if (CGAL::IO::read_distance_cloud(file.name, result, parameters::error_message(&error)))
          assert(result == cloud);
        else
        {
          check_words(error, {file.name});
          ++number_of_refused;
        }
      }
      assert(number_of_refused > 200);
    }
  std::string damaged = zip({points, distances}, 0);
  damaged[200] = static_cast<char>(damaged[200] ^ 1);
  refuse(".npz", damaged, {"array \"points\"", "check sum", "damaged"});
}

void test_small_number_types()
{
  std::vector<std::pair<CGAL::Simple_cartesian<float>::Point_3, float>> cloud;
  std::string error;
  const Test_file file(".npy", npy({1, 2, 3, 1e300}, {1, 4}));
  assert(!CGAL::IO::read_distance_cloud(file.name, cloud, parameters::error_message(&error)));
  check_words(error, {"point 0", "1e+300"});
}

int main()
{
  const auto count_files = [] { return std::distance(fs::directory_iterator("."), fs::directory_iterator()); };
  const auto before = count_files();
  test_npy();
  test_structures();
  test_columns();
  test_bad_npy();
  test_npz();
  test_arrays_of_any_name();
  test_bad_npz();
  test_small_number_types();
  assert(count_files() == before);
  return 0;
}
