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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_JSON_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_JSON_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_json.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream as wireframe JSON, version 2.
///
/// This is the only format that keeps everything: `read_wireframe_json()` gives back the same wireframe, to
/// the last bit if the number type is `double`. The object has the keys `format` ("wireframe"), `version`
/// (2), `sampling_distance`, `provenance` (an object with the members of `Wireframe_provenance` that are known, if any
/// is), `vertices` (an array of points) and `curves`. Each curve has `type` ("bspline",
/// "line", "circle", "arc", "ellipse" or "elliptic_arc"), `closed`, `source` and `target` (indices of
/// vertices, `null` on a closed curve without vertex), `degree`, `knots`, `control_points`, `weights` (if it
/// is rational), and how well the cloud supports it: `rms`, `max` (both in the unit of the wireframe) and
/// `support` (a number of points). A circle, an ellipse or an arc has the members of `Wireframe_conic` as `center`,
/// `axis`, `major_direction`, `radii` (major, minor) and `angles` (start, end; in radians); it and a line have an
/// object `uncertainty` with `position`, `direction` and, if there are any, `radii`.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamProvenance
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the stream cannot be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_json(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    return internal::write_json(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                                internal::get_provenance(np), error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file as wireframe JSON, version 2.
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamProvenance
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_json(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_json(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                                internal::get_provenance(np), error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_JSON_H
