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

#ifndef WIREFRAME_EVALUATION_READ_PREDICTION_H
#define WIREFRAME_EVALUATION_READ_PREDICTION_H

#include <Wireframe_evaluation/Bspline.h>
#include <Wireframe_evaluation/Evaluated_curve.h>
#include <Wireframe_evaluation/json_access.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_evaluation {
namespace internal {

class Prediction_reader
{
public:
  explicit Prediction_reader(double step) : m_step(step) {}

  Predicted_wireframe read(const Json& document)
  {
    if (has(document, "vertices"))
      m_result.vertices = points(document, "vertices", "");
    if (has(document, "corners"))
      m_result.corners = points(document, "corners", "");
    for (const Json& value : array_member(document, "curves", ""))
      add_curve(value);
    return std::move(m_result);
  }

private:
  void add_curve(const Json& value)
  {
    const std::string place = "curves[" + std::to_string(m_result.curves.size()) + "]: ";
    if (!value.is_object())
      throw Format_error(place + "is not an object");
    Evaluated_curve curve{has(value, "control_points") ? spline(value, place) : given_polyline(value, place)};
    curve.is_closed = boolean(value, "closed", place);
    curve.kind = curve_kind(text(value, "type", place));
    curve.source = vertex(value, "source", place);
    curve.target = vertex(value, "target", place);
    m_result.curves.push_back(std::move(curve));
  }

  Polyline spline(const Json& value, const std::string& place) const
  {
    Bspline result;
    const Json& degree = member(value, "degree", place);
    if (!degree.is_number_unsigned())
      throw Format_error(place + "\"degree\" is not a whole number of 1 or more");
    result.degree = degree.get<std::size_t>();
    result.knots = numbers(value, "knots", place);
    result.control_points = points(value, "control_points", place);
    if (has(value, "weights"))
      result.weights = numbers(value, "weights", place);
    try
    {
      result.check();
      return result.polyline(m_step);
    }
    catch (const std::runtime_error& error)
    {
      throw Format_error(place + error.what());
    }
  }

  static Polyline given_polyline(const Json& value, const std::string& place)
  {
    if (!has(value, "points"))
      throw Format_error(place + "there is neither \"control_points\" nor \"points\"");
    const std::vector<Point> result = points(value, "points", place);
    if (result.size() < 2)
      throw Format_error(place + "has fewer than two points");
    return Polyline(result);
  }

  std::size_t vertex(const Json& value, const char* key, const std::string& place) const
  {
    if (!has(value, key))
      return Evaluated_curve::no_vertex;
    const Json& index = value[key];
    if (!index.is_number_unsigned() || index.get<std::size_t>() >= m_result.vertices.size())
      throw Format_error(place + "\"" + key + "\" is not an index of one of the "
                         + std::to_string(m_result.vertices.size()) + " vertices");
    return index.get<std::size_t>();
  }

  const double m_step;
  Predicted_wireframe m_result;
};

} // namespace internal

/*!
reads a wireframe to be evaluated, in wireframe JSON; a curve may be given by a list `points` instead of a
B-spline. Its curves become polylines with points about `step` apart at most. Throws `Format_error` if it cannot.
*/
inline Predicted_wireframe read_prediction(const std::string& path, double step)
{
  return internal::Prediction_reader(step).read(internal::read_json(path));
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_READ_PREDICTION_H
