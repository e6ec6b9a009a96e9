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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_OBJ_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_OBJ_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_obj.h>
#include <CGAL/Wireframe_extraction/Spline_curve_3.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

inline std::string obj_comment(const Plain_wireframe& wireframe)
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
class Obj_spline_writer
{
  typedef Plain_curve Curve;
  typedef Plain_spline Spline;

public:
  Obj_spline_writer(std::ostream& out, const Plain_traits& traits) : m_out(out), m_traits(traits) {}

  void write(const Plain_wireframe& wireframe)
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
    const bool is_plain = !spline.is_rational() || spline.weights()[i] == 1.;
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
    return number_to_string(value);
  }

  std::ostream& m_out;
  const Plain_traits& m_traits;
  std::size_t m_number_of_points = 0;
};

inline bool write_obj_polylines(std::ostream& out, const Plain_wireframe& wireframe, const Curve_sampling& sampling,
                                std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, sampling, sampled, error))
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

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_obj(std::ostream& out, const Plain_wireframe& wireframe, const Curve_sampling& sampling, bool has_splines,
               std::string& error)
{
  if (!has_splines)
    return write_obj_polylines(out, wireframe, sampling, error);
  const Plain_traits traits;
  error = wireframe_problem(wireframe, traits);
  if (error.empty())
    Obj_spline_writer(out, traits).write(wireframe);
  return error.empty();
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_OBJ_IMPL_H
