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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_PIECES_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_PIECES_IMPL_H

#include <CGAL/Wireframe_extraction/internal/types/Curve_type_recognizer.h>
#include <CGAL/Wireframe_extraction/internal/types/recognize_pieces.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// one line for each kind and each curve that others agree with
inline std::vector<std::string> texts(const std::vector<Regularity>& regularities)
{
  std::map<std::pair<Regularity_kind, std::size_t>, std::string> groups;
  for (const Regularity& regularity : regularities)
  {
    std::string& group = groups[{regularity.kind, regularity.curves[0]}];
    group +=
      (group.empty() ? std::to_string(regularity.curves[0]) + ", " : ", ") + std::to_string(regularity.curves[1]);
  }
  std::vector<std::string> result;
  for (const auto& group : groups)
  {
    const std::string first = std::to_string(group.first.second), list = group.second;
    switch (group.first.first)
    {
    case Regularity_kind::EQUAL_RADII: result.push_back("equal radii: curves " + list); break;
    case Regularity_kind::COAXIAL: result.push_back("coaxial: curves " + list); break;
    case Regularity_kind::PARALLEL: result.push_back("parallel: curves " + list); break;
    case Regularity_kind::ORTHOGONAL:
      result.push_back("orthogonal to curve " + first + ": curves " + list.substr(first.size() + 2));
    }
  }
  return result;
}

// Whether a closed curve passes smoothly through its vertex, at which it is alone: nothing but
// chance put the vertex there.
inline bool passes_through_vertex(const Untyped_curve& curve, std::size_t degree, double smooth_angle)
{
  const std::vector<Vector>& p = curve.polyline;
  const Vector start = p[1] - p[0], end = p[p.size() - 1] - p[p.size() - 2];
  return curve.is_loop() && degree == 2
    && start.dot(end) > std::cos(smooth_angle * CGAL_PI / 180.) * start.norm() * end.norm();
}

// how many ends of curves are at each vertex
inline std::vector<std::size_t> degrees_of(std::size_t number_of_vertices, const std::vector<Untyped_curve>& curves)
{
  std::vector<std::size_t> degrees(number_of_vertices, 0);
  for (const Untyped_curve& curve : curves)
    if (!curve.is_closed_without_vertex())
      for (const std::size_t v : curve.vertices)
        ++degrees[v];
  return degrees;
}

CGAL_WIREFRAME_EXTRACTION_INLINE Recognized_pieces recognize_pieces(const Skeleton_data& skeleton,
                                                                    const Extraction_options& options,
                                                                    const std::vector<Vector>& vertices,
                                                                    std::vector<Untyped_curve>& curves,
                                                                    const std::function<bool(double)>& proceed)
{
  const std::vector<std::size_t> degrees = degrees_of(vertices.size(), curves);
  for (Untyped_curve& curve : curves)
    if (!curve.is_closed_without_vertex()
        && passes_through_vertex(curve, degrees[curve.vertices[0]], options.smooth_angle))
      curve.vertices = {{Untyped_curve::no_vertex, Untyped_curve::no_vertex}};
  Curve_type_recognizer recognizer(*skeleton.band, skeleton.noise(options), options.support_distance,
                                   options.type_significance, options.regularize, vertices, curves, proceed);
  Recognized_pieces result;
  result.pieces = recognizer.run();
  result.is_cancelled = recognizer.is_cancelled();
  if (result.is_cancelled)
    return result;
  result.vertices = recognizer.vertices();
  result.regularities = texts(recognizer.regularities());
  return result;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_PIECES_IMPL_H
