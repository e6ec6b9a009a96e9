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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_END_JOINER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_END_JOINER_H

#include <CGAL/Wireframe_extraction/internal/Network_editor.h>
#include <CGAL/Wireframe_extraction/internal/Tangency_resolver.h>

#include <Eigen/LU>

#include <queue>
#include <tuple>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Where a curve ends is known well across the curve and badly along it. Such a belief is a Gaussian, and beliefs
// about the same corner multiply.
struct Position_belief
{
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Vector weighted = Vector::Zero();     // information * mean
  double constant = 0.;                 // sum of mean^T information mean

  static Position_belief along_line(const Vector& mean, const Vector& direction, double along, double across)
  {
    Position_belief belief;
    const Eigen::Matrix3d parallel = direction * direction.transpose();
    belief.information = (Eigen::Matrix3d::Identity() - parallel) / (across * across);
    if (along < (std::numeric_limits<double>::infinity)())
      belief.information += parallel / (along * along);
    belief.weighted = belief.information * mean;
    belief.constant = mean.dot(belief.weighted);
    return belief;
  }

  Position_belief operator*(const Position_belief& other) const
  {
    Position_belief product;
    product.information = information + other.information;
    product.weighted = weighted + other.weighted;
    product.constant = constant + other.constant;
    return product;
  }

  Vector mean() const { return information.ldlt().solve(weighted); }

  // sum of the squared, normalised deviations of the single beliefs from their common mean
  double disagreement() const { return (std::max)(0., constant - weighted.dot(mean())); }
};

// Joins the ends of traced curves in a network.
class Curve_end_joiner : private Network_editor
{
public:
  using Network_editor::Network_editor;

  void join()
  {
    Tangency_resolver tangencies(m_network, m_options);
    tangencies.bridge_tangencies();
    merge_nodes_that_agree();
    attach_ends_to_passing_curves();
    dissolve_smooth_joints();
    bridge_gaps();
    extend_free_ends();
    dissolve_smooth_joints();
    tangencies.separate_tangent_curves();
  }

  // Removes joints of two curves where a rounded course explains the field better than a corner:
  // loss(center, radius, polylines) tells how badly polylines explain it.
  template <class Loss>
  void round_off(const Loss& loss, double margin)
  {
    for (const std::vector<Curve_end>& ends : m_network.incidences()) {
      if (ends.size() != 2 || ends[0].first == ends[1].first)
        continue;
      Network_curve &first = m_network.curves[ends[0].first], &second = m_network.curves[ends[1].first];
      if (!first.is_alive || !second.is_alive || std::count(first.nodes.begin(), first.nodes.end(), no_node) > 0)
        continue;
      const Vector corner = ends[0].second == 0 ? first.points.front() : first.points.back();
      double best = loss(corner, 4., {&first.points, &second.points})
        + (tip(ends[0]).tangent.dot(tip(ends[1]).tangent) < -std::cos(m_options.rounded_turn) ? margin : -margin);
      std::vector<Vector> rounded_first, rounded_second;
      for (double reach : {0.7, 1.2, 1.8, 2.5, 3.5, 4.5}) {
        const std::vector<Vector> a = cut_back(first.points, ends[0].second, reach),
                                  b = cut_back(second.points, ends[1].second, reach);
        if (a.size() < 2 || b.size() < 2)
          break;
        std::vector<Vector> with_arc = a;
        append_arc(with_arc, end_direction(a), b.back(), -end_direction(b));
        const double rounded = loss(corner, 4., {&with_arc, &b});
        if (rounded < best) {
          best = rounded;
          rounded_first = with_arc;
          rounded_second = b;
        }
      }
      if (rounded_first.empty())
        continue;
      rounded_first.push_back(corner);   // stands for the node until the two are one
      rounded_second.push_back(corner);
      if (ends[0].second == 0)
        std::reverse(rounded_first.begin(), rounded_first.end());
      if (ends[1].second == 0)
        std::reverse(rounded_second.begin(), rounded_second.end());
      first.points = rounded_first;
      second.points = rounded_second;
      concatenate(ends[0], ends[1]);
    }
  }

  // Adds curves between near nodes where `gain(polyline)` is positive: straight ones, or between free ends such that
  // lead on smoothly.
  template <class Gain, class Accept>
  void add_edges_between_nodes(double longest, const Gain& gain, const Accept& accept)
  {
    const auto incidences = m_network.incidences();
    std::vector<std::size_t> used;
    std::vector<Vector> positions;
    for (std::size_t node = 0; node < incidences.size(); ++node)
      if (!incidences[node].empty()) {
        used.push_back(node);
        positions.push_back(m_network.nodes[node]);
      }
    const Ball_search search(positions);
    std::vector<std::tuple<double, std::size_t, std::size_t, std::vector<Vector> > > candidates;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < used.size(); ++i) {
      search.query(positions[i], longest, found);
      for (std::size_t j : found) {
        if (i >= j || (positions[i] - positions[j]).norm() < 1.)
          continue;
        const std::vector<Curve_end> &a = incidences[used[i]], &b = incidences[used[j]];
        std::vector<Vector> polyline = straight(positions[i], positions[j]);
        double best = gain(polyline);
        if (a.size() == 1 && b.size() == 1) {
          std::vector<Vector> arc{positions[i]};
          append_arc(arc, tip(a[0]).tangent, positions[j], -tip(b[0]).tangent);
          const double gain_of_arc = gain(arc);
          if (gain_of_arc > best) {
            best = gain_of_arc;
            polyline = arc;
          }
        }
        if (best > 0.)
          candidates.emplace_back(-best, used[i], used[j], polyline);
      }
    }
    std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
      return std::tie(std::get<0>(a), std::get<1>(a), std::get<2>(a))
        < std::tie(std::get<0>(b), std::get<1>(b), std::get<2>(b));
    });
    for (const auto& candidate : candidates) {
      // what was added before may have taken the evidence
      if (!(gain(std::get<3>(candidate)) > 0.))
        continue;
      Network_curve curve;
      curve.nodes = {std::get<1>(candidate), std::get<2>(candidate)};
      curve.points = std::get<3>(candidate);
      set_tips(curve);
      m_network.curves.push_back(curve);
      accept(curve.points);
    }
  }

  template <class Prune>
  void prune(const Prune& prune_polylines)
  {
    std::vector<const std::vector<Vector>*> polylines;
    for (const Network_curve& curve : m_network.curves)
      polylines.push_back(curve.is_alive ? &curve.points : nullptr);
    const std::vector<char> keep = prune_polylines(polylines);
    for (std::size_t c = 0; c < keep.size(); ++c)
      m_network.curves[c].is_alive = keep[c];
    dissolve_smooth_joints();
  }

  // Cuts free ends back to where the surface has a crease: is_on_crease(position). Curves without any are left alone if
  // they are longer than `longest`.
  template <class Is_on_crease>
  void trim_free_ends(const Is_on_crease& is_on_crease, double longest)
  {
    for (const Curve_end& end : free_ends()) {
      Network_curve& curve = m_network.curves[end.first];
      if (!curve.is_alive)
        continue;
      std::vector<Vector> points = curve.points;
      if (end.second == 0)
        std::reverse(points.begin(), points.end());
      std::size_t last = points.size();
      int run = 0;
      while (last > 0 && run < 3)
        run = is_on_crease(points[--last]) ? run + 1 : 0;
      last = (std::min)(points.size() - 1, last + 2);
      if (run < 3) {
        curve.is_alive = polyline_length(curve.points) > longest;
        continue;
      }
      if (last + 1 == points.size())
        continue;
      points.resize(last + 1);
      if (points.size() < 2 || polyline_length(points) < 3.) {
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
    while (changed) {
      changed = false;
      const auto incidences = m_network.incidences();
      for (Network_curve& curve : m_network.curves) {
        if (!curve.is_alive || curve.is_closed_without_node())
          continue;
        const int free_ends = int(incidences[curve.nodes[0]].size() == 1) + int(incidences[curve.nodes[1]].size() == 1);
        const double length = polyline_length(curve.points);
        if ((free_ends == 2 && length < free_length) || (free_ends == 1 && length < dangling_length)) {
          curve.is_alive = false;
          changed = true;
        }
      }
      if (changed)
        dissolve_smooth_joints();
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

  struct Cluster
  {
    Position_belief belief;
    std::vector<Curve_end> members;
    std::size_t number_of_nodes;
    bool is_alive;
  };

  // agglomerative: of all nodes, the two that agree best become one first
  void merge_nodes_that_agree()
  {
    std::vector<Cluster> clusters;
    std::vector<Vector> positions;
    for (const std::vector<Curve_end>& ends : m_network.incidences()) {
      if (ends.empty())
        continue;
      Cluster cluster{belief(ends[0]), ends, 1, true};
      for (std::size_t k = 1; k < ends.size(); ++k)
        cluster.belief = cluster.belief * belief(ends[k]);
      positions.push_back(cluster.belief.mean());
      clusters.push_back(cluster);
    }
    typedef std::tuple<double, std::size_t, std::size_t> Candidate;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate> > queue;
    const auto propose = [&](std::size_t a, std::size_t b) {
      if (!may_meet(clusters[a], clusters[b]))
        return;
      const double cost = (clusters[a].belief * clusters[b].belief).disagreement()
        - clusters[a].belief.disagreement() - clusters[b].belief.disagreement();
      if (cost < m_options.maximum_disagreement)
        queue.emplace(cost, a, b);
    };
    const Ball_search search(positions);
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      search.query(positions[i], m_options.reach, found);
      for (std::size_t j : found)
        if (i < j)
          propose(i, j);
    }
    while (!queue.empty()) {
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
    for (const Cluster& cluster : clusters) {
      if (!cluster.is_alive || cluster.number_of_nodes < 2)
        continue;
      const std::size_t node = m_network.nodes.size();
      m_network.nodes.push_back(cluster.belief.mean());
      for (const Curve_end& end : cluster.members)
        attach(end, node);
    }
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

  // a node next to the inside of another curve splits that curve
  void attach_ends_to_passing_curves()
  {
    Segment_grid grid;
    for (std::size_t c = 0; c < m_network.curves.size(); ++c)
      if (m_network.curves[c].is_alive)
        grid.add(c, m_network.curves[c].points);
    struct Split { std::size_t node, curve; Segment_grid::Hit hit; };
    std::vector<Split> splits;
    const auto incidences = m_network.incidences();
    for (std::size_t node = 0; node < incidences.size(); ++node) {
      if (incidences[node].empty())
        continue;
      Position_belief common;
      for (const Curve_end& end : incidences[node])
        common = common * belief(end);
      const Vector position = incidences[node].size() > 1 ? m_network.nodes[node] : common.mean();
      std::vector<Segment_grid::Hit> best_of_curve;
      grid.visit(position, 3., [&](const Segment_grid::Hit& hit) {
        for (Segment_grid::Hit& other : best_of_curve)
          if (other.curve == hit.curve) {
            if (hit.distance < other.distance)
              other = hit;
            return;
          }
        best_of_curve.push_back(hit);
      });
      for (const Segment_grid::Hit& hit : best_of_curve) {
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
    for (std::size_t k = 0; k < splits.size(); ++k) {
      const std::size_t shift = split_curve(splits[k].curve, splits[k].hit, splits[k].node);
      for (std::size_t other = k + 1; other < splits.size() && splits[other].curve == splits[k].curve; ++other)
        splits[other].hit.segment += shift;
    }
  }

  // returns by how much the indices of the segments before grow: a closed curve begins anew where it is opened
  std::size_t split_curve(std::size_t c, const Segment_grid::Hit& hit, std::size_t node)
  {
    const Curve_network& network = m_network;
    std::vector<Vector> points = network.curves[c].points;
    if (hit.segment + 1 >= points.size())
      return 0;
    const auto incidences = m_network.incidences();
    if (incidences[node].size() == 1) {
      m_network.nodes[node] = hit.point;
      attach(incidences[node].front(), node);
      points = network.curves[c].points;
      if (hit.segment + 1 >= points.size())
        return 0;
    }
    const Vector position = m_network.nodes[node];
    if (network.curves[c].is_closed_without_node()) {
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

  static std::vector<Vector> straight(const Vector& a, const Vector& b)
  {
    const std::size_t count = (std::max)(std::size_t(4), static_cast<std::size_t>(2. * (b - a).norm()));
    std::vector<Vector> points;
    for (std::size_t k = 0; k <= count; ++k)
      points.push_back(a + (b - a) * (double(k) / double(count)));
    return points;
  }

  // leads smoothly from the end of a polyline to another place, about on a circle where that is possible
  static void append_arc(std::vector<Vector>& points, const Vector& leave, const Vector& to, const Vector& arrive)
  {
    const Vector from = points.back();
    const double turn = std::acos((std::min)(1., (std::max)(-1., leave.dot(arrive))));
    const double chord = (to - from).norm();
    const double handle = turn > 1e-3 ? (std::min)(1., 2. / 3. * std::tan(turn / 4.) / std::sin(turn / 2.)) : 1. / 3.;
    const Vector first = from + handle * chord * leave, second = to - handle * chord * arrive;
    for (int k = 1; k <= 10; ++k) {
      const double t = k / 10., u = 1. - t;
      points.push_back(u * u * u * from + 3. * u * u * t * first + 3. * u * t * t * second + t * t * t * to);
    }
  }

  // free ends that lead to a node a little farther on
  void extend_free_ends()
  {
    const auto incidences = m_network.incidences();
    std::vector<std::size_t> targets;
    std::vector<Vector> positions;
    for (std::size_t node = 0; node < incidences.size(); ++node)
      if (incidences[node].size() > 1) {
        targets.push_back(node);
        positions.push_back(m_network.nodes[node]);
      }
    const Ball_search search(positions);
    std::vector<std::size_t> found;
    for (const std::vector<Curve_end>& ends : incidences) {
      if (ends.size() != 1)
        continue;
      search.query(tip(ends[0]).point, 1.6 * m_options.reach, found);
      double nearest = (std::numeric_limits<double>::infinity)(), depth_of_nearest = 0.;
      std::size_t target = no_node;
      for (double depth : depths) {
        if (target != no_node || !has_depth(ends[0], depth))
          break;
        const Local_curve end = inner_tip(ends[0], depth);
        for (std::size_t k : found) {
          const Vector offset = positions[k] - end.point;
          const double ahead = offset.dot(end.tangent);
          const double miss = (offset - ahead * end.tangent).norm();
          if (ahead > -1. && miss < 2. * m_options.across() + 0.1 * std::abs(ahead) && ahead < nearest
              && m_network.curves[ends[0].first].nodes[1 - ends[0].second] != targets[k]) {
            nearest = ahead;
            depth_of_nearest = depth;
            target = targets[k];
          }
        }
      }
      if (target != no_node) {
        shorten(ends[0], depth_of_nearest);
        attach(ends[0], target);
      }
    }
  }

  // free ends that face each other
  void bridge_gaps()
  {
    bridge(free_ends(), [](std::size_t, std::size_t) { return true; }, [this](const Bridging_arc& arc) {
      return arc.turn <= 1.2 ? (std::max)({arc.mismatch, arc.turn / (0.35 + 0.06 * arc.gap),
                                           arc.gap / m_options.maximum_bridge}) : 1.;
    });
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_END_JOINER_H
