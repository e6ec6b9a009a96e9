// Writes a field that was estimated, with the points it belongs to.

#ifndef EXTRACT_WIREFRAME_WRITE_FIELD_H
#define EXTRACT_WIREFRAME_WRITE_FIELD_H

#include "Field_header.h"
#include "open_input.h"

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/byte_tools.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace tool {

// As PLY, with what the stages that follow have to know as comments. Returns false, with what went wrong, if the cloud
// cannot be read once more.
inline bool write_field(std::ostream& stream, Input_cloud& cloud,
                        const CGAL::Wireframe_extraction::Distance_field& field, std::string& error)
{
  const auto is_known = [](double distance) { return std::isfinite(distance); };
  const auto count = std::count_if(field.distances.begin(), field.distances.end(), is_known);
  stream << "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : Field_header(field.sampling_distance, field.noise_level).comments())
    stream << "comment " << comment << '\n';
  stream << "element vertex " << std::to_string(count)
         << "\nproperty double x\nproperty double y\nproperty double z\nproperty double distance\n"
            "property double deviation\nend_header\n";
  std::size_t index = 0;
  const bool is_read = cloud.read([&](const Input_cloud::Sample* first, const Input_cloud::Sample* beyond) {
    std::string bytes;
    for (; first != beyond && index < field.distances.size(); ++first, ++index)
      if (is_known(field.distances[index]))
        for (const double value : {first->x, first->y, first->z, field.distances[index], field.deviations[index]})
          CGAL::IO::internal::append_little_endian(value, bytes);
    stream << bytes;
    return true;
  });
  if (!is_read)
    error = cloud.error_message();
  return is_read;
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_WRITE_FIELD_H
