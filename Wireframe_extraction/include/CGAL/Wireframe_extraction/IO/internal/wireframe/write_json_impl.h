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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_JSON_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_JSON_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/json_text.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_json.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// of a point or a vector
inline std::string json_point(const Coordinates& point) { return json_array(point, json_number); }

inline std::string json_pair(double first, double second)
{
  return json_array(std::array<double, 2>{{first, second}}, json_number);
}

// the parameters of a line or a conic, beside the spline that every curve has
inline std::string json_parameters(const Plain_curve& curve)
{
  if (curve.type == Wireframe_curve_type::BSPLINE)
    return "";
  const auto& uncertainty = curve.uncertainty;
  std::string parameters, radii;
  if (curve.conic)
  {
    const Plain_conic& conic = *curve.conic;
    parameters = ",\"center\":" + json_point(conic.center) + ",\"axis\":" + json_point(conic.axis)
      + ",\"major_direction\":" + json_point(conic.major_direction)
      + ",\"radii\":" + json_pair(conic.major_radius, conic.minor_radius)
      + ",\"angles\":" + json_pair(conic.start_angle, conic.end_angle);
    radii = ",\"radii\":" + json_pair(uncertainty.major_radius, uncertainty.minor_radius);
  }
  return parameters + ",\"uncertainty\":{\"position\":" + json_number(uncertainty.position)
    + ",\"direction\":" + json_number(uncertainty.direction) + radii + "}";
}

inline std::string json_curve(const Plain_curve& curve)
{
  const auto to_index = [](std::size_t index) {
    return index == Plain_curve::no_vertex ? std::string("null") : std::to_string(index);
  };
  std::string text = "{\"type\":\"" + to_string(curve.type) + "\",\"closed\":" + (curve.is_closed() ? "true" : "false")
    + ",\"source\":" + to_index(curve.source) + ",\"target\":" + to_index(curve.target) + ",\"degree\":"
    + std::to_string(curve.spline.degree()) + ",\"knots\":" + json_array(curve.spline.knots(), json_number)
    + ",\"control_points\":" + json_array(curve.spline.control_points(), json_point);
  if (curve.spline.is_rational())
    text += ",\"weights\":" + json_array(curve.spline.weights(), json_number);
  return text + json_parameters(curve) + ",\"rms\":" + json_number(curve.rms) + ",\"max\":" + json_number(curve.max)
    + ",\"support\":" + std::to_string(curve.support) + ",\"doubts\":"
    + json_array(curve.doubts, [](Wireframe_doubt doubt) { return "\"" + to_string(doubt) + "\""; }) + "}";
}

// what is known of where the wireframe comes from, as a line of its own; nothing if nothing is
inline std::string json_provenance(const Wireframe_provenance& provenance)
{
  std::string members;
  const auto add = [&members](const char* name, const std::string& value) {
    members += std::string(members.empty() ? "" : ",") + "\"" + name + "\":" + value;
  };
  const auto add_texts = [&add](const char* name, const std::vector<std::string>& texts) {
    if (!texts.empty())
      add(name, json_array(texts, json_string));
  };
  if (!provenance.program.empty())
    add("program", json_string(provenance.program));
  add_texts("inputs", provenance.inputs);
  std::string options;
  for (const auto& option : provenance.options)
    options += (options.empty() ? "" : ",") + json_string(option.first) + ":" + json_string(option.second);
  if (!options.empty())
    add("options", "{" + options + "}");
  if (!provenance.unit.empty())
    add("unit", json_string(provenance.unit));
  if (provenance.noise_level > 0. && std::isfinite(provenance.noise_level))
    add("noise_level", json_number(provenance.noise_level));
  add_texts("warnings", provenance.warnings);
  add_texts("regularities", provenance.regularities);
  return members.empty() ? members : " \"provenance\":{" + members + "},\n";
}

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_json(std::ostream& out, const Plain_wireframe& wireframe, const Wireframe_provenance& provenance,
                std::string& error)
{
  error = wireframe_problem(wireframe, Plain_traits());
  if (!error.empty())
    return false;
  out << "{\"format\":\"wireframe\",\"version\":2,\"sampling_distance\":" << json_number(wireframe.sampling_distance)
      << ",\n"
      << json_provenance(provenance) << " \"vertices\":" << json_array(wireframe.vertices, json_point, ",\n  ")
      << ",\n \"curves\":[";
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    out << (i == 0 ? "" : ",\n  ") << json_curve(wireframe.curves[i]);
  out << "]}\n";
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_JSON_IMPL_H
