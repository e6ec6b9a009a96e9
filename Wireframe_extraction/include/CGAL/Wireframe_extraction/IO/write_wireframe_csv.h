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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_CSV_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_CSV_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_csv.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream as a table of its curves in the CSV format of RFC 4180.
///
/// There is a header with the names of the columns, and a row per curve: `index`, `type` (as in wireframe
/// JSON), `closed` (`true` or `false`), `source` and `target` (indices of vertices), `length`; `center`,
/// `axis` and `major_direction` (`_x`, `_y`, `_z` each), `major_radius`, `minor_radius`, `start_angle` and
/// `end_angle` (in radians) of a circle, an ellipse, or an arc; the uncertainties of these
/// (`position_uncertainty`, `direction_uncertainty`, `major_radius_uncertainty`, `minor_radius_uncertainty`);
/// `rms`, `max` and `support`. Of a line, `center` is its middle and `axis` its direction. What a curve does
/// not have is an empty field; an uncertainty that is not known is 0. Numbers have all digits and a decimal
/// point whatever the locale; lengths are in the unit of the wireframe. Lines end with a carriage return and
/// a line feed.
///
/// The table does not hold the shape of B-splines, nor the positions of the vertices.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the stream cannot be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_csv(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    return internal::write_csv(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file as a table of its curves in the CSV format of RFC 4180.
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
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_csv(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_csv(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_CSV_H
