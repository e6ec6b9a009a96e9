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

#ifndef CGAL_WIREFRAME_EXTRACTION_RECOGNIZE_CURVE_TYPES_H
#define CGAL_WIREFRAME_EXTRACTION_RECOGNIZE_CURVE_TYPES_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_type_recognizer.h>
#include <CGAL/Wireframe_extraction/internal/types/Typed_curve_maker.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_type_config.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
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
  constexpr double step = 0.1;
  Untyped_curve result;
  result.vertices = {{curve.source, curve.target}};
  result.number_of_parameters = 3. * double(curve.spline.control_points().size());
  const double length = CGAL::to_double(curve.spline.length()) / skeleton.unit();
  std::size_t count = (std::max)(std::size_t(16), std::size_t(std::ceil(length / step)));
  result.polyline = sample(skeleton, curve, count);
  // the parameter of a fitted spline is nearly its arc length, that of others may not be
  for (int k = 0; k < 10 && longest_step(result.polyline) > 2. * step; ++k)
    result.polyline = sample(skeleton, curve, count *= 2);
  if (curve.is_closed())
    result.polyline.back() = result.polyline.front();
  return result;
}

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

// Whether a closed curve passes smoothly through its vertex, at which it is alone: nothing but chance put the vertex there.
inline bool passes_through_vertex(const Untyped_curve& curve, std::size_t degree, double smooth_angle)
{
  const std::vector<Vector>& p = curve.polyline;
  const Vector start = p[1] - p[0], end = p[p.size() - 1] - p[p.size() - 2];
  return curve.is_loop() && degree == 2
    && start.dot(end) > std::cos(smooth_angle * CGAL_PI / 180.) * start.norm() * end.norm();
}

template <class GeomTraits>
Wireframe<GeomTraits> recognize(const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe<GeomTraits>& wireframe,
                                const Extraction_options& options, std::vector<std::string>& regularities)
{
  std::vector<Untyped_curve> curves;
  for (const Wireframe_curve<GeomTraits>& curve : wireframe.curves)
    curves.push_back(untyped(skeleton, curve));
  std::vector<Vector> vertices;
  for (const typename GeomTraits::Point_3& p : wireframe.vertices)
    vertices.push_back(skeleton.to_local(p));
  std::vector<std::size_t> degrees(vertices.size(), 0);
  for (const Untyped_curve& curve : curves)
    if (!curve.is_closed_without_vertex())
      for (const std::size_t v : curve.vertices)
        ++degrees[v];
  for (Untyped_curve& curve : curves)
    if (!curve.is_closed_without_vertex()
        && passes_through_vertex(curve, degrees[curve.vertices[0]], options.smooth_angle))
      curve.vertices = {{Untyped_curve::no_vertex, Untyped_curve::no_vertex}};
  Curve_type_recognizer recognizer(skeleton.band(), noise_of(skeleton, options), options.support_distance,
                                   options.type_significance, options.regularize, vertices, curves);
  std::vector<Typed_piece> pieces = recognizer.run();
  regularities = texts(recognizer.regularities());
  for (Typed_piece& piece : pieces)
    if (!piece.is_primitive && piece.is_whole)
      piece.vertices = {{wireframe.curves[piece.curve].source, wireframe.curves[piece.curve].target}};

  // Of the cuts that were tried, those that are left become vertices; and those that closed curves passed by chance go.
  std::vector<std::size_t> new_index(recognizer.vertices().size(), Typed_piece::no_vertex);
  std::vector<Vector> kept;
  Wireframe<GeomTraits> result;
  result.sampling_distance = wireframe.sampling_distance;
  const auto keep = [&](std::size_t v) {
    if (new_index[v] == Typed_piece::no_vertex)
    {
      new_index[v] = kept.size();
      kept.push_back(recognizer.vertices()[v]);
      const bool is_untouched = v < vertices.size() && recognizer.vertices()[v] == vertices[v];
      result.vertices.push_back(is_untouched ? wireframe.vertices[v] : skeleton.to_point(recognizer.vertices()[v]));
    }
    return new_index[v];
  };
  std::vector<char> is_used(new_index.size(), 0);
  for (const Typed_piece& piece : pieces)
    for (const std::size_t v : piece.vertices)
      if (v != Typed_piece::no_vertex)
        is_used[v] = 1;
  for (std::size_t v = 0; v < wireframe.vertices.size(); ++v)
    if (is_used[v] || degrees[v] == 0)
      keep(v);
  for (Typed_piece& piece : pieces)
    for (std::size_t& v : piece.vertices)
      v = v == Typed_piece::no_vertex ? v : keep(v);
  const Typed_curve_maker<GeomTraits> maker(skeleton, kept, result.vertices);
  for (const Typed_piece& piece : pieces)
    result.curves.push_back(maker.make(piece, wireframe.curves[piece.curve], curves[piece.curve].polyline));
  return result;
}

} // namespace internal

/*!
\ingroup PkgWireframeExtractionFunctions

replaces the splines of a wireframe by lines, circles, ellipses, and arcs of these, where the field says that they are.

Along each curve, about every 1.5 r, the points nearby tell where the field has the curve and how firmly it is held there.
A line, a circle and an ellipse are fitted to these stations by robust least squares, and the first of them is taken under
which the stations are not less likely than `type_significance`: the sum of their squared residuals, in units of the variance
that the noise level of the field implies, follows a chi-square distribution if the curve is the true one. Single residuals
count as four standard deviations at most, and two stations as one independent observation, since neighbors share errors of
the field. A curve that is none of them is cut: dynamic programming finds the lines and arcs, and the splines between them, of
least Bayesian information criterion \cgalCite{Sch78}, so that a slot becomes two lines and two arcs. Three arcs of circles in a
row are no evidence of arcs, for any smooth curve can be approximated so, and with fewer than three stations nothing is
recognized: such curves stay splines.

Then all lines, circles and ellipses are fitted once more, at once, with the vertices as common parameters: corners stay on
all their curves, and where a cut joins a line and an arc, or two arcs, their tangents agree, if that is not less likely than
`type_significance` either. What the common fit would make unlikely becomes a spline again. Splines follow the vertices.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton
\param wireframe the wireframe that `fit_curves()` makes from it; only splines are expected
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{type_significance}
    \cgalParamDescription{the share of true lines, circles and ellipses that are taken for splines because of the errors of the
                          field. A smaller one takes more curves for lines and circles}
    \cgalParamType{`double`}
    \cgalParamDefault{0.001}
    \cgalParamExtra{between 0 and 1}
  \cgalParamNEnd
  \cgalParamNBegin{regularize}
    \cgalParamDescription{whether radii that are equal as closely as they are known, circles on one axis, and directions that
                          are parallel or orthogonal, become exactly so. Where a curve would then be less likely than
                          `type_significance`, its regularities are given up}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{extraction_report}
    \cgalParamDescription{a reference to what shall tell what was made regular: `std::ref(report)`}
    \cgalParamType{`std::reference_wrapper<Wireframe_extraction_report>`}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{support_distance}
    \cgalParamDescription{how far from the curves points may lie that count, in multiples of r; at most what
                          `select_skeleton()` kept}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{smooth_angle}
    \cgalParamDescription{the largest angle at which a curve passes smoothly through a vertex, in degrees}
    \cgalParamType{`double`}
    \cgalParamDefault{20}
  \cgalParamNEnd
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the standard deviation of the distances, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{what `contract_skeleton()` or `refine_field()` found}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the wireframe with types, parameters and their uncertainties. Its vertices are those of `wireframe`, in their order,
then those of the cuts. The vertex of a closed curve that passes smoothly through it, and is alone there, is left out if the
curve becomes a circle or an ellipse, or is cut elsewhere.

Complexity: O(n log n) for n points, besides the solution of the sparse normal equations. The number of places at which a curve
may be cut is bounded.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Wireframe<GeomTraits> recognize_curve_types(
  const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe<GeomTraits>& wireframe,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  Wireframe_extraction_report own_report;
  Wireframe_extraction_report& report =
    CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::extraction_report),
                                       std::ref(own_report))
      .get();
  const internal::Extraction_options options = internal::extraction_options(np);
  return internal::run_concurrently<ConcurrencyTag>(
    [&] { return internal::recognize(skeleton, wireframe, options, report.regularities); });
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_RECOGNIZE_CURVE_TYPES_H
