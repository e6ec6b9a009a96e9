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
#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TANGENCY_RESOLVER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TANGENCY_RESOLVER_H

#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/network/Network_editor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Curves that touch each other, such as a circle and the side of a square around it, cannot be told apart near the
// point of contact. They lead through it all the same, and there is no vertex.
class Tangency_resolver : private Network_editor
{
  // In radians: by how much two curves that touch may seem to turn where one goes over into the other (29 degrees: a
  // circle of radius 12 r turns so much over the 6 r by which its direction is measured behind the contact), and how
  // much a curve may turn where it touches another one (143 degrees, or it comes back).
  static constexpr double tangential_turn = 0.5, largest_turn = 2.5;
  // What is left of two curves where they cannot be told apart, in r: curves at 6 degrees are closer than the width of
  // a trace's corridor for 6 r. It ends nowhere else if it is their last part, and then may turn the more, by 63
  // degrees: as far as a trace goes astray where it sees both.
  static constexpr double longest_stem = 6., most_turn_to_free_stem = 1.1;
  // From an end to the curve it touches, in r: a trace follows its curve until the fits see both.
  static constexpr double reach_of_contact = 0.8, reach_of_contact_per_noise = 2.;
  // Behind the ends, the farthest first: close to them the two curves disturb each other. In r.
  static constexpr double depths_of_partners[] = {9., 6., 3.};
  static constexpr double largest_mismatch = 1.; // of partners, in units of what is smooth

public:
  using Network_editor::Network_editor;

  // A curve that touches another one was followed up to where the two are too close to be told apart, from both sides.
  void bridge_tangencies()
  {
    const Segment_grid grid = m_network.segments();
    const double reach = reach_of_contact + reach_of_contact_per_noise * m_options.noise;
    std::vector<Candidate> candidates;
    std::vector<Curve_end> ends;
    for (const std::vector<Curve_end>& around : m_network.incidences())
      if (!goes_on())
        return;
      else if (around.size() == 1)
      {
        const Local_curve& end = tip(around[0]);
        const Segment_grid::Hit hit = grid.nearest(end.point, reach, [&](const Segment_grid::Hit& h) {
          return h.curve != around[0].first && std::abs(h.direction.dot(end.tangent)) > std::cos(tangential_turn);
        });
        const bool is_touching = hit.is_valid() && is_inside(hit);
        candidates.push_back({is_touching, is_touching ? hit.curve : Segment_grid::no_curve});
        ends.push_back(around[0]);
      }
      else if (around.size() == 3)
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::vector<Curve_end> rest{around[(k + 1) % 3], around[(k + 2) % 3]};
          if (lead_on(rest, around[k]))
            for (const Curve_end& end : rest)
            {
              candidates.push_back({true, Segment_grid::no_curve});
              ends.push_back(end);
            }
        }
    bridge(
      ends,
      [&](std::size_t i, std::size_t j) {
        const Candidate &a = candidates[i], &b = candidates[j];
        return (a.is_touching || b.is_touching)
          && (a.touched == b.touched || a.touched == Segment_grid::no_curve || b.touched == Segment_grid::no_curve)
          && node_of(ends[i]) != node_of(ends[j]);
      },
      [](const Bridging_arc& arc) { return arc.turn < largest_turn ? arc.mismatch : most_costly_bridge; });
    dissolve_smooth_joints();
  }

  // Two curves that touch each other were taken for one where they are close: between two nodes in which two curves
  // each lead on smoothly, or in a single node where four curves meet on one tangent.
  void separate_tangent_curves()
  {
    for (bool changed = true; changed && goes_on();)
    {
      changed = false;
      const auto incidences = m_network.incidences();
      for (std::size_t c = 0; c < m_network.curves.size() && !changed; ++c)
      {
        const Network_curve& curve = m_network.curves[c];
        if (!curve.is_alive || curve.is_closed_without_node() || curve.nodes[0] == curve.nodes[1]
            || incidences[curve.nodes[0]].size() != 3 || incidences[curve.nodes[1]].size() != 3
            || polyline_length(curve.points) > m_options.maximum_bridge)
          continue;
        const std::vector<Curve_end> a = others(incidences[curve.nodes[0]], {c, 0}),
                                     b = others(incidences[curve.nodes[1]], {c, 1});
        if (a.size() == 2 && b.size() == 2 && lead_on(a, {c, 0}) && lead_on(b, {c, 1}))
          changed = separate(a, b, curve.points);
      }
      for (std::size_t node = 0; node < incidences.size() && !changed; ++node)
      {
        const std::vector<Curve_end>& ends = incidences[node];
        if (ends.size() != 4)
          continue;
        std::vector<Curve_end> sides[2];
        for (const Curve_end& end : ends)
          sides[direction(end).dot(direction(ends[0])) < 0.].push_back(end);
        if (sides[0].size() == 2 && lead_on(sides[1], sides[0][0]) && lead_on(sides[1], sides[0][1]))
          changed = separate(sides[0], sides[1], {m_network.nodes[node]});
      }
    }
  }

  // Two curves that meet at an acute angle are too close to be told apart before they do. What is found from there on
  // is one short curve that both lead to: it is taken for the last part of each.
  void close_acute_corners()
  {
    Incidences incidences = m_network.incidences();
    for (std::size_t c = 0; c < m_network.curves.size() && goes_on(); ++c)
    {
      const Network_curve& stem = m_network.curves[c];
      if (!stem.is_alive || stem.is_closed_without_node() || stem.nodes[0] == stem.nodes[1]
          || polyline_length(stem.points) > longest_stem)
        continue;
      for (int e = 0; e < 2; ++e)
      {
        const std::vector<Curve_end> branches = others(incidences[stem.nodes[e]], {c, e});
        const bool is_free = incidences[stem.nodes[1 - e]].size() == 1;
        if (!are_branches(branches, {c, e}, is_free ? most_turn_to_free_stem : tangential_turn))
          continue;
        for (const Curve_end& branch : branches)
          lead_along({c, e}, branch);
        m_network.curves[c].is_alive = false;
        incidences = m_network.incidences();
        break;
      }
    }
  }

private:
  struct Candidate
  {
    bool is_touching;
    std::size_t touched; // the curve, if it is known
  };

  static std::vector<Curve_end> others(const std::vector<Curve_end>& ends, const Curve_end& one)
  {
    std::vector<Curve_end> result;
    for (const Curve_end& end : ends)
      if (end.first != one.first)
        result.push_back(end);
    return result;
  }

  // whether two curves, and nothing else, lead to the stem that starts at that end, both from behind it
  bool are_branches(const std::vector<Curve_end>& ends, const Curve_end& start, double most_turn) const
  {
    if (ends.size() != 2 || ends[0].first == ends[1].first)
      return false;
    const Network_curve& stem = m_network.curves[start.first];
    const Vector onward = (start.second == 0 ? 1. : -1.) * (stem.points.back() - stem.points.front()).normalized();
    return std::all_of(ends.begin(), ends.end(), [&](const Curve_end& end) {
      return node_of({end.first, 1 - end.second}) != stem.nodes[1 - start.second]
        && direction(end).dot(onward) > std::cos(most_turn);
    });
  }

  // appends a polyline that starts where the curve has that end, but for its first point
  void go_on_along(const Curve_end& end, const std::vector<Vector>& polyline)
  {
    std::vector<Vector>& points = m_network.curves[end.first].points;
    if (end.second == 0)
      std::reverse(points.begin(), points.end());
    points.insert(points.end(), polyline.begin() + 1, polyline.end());
    if (end.second == 0)
      std::reverse(points.begin(), points.end());
  }

  // lets the curve of `end` go on along that of `start`, from there to its other end
  void lead_along(const Curve_end& start, const Curve_end& end)
  {
    std::vector<Vector> stem = m_network.curves[start.first].points;
    if (start.second == 1)
      std::reverse(stem.begin(), stem.end());
    go_on_along(end, stem);
    Network_curve& curve = m_network.curves[end.first];
    curve.nodes[end.second] = node_of({start.first, 1 - start.second});
    set_tip(curve, end.second);
  }

  // the course behind the last part, where other curves disturb it
  Vector direction(const Curve_end& end) const { return inner_tip(end, depths[1]).value_or(tip(end)).tangent; }

  bool lead_on(const std::vector<Curve_end>& ends, const Curve_end& from) const
  {
    const Vector onward = direction(from);
    return std::all_of(ends.begin(), ends.end(),
                       [&](const Curve_end& end) { return direction(end).dot(onward) < -std::cos(tangential_turn); });
  }

  // Joins each end on one side to the one on the other side that it leads to, if it is clear which one that is.
  bool separate(const std::vector<Curve_end>& a, const std::vector<Curve_end>& b, const std::vector<Vector>& between)
  {
    double sums[2], largest[2];
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double first = mismatch(a[0], b[k]), second = mismatch(a[1], b[1 - k]);
      sums[k] = first + second;
      largest[k] = (std::max)(first, second);
    }
    const std::size_t partner = sums[0] < sums[1] ? 0 : 1;
    if (!(largest[partner] < largest_mismatch))
      return false;
    const std::array<std::size_t, 2> nodes = {node_of(a[0]), node_of(b[0])};
    lead(a[0], b[partner], between);
    Incidences incidences = m_network.incidences();
    join_ends(a[0], b[partner], incidences);
    // what is left in the nodes leads on as well
    for (std::size_t rest : nodes)
      if (incidences[rest].size() == 2)
      {
        const Curve_end first = incidences[rest][0], second = incidences[rest][1];
        join_ends(first, second, incidences);
      }
    return true;
  }

  // of an arc from one end to the other, as far behind the ends as possible: close to them the two curves disturb each
  // other
  double mismatch(const Curve_end& a, const Curve_end& b) const
  {
    for (double depth : depths_of_partners)
    {
      const std::optional<Local_curve> ta = inner_tip(a, depth), tb = inner_tip(b, depth);
      if (!ta || !tb)
        continue;
      const Bridging_arc arc = bridging_arc(a, *ta, b, *tb);
      if (arc.turn < largest_turn)
        return arc.mismatch;
    }
    return (std::numeric_limits<double>::infinity)();
  }

  // appends the polyline to the curve of `a`, and gives its end and that of the curve of `b` a node of their own
  void lead(const Curve_end& a, const Curve_end& b, const std::vector<Vector>& between)
  {
    const std::size_t node = m_network.nodes.size();
    m_network.nodes.push_back(between.back());
    go_on_along(a, between);
    m_network.curves[a.first].nodes[a.second] = node;
    m_network.curves[b.first].nodes[b.second] = node;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_TANGENCY_RESOLVER_H
