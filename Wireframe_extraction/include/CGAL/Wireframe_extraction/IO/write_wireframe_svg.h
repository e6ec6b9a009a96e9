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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_SVG_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_SVG_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_svg.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

template <class NamedParameters>
bool has_dimensions(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::Wireframe_extraction::internal_np::dimensions), false);
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream as a drawing in the SVG format.
///
/// There are four views, all at one scale and arranged in third-angle projection: the front view (`x` to the
/// right, `z` upwards), above it the top view (`x`, `y`), on its right the view from the right (`y`, `z`),
/// and in the corner between these an isometric view, from the front, the right, and above. Each is a group
/// (`g`) with the `id` "front", "top", "right" or "isometric", that has a title, an element per curve, with
/// the type of the curve as its `class` (and `doubtful`, if it is) and its index and type as a tooltip, and a `circle`
/// of the class `vertex` per vertex. Each kind of curve has a colour. Below are the size of the wireframe and the
/// scale.
///
/// Curves are exact, whatever the view: a line is a `line`, a circle or an ellipse a `circle`, an `ellipse` or, seen
/// from its edge, a `line`; an arc is a `path` of elliptic arcs, a B-spline a `path` of cubic Bezier curves, which are
/// within 10<sup>-8</sup> of the size where it is rational or of a degree above three. All curves are drawn in the same
/// way, whatever is before them: what hides them is not known from a wireframe.
///
/// One unit of the file is a millimeter on paper. The scale is 1:1 for what is neither too small nor too large for a
/// page, and else one of ISO 5455; the attribute `data-scale` has the millimeters of one unit of the wireframe.
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
///     \cgalParamDescription{what one unit of the coordinates is; its symbol is written beside the size}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{dimensions}
///     \cgalParamDescription{whether the radii of arcs and the diameters of circles are written, each in one view: one
///                           that shows it as a circle, or else the isometric one}
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
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_svg(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    return internal::write_svg(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_length_unit(np), internal::has_dimensions(np), error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file as a drawing in the SVG format.
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
///     \cgalParamDescription{what one unit of the coordinates is; its symbol is written beside the size}
///     \cgalParamType{`Wireframe_extraction::Length_unit`}
///     \cgalParamDefault{`Length_unit::MILLIMETER`}
///   \cgalParamNEnd
///   \cgalParamNBegin{dimensions}
///     \cgalParamDescription{whether the radii of arcs and the diameters of circles are written, each in one view: one
///                           that shows it as a circle, or else the isometric one}
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
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_svg(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_svg(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_length_unit(np), internal::has_dimensions(np), error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_SVG_H
