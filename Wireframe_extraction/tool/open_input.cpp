#include "open_input.h"
#include "Cloud_in_memory.h"
#include "Kernel.h"
#include "open_mesh.h"

#include <CGAL/Wireframe_extraction/IO/Distance_cloud_file.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Chunked_input.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Ply_header.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_patches.h>
#include <CGAL/Wireframe_extraction/fuse_distance_patches.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace tool {
namespace {

namespace wireframe = CGAL::Wireframe_extraction;
typedef Kernel::Point_3 Point;

// What the header says of the distances that are read; what is wrong with the file is told when it is read.
Field_header field_header_of(const Input& input)
{
  namespace io = CGAL::IO::internal;
  const std::string property = "distance"; // that is written
  if (input.extension() != ".ply" || (!input.distance_property.empty() && input.distance_property != property))
    return Field_header();
  std::ifstream stream;
  std::string error;
  if (!io::open_input_file(input.files.front(), stream, error))
    return Field_header();
  io::Chunked_input bytes(stream);
  io::Ply_header header;
  if (!header.read(bytes, input.files.front(), error))
    return Field_header();
  const std::size_t vertex = header.find_element("vertex");
  const std::vector<std::string> names =
    vertex < header.elements.size() ? header.elements[vertex].property_names() : std::vector<std::string>();
  return std::find(names.begin(), names.end(), property) != names.end() ? Field_header(header.comments)
                                                                        : Field_header();
}

class Cloud_in_file : public Input_cloud
{
public:
  template <class NamedParameters>
  Cloud_in_file(const Input& input, const NamedParameters& np)
    : m_file(input.has_distances ? CGAL::IO::Distance_cloud_file(input.files.front(), input.distances, np)
                                 : CGAL::IO::Distance_cloud_file(input.files.front(), np))
  {
    if (input.mesh == Mesh_choice::SCAN && is_mesh(input))
      m_mesh_kind = "scan";
    if (!input.has_distances && input.field_origin != wireframe::Field_origin::ESTIMATED)
      m_field_header = field_header_of(input);
  }

  bool read(const Sink& sink) override { return m_file.read(sink); }
  bool has_distances() const override { return m_file.has_distances(); }
  std::string error_message() const override { return m_file.error_message(); }
  std::size_t number_of_skipped() const override { return m_file.number_of_skipped(); }
  std::string mesh_kind() const override { return m_mesh_kind; }
  Field_header field_header() const override { return m_field_header; }
  std::string note() const override { return m_file.assumption(); }
  std::string distance_place() const override { return m_file.distance_place(); }

private:
  CGAL::IO::Distance_cloud_file m_file;
  std::string m_mesh_kind;
  Field_header m_field_header;
};

// pipes cannot be read twice; what is not there at all is told by the reader
bool can_be_read_once_only(const std::string& filename)
{
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(filename, error);
  return !error && std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)
    && !std::filesystem::is_directory(status);
}

// returns what went wrong
std::string take(CGAL::IO::Distance_cloud_file&& file, const Input& input, Cloud_in_memory& result)
{
  typedef Input_cloud::Sample Sample;
  file.read([&](const Sample* first, const Sample* beyond) {
    result.samples.insert(result.samples.end(), first, beyond);
    return !input.callback || input.callback(0.); // nobody knows how much is left
  });
  result.skipped = file.number_of_skipped();
  result.text = file.assumption();
  result.place = file.distance_place();
  result.are_distances_known = file.has_distances();
  return file.error_message();
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
  std::vector<std::pair<Point, double>> cloud;
  if (!wireframe::fuse_distance_patches(patches, cloud,
                                        wireframe::parameters::patch_fusion(input.fusion).error_message(&error)))
    return input.files.front() + (input.files.size() > 1 ? " and its fellow patches: " : ": ") + error;
  result.text = "the patches have " + std::to_string(number_of_points) + (number_of_points == 1 ? " point" : " points")
    + ", which were fused to " + std::to_string(cloud.size());
  for (const auto& sample : cloud)
    result.samples.push_back({sample.first.x(), sample.first.y(), sample.first.z(), sample.second});
  return std::string();
}

// a folder given as a file
std::string why_no_file(const Input& input)
{
  std::error_code code;
  for (const std::string& name : input.files)
    if (std::filesystem::is_directory(name, code))
      return name
        + ": is a directory, not a file; give a file in it, or a list of them: --batch LIST --output-dir DIR, where "
          "LIST "
          "has the name of a file in each line";
  return std::string();
}

} // namespace

std::string Input::extension() const { return CGAL::IO::internal::format_extension(format, files.front()); }

std::unique_ptr<Input_cloud> open_input(const Input& input, std::string& error)
{
  const auto np = wireframe::parameters::skip_invalid(input.skip_invalid)
                    .field_origin(input.field_origin)
                    .input_format(input.format)
                    .clamp_negative(input.clamp_negative)
                    .coordinate_properties(input.coordinate_properties)
                    .distance_property(input.distance_property)
                    .points_dataset(input.points_dataset)
                    .distances_dataset(input.distances_dataset);
  const bool is_once_only =
    can_be_read_once_only(input.files.front()) || (input.has_distances && can_be_read_once_only(input.distances));
  error = why_no_file(input);
  if (error.empty())
    error = why_no_distances(input);
  if (!error.empty())
    return std::make_unique<Cloud_in_memory>();
  if (is_mesh_to_sample(input, is_once_only))
    return open_mesh(input, error);
  if (!input.are_patches && !is_once_only)
    return std::make_unique<Cloud_in_file>(input, np);
  auto result = std::make_unique<Cloud_in_memory>();
  if (input.are_patches)
    error = read_patches(input, *result, np.number_of_skipped(&result->skipped));
  else if (input.has_distances)
    error = take(CGAL::IO::Distance_cloud_file(input.files.front(), input.distances, np), input, *result);
  else
    error = take(CGAL::IO::Distance_cloud_file(input.files.front(), np), input, *result);
  return result;
}

} // namespace tool
