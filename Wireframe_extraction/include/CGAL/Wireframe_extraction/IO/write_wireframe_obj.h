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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_OBJ_H
#define CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_OBJ_H

#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/number_utils.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

template <class GeomTraits>
std::string obj_comment(const CGAL::Wireframe<GeomTraits>& wireframe)
{
  return "# wireframe: " + plural(wireframe.vertices.size(), "vertex", "vertices") + ", "
    + plural(wireframe.curves.size(), "curve", "curves") + "\n";
}

inline std::string obj_group(std::size_t index, Wireframe_curve_type type)
{
  return "g curve_" + std::to_string(index) + "_" + to_string(type) + "\n";
}

// Writes curves as free-form curves. The vertices come first, and are the ends of curves as far as their weight
// allows that; other control points stand before the curve to which they belong.
template <class GeomTraits>
class Obj_spline_writer
{
  typedef Wireframe_curve<GeomTraits> Curve;
  typedef Spline_curve_3<GeomTraits> Spline;

public:
  Obj_spline_writer(std::ostream& out, const GeomTraits& traits) : m_out(out), m_traits(traits) {}

  void write(const CGAL::Wireframe<GeomTraits>& wireframe)
  {
    m_out << obj_comment(wireframe);
    for (const auto& vertex : wireframe.vertices)
      m_out << "v " << to_text(coordinates_of(vertex, m_traits)) << "\n";
    m_number_of_points = wireframe.vertices.size();
    for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    {
      const Curve& curve = wireframe.curves[i];
      if (curve.type == Wireframe_curve_type::LINE)
        write_line(i, curve);
      else
        write_spline(i, curve, curve.conic ? curve.conic->to_spline(curve.is_closed(), m_traits) : curve.spline);
    }
  }

private:
  // a segment needs no free form
  void write_line(std::size_t index, const Curve& curve)
  {
    const std::string first = end_point(curve.source, curve.spline, 0);
    const std::string last = end_point(curve.target, curve.spline, curve.spline.control_points().size() - 1);
    m_out << obj_group(index, curve.type) << "l " << first << " " << last << "\n";
  }

  void write_spline(std::size_t index, const Curve& curve, const Spline& spline)
  {
    const std::size_t last = spline.control_points().size() - 1;
    const std::string first_point = end_point(curve.source, spline, 0);
    std::string points = first_point;
    for (std::size_t i = 1; i < last; ++i)
      points += " " + new_point(spline, i);
    const bool ends_where_it_starts = spline.is_closed() && curve.target == Curve::no_vertex
      && (!spline.is_rational() || spline.weights().front() == spline.weights().back());
    points += " " + (ends_where_it_starts ? first_point : end_point(curve.target, spline, last));
    m_out << obj_group(index, curve.type) << "cstype " << (spline.is_rational() ? "rat " : "") << "bspline\ndeg "
          << std::to_string(spline.degree()) << "\ncurv " << text(spline.parameter_range().first) << " "
          << text(spline.parameter_range().second) << " " << points << "\nparm u";
    for (const auto& knot : spline.knots())
      m_out << " " << text(knot);
    m_out << "\nend\n";
  }

  // a vertex has the weight one
  std::string end_point(std::size_t vertex, const Spline& spline, std::size_t i)
  {
    const bool is_plain = !spline.is_rational() || CGAL::to_double(spline.weights()[i]) == 1.;
    return vertex != Curve::no_vertex && is_plain ? std::to_string(vertex + 1) : new_point(spline, i);
  }

  std::string new_point(const Spline& spline, std::size_t i)
  {
    m_out << "v " << to_text(coordinates_of(spline.control_points()[i], m_traits));
    if (spline.is_rational())
      m_out << " " << text(spline.weights()[i]);
    m_out << "\n";
    return std::to_string(++m_number_of_points);
  }

  template <class FT>
  static std::string text(const FT& value)
  {
    return number_to_string(CGAL::to_double(value));
  }

  std::ostream& m_out;
  const GeomTraits& m_traits;
  std::size_t m_number_of_points = 0;
};

template <class GeomTraits, class NamedParameters>
bool write_obj_polylines(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
                         std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, np, sampled, error))
    return false;
  out << obj_comment(wireframe);
  for (const Coordinates& point : sampled.points)
    out << "v " << to_text(point) << "\n";
  for (std::size_t i = 0; i < sampled.polylines.size(); ++i)
  {
    out << obj_group(i, wireframe.curves[i].type) << "l";
    for (const std::size_t index : sampled.polylines[i])
      out << " " << std::to_string(index + 1);
    out << "\n";
  }
  return true;
}

template <class GeomTraits, class NamedParameters>
bool write_obj(std::ostream& out, const CGAL::Wireframe<GeomTraits>& wireframe, const NamedParameters& np,
               std::string& error)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  if (!CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::obj_splines), false))
    return write_obj_polylines(out, wireframe, np, error);
  const GeomTraits traits = get_geom_traits<GeomTraits>(np);
  error = wireframe_problem(wireframe, traits);
  if (error.empty())
    Obj_spline_writer<GeomTraits>(out, traits).write(wireframe);
  return error.empty();
}

} // namespace internal

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a stream in the Wavefront OBJ format.
///
/// Every curve becomes a polyline (`l`) in a group (`g`) that is named after the index and the type of the
/// curve, such as `curve_0_line`. The points (`v`) start with the vertices of the wireframe in their order;
/// curves that share a vertex share its point, and a closed polyline ends with the point it starts with.
/// Coordinates are written with all digits.
///
/// With `obj_splines`, curves are not sampled but written as free-form curves (`cstype bspline`, or
/// `rat bspline` if they have weights), which not every program reads: a circle, an ellipse, or an arc as what
/// `Wireframe_conic::to_spline()` makes of it, and a line as a segment (`l`). Groups and vertices are as
/// before; the points that follow are control points, with their weight as fourth number. The format has no
/// word for a closed curve, which is one that ends at the point it starts with.
///
/// The format does not hold the parameters of circles and ellipses, the uncertainties, how well the cloud
/// supports a curve, the sampling distance, and the unit.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param stream the stream
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{sampling_step}
///     \cgalParamDescription{the largest arc length between two neighbouring points of a curve}
///     \cgalParamType{`GeomTraits::FT`}
///     \cgalParamDefault{0.25 times the sampling distance of the wireframe; one hundredth of the longest
///                       curve if that is 0}
///     \cgalParamExtra{in the unit of the wireframe; has to be positive. A curve is split evenly into as few
///                     pieces as that allows, a closed one into three at least.}
///   \cgalParamNEnd
///   \cgalParamNBegin{obj_splines}
///     \cgalParamDescription{whether curves are written as free-form curves, and not as polylines}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{If it is `true`, `sampling_step` has no effect.}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the stream cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_obj(std::ostream& stream, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_stream(
    stream, np, [&](std::ostream& out, std::string& error) { return internal::write_obj(out, wireframe, np, error); });
}

/// \ingroup PkgWireframeExtractionIO
/// writes a wireframe into a file in the Wavefront OBJ format.
///
/// The content is that of the overload for a stream.
/// The file is written as a whole or not at all: on failure a file of this name is as it was before, and
/// nothing else is left behind.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param filename the name of the file
/// \param wireframe the wireframe
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{sampling_step}
///     \cgalParamDescription{the largest arc length between two neighbouring points of a curve}
///     \cgalParamType{`GeomTraits::FT`}
///     \cgalParamDefault{0.25 times the sampling distance of the wireframe; one hundredth of the longest
///                       curve if that is 0}
///     \cgalParamExtra{in the unit of the wireframe; has to be positive. A curve is split evenly into as few
///                     pieces as that allows, a closed one into three at least.}
///   \cgalParamNEnd
///   \cgalParamNBegin{obj_splines}
///     \cgalParamDescription{whether curves are written as free-form curves, and not as polylines}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{If it is `true`, `sampling_step` has no effect.}
///   \cgalParamNEnd
///   \cgalParamNBegin{error_message}
///     \cgalParamDescription{receives what went wrong; empty on success}
///     \cgalParamType{`std::string*`}
///     \cgalParamDefault{a null pointer: nothing is received}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of the traits class of the wireframe}
///     \cgalParamType{`GeomTraits`}
///     \cgalParamDefault{a default constructed object}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \return `true` if all was written, else `false`: the wireframe has a number that is not finite, or is
///   malformed in another way, or the file cannot be written.
///
/// Takes time and memory linear in the number of points.
template <class GeomTraits, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool write_wireframe_obj(const std::string& filename, const CGAL::Wireframe<GeomTraits>& wireframe,
                         const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  return internal::write_to_file(filename, np, [&](std::ostream& out, std::string& error) {
    return internal::write_obj(out, wireframe, np, error);
  });
}

} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_WRITE_WIREFRAME_OBJ_H
