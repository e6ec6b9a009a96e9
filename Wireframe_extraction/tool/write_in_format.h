// The formats that the tool extract_wireframe writes.

#ifndef EXTRACT_WIREFRAME_WRITE_IN_FORMAT_H
#define EXTRACT_WIREFRAME_WRITE_IN_FORMAT_H

#include "Options.h"
#include "write_cad.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <optional>
#include <ostream>
#include <string>

namespace tool {

// Extensions are in lower case and have their dots.
inline bool has_format(const std::string& extension)
{
#ifdef EXTRACT_WIREFRAME_WITH_CAD
  if (CGAL::IO::internal::is_cad_extension(extension))
    return true;
#endif
  for (const char* const known :
       {".json", ".obj", ".ply", ".dxf", ".vtp", ".gltf", ".glb", ".svg", ".csv", ".txt", ".cgal"})
    if (extension == known)
      return true;
  return false;
}

// Writes a format that there is, after its extension.
template <class GeomTraits>
bool write_in_format(const std::string& extension, std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                     const Options& options, const CGAL::Wireframe_provenance& provenance, std::string& error)
{
#ifdef EXTRACT_WIREFRAME_WITH_CAD
  if (CGAL::IO::internal::is_cad_extension(extension))
    return write_cad(extension, stream, wireframe, options.unit, options.step_schema, provenance, error);
#endif
  const auto if_given = [](double value) { return value > 0. ? std::optional<double>(value) : std::nullopt; };
  const auto np = CGAL::Wireframe_extraction::parameters::error_message(&error)
                    .unit(options.unit)
                    .sampling_step(if_given(options.sampling_step))
                    .chord_tolerance(if_given(options.chord_tolerance));
  if (extension == ".json")
    return CGAL::IO::write_wireframe_json(stream, wireframe, np.provenance(provenance));
  if (extension == ".obj")
    return CGAL::IO::write_wireframe_obj(stream, wireframe, np.obj_splines(options.has_obj_splines));
  if (extension == ".ply")
    return CGAL::IO::write_wireframe_ply(stream, wireframe, np);
  if (extension == ".dxf")
    return CGAL::IO::write_wireframe_dxf(stream, wireframe, np.dxf_splines(options.has_dxf_splines));
  if (extension == ".vtp")
    return CGAL::IO::write_wireframe_vtp(stream, wireframe, np);
  if (extension == ".gltf" || extension == ".glb")
    return CGAL::IO::write_wireframe_gltf(stream, wireframe, np.use_binary_mode(extension == ".glb"));
  if (extension == ".svg")
    return CGAL::IO::write_wireframe_svg(stream, wireframe, np.dimensions(options.has_dimensions));
  if (extension == ".csv")
    return CGAL::IO::write_wireframe_csv(stream, wireframe, np);
  return CGAL::IO::write_wireframe_polylines(stream, wireframe, np);
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_WRITE_IN_FORMAT_H
