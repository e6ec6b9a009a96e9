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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_VTP_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_VTP_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/get_sampling.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_vtp.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the XML format of VTK for polygonal data (ascii), for instance for
/// ParaView.
///
/// Every vertex of the wireframe is a cell of one point, and every curve a polyline; the vertices come first,
/// and are the first points, in their order. Curves that share a vertex share its point, and a closed
/// polyline ends with the point it starts with. Each cell has the data `index` (of the curve), `type` (the
/// value of `Wireframe_curve_type` as an integer, from 0 for a B-spline to 5 for an elliptic arc),
/// `type_name`, `closed`, `source`, `target`, `length`, `radius` (the major one of an ellipse) and
/// `minor_radius`, `rms`, `max` and `support`. Where there is no index or type it is -1, where there is no
/// radius it is 0, and a vertex has the `type_name` "vertex". The sampling distance and the unit are field
/// data. Numbers have all digits.
///
/// The format does not hold the curves themselves, nor center, axis, angles and uncertainty of circles and
/// ellipses.
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
///     \cgalParamDescription{what one unit of the coordinates is; its symbol, such as "mm", is written as the
///                           field `unit`}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
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
bool write_wireframe_vtp(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    return internal::write_vtp(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_sampling(np), internal::get_length_unit(np), error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the XML format of VTK for polygonal data (ascii), for instance for
/// ParaView.
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
///   \wireframeParamSamplingStep
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; its symbol, such as "mm", is written as the
///                           field `unit`}
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
bool write_wireframe_vtp(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_vtp(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_sampling(np), internal::get_length_unit(np), error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_VTP_H
