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

#ifndef WIREFRAME_EVALUATION_READ_TRUTH_H
#define WIREFRAME_EVALUATION_READ_TRUTH_H

#include <Wireframe_evaluation/Evaluated_curve.h>
#include <Wireframe_evaluation/json_access.h>

#include <string>
#include <utility>
#include <vector>

namespace Wireframe_evaluation {
namespace internal {

inline std::vector<Evaluated_curve> true_curves(const Json& document, const char* key)
{
  std::vector<Evaluated_curve> result;
  for (const Json& value : array_member(document, key, ""))
  {
    const std::string place = std::string(key) + "[" + std::to_string(result.size()) + "]: ";
    if (!value.is_object())
      throw Format_error(place + "is not an object");
    const std::vector<Point> points_of_curve = points(value, "points", place);
    if (points_of_curve.size() < 2)
      throw Format_error(place + "has fewer than two points");
    Evaluated_curve curve{Polyline(points_of_curve)};
    curve.is_closed = boolean(value, "closed", place);
    curve.kind = curve_kind(text(value, "kind", place));
    result.push_back(std::move(curve));
  }
  return result;
}

} // namespace internal

/*!
reads a true wireframe: a JSON object with the sampling distance `r`, the lists `curves` and `segments` (the
latter may be missing) of objects with `kind`, `closed` and `points`, the list `corners`, and the number `points`
of points of the cloud (which may be missing). Throws `Format_error` if it cannot.
*/
inline True_wireframe read_truth(const std::string& path)
{
  const internal::Json document = internal::read_json(path);
  True_wireframe result;
  result.sampling_distance = internal::number(internal::member(document, "r", ""), "\"r\"");
  if (!(result.sampling_distance > 0.))
    throw Format_error("the sampling distance \"r\" is not positive");
  result.curves = internal::true_curves(document, "curves");
  if (result.curves.empty())
    throw Format_error("there is no curve");
  if (internal::has(document, "segments"))
    result.segments = internal::true_curves(document, "segments");
  result.corners = internal::points(document, "corners", "");
  if (internal::has(document, "points") && document["points"].is_number_unsigned())
    result.number_of_points = document["points"].get<std::size_t>();
  return result;
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_READ_TRUTH_H
