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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_H

#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe_conic.h>
#include <CGAL/Wireframe_extraction/Wireframe_curve_type.h>
#include <CGAL/Wireframe_extraction/Wireframe_doubt.h>
#include <CGAL/Wireframe_extraction/internal/spline/Wireframe_check.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// How far the parameters of a line, circle or ellipse may be off, as standard deviations. Zero where it is not known.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
struct Wireframe_curve_uncertainty
{
  typedef GeomTraits Geom_traits;     ///< the traits class
  typedef typename GeomTraits::FT FT; ///< the number type

  FT position = FT(0);     ///< of the center, or of the middle of a line, in the cloud's unit
  FT direction = FT(0);    ///< of the axis, or of the direction of a line, in radians
  FT major_radius = FT(0); ///< of `Wireframe_conic::major_radius`, in the cloud's unit
  FT minor_radius = FT(0); ///< of `Wireframe_conic::minor_radius`, in the cloud's unit
};

/// \ingroup PkgWireframeExtractionClasses
/// One curve of a wireframe: its geometry, its two vertices, and how well the field supports it.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
struct Wireframe_curve
{
  typedef GeomTraits Geom_traits;            ///< the traits class
  typedef typename GeomTraits::FT FT;        ///< the number type
  typedef Spline_curve_3<GeomTraits> Spline; ///< the geometry of the curve

  /// the value of `source` and `target` of a closed curve that passes through no vertex
  static constexpr std::size_t no_vertex = (std::numeric_limits<std::size_t>::max)();

  Wireframe_curve_type type = Wireframe_curve_type::BSPLINE; ///< the kind of the curve
  Spline spline;                                       ///< the geometry; it starts and ends exactly at the vertices
  std::optional<Wireframe_conic<GeomTraits>> conic;    ///< the parameters of a circle, an ellipse, or an arc; curves of
                                                       ///< other kinds have none. `spline` has the same shape, up to
                                                       ///< rounding
  Wireframe_curve_uncertainty<GeomTraits> uncertainty; ///< of the parameters of a line or conic
  std::size_t source = no_vertex;   ///< index of the vertex at which the curve starts, or `no_vertex`
  std::size_t target = no_vertex;   ///< index of the vertex at which the curve ends, or `no_vertex`
  FT rms = FT(0);                   ///< root mean square of the field's residuals on the curve, in the cloud's unit
  FT max = FT(0);                   ///< largest absolute residual of the supporting points, in the cloud's unit
  std::size_t support = 0;          ///< number of points of the cloud that support the curve
  std::set<Wireframe_doubt> doubts; ///< why the curve may be wrong, as `extract_wireframe()` finds; empty if it has
                                    ///< nothing against it

  /// returns whether the curve has `doubts`. Constant time.
  bool is_doubtful() const { return !doubts.empty(); }

  /// returns whether the curve ends where it starts.
  bool is_closed() const { return spline.is_closed(); }

  /// returns the length of the curve, in the cloud's unit: `spline.length()`.
  FT length() const { return spline.length(); }

  /// returns the point of the curve at a parameter of `spline`: `spline.point(t)`.
  /// \param t the parameter, in `spline.parameter_range()`
  typename GeomTraits::Point_3 point(FT t) const { return spline.point(t); }

  /// returns the radius of a circle or of an arc of one, in the cloud's unit. Constant time.
  /// \pre `type` is `CIRCLE` or `ARC`, and there is a `conic`
  FT radius() const
  {
    CGAL_precondition_msg((type == Wireframe_curve_type::CIRCLE || type == Wireframe_curve_type::ARC) && conic,
                          "Only circles and their arcs have a radius.");
    return conic->major_radius;
  }
};

/// \ingroup PkgWireframeExtractionClasses
/// A parametric wireframe: vertices, and curves between them.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
struct Wireframe
{
  typedef GeomTraits Geom_traits;               ///< the traits class
  typedef typename GeomTraits::FT FT;           ///< the number type
  typedef typename GeomTraits::Point_3 Point_3; ///< the point type
  typedef Wireframe_curve<GeomTraits> Curve;    ///< the curve type

  FT sampling_distance = FT(0);  ///< the sampling distance of the cloud, in the cloud's unit
  std::vector<Point_3> vertices; ///< corners and ends of curves
  std::vector<Curve> curves;     ///< the curves

  /// returns whether the wireframe has no curve.
  bool is_empty() const { return curves.empty(); }

  /*!
  returns whether the wireframe is one that can be written, and says why not. All numbers have to be finite, vertices
  that curves refer to have to exist, splines have to be clamped, open curves have to start and end at their vertices
  and closed ones where they start, and circles, ellipses and arcs need a `Wireframe_curve::conic` of the same shape as
  their spline, which other curves must not have. Linear in the size of the wireframe.

  \param why if it is not null, the string that gets what is wrong first, or is emptied; null by default
  \param traits the traits object; the default is a default constructed one
  */
  bool is_valid(std::string* why = nullptr, const GeomTraits& traits = GeomTraits()) const
  {
    const std::string problem = Wireframe_extraction::internal::Wireframe_check<GeomTraits>(*this, traits)();
    if (why != nullptr)
      *why = problem;
    return problem.empty();
  }

  /// returns the indices of the curves that start or end at a vertex, in ascending order; one that does both is there
  /// once. Linear in the number of curves.
  /// \param vertex the index of the vertex
  std::vector<std::size_t> incident_curves(std::size_t vertex) const
  {
    std::vector<std::size_t> incident;
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (curves[i].source == vertex || curves[i].target == vertex)
        incident.push_back(i);
    return incident;
  }
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_H
