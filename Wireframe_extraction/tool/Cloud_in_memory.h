// A cloud of the tool extract_wireframe that is in memory.

#ifndef EXTRACT_WIREFRAME_CLOUD_IN_MEMORY_H
#define EXTRACT_WIREFRAME_CLOUD_IN_MEMORY_H

#include "Kernel.h"
#include "open_input.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tool {

class Cloud_in_memory : public Input_cloud
{
public:
  typedef Kernel::Point_3 Point;

  std::vector<std::pair<Point, double>> cloud;
  std::size_t skipped = 0;
  std::string text, text_without_feature;

  bool read(const Sink& sink) override
  {
    std::vector<Sample> chunk;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
      const Point& p = cloud[i].first;
      chunk.push_back(Sample{p.x(), p.y(), p.z(), cloud[i].second});
      if (chunk.size() < 4096 && i + 1 < cloud.size())
        continue;
      if (!sink(chunk.data(), chunk.data() + chunk.size()))
        return true;
      chunk.clear();
    }
    return true;
  }

  std::size_t number_of_skipped() const override { return skipped; }
  std::string no_feature() const override { return text_without_feature; }
  std::string note() const override { return text; }
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_CLOUD_IN_MEMORY_H
