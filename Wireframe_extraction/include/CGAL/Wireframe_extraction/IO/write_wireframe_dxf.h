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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_DXF_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_DXF_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_dxf.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// whether tilted conics are to be splines
template <class NamedParameters>
bool has_dxf_splines(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::Wireframe_extraction::internal_np::dxf_splines), false);
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the DXF format of AutoCAD 2000 (AC1015, ascii).
///
/// The curves are entities in space, exact up to rounding, in the model space and in the order of the
/// wireframe: a line is a `LINE`, a circle a `CIRCLE`, an arc an `ARC`, an ellipse or an arc of one an
/// `ELLIPSE`, and a B-spline a `SPLINE` with its degree, knots, weights and control points. A circle or an
/// ellipse has the normal of its plane as its extrusion direction, about which an arc runs counterclockwise. It is
/// exactly (0, 0, 1) where the plane is level as far as `Wireframe_curve::uncertainty` tells: many programs put others
/// elsewhere.
/// Every kind of curve has a layer: `LINES`, `CIRCLES`, `ARCS`, `ELLIPSES`, `ELLIPTIC_ARCS` and `SPLINES`;
/// before the curves, the vertices are `POINT` entities in the layer `VERTICES`. An ellipse whose radii
/// differ by a factor of more than a million is a `SPLINE`, as the format has none; an arc of a whole turn is
/// a full circle or ellipse.
///
/// The format does not hold which vertices a curve joins, the uncertainties, how well the cloud supports a
/// curve, and the sampling distance.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; written as `$INSUNITS`, by which programs
///                           scale what they insert}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{dxf_splines}
///     \cgalParamDescription{whether circles, ellipses and their arcs that are tilted against the xy plane are splines,
///                           for programs that flatten them or put them elsewhere}
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
/// Takes time and memory linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_dxf(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    return internal::write_dxf(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_length_unit(np), internal::has_dxf_splines(np), error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the DXF format of AutoCAD 2000 (AC1015, ascii).
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
///   \cgalParamNBegin{unit}
///     \cgalParamDescription{what one unit of the coordinates is; written as `$INSUNITS`, by which programs
///                           scale what they insert}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{dxf_splines}
///     \cgalParamDescription{whether circles, ellipses and their arcs that are tilted against the xy plane are splines,
///                           for programs that flatten them or put them elsewhere}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
///   \wireframeParamErrorMessage
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time and memory linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_dxf(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_dxf(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_length_unit(np), internal::has_dxf_splines(np), error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_DXF_H
