#include "open_input.h"
#include "Cloud_in_memory.h"
#include "Kernel.h"
#include "open_mesh.h"

#include <CGAL/Wireframe_extraction/IO/Distance_cloud_file.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_patches.h>
#include <CGAL/Wireframe_extraction/fuse_distance_patches.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <filesystem>
#include <system_error>
#include <utility>

namespace tool {
namespace {

namespace wireframe = CGAL::Wireframe_extraction;
typedef Kernel::Point_3 Point;

class Cloud_in_file : public Input_cloud
{
public:
  template <class NamedParameters>
  Cloud_in_file(const Input& input, const NamedParameters& np)
    : m_file(input.has_distances ? CGAL::IO::Distance_cloud_file(input.files.front(), input.distances, np)
                                 : CGAL::IO::Distance_cloud_file(input.files.front(), np))
  {}

  bool read(const Sink& sink) override { return m_file.read(sink); }
  std::string error_message() const override { return m_file.error_message(); }
  std::size_t number_of_skipped() const override { return m_file.number_of_skipped(); }

private:
  CGAL::IO::Distance_cloud_file m_file;
};

// pipes cannot be read twice; what is not there at all is told by the reader
bool can_be_read_once_only(const std::string& filename)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(filename, error);
  return !error && std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)
    && !std::filesystem::is_directory(status);
}

template <class NamedParameters>
std::string read_patches(const Input& input, Cloud_in_memory& result, const NamedParameters& np)
{
  std::string error;
  std::vector<wireframe::Distance_patch<Point, double>> patches;
  if (!CGAL::IO::read_distance_patches(
        input.files, patches,
        np.error_message(&error).indices_dataset(input.indices_dataset).use_indices(input.use_indices)))
    return error;
  std::size_t number_of_points = 0;
  for (const auto& patch : patches)
    number_of_points += patch.samples.size();
  if (!wireframe::fuse_distance_patches(patches, result.cloud,
                                        wireframe::parameters::patch_fusion(input.fusion).error_message(&error)))
    return input.files.front() + (input.files.size() > 1 ? " and its fellow patches: " : ": ") + error;
  result.text = "the patches have " + std::to_string(number_of_points) + (number_of_points == 1 ? " point" : " points")
    + ", which were fused to " + std::to_string(result.cloud.size());
  return std::string();
}

} // namespace

std::unique_ptr<Input_cloud> open_input(const Input& input, std::string& error)
{
  const auto np = wireframe::parameters::skip_invalid(input.skip_invalid)
                    .distance_property(input.distance_property)
                    .points_dataset(input.points_dataset)
                    .distances_dataset(input.distances_dataset);
  const bool is_once_only =
    can_be_read_once_only(input.files.front()) || (input.has_distances && can_be_read_once_only(input.distances));
  if (is_mesh_to_sample(input, is_once_only))
    return open_mesh(input, error);
  if (!input.are_patches && !is_once_only)
    return std::make_unique<Cloud_in_file>(input, np);
  auto result = std::make_unique<Cloud_in_memory>();
  const auto all = np.number_of_skipped(&result->skipped);
  if (input.are_patches)
    error = read_patches(input, *result, all);
  else if (input.has_distances)
    CGAL::IO::read_distance_cloud(input.files.front(), input.distances, result->cloud, all.error_message(&error));
  else
    CGAL::IO::read_distance_cloud(input.files.front(), result->cloud, all.error_message(&error));
  return result;
}

} // namespace tool
