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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_OBJ_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_OBJ_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/get_sampling.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_obj.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the Wavefront OBJ format.
///
/// Every curve becomes a polyline (`l`) in a group (`g`) that is named after the index and the type of the
/// curve, such as `curve_0_line`. The points (`v`) start with the vertices of the wireframe in their order;
/// curves that share a vertex share its point, and a closed polyline ends with the point it starts with.
/// Coordinates are written with all digits.
///
/// With `obj_splines`, curves are not sampled but written as free-form curves (`cstype bspline`, or
/// `rat bspline` if they have weights), which not every program reads: a circle, an ellipse, or an arc as what
/// `Wireframe_conic::to_spline()` makes of it, and a line as a segment (`l`). Groups and vertices are as
/// before; the points that follow are control points, with their weight as fourth number. The format has no
/// word for a closed curve, which is one that ends at the point it starts with.
///
/// The format does not hold the parameters of circles and ellipses, the uncertainties, how well the cloud
/// supports a curve, the sampling distance, and the unit.
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
///   \cgalParamNBegin{obj_splines}
///     \cgalParamDescription{whether curves are written as free-form curves, and not as polylines}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{If it is `true`, `sampling_step` has no effect.}
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
bool write_wireframe_obj(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(stream, np, [&](std::ostream& out, std::string& error) {
    namespace internal_np = CGAL::Wireframe_extraction::internal_np;
    const bool has_splines =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::obj_splines), false);
    return internal::write_obj(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_sampling(np), has_splines, error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the Wavefront OBJ format.
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
///   \cgalParamNBegin{obj_splines}
///     \cgalParamDescription{whether curves are written as free-form curves, and not as polylines}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{If it is `true`, `sampling_step` has no effect.}
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
bool write_wireframe_obj(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    namespace internal_np = CGAL::Wireframe_extraction::internal_np;
    const bool has_splines =
      CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::obj_splines), false);
    return internal::write_obj(out, internal::plain_wireframe(wireframe, internal::get_geom_traits<GeomTraits>(np)),
                               internal::get_sampling(np), has_splines, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_OBJ_H
