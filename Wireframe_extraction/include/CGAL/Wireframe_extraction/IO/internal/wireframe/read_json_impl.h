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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_READ_JSON_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_READ_JSON_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/read_json.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <istream>
#include <new>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Turns a JSON document into a wireframe. Every function returns whether all was well, and says in `error()`
// what was not.
class Wireframe_json_reader
{
public:
  typedef Plain_traits::Point_3 Point_3;

  bool read(std::istream& stream, Plain_wireframe& wireframe, Wireframe_provenance& provenance)
  {
    Json document;
    return parse(stream, document) && check_format(document)
      && (!document.contains("provenance") || read_provenance(document["provenance"], provenance))
      && read_document(document, wireframe);
  }

  const std::string& error() const { return m_error; }

private:
  typedef nlohmann::json Json;

  bool fail(const std::string& error)
  {
    m_error = m_place + error;
    return false;
  }

  bool parse(std::istream& stream, Json& document)
  {
    if (stream.peek() == std::istream::traits_type::eof())
      return fail(stream.bad() ? "cannot be read" : internal::empty_file_text());
    try
    {
      document = Json::parse(stream);
    }
    catch (const Json::exception& exception)
    {
      // the text starts with a name of the exception in brackets
      const std::string text = exception.what();
      const std::size_t end = text.find("] ");
      return fail("is no valid JSON, or truncated: "
                  + printable(text.substr(end == std::string::npos ? 0 : end + 2), 200));
    }
    catch (const std::bad_alloc&)
    {
      return fail("there is not enough memory to read it");
    }
    return true;
  }

  bool check_format(const Json& document)
  {
    if (!document.is_object() || !document.contains("format") || document["format"] != "wireframe")
      return fail("is no wireframe: a wireframe is a JSON object with \"format\":\"wireframe\"");
    if (!document.contains("version") || !document["version"].is_number_integer())
      return fail("has no \"version\" that is an integer");
    if (document["version"] != 1 && document["version"] != 2)
      return fail("has version " + document["version"].dump() + ", only versions 1 and 2 are known");
    return true;
  }

  // every member may be missing
  bool read_provenance(const Json& json, Wireframe_provenance& provenance)
  {
    Wireframe_provenance result;
    if (!json.is_object())
      return fail("\"provenance\" is " + brief(json) + ", it has to be an object");
    if (!read_text(json, "program", result.program) || !read_text(json, "unit", result.unit)
        || (json.contains("noise_level") && !read_number(json, "noise_level", result.noise_level))
        || !read_texts(json, "inputs", result.inputs) || !read_texts(json, "warnings", result.warnings)
        || !read_texts(json, "regularities", result.regularities))
      return false;
    if (json.contains("options"))
    {
      if (!json["options"].is_object())
        return fail("\"options\" is " + found(json, "options") + ", it has to be an object");
      for (const auto& option : json["options"].items())
        if (option.value().is_string())
          result.options.emplace_back(option.key(), option.value().get<std::string>());
        else
          return fail("\"options\" holds " + brief(option.value()) + ", which is no text");
    }
    provenance = std::move(result);
    return true;
  }

  bool read_text(const Json& json, const char* key, std::string& text)
  {
    if (!json.contains(key))
      return true;
    if (!json[key].is_string())
      return fail(quote(key) + " is " + found(json, key) + ", it has to be a text");
    text = json[key].get<std::string>();
    return true;
  }

  bool read_texts(const Json& json, const char* key, std::vector<std::string>& texts)
  {
    const Json* array = nullptr;
    if (!json.contains(key))
      return true;
    if (!find_array(json, key, array))
      return false;
    for (const Json& value : *array)
    {
      if (!value.is_string())
        return fail(quote(key) + " holds " + brief(value) + ", which is no text");
      texts.push_back(value.get<std::string>());
    }
    return true;
  }

  bool read_document(const Json& document, Plain_wireframe& wireframe)
  {
    Plain_wireframe result;
    double sampling_distance = 0.;
    const Json* curves = nullptr;
    if (!read_number(document, "sampling_distance", sampling_distance)
        || !read_points(document, "vertices", result.vertices) || !find_array(document, "curves", curves))
      return false;
    result.sampling_distance = sampling_distance;
    for (std::size_t i = 0; i < curves->size(); ++i)
    {
      m_place = "curve " + std::to_string(i) + ": ";
      Plain_curve curve;
      if (!read_curve((*curves)[i], curve))
        return false;
      result.curves.push_back(std::move(curve));
    }
    m_place.clear();
    const std::string problem = wireframe_problem(result, m_traits);
    if (!problem.empty())
      return fail(problem);
    wireframe = std::move(result);
    return true;
  }

  // ---- one curve ----

  bool read_curve(const Json& json, Plain_curve& curve)
  {
    if (!json.is_object())
      return fail("it is no JSON object");
    double rms = 0., max = 0.;
    std::size_t support = 0;
    if (!read_type(json, curve.type) || !read_vertex(json, "source", curve.source)
        || !read_vertex(json, "target", curve.target) || (json.contains("rms") && !read_number(json, "rms", rms))
        || (json.contains("max") && !read_number(json, "max", max))
        || (json.contains("support") && !read_count(json, "support", support))
        || (json.contains("doubts") && !read_doubts(json, curve.doubts)))
      return false;
    curve.rms = rms;
    curve.max = max;
    curve.support = support;
    return read_spline(json, curve) && read_parameters(json, curve);
  }

  // what a line or a conic has beside its spline; uncertainties may be missing
  bool read_parameters(const Json& json, Plain_curve& curve)
  {
    if (is_conic(curve.type) && !read_conic(json, curve.conic.emplace()))
      return false;
    if (curve.type == Wireframe_curve_type::BSPLINE || !json.contains("uncertainty"))
      return true;
    const Json& uncertainty = json["uncertainty"];
    double position = 0., direction = 0.;
    if (!uncertainty.is_object())
      return fail("\"uncertainty\" is " + found(json, "uncertainty") + ", it has to be an object");
    if (!read_number(uncertainty, "position", position) || !read_number(uncertainty, "direction", direction))
      return false;
    curve.uncertainty.position = position;
    curve.uncertainty.direction = direction;
    return !is_conic(curve.type)
      || read_pair(uncertainty, "radii", curve.uncertainty.major_radius, curve.uncertainty.minor_radius);
  }

  bool read_conic(const Json& json, Plain_conic& conic)
  {
    std::vector<double> center, axis, direction;
    if (!read_array_of(json, "center", 3, center) || !read_array_of(json, "axis", 3, axis)
        || !read_array_of(json, "major_direction", 3, direction)
        || !read_pair(json, "radii", conic.major_radius, conic.minor_radius)
        || !read_pair(json, "angles", conic.start_angle, conic.end_angle))
      return false;
    conic.center = m_traits.construct_point_3_object()(center[0], center[1], center[2]);
    conic.axis = m_traits.construct_vector_3_object()(axis[0], axis[1], axis[2]);
    conic.major_direction = m_traits.construct_vector_3_object()(direction[0], direction[1], direction[2]);
    return true;
  }

  bool read_pair(const Json& json, const char* key, double& first, double& second)
  {
    std::vector<double> numbers;
    if (!read_array_of(json, key, 2, numbers))
      return false;
    first = numbers[0];
    second = numbers[1];
    return true;
  }

  bool read_spline(const Json& json, Plain_curve& curve)
  {
    std::size_t degree = 0;
    std::vector<double> knots, weights;
    std::vector<Point_3> control_points;
    if (!json.contains("closed") || !json["closed"].is_boolean())
      return fail("\"closed\" has to be true or false");
    if (!read_count(json, "degree", degree) || !read_numbers(json, "knots", knots)
        || !read_points(json, "control_points", control_points)
        || (json.contains("weights") && !read_numbers(json, "weights", weights)))
      return false;
    if (json.contains("weights") && weights.empty())
      return fail("\"weights\" is empty; a curve without weights does not have that key");
    std::string why;
    if (degree > control_points.size())
      return fail("degree " + std::to_string(degree) + " needs more than that many control points; there are "
                  + std::to_string(control_points.size()));
    if (!Plain_spline::is_valid(degree, knots, control_points, weights, &why, m_traits))
      return fail(why);
    curve.spline = Plain_spline(degree, std::move(knots), std::move(control_points), std::move(weights),
                                json["closed"].get<bool>(), m_traits);
    return true;
  }

  bool read_type(const Json& json, Wireframe_curve_type& type)
  {
    const Wireframe_curve_type types[] = {Wireframe_curve_type::BSPLINE, Wireframe_curve_type::LINE,
                                          Wireframe_curve_type::CIRCLE,  Wireframe_curve_type::ARC,
                                          Wireframe_curve_type::ELLIPSE, Wireframe_curve_type::ELLIPTIC_ARC};
    std::string names;
    for (const Wireframe_curve_type known : types)
    {
      type = known;
      if (json.contains("type") && json["type"] == to_string(known))
        return true;
      names += std::string(names.empty() ? "" : ", ") + to_string(known);
    }
    return fail("\"type\" is " + found(json, "type") + ", it has to be one of " + names);
  }

  bool read_doubts(const Json& json, std::set<Wireframe_doubt>& doubts)
  {
    const Json* names = nullptr;
    if (!find_array(json, "doubts", names))
      return false;
    for (const Json& name : *names)
    {
      const auto is_named = [&](Wireframe_doubt known) { return name == to_string(known); };
      const auto found = std::find_if(all_doubts().begin(), all_doubts().end(), is_named);
      if (found == all_doubts().end())
        return fail("\"doubts\" holds " + brief(name) + ", which is no known reason");
      doubts.insert(*found);
    }
    return true;
  }

  // null or nothing stands for no vertex
  bool read_vertex(const Json& json, const char* key, std::size_t& vertex)
  {
    vertex = Plain_curve::no_vertex;
    if (!json.contains(key) || json[key].is_null())
      return true;
    if (!read_count(json, key, vertex))
      return false;
    // a number in the file must not be taken for the mark
    return vertex != Plain_curve::no_vertex
      || fail(quote(key) + " is " + found(json, key) + ", there is no such vertex");
  }

  // ---- values ----

  static std::string found(const Json& json, const char* key)
  {
    return json.contains(key) ? brief(json[key]) : std::string("missing");
  }

  static std::string brief(const Json& value)
  {
    if (value.is_structured())
      return value.is_array() ? "an array" : "an object";
    if (value.is_string())
      return quote(value.get_ref<const std::string&>());
    return value.dump();
  }

  static bool is_finite_number(const Json& value) { return value.is_number() && std::isfinite(value.get<double>()); }

  bool read_number(const Json& json, const char* key, double& number)
  {
    if (!json.contains(key) || !is_finite_number(json[key]))
      return fail(quote(key) + " is " + found(json, key) + ", it has to be a finite number");
    number = json[key].get<double>();
    return true;
  }

  bool read_count(const Json& json, const char* key, std::size_t& count)
  {
    if (!json.contains(key) || !json[key].is_number_unsigned())
      return fail(quote(key) + " is " + found(json, key) + ", it has to be a natural number");
    count = json[key].get<std::size_t>();
    return true;
  }

  bool find_array(const Json& json, const char* key, const Json*& array)
  {
    if (!json.contains(key) || !json[key].is_array())
      return fail(quote(key) + " is " + found(json, key) + ", it has to be an array");
    array = &json[key];
    return true;
  }

  bool read_numbers(const Json& json, const char* key, std::vector<double>& numbers)
  {
    const Json* array = nullptr;
    if (!find_array(json, key, array))
      return false;
    numbers.reserve(array->size());
    for (const Json& value : *array)
    {
      if (!is_finite_number(value))
        return fail(quote(key) + " holds at index " + std::to_string(numbers.size()) + " " + brief(value)
                    + ", which is no finite number");
      numbers.push_back(value.get<double>());
    }
    return true;
  }

  // two or three numbers, as `count` says
  bool read_array_of(const Json& json, const char* key, std::size_t count, std::vector<double>& numbers)
  {
    return (read_numbers(json, key, numbers) && numbers.size() == count)
      || fail(quote(key) + " is " + found(json, key) + ", it has to be an array of " + (count == 2 ? "two" : "three")
              + " finite numbers");
  }

  bool read_points(const Json& json, const char* key, std::vector<Point_3>& points)
  {
    const Json* array = nullptr;
    if (!find_array(json, key, array))
      return false;
    points.reserve(array->size());
    for (const Json& value : *array)
    {
      if (!value.is_array() || value.size() != 3 || !is_finite_number(value[0]) || !is_finite_number(value[1])
          || !is_finite_number(value[2]))
        return fail(quote(key) + " holds at index " + std::to_string(points.size())
                    + " something else than a point of three finite numbers");
      points.push_back(
        m_traits.construct_point_3_object()(value[0].get<double>(), value[1].get<double>(), value[2].get<double>()));
    }
    return true;
  }

  Plain_traits m_traits;
  std::string m_place;
  std::string m_error;
};

CGAL_WIREFRAME_EXTRACTION_JSON_INLINE
bool read_json(std::istream& stream, Plain_wireframe& wireframe, Wireframe_provenance& provenance, std::string& error)
{
  Wireframe_json_reader reader;
  reader.read(stream, wireframe, provenance);
  error = reader.error();
  return error.empty();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_READ_JSON_IMPL_H
