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

#ifndef WIREFRAME_EVALUATION_CHAIN_CURVES_H
#define WIREFRAME_EVALUATION_CHAIN_CURVES_H

#include <Wireframe_evaluation/Evaluated_curve.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace Wireframe_evaluation {

/// Curves joined where they go on smoothly, and the vertices that remain.
struct Chained_curves
{
  std::vector<Evaluated_curve> curves;
  std::set<std::size_t> vertices;
};

namespace internal {

class Curve_chainer
{
public:
  typedef std::function<bool(const Evaluated_curve&, const Evaluated_curve&)> Predicate;

  Curve_chainer(const std::vector<Evaluated_curve>& curves, double radius, double angle, Predicate may_join)
    : m_curves(curves), m_radius(radius), m_cosine(-std::cos(angle * CGAL_PI / 180.)), m_may_join(std::move(may_join)),
      m_is_used(curves.size(), false)
  {
    for (std::size_t i = 0; i < curves.size(); ++i)
      if (has_ends(curves[i]))
      {
        m_ends[curves[i].source].push_back(End{i, false});
        m_ends[curves[i].target].push_back(End{i, true});
      }
  }

  Chained_curves run()
  {
    for (const auto& vertex : m_ends)
      if (!passes(vertex.second))
        m_result.vertices.insert(vertex.first);
    for (std::size_t vertex : m_result.vertices)
      for (const End& end : m_ends[vertex])
        if (!m_is_used[end.curve])
          walk(end);
    // what is left are cycles without a remaining vertex, and curves without ends
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      if (!m_is_used[i])
      {
        if (has_ends(m_curves[i]))
          walk(End{i, false});
        else
          m_result.curves.push_back(m_curves[i]);
      }
    return std::move(m_result);
  }

private:
  struct End
  {
    std::size_t curve;
    bool is_target;
  };

  static bool has_ends(const Evaluated_curve& curve) { return curve.has_vertices() && !curve.is_closed; }

  bool passes(const std::vector<End>& ends) const
  {
    if (ends.size() != 2)
      return false;
    const Evaluated_curve& a = m_curves[ends[0].curve];
    const Evaluated_curve& b = m_curves[ends[1].curve];
    const double cosine = a.polyline.direction_from_end(ends[0].is_target, m_radius)
      * b.polyline.direction_from_end(ends[1].is_target, m_radius);
    return cosine <= m_cosine && (!m_may_join || ends[0].curve == ends[1].curve || m_may_join(a, b));
  }

  // follows the curves from an end until a vertex remains or the start is reached again
  void walk(End from)
  {
    Evaluated_curve chain = m_curves[from.curve];
    chain.source = vertex_of(from);
    chain.is_closed = false;
    std::vector<Point> points;
    while (true)
    {
      m_is_used[from.curve] = true;
      append(from, points);
      const End to = {from.curve, !from.is_target};
      chain.target = vertex_of(to);
      if (m_result.vertices.count(chain.target) > 0)
        break;
      from = other_end(to);
      if (m_is_used[from.curve])
      {
        chain.is_closed = true;
        points.push_back(points.front());
        break;
      }
    }
    chain.polyline = Polyline(points);
    m_result.curves.push_back(std::move(chain));
  }

  std::size_t vertex_of(const End& end) const
  {
    return end.is_target ? m_curves[end.curve].target : m_curves[end.curve].source;
  }

  // the other one of the two ends that meet here
  End other_end(const End& end) const
  {
    const std::vector<End>& ends = m_ends.at(vertex_of(end));
    return ends[0].curve == end.curve && ends[0].is_target == end.is_target ? ends[1] : ends[0];
  }

  void append(const End& from, std::vector<Point>& points) const
  {
    const std::vector<Point>& added = m_curves[from.curve].polyline.points();
    if (from.is_target)
      points.insert(points.end(), added.rbegin(), added.rend());
    else
      points.insert(points.end(), added.begin(), added.end());
  }

  const std::vector<Evaluated_curve>& m_curves;
  const double m_radius, m_cosine;
  const Predicate m_may_join;
  std::vector<bool> m_is_used;
  std::map<std::size_t, std::vector<End>> m_ends; // per vertex
  Chained_curves m_result;
};

} // namespace internal

/*!
joins curves at all vertices where exactly two ends meet, and turn by `angle` degrees at most. A curve that is marked
as closed promises to pass smoothly where it starts, so it has no ends, and its vertex is none of those that remain
unless other curves end there.

\param curves the curves
\param radius how far from the vertex the directions are taken
\param angle the angle, in degrees
\param may_join says whether two curves may be joined at all; all may if it is empty. It is not asked about a
       curve and itself
*/
inline Chained_curves chain_curves(const std::vector<Evaluated_curve>& curves, double radius, double angle,
                                   internal::Curve_chainer::Predicate may_join = nullptr)
{
  return internal::Curve_chainer(curves, radius, angle, std::move(may_join)).run();
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_CHAIN_CURVES_H
