// A regressor that sees one patch at a time says "far" where the feature lies in another patch. Here a cloud is cut
// into patches that overlap, and they are put together again.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_patches.h>
#include <CGAL/Wireframe_extraction/fuse_distance_patches.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Wireframe_extraction::Distance_patch<Point, double> Patch;

namespace parameters = CGAL::Wireframe_extraction::parameters;

// Writes the points with x from `begin` to `end`. Those near a cut get a distance that is too large.
bool write_patch(const std::string& name, const std::vector<std::pair<Point, double>>& cloud, double begin, double end)
{
  std::ofstream file(name);
  file.precision(17);
  for (const auto& sample : cloud)
  {
    const double x = sample.first.x();
    if (x < begin || x > end)
      continue;
    const bool is_near_cut = x < begin + 0.05 || x > end - 0.05;
    file << sample.first << ' ' << (is_near_cut ? 1. : sample.second) << '\n';
  }
  return static_cast<bool>(file.flush());
}

int main()
{
  std::string error;
  std::vector<std::pair<Point, double>> cloud;
  if (!CGAL::IO::read_distance_cloud("data/box_with_hole.ply", cloud, parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }

  const std::vector<std::string> names = {"patch_0.xyz", "patch_1.xyz", "patch_2.xyz"};
  const double far = 1e6;
  if (!write_patch(names[0], cloud, -far, 0.4) || !write_patch(names[1], cloud, 0.2, 0.7)
      || !write_patch(names[2], cloud, 0.5, far))
    return EXIT_FAILURE;

  // Each point is known by its position. Files of HDF5 and NumPy may have indices, too.
  std::vector<Patch> patches;
  std::vector<std::pair<Point, double>> fused;
  if (!CGAL::IO::read_distance_patches(names, patches, parameters::error_message(&error))
      || !CGAL::Wireframe_extraction::fuse_distance_patches(patches, fused, parameters::error_message(&error)))
  {
    std::cerr << error << std::endl;
    return EXIT_FAILURE;
  }
  std::size_t number_of_samples = 0, number_of_far = 0;
  for (const Patch& patch : patches)
    number_of_samples += patch.samples.size();
  for (const auto& sample : fused)
    number_of_far += sample.second == 1. ? 1 : 0;
  std::cout << number_of_samples << " points of " << patches.size() << " patches are " << fused.size() << " points, "
            << number_of_far << " of them without a good distance" << std::endl;
  return fused.size() == cloud.size() && number_of_far == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
