// The scale of a field and its noise, and where they are from.

#ifndef EXTRACT_WIREFRAME_FIELD_SCALE_H
#define EXTRACT_WIREFRAME_FIELD_SCALE_H

#include "Field_header.h"
#include "Options.h"

#include <algorithm>
#include <string>

namespace tool {

// What the extraction is told of the field: what was given counts, then what its file says; the rest is estimated.
struct Field_scale
{
  double sampling_distance = 0.; // 0: to be estimated
  double noise_level = -1.;      // in sampling distances; negative: to be estimated
  std::string origin_of_r = "estimated",
              origin_of_noise; // for the summary; that of the noise only if it is from the file

  Field_scale() {}

  Field_scale(const Options& options, const Field_header& header)
    : sampling_distance(options.sampling_distance), noise_level(options.extraction.noise_level)
  {
    if (sampling_distance > 0.)
      origin_of_r = "given";
    else if (header.is_known())
    {
      sampling_distance = header.sampling_distance;
      origin_of_r = "from the file";
    }
    if (noise_level < 0. && header.is_known())
    {
      // it is a length, and at most r
      noise_level = (std::min)(1., header.noise_level * header.sampling_distance / sampling_distance);
      origin_of_noise = "from the file";
    }
  }
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_FIELD_SCALE_H
