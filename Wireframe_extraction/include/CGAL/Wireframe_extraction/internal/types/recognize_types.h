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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_TYPES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_TYPES_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/types/Typed_curve_maker.h>
#include <CGAL/Wireframe_extraction/internal/types/Typed_piece.h>
#include <CGAL/Wireframe_extraction/internal/types/recognize_pieces.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// at equal steps of the parameter
template <class GeomTraits>
std::vector<Vector> sample(const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe_curve<GeomTraits>& curve,
                           std::size_t count)
{
  const auto range = curve.spline.parameter_range();
  std::vector<Vector> positions;
  for (std::size_t k = 0; k <= count; ++k)
  {
    const typename GeomTraits::FT share(double(k) / double(count));
    positions.push_back(skeleton.to_local(curve.spline.point(range.first + share * (range.second - range.first))));
  }
  return positions;
}

inline double longest_step(const std::vector<Vector>& polyline)
{
  double longest = 0.;
  for (std::size_t k = 1; k < polyline.size(); ++k)
    longest = (std::max)(longest, (polyline[k] - polyline[k - 1]).norm());
  return longest;
}

template <class GeomTraits>
Untyped_curve untyped(const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe_curve<GeomTraits>& curve)
{
  // r: a chord of 0.1 r leaves an arc of radius 1 r by 0.001 r
  constexpr double step = 0.1;
  constexpr std::size_t least_count = 16;
  constexpr int most_refinements =
    10; // of a spline whose parameter is far from its arc length: 1000 times as many points
  Untyped_curve result;
  result.vertices = {{curve.source, curve.target}};
  result.number_of_parameters = 3. * double(curve.spline.control_points().size());
  const double length = CGAL::to_double(curve.spline.length()) / skeleton.data().unit;
  std::size_t count = (std::max)(+least_count, std::size_t(std::ceil(length / step)));
  result.polyline = sample(skeleton, curve, count);
  // the parameter of a fitted spline is nearly its arc length, that of others may not be
  for (int k = 0; k < most_refinements && longest_step(result.polyline) > 2. * step; ++k)
    result.polyline = sample(skeleton, curve, count *= 2);
  if (curve.is_closed())
    result.polyline.back() = result.polyline.front();
  return result;
}

// Returns whether it was not cancelled; else `result` and `regularities` are left as they are.
template <class GeomTraits>
bool recognize_types(const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe<GeomTraits>& wireframe,
                     const Extraction_options& options, const std::function<bool(double)>& proceed,
                     Wireframe<GeomTraits>& result, std::vector<std::string>& regularities)
{
  std::vector<Untyped_curve> curves;
  for (const Wireframe_curve<GeomTraits>& curve : wireframe.curves)
    curves.push_back(untyped(skeleton, curve));
  std::vector<Vector> vertices;
  for (const typename GeomTraits::Point_3& p : wireframe.vertices)
    vertices.push_back(skeleton.to_local(p));
  Recognized_pieces recognized = recognize_pieces(skeleton.data(), options, vertices, curves, proceed);
  if (recognized.is_cancelled)
    return false;
  regularities = std::move(recognized.regularities);
  std::vector<Typed_piece>& pieces = recognized.pieces;
  for (Typed_piece& piece : pieces)
    if (!piece.is_primitive && piece.is_whole)
      piece.vertices = {{wireframe.curves[piece.curve].source, wireframe.curves[piece.curve].target}};

  // Of the cuts that were tried, those that are left become vertices; and those that closed curves passed by chance go.
  std::vector<std::size_t> new_index(recognized.vertices.size(), Typed_piece::no_vertex);
  std::vector<Vector> kept;
  Wireframe<GeomTraits> typed;
  typed.sampling_distance = wireframe.sampling_distance;
  const auto keep = [&](std::size_t v) {
    if (new_index[v] == Typed_piece::no_vertex)
    {
      new_index[v] = kept.size();
      kept.push_back(recognized.vertices[v]);
      const bool is_untouched = v < vertices.size() && recognized.vertices[v] == vertices[v];
      typed.vertices.push_back(is_untouched ? wireframe.vertices[v] : skeleton.to_point(recognized.vertices[v]));
    }
    return new_index[v];
  };
  std::vector<char> is_used(new_index.size(), 0);
  for (const Typed_piece& piece : pieces)
    for (const std::size_t v : piece.vertices)
      if (v != Typed_piece::no_vertex)
        is_used[v] = 1;
  std::vector<char> has_curve(wireframe.vertices.size(), 0);
  for (const Wireframe_curve<GeomTraits>& curve : wireframe.curves)
    if (curve.source != curve.no_vertex)
      has_curve[curve.source] = has_curve[curve.target] = 1;
  for (std::size_t v = 0; v < wireframe.vertices.size(); ++v)
    if (is_used[v] || !has_curve[v])
      keep(v);
  for (Typed_piece& piece : pieces)
    for (std::size_t& v : piece.vertices)
      v = v == Typed_piece::no_vertex ? v : keep(v);
  const Typed_curve_maker<GeomTraits> maker(skeleton, kept, typed.vertices);
  for (const Typed_piece& piece : pieces)
    typed.curves.push_back(maker.make(piece, wireframe.curves[piece.curve], curves[piece.curve].polyline));
  result = std::move(typed);
  return true;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_RECOGNIZE_TYPES_H
