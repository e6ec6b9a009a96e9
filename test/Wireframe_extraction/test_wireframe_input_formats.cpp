// Clouds in the formats of NumPy, HDF5, PCL and of meshes, all of them written here, and the fusion of overlapping
// patches.

#include "check_words.h"

#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_patches.h>
#include <CGAL/Wireframe_extraction/fuse_distance_patches.h>

#include <CGAL/Simple_cartesian.h>

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <initializer_list>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;
namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe_extraction::Distance_patch<Point, double> Patch;
typedef std::vector<Patch> Patches;
typedef CGAL::Wireframe_extraction::Patch_fusion Patch_fusion;

// a file of the current directory that is gone at the end of the test
struct Test_file
{
  std::string name;

  explicit Test_file(const std::string& suffix) : name("input_scratch" + suffix) {}

  Test_file(const std::string& suffix, const std::string& content) : Test_file(suffix)
  {
    std::ofstream(name, std::ios::binary) << content;
  }

  Test_file(const Test_file&) = delete;
  Test_file& operator=(const Test_file&) = delete;
  ~Test_file() { std::remove(name.c_str()); }

  std::string content() const
  {
    std::ifstream stream(name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
};

struct Names
{
  std::string points, distances, property;
};

auto name_parameters(const Names& names, std::string& error)
{
  return parameters::points_dataset(names.points).distances_dataset(names.distances)
    .distance_property(names.property).error_message(&error);
}

Cloud read(const std::string& name, const Names& names = Names())
{
  Cloud cloud;
  std::string error;
  if(!CGAL::IO::read_distance_cloud(name, cloud, name_parameters(names, error)))
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty() && !cloud.empty());
  return cloud;
}

Cloud read_pair(const std::string& name, const std::string& distances, const Names& names = Names())
{
  Cloud cloud;
  std::string error;
  if(!CGAL::IO::read_distance_cloud(name, distances, cloud, name_parameters(names, error)))
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty());
  return cloud;
}

void refuse(const Test_file& file, const Words& words, const Names& names = Names())
{
  const Cloud before = { { Point(1, 2, 3), 4 } };
  Cloud cloud = before;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(file.name, cloud, name_parameters(names, error)));
  assert(cloud == before);
  check_words(error, words);
  assert(error.compare(0, file.name.size(), file.name) == 0);
}

void refuse(const std::string& suffix, const std::string& content, const Words& words, const Names& names = Names())
{
  refuse(Test_file(suffix, content), words, names);
}

void refuse_pair(const std::string& name, const std::string& distances, const Words& words)
{
  Cloud cloud;
  std::string error;
  assert(!CGAL::IO::read_distance_cloud(name, distances, cloud, parameters::error_message(&error)));
  assert(cloud.empty());
  check_words(error, words);
}

// numbers that float holds exactly
Cloud sample_cloud(std::size_t count)
{
  Cloud cloud;
  for(std::size_t i = 0; i < count; ++i)
  {
    const double t = static_cast<double>(i);
    cloud.emplace_back(Point(t, 0.5 * t - 3., 100. - 0.25 * t), 0.125 * static_cast<double>(i % 17));
  }
  return cloud;
}

std::vector<double> points_of(const Cloud& cloud)
{
  std::vector<double> values;
  for(const auto& sample : cloud)
    values.insert(values.end(), { sample.first.x(), sample.first.y(), sample.first.z() });
  return values;
}

std::vector<double> distances_of(const Cloud& cloud)
{
  std::vector<double> values;
  for(const auto& sample : cloud)
    values.push_back(sample.second);
  return values;
}

std::vector<double> rows_of_four(const Cloud& cloud)
{
  std::vector<double> values;
  for(const auto& sample : cloud)
    values.insert(values.end(), { sample.first.x(), sample.first.y(), sample.first.z(), sample.second });
  return values;
}

template <class Number>
void append(Number number, bool is_big, std::string& bytes)
{
  char raw[sizeof(Number)];
  std::memcpy(raw, &number, sizeof(Number));
  const std::uint16_t one = 1;
  const bool is_host_big = *reinterpret_cast<const char*>(&one) == 0;
  if(is_big != is_host_big)
    std::reverse(raw, raw + sizeof(Number));
  bytes.append(raw, sizeof(Number));
}

// ---- NumPy ----

std::string npy_header(const std::string& dictionary, int version = 1)
{
  std::string bytes("\x93NUMPY", 6);
  bytes += static_cast<char>(version);
  bytes += '\0';
  if(version == 1)
    append(static_cast<std::uint16_t>(dictionary.size()), false, bytes);
  else
    append(static_cast<std::uint32_t>(dictionary.size()), false, bytes);
  return bytes + dictionary;
}

std::string dictionary(const std::string& type, const std::string& shape, bool is_fortran = false)
{
  return "{'descr': '" + type + "', 'fortran_order': " + (is_fortran ? "True" : "False") + ", 'shape': (" + shape
         + "), }      \n";
}

// a .npy file; the values are in C's order
std::string npy(const std::vector<double>& values, const std::vector<std::size_t>& shape,
                const std::string& type = "<f8", bool is_fortran = false, int version = 1)
{
  std::string shape_text;
  for(const std::size_t& size : shape)
    shape_text += std::to_string(size) + (shape.size() == 1 ? "," : &size == &shape.back() ? "" : ", ");
  std::string bytes = npy_header(dictionary(type, shape_text, is_fortran), version);
  for(std::size_t i = 0; i < values.size(); ++i)
  {
    std::size_t index = i;
    if(is_fortran)
    {
      // the position of the i-th value of Fortran's order
      std::size_t rest = i;
      std::vector<std::size_t> position;
      for(const std::size_t size : shape)
      {
        position.push_back(rest % size);
        rest /= size;
      }
      index = 0;
      for(std::size_t axis = 0; axis < shape.size(); ++axis)
        index = index * shape[axis] + position[axis];
    }
    const double value = values[index];
    const bool is_big = (type[0] == '>');
    const std::string kind = type.substr(1);
    if(kind == "f8")
      append(value, is_big, bytes);
    else if(kind == "f4")
      append(static_cast<float>(value), is_big, bytes);
    else if(kind == "i8")
      append(static_cast<std::int64_t>(value), is_big, bytes);
    else if(kind == "u2")
      append(static_cast<std::uint16_t>(value), is_big, bytes);
    else
      assert(false);
  }
  return bytes;
}

void test_npy()
{
  const Cloud cloud = sample_cloud(10007); // more than one chunk
  const std::size_t n = cloud.size();
  for(const char* const type : { "<f8", ">f8", "<f4", ">f4" })
    for(const bool is_fortran : { false, true })
    {
      const Test_file all(".npy", npy(rows_of_four(cloud), { n, 4 }, type, is_fortran));
      assert(read(all.name) == cloud);
      const Test_file points("_points.npy", npy(points_of(cloud), { n, 3 }, type, is_fortran));
      const Test_file distances("_distances.npy", npy(distances_of(cloud), { n }, type, is_fortran));
      assert(read_pair(points.name, distances.name) == cloud);
      std::string lines;
      for(const double distance : distances_of(cloud))
        lines += std::to_string(distance) + "\n";
      const Test_file text("_distances.txt", lines);
      assert(read_pair(points.name, text.name) == cloud);
      // what is there once more is not looked at
      assert(read_pair(all.name, distances.name) == cloud);
      refuse(points, { "10007 x 3", "no distances", "separate file", "fourth column", ".npz" });
    }
  for(const int version : { 2, 3 })
  {
    const Test_file file(".NPY", npy(rows_of_four(cloud), { n, 4 }, "<f8", false, version));
    assert(read(file.name) == cloud);
  }
  const Cloud small = sample_cloud(12);
  const Test_file patches(".npy", npy(rows_of_four(small), { 3, 4, 4 }));
  assert(read(patches.name) == small);
  const Test_file fortran_patches(".npy", npy(rows_of_four(small), { 3, 4, 4 }, ">f4", true));
  assert(read(fortran_patches.name) == small);
  // any text may be a cloud whose distances are an array
  const Test_file text(".xyz", "0 0 0\n1 2 3\n");
  const Test_file two("_two.npy", npy({ 5, 6 }, { 2, 1 }, ">f4"));
  assert(read_pair(text.name, two.name) == (Cloud{ { Point(0, 0, 0), 5 }, { Point(1, 2, 3), 6 } }));
}

void test_bad_npy()
{
  const auto with = [](const std::string& entries, std::size_t number_of_bytes = 32)
  { return npy_header(entries) + std::string(number_of_bytes, '\0'); };
  refuse(".npy", "", { "is empty", "get a complete copy" });
  refuse(".npy", "1 2 3 4\n", { "no NumPy file", "\"1 2 3 4?\"", "numpy.save()" });
  refuse(".npy", std::string("\x93NUM", 4), { "no NumPy file" });
  refuse(".npy", std::string("\x93NUMPY\x01", 7), { "truncated", "header" });
  refuse(".npy", std::string("\x93NUMPY\x01\0\x40", 9), { "truncated", "header" });
  refuse(".npy", std::string("\x93NUMPY\x01\0\x40\0{'descr'", 18), { "truncated", "header" });
  refuse(".npy", npy({ 1, 2, 3, 4 }, { 1, 4 }, "<f8", false, 4), { "version 4", "1 to 3" });
  refuse(".npy", std::string("\x93NUMPY\x02\0\xff\xff\xff\x7f{", 13), { "header", "2147483647 bytes" });
  refuse(".npy", with(dictionary("|O", "1, 4")), { "Python objects", "float64", "numpy.asarray" });
  for(const char* const type : { "<f2", "<c16", "|b1", "<U7", "|V8", "f8", "<f", "<f99999999999999999999", "?f8",
                                 "|f8", "" })
    refuse(".npy", with(dictionary(type, "1, 4")), { "type", std::string("\"") + type + "\"", "float64" });
  refuse(".npy", with("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (4,)}"),
         { "structured", "numpy.asarray" });
  for(const char* const entries : { "", "x", "{", "{}x", "{'descr' '<f8'}", "{'descr': '<f8', 'fortran_order': No}",
                                    "{'descr': '<f8' 'shape': ()}", "{'shape': (1, -4)}", "{'shape': (1 4)}",
                                    "{'shape': (99999999999999999999,)}", "{'shape': 4}", "{'descr': 4}",
                                    "{'descr': '<f8}", "{descr: '<f8'}", "{'shape': (1, 4), } trailing" })
    refuse(".npy", with(entries), { "header is malformed" });
  std::string deep = "{'shape': (";
  for(int i = 0; i < 1000; ++i)
    deep += "1, ";
  refuse(".npy", with(deep + ")}"), { "header is malformed" });
  refuse(".npy", with("{}"), { "lacks" });
  refuse(".npy", with("{'descr': '<f8', 'shape': (1, 4)}"), { "lacks" });
  refuse(".npy", with("{'descr': '<f8', 'descr': '<f8'}"), { "unexpected", "\"descr\"" });
  refuse(".npy", with("{'descr': '<f8', 'other': 'x'}"), { "unexpected", "\"other\"" });
  const std::string good = npy({ 1, 2, 3, 4, 5, 6, 7, 8 }, { 2, 4 });
  refuse(".npy", good.substr(0, good.size() - 1), { "promises the shape 2 x 4", "64 bit", "63 bytes", "truncated" });
  refuse(".npy", good + "x", { "more than the shape 2 x 4" });
  refuse(".npy", npy({ 1, 2, 3, 4 }, { 4 }), { "shape 4", "N x 3", "N x 4" });
  refuse(".npy", npy({ 1, 2, 3, 4 }, { 2, 2 }), { "shape 2 x 2", "N x 3", "N x 4" });
  refuse(".npy", npy({ 1 }, {}), { "single number" });
  refuse(".npy", npy({ 1, 2, 3, 4 }, { 1, 1, 1, 4 }), { "shape 1 x 1 x 1 x 4" });
  refuse(".npy", npy({}, { 0, 4 }), { "holds no points" });
  refuse(".npy", npy({ 1, 2, 3, std::nan("") }, { 1, 4 }), { "point 0", "distance is nan", "skip_invalid" });
  const auto begin = std::chrono::steady_clock::now();
  for(const char* const shape : { "1000000000000, 4", "9223372036854775808, 4", "18446744073709551615, 4",
                                  "4611686018427387904, 4", "4294967296, 4294967296, 4" })
    refuse(".npy", with(dictionary("<f8", shape)), { "promises the shape", "at most 32 bytes", "truncated" });
  assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));

  const Test_file points("_points.npy", npy({ 1, 2, 3, 4, 5, 6 }, { 2, 3 }));
  const Test_file one("_one.npy", npy({ 1 }, { 1 })), none("_none.npy", npy({}, { 0 }));
  const std::string two = npy({ 1, 2 }, { 2 });
  const Test_file bad("_bad.npy", npy({ 1, -2 }, { 2 })), cut("_cut.npy", two.substr(0, two.size() - 1));
  refuse_pair(points.name, one.name, { "2 points", one.name, "1 distance;" });
  refuse_pair(points.name, none.name, { none.name, "no distances" });
  refuse_pair(points.name, bad.name, { points.name, "1 of 2", "distance is -2 (" + bad.name + ")" });
  refuse_pair(points.name, cut.name, { cut.name, "truncated" });
  refuse_pair(points.name, "input_none.npy", { "input_none.npy", "No such file" });
}

// ---- NumPy archives ----

std::uint32_t check_sum(const std::string& bytes)
{
  std::uint32_t sum = 0xFFFFFFFFu;
  for(const char c : bytes)
  {
    sum ^= static_cast<unsigned char>(c);
    for(int bit = 0; bit < 8; ++bit)
      sum = (sum & 1u) != 0 ? (sum >> 1) ^ 0xEDB88320u : sum >> 1;
  }
  return ~sum;
}

std::string deflated(const std::string& bytes)
{
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  z_stream stream = z_stream();
  assert(deflateInit2(&stream, 9, Z_DEFLATED, -15, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(&result[0]);
  stream.avail_out = static_cast<uInt>(result.size());
  assert(deflate(&stream, Z_FINISH) == Z_STREAM_END);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
#else
  return bytes;
#endif
}

struct Member
{
  std::string name, content;
};

// with the numbers of 64 bits that numpy.savez() writes, or also with those of archives above 4 GB
std::string zip(const std::vector<Member>& members, unsigned method, bool is_large = false, unsigned flags = 0)
{
  std::string bytes, directory;
  for(const Member& member : members)
  {
    const std::string data = method == 8 ? deflated(member.content) : member.content;
    const std::uint32_t sum = check_sum(member.content);
    const std::uint64_t offset = bytes.size();
    const auto append_common = [&](std::string& target)
    {
      append(std::uint16_t(45), false, target);
      append(static_cast<std::uint16_t>(flags), false, target);
      append(static_cast<std::uint16_t>(method), false, target);
      append(std::uint32_t(0), false, target);
      append(sum, false, target);
    };
    const auto append_large = [&](bool has_offset, std::string& target)
    {
      append(std::uint16_t(1), false, target);
      append(std::uint16_t(has_offset ? 24 : 16), false, target);
      append(std::uint64_t(member.content.size()), false, target);
      append(std::uint64_t(data.size()), false, target);
      if(has_offset)
        append(offset, false, target);
    };
    bytes += "PK\3\4";
    append_common(bytes);
    append(0xFFFFFFFFu, false, bytes);
    append(0xFFFFFFFFu, false, bytes);
    append(static_cast<std::uint16_t>(member.name.size()), false, bytes);
    append(std::uint16_t(20), false, bytes);
    bytes += member.name;
    append_large(false, bytes);
    bytes += data;

    directory += "PK\1\2";
    append(std::uint16_t(45), false, directory);
    append_common(directory);
    append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(data.size()), false, directory);
    append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(member.content.size()), false, directory);
    append(static_cast<std::uint16_t>(member.name.size()), false, directory);
    append(std::uint16_t(is_large ? 28 : 0), false, directory);
    directory += std::string(10, '\0');
    append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(offset), false, directory);
    directory += member.name;
    if(is_large)
      append_large(true, directory);
  }
  const std::uint64_t begin = bytes.size(), size = directory.size(), count = members.size();
  bytes += directory;
  if(is_large)
  {
    const std::uint64_t large_end = bytes.size();
    bytes += "PK\6\6";
    append(std::uint64_t(44), false, bytes);
    bytes += std::string(12, '\0');
    append(count, false, bytes);
    append(count, false, bytes);
    append(size, false, bytes);
    append(begin, false, bytes);
    bytes += std::string("PK\6\7\0\0\0\0", 8);
    append(large_end, false, bytes);
    append(std::uint32_t(1), false, bytes);
  }
  bytes += std::string("PK\5\6\0\0\0\0", 8);
  append(static_cast<std::uint16_t>(is_large ? 0xFFFF : count), false, bytes);
  append(static_cast<std::uint16_t>(is_large ? 0xFFFF : count), false, bytes);
  append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(size), false, bytes);
  append(is_large ? 0xFFFFFFFFu : static_cast<std::uint32_t>(begin), false, bytes);
  append(std::uint16_t(0), false, bytes);
  return bytes;
}

std::vector<unsigned> zip_methods()
{
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  return { 0, 8 };
#else
  return { 0 };
#endif
}

void test_npz()
{
  const Cloud cloud = sample_cloud(30011);
  const std::size_t n = cloud.size();
  const Member points = { "points.npy", npy(points_of(cloud), { n, 3 }, "<f4", true) };
  const Member distances = { "distances.npy", npy(distances_of(cloud), { n }, ">f8") };
  const Member other = { "has_sharp.npy", npy({ 1 }, { 1 }, "<i8") }, text = { "read.me", "no array" };
  for(const unsigned method : zip_methods())
    for(const bool is_large : { false, true })
    {
      const Test_file file(".npz", zip({ other, points, text, distances }, method, is_large));
      assert(read(file.name) == cloud);
      assert(read(file.name, { "POINTS", "distances", "" }) == cloud);
      assert(read_pair(file.name, file.name) == cloud);
      refuse(file, { "no array \"xyz\"", "it has: has_sharp, points, distances.", "points_dataset" },
             { "xyz", "", "" });
      refuse(file, { "no array \"d\"", "has_sharp, points, distances", "distances_dataset", "separate file" },
             { "", "d", "" });
      refuse(file, { "no array \"p\"" }, { "", "", "p" });
      refuse(file, { "array \"has_sharp\" has the shape 1;", "N x 3" }, { "has_sharp", "", "" });
      refuse(file, { "array \"has_sharp\" has the shape 1,", "array \"points\" 30011 x 3", "exactly one distance",
                     "distances_dataset" }, { "", "has_sharp", "" });
    }
  // the usual names, in their order
  const Cloud small = sample_cloud(6);
  const Member xyz = { "xyz.npy", npy(points_of(small), { 2, 3, 3 }) };
  const Member quality = { "quality.npy", npy(std::vector<double>(6, 9.), { 6 }) };
  const Member sharpness = { "sharpness.npy", npy(distances_of(small), { 2, 3, 1 }) };
  const Test_file patches(".npz", zip({ quality, sharpness, xyz }, 0));
  assert(read(patches.name, { "xyz", "", "" }) == small);
  assert(read(patches.name, { "xyz", "", "sharpness" }) == small);
  assert(read(patches.name, { "xyz", "quality", "sharpness" })[3].second == 9.);
  refuse(".npz", zip({ xyz, { "distance.npy", npy(distances_of(small), { 3, 2 }) } }, 0),
         { "\"distance\" has the shape 3 x 2", "2 x 3 x 3" }, { "xyz", "", "" });
  refuse(".npz", zip({ { "points.npy", npy(points_of(small), { 6, 3 }) } }, 0),
         { "for the distances", "sharpness", "it has: points." });
}

void test_bad_npz()
{
  const Cloud cloud = sample_cloud(50);
  const Member points = { "points.npy", npy(points_of(cloud), { 50, 3 }) };
  const Member distances = { "distances.npy", npy(distances_of(cloud), { 50 }) };
  refuse(".npz", "", { "is empty", "get a complete copy" });
  refuse(".npz", "PK", { "no NumPy archive", "truncated", "numpy.savez()" });
  refuse(".npz", zip({}, 0), { "no array \"points\"", "(none)" });
  refuse(".npz", zip({ points, distances }, 12), { "\"points\"", "method 12", "numpy.savez()" });
  refuse(".npz", zip({ points, distances }, 0, false, 1), { "\"points\"", "encrypted" });
  refuse(".npz", zip({ { "points.npy", "no array" }, distances }, 0), { "array \"points\": is no NumPy file" });
  refuse(".npz", zip({ { "points.npy", npy_header(dictionary("<f8", "1000000000000, 3")) + std::string(48, '\0') },
                       distances }, 0), { "array \"points\"", "1000000000000 x 3", "at most 48 bytes" });
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_ZLIB
  refuse(".npz", zip({ { "points.npy", npy_header(dictionary("<f8", "1000000000000, 3")) + std::string(48, '\0') },
                       distances }, 8), { "array \"points\"", "1000000000000 x 3", "at most 48 bytes" });
#else
  refuse(".npz", zip({ points, distances }, 8),
         { "\"points\"", "needs zlib", "without which this program was built", "numpy.savez()",
           "CGAL::Wireframe_extraction_ZLIB", "zlib1g-dev" });
#endif
  for(const unsigned method : zip_methods())
    for(const bool is_large : { false, true })
    {
      const std::string good = zip({ points, distances }, method, is_large);
      // wherever it is cut, and whatever byte is wrong, there is an error or the right cloud
      for(std::size_t size = 0; size < good.size(); size += 7)
      {
        const Test_file file(".npz", good.substr(0, size));
        refuse(file, { file.name });
      }
      std::mt19937 random(7);
      std::size_t number_of_refused = 0;
      for(int i = 0; i < 400; ++i)
      {
        std::string bad = good;
        bad[random() % bad.size()] = static_cast<char>(random());
        const Test_file file(".npz", bad);
        Cloud result;
        std::string error;
        if(CGAL::IO::read_distance_cloud(file.name, result, parameters::error_message(&error)))
          assert(result == cloud);
        else
        {
          check_words(error, { file.name });
          ++number_of_refused;
        }
      }
      assert(number_of_refused > 200);
    }
  std::string damaged = zip({ points, distances }, 0);
  damaged[200] = static_cast<char>(damaged[200] ^ 1);
  refuse(".npz", damaged, { "array \"points\"", "check sum", "damaged" });
}

// ---- HDF5 ----

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5

class Hdf5_writer
{
public:
  explicit Hdf5_writer(const std::string& name)
    : file_(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT))
  {
    assert(file_ >= 0);
  }

  ~Hdf5_writer() { H5Fclose(file_); }

  void add_group(const std::string& name)
  {
    H5Gclose(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  }

  void add(const std::string& name, const std::vector<double>& values, const std::vector<hsize_t>& shape,
           hid_t type = H5T_IEEE_F64LE, bool is_compressed = false, bool is_written = true)
  {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    if(is_compressed)
    {
      std::vector<hsize_t> chunk(shape);
      chunk[0] = (std::min)(chunk[0], hsize_t(100));
      H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data());
      H5Pset_deflate(properties, 9);
    }
    const hid_t dataset = H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
    assert(dataset >= 0);
    if(is_written)
      assert(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    H5Dclose(dataset);
    H5Pclose(properties);
    H5Sclose(space);
  }

  void add_rows(const std::string& name, std::vector<std::vector<double>> rows, hid_t type = H5T_IEEE_F64LE)
  {
    const hsize_t count = rows.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t file_type = H5Tvlen_create(type), memory_type = H5Tvlen_create(H5T_NATIVE_DOUBLE);
    const hid_t dataset = H5Dcreate2(file_, name.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    std::vector<hvl_t> raw;
    for(std::vector<double>& row : rows)
      raw.push_back({ row.size(), row.data() });
    assert(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) >= 0);
    H5Dclose(dataset);
    H5Tclose(memory_type);
    H5Tclose(file_type);
    H5Sclose(space);
  }

  void add_external(const std::string& name, hsize_t count)
  {
    const hsize_t shape[] = { count, 3 };
    const hid_t space = H5Screate_simple(2, shape, nullptr);
    const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_external(properties, "input_scratch_elsewhere.raw", 0, H5F_UNLIMITED);
    H5Dclose(H5Dcreate2(file_, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, properties, H5P_DEFAULT));
    H5Pclose(properties);
    H5Sclose(space);
  }

  void add_text(const std::string& name)
  {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t dataset = H5Dcreate2(file_, name.c_str(), H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dclose(dataset);
    H5Sclose(space);
  }

private:
  hid_t file_;
};

void test_hdf5()
{
  const Cloud cloud = sample_cloud(600000); // more than one slab
  const hsize_t n = cloud.size();
  {
    const Test_file file(".h5");
    {
      Hdf5_writer writer(file.name);
      writer.add("points", points_of(cloud), { n, 3 }, H5T_IEEE_F32LE);
      writer.add("distances", distances_of(cloud), { n }, H5T_IEEE_F32BE);
    }
    assert(read(file.name) == cloud);
  }
  for(const bool is_compressed : { false, true })
  {
    const Cloud small = sample_cloud(4000);
    const Test_file file(".HDF5");
    {
      Hdf5_writer writer(file.name);
      writer.add_group("of_model");
      writer.add_text("item_id"); // and no has_sharp
      writer.add("points", points_of(small), { 10, 400, 3 }, H5T_IEEE_F64BE, is_compressed);
      writer.add("distances", distances_of(small), { 10, 400 }, H5T_IEEE_F32LE, is_compressed);
      writer.add("quality", std::vector<double>(4000, 7.), { 4000 }, H5T_STD_I16LE, is_compressed);
      writer.add("of_model/xyz", points_of(small), { 4000, 3 });
    }
    assert(read(file.name) == small);
    assert(read(file.name, { "of_model/xyz", "quality", "" })[42].first == small[42].first);
    assert(read(file.name, { "", "quality", "" })[17].second == 7.);
    assert(read(file.name, { "", "", "quality" })[17].second == 7.);
    assert(read_pair(file.name, file.name) == small);
    const Test_file text("_points.xyz", "0 0 0\n");
    refuse_pair(text.name, file.name, { "1 point,", "4000 distances" });
    const Words contents = { "distances (10 x 400)", "item_id (of a single number)", "of_model/xyz (4000 x 3)",
                             "points (10 x 400 x 3)", "quality (4000)" };
    refuse(file, contents, { "vertices", "", "" });
    refuse(file, { "no data set \"vertices\"", "points_dataset" }, { "vertices", "", "" });
    refuse(file, contents, { "", "field", "" });
    refuse(file, { "no data set \"field\"", "distances_dataset", "separate file" }, { "", "field", "" });
    refuse(file, { "\"quality\" has the shape 4000;", "N x 3", "B x N x 3", "points_dataset" }, { "quality", "", "" });
    refuse(file, { "\"item_id\" holds no numbers" }, { "item_id", "", "" });
    refuse(file, { "\"of_model/xyz\" has the shape 4000 x 3,", "\"points\" 10 x 400 x 3", "exactly one distance" },
           { "", "of_model/xyz", "" });
  }
}

void test_hdf5_rows()
{
  const Cloud cloud = sample_cloud(300);
  std::vector<std::vector<double>> points(100), distances(100);
  for(std::size_t i = 0, row = 0; i < cloud.size(); ++i)
  {
    points[row].insert(points[row].end(), { cloud[i].first.x(), cloud[i].first.y(), cloud[i].first.z() });
    distances[row].push_back(cloud[i].second);
    if(i % 7 == 3)
      ++row;
  }
  const Test_file file(".h5");
  {
    Hdf5_writer writer(file.name);
    writer.add_rows("points", points);
    writer.add_rows("distances", distances, H5T_IEEE_F32LE);
    writer.add("flat", distances_of(cloud), { 300 });
    points[2].pop_back();
    writer.add_rows("bad", points);
    std::swap(distances[1], distances[90]);
    writer.add_rows("swapped", distances);
  }
  assert(read(file.name) == cloud);
  assert(read(file.name, { "", "flat", "" }) == cloud);
  refuse(file, { "\"bad\" has the shape 100 rows", "multiples of three" }, { "bad", "", "" });
  refuse(file, { "\"swapped\" has the shape 100 rows", "exactly one distance" }, { "", "swapped", "" });
}

void test_bad_hdf5()
{
  refuse(".h5", "", { "is empty", "get a complete copy" });
  refuse(".h5", "1 2 3 4\n", { "no HDF5 file", "truncated" });
  {
    const Test_file file(".h5");
    Hdf5_writer(file.name);
    refuse(file, { "no data set \"points\"", "no data set at all" });
  }
  {
    const Test_file file(".h5");
    {
      Hdf5_writer writer(file.name);
      writer.add("points", {}, { 0, 3 });
      writer.add("distances", {}, { 0 });
      writer.add("huge", {}, { hsize_t(1) << 40, 3 }, H5T_IEEE_F64LE, true, false);
      writer.add_external("elsewhere", 100);
      writer.add("vast", {}, { hsize_t(1) << 61, 3 }, H5T_STD_I8LE, true, false);
    }
    refuse(file, { "holds no points" });
    const auto begin = std::chrono::steady_clock::now();
    refuse(file, { "\"huge\" promises the shape 1099511627776 x 3 of 64 bit", "only 0 bytes", "never written" },
           { "huge", "", "" });
    refuse(file, { "\"elsewhere\"", "other files", "h5py" }, { "elsewhere", "", "" });
    refuse(file, { "\"vast\" promises", "only 0 bytes" }, { "vast", "", "" });
    assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
  }
  const Cloud cloud = sample_cloud(2000);
  const Test_file file(".h5");
  {
    Hdf5_writer writer(file.name);
    writer.add("points", points_of(cloud), { 2000, 3 }, H5T_IEEE_F64LE, true);
    writer.add("distances", distances_of(cloud), { 2000 });
  }
  assert(read(file.name) == cloud);
  const std::string good = file.content();
  for(std::size_t size = 1; size < good.size(); size += good.size() / 40)
    refuse(".h5", good.substr(0, size), { "truncated", "complete copy" });
}

// the library says nothing itself, and afterwards speaks to whom it spoke before
void test_silence()
{
  static int number_of_calls;
  const H5E_auto2_t count = [](hid_t, void*)
  {
    ++number_of_calls;
    return herr_t(0);
  };
  H5E_auto2_t old_function, function;
  void *old_data, *data;
  H5Eget_auto2(H5E_DEFAULT, &old_function, &old_data);
  H5Eset_auto2(H5E_DEFAULT, count, &number_of_calls);
  refuse(".h5", "1 2 3 4\n", { "no HDF5 file" });
  const Test_file file(".h5");
  Hdf5_writer(file.name).add("points", { 1, 2 }, { 2 });
  refuse(file, { "\"points\"" });
  assert(number_of_calls == 0);
  H5Eget_auto2(H5E_DEFAULT, &function, &data);
  assert(function == count && data == &number_of_calls);
  H5Fopen("input_none.h5", H5F_ACC_RDONLY, H5P_DEFAULT);
  assert(number_of_calls == 1);
  H5Eset_auto2(H5E_DEFAULT, old_function, old_data);
}

#else // without HDF5

void test_hdf5()
{
  for(const char* const suffix : { ".h5", ".hdf5", ".H5" })
    refuse(suffix, "anything", { "needs HDF5", "without which this program was built", "CGAL::Wireframe_extraction_HDF5",
                                 "libhdf5-dev" });
}

void test_hdf5_rows() {}
void test_bad_hdf5() {}
void test_silence() {}

#endif

// ---- PCD ----

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
  std::string ascii = pcd_header("normal x y z quality distance", "4 4 4 4 2 4", "F F F F U F", "3 1 1 1 1 1", n,
                                 "ascii");
  std::string binary = pcd_header("x _ y z rgb Distance", "8 1 4 4 4 8", "F U F F U F", "1 3 1 1 1 1", n, "binary");
  for(const auto& sample : cloud)
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
  assert(read(ascii_file.name, { "", "", "quality" })[5].second == 3.);
  const Test_file distances("_distances.npy", npy(std::vector<double>(cloud.size(), 2.), { cloud.size() }));
  assert(read_pair(binary_file.name, distances.name)[9].second == 2.);
  const Test_file no_points(".pcd", "FIELDS x y z distance\nWIDTH 2\nHEIGHT 2\nDATA ascii\n"
                                    "0 0 0 0\n1 1 1 1\n2 2 2 2\n3 3 3 3");
  assert(read(no_points.name).size() == 4);

  const auto header = [](const std::string& number, const std::string& kind)
  { return pcd_header("x y z distance", "4 4 4 4", "F F F F", "1 1 1 1", number, kind); };
  refuse(".pcd", "", { "is empty", "get a complete copy" });
  refuse(".pcd", "ply\n", { ":1:", "\"ply\" starts no PCD file" });
  refuse(".pcd", "VERSION 0.7\nCOLOUR 1\n", { ":2:", "\"COLOUR\"" });
  refuse(".pcd", "VERSION 0.7\nFIELDS x y z\n", { "truncated", "DATA" });
  refuse(".pcd", "DATA ascii\n", { "no FIELDS" });
  refuse(".pcd", "FIELDS x y z distance\nDATA ascii\n", { "POINTS", "WIDTH" });
  refuse(".pcd", "FIELDS x y z distance\nSIZE 4 4 4\n", { ":2:", "SIZE has 3 entries", "FIELDS 4" });
  refuse(".pcd", "FIELDS x y z distance\nSIZE 4 4 4 9\n", { ":2:", "\"9\"", "size" });
  refuse(".pcd", "FIELDS x y z distance\nCOUNT 1 1 1 9999999\n", { ":2:", "\"9999999\"", "count" });
  refuse(".pcd", "FIELDS x y z distance\nTYPE F F F D\n", { ":2:", "\"D\"", "type" });
  refuse(".pcd", "FIELDS x y z distance\nPOINTS many\n", { ":2:", "POINTS", "number" });
  refuse(".pcd", "FIELDS x y z distance\nPOINTS 5\nWIDTH 2\nHEIGHT 3\nDATA ascii\n", { "5 POINTS", "WIDTH 2", "3" });
  refuse(".pcd", "FIELDS x y z distance\nWIDTH 18446744073709551615\nHEIGHT 3\nDATA binary\n0123456789abcdef",
         { "promises", "truncated" });
  refuse(".pcd", header("1", "binary_compressed"), { ":11:", "compressed", "pcl_convert_pcd_ascii_binary",
                                                   "pcl-tools" });
  refuse(".pcd", header("1", "text"), { ":11:", "ascii or binary", "\"text\"" });
  refuse(".pcd", header("1", "ascii"), { "truncated", "after 0 of 1 points" });
  refuse(".pcd", header("1", "ascii") + "1 2 3\n", { ":12:", "3 values", "4" });
  refuse(".pcd", header("1", "ascii") + "1 2 3 far\n", { ":12:", "\"far\"" });
  refuse(".pcd", header("1", "ascii") + "1 2 nan 4\n", { "point 0", "line 12", "skip_invalid" });
  refuse(".pcd", header("1", "ascii") + "1 2 3 4\n5 6 7 8\n", { "more than the 1 points" });
  refuse(".pcd", header("0", "ascii"), { "holds no points" });
  refuse(".pcd", header("2", "binary") + std::string(31, '\0'), { "promises 2 points of 16 bytes", "31", "truncated" });
  refuse(".pcd", header("1000000000000", "binary") + std::string(31, '\0'), { "1000000000000", "truncated" });
  refuse(".pcd", header("18446744073709551615", "ascii") + "1 2 3 4\n", { "after 1 of 18446744073709551615" });
  refuse(".pcd", header("1", "binary") + std::string(32, '\0'), { "more than the 1 points" });
  refuse(".pcd", pcd_header("x y z rgb", "4 4 4 4", "F F F U", "1 1 1 1", "1", "ascii") + "1 2 3 4\n",
         { "no field for the distance", "sharpness", "x, y, z, rgb", "distance_property", "separate file" });
  refuse(".pcd", header("1", "ascii") + "1 2 3 4\n", { "no field \"own\"", "x, y, z, distance" }, { "", "", "own" });
  refuse(".pcd", pcd_header("x y distance", "4 4 4", "F F F", "1 1 1", "1", "ascii"), { "no field \"z\"" });
  refuse(".pcd", pcd_header("x y z distance", "4 4 4 4", "F F F F", "1 1 1 2", "1", "ascii"),
         { "\"distance\" has 2 numbers" });
  refuse(".pcd", pcd_header("x y z distance", "4 4 4 3", "F F F F", "1 1 1 1", "1", "ascii"),
         { "\"distance\"", "F of size 3" });
  refuse(".pcd", pcd_header("x y z distance", "0 0 0 0", "F F F F", "0 0 0 0", "9", "binary"), { "0 numbers" });
}

// ---- meshes ----

void test_off()
{
  const Cloud expected = { { Point(0, 0, 0), 0.5 }, { Point(1, 0, 0), 1 }, { Point(0, 1.5, -2), 0 } };
  const Test_file distances("_distances.txt", "0.5\n1\n0\n");
  for(const char* const text : { "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1.5 -2\n3 0 1 2\n",
                                 "OFF 3 1 0 # a comment\n\n# another\n0 0 0\n1 0 0 # 7\n0 1.5 -2\n3 0 1 2\n",
                                 "COFF\r\n3 1 0\r\n0 0 0 255 0 0 255\r\n1 0 0 255 0 0 255\r\n0 1.5 -2 0 0 0 0\r\n",
                                 "NOFF\n3 0 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1.5 -2 0 0 1\n",
                                 "STCNOFF\n3 0\n0 0 0 1\n1 0 0 1\n0 1.5 -2 1" })
  {
    const Test_file file(".off", text);
    assert(read_pair(file.name, distances.name) == expected);
    refuse(file, { "no distances", "separate file", "PLY" });
  }
  const auto refuse_off = [&](const std::string& text, const Words& words)
  {
    const Test_file file(".off", text);
    refuse_pair(file.name, distances.name, words);
    refuse_pair(file.name, distances.name, { file.name });
  };
  refuse_off("", { "is empty", "get a complete copy" });
  refuse_off("# nothing\n", { "truncated", "header" });
  refuse_off("solid\n", { ":1:", "\"solid\"", "COFF" });
  refuse_off("4OFF\n1 0 0\n0 0 0 0\n", { ":1:", "\"4OFF\"", "three coordinates" });
  refuse_off("OFF BINARY\n", { ":1:", "binary", "PLY" });
  refuse_off("OFF\n", { "truncated", "number of vertices" });
  refuse_off("OFF\nmany 1 0\n", { ":2:", "\"many\"" });
  refuse_off("OFF\n1 0 0 0\n", { ":2:", "numbers of vertices" });
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0 0\n", { "truncated", "after 2 of 3 vertices" });
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0\n0 0 1\n", { ":4:", "2 values" });
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0 x\n0 0 1\n", { ":4:", "\"x\"" });
  refuse_off("OFF\n3 1 0\n0 0 0\n1 0 inf\n0 0 1\n", { "point 1", "line 4" });
  refuse_off("OFF\n4 1 0\n0 0 0\n1 0 0\n0 0 1\n0 0 2\n", { "4 points", "3 distances" });
  refuse_off("OFF\n0 0 0\n", { "holds no points" });
  refuse_off("OFF\n1000000000000 1 0\n0 0 0\n", { "promises 1000000000000 vertices", "truncated" });
  refuse_off("OFF\n18446744073709551615 1 0\n0 0 0\n", { "promises 18446744073709551615 vertices" });
}

void test_mesh_in_ply()
{
  const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\nproperty float quality\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n0 0 0 0.5\n1 0 0 1\n0 1.5 -2 0\n";
  const Test_file file(".ply", vertices + "3 0 1 2\n");
  const Cloud expected = { { Point(0, 0, 0), 0.5 }, { Point(1, 0, 0), 1 }, { Point(0, 1.5, -2), 0 } };
  assert(read(file.name) == expected);
  std::string binary = vertices.substr(0, vertices.find("end_header"));
  binary.replace(binary.find("ascii"), 5, "binary_big_endian");
  binary += "end_header\n";
  for(const float value : { 0.f, 0.f, 0.f, .5f, 1.f, 0.f, 0.f, 1.f, 0.f, 1.5f, -2.f, 0.f })
    append(value, true, binary);
  binary += '\3';
  for(const std::int32_t index : { 0, 1, 2 })
    append(index, true, binary);
  const Test_file binary_file(".ply", binary);
  assert(read(binary_file.name) == expected);
}

// ---- patches ----

// The points of a box's surface, in the order that fusion by positions gives. Coordinates are such that text and
// double hold them.
Cloud box_cloud()
{
  Cloud cloud;
  std::mt19937 random(3);
  for(int x = 0; x <= 20; ++x)
    for(int y = 0; y <= 20; ++y)
      for(int z = 0; z <= 20; ++z)
        if(x % 20 == 0 || y % 20 == 0 || z % 20 == 0)
          cloud.emplace_back(Point(x * 0.25 - 2., y * 0.25, z * 0.25 + 1.), (random() % 1000) / 1024.);
  return cloud;
}

// Cuts a cloud into parts that overlap; where a point is in several, all but one say "far".
Patches cut(const Cloud& cloud, bool has_indices, double far)
{
  Patches patches;
  for(int x = 0; x < 3; ++x)
    for(int z = 0; z < 2; ++z)
    {
      Patch patch;
      for(std::size_t i = 0; i < cloud.size(); ++i)
      {
        const Point& p = cloud[i].first;
        const double u = (p.x() + 2.) / 5. * 3. - x, v = (p.z() - 1.) / 5. * 2. - z;
        if(u < -0.3 || u > 1.3 || v < -0.3 || v > 1.3)
          continue;
        const bool is_inside = (u >= 0. || x == 0) && (u < 1. || x == 2) && (v >= 0. || z == 0) && (v < 1. || z == 1);
        patch.samples.emplace_back(p, is_inside ? cloud[i].second : far);
        if(has_indices)
          patch.indices.push_back(i);
      }
      patches.push_back(patch);
    }
  return patches;
}

Cloud fuse(const Patches& patches, Patch_fusion fusion = Patch_fusion::MINIMUM)
{
  Cloud cloud = { { Point(9, 9, 9), 9 } };
  std::string error = "old";
  if(!CGAL::Wireframe_extraction::fuse_distance_patches(
       patches, cloud, parameters::patch_fusion(fusion).error_message(&error)))
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty());
  return cloud;
}

void refuse_to_fuse(const Patches& patches, const Words& words)
{
  const Cloud before = { { Point(9, 9, 9), 9 } };
  Cloud cloud = before;
  std::string error;
  assert(!CGAL::Wireframe_extraction::fuse_distance_patches(patches, cloud, parameters::error_message(&error)));
  check_words(error, words);
  assert(cloud == before);
}

void test_fusion()
{
  const Cloud cloud = box_cloud();
  std::mt19937 random(11);
  for(const bool has_indices : { false, true })
  {
    Patches patches = cut(cloud, has_indices, 1.);
    std::size_t count = 0;
    for(const Patch& patch : patches)
      count += patch.samples.size();
    assert(count > cloud.size() + cloud.size() / 2);
    assert(fuse(patches) == cloud);
    const Cloud median = fuse(patches, Patch_fusion::MEDIAN);
    assert(median != cloud && median.size() == cloud.size());
    // the same whatever the order of patches and points
    for(int i = 0; i < 20; ++i)
    {
      std::shuffle(patches.begin(), patches.end(), random);
      for(Patch& patch : patches)
      {
        const std::size_t a = random() % patch.samples.size(), b = random() % patch.samples.size();
        std::swap(patch.samples[a], patch.samples[b]);
        if(has_indices)
          std::swap(patch.indices[a], patch.indices[b]);
      }
      assert(fuse(patches) == cloud);
      assert(fuse(patches, Patch_fusion::MEDIAN) == median);
    }
  }
}

void test_fusion_of_values()
{
  const Point a(0, 0, 0), b(1, 0, 0), c(1, 1, 1);
  const auto one = [](const Point& p, double distance) { return Patch{ { { p, distance } }, {} }; };
  Patches patches = { one(a, 5), one(b, 1), one(a, 2), one(a, 9), one(b, 3), one(c, 0) };
  assert(fuse(patches) == (Cloud{ { a, 2 }, { b, 1 }, { c, 0 } }));
  assert(fuse(patches, Patch_fusion::MEDIAN) == (Cloud{ { a, 5 }, { b, 2 }, { c, 0 } }));
  patches.push_back(Patch()); // an empty one says nothing
  assert(fuse(patches) == (Cloud{ { a, 2 }, { b, 1 }, { c, 0 } }));
  assert(fuse({ one(b, 3) }) == (Cloud{ { b, 3 } }));
  assert(fuse({ one(b, 3), one(b, 2) }) == (Cloud{ { b, 2 } }));

  // close points are the same, but not those beyond the tolerance, which is 1e-6 of the diagonal
  const double unit = 1e-6 * std::sqrt(3.);
  for(const Point& step : { Point(1, 0, 0), Point(0, -1, 0), Point(0.6, 0.6, -0.5) })
  {
    const auto moved = [&](double length)
    { return Point(0.5 + length * step.x(), 0.5 + length * step.y(), 0.5 + length * step.z()); };
    assert(fuse({ one(a, 1), one(c, 1), one(moved(0), 2), one(moved(0.95 * unit), 3) }).size() == 3);
    assert(fuse({ one(a, 1), one(c, 1), one(moved(0), 2), one(moved(1.1 * unit), 3) }).size() == 4);
    // in a chain, all are
    const Cloud chain = fuse({ one(a, 1), one(c, 1), one(moved(1.8 * unit), 2), one(moved(0.9 * unit), 1.5),
                               one(moved(0), 3) });
    assert(chain.size() == 3 && chain[1].second == 1.5);
  }

  // indices count more than positions
  Patches indexed = { Patch{ { { c, 1 }, { a, 2 } }, { 7, 3 } },
                      Patch{ { { Point(0, 0, 1e-4), 1 }, { c, 4 } }, { 3, 8 } } };
  assert(fuse(indexed) == (Cloud{ { a, 1 }, { c, 1 }, { c, 4 } }));
  indexed[1].indices.clear(); // not all have them: positions count
  assert(fuse(indexed) == (Cloud{ { a, 2 }, { Point(0, 0, 1e-4), 1 }, { c, 1 } }));

  refuse_to_fuse({}, { "no points" });
  refuse_to_fuse({ Patch() }, { "no points" });
  refuse_to_fuse({ one(Point(0, std::nan(""), 0), 1) }, { "coordinate", "not finite" });
  refuse_to_fuse({ one(a, -1) }, { "distance", "negative" });
  refuse_to_fuse({ one(a, HUGE_VAL) }, { "distance", "not finite" });
  refuse_to_fuse({ Patch{ { { a, 1 }, { b, 1 } }, { 1 } } }, { "2 points", "1 index;" });
  // indices of the patch instead of the cloud
  refuse_to_fuse({ Patch{ { { a, 1 }, { b, 1 } }, { 0, 1 } }, Patch{ { { a, 1 }, { c, 1 } }, { 0, 1 } } },
                 { "index 1 ", "(1 0 0) and (1 1 1)", "whole cloud", "indices_dataset", "use_indices" });
}

// as many points as clouds have, all of them twice, on planes; and many times the same one
void test_fusion_is_fast()
{
  Patches patches(2);
  for(int x = 0; x < 400; ++x)
    for(int y = 0; y < 400; ++y)
      for(Patch& patch : patches)
        patch.samples.emplace_back(x % 2 == 0 ? Point(x, y, 0) : Point(0, x, y + 1), &patch == &patches[0] ? 1. : 2.);
  patches[1].samples.insert(patches[1].samples.end(), 100000, { Point(0, 0, 0), 3. });
  const auto begin = std::chrono::steady_clock::now();
  const Cloud cloud = fuse(patches);
  assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(30));
  assert(cloud.size() == 160000);
  for(const auto& sample : cloud)
    assert(sample.second == 1.);
}

bool read_patches(const std::vector<std::string>& names, Patches& patches, std::string& error,
                  const std::string& indices = "", bool use_indices = true)
{
  return CGAL::IO::read_distance_patches(
    names, patches, parameters::indices_dataset(indices).use_indices(use_indices).error_message(&error));
}

void test_patch_files()
{
  const Cloud cloud = box_cloud();
  const Patches expected = cut(cloud, true, 1.);
  // each patch in a format of its own
  const auto& samples = expected;
  const auto indices_of = [&](std::size_t i)
  { return std::vector<double>(samples[i].indices.begin(), samples[i].indices.end()); };
  const auto npz_of = [&](std::size_t i, const std::string& indices, unsigned method)
  {
    const std::size_t n = samples[i].samples.size();
    return zip({ { "points.npy", npy(points_of(samples[i].samples), { n, 3 }) },
                 { "distances.npy", npy(distances_of(samples[i].samples), { n }) },
                 { indices + ".npy", npy(indices_of(i), { n }, "<i8") } }, method);
  };
  std::string text;
  for(const auto& sample : samples[2].samples)
    text += std::to_string(sample.first.x()) + " " + std::to_string(sample.first.y()) + " "
            + std::to_string(sample.first.z()) + " " + CGAL::IO::internal::number_to_string(sample.second) + "\n";
  const Test_file a("_a.npz", npz_of(0, "indices", zip_methods().back()));
  const Test_file b("_b.npz", npz_of(1, "indexes_in_whole", 0));
  const Test_file c("_c.xyz", text), c_indexed("_c.npz", npz_of(2, "own", 0));
  const Test_file d("_d.npy", npy(rows_of_four(samples[3].samples), { samples[3].samples.size(), 4 }));
  const Test_file e("_e.npz", npz_of(4, "indices", 0)), f("_f.npz", npz_of(5, "indices", 0));
  Patches patches;
  std::string error;
  assert(read_patches({ a.name, b.name, c.name, d.name, e.name, f.name }, patches, error));
  assert(error.empty() && patches.size() == 6);
  for(std::size_t i = 0; i < 6; ++i)
    assert(patches[i].samples == expected[i].samples
           && patches[i].indices == (i == 2 || i == 3 ? std::vector<std::size_t>() : expected[i].indices));
  assert(fuse(patches) == cloud);

  assert(read_patches({ a.name, b.name }, patches, error, "", false));
  assert(patches[0].indices.empty() && patches[1].indices.empty());
  assert(read_patches({ c_indexed.name }, patches, error, "own") && patches[0].indices == expected[2].indices);
  assert(!read_patches({ a.name, b.name }, patches, error, "indices"));
  check_words(error, { b.name, "no array \"indices\"", "indexes_in_whole", "indices_dataset" });
  assert(patches.size() == 1); // as it was
  assert(!read_patches({ a.name }, patches, error, "points"));
  check_words(error, { a.name, "\"points\" has the shape", "exactly one index", "indices_dataset" });
  assert(!read_patches({ a.name }, patches, error, "distances"));
  check_words(error, { a.name, "\"distances\"", "no index", "indices_dataset" });
  assert(!read_patches({ a.name, "input_none.npz" }, patches, error));
  check_words(error, { "input_none.npz", "No such file" });
  assert(!read_patches({}, patches, error));
  check_words(error, { "no names" });

  // invalid points are left out with their indices
  const double nan = std::nan("");
  const Test_file holes(".npz", zip({ { "points.npy", npy({ 0, 0, 0, nan, 0, 0, 2, 2, 2 }, { 3, 3 }) },
                                      { "distances.npy", npy({ 1, 2, 3 }, { 3 }) },
                                      { "indices.npy", npy({ 5, 6, 7 }, { 3 }, "<u2") } }, 0));
  std::size_t number_of_skipped = 0;
  assert(CGAL::IO::read_distance_patches(std::vector<std::string>{ holes.name, holes.name }, patches,
    parameters::skip_invalid(true).number_of_skipped(&number_of_skipped)));
  assert(number_of_skipped == 2 && patches[1].samples.size() == 2);
  assert((patches[1].indices == std::vector<std::size_t>{ 5, 7 }));

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
  // all patches of a model in one file, as rows of their lengths
  const Test_file file(".hdf5");
  {
    std::vector<std::vector<double>> points, distances, indices;
    for(std::size_t i = 0; i < samples.size(); ++i)
    {
      points.push_back(points_of(samples[i].samples));
      distances.push_back(distances_of(samples[i].samples));
      indices.push_back(indices_of(i));
    }
    Hdf5_writer writer(file.name);
    writer.add_rows("points", points);
    writer.add_rows("distances", distances);
    writer.add_rows("indexes_in_whole", indices, H5T_STD_I32LE);
  }
  assert(read_patches({ file.name }, patches, error));
  assert(patches.size() == 1 && patches[0].indices.size() == patches[0].samples.size());
  assert(fuse(patches) == cloud);
  assert(read_patches({ file.name }, patches, error, "", false) && patches[0].indices.empty());
  assert(fuse(patches) == cloud);
#endif
}

// one point far off, as some programs write it for "no value", must not make the others look the same
void test_fusion_with_a_far_point()
{
  Patches patches(2);
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 10; ++y)
      for (Patches::value_type& patch : patches)
        patch.samples.emplace_back(Point(0.01 * x, 0.01 * y, 0.), 0.1 * x);
  patches[1].samples.emplace_back(Point(-9999., -9999., -9999.), 1.);
  assert(fuse(patches).size() == 101);
}

void test_small_number_types()
{
  std::vector<std::pair<CGAL::Simple_cartesian<float>::Point_3, float>> cloud;
  std::string error;
  const Test_file file(".npy", npy({ 1, 2, 3, 1e300 }, { 1, 4 }));
  assert(!CGAL::IO::read_distance_cloud(file.name, cloud, parameters::error_message(&error)));
  check_words(error, { "point 0", "1e+300" });
  std::vector<CGAL::Wireframe_extraction::Distance_patch<CGAL::Simple_cartesian<float>::Point_3, float>> patches(2);
  patches[0].samples = { { { 1.f, 2.f, 3.f }, 4.f } };
  patches[1].samples = { { { 1.f, 2.f, 3.f }, 3.f } };
  assert(CGAL::Wireframe_extraction::fuse_distance_patches(patches, cloud));
  assert(cloud.size() == 1 && cloud[0].second == 3.f);
}

int main()
{
  const auto count_files = [] { return std::distance(fs::directory_iterator("."), fs::directory_iterator()); };
  const auto before = count_files();
  test_npy();
  test_bad_npy();
  test_npz();
  test_bad_npz();
  test_hdf5();
  test_hdf5_rows();
  test_bad_hdf5();
  test_silence();
  test_pcd();
  test_off();
  test_mesh_in_ply();
  test_fusion();
  test_fusion_of_values();
  test_fusion_is_fast();
  test_fusion_with_a_far_point();
  test_patch_files();
  test_small_number_types();
  assert(count_files() == before);
  return 0;
}
