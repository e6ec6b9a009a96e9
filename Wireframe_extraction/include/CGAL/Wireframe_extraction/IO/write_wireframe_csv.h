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
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// One row, whose fields need no quotes: they are numbers, and words of ours.
class Csv_row
{
public:
  void add(const std::string& text)
  {
    m_text += (m_is_first ? "" : ",") + text;
    m_is_first = false;
  }

  void add(double value) { add(number_to_string(value)); }

  void add(const Spline_vector& v)
  {
    add(v.x);
    add(v.y);
    add(v.z);
  }

  void add_empty(int count)
  {
    for (; count > 0; --count)
      add(std::string());
  }

  // RFC 4180 ends lines so, on all systems
  std::string text() const { return m_text + "\r\n"; }

private:
  std::string m_text;
  bool m_is_first = true;
};

inline const char* csv_header()
{
  return "index,type,closed,source,target,length,center_x,center_y,center_z,axis_x,axis_y,axis_z,"
         "major_direction_x,major_direction_y,major_direction_z,major_radius,minor_radius,start_angle,end_angle,"
         "position_uncertainty,direction_uncertainty,major_radius_uncertainty,minor_radius_uncertainty,"
         "rms,max,support\r\n";
}

// of a line: its middle and its direction
template <class GeomTraits>
void add_csv_line(const Wireframe_curve<GeomTraits>& curve, const GeomTraits& traits, Csv_row& row)
{
  const Spline_vector begin = vector_of(curve.spline.control_points().front(), traits);
  const Spline_vector end = vector_of(curve.spline.control_points().back(), traits);
  row.add(0.5 * begin + 0.5 * end);
  if (norm(end - begin) > 0.)
    row.add(unit_vector(end - begin));
  else
    row.add_empty(3);
  row.add_empty(7);
}

template <class GeomTraits>
void add_csv_conic(const Wireframe_conic<GeomTraits>& conic, const GeomTraits& traits, Csv_row& row)
{
  row.add(vector_of(conic.center, traits));
  row.add(vector_of(conic.axis, traits));
  row.add(vector_of(conic.major_direction, traits));
  for (const auto& value : {conic.major_radius, conic.minor_radius, conic.start_angle, conic.end_angle})
    row.add(CGAL::to_double(value));
}

template <class GeomTraits>
std::string csv_row(std::size_t index, const Wireframe_curve<GeomTraits>& curve, const GeomTraits& traits)
{
  Csv_row row;
  row.add(std::to_string(index));
  row.add(to_string(curve.type));
  row.add(std::string(curve.is_closed() ? "true" : "false"));
  for (const std::size_t vertex : {curve.source, curve.target})
    row.add(vertex == Wireframe_curve<GeomTraits>::no_vertex ? std::string() : std::to_string(vertex));
  row.add(CGAL::to_double(curve.length()));
  const auto& uncertainty = curve.uncertainty;
  if (curve.conic)
    add_csv_conic(*curve.conic, traits, row);
  else if (curve.type == Wireframe_curve_type::LINE)
    add_csv_line(curve, traits, row);
  else
    row.add_empty(13);
  if (curve.type == Wireframe_curve_type::BSPLINE)
    row.add_empty(2);
  else
  {
    row.add(CGAL::to_double(uncertainty.position));
    row.add(CGAL::to_double(uncertainty.direction));
  }
  if (curve.conic)
  {
    row.add(CGAL::to_double(uncertainty.major_radius));
    row.add(CGAL::to_double(uncertainty.minor_radius));
  }
  else
    row.add_empty(2);
  row.add(CGAL::to_double(curve.rms));
  row.add(CGAL::to_double(curve.max));
  row.add(std::to_string(curve.support));
  return row.text();
}

template <class GeomTraits, class NamedParameters>
bool write_csv(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
               std::string& error)
{
  const GeomTraits traits = get_geom_traits<GeomTraits>(np);
  error = wireframe_problem(wireframe, traits);
  if (!error.empty())
    return false;
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    if (!std::isfinite(CGAL::to_double(wireframe.curves[i].spline.length())))
    {
      error = "curve " + std::to_string(i) + " is too long for its length to be a number; scale the wireframe down";
      return false;
    }
  out << csv_header();
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    out << csv_row(i, wireframe.curves[i], traits);
  return true;
}

} // namespace internal

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
bool write_wireframe_csv(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_csv(out, wireframe, np, error); });
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
bool write_wireframe_csv(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_csv(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_CSV_H
