// The clouds that the tool extract_wireframe reads. The readers are compiled apart from the rest.

#ifndef EXTRACT_WIREFRAME_INPUT_H
#define EXTRACT_WIREFRAME_INPUT_H

#include <CGAL/Wireframe_extraction/policies.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tool {

typedef std::vector<std::pair<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3, double> > Cloud;

// what is to be read, and how
struct Input
{
  std::vector<std::string> files;        // one, or patches
  std::string distances;                 // a file of its own
  bool has_distances = false, are_patches = false;
  std::string distance_property, points_dataset, distances_dataset, indices_dataset;
  bool use_indices = true, skip_invalid = false;
  CGAL::Wireframe_extraction::Patch_fusion fusion = CGAL::Wireframe_extraction::Patch_fusion::MINIMUM;
};

// Reads a cloud, or patches of one. Returns what went wrong, nothing if all went well.
std::string read_input(const Input& input, Cloud& cloud, std::size_t& number_of_skipped,
                       std::size_t& number_of_points_of_patches);

} // namespace tool

#endif // EXTRACT_WIREFRAME_INPUT_H
