// What the header of a field that the tool extract_wireframe wrote tells of it.

#ifndef EXTRACT_WIREFRAME_FIELD_HEADER_H
#define EXTRACT_WIREFRAME_FIELD_HEADER_H

#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cmath>
#include <string>
#include <vector>

namespace tool {

// What the stages have to know of a field besides its distances, to go on as if it was just estimated.
struct Field_header
{
  double sampling_distance = 0.; // 0: nothing is known
  double noise_level = -1.;      // in sampling distances; negative if it is not known

  Field_header() {}

  Field_header(double r, double noise) : sampling_distance(r), noise_level(noise) {}

  // Nothing is known unless both of them are there, and make sense.
  explicit Field_header(const std::vector<std::string>& comments)
  {
    Field_header read;
    for (const std::string& comment : comments)
    {
      read_value(comment, r_name(), read.sampling_distance);
      read_value(comment, noise_name(), read.noise_level);
    }
    if (std::isfinite(read.sampling_distance) && read.sampling_distance > 0. && read.noise_level >= 0.
        && read.noise_level <= 1.)
      *this = read;
  }

  bool is_known() const { return sampling_distance > 0.; }

  // as the constructor reads them
  std::vector<std::string> comments() const
  {
    return {r_name() + CGAL::IO::internal::number_to_string(sampling_distance),
            noise_name() + CGAL::IO::internal::number_to_string(noise_level)};
  }

private:
  static std::string r_name() { return "sampling_distance "; }
  static std::string noise_name() { return "noise_level "; }

  static void read_value(const std::string& comment, const std::string& name, double& value)
  {
    double number = 0.;
    if (comment.compare(0, name.size(), name) == 0
        && CGAL::IO::internal::parse_number(CGAL::IO::internal::trim(comment).substr(name.size()), number))
      value = number;
  }
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_FIELD_HEADER_H
