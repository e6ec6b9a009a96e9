// Clouds in HDF5, or what is said without that library.

#include "Hdf5_writer.h"
#include "cloud_file_checks.h"

#include <CGAL/Wireframe_extraction/IO/Distance_cloud_file.h>

#include <cassert>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

namespace fs = std::filesystem;

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5

void test_hdf5()
{
  const Cloud cloud = sample_cloud(600000); // more than one slab
  const hsize_t n = cloud.size();
  {
    const Test_file file(".h5");
    {
      Hdf5_writer writer(file.name);
      writer.add("points", points_of(cloud), {n, 3}, H5T_IEEE_F32LE);
      writer.add("distances", distances_of(cloud), {n}, H5T_IEEE_F32BE);
    }
    assert(read(file.name) == cloud);
  }
  for (const bool is_compressed : {false, true})
  {
    const Cloud small = sample_cloud(4000);
    const Test_file file(".HDF5");
    {
      Hdf5_writer writer(file.name);
      writer.add_group("of_model");
      writer.add_text("item_id"); // and no has_sharp
      writer.add("points", points_of(small), {10, 400, 3}, H5T_IEEE_F64BE, is_compressed);
      writer.add("distances", distances_of(small), {10, 400}, H5T_IEEE_F32LE, is_compressed);
      writer.add("quality", std::vector<double>(4000, 7.), {4000}, H5T_STD_I16LE, is_compressed);
      writer.add("of_model/xyz", points_of(small), {4000, 3});
    }
    assert(read(file.name) == small);
    assert(read(file.name, {"of_model/xyz", "quality", ""})[42].first == small[42].first);
    assert(read(file.name, {"", "quality", ""})[17].second == 7.);
    assert(read(file.name, {"", "", "quality"})[17].second == 7.);
    assert(read_pair(file.name, file.name) == small);
    const Test_file text("_points.xyz", "0 0 0\n");
    refuse_pair(text.name, file.name, {"1 point,", "4000 distances"});
    const Words contents = {"distances (10 x 400)", "item_id (of a single number)", "of_model/xyz (4000 x 3)",
                            "points (10 x 400 x 3)", "quality (4000)"};
    refuse(file, contents, {"vertices", "", ""});
    refuse(file, {"no data set \"vertices\"", "points_dataset"}, {"vertices", "", ""});
    refuse(file, contents, {"", "field", ""});
    refuse(file, {"no data set \"field\"", "distances_dataset", "separate file"}, {"", "field", ""});
    refuse(file, {"\"quality\" has the shape 4000;", "N x 3", "B x N x 3", "points_dataset"}, {"quality", "", ""});
    refuse(file, {"\"item_id\" holds no numbers"}, {"item_id", "", ""});
    refuse(file, {"\"of_model/xyz\" has the shape 4000 x 3,", "\"points\" 10 x 400 x 3", "exactly one distance"},
           {"", "of_model/xyz", ""});
  }
}

// points only, and points with distances that are not to be looked at
void test_without_distances()
{
  namespace WE = CGAL::Wireframe_extraction;
  namespace WP = CGAL::Wireframe_extraction::parameters;
  typedef WE::Distance_cloud_source::Sample Sample;
  const Cloud cloud = sample_cloud(4000);
  for (const bool has_distances : {false, true})
  {
    const Test_file file(".h5");
    {
      Hdf5_writer writer(file.name);
      writer.add("points", points_of(cloud), {10, 400, 3});
      if (has_distances)
        writer.add("distances", std::vector<double>(4000, -1.), {10, 400});
    }
    CGAL::IO::Distance_cloud_file source(
      file.name, WP::field_origin(has_distances ? WE::Field_origin::ESTIMATED : WE::Field_origin::AUTOMATIC));
    std::size_t i = 0;
    assert(source.read([&](const Sample* first, const Sample* beyond) {
      for (; first != beyond; ++first, ++i)
        assert(first->x == cloud[i].first.x() && first->y == cloud[i].first.y() && first->z == cloud[i].first.z());
      return true;
    }));
    assert(i == cloud.size() && !source.has_distances() && source.assumption().empty());
    CGAL::IO::Distance_cloud_file given(file.name);
    assert(!given.read([](const Sample*, const Sample*) { return true; }));
    assert(has_distances || given.error_message().find("field_origin") != std::string::npos);
  }
}

void test_hdf5_rows()
{
  const Cloud cloud = sample_cloud(300);
  std::vector<std::vector<double>> points(100), distances(100);
  for (std::size_t i = 0, row = 0; i < cloud.size(); ++i)
  {
    points[row].insert(points[row].end(), {cloud[i].first.x(), cloud[i].first.y(), cloud[i].first.z()});
    distances[row].push_back(cloud[i].second);
    if (i % 7 == 3)
      ++row;
  }
  const Test_file file(".h5");
  {
    Hdf5_writer writer(file.name);
    writer.add_rows("points", points);
    writer.add_rows("distances", distances, H5T_IEEE_F32LE);
    writer.add("flat", distances_of(cloud), {300});
    points[2].pop_back();
    writer.add_rows("bad", points);
    std::swap(distances[1], distances[90]);
    writer.add_rows("swapped", distances);
  }
  assert(read(file.name) == cloud);
  assert(read(file.name, {"", "flat", ""}) == cloud);
  refuse(file, {"\"bad\" has the shape 100 rows", "multiples of three"}, {"bad", "", ""});
  refuse(file, {"\"swapped\" has the shape 100 rows", "exactly one distance"}, {"", "swapped", ""});
}

void test_bad_hdf5()
{
  refuse(".h5", "", {"is empty", "get a complete copy"});
  refuse(".h5", "1 2 3 4\n", {"no HDF5 file", "truncated"});
  {
    const Test_file file(".h5");
    Hdf5_writer(file.name);
    refuse(file, {"no data set \"points\"", "no data set at all"});
  }
  {
    const Test_file file(".h5");
    {
      Hdf5_writer writer(file.name);
      writer.add("points", {}, {0, 3});
      writer.add("distances", {}, {0});
      writer.add("huge", {}, {hsize_t(1) << 40, 3}, H5T_IEEE_F64LE, true, false);
      writer.add_external("elsewhere", 100);
      writer.add("vast", {}, {hsize_t(1) << 61, 3}, H5T_STD_I8LE, true, false);
    }
    refuse(file, {"holds no points"});
    const auto begin = std::chrono::steady_clock::now();
    refuse(file, {"\"huge\" promises the shape 1099511627776 x 3 of 64 bit", "only 0 bytes", "never written"},
           {"huge", "", ""});
    refuse(file, {"\"elsewhere\"", "other files", "h5py"}, {"elsewhere", "", ""});
    refuse(file, {"\"vast\" promises", "only 0 bytes"}, {"vast", "", ""});
    assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(10));
  }
  const Cloud cloud = sample_cloud(2000);
  const Test_file file(".h5");
  {
    Hdf5_writer writer(file.name);
    writer.add("points", points_of(cloud), {2000, 3}, H5T_IEEE_F64LE, true);
    writer.add("distances", distances_of(cloud), {2000});
  }
  assert(read(file.name) == cloud);
  const std::string good = file.content();
  for (std::size_t size = 1; size < good.size(); size += good.size() / 40)
    refuse(".h5", good.substr(0, size), {"truncated", "complete copy"});
}

void test_lzf()
{
  const Cloud cloud = sample_cloud(6000);
  const auto keep = [](const std::vector<unsigned char>&) {};
  const Test_file file(".h5");
  {
    Hdf5_writer writer(file.name);
    writer.add_lzf("points", points_of(cloud), {6, 1000, 3}, keep);
    writer.add_lzf("distances", distances_of(cloud), {6, 1000}, keep);
    writer.add_lzf("equal", std::vector<double>(6000, 3.), {6, 1000}, keep); // it repeats what it repeats
    writer.add_lzf("short", distances_of(cloud), {6, 1000}, [](std::vector<unsigned char>& data) { data.pop_back(); });
    writer.add_lzf("long", distances_of(cloud), {6, 1000}, [](std::vector<unsigned char>& data) {
      data.insert(data.end(), {0, 7});
    });
    writer.add_lzf("before", distances_of(cloud), {6, 1000}, [](std::vector<unsigned char>& data) {
      data = {0, 7, 0xff, 0xff, 1}; // a byte, and what would have to come before it
    });
    writer.add_lzf("run", distances_of(cloud), {6, 1000},
                   [](std::vector<unsigned char>& data) { data.assign(30, 31); });
    writer.add_filtered("foreign", {6000}, {6000}, 32099, {});
  }
  assert(read(file.name) == cloud);
  assert(read(file.name, {"", "equal", ""})[4567].second == 3.);
  for (const char* const name : {"short", "long", "before", "run"})
    refuse(file, {"\"" + std::string(name) + "\" cannot be read", "damaged"}, {"", name, ""});
  refuse(file, {"\"foreign\"", "filter", "32099", "h5repack"}, {"", "foreign", ""});
}

// the library says nothing itself, and afterwards speaks to whom it spoke before
void test_silence()
{
  static int number_of_calls;
  const H5E_auto2_t count = [](hid_t, void*) {
    ++number_of_calls;
    return herr_t(0);
  };
  H5E_auto2_t old_function, function;
  void *old_data, *data;
  H5Eget_auto2(H5E_DEFAULT, &old_function, &old_data);
  H5Eset_auto2(H5E_DEFAULT, count, &number_of_calls);
  refuse(".h5", "1 2 3 4\n", {"no HDF5 file"});
  const Test_file file(".h5");
  Hdf5_writer(file.name).add("points", {1, 2}, {2});
  refuse(file, {"\"points\""});
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
  for (const char* const suffix : {".h5", ".hdf5", ".H5"})
    refuse(suffix, "anything",
           {"needs HDF5", "without which this program was built", "CGAL::Wireframe_extraction_HDF5", "libhdf5-dev"});
}

#endif

int main()
{
  const auto count_files = [] { return std::distance(fs::directory_iterator("."), fs::directory_iterator()); };
  const auto before = count_files();
  test_hdf5();
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
  test_without_distances();
  test_hdf5_rows();
  test_lzf();
  test_bad_hdf5();
  test_silence();
#endif
  assert(count_files() == before);
  return 0;
}
