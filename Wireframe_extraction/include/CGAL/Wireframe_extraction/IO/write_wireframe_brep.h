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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_BREP_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_BREP_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Opencascade_session.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Opencascade_shape.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <BRepTools.hxx>

#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

template <class GeomTraits, class NamedParameters>
bool write_brep(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
                std::string& error)
{
  return write_with_opencascade(
    out,
    [&](Opencascade_session&, std::ostream& text, std::string& problem) {
      Opencascade_shape shape;
      if (!make_shape(wireframe, get_geom_traits<GeomTraits>(np), shape, problem))
        return false;
      BRepTools::Write(shape.compound, text);
      return true;
    },
    error);
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the BREP format of OpenCASCADE.
///
/// The shape is a compound with an edge for each curve, on a line, circle, ellipse or B-spline after its type. Edges of
/// curves that share a vertex share it too. Curves that form a closed loop, with no other curve at any of their
/// vertices, are a closed wire. Numbers have 15 digits.
///
/// The format cannot hold the unit, and what `Wireframe_curve` says of uncertainty, residuals and support; a vertex
/// without curve is left out.
///
/// Needs OpenCASCADE: link the CMake target `CGAL::Wireframe_extraction_OCCT`. The translators of OpenCASCADE have
/// global settings, which are as before when the function returns, and calls from several threads wait for each
/// other; no other thread may use these translators meanwhile. OpenCASCADE prints nothing, and none of its exceptions
/// gets out.
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
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, is malformed
///   in another way, or has a curve that OpenCASCADE has not, such as one of a degree above 25, or the stream cannot
///   be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_brep(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_brep(out, wireframe, np, error); });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the BREP format of OpenCASCADE.
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
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, is malformed
///   in another way, or has a curve that OpenCASCADE has not, such as one of a degree above 25, or the file cannot
///   be written.
///
/// Takes time linear in the size of the wireframe.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_brep(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                          const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_brep(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_BREP_H
