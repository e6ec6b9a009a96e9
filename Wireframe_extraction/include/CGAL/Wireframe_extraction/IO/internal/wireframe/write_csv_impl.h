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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_CSV_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_CSV_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_csv.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <cmath>
#include <cstddef>
#include <ostream>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// One row, whose fields need no quotes: they are numbers, and words of ours.
class Csv_row
{
public:
  void add(const std::string& text)
  {
    m_text += (m_is_first ? "" : ",") + text;
    m_is_first = false;
  }

  void add(double value) { add(number_to_string(value)); }

  void add(const Spline_vector& v)
  {
    add(v.x);
    add(v.y);
    add(v.z);
  }

  void add_empty(int count)
  {
    for (; count > 0; --count)
      add(std::string());
  }

  // RFC 4180 ends lines so, on all systems
  std::string text() const { return m_text + "\r\n"; }

private:
  std::string m_text;
  bool m_is_first = true;
};

inline const char* csv_header()
{
  return "index,type,closed,source,target,length,center_x,center_y,center_z,axis_x,axis_y,axis_z,"
         "major_direction_x,major_direction_y,major_direction_z,major_radius,minor_radius,start_angle,end_angle,"
         "position_uncertainty,direction_uncertainty,major_radius_uncertainty,minor_radius_uncertainty,"
         "rms,max,support,doubtful,doubts\r\n";
}

// of a line: its middle and its direction
inline void add_csv_line(const Plain_curve& curve, const Plain_traits& traits, Csv_row& row)
{
  const Spline_vector begin = vector_of(curve.spline.control_points().front(), traits);
  const Spline_vector end = vector_of(curve.spline.control_points().back(), traits);
  row.add(0.5 * begin + 0.5 * end);
  if (norm(end - begin) > 0.)
    row.add(unit_vector(end - begin));
  else
    row.add_empty(3);
  row.add_empty(7);
}

inline void add_csv_conic(const Plain_conic& conic, const Plain_traits& traits, Csv_row& row)
{
  row.add(vector_of(conic.center, traits));
  row.add(vector_of(conic.axis, traits));
  row.add(vector_of(conic.major_direction, traits));
  for (const auto& value : {conic.major_radius, conic.minor_radius, conic.start_angle, conic.end_angle})
    row.add(value);
}

inline std::string truth_text(bool value) { return value ? "true" : "false"; }

inline std::string csv_row(std::size_t index, const Plain_curve& curve, const Plain_traits& traits)
{
  Csv_row row;
  row.add(std::to_string(index));
  row.add(to_string(curve.type));
  row.add(truth_text(curve.is_closed()));
  for (const std::size_t vertex : {curve.source, curve.target})
    row.add(vertex == Plain_curve::no_vertex ? std::string() : std::to_string(vertex));
  row.add(curve.length());
  const auto& uncertainty = curve.uncertainty;
  if (curve.conic)
    add_csv_conic(*curve.conic, traits, row);
  else if (curve.type == Wireframe_curve_type::LINE)
    add_csv_line(curve, traits, row);
  else
    row.add_empty(13);
  if (curve.type == Wireframe_curve_type::BSPLINE)
    row.add_empty(2);
  else
  {
    row.add(uncertainty.position);
    row.add(uncertainty.direction);
  }
  if (curve.conic)
  {
    row.add(uncertainty.major_radius);
    row.add(uncertainty.minor_radius);
  }
  else
    row.add_empty(2);
  row.add(curve.rms);
  row.add(curve.max);
  row.add(std::to_string(curve.support));
  row.add(truth_text(curve.is_doubtful()));
  row.add(names_of(curve.doubts, " ")); // which need no quotes
  return row.text();
}

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_csv(std::ostream& out, const Plain_wireframe& wireframe, std::string& error)
{
  const Plain_traits traits;
  error = wireframe_problem(wireframe, traits);
  if (!error.empty())
    return false;
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    if (!std::isfinite(wireframe.curves[i].spline.length()))
    {
      error = "curve " + std::to_string(i) + " is too long for its length to be a number; scale the wireframe down";
      return false;
    }
  out << csv_header();
  for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    out << csv_row(i, wireframe.curves[i], traits);
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_CSV_IMPL_H
