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
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// readers take "-0" for the integer 0, and the sign is lost
inline std::string json_number(double value)
{
  return value == 0. ? std::string(std::signbit(value) ? "-0.0" : "0") : number_to_string(value);
}

// "[a,b,c]"
template <class Range, class To_text>
std::string json_array(const Range& range, const To_text& to_text, const char* separator = ",")
{
  std::string text = "[";
  for (const auto& value : range)
  {
    text += (text.size() == 1 ? "" : separator);
    text += to_text(value);
  }
  return text + "]";
}

// of a point or a vector
template <class Position, class GeomTraits>
std::string json_point(const Position& point, const GeomTraits& traits)
{
  return json_array(coordinates_of(point, traits), json_number);
}

template <class FT>
std::string json_pair(const FT& first, const FT& second)
{
  return json_array(std::array<double, 2>{{CGAL::to_double(first), CGAL::to_double(second)}}, json_number);
}

// the parameters of a line or a conic, beside the spline that every curve has
template <class GeomTraits>
std::string json_parameters(const Wireframe_curve<GeomTraits>& curve, const GeomTraits& traits)
{
  if (curve.type == Wireframe_curve_type::BSPLINE)
    return "";
  const auto& uncertainty = curve.uncertainty;
  std::string parameters, radii;
  if (curve.conic)
  {
    const Wireframe_conic<GeomTraits>& conic = *curve.conic;
    parameters = ",\"center\":" + json_point(conic.center, traits) + ",\"axis\":" + json_point(conic.axis, traits)
      + ",\"major_direction\":" + json_point(conic.major_direction, traits)
      + ",\"radii\":" + json_pair(conic.major_radius, conic.minor_radius)
      + ",\"angles\":" + json_pair(conic.start_angle, conic.end_angle);
    radii = ",\"radii\":" + json_pair(uncertainty.major_radius, uncertainty.minor_radius);
  }
  return parameters + ",\"uncertainty\":{\"position\":" + json_number(CGAL::to_double(uncertainty.position))
    + ",\"direction\":" + json_number(CGAL::to_double(uncertainty.direction)) + radii + "}";
}

template <class GeomTraits>
std::string json_curve(const Wireframe_curve<GeomTraits>& curve, const GeomTraits& traits)
{
  const auto to_number = [](const auto& value) { return json_number(CGAL::to_double(value)); };
  const auto to_point = [&traits](const auto& point) { return json_point(point, traits); };
  const auto to_index = [](std::size_t index) {
    return index == Wireframe_curve<GeomTraits>::no_vertex ? std::string("null") : std::to_string(index);
  };
  std::string text = "{\"type\":\"" + to_string(curve.type) + "\",\"closed\":" + (curve.is_closed() ? "true" : "false")
    + ",\"source\":" + to_index(curve.source) + ",\"target\":" + to_index(curve.target) + ",\"degree\":"
    + std::to_string(curve.spline.degree()) + ",\"knots\":" + json_array(curve.spline.knots(), to_number)
    + ",\"control_points\":" + json_array(curve.spline.control_points(), to_point);
  if (curve.spline.is_rational())
    text += ",\"weights\":" + json_array(curve.spline.weights(), to_number);
  return text + json_parameters(curve, traits) + ",\"rms\":" + to_number(curve.rms) + ",\"max\":" + to_number(curve.max)
    + ",\"support\":" + std::to_string(curve.support) + "}";
}

template <class GeomTraits>
bool write_json(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const GeomTraits& traits,
                std::string& error)
{
  error = wireframe_problem(wireframe, traits);
  if (!error.empty())
    return false;
  out << "{\"format\":\"wireframe\",\"version\":1,\"sampling_distance\":"
      << json_number(CGAL::to_double(wireframe.sampling_distance)) << ",\n \"vertices\":"
      << json_array(
           wireframe.vertices, [&traits](const auto& point) { return json_point(point, traits); }, ",\n  ")
      << ",\n \"curves\":[";
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    out << (i == 0 ? "" : ",\n  ") << json_curve(wireframe.curves[i], traits);
  out << "]}\n";
  return true;
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream as wireframe JSON, version 1.
///
/// This is the only format that keeps everything: `read_wireframe_json()` gives back the same wireframe, to
/// the last bit if the number type is `double`. The object has the keys `format` ("wireframe"), `version`
/// (1), `sampling_distance`, `vertices` (an array of points) and `curves`. Each curve has `type` ("bspline",
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
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
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
    const GeomTraits traits = internal::get_geom_traits<GeomTraits>(np);
    return internal::write_json(out, wireframe, traits, error);
  });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file as wireframe JSON, version 1.
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
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
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
    const GeomTraits traits = internal::get_geom_traits<GeomTraits>(np);
    return internal::write_json(out, wireframe, traits, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_JSON_H
