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
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/options/Stage_call.h>
#include <CGAL/Wireframe_extraction/internal/types/call_recognize_curve_types.h>

#include <functional>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionFunctions

replaces the splines of a wireframe by lines, circles, ellipses, and arcs of these, where the field says that they are.

Along each curve, about every 1.5 r, the points nearby tell where the field has the curve and how firmly it is held
there. A line, a circle and an ellipse are fitted to these stations by robust least squares, and the first of them is
taken under which the stations are not less likely than `type_significance`: the sum of their squared residuals, in
units of the variance that the noise level of the field implies, follows a chi-square distribution if the curve is the
true one. Single residuals count as four standard deviations at most, and two stations as one independent observation,
since neighbors share errors of the field. A curve that is none of them is cut: dynamic programming finds the lines and
arcs, and the splines between them, of least Bayesian information criterion \cgalCite{Sch78}, so that a slot becomes two
lines and two arcs. Three arcs of circles in a row are no evidence of arcs, for any smooth curve can be approximated so,
and with fewer than three stations nothing is recognized: such curves stay splines. So do those that a line, a circle or
an ellipse would replace that does not stay, along its whole length, within 1 r and four standard deviations of the
spline; a little more over gaps, and 3 r around vertices.

Then all lines, circles and ellipses are fitted once more, at once, with the vertices as common parameters: corners stay
on all their curves, and where a cut joins a line and an arc, or two arcs, their tangents agree, if that is not less
likely than `type_significance` either. What the common fit would make unlikely becomes a spline
again. Splines follow the vertices.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton the skeleton
\param wireframe the wireframe that `fit_curves()` makes from it; only splines are expected
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{type_significance}
    \cgalParamDescription{the share of true lines, circles and ellipses that are taken for splines because of the errors
                          of the field. A smaller one takes more curves for lines and circles}
    \cgalParamType{`double`}
    \cgalParamDefault{0.001}
    \cgalParamExtra{between 0 and 1}
  \cgalParamNEnd
  \cgalParamNBegin{regularize}
    \cgalParamDescription{whether radii that are equal as closely as they are known, circles on one axis, and directions
                          that are parallel or orthogonal, become exactly so. Where a curve would then be less likely
                          than `type_significance`, its regularities are given up}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{extraction_report}
    \cgalParamDescription{a reference to what gets the status, the message, and what was made regular:
                          `std::ref(report)`}
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
  \wireframeParamCallback{After cancelling, the wireframe is empty, and the status in the report is `CANCELLED`.}
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the standard deviation of the distances, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{what `contract_skeleton()` or `refine_field()` found}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the wireframe with types, parameters and their uncertainties. Its vertices are those of `wireframe`, in their
order, then those of the cuts. The vertex of a closed curve that passes smoothly through it, and is alone there, is left
out if the curve becomes a circle or an ellipse, or is cut elsewhere. It is empty if a parameter is out of its range;
the report has the reason.

Complexity: O(n log n) for n points, besides the solution of the sparse normal equations. The number of places at which
a curve may be cut is bounded.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Wireframe<GeomTraits> recognize_curve_types(
  const Wireframe_skeleton<GeomTraits>& skeleton, const Wireframe<GeomTraits>& wireframe,
  const NamedParameters& np = CGAL::parameters::default_values())
{
  internal::Stage_call call(np);
  return internal::call_recognize_curve_types<ConcurrencyTag>(skeleton, wireframe, call);
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_RECOGNIZE_CURVE_TYPES_H
