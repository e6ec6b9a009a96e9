#include "extract_wireframe_input.h"

#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/IO/read_distance_patches.h>
#include <CGAL/Wireframe_extraction/fuse_distance_patches.h>
#include <CGAL/Wireframe_extraction/parameters.h>

namespace tool {

std::string read_input(const Input& input, Cloud& cloud, std::size_t& number_of_skipped,
                       std::size_t& number_of_points_of_patches)
{
  namespace wireframe = CGAL::Wireframe_extraction;
  std::string error;
  const auto np = wireframe::parameters::skip_invalid(input.skip_invalid).error_message(&error)
                    .distance_property(input.distance_property).number_of_skipped(&number_of_skipped)
                    .points_dataset(input.points_dataset).distances_dataset(input.distances_dataset);
  number_of_points_of_patches = 0;
  if(input.has_distances)
    CGAL::IO::read_distance_cloud(input.files.front(), input.distances, cloud, np);
  else if(!input.are_patches)
    CGAL::IO::read_distance_cloud(input.files.front(), cloud, np);
  else
  {
    std::vector<wireframe::Distance_patch<Cloud::value_type::first_type, double> > patches;
    if(!CGAL::IO::read_distance_patches(
         input.files, patches, np.indices_dataset(input.indices_dataset).use_indices(input.use_indices)))
      return error;
    for(const auto& patch : patches)
      number_of_points_of_patches += patch.samples.size();
    if(!wireframe::fuse_distance_patches(
         patches, cloud, wireframe::parameters::patch_fusion(input.fusion).error_message(&error)))
      return input.files.front() + (input.files.size() > 1 ? " and its fellow patches: " : ": ") + error;
  }
  return error;
}

} // namespace tool
