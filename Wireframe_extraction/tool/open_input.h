// The clouds that the tool extract_wireframe reads. The readers are compiled apart from the rest.

#ifndef EXTRACT_WIREFRAME_OPEN_INPUT_H
#define EXTRACT_WIREFRAME_OPEN_INPUT_H

#include "Field_header.h"

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tool {

// what a mesh is taken for
enum class Mesh_choice
{
  AUTOMATIC,
  CAD,
  SCAN
};

// what is to be read, and how
struct Input
{
  std::vector<std::string> files; // one, or patches
  std::string distances;          // a file of its own
  std::string format;             // an extension; empty: that of the file
  bool has_distances = false, are_patches = false;
  std::vector<std::string> coordinate_properties; // none, or three
  std::string distance_property, points_dataset, distances_dataset, indices_dataset;
  bool use_indices = true, skip_invalid = false, clamp_negative = false;
  CGAL::Wireframe_extraction::Patch_fusion fusion = CGAL::Wireframe_extraction::Patch_fusion::MINIMUM;
  CGAL::Wireframe_extraction::Field_origin field_origin = CGAL::Wireframe_extraction::Field_origin::AUTOMATIC;
  Mesh_choice mesh = Mesh_choice::AUTOMATIC;
  // of a mesh that is sampled, as of sample_sharp_mesh()
  double sampling_distance = 0., minimum_fold = 20., maximum_facet_fold = 50.;
  int maximum_number_of_points = 200000;
  bool use_boundaries = false;
  // is asked with the share that is done whether to go on while a mesh is sampled, or what can be
  // read only once is read
  std::function<bool(double)> callback;

  // of the file, or what stands for it, in lower case and with the dot
  std::string extension() const;

  // whether it is told where CLOUD has its distances
  bool names_distances() const { return !distance_property.empty() || !distances_dataset.empty(); }
};

// A cloud that stays in its file, or one in memory, with distances or without.
class Input_cloud : public CGAL::Wireframe_extraction::Distance_cloud_source
{
public:
  virtual std::size_t number_of_skipped() const = 0;

  // why no sharp feature can be found, if that is known from the start
  virtual std::string no_feature() const { return std::string(); }

  // what a mesh was taken for, as --mesh says it; empty for what is no mesh
  virtual std::string mesh_kind() const { return std::string(); }

  // of a field that this tool wrote
  virtual Field_header field_header() const { return Field_header(); }

  // what of the file holds the distances; empty if nothing does
  virtual std::string distance_place() const { return std::string(); }

  // what the user shall know
  virtual std::string note() const { return std::string(); }
};

// Opens a cloud. Patches, meshes that are sampled, and what can be read only once, are read at once: then `error` may
// have what went wrong.
std::unique_ptr<Input_cloud> open_input(const Input& input, std::string& error);

} // namespace tool

#endif // EXTRACT_WIREFRAME_OPEN_INPUT_H
