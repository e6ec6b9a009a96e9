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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_READ_WIREFRAME_JSON_H
#define CGAL_WIREFRAME_EXTRACTION_IO_READ_WIREFRAME_JSON_H

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/read_json.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <cstddef>
#include <fstream>
#include <istream>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace IO {
namespace internal {

// Reads a wireframe, and says what is wrong.
template <class GeomTraits>
std::string read_json_as(std::istream& stream, const GeomTraits& traits, CGAL::Wireframe<GeomTraits>& wireframe,
                         Wireframe_provenance* provenance)
{
  typedef typename GeomTraits::FT FT;
  const Plain_traits plain_traits;
  Plain_wireframe plain;
  std::string error;
  Wireframe_provenance origin;
  if (!read_json(stream, plain, origin, error))
    return error;
  const Wireframe_converter<Plain_traits, GeomTraits> convert(plain_traits, traits);
  // what is valid in double need not be so in numbers of less precision
  if constexpr (!std::is_same<FT, double>::value)
    for (std::size_t i = 0; i < plain.curves.size(); ++i)
    {
      const Plain_spline& spline = plain.curves[i].spline;
      if (!Spline_curve_3<GeomTraits>::is_valid(spline.degree(), convert.numbers(spline.knots()),
                                                convert.points(spline.control_points()),
                                                convert.numbers(spline.weights()), &error, traits))
        return "curve " + std::to_string(i) + ": " + error;
    }
  CGAL::Wireframe<GeomTraits> result = convert(plain);
  if constexpr (!std::is_same<FT, double>::value)
    error = wireframe_problem(result, traits);
  if (error.empty())
  {
    wireframe = std::move(result);
    if (provenance != nullptr)
      *provenance = std::move(origin);
  }
  return error;
}

// where to tell what the file says of where the wireframe comes from, or nothing
template <class NamedParameters>
Wireframe_provenance* wanted_provenance(const NamedParameters& np)
{
  return CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, CGAL::Wireframe_extraction::internal_np::provenance),
    static_cast<Wireframe_provenance*>(nullptr));
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// reads a wireframe from a stream of wireframe JSON, version 2, as `write_wireframe_json()` writes it, or version 1.
///
/// Everything is checked: the format and its version, that all numbers are finite, that degree, knots,
/// control points and weights of a curve make a clamped B-spline, that its vertices exist, that an open curve
/// starts and ends at its vertices and a closed one where it starts. Keys that are not known are passed over.
/// A curve may lack `weights`, `rms`, `max` and `support`, and if it is closed, `source` and `target`.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe. What it held before is replaced; it is left as it was if reading fails.
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong, with the index of the curve; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{provenance}
///     \cgalParamDescription{receives what the file tells of where the wireframe comes from; emptied if that is
///                           nothing}
///     \cgalParamType{`CGAL::Wireframe_provenance*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \wireframeParamTraits
/// \cgalNamedParamsEnd
///
/// \return `true` if a valid wireframe was read (which may have no curve), else `false`.
///
/// Takes time and memory linear in the size of the text.
/// Needs the library nlohmann-json, unless it was there when the compiled core was built.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_wireframe_json(std::istream& stream, CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const GeomTraits traits = internal::get_geom_traits<GeomTraits>(np);
  return internal::report(np, internal::read_json_as(stream, traits, wireframe, internal::wanted_provenance(np)));
}

/// \ingroup PkgWireframeExtractionIO
/// reads a wireframe from a file of wireframe JSON, version 2 or 1.
///
/// What is read and checked is that of the overload for a stream.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe. What it held before is replaced; it is left as it was if reading fails.
/// \param np an optional sequence of named parameters among those of the overload for a stream; messages
///   start with the name of the file
///
/// \return `true` if a valid wireframe was read (which may have no curve), else `false`: the file cannot be
///   read, or what it holds is not valid.
///
/// Takes time and memory linear in the size of the file.
/// Needs the library nlohmann-json, unless it was there when the compiled core was built.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool read_wireframe_json(const std::string& filename, CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const GeomTraits traits = internal::get_geom_traits<GeomTraits>(np);
  std::ifstream stream;
  std::string error;
  if (internal::open_input_file(filename, stream, error))
  {
    error = internal::read_json_as(stream, traits, wireframe, internal::wanted_provenance(np));
    if (!error.empty())
      error = filename + ": " + error;
  }
  return internal::report(np, error);
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_READ_WIREFRAME_JSON_H
