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
#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_NETWORK_EDITOR_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_NETWORK_EDITOR_H

#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

struct Joining_options
{
  double noise = 0.1;
  double reach = 5.; // ends farther apart are not compared
  double maximum_disagreement = 12.;
  double rounded_turn = 0.8; // joints of two curves that turn by less are rather rounded than sharp
  double smooth_turn = 0.35; // joints of two curves that turn by less are no corners

  double maximum_bridge = 18.; // gap between ends that face each other

  double along() const { return 0.9 + 2. * noise; }
  double across() const { return 0.2 + 0.7 * noise; }
};

// What can be done to the ends of a network's curves, and how well two of them lead on to each other.
class Network_editor
{
public:
  typedef std::pair<std::size_t, int> Curve_end;

  Network_editor(Curve_network& network, const Joining_options& options) : m_network(network), m_options(options) {}

protected:
  Curve_network& m_network;
  const Joining_options& m_options;

  const Local_curve& tip(const Curve_end& end) const { return m_network.curves[end.first].tips[end.second]; }

  std::vector<Curve_end> free_ends() const
  {
    std::vector<Curve_end> result;
    for (const std::vector<Curve_end>& ends : m_network.incidences())
      if (ends.size() == 1)
        result.push_back(ends[0]);
    return result;
  }

  bool is_inside(const Segment_grid::Hit& hit) const
  {
    const std::vector<Vector>& points = m_network.curves[hit.curve].points;
    if (m_network.curves[hit.curve].is_closed_without_node())
      return true;
    return (hit.point - points.front()).norm() > 2.5 && (hit.point - points.back()).norm() > 2.5;
  }

  // lets the curve end in the node: what went beyond it is cut off
  void attach(const Curve_end& end, std::size_t node)
  {
    Network_curve& curve = m_network.curves[end.first];
    const Vector& target = m_network.nodes[node];
    if (end.second == 0)
      std::reverse(curve.points.begin(), curve.points.end());
    std::size_t nearest = 0;
    const std::size_t first = curve.points.size() / 2;
    double best = (std::numeric_limits<double>::infinity)();
    for (std::size_t i = first; i < curve.points.size(); ++i)
    {
      const double d = (curve.points[i] - target).squaredNorm();
      if (d < best)
      {
        best = d;
        nearest = i;
      }
    }
    // the last points before the node lie where several curves disturb each other
    while (nearest > first && nearest > 1 && (curve.points[nearest] - target).norm() < 0.75)
      --nearest;
    curve.points.resize(nearest + 1);
    curve.points.push_back(target);
    if (end.second == 0)
      std::reverse(curve.points.begin(), curve.points.end());
    curve.nodes[end.second] = node;
  }

  static void set_tip(Network_curve& curve, int e)
  {
    const std::vector<Vector>& p = curve.points;
    const Vector& end = e == 0 ? p.front() : p.back();
    // the direction over about two sampling distances
    Vector inner = e == 0 ? p.back() : p.front();
    for (std::size_t k = 1; k < p.size(); ++k)
    {
      const Vector& q = e == 0 ? p[k] : p[p.size() - 1 - k];
      if ((q - end).norm() > 2.)
      {
        inner = q;
        break;
      }
    }
    curve.tips[e].point = end;
    curve.tips[e].tangent = (end - inner).norm() > 0. ? (end - inner).normalized() : Vector(Vector::UnitX());
    curve.tips[e].bend.setZero();
    curve.ends_in_void[e] = false;
  }

  static void set_tips(Network_curve& curve)
  {
    set_tip(curve, 0);
    set_tip(curve, 1);
  }

  // two curves that meet in a node where nothing else ends and that hardly turn there are one curve
  void dissolve_smooth_joints()
  {
    for (bool changed = true; changed;)
    {
      changed = false;
      const auto incidences = m_network.incidences();
      std::vector<char> is_touched(m_network.curves.size(), 0); // its incidences are out of date
      for (const std::vector<Curve_end>& ends : incidences)
      {
        if (ends.size() != 2 || is_touched[ends[0].first] || is_touched[ends[1].first]
            || tip(ends[0]).tangent.dot(tip(ends[1]).tangent) > -std::cos(m_options.smooth_turn))
          continue;
        join_ends(ends[0], ends[1]);
        is_touched[ends[0].first] = is_touched[ends[1].first] = 1;
        changed = true;
      }
    }
  }

  void join_ends(const Curve_end& a, const Curve_end& b)
  {
    if (a.first == b.first)
      close(m_network.curves[a.first]);
    else
      concatenate(a, b);
  }

  static void close(Network_curve& curve) { curve.nodes = {no_node, no_node}; }

  // appends the curve of `b` to that of `a`; the latter's other end keeps its place
  void concatenate(const Curve_end& a, const Curve_end& b)
  {
    Network_curve& first = m_network.curves[a.first];
    Network_curve& second = m_network.curves[b.first];
    std::vector<Vector> head = first.points, tail = second.points;
    if (a.second == 0)
      std::reverse(head.begin(), head.end());
    if (b.second == 1)
      std::reverse(tail.begin(), tail.end());
    // the common node was an estimate of where they meet, no point of the curve
    head.pop_back();
    head.insert(head.end(), tail.begin() + 1, tail.end());
    const int kept = 1 - a.second, taken = 1 - b.second;
    Network_curve joined;
    joined.points = head;
    joined.nodes = {first.nodes[kept], second.nodes[taken]};
    joined.tips = {first.tips[kept], second.tips[taken]};
    joined.ends_in_void = {first.ends_in_void[kept], second.ends_in_void[taken]};
    first = joined;
    second.is_alive = false;
  }

  // Joins those pairs of ends that may be joined, may_join(i, j), the cheapest ones first, if they cost less than 1:
  // cost_of(arc) of the arc that bridges the gap.
  template <class May_join, class Cost>
  void bridge(const std::vector<Curve_end>& ends, const May_join& may_join, const Cost& cost_of)
  {
    std::vector<Vector> positions;
    for (const Curve_end& end : ends)
      positions.push_back(tip(end).point);
    const Ball_search search(positions);
    struct Bridge
    {
      double cost;
      std::size_t from, to;
      double depths[2];
    };
    std::vector<Bridge> bridges;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      search.query(positions[i], m_options.maximum_bridge, found);
      for (std::size_t j : found)
      {
        if (i >= j || !may_join(i, j))
          continue;
        // where the field is wrong, the last part of a curve may have gone astray: what lies deeper may lead on better
        Bridge best{1., i, j, {0., 0.}};
        for (double depth_i : depths)
          for (double depth_j : depths)
          {
            const double cost = cost_of(bridging_arc(ends[i], depth_i, ends[j], depth_j)) + 0.05 * (depth_i + depth_j);
            if (cost < best.cost)
              best = {cost, i, j, {depth_i, depth_j}};
          }
        if (best.cost < 1.)
          bridges.push_back(best);
      }
    }
    std::sort(bridges.begin(), bridges.end(), [](const Bridge& a, const Bridge& b) {
      return std::tie(a.cost, a.from, a.to) < std::tie(b.cost, b.from, b.to);
    });
    std::vector<char> is_taken(ends.size(), 0);
    for (const Bridge& bridge : bridges)
    {
      if (is_taken[bridge.from] || is_taken[bridge.to])
        continue;
      is_taken[bridge.from] = is_taken[bridge.to] = 1;
      shorten(ends[bridge.from], bridge.depths[0]);
      shorten(ends[bridge.to], bridge.depths[1]);
      const std::size_t node = m_network.nodes.size();
      m_network.nodes.push_back(0.5 * (tip(ends[bridge.from]).point + tip(ends[bridge.to]).point));
      attach(ends[bridge.from], node);
      attach(ends[bridge.to], node);
    }
  }

  static constexpr double depths[] = {0., 3., 6.};

  // the outward course at some depth behind the end; the tip itself at depth 0
  Local_curve inner_tip(const Curve_end& end, double depth) const
  {
    if (depth == 0.)
      return tip(end);
    const std::vector<Vector> rest = cut_back(m_network.curves[end.first].points, end.second, depth);
    Local_curve result;
    result.point = rest.back();
    // directions of the last piece and the one before it, extrapolated to the end as far as noise allows
    const double extrapolation = 0.5 * (std::max)(0., 1. - 10. * m_options.noise);
    const std::vector<Vector> inner = cut_back(rest, 1, 1.5);
    const std::vector<Vector> innermost = inner.empty() ? inner : cut_back(inner, 1, 1.5);
    if (innermost.empty())
      result.tangent = end_direction(rest);
    else
      result.tangent = ((1. + extrapolation) * (rest.back() - inner.back()).normalized()
                        - extrapolation * (inner.back() - innermost.back()).normalized())
                         .normalized();
    return result;
  }

  // whether enough of the curve is left behind that depth
  bool has_depth(const Curve_end& end, double depth) const
  {
    return depth == 0. || cut_back(m_network.curves[end.first].points, end.second, depth + 6.).size() >= 3;
  }

  void shorten(const Curve_end& end, double depth)
  {
    // an earlier bridge may have shortened the other end of the same curve
    if (depth == 0. || !has_depth(end, depth))
      return;
    const Local_curve shorter_tip = inner_tip(end, depth);
    Network_curve& curve = m_network.curves[end.first];
    std::vector<Vector> rest = cut_back(curve.points, end.second, depth);
    if (end.second == 0)
      std::reverse(rest.begin(), rest.end());
    curve.points = rest;
    curve.tips[end.second] = shorter_tip;
  }

  // the polyline without what lies within `reach` of its end, which comes last
  static std::vector<Vector> cut_back(std::vector<Vector> points, int end, double reach)
  {
    if (end == 0)
      std::reverse(points.begin(), points.end());
    const Vector last = points.back();
    while (!points.empty() && (points.back() - last).norm() < reach)
      points.pop_back();
    return points;
  }

  static Vector end_direction(const std::vector<Vector>& points)
  {
    const std::size_t n = points.size();
    const Vector last = (points[n - 1] - points[n - 2]).normalized();
    return n < 3 ? last : Vector((1.5 * last - 0.5 * (points[n - 2] - points[n - 3]).normalized()).normalized());
  }

  // An arc of a circle that starts at the inner tip of one end and passes through that of another one.
  struct Bridging_arc
  {
    double gap = (std::numeric_limits<double>::infinity)();
    double turn = (std::numeric_limits<double>::infinity)();
    double mismatch = (std::numeric_limits<double>::infinity)(); // of its direction there, below 1 where it is smooth
  };

  Bridging_arc bridging_arc(const Curve_end& a, double depth_a, const Curve_end& b, double depth_b) const
  {
    Bridging_arc arc;
    if (!has_depth(a, depth_a) || !has_depth(b, depth_b))
      return arc;
    const Local_curve ta = inner_tip(a, depth_a), tb = inner_tip(b, depth_b);
    const Vector offset = tb.point - ta.point;
    const double gap = offset.norm();
    if (a.first == b.first && polyline_length(m_network.curves[a.first].points) < 8. + gap)
      return arc;
    arc.gap = gap;
    if (!(gap > 0.))
    {
      arc.turn = arc.mismatch = 0.;
      return arc;
    }
    const Vector chord = offset / gap;
    const Vector arrival = 2. * chord.dot(ta.tangent) * chord - ta.tangent;
    const double limit = 0.35 + 0.5 * m_options.noise + 1.5 * m_options.across() / (gap + 1.);
    arc.turn = 2. * std::acos((std::min)(1., (std::max)(-1., chord.dot(ta.tangent))));
    arc.mismatch = (arrival + tb.tangent).norm() / limit;
    return arc;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_NETWORK_EDITOR_H
