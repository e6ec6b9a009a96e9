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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_GLTF_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_GLTF_H

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/get_sampling.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_gltf.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the format glTF 2.0.
///
/// Every curve is a polyline (`LINE_STRIP`) with a node of its own, which is named after the index and the
/// type of the curve, such as `curve_0_line`, and has `extras` with `index`, `type`, `closed`, `rms`, `max`
/// and `support`; a closed polyline ends with the point it starts with. A node named `vertices` has the
/// vertices as `POINTS`. Each kind of curve has a colour.
///
/// Coordinates are in single precision, relative to the middle of the wireframe: the node `wireframe`, above
/// all others, has the middle as its translation, so that wireframes keep their precision far off the origin,
/// too. The unit of glTF is the meter, so this node also has a scale, which converts from `unit`. Axes are
/// not turned: glTF takes `y` as up.
///
/// The format does not hold the curves themselves, their parameters and uncertainties, which vertices they
/// join, and the sampling distance.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamSamplingStep
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; the node `wireframe` scales it to meters}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{use_binary_mode}
///     \cgalParamDescription{whether the binary form of the format (`.glb`) is written, or JSON (`.gltf`)
///                           with the coordinates in base64; a stream for the binary form has to be opened in
///                           binary mode}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the stream cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_gltf(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    namespace internal_np = CGAL::Wireframe_extraction::internal_np;
    const bool is_binary =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::use_binary_mode), false);
    return internal::write_gltf(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                                internal::get_sampling(np), internal::get_length_unit(np), is_binary, error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the format glTF 2.0.
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
/// A file with the extension `.glb` (in upper or lower case) has the binary form, any other is JSON with the
/// coordinates in base64.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamSamplingStep
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; the node `wireframe` scales it to meters}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_gltf(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_gltf(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                                internal::get_sampling(np), internal::get_length_unit(np),
                                internal::lower_extension(filename) == ".glb", error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_GLTF_H
