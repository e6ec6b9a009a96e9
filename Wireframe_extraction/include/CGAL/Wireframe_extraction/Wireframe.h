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

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// The kind of a curve of a wireframe. Whatever its kind, a curve has its B-spline form.
enum class Wireframe_curve_type
{
  BSPLINE,     ///< a B-spline that is none of the others
  LINE,        ///< a line segment
  CIRCLE,      ///< a full circle
  ARC,         ///< an arc of a circle
  ELLIPSE,     ///< a full ellipse
  ELLIPTIC_ARC ///< an arc of an ellipse
};

/// \ingroup PkgWireframeExtractionFunctions
/// returns whether curves of this kind have a `Wireframe_curve::conic`. Constant time.
///
/// \param type the kind
inline bool is_conic(Wireframe_curve_type type)
{
  return type != Wireframe_curve_type::BSPLINE && type != Wireframe_curve_type::LINE;
}

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
  Spline spline;                     ///< the geometry; it starts and ends exactly at the vertices
  Wireframe_conic<GeomTraits> conic; ///< the parameters of a circle, an ellipse, or an arc; `spline` has the same
                                     ///< shape, up to rounding. Without meaning for other kinds
  Wireframe_curve_uncertainty<GeomTraits> uncertainty; ///< of the parameters of a line or conic
  std::size_t source = no_vertex; ///< index of the vertex at which the curve starts, or `no_vertex`
  std::size_t target = no_vertex; ///< index of the vertex at which the curve ends, or `no_vertex`
  FT root_mean_square = FT(0);    ///< root mean square of the field's residuals on the curve, in the cloud's unit
  FT maximum_deviation = FT(0);   ///< largest absolute residual of the supporting points, in the cloud's unit
  std::size_t support = 0;        ///< number of points of the cloud that support the curve

  /// returns whether the curve ends where it starts.
  bool is_closed() const { return spline.is_closed(); }
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
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_H
