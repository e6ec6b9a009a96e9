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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_SVG_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_SVG_IMPL_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Sampled_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/drawing_views.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_svg.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <set>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// A view and its place.
struct Svg_view : Drawing_view
{
  double width = 0., height = 0.; // of what is seen
  double left = 0., top = 0.;     // on the page, in pixels
};

// The four views of a drawing, all at one scale.
class Svg_drawing
{
public:
  explicit Svg_drawing(const Sampled_wireframe& sampled) : m_sampled(sampled)
  {
    for (std::size_t i = 0; i < m_views.size(); ++i)
      static_cast<Drawing_view&>(m_views[i]) = drawing_views()[i];
    find_extent();
    arrange();
  }

  bool is_finite() const { return std::isfinite(m_scale) && std::isfinite(m_width) && std::isfinite(m_height); }

  void write(std::ostream& out, const Plain_wireframe& wireframe, const char* unit) const
  {
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\""
        << pixels(m_width) << "\" height=\"" << pixels(m_height) << "\" viewBox=\"0 0 " << pixels(m_width) << " "
        << pixels(m_height)
        << "\" font-family=\"sans-serif\" font-size=\"14\">\n<title>Wireframe: top, front, right "
           "and isometric view</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (const Svg_view& view : m_views)
      write_view(out, wireframe, view);
    write_legend(out, wireframe);
    out << "<text x=\"" << pixels(margin) << "\" y=\"" << pixels(m_height - margin) << "\">Size " << size_text(0)
        << " x " << size_text(1) << " x " << size_text(2) << " " << unit << ", third-angle projection</text>\n</svg>\n";
  }

private:
  static constexpr double margin = 24., title_height = 30.;

  void find_extent()
  {
    if (!m_sampled.points.empty())
      m_low = m_high = m_sampled.points.front();
    for (const Coordinates& point : m_sampled.points)
      for (std::size_t i = 0; i < 3; ++i)
      {
        m_low[i] = (std::min)(m_low[i], point[i]);
        m_high[i] = (std::max)(m_high[i], point[i]);
      }
    for (Svg_view& view : m_views)
      for (const Coordinates& point : m_sampled.points)
      {
        view.width = (std::max)(view.width, 2. * std::abs(dot(from_center(point), view.right)));
        view.height = (std::max)(view.height, 2. * std::abs(dot(from_center(point), view.up)));
      }
  }

  Spline_vector from_center(const Coordinates& point) const
  {
    std::array<double, 3> p;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] = point[i] - (0.5 * m_low[i] + 0.5 * m_high[i]);
    return Spline_vector{p[0], p[1], p[2]};
  }

  // The top view is above the front view, and the right one on its right.
  void arrange()
  {
    const Svg_view &top = m_views[0], &isometric = m_views[1], &front = m_views[2], &right = m_views[3];
    const std::array<double, 2> columns = {
      {(std::max)(top.width, front.width), (std::max)(isometric.width, right.width)}};
    const std::array<double, 2> rows = {
      {(std::max)(top.height, isometric.height), (std::max)(front.height, right.height)}};
    const double size = (std::max)(columns[0] + columns[1], rows[0] + rows[1]);
    m_scale = size > 0. ? 900. / size : 1.;
    for (std::size_t i = 0; i < 4; ++i)
    {
      Svg_view& view = m_views[i];
      const bool is_right = (i % 2 == 1), is_below = (i / 2 == 1);
      // what is higher or wider than another view of its row or column has the same middle
      view.left = margin + (is_right ? m_scale * columns[0] + 2. * margin : 0.)
        + 0.5 * m_scale * (columns[is_right] - view.width);
      view.top = title_height + (is_below ? m_scale * rows[0] + margin + title_height : 0.)
        + 0.5 * m_scale * (rows[is_below] - view.height);
    }
    m_row_tops = {{title_height, m_scale * rows[0] + margin + 2. * title_height}};
    m_column_lefts = {{margin, m_scale * columns[0] + 3. * margin}};
    m_legend_top = m_row_tops[1] + m_scale * rows[1] + margin;
    // the lines of text below need some room, too
    m_width = (std::max)(m_scale * (columns[0] + columns[1]) + 4. * margin, 560.);
    m_height = m_legend_top + 3. * margin;
  }

  void write_view(std::ostream& out, const Plain_wireframe& wireframe, const Svg_view& view) const
  {
    const std::size_t i = static_cast<std::size_t>(&view - &m_views[0]);
    out << "<g id=\"" << view.id << "\" fill=\"none\" stroke-width=\"1.5\" stroke-linejoin=\"round\">\n<text x=\""
        << pixels(m_column_lefts[i % 2]) << "\" y=\"" << pixels(m_row_tops[i / 2] - 10.) << "\" fill=\"black\">"
        << view.title << "</text>\n";
    for (std::size_t j = 0; j < m_sampled.polylines.size(); ++j)
    {
      const Wireframe_curve_type type = wireframe.curves[j].type;
      out << "<polyline class=\"" << to_string(type) << "\" stroke=\"" << hexadecimal(colour_of(type))
          << "\" points=\"";
      for (const std::size_t index : m_sampled.polylines[j])
        out << pixels(page_x(view, index)) << "," << pixels(page_y(view, index)) << " ";
      out << "\"><title>curve " << std::to_string(j) << ": " << to_string(type) << "</title></polyline>\n";
    }
    for (std::size_t j = 0; j < wireframe.vertices.size(); ++j)
      out << "<circle class=\"vertex\" fill=\"black\" r=\"2\" cx=\"" << pixels(page_x(view, j)) << "\" cy=\""
          << pixels(page_y(view, j)) << "\"/>\n";
    out << "</g>\n";
  }

  double page_x(const Svg_view& view, std::size_t index) const
  {
    return view.left + m_scale * (0.5 * view.width + dot(from_center(m_sampled.points[index]), view.right));
  }

  double page_y(const Svg_view& view, std::size_t index) const
  {
    return view.top + m_scale * (0.5 * view.height - dot(from_center(m_sampled.points[index]), view.up));
  }

  // the kinds of curves that are there
  void write_legend(std::ostream& out, const Plain_wireframe& wireframe) const
  {
    std::set<Wireframe_curve_type> types;
    for (const auto& curve : wireframe.curves)
      types.insert(curve.type);
    double left = margin;
    out << "<g id=\"legend\">\n";
    for (const Wireframe_curve_type type : types)
    {
      out << "<text x=\"" << pixels(left) << "\" y=\"" << pixels(m_legend_top + 14.) << "\" fill=\""
          << hexadecimal(colour_of(type)) << "\">" << to_string(type) << "</text>\n";
      left += 90.;
    }
    out << "</g>\n";
  }

  // a length in the unit of the wireframe, short
  std::string size_text(std::size_t axis) const
  {
    const double size = m_high[axis] - m_low[axis];
    if (!(size > 0.))
      return "0";
    const double digits = std::pow(10., 3. - std::floor(std::log10(size)));
    return std::isfinite(digits) && digits > 0. ? number_to_string(std::round(size * digits) / digits)
                                                : number_to_string(size);
  }

  static std::string pixels(double value) { return number_to_string(std::round(1000. * value) / 1000.); }

  const Sampled_wireframe& m_sampled;
  std::array<Svg_view, 4> m_views;
  Coordinates m_low = {{0., 0., 0.}}, m_high = {{0., 0., 0.}};
  std::array<double, 2> m_row_tops, m_column_lefts;
  double m_scale = 1., m_legend_top = 0., m_width = 0., m_height = 0.;
};

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_svg(std::ostream& out, const Plain_wireframe& wireframe, const Curve_sampling& sampling,
               Wireframe_extraction::Length_unit unit, std::string& error)
{
  Sampled_wireframe sampled;
  if (!sample_wireframe(wireframe, sampling, sampled, error))
    return false;
  const Svg_drawing drawing(sampled);
  if (!drawing.is_finite())
  {
    error = "the wireframe is too large or too small to be drawn; scale it";
    return false;
  }
  drawing.write(out, wireframe, symbol_of(unit));
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_SVG_IMPL_H
