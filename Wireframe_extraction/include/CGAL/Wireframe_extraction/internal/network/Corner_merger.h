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

#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/network/Network_editor.h>
#include <CGAL/Wireframe_extraction/internal/network/Position_belief.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Makes corners of ends of curves whose beliefs about where they end agree, and of such that end next to another curve.
class Corner_merger : private Network_editor
{
  struct Cluster
  {
    Position_belief belief;
    std::vector<Curve_end> members;
    std::size_t number_of_nodes;
    bool is_alive;
  };

public:
  using Network_editor::Network_editor;

  // agglomerative: of all nodes, the two that agree best become one first
  void merge_nodes_that_agree()
  {
    std::vector<Cluster> clusters;
    std::vector<Vector> positions;
    for (const std::vector<Curve_end>& ends : m_network.incidences())
    {
      if (ends.empty())
        continue;
      Cluster cluster{belief(ends[0]), ends, 1, true};
      for (std::size_t k = 1; k < ends.size(); ++k)
        cluster.belief = cluster.belief * belief(ends[k]);
      positions.push_back(cluster.belief.mean());
      clusters.push_back(cluster);
    }
    typedef std::tuple<double, std::size_t, std::size_t> Candidate;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue;
    const auto propose = [&](std::size_t a, std::size_t b) {
      if (!may_meet(clusters[a], clusters[b]))
        return;
      const double cost = (clusters[a].belief * clusters[b].belief).disagreement() - clusters[a].belief.disagreement()
        - clusters[b].belief.disagreement();
      if (cost < m_options.maximum_disagreement)
        queue.emplace(cost, a, b);
    };
    const Ball_search search(positions);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      search.query(positions[i], m_options.reach, found);
      for (std::size_t j : found)
        if (i < j)
          propose(i, j);
    }
    while (!queue.empty())
    {
      const std::size_t a = std::get<1>(queue.top()), b = std::get<2>(queue.top());
      queue.pop();
      if (!clusters[a].is_alive || !clusters[b].is_alive)
        continue;
      Cluster merged = clusters[a];
      merged.belief = merged.belief * clusters[b].belief;
      merged.members.insert(merged.members.end(), clusters[b].members.begin(), clusters[b].members.end());
      merged.number_of_nodes += clusters[b].number_of_nodes;
      clusters[a].is_alive = clusters[b].is_alive = false;
      const Vector mean = merged.belief.mean();
      clusters.push_back(merged);
      for (std::size_t k = 0; k + 1 < clusters.size(); ++k)
        if (clusters[k].is_alive && (clusters[k].belief.mean() - mean).norm() < m_options.reach)
          propose(k, clusters.size() - 1);
    }
    for (const Cluster& cluster : clusters)
    {
      if (!cluster.is_alive || cluster.number_of_nodes < 2)
        continue;
      const std::size_t node = m_network.nodes.size();
      m_network.nodes.push_back(cluster.belief.mean());
      for (const Curve_end& end : cluster.members)
        attach(end, node);
    }
  }

  // a node next to the inside of another curve splits that curve
  void attach_ends_to_passing_curves()
  {
    Segment_grid grid;
    for (std::size_t c = 0; c < m_network.curves.size(); ++c)
      if (m_network.curves[c].is_alive)
        grid.add(c, m_network.curves[c].points);
    struct Split
    {
      std::size_t node, curve;
      Segment_grid::Hit hit;
    };
    std::vector<Split> splits;
    const auto incidences = m_network.incidences();
    for (std::size_t node = 0; node < incidences.size(); ++node)
    {
      if (incidences[node].empty())
        continue;
      Position_belief common;
      for (const Curve_end& end : incidences[node])
        common = common * belief(end);
      const Vector position = incidences[node].size() > 1 ? m_network.nodes[node] : common.mean();
      std::vector<Segment_grid::Hit> best_of_curve;
      grid.visit(position, 3., [&](const Segment_grid::Hit& hit) {
        for (Segment_grid::Hit& other : best_of_curve)
          if (other.curve == hit.curve)
          {
            if (hit.distance < other.distance)
              other = hit;
            return;
          }
        best_of_curve.push_back(hit);
      });
      for (const Segment_grid::Hit& hit : best_of_curve)
      {
        if (!is_inside(hit))
          continue;
        const Position_belief line = Position_belief::along_line(
          hit.point, hit.direction, (std::numeric_limits<double>::infinity)(), m_options.across());
        const Position_belief both = common * line;
        if (both.disagreement() - common.disagreement() < m_options.maximum_disagreement)
          splits.push_back({node, hit.curve, hit});
      }
    }
    // splits of one curve, from its end to its beginning, keep the indices of the segments valid
    std::sort(splits.begin(), splits.end(), [](const Split& a, const Split& b) {
      return std::make_tuple(a.curve, b.hit.segment, a.node) < std::make_tuple(b.curve, a.hit.segment, b.node);
    });
    for (std::size_t k = 0; k < splits.size(); ++k)
    {
      const std::size_t shift = split_curve(splits[k].curve, splits[k].hit, splits[k].node);
      for (std::size_t other = k + 1; other < splits.size() && splits[other].curve == splits[k].curve; ++other)
        splits[other].hit.segment += shift;
    }
  }

private:
  Position_belief belief(const Curve_end& end) const
  {
    const Network_curve& curve = m_network.curves[end.first];
    const Local_curve& tip = curve.tips[end.second];
    const double along = curve.ends_in_void[end.second] ? m_options.along() + 1.5 : m_options.along();
    const double ahead = curve.ends_in_void[end.second] ? 1.3 : 0.3;
    return Position_belief::along_line(tip.at(ahead), tip.tangent_at(ahead), along, m_options.across());
  }

  // the two ends of one short curve are no corner
  bool may_meet(const Cluster& a, const Cluster& b) const
  {
    for (const Curve_end& i : a.members)
      for (const Curve_end& j : b.members)
        if (i.first == j.first && polyline_length(m_network.curves[i.first].points) < 8.)
          return false;
    return true;
  }

  // returns by how much the indices of the segments before grow: a closed curve begins anew where it is opened
  std::size_t split_curve(std::size_t c, const Segment_grid::Hit& hit, std::size_t node)
  {
    const Curve_network& network = m_network;
    std::vector<Vector> points = network.curves[c].points;
    if (hit.segment + 1 >= points.size())
      return 0;
    const auto incidences = m_network.incidences();
    if (incidences[node].size() == 1)
    {
      m_network.nodes[node] = hit.point;
      attach(incidences[node].front(), node);
      points = network.curves[c].points;
      if (hit.segment + 1 >= points.size())
        return 0;
    }
    const Vector position = m_network.nodes[node];
    if (network.curves[c].is_closed_without_node())
    {
      // a closed curve is opened at the node
      std::vector<Vector> opened{position};
      opened.insert(opened.end(), points.begin() + hit.segment + 1, points.end() - 1);
      opened.insert(opened.end(), points.begin(), points.begin() + hit.segment + 1);
      opened.push_back(position);
      Network_curve& curve = m_network.curves[c];
      curve.points = opened;
      curve.nodes = {node, node};
      set_tips(curve);
      return points.size() - 1 - hit.segment;
    }
    Network_curve second = network.curves[c];
    second.points.assign(points.begin() + hit.segment + 1, points.end());
    second.points.insert(second.points.begin(), position);
    second.nodes[0] = node;
    set_tip(second, 0);
    Network_curve& first = m_network.curves[c];
    first.points.resize(hit.segment + 1);
    first.points.push_back(position);
    first.nodes[1] = node;
    set_tip(first, 1);
    m_network.curves.push_back(second);
    return 0;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CORNER_MERGER_H
