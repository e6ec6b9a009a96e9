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

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Drawn_curve.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/drawing_views.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/unit_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/write_svg.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// A view and its place.
struct Svg_view : Drawing_view
{
  double width = 0., height = 0.; // of what is seen
  double left = 0., top = 0.;     // on the page, in millimeters
};

// a place on the page, in millimeters
struct Svg_point
{
  double x = 0., y = 0.;
};

// The four views of a drawing, all at one scale. Lengths on the page are in millimeters.
class Svg_drawing
{
public:
  Svg_drawing(const Plain_wireframe& wireframe, Wireframe_extraction::Length_unit unit, bool has_dimensions)
    : m_wireframe(wireframe), m_unit(unit), m_has_dimensions(has_dimensions)
  {
    for (std::size_t i = 0; i < m_views.size(); ++i)
      static_cast<Drawing_view&>(m_views[i]) = drawing_views()[i];
    find_curves();
    arrange();
  }

  bool is_finite() const { return std::isfinite(m_scale) && std::isfinite(m_width) && std::isfinite(m_height); }

  void write(std::ostream& out) const
  {
    const std::string width = number(m_width), height = number(m_height);
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width
        << "mm\" height=\"" << height << "mm\" viewBox=\"0 0 " << width << " " << height << "\" data-scale=\""
        << number_to_string(m_scale)
        << "\" font-family=\"sans-serif\" font-size=\"4\">\n<title>Wireframe: top, front, right "
           "and isometric view</title>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
    for (const Svg_view& view : m_views)
      write_view(out, view);
    write_legend(out);
    out << "<text x=\"" << number(margin) << "\" y=\"" << number(m_height - margin) << "\">Size " << size_text(0)
        << " x " << size_text(1) << " x " << size_text(2) << " " << symbol_of(m_unit)
        << ", third-angle projection, scale " << scale_text() << "</text>\n</svg>\n";
  }

private:
  static constexpr double margin = 7., title_height = 9.; // room around the views, and for their titles
  // What is between these sizes is drawn as it is, and all else at the scale of ISO 5455 at which it fits.
  static constexpr double least_size = 60., most_size = 600., fitting_size = 400.;
  static constexpr double least_width = 170.; // that the text below needs

  void find_curves()
  {
    const Plain_traits traits;
    Drawn_range ranges[3];
    for (const auto& curve : m_wireframe.curves)
      for (const auto& point : curve.spline.control_points())
        add_to(ranges, vector_of(point, traits));
    for (const auto& vertex : m_wireframe.vertices)
      add_to(ranges, vector_of(vertex, traits));
    Spline_vector high;
    if (!m_wireframe.vertices.empty() || !m_wireframe.curves.empty())
    {
      const Spline_vector low = {ranges[0].low, ranges[1].low, ranges[2].low};
      high = {ranges[0].high, ranges[1].high, ranges[2].high};
      m_origin = 0.5 * low + 0.5 * high;
      high = high - low;
    }
    const double size = norm(high);
    for (const auto& curve : m_wireframe.curves)
      m_curves.emplace_back(curve, m_origin, size);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Drawn_range range = range_along(Spline_vector{i == 0 ? 1. : 0., i == 1 ? 1. : 0., i == 2 ? 1. : 0.});
      m_size[i] = range.high - range.low;
    }
    find_middle();
    for (Svg_view& view : m_views)
    {
      view.width = extent_along(view.right);
      view.height = extent_along(view.up);
    }
  }

  static void add_to(Drawn_range* ranges, const Spline_vector& p)
  {
    ranges[0].add(p.x);
    ranges[1].add(p.y);
    ranges[2].add(p.z);
  }

  // control points lie outside of their curves, whose middle is the middle of each view
  void find_middle()
  {
    const Drawn_range x = range_along(Spline_vector{1., 0., 0.}), y = range_along(Spline_vector{0., 1., 0.}),
                      z = range_along(Spline_vector{0., 0., 1.});
    m_middle = {0.5 * x.low + 0.5 * x.high, 0.5 * y.low + 0.5 * y.high, 0.5 * z.low + 0.5 * z.high};
  }

  Drawn_range range_along(const Spline_vector& direction) const
  {
    Drawn_range range;
    for (const Drawn_curve& curve : m_curves)
      curve.extend(direction, range);
    for (const auto& vertex : m_wireframe.vertices)
      range.add(dot(vector_of(vertex, Plain_traits()) - m_origin, direction));
    if (m_curves.empty() && m_wireframe.vertices.empty())
      range.add(0.);
    return range;
  }

  // the length on the page of what is seen, if the middle is to be in its middle
  double extent_along(const Spline_vector& direction) const
  {
    const Drawn_range range = range_along(direction);
    const double middle = dot(m_middle, direction);
    return 2. * (std::max)(range.high - middle, middle - range.low);
  }

  // The top view is above the front view, and the right one on its right.
  void arrange()
  {
    const Svg_view &top = m_views[0], &isometric = m_views[1], &front = m_views[2], &right = m_views[3];
    const std::array<double, 2> columns = {
      {(std::max)(top.width, front.width), (std::max)(isometric.width, right.width)}};
    const std::array<double, 2> rows = {
      {(std::max)(top.height, isometric.height), (std::max)(front.height, right.height)}};
    find_scale((std::max)(columns[0] + columns[1], rows[0] + rows[1]));
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
    m_width = (std::max)(m_scale * (columns[0] + columns[1]) + 4. * margin, least_width);
    m_height = m_legend_top + 3. * margin;
  }

  // `size` is the width or height of all views together
  void find_scale(double size)
  {
    const double unit = 1000. * meters_of(m_unit), millimeters = size * unit;
    if (millimeters > 0. && !(millimeters >= least_size && millimeters <= most_size))
    {
      const double most = fitting_size / millimeters, power = std::pow(10., std::floor(std::log10(most)));
      m_ratio = power * (most >= 5. * power ? 5. : most >= 2. * power ? 2. : 1.);
    }
    m_scale = m_ratio * unit;
  }

  // as on drawings: 2:1 is twice as large
  std::string scale_text() const
  {
    const auto rounded = [](double ratio) {
      const std::string text = std::to_string(std::round(ratio)); // without an exponent
      return text.substr(0, text.find_first_not_of("0123456789"));
    };
    return m_ratio >= 1. ? rounded(m_ratio) + ":1" : "1:" + rounded(1. / m_ratio);
  }

  void write_view(std::ostream& out, const Svg_view& view) const
  {
    const std::size_t i = static_cast<std::size_t>(&view - &m_views[0]);
    out << "<g id=\"" << view.id
        << "\" fill=\"none\" stroke-width=\"0.4\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n<text x=\""
        << number(m_column_lefts[i % 2]) << "\" y=\"" << number(m_row_tops[i / 2] - 3.) << "\" fill=\"black\">"
        << view.title << "</text>\n";
    for (std::size_t j = 0; j < m_curves.size(); ++j)
      write_curve(out, view, j);
    for (const auto& vertex : m_wireframe.vertices)
    {
      const Svg_point p = place(view, vector_of(vertex, Plain_traits()) - m_origin);
      out << "<circle class=\"vertex\" fill=\"black\" r=\"0.6\" cx=\"" << number(p.x) << "\" cy=\"" << number(p.y)
          << "\"/>\n";
    }
    if (m_has_dimensions)
      write_dimensions(out, view);
    out << "</g>\n";
  }

  void write_curve(std::ostream& out, const Svg_view& view, std::size_t j) const
  {
    const auto& curve = m_wireframe.curves[j];
    const std::string type = to_string(curve.type), doubts = names_of(curve.doubts, ", ");
    std::string element;
    const std::string shape = m_curves[j].is_segment() ? segment(view, m_curves[j].ends(), element)
      : m_curves[j].is_arc()                           ? arc(view, m_curves[j].arc(), element)
                                                       : cubics(view, m_curves[j].cubics(), element);
    out << "<" << element << " class=\"" << type << (curve.is_doubtful() ? " doubtful" : "") << "\" stroke=\""
        << hexadecimal(colour_of(curve.type)) << "\" " << shape << "><title>curve " << std::to_string(j) << ": " << type
        << (doubts.empty() ? "" : "; doubtful: " + doubts) << "</title></" << element << ">\n";
  }

  std::string segment(const Svg_view& view, const std::array<Spline_vector, 2>& ends, std::string& element) const
  {
    element = "line";
    const Svg_point p = place(view, ends[0]), q = place(view, ends[1]);
    return "x1=\"" + number(p.x) + "\" y1=\"" + number(p.y) + "\" x2=\"" + number(q.x) + "\" y2=\"" + number(q.y)
      + "\"";
  }

  // The projection of an ellipse is one, of which two conjugate half diameters are known.
  std::string arc(const Svg_view& view, const Drawn_curve::Arc& arc, std::string& element) const
  {
    // Shares of the larger radius: what is seen as a segment, and as round; and below what the ends of an arc, which
    // are rounded to a millionth of a millimeter, no longer tell its center.
    static constexpr double edge_on = 1e-9, round = 1e-9, flat = 0.01;
    const Svg_point c = place(view, arc.center), u = direction(view, arc.u), v = direction(view, arc.v);
    const double angle = 0.5 * std::atan2(2. * (u.x * v.x + u.y * v.y), u.x * u.x + u.y * u.y - v.x * v.x - v.y * v.y);
    const double co = std::cos(angle), si = std::sin(angle);
    const Svg_point major = {co * u.x + si * v.x, co * u.y + si * v.y},
                    minor = {co * v.x - si * u.x, co * v.y - si * u.y};
    const double a = std::hypot(major.x, major.y), b = std::hypot(minor.x, minor.y);
    if (!(b > edge_on * a))
      return seen_from_the_edge(view, arc, element);
    const double degrees = std::atan2(major.y, major.x) * 180. / CGAL_PI;
    if (!arc.is_full)
    {
      element = "path";
      if (b < flat * a)
        return flat_path(view, arc);
      return "d=\""
        + arc_path(view, arc, number(a) + " " + number(b) + " " + number_to_string(degrees), u.x * v.y - u.y * v.x > 0.)
        + "\"";
    }
    const std::string center = "cx=\"" + number(c.x) + "\" cy=\"" + number(c.y) + "\" ";
    element = a - b <= round * a ? "circle" : "ellipse";
    if (element == "circle")
      return center + "r=\"" + number(a) + "\"";
    return center + "rx=\"" + number(a) + "\" ry=\"" + number(b) + "\" transform=\"rotate(" + number_to_string(degrees)
      + " " + number(c.x) + " " + number(c.y) + ")\"";
  }

  // An arc is given by its ends, which determine it badly if it is near half a turn or a whole one; a third is well.
  std::string arc_path(const Svg_view& view, const Drawn_curve::Arc& arc, const std::string& radii,
                       bool is_clockwise) const
  {
    const int count = static_cast<int>(std::ceil(arc.sweep / (2. / 3. * CGAL_PI) * (1. - 1e-12)));
    std::string path = "M " + pair(place(view, arc.point(arc.start)));
    for (int i = 1; i <= count; ++i)
      path += " A " + radii + " 0 " + (is_clockwise ? "1 " : "0 ")
        + pair(place(view, arc.point(arc.start + arc.sweep * i / count)));
    return path;
  }

  // by Bezier curves of a 24th of a turn, whose deviation is below 10^-8 of the radius
  std::string flat_path(const Svg_view& view, const Drawn_curve::Arc& arc) const
  {
    const int count = static_cast<int>(std::ceil(arc.sweep / (CGAL_PI / 12.)));
    const double step = arc.sweep / count, reach = 4. / 3. * std::tan(0.25 * step);
    std::string path = "d=\"M " + pair(place(view, arc.point(arc.start)));
    for (int i = 0; i < count; ++i)
    {
      const double begin = arc.start + i * step, end = begin + step;
      const Spline_vector next = arc.point(begin) + reach * arc.tangent(begin),
                          last = arc.point(end) - reach * arc.tangent(end);
      path += " C " + pair(place(view, next)) + " " + pair(place(view, last)) + " " + pair(place(view, arc.point(end)));
    }
    return path + "\"";
  }

  std::string seen_from_the_edge(const Svg_view& view, const Drawn_curve::Arc& arc, std::string& element) const
  {
    const Spline_vector normal = cross(arc.u, arc.v), along = cross(cross(view.right, view.up), normal);
    const double u = dot(arc.u, along), v = dot(arc.v, along), turn = 2. * CGAL_PI;
    std::vector<double> angles = {arc.start, arc.start + arc.sweep};
    for (const double peak : {std::atan2(v, u), std::atan2(v, u) + CGAL_PI})
      if (arc.is_full || peak - arc.start - turn * std::floor((peak - arc.start) / turn) <= arc.sweep)
        angles.push_back(peak);
    const auto is_before = [&](double one, double two) { return dot(arc.point(one) - arc.point(two), along) < 0.; };
    const auto ends = std::minmax_element(angles.begin(), angles.end(), is_before);
    return segment(view, {{arc.point(*ends.first), arc.point(*ends.second)}}, element);
  }

  std::string cubics(const Svg_view& view, const std::vector<Drawn_curve::Cubic>& cubics, std::string& element) const
  {
    element = "path";
    std::string path = "d=\"M " + pair(place(view, cubics.front()[0]));
    for (const Drawn_curve::Cubic& cubic : cubics)
      path +=
        " C " + pair(place(view, cubic[1])) + " " + pair(place(view, cubic[2])) + " " + pair(place(view, cubic[3]));
    return path + "\"";
  }

  // Radii are written where their circles are seen as circles, first.
  void write_dimensions(std::ostream& out, const Svg_view& view) const
  {
    static constexpr double half_diagonal = 0.70710678118654752;
    for (std::size_t j = 0; j < m_curves.size(); ++j)
    {
      const auto type = m_wireframe.curves[j].type;
      const bool is_arc = type == Wireframe_curve_type::ARC;
      if ((!is_arc && type != Wireframe_curve_type::CIRCLE) || view_of_dimension(m_curves[j].arc()) != &view)
        continue;
      const Drawn_curve::Arc& arc = m_curves[j].arc();
      const Svg_point c = place(view, arc.center);
      const Svg_point p = place(view,
                                is_arc ? arc.point(arc.start + 0.5 * arc.sweep)
                                       : arc.center + norm(arc.u) * half_diagonal * (view.right + view.up));
      out << "<g class=\"dimension\" stroke=\"black\" stroke-width=\"0.2\"><line x1=\"" << number(c.x) << "\" y1=\""
          << number(c.y) << "\" x2=\"" << number(p.x) << "\" y2=\"" << number(p.y)
          << "\"/><text stroke=\"none\" fill=\"black\" font-size=\"3\" x=\"" << number(p.x + 1.) << "\" y=\""
          << number(p.y - 1.) << "\">" << (is_arc ? "R " : "\xe2\x8c\x80 ")
          << short_text((is_arc ? 1. : 2.) * m_wireframe.curves[j].conic->major_radius) << "</text></g>\n";
    }
  }

  const Svg_view* view_of_dimension(const Drawn_curve::Arc& arc) const
  {
    static constexpr double most_tilt = 0.02; // in radians: about a degree
    const Spline_vector axis = unit_vector(cross(arc.u, arc.v));
    for (const std::size_t i : {std::size_t(2), std::size_t(0), std::size_t(3)})
      if (norm(cross(axis, cross(m_views[i].right, m_views[i].up))) <= most_tilt)
        return &m_views[i];
    return &m_views[1];
  }

  Svg_point direction(const Svg_view& view, const Spline_vector& v) const
  {
    return {m_scale * dot(v, view.right), -m_scale * dot(v, view.up)};
  }

  Svg_point place(const Svg_view& view, const Spline_vector& p) const
  {
    const Svg_point d = direction(view, p - m_middle);
    return {view.left + m_scale * 0.5 * view.width + d.x, view.top + m_scale * 0.5 * view.height + d.y};
  }

  // the kinds of curves that are there
  void write_legend(std::ostream& out) const
  {
    std::set<Wireframe_curve_type> types;
    for (const auto& curve : m_wireframe.curves)
      types.insert(curve.type);
    double left = margin;
    out << "<g id=\"legend\">\n";
    for (const Wireframe_curve_type type : types)
    {
      out << "<text x=\"" << number(left) << "\" y=\"" << number(m_legend_top + 4.) << "\" fill=\""
          << hexadecimal(colour_of(type)) << "\">" << to_string(type) << "</text>\n";
      left += 26.;
    }
    out << "</g>\n";
  }

  std::string size_text(std::size_t axis) const { return short_text(m_size[axis]); }

  // a length in the unit of the wireframe, with four digits
  static std::string short_text(double size)
  {
    if (!(size > 0.))
      return "0";
    const double digits = std::pow(10., 3. - std::floor(std::log10(size)));
    return std::isfinite(digits) && digits > 0. ? number_to_string(std::round(size * digits) / digits)
                                                : number_to_string(size);
  }

  // a millionth of a millimeter is enough, for an exact page as well
  static std::string number(double value) { return number_to_string(std::round(1e6 * value) / 1e6); }

  static std::string pair(const Svg_point& p) { return number(p.x) + " " + number(p.y); }

  const Plain_wireframe& m_wireframe;
  const Wireframe_extraction::Length_unit m_unit;
  const bool m_has_dimensions;
  std::array<Svg_view, 4> m_views;
  std::vector<Drawn_curve> m_curves; // relative to the origin
  Spline_vector m_origin, m_middle;
  std::array<double, 3> m_size = {{0., 0., 0.}};
  std::array<double, 2> m_row_tops, m_column_lefts;
  double m_ratio = 1.; // of lengths on the page to true ones
  double m_scale = 1.; // millimeters on the page for one unit of the wireframe
  double m_legend_top = 0., m_width = 0., m_height = 0.;
};

CGAL_WIREFRAME_EXTRACTION_INLINE
bool write_svg(std::ostream& out, const Plain_wireframe& wireframe, Wireframe_extraction::Length_unit unit,
               bool has_dimensions, std::string& error)
{
  error = wireframe_problem(wireframe, Plain_traits());
  if (!error.empty())
    return false;
  const Svg_drawing drawing(wireframe, unit, has_dimensions);
  if (!drawing.is_finite())
  {
    error = "the wireframe is too large or too small to be drawn; scale it";
    return false;
  }
  drawing.write(out);
  return true;
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_WRITE_SVG_IMPL_H
