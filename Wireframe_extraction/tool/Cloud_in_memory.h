// A cloud of the tool extract_wireframe that is in memory.

#ifndef EXTRACT_WIREFRAME_CLOUD_IN_MEMORY_H
#define EXTRACT_WIREFRAME_CLOUD_IN_MEMORY_H

#include "open_input.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {

class Cloud_in_memory : public Input_cloud
{
public:
  std::vector<Sample> samples;
  std::size_t skipped = 0;
  std::string text, text_without_feature, kind_of_mesh, place;
  bool are_distances_known = true;

  bool read(const Sink& sink) override
  {
    static constexpr std::size_t samples_per_chunk = 4096;
    for (std::size_t first = 0; first < samples.size(); first += samples_per_chunk)
      if (!sink(samples.data() + first, samples.data() + (std::min)(first + samples_per_chunk, samples.size())))
        break;
    return true;
  }

  bool has_distances() const override { return are_distances_known; }
  std::size_t number_of_skipped() const override { return skipped; }
  std::string no_feature() const override { return text_without_feature; }
  std::string mesh_kind() const override { return kind_of_mesh; }
  std::string note() const override { return text; }
  std::string distance_place() const override { return place; }
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_CLOUD_IN_MEMORY_H
