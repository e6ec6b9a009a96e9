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

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Thresholds that the steps which join curves share. Lengths are in r, the sampling distance, angles in radians.
struct Joining_options
{
  double noise = 0.1;        // typical residual of the field near curves, in r
  double reach = 5.;         // ends farther apart are not compared: a little more than radius_of_fits
  double smooth_turn = 0.35; // joints of two curves that turn by less are no corners: 20 degrees, as in the evaluation
  double maximum_bridge = 18.; // gap between ends that face each other
  // Sum of squares of the deviations of two beliefs from what they have in common: beliefs of three coordinates that
  // are right exceed it in 0.7 % of all cases (chi squared, 3 degrees of freedom).
  double maximum_disagreement = 12.;
  // Joints of two curves that turn by less are rather rounded than sharp, and in doubt so: half of the right angle that
  // most corners have.
  double rounded_turn = 0.8;

  // Standard deviations of where a curve ends. Across: feet on local fits were measured to be off by 0.07 r in the
  // median on exact fields, 0.25 r on fields of regressors (noise 0.25), 0.4 r with moved points (0.45), which is 0.1,
  // 0.37 and 0.6 as a deviation. Along: the ball in which a corner disturbs the fits, and the step of a trace.
  double along() const { return 0.9 + 2. * noise; }
  double across() const { return 0.2 + 0.7 * noise; }
};

// What can be done to the ends of a network's curves, and how well two of them lead on to each other.
class Network_editor
{
public:
  typedef std::pair<std::size_t, int> Curve_end;
  typedef std::vector<std::vector<Curve_end>> Incidences; // the ends that meet in each node

  // After cancelling by `progress`, if there is one, not all is done, but the network is one.
  Network_editor(Curve_network& network, const Joining_options& options, Progress* progress = nullptr)
    : m_network(network), m_options(options), m_progress(progress)
  {}

protected:
  // Lengths in r.
  static constexpr double radius_of_fits = 4.; // of the balls that traces look at; there, curves disturb each other
  // A curve runs through a place on its inside, rather than ends there, from this distance to its ends on: half the
  // reach within which ends are compared to each other.
  static constexpr double least_distance_to_ends = 2.5;
  // Within it of a node, points of a curve are dropped: there the nearest points of the field belong to any of the
  // curves that meet (half of the skeleton's width of 1.5).
  static constexpr double disturbed_length = 0.75;
  static constexpr double length_of_tip = 2.; // which gives the direction of a polyline's end: four points of a trace

  // Where the field is wrong, the last part of a curve may have gone astray. What lies deeper may lead on better; steps
  // of 3 pass by what a ball of radius_of_fits saw of the disturbance.
  static constexpr std::size_t number_of_depths = 3;
  static constexpr double depths[number_of_depths] = {0., 3., 6.};
  // of a bridge, per r by which it starts behind an end: it only decides between those that are about equally good
  static constexpr double cost_of_depth = 0.05;
  static constexpr double most_costly_bridge = 1.; // costs are relative to their limits
  // what two ends of one curve must have between them, or they are both ends of what a single ball showed
  static constexpr double shortest_return = 2. * radius_of_fits;
  static constexpr double least_rest = 6.; // of a curve behind a depth, with so many points:
  static constexpr std::size_t least_points_of_rest = 3;
  static constexpr double length_of_piece = 1.5; // of two that tell by which turn a curve goes on: three points each
  // by how much of the turn between two pieces the direction at their middles differs from that at the end
  static constexpr double extrapolation = 0.5;
  static constexpr double less_extrapolation_per_noise = 10.; // none from 0.1 on: then pieces seem to turn by noise

  // How much the direction of a curve may differ from that of the arc that arrives there: the turn of two smooth pieces
  // (as smooth_turn), and what noise does to directions over few r and to a chord.
  static constexpr double mismatch_of_arcs = 0.35, mismatch_per_noise = 0.5, mismatch_of_chord = 1.5;
  static constexpr double shortest_chord = 1.; // beside gaps, so that ends that touch are not free to turn

  Curve_network& m_network;
  const Joining_options& m_options;
  Progress* const m_progress;

  bool goes_on() const { return internal::goes_on(m_progress); }

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
    return m_network.curves[hit.curve].has_inside(hit.point, least_distance_to_ends);
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
    while (nearest > first && nearest > 1 && (curve.points[nearest] - target).norm() < disturbed_length)
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
    Vector inner = e == 0 ? p.back() : p.front();
    for (std::size_t k = 1; k < p.size(); ++k)
    {
      const Vector& q = e == 0 ? p[k] : p[p.size() - 1 - k];
      if ((q - end).norm() > length_of_tip)
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
    Incidences incidences = m_network.incidences();
    for (std::size_t node = 0; node < incidences.size() && goes_on(); ++node)
      if (incidences[node].size() == 2)
      {
        const Curve_end a = incidences[node][0], b = incidences[node][1];
        if (tip(a).tangent.dot(tip(b).tangent) <= -std::cos(m_options.smooth_turn))
          join_ends(a, b, incidences);
      }
  }

  // Joins two ends that meet in a node where no other curve ends. Curves that are joined change their names and
  // directions, so what was known of ends before is out of date after it; the incidences are kept up to date.
  void join_ends(const Curve_end& a, const Curve_end& b, Incidences& incidences)
  {
    incidences[node_of(a)].clear();
    if (a.first == b.first)
    {
      m_network.curves[a.first].nodes = {no_node, no_node};
      return;
    }
    const Curve_end kept(a.first, 1 - a.second), taken(b.first, 1 - b.second);
    rename(incidences[node_of(kept)], kept, {a.first, 0});
    rename(incidences[node_of(taken)], taken, {a.first, 1});
    concatenate(a, b);
  }

  static void rename(std::vector<Curve_end>& ends, const Curve_end& end, const Curve_end& name)
  {
    std::replace(ends.begin(), ends.end(), end, name);
  }

  std::size_t node_of(const Curve_end& end) const { return m_network.curves[end.first].nodes[end.second]; }

  // appends the curve of `b` to that of `a`, which is turned such that its other end comes first
  void concatenate(const Curve_end& a, const Curve_end& b)
  {
    Network_curve& first = m_network.curves[a.first];
    Network_curve& second = m_network.curves[b.first];
    Network_curve joined;
    joined.points.swap(first.points);
    if (a.second == 0)
      std::reverse(joined.points.begin(), joined.points.end());
    if (b.second == 1)
      std::reverse(second.points.begin(), second.points.end());
    // the common node was an estimate of where they meet, no point of the curve
    joined.points.pop_back();
    joined.points.insert(joined.points.end(), second.points.begin() + 1, second.points.end());
    const int kept = 1 - a.second, taken = 1 - b.second;
    joined.nodes = {first.nodes[kept], second.nodes[taken]};
    joined.tips = {first.tips[kept], second.tips[taken]};
    joined.ends_in_void = {first.ends_in_void[kept], second.ends_in_void[taken]};
    first = joined;
    second.is_alive = false;
  }

  // Joins those pairs of ends that may be joined, may_join(i, j), the cheapest ones first, if they cost less than
  // most_costly_bridge: cost_of(arc) of the arc that bridges the gap.
  template <class May_join, class Cost>
  void bridge(const std::vector<Curve_end>& ends, const May_join& may_join, const Cost& cost_of)
  {
    std::vector<Vector> positions;
    std::vector<std::array<std::optional<Local_curve>, number_of_depths>> tips(ends.size());
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      positions.push_back(tip(ends[i]).point);
      for (std::size_t k = 0; k < number_of_depths; ++k)
        tips[i][k] = inner_tip(ends[i], depths[k]);
    }
    const Ball_search search(positions);
    struct Bridge
    {
      double cost;
      std::size_t from, to;
      double depths[2];
    };
    std::vector<Bridge> bridges;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < ends.size() && goes_on(); ++i)
    {
      search.query(positions[i], m_options.maximum_bridge, found);
      for (std::size_t j : found)
      {
        if (i >= j || !may_join(i, j))
          continue;
        Bridge best{most_costly_bridge, i, j, {0., 0.}};
        for (std::size_t k = 0; k < number_of_depths; ++k)
          for (std::size_t l = 0; l < number_of_depths; ++l)
          {
            if (!tips[i][k] || !tips[j][l])
              continue;
            const double cost = cost_of(bridging_arc(ends[i], *tips[i][k], ends[j], *tips[j][l]))
              + cost_of_depth * (depths[k] + depths[l]);
            if (cost < best.cost)
              best = {cost, i, j, {depths[k], depths[l]}};
          }
        if (best.cost < most_costly_bridge)
          bridges.push_back(best);
      }
    }
    std::sort(bridges.begin(), bridges.end(), [](const Bridge& a, const Bridge& b) {
      return std::tie(a.cost, a.from, a.to) < std::tie(b.cost, b.from, b.to);
    });
    std::vector<char> is_taken(ends.size(), 0);
    for (const Bridge& bridge : bridges)
    {
      if (!goes_on())
        return;
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

  // A polyline as one sees it from one of its ends.
  class Inward_view
  {
    const std::vector<Vector>& m_points;
    const bool m_is_from_front;

  public:
    Inward_view(const std::vector<Vector>& points, int end) : m_points(points), m_is_from_front(end == 0) {}

    std::size_t size() const { return m_points.size(); }
    const Vector& operator[](std::size_t k) const { return m_points[m_is_from_front ? k : m_points.size() - 1 - k]; }

    // the first point behind the given one that is at least `reach` away from it, or size()
    std::size_t beyond(std::size_t from, double reach) const
    {
      std::size_t k = from;
      while (k < size() && ((*this)[k] - (*this)[from]).norm() < reach)
        ++k;
      return k;
    }

    // the outward direction at a point
    Vector direction(std::size_t k) const
    {
      const Vector last = ((*this)[k] - (*this)[k + 1]).normalized();
      if (k + 2 >= size())
        return last;
      return ((1. + extrapolation) * last - extrapolation * ((*this)[k + 1] - (*this)[k + 2]).normalized())
        .normalized();
    }
  };

  // The outward course at some depth behind the end, where enough of the curve is left behind that; the tip itself at
  // depth 0.
  std::optional<Local_curve> inner_tip(const Curve_end& end, double depth) const
  {
    if (depth == 0.)
      return tip(end);
    const Inward_view points(m_network.curves[end.first].points, end.second);
    if (points.beyond(0, depth + least_rest) + least_points_of_rest > points.size())
      return {};
    Local_curve result;
    const std::size_t start = points.beyond(0, depth);
    result.point = points[start];
    // directions of the last piece and the one before it, extrapolated to the end as far as noise allows
    const double share = extrapolation * (std::max)(0., 1. - less_extrapolation_per_noise * m_options.noise);
    const std::size_t inner = points.beyond(start, length_of_piece);
    const std::size_t innermost = inner < points.size() ? points.beyond(inner, length_of_piece) : inner;
    if (innermost == points.size())
      result.tangent = points.direction(start);
    else
      result.tangent = ((1. + share) * (points[start] - points[inner]).normalized()
                        - share * (points[inner] - points[innermost]).normalized())
                         .normalized();
    return result;
  }

  void shorten(const Curve_end& end, double depth)
  {
    // an earlier bridge may have shortened the other end of the same curve
    const std::optional<Local_curve> shorter_tip = inner_tip(end, depth);
    if (depth == 0. || !shorter_tip)
      return;
    Network_curve& curve = m_network.curves[end.first];
    std::vector<Vector> rest = cut_back(curve.points, end.second, depth);
    if (end.second == 0)
      std::reverse(rest.begin(), rest.end());
    curve.points = rest;
    curve.tips[end.second] = *shorter_tip;
  }

  // the polyline without what lies within `reach` of its end, which comes last
  static std::vector<Vector> cut_back(const std::vector<Vector>& points, int end, double reach)
  {
    const Inward_view view(points, end);
    const std::size_t last = view.beyond(0, reach);
    std::vector<Vector> rest;
    for (std::size_t k = view.size(); k > last; --k)
      rest.push_back(view[k - 1]);
    return rest;
  }

  // An arc of a circle that starts at the inner tip of one end and passes through that of another one.
  struct Bridging_arc
  {
    double gap = (std::numeric_limits<double>::infinity)();
    double turn = (std::numeric_limits<double>::infinity)();
    double mismatch = (std::numeric_limits<double>::infinity)(); // of its direction there, at most 1 where it is smooth
  };

  // from the course `ta` at or behind one end to `tb` at or behind another
  Bridging_arc bridging_arc(const Curve_end& a, const Local_curve& ta, const Curve_end& b, const Local_curve& tb) const
  {
    Bridging_arc arc;
    const Vector offset = tb.point - ta.point;
    const double gap = offset.norm();
    if (a.first == b.first && polyline_length(m_network.curves[a.first].points) < shortest_return + gap)
      return arc;
    arc.gap = gap;
    if (!(gap > 0.))
    {
      arc.turn = arc.mismatch = 0.;
      return arc;
    }
    const Vector chord = offset / gap;
    const Vector arrival = 2. * chord.dot(ta.tangent) * chord - ta.tangent;
    const double limit = mismatch_of_arcs + mismatch_per_noise * m_options.noise
      + mismatch_of_chord * m_options.across() / (gap + shortest_chord);
    arc.turn = 2. * std::acos((std::min)(1., (std::max)(-1., chord.dot(ta.tangent))));
    arc.mismatch = (arrival + tb.tangent).norm() / limit;
    return arc;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_NETWORK_EDITOR_H
