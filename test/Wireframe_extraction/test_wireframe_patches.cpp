// Overlapping patches of a cloud: their files, and their fusion.

#include <CGAL/Wireframe_extraction/fuse_distance_patches.h>

#include "Hdf5_writer.h"
#include "cloud_file_checks.h"
#include "numpy_writers.h"

#include <CGAL/Wireframe_extraction/IO/read_distance_patches.h>

#include <cassert>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

typedef CGAL::Wireframe_extraction::Distance_patch<Point, double> Patch;
typedef std::vector<Patch> Patches;
typedef CGAL::Wireframe_extraction::Patch_fusion Patch_fusion;

// The points of a box's surface, in the order that fusion by positions gives. Coordinates are such that text and
// double hold them.
Cloud box_cloud()
{
  Cloud cloud;
  std::mt19937 random(3);
  for (int x = 0; x <= 20; ++x)
    for (int y = 0; y <= 20; ++y)
      for (int z = 0; z <= 20; ++z)
        if (x % 20 == 0 || y % 20 == 0 || z % 20 == 0)
          cloud.emplace_back(Point(x * 0.25 - 2., y * 0.25, z * 0.25 + 1.), (random() % 1000) / 1024.);
  return cloud;
}

// Cuts a cloud into parts that overlap; where a point is in several, all but one say "far".
Patches cut(const Cloud& cloud, bool has_indices, double far)
{
  Patches patches;
  for (int x = 0; x < 3; ++x)
    for (int z = 0; z < 2; ++z)
    {
      Patch patch;
      for (std::size_t i = 0; i < cloud.size(); ++i)
      {
        const Point& p = cloud[i].first;
        const double u = (p.x() + 2.) / 5. * 3. - x, v = (p.z() - 1.) / 5. * 2. - z;
        if (u < -0.3 || u > 1.3 || v < -0.3 || v > 1.3)
          continue;
        const bool is_inside = (u >= 0. || x == 0) && (u < 1. || x == 2) && (v >= 0. || z == 0) && (v < 1. || z == 1);
        patch.samples.emplace_back(p, is_inside ? cloud[i].second : far);
        if (has_indices)
          patch.indices.push_back(i);
      }
      patches.push_back(patch);
    }
  return patches;
}

Cloud fuse(const Patches& patches, Patch_fusion fusion = Patch_fusion::MINIMUM)
{
  Cloud cloud = {{Point(9, 9, 9), 9}};
  std::string error = "old";
  if (!CGAL::Wireframe_extraction::fuse_distance_patches(patches, cloud,
                                                         parameters::patch_fusion(fusion).error_message(&error)))
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty());
  return cloud;
}

void refuse_to_fuse(const Patches& patches, const Words& words)
{
  const Cloud before = {{Point(9, 9, 9), 9}};
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
  for (const bool has_indices : {false, true})
  {
    Patches patches = cut(cloud, has_indices, 1.);
    std::size_t count = 0;
    for (const Patch& patch : patches)
      count += patch.samples.size();
    assert(count > cloud.size() + cloud.size() / 2);
    assert(fuse(patches) == cloud);
    const Cloud median = fuse(patches, Patch_fusion::MEDIAN);
    assert(median != cloud && median.size() == cloud.size());
    // the same whatever the order of patches and points
    for (int i = 0; i < 20; ++i)
    {
      std::shuffle(patches.begin(), patches.end(), random);
      for (Patch& patch : patches)
      {
        const std::size_t a = random() % patch.samples.size(), b = random() % patch.samples.size();
        std::swap(patch.samples[a], patch.samples[b]);
        if (has_indices)
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
  const auto one = [](const Point& p, double distance) { return Patch{{{p, distance}}, {}}; };
  Patches patches = {one(a, 5), one(b, 1), one(a, 2), one(a, 9), one(b, 3), one(c, 0)};
  assert(fuse(patches) == (Cloud{{a, 2}, {b, 1}, {c, 0}}));
  assert(fuse(patches, Patch_fusion::MEDIAN) == (Cloud{{a, 5}, {b, 2}, {c, 0}}));
  patches.push_back(Patch()); // an empty one says nothing
  assert(fuse(patches) == (Cloud{{a, 2}, {b, 1}, {c, 0}}));
  assert(fuse({one(b, 3)}) == (Cloud{{b, 3}}));
  assert(fuse({one(b, 3), one(b, 2)}) == (Cloud{{b, 2}}));

  // close points are the same, but not those beyond the tolerance, which is 1e-6 of the diagonal
  const double unit = 1e-6 * std::sqrt(3.);
  for (const Point& step : {Point(1, 0, 0), Point(0, -1, 0), Point(0.6, 0.6, -0.5)})
  {
    const auto moved = [&](double length) {
      return Point(0.5 + length * step.x(), 0.5 + length * step.y(), 0.5 + length * step.z());
    };
    assert(fuse({one(a, 1), one(c, 1), one(moved(0), 2), one(moved(0.95 * unit), 3)}).size() == 3);
    assert(fuse({one(a, 1), one(c, 1), one(moved(0), 2), one(moved(1.1 * unit), 3)}).size() == 4);
    // in a chain, all are
    const Cloud chain =
      fuse({one(a, 1), one(c, 1), one(moved(1.8 * unit), 2), one(moved(0.9 * unit), 1.5), one(moved(0), 3)});
    assert(chain.size() == 3 && chain[1].second == 1.5);
  }

  // indices count more than positions
  Patches indexed = {Patch{{{c, 1}, {a, 2}}, {7, 3}}, Patch{{{Point(0, 0, 1e-4), 1}, {c, 4}}, {3, 8}}};
  assert(fuse(indexed) == (Cloud{{a, 1}, {c, 1}, {c, 4}}));
  indexed[1].indices.clear(); // not all have them: positions count
  assert(fuse(indexed) == (Cloud{{a, 2}, {Point(0, 0, 1e-4), 1}, {c, 1}}));

  refuse_to_fuse({}, {"no points"});
  refuse_to_fuse({Patch()}, {"no points"});
  refuse_to_fuse({one(Point(0, std::nan(""), 0), 1)}, {"coordinate", "not finite"});
  refuse_to_fuse({one(a, -1)}, {"distance", "negative"});
  refuse_to_fuse({one(a, HUGE_VAL)}, {"distance", "not finite"});
  refuse_to_fuse({Patch{{{a, 1}, {b, 1}}, {1}}}, {"2 points", "1 index;"});
  // indices of the patch instead of the cloud
  refuse_to_fuse({Patch{{{a, 1}, {b, 1}}, {0, 1}}, Patch{{{a, 1}, {c, 1}}, {0, 1}}},
                 {"index 1 ", "(1 0 0) and (1 1 1)", "whole cloud", "indices_dataset", "use_indices"});
}

// as many points as clouds have, all of them twice, on planes; and many times the same one
void test_fusion_is_fast()
{
  Patches patches(2);
  for (int x = 0; x < 400; ++x)
    for (int y = 0; y < 400; ++y)
      for (Patch& patch : patches)
        patch.samples.emplace_back(x % 2 == 0 ? Point(x, y, 0) : Point(0, x, y + 1), &patch == &patches[0] ? 1. : 2.);
  patches[1].samples.insert(patches[1].samples.end(), 100000, {Point(0, 0, 0), 3.});
  const auto begin = std::chrono::steady_clock::now();
  const Cloud cloud = fuse(patches);
  assert(std::chrono::steady_clock::now() - begin < std::chrono::seconds(30));
  assert(cloud.size() == 160000);
  for (const auto& sample : cloud)
    assert(sample.second == 1.);
}

bool read_patches(const std::vector<std::string>& names, Patches& patches, std::string& error,
                  const std::string& indices = "", bool use_indices = true)
{
  return CGAL::IO::read_distance_patches(
    names, patches, parameters::indices_dataset(indices).use_indices(use_indices).error_message(&error));
}

std::vector<double> indices_of(const Patch& patch)
{
  return std::vector<double>(patch.indices.begin(), patch.indices.end());
}

std::string npz_of(const Patch& patch, const std::string& name_of_indices, unsigned method)
{
  const std::size_t n = patch.samples.size();
  return zip({{"points.npy", npy(points_of(patch.samples), {n, 3})},
              {"distances.npy", npy(distances_of(patch.samples), {n})},
              {name_of_indices + ".npy", npy(indices_of(patch), {n}, "<i8")}},
             method);
}

void test_patch_files()
{
  const Cloud cloud = box_cloud();
  const Patches expected = cut(cloud, true, 1.);
  // each patch in a format of its own
  std::string text;
  for (const auto& sample : expected[2].samples)
    text += std::to_string(sample.first.x()) + " " + std::to_string(sample.first.y()) + " "
      + std::to_string(sample.first.z()) + " " + CGAL::IO::internal::number_to_string(sample.second) + "\n";
  const Test_file a("_a.npz", npz_of(expected[0], "indices", zip_methods().back()));
  const Test_file b("_b.npz", npz_of(expected[1], "indexes_in_whole", 0));
  const Test_file c("_c.xyz", text), c_indexed("_c.npz", npz_of(expected[2], "own", 0));
  const Test_file d("_d.npy", npy(rows_of_four(expected[3].samples), {expected[3].samples.size(), 4}));
  const Test_file e("_e.npz", npz_of(expected[4], "indices", 0)), f("_f.npz", npz_of(expected[5], "indices", 0));
  Patches patches;
  std::string error;
  assert(read_patches({a.name, b.name, c.name, d.name, e.name, f.name}, patches, error));
  assert(error.empty() && patches.size() == 6);
  for (std::size_t i = 0; i < 6; ++i)
    assert(patches[i].samples == expected[i].samples
           && patches[i].indices == (i == 2 || i == 3 ? std::vector<std::size_t>() : expected[i].indices));
  assert(fuse(patches) == cloud);

  assert(read_patches({a.name, b.name}, patches, error, "", false));
  assert(patches[0].indices.empty() && patches[1].indices.empty());
  assert(read_patches({c_indexed.name}, patches, error, "own") && patches[0].indices == expected[2].indices);
  assert(!read_patches({a.name, b.name}, patches, error, "indices"));
  check_words(error, {b.name, "no array \"indices\"", "indexes_in_whole", "indices_dataset"});
  assert(patches.size() == 1); // as it was
  assert(!read_patches({a.name}, patches, error, "points"));
  check_words(error, {a.name, "\"points\" has the shape", "exactly one index", "indices_dataset"});
  assert(!read_patches({a.name}, patches, error, "distances"));
  check_words(error, {a.name, "\"distances\"", "no index", "indices_dataset"});
  assert(!read_patches({a.name, "input_none.npz"}, patches, error));
  check_words(error, {"input_none.npz", "No such file"});
  assert(!read_patches({}, patches, error));
  check_words(error, {"no names"});
}

// they are left out with their indices
void test_invalid_points()
{
  Patches patches;
  const double nan = std::nan("");
  const Test_file holes(".npz",
                        zip({{"points.npy", npy({0, 0, 0, nan, 0, 0, 2, 2, 2}, {3, 3})},
                             {"distances.npy", npy({1, 2, 3}, {3})},
                             {"indices.npy", npy({5, 6, 7}, {3}, "<u2")}},
                            0));
  std::size_t number_of_skipped = 0;
  assert(CGAL::IO::read_distance_patches(std::vector<std::string>{holes.name, holes.name}, patches,
                                         parameters::skip_invalid(true).number_of_skipped(&number_of_skipped)));
  assert(number_of_skipped == 2 && patches[1].samples.size() == 2);
  assert((patches[1].indices == std::vector<std::size_t>{5, 7}));
}

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
// all patches of a model in one file, as rows of their lengths
void test_patches_in_hdf5()
{
  const Cloud cloud = box_cloud();
  const Test_file file(".hdf5");
  {
    std::vector<std::vector<double>> points, distances, indices;
    for (const Patch& patch : cut(cloud, true, 1.))
    {
      points.push_back(points_of(patch.samples));
      distances.push_back(distances_of(patch.samples));
      indices.push_back(indices_of(patch));
    }
    Hdf5_writer writer(file.name);
    writer.add_rows("points", points);
    writer.add_rows("distances", distances);
    writer.add_rows("indexes_in_whole", indices, H5T_STD_I32LE);
  }
  Patches patches;
  std::string error;
  assert(read_patches({file.name}, patches, error));
  assert(patches.size() == 1 && patches[0].indices.size() == patches[0].samples.size());
  assert(fuse(patches) == cloud);
  assert(read_patches({file.name}, patches, error, "", false) && patches[0].indices.empty());
  assert(fuse(patches) == cloud);
}
#endif

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

void test_fusion_of_small_number_types()
{
  std::vector<std::pair<CGAL::Simple_cartesian<float>::Point_3, float>> cloud;
  std::vector<CGAL::Wireframe_extraction::Distance_patch<CGAL::Simple_cartesian<float>::Point_3, float>> patches(2);
  patches[0].samples = {{{1.f, 2.f, 3.f}, 4.f}};
  patches[1].samples = {{{1.f, 2.f, 3.f}, 3.f}};
  assert(CGAL::Wireframe_extraction::fuse_distance_patches(patches, cloud));
  assert(cloud.size() == 1 && cloud[0].second == 3.f);
}

int main()
{
  const auto count_files = [] { return std::distance(fs::directory_iterator("."), fs::directory_iterator()); };
  const auto before = count_files();
  test_fusion();
  test_fusion_of_values();
  test_fusion_is_fast();
  test_fusion_with_a_far_point();
  test_fusion_of_small_number_types();
  test_patch_files();
  test_invalid_points();
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_HDF5
  test_patches_in_hdf5();
#endif
  assert(count_files() == before);
  return 0;
}
