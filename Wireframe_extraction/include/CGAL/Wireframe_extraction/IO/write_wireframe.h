// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_H

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_csv.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_dxf.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_gltf.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_json.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_obj.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_ply.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_polylines.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_svg.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_vtp.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#ifdef CGAL_WIREFRAME_EXTRACTION_USE_OCCT
#include <CGAL/Wireframe_extraction/IO/write_wireframe_brep.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_iges.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_step.h>
#endif

#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// for messages
inline const char* known_wireframe_extensions()
{
  return ".json, .step, .stp, .iges, .igs, .brep, .dxf, .obj, .ply, .vtp, .gltf, .glb, .svg, .csv, .polylines.txt, "
         ".txt "
         "and .cgal";
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file, in the format that the extension of the file (in upper or lower case)
/// names:
/// - `.json`: `write_wireframe_json()`
/// - `.obj`: `write_wireframe_obj()`
/// - `.ply`: `write_wireframe_ply()`
/// - `.dxf`: `write_wireframe_dxf()`
/// - `.vtp`: `write_wireframe_vtp()`
/// - `.gltf` and `.glb`: `write_wireframe_gltf()`
/// - `.svg`: `write_wireframe_svg()`
/// - `.csv`: `write_wireframe_csv()`
/// - `.txt` (thus `.polylines.txt`) and `.cgal`: `write_wireframe_polylines()`
/// - `.step` and `.stp`: `write_wireframe_step()`
/// - `.iges` and `.igs`: `write_wireframe_iges()`
/// - `.brep`: `write_wireframe_brep()`
///
/// The last three need OpenCASCADE, and are there if the macro `CGAL_WIREFRAME_EXTRACTION_USE_OCCT` is defined, as
/// the CMake target `CGAL::Wireframe_extraction_OCCT` does.
///
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters: those of the function for the format, and the ones listed below.
///   A parameter that a format has no use for is passed over.
///
/// \cgalNamedParamsBegin
///   \wireframeParamErrorMessage
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a geometric traits class}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{`GeomTraits()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, the extension is unknown or needs OpenCASCADE and there is none, or the file
///   cannot be written.
///
/// Takes time and memory linear in the number of points written.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                     const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const std::string extension = internal::lower_extension(filename);
  if (extension == ".json")
    return write_wireframe_json(filename, wireframe, np);
  if (extension == ".obj")
    return write_wireframe_obj(filename, wireframe, np);
  if (extension == ".ply")
    return write_wireframe_ply(filename, wireframe, np);
  if (extension == ".dxf")
    return write_wireframe_dxf(filename, wireframe, np);
  if (extension == ".vtp")
    return write_wireframe_vtp(filename, wireframe, np);
  if (extension == ".gltf" || extension == ".glb")
    return write_wireframe_gltf(filename, wireframe, np);
  if (extension == ".svg")
    return write_wireframe_svg(filename, wireframe, np);
  if (extension == ".csv")
    return write_wireframe_csv(filename, wireframe, np);
  if (extension == ".txt" || extension == ".cgal")
    return write_wireframe_polylines(filename, wireframe, np);
  if (internal::is_cad_extension(extension))
  {
#ifdef CGAL_WIREFRAME_EXTRACTION_USE_OCCT
    if (extension == ".brep")
      return write_wireframe_brep(filename, wireframe, np);
    return extension == ".step" || extension == ".stp" ? write_wireframe_step(filename, wireframe, np)
                                                       : write_wireframe_iges(filename, wireframe, np);
#else
    return internal::report(np,
                            filename + ": " + extension
                              + " needs OpenCASCADE, without which this program was "
                                "built; link the CMake target CGAL::Wireframe_extraction_OCCT "
                                "(Debian: libocct-data-exchange-dev)");
#endif
  }
  return internal::report(np,
                          filename + ": unknown extension " + internal::quote(extension) + " of a wireframe; known are "
                            + internal::known_wireframe_extensions());
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_H
