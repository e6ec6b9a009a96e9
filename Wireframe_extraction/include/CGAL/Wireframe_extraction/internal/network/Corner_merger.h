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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CORNER_MERGER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CORNER_MERGER_H

#include <CGAL/Wireframe_extraction/internal/base/Position_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/network/Network_editor.h>
#include <CGAL/Wireframe_extraction/internal/network/Position_belief.h>
#include <CGAL/Wireframe_extraction/internal/network/crossings.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Makes corners of ends of curves whose beliefs about where they end agree, and of such that end next to another curve.
class Corner_merger : private Network_editor
{
  // Lengths in r.
  // A trace stops this far before the corner where its fits become bad. Where the data end, it stops earlier, by the
  // part of a gap that was not bridged, and less is known of the place along the curve.
  static constexpr double usual_shortfall = 0.3, shortfall_in_void = 1.3;
  static constexpr double more_doubt_in_void = 1.5;
  // From a node to a curve that it splits. Beliefs decide, this bounds the search: single ends are uncertain by
  // along(), about 1, so that three times this are enough.
  static constexpr double farthest_passing_curve = 3.;
  // with larger errors, in r, two traces of one edge cross more often than two edges do
  static constexpr double most_noise_of_crossings = 0.1;
  static constexpr double least_piece = 0.1; // splits that are closer than half of across() are at the same place

  struct Cluster
  {
    Position_belief belief;
    std::vector<Curve_end> members;
    std::size_t number_of_nodes = 1;
    bool is_alive = true;
    Vector mean = Vector::Zero(); // of the belief, and what it tells about how well its factors agree
    double disagreement = 0.;

    void set_belief(const Position_belief& product)
    {
      belief = product;
      mean = product.mean();
      disagreement = product.disagreement();
    }
  };

  // The segment is that of the curve as it was when the split was proposed. Splits, and ends that are attached, change
  // curves, so it tells which splits come first, and the place alone tells what is split.
  struct Split
  {
    std::size_t node, curve, segment;
    Vector place;
  };

  struct Place_on_curve
  {
    double squared_distance = (std::numeric_limits<double>::infinity)();
    std::size_t curve = no_node, segment = 0;
  };

public:
  using Network_editor::Network_editor;

  // agglomerative: of all nodes, the two that agree best become one first
  void merge_nodes_that_agree()
  {
    std::vector<Cluster> clusters;
    typedef std::tuple<double, std::size_t, std::size_t> Candidate;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue;
    Position_grid grid(m_options.reach); // of those that are alive
    const auto add = [&](const Cluster& cluster) {
      const std::size_t b = clusters.size();
      clusters.push_back(cluster);
      grid.visit(cluster.mean, [&](std::size_t a) {
        const double cost = cost_of_merging(clusters[a], cluster);
        if (cost < m_options.maximum_disagreement)
          queue.emplace(cost, a, b);
      });
      grid.add(b, cluster.mean);
    };
    for (const std::vector<Curve_end>& ends : m_network.incidences())
      if (!ends.empty() && goes_on())
        add(cluster_of(ends));
    while (!queue.empty() && goes_on())
    {
      const std::size_t a = std::get<1>(queue.top()), b = std::get<2>(queue.top());
      queue.pop();
      if (!clusters[a].is_alive || !clusters[b].is_alive)
        continue;
      const Cluster both = merged(clusters[a], clusters[b]);
      for (std::size_t gone : {a, b})
      {
        clusters[gone].is_alive = false;
        grid.remove(gone, clusters[gone].mean);
      }
      add(both);
    }
    for (const Cluster& cluster : clusters)
    {
      if (!cluster.is_alive || cluster.number_of_nodes < 2)
        continue;
      const std::size_t node = m_network.nodes.size();
      m_network.nodes.push_back(cluster.mean);
      for (const Curve_end& end : cluster.members)
        attach(end, node);
    }
  }

  // a node next to the inside of another curve splits that curve
  void attach_ends_to_passing_curves()
  {
    Incidences incidences = m_network.incidences();
    std::vector<Split> splits = proposed_splits(incidences);
    std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
      return std::tie(a.curve, b.segment, a.node) < std::tie(b.curve, a.segment, b.node);
    });
    std::vector<std::size_t> pieces; // of the curve that is split
    for (std::size_t k = 0; k < splits.size() && goes_on(); ++k)
    {
      if (k == 0 || splits[k].curve != splits[k - 1].curve)
        pieces.assign(1, splits[k].curve);
      split_curve(pieces, splits[k], incidences);
    }
  }

  // Two curves that pass through one place in different directions end there: a shape has a vertex
  // where four edges meet.
  void split_crossings()
  {
    if (m_options.noise > most_noise_of_crossings)
      return;
    Incidences incidences = m_network.incidences();
    std::map<std::size_t, std::vector<std::size_t>> pieces; // of the curves that are split
    for (const Curve_crossing& crossing : crossings(m_network, m_options.across(), least_distance_to_ends, m_progress))
    {
      if (!goes_on())
        return;
      const std::size_t node = m_network.nodes.size();
      m_network.nodes.push_back(crossing.place);
      incidences.emplace_back();
      for (std::size_t c : crossing.curves)
      {
        std::vector<std::size_t>& of_curve = pieces[c];
        if (of_curve.empty())
          of_curve.push_back(c);
        split_at(of_curve, node, crossing.place, incidences);
      }
    }
  }

private:
  Cluster cluster_of(const std::vector<Curve_end>& ends) const
  {
    Cluster result;
    result.members = ends;
    Position_belief product = belief(ends[0]);
    for (std::size_t k = 1; k < ends.size(); ++k)
      product = product * belief(ends[k]);
    result.set_belief(product);
    return result;
  }

  static Cluster merged(const Cluster& a, const Cluster& b)
  {
    Cluster result;
    result.members = a.members;
    result.members.insert(result.members.end(), b.members.begin(), b.members.end());
    result.number_of_nodes = a.number_of_nodes + b.number_of_nodes;
    result.set_belief(a.belief * b.belief);
    return result;
  }

  // by how much the beliefs of two clusters disagree with each other
  double cost_of_merging(const Cluster& a, const Cluster& b) const
  {
    if (!may_meet(a, b))
      return (std::numeric_limits<double>::infinity)();
    return (a.belief * b.belief).disagreement() - a.disagreement - b.disagreement;
  }

  Position_belief belief(const Curve_end& end) const
  {
    const Network_curve& curve = m_network.curves[end.first];
    const Local_curve& tip = curve.tips[end.second];
    const bool is_in_void = curve.ends_in_void[end.second];
    const double along = is_in_void ? m_options.along() + more_doubt_in_void : m_options.along();
    const double ahead = is_in_void ? shortfall_in_void : usual_shortfall;
    return Position_belief::along_line(tip.at(ahead), tip.tangent_at(ahead), along, m_options.across());
  }

  // the two ends of one short curve are no corner
  bool may_meet(const Cluster& a, const Cluster& b) const
  {
    for (const Curve_end& i : a.members)
      for (const Curve_end& j : b.members)
        if (i.first == j.first && polyline_length(m_network.curves[i.first].points) < shortest_return)
          return false;
    return true;
  }

  std::vector<Split> proposed_splits(const Incidences& incidences) const
  {
    const Segment_grid grid = m_network.segments();
    std::vector<Split> splits;
    for (std::size_t node = 0; node < incidences.size() && goes_on(); ++node)
    {
      if (incidences[node].empty())
        continue;
      Position_belief common;
      for (const Curve_end& end : incidences[node])
        common = common * belief(end);
      const Vector position = incidences[node].size() > 1 ? m_network.nodes[node] : common.mean();
      for (const Segment_grid::Hit& hit : nearest_of_each_curve(grid, position))
      {
        if (!is_inside(hit))
          continue;
        const Position_belief line = Position_belief::along_line(
          hit.point, hit.direction, (std::numeric_limits<double>::infinity)(), m_options.across());
        const Position_belief both = common * line;
        if (both.disagreement() - common.disagreement() < m_options.maximum_disagreement)
          splits.push_back({node, hit.curve, hit.segment, hit.point});
      }
    }
    return splits;
  }

  static std::vector<Segment_grid::Hit> nearest_of_each_curve(const Segment_grid& grid, const Vector& position)
  {
    std::vector<Segment_grid::Hit> result;
    grid.visit(position, farthest_passing_curve, [&](const Segment_grid::Hit& hit) {
      for (Segment_grid::Hit& other : result)
        if (other.curve == hit.curve)
        {
          if (hit.distance < other.distance)
            other = hit;
          return;
        }
      result.push_back(hit);
    });
    return result;
  }

  // splits that one of the pieces of a curve which passes the place
  void split_curve(std::vector<std::size_t>& pieces, const Split& split, Incidences& incidences)
  {
    std::vector<Curve_end>& ends = incidences[split.node];
    if (ends.empty()) // they were moved to another node
      return;
    if (ends.size() == 1)
    {
      m_network.nodes[split.node] = split.place;
      attach(ends.front(), split.node);
    }
    split_at(pieces, split.node, split.place, incidences);
  }

  void split_at(std::vector<std::size_t>& pieces, std::size_t node, const Vector& place, Incidences& incidences)
  {
    std::vector<Curve_end>& ends = incidences[node];
    const Place_on_curve at = nearest_place(pieces, place);
    Network_curve& curve = m_network.curves[at.curve];
    for (std::size_t end : curve.nodes)
      if (end != no_node && end != node && (m_network.nodes[end] - place).norm() < least_piece)
      {
        move_ends(node, end, incidences); // an earlier split was there
        return;
      }
    if (curve.is_closed_without_node())
    {
      open(curve, at.segment, node);
      ends.insert(ends.end(), {{at.curve, 0}, {at.curve, 1}});
      return;
    }
    const std::size_t beyond = m_network.curves.size();
    std::vector<Curve_end>& ends_beyond = incidences[curve.nodes[1]];
    rename(ends_beyond, {at.curve, 1}, {beyond, 1});
    ends.insert(ends.end(), {{at.curve, 1}, {beyond, 0}});
    m_network.curves.push_back(cut_off(curve, at.segment, node));
    pieces.push_back(beyond);
  }

  void move_ends(std::size_t from, std::size_t to, Incidences& incidences)
  {
    for (const Curve_end& end : incidences[from])
    {
      attach(end, to);
      incidences[to].push_back(end);
    }
    incidences[from].clear();
  }

  Place_on_curve nearest_place(const std::vector<std::size_t>& curves, const Vector& p) const
  {
    Place_on_curve best;
    for (std::size_t c : curves)
    {
      const std::vector<Vector>& points = m_network.curves[c].points;
      for (std::size_t k = 1; k < points.size(); ++k)
      {
        const double squared_distance = squared_distance_to_segment(p, points[k - 1], points[k]);
        if (squared_distance < best.squared_distance)
          best = {squared_distance, c, k - 1};
      }
    }
    return best;
  }

  // lets a closed curve start and end at a node in one of its segments
  void open(Network_curve& curve, std::size_t segment, std::size_t node) const
  {
    const std::vector<Vector>& points = curve.points;
    const Vector position = m_network.nodes[node];
    std::vector<Vector> opened{position};
    opened.insert(opened.end(), points.begin() + segment + 1, points.end() - 1);
    opened.insert(opened.end(), points.begin(), points.begin() + segment + 1);
    opened.push_back(position);
    curve.points = opened;
    curve.nodes = {node, node};
    set_tips(curve);
  }

  // lets a curve end at a node in one of its segments, and returns what lies beyond
  Network_curve cut_off(Network_curve& curve, std::size_t segment, std::size_t node) const
  {
    const Vector position = m_network.nodes[node];
    Network_curve rest = curve;
    rest.points.assign(curve.points.begin() + segment + 1, curve.points.end());
    rest.points.insert(rest.points.begin(), position);
    rest.nodes[0] = node;
    set_tip(rest, 0);
    curve.points.resize(segment + 1);
    curve.points.push_back(position);
    curve.nodes[1] = node;
    set_tip(curve, 1);
    return rest;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CORNER_MERGER_H
