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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_END_JOINER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_END_JOINER_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/network/Corner_merger.h>
#include <CGAL/Wireframe_extraction/internal/network/Joint_editor.h>
#include <CGAL/Wireframe_extraction/internal/network/Network_editor.h>
#include <CGAL/Wireframe_extraction/internal/network/Tangency_resolver.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Joins the ends of traced curves in a network.
class Curve_end_joiner : private Joint_editor
{
  // Lengths in r, angles in radians.
  // Where a corner turns much, the loss of a smooth course is at most this share of its loss, if it is not less by the
  // margin: in a precise field, what one model misses twice as badly is an error of the model, not of the field.
  static constexpr double most_of_loss = 0.5;

  // Free ends lead to nodes ahead that are farther than those that beliefs compare, and to such that a trace has run
  // past by no more than along(); if these lie within two standard deviations aside, and within the error of a
  // direction, 0.1 (6 degrees), farther away.
  static constexpr double reach_ahead = 1.6; // in units of the reach of beliefs
  static constexpr double farthest_behind = 1.;
  static constexpr double deviations_aside = 2., slope_aside = 0.1;

  // A gap is bridged by an arc that turns by 69 degrees at most, and by less where it is short: by 0.35 (as two curves
  // that lead on smoothly) and what a circle of radius 1 / 0.06 = 17 turns over the gap.
  static constexpr double largest_turn_of_bridge = 1.2;
  static constexpr double turn_of_bridge = 0.35, turn_per_gap = 0.06;

  // A crease ends where the last so many places in a row have one: single ones occur beside creases as well.
  static constexpr int places_in_a_row = 3;
  static constexpr double least_trimmed = 3.; // of what is left of a curve: less is within the ball of one fit

  // An edge that the field does not show is another than those there are if it is so far from them along its middle
  // half: by this share of its length, as from those that leave its ends at 53 degrees and more, or by one r.
  static constexpr double share_apart = 0.2, most_apart = 1.;
  static constexpr std::size_t edges_of_gap = 2; // where three edges meet, as in most corners, and one is missing

public:
  using Joint_editor::Joint_editor;

  void join()
  {
    Tangency_resolver tangencies(m_network, m_options, m_progress);
    tangencies.bridge_tangencies();
    Corner_merger corners(m_network, m_options, m_progress);
    corners.merge_nodes_that_agree();
    corners.attach_ends_to_passing_curves();
    corners.split_crossings();
    dissolve_smooth_joints();
    bridge_gaps();
    tangencies.close_acute_corners();
    extend_free_ends();
    dissolve_smooth_joints();
    tangencies.separate_tangent_curves();
  }

  // free ends that lead to a node a little farther on
  void extend_free_ends()
  {
    const auto incidences = m_network.incidences();
    std::vector<std::size_t> targets;
    std::vector<Vector> positions;
    for (std::size_t node = 0; node < incidences.size(); ++node)
      if (incidences[node].size() > 1)
      {
        targets.push_back(node);
        positions.push_back(m_network.nodes[node]);
      }
    const Ball_search search(positions);
    std::vector<std::size_t> found;
    for (const std::vector<Curve_end>& ends : incidences)
    {
      if (!goes_on())
        return;
      if (ends.size() != 1)
        continue;
      search.query(tip(ends[0]).point, reach_ahead * m_options.reach, found);
      double nearest = (std::numeric_limits<double>::infinity)(), depth_of_nearest = 0.;
      std::size_t target = no_node;
      for (double depth : depths)
      {
        const std::optional<Local_curve> end = inner_tip(ends[0], depth);
        if (target != no_node || !end)
          break;
        for (std::size_t k : found)
        {
          const Vector offset = positions[k] - end->point;
          const double ahead = offset.dot(end->tangent);
          const double miss = (offset - ahead * end->tangent).norm();
          if (ahead > -farthest_behind && miss < deviations_aside * m_options.across() + slope_aside * std::abs(ahead)
              && std::abs(ahead) < nearest && m_network.curves[ends[0].first].nodes[1 - ends[0].second] != targets[k])
          {
            nearest = std::abs(ahead);
            depth_of_nearest = depth;
            target = targets[k];
          }
        }
      }
      if (target != no_node)
      {
        shorten(ends[0], depth_of_nearest);
        attach(ends[0], target);
      }
    }
  }

  // free ends that face each other
  void bridge_gaps()
  {
    bridge(
      free_ends(), [](std::size_t, std::size_t) { return true; },
      [this](const Bridging_arc& arc) {
        return arc.turn <= largest_turn_of_bridge
          ? (std::max)(
            {arc.mismatch, arc.turn / (turn_of_bridge + turn_per_gap * arc.gap), arc.gap / m_options.maximum_bridge})
          : most_costly_bridge;
      });
  }

  // Removes joints of two curves where a smooth course explains the field better than a corner: joint_fit(center,
  // polylines) makes a Joint_fit of what two curves are near the place where they meet.
  template <class Make_joint_fit>
  void round_off(const Make_joint_fit& joint_fit, double margin, Progress& progress)
  {
    Incidences incidences = m_network.incidences();
    for (std::size_t node = 0; node < incidences.size() && progress.goes_on(); ++node)
    {
      if (incidences[node].size() != 2)
        continue;
      const Curve_end a = incidences[node][0], b = incidences[node][1];
      if (a.first != b.first && round_joint(a, b, joint_fit, margin, progress))
        join_ends(a, b, incidences);
    }
  }

  // Adds curves between near nodes where `gain(polyline)` is positive: straight ones, or between free ends such that
  // lead on smoothly. Then straight ones between corners of which the field shows no more than two edges, where it is
  // the surface that shows a third: `is_folded(polyline)`.
  template <class Gain, class Is_folded, class Accept>
  void add_edges_between_nodes(double longest, const Gain& gain, const Is_folded& is_folded, const Accept& accept)
  {
    const Incidences incidences = m_network.incidences();
    std::vector<Edge_candidate> candidates, hypotheses;
    for_each_near_pair(incidences, longest, [&](std::size_t i, std::size_t j) {
      Edge_candidate edge = best_edge(incidences, i, j, gain);
      if (edge.gain > 0.)
        candidates.push_back(edge);
      else if (incidences[i].size() <= edges_of_gap && incidences[j].size() <= edges_of_gap)
        hypotheses.push_back({-(m_network.nodes[i] - m_network.nodes[j]).norm(), {i, j}, {}});
    });
    std::vector<std::size_t> degrees;
    for (const std::vector<Curve_end>& ends : incidences)
      degrees.push_back(ends.size());
    const auto add = [&](const Edge_candidate& edge) {
      Network_curve curve;
      curve.nodes = edge.nodes;
      curve.points = edge.points;
      set_tips(curve);
      m_network.curves.push_back(curve);
      accept(curve.points);
      ++degrees[edge.nodes[0]];
      ++degrees[edge.nodes[1]];
    };
    std::sort(candidates.begin(), candidates.end());
    for (const Edge_candidate& edge : candidates)
      // what was added before may have taken the evidence
      if (goes_on() && gain(edge.points) > 0.)
        add(edge);
    // the shortest first: longer ones may lead over them
    std::sort(hypotheses.begin(), hypotheses.end());
    Segment_grid grid = m_network.segments();
    for (Edge_candidate& edge : hypotheses)
    {
      if (!goes_on() || degrees[edge.nodes[0]] > edges_of_gap || degrees[edge.nodes[1]] > edges_of_gap)
        continue;
      edge.points = straight(m_network.nodes[edge.nodes[0]], m_network.nodes[edge.nodes[1]]);
      if (!runs_apart(edge.points, grid) || !is_folded(edge.points))
        continue;
      add(edge);
      grid.add(m_network.curves.size() - 1, edge.points);
    }
  }

  template <class Prune>
  void prune(const Prune& prune_polylines)
  {
    const std::vector<char> keep = prune_polylines(m_network.polylines());
    for (std::size_t c = 0; c < keep.size(); ++c)
      m_network.curves[c].is_alive = keep[c];
    dissolve_smooth_joints();
  }

  // Cuts free ends back to where the surface has a crease: is_on_crease(position). Curves without any are left alone if
  // they are longer than `longest`.
  template <class Is_on_crease>
  void trim_free_ends(const Is_on_crease& is_on_crease, double longest)
  {
    for (const Curve_end& end : free_ends())
    {
      Network_curve& curve = m_network.curves[end.first];
      if (!goes_on())
        return;
      if (!curve.is_alive)
        continue;
      std::vector<Vector> points = curve.points;
      if (end.second == 0)
        std::reverse(points.begin(), points.end());
      std::size_t last = points.size();
      int run = 0;
      while (last > 0 && run < places_in_a_row)
        run = is_on_crease(points[--last]) ? run + 1 : 0;
      last = (std::min)(points.size() - 1, last + places_in_a_row - 1);
      if (run < places_in_a_row)
      {
        curve.is_alive = polyline_length(curve.points) > longest;
        continue;
      }
      if (last + 1 == points.size())
        continue;
      points.resize(last + 1);
      if (points.size() < 2 || polyline_length(points) < least_trimmed)
      {
        curve.is_alive = false;
        continue;
      }
      if (end.second == 0)
        std::reverse(points.begin(), points.end());
      curve.points = points;
      set_tip(curve, end.second);
      m_network.nodes[curve.nodes[end.second]] = curve.tips[end.second].point;
    }
    dissolve_smooth_joints();
  }

  // removes short pieces that nothing but themselves speaks for
  void drop_spurs(double free_length, double dangling_length)
  {
    bool changed = true;
    while (changed && goes_on())
    {
      changed = false;
      const auto incidences = m_network.incidences();
      for (Network_curve& curve : m_network.curves)
      {
        if (!curve.is_alive || curve.is_closed_without_node())
          continue;
        const int free_ends = int(incidences[curve.nodes[0]].size() == 1) + int(incidences[curve.nodes[1]].size() == 1);
        const double length = polyline_length(curve.points);
        if ((free_ends == 2 && length < free_length) || (free_ends == 1 && length < dangling_length))
        {
          curve.is_alive = false;
          changed = true;
        }
      }
      if (changed)
        dissolve_smooth_joints();
    }
  }

private:
  // an edge that the network may lack
  struct Edge_candidate
  {
    double gain;
    std::array<std::size_t, 2> nodes;
    std::vector<Vector> points;

    // the best first
    bool operator<(const Edge_candidate& other) const
    {
      return std::tie(other.gain, nodes) < std::tie(gain, other.nodes);
    }
  };

  // calls visitor(node, other) for nodes where curves meet
  template <class Visitor>
  void for_each_near_pair(const Incidences& incidences, double longest, const Visitor& visitor) const
  {
    std::vector<std::size_t> used, found;
    std::vector<Vector> positions;
    for (std::size_t node = 0; node < incidences.size(); ++node)
      if (!incidences[node].empty())
      {
        used.push_back(node);
        positions.push_back(m_network.nodes[node]);
      }
    const Ball_search search(positions);
    for (std::size_t i = 0; i < used.size() && goes_on(); ++i)
    {
      search.query(positions[i], longest, found);
      for (std::size_t j : found)
        if (i < j && (positions[i] - positions[j]).norm() >= least_edge)
          visitor(used[i], used[j]);
    }
  }

  // whether no curve comes near the middle half of a straight edge
  static bool runs_apart(const std::vector<Vector>& edge, const Segment_grid& grid)
  {
    const double length = (edge.back() - edge.front()).norm();
    const double apart = (std::min)(most_apart, share_apart * length);
    return std::none_of(edge.begin(), edge.end(), [&](const Vector& place) {
      return (std::min)((place - edge.front()).norm(), (place - edge.back()).norm()) >= 0.25 * length
        && grid.nearest(place, apart, [](const Segment_grid::Hit&) { return true; }).is_valid();
    });
  }

  // the straight edge, or the arc that leads on from two free ends
  template <class Gain>
  Edge_candidate best_edge(const Incidences& incidences, std::size_t i, std::size_t j, const Gain& gain) const
  {
    const Vector &from = m_network.nodes[i], &to = m_network.nodes[j];
    Edge_candidate edge{0., {i, j}, straight(from, to)};
    edge.gain = gain(edge.points);
    if (incidences[i].size() == 1 && incidences[j].size() == 1)
    {
      std::vector<Vector> arc{from};
      append_arc(arc, tip(incidences[i][0]).tangent, to, -tip(incidences[j][0]).tangent);
      const double gain_of_arc = gain(arc);
      if (gain_of_arc > edge.gain)
        edge = {gain_of_arc, {i, j}, arc};
    }
    return edge;
  }

  // A curve as one sees it from one of its ends: the part that is near, which starts at the end, and the rest.
  struct Parted_curve
  {
    std::vector<Vector> near, far;

    Parted_curve(const std::vector<Vector>& points, int end)
    {
      const Inward_view view(points, end);
      double length = 0.;
      for (std::size_t k = 0; k < view.size(); ++k)
      {
        (length < length_of_joint || near.size() < 2 ? near : far).push_back(view[k]);
        if (k + 1 < view.size())
          length += (view[k + 1] - view[k]).norm();
      }
    }
  };

  // Returns whether the field asks for a smooth course; then the two curves follow it, and only need to be joined.
  template <class Make_joint_fit>
  bool round_joint(const Curve_end& a, const Curve_end& b, const Make_joint_fit& joint_fit, double margin,
                   Progress& progress)
  {
    Network_curve &first = m_network.curves[a.first], &second = m_network.curves[b.first];
    const Parted_curve one(first.points, a.second), two(second.points, b.second);
    const std::vector<Vector> head(one.near.rbegin(), one.near.rend()), &tail = two.near;
    const Vector corner = tail.front();
    const auto joint = joint_fit(corner, std::vector<std::vector<Vector>>{head, tail});
    Joint_course smooth = best_rounded_course(joint, head, tail), sharp = best_corner(joint, head, tail);
    if (smooth.polylines.empty())
      return false;
    if (m_options.noise < least_noise_without_fits)
    {
      improve(smooth, joint.smooth(smooth.polylines[0], progress));
      improve(sharp, joint.corner(sharp.polylines[0], sharp.polylines[1], progress));
    }
    const bool turns_little = tip(a).tangent.dot(tip(b).tangent) < -std::cos(m_options.rounded_turn);
    const double most = turns_little ? sharp.loss + margin : (std::max)(sharp.loss - margin, most_of_loss * sharp.loss);
    if (progress.is_cancelled() || !(smooth.loss < most))
      return false;
    std::vector<Vector> course = smooth.polylines[0];
    course.front() = head.front();
    course.back() = tail.back();
    // the corner stands for the node until the two are one
    set_points(first, a.second, one.far, std::vector<Vector>(course.begin(), course.end() - 1), corner);
    set_points(second, b.second, two.far, {course.back()}, corner);
    return true;
  }

  // `far` starts near the end in question, `near` leads to it
  static void set_points(Network_curve& curve, int end, const std::vector<Vector>& far, const std::vector<Vector>& near,
                         const Vector& last)
  {
    curve.points.assign(far.rbegin(), far.rend());
    curve.points.insert(curve.points.end(), near.begin(), near.end());
    curve.points.push_back(last);
    if (end == 0)
      std::reverse(curve.points.begin(), curve.points.end());
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_END_JOINER_H
