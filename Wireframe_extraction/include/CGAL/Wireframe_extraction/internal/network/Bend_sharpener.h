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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BEND_SHARPENER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BEND_SHARPENER_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_evidence.h>
#include <CGAL/Wireframe_extraction/internal/network/Joint_editor.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Makes corners of bends. Where the field errs, a trace that comes to a corner may run around it and go on with another
// curve, and a spline explains the points there as well as the corner does. What tells is a third edge: the corners of
// parts have one, which leads to another corner, and where an edge is rounded none leaves it.
class Bend_sharpener : private Joint_editor
{
  // Lengths in r, angles in radians.
  // The directions before and behind a bend are those of chords, which begin where a trace has come around a corner,
  // and are long enough to be sure within some 0.1 (6 degrees).
  static constexpr double half_of_bend = 2., length_of_chord = 3., shortest_chord = 1.5;
  // An arc of a circle turns by 0.43 of the turn of a bend from such a chord to the next one, lines that meet by 0.
  static constexpr double most_turn_of_sides = 0.2;
  // nearer bends are one, which both see; where they are two, the second shows when the first has become a corner
  static constexpr double between_bends = half_of_bend + length_of_chord;
  // A third edge: longer ones are traced. It leaves by more than what the chords err together with the turn that is no
  // corner; else it runs along one of the two that it shall tell about.
  static constexpr double longest_edge = 10., least_angle = 0.5;
  // of the places along it that have a point which agrees with it: the errors of one regressor's patch cover less
  static constexpr double least_support = 0.6;
  // of the ball whose points judge: it holds most of a third edge, whose points the others must leave
  static constexpr double radius_of_judgement = 6.;

  static constexpr std::size_t no_target = static_cast<std::size_t>(-1), no_curve = no_target;

  // The points of a curve on both sides of a bend, the bend itself last and first.
  struct Sides
  {
    std::size_t first, last; // of the curve's points
    std::vector<Vector> head, tail;
  };

  struct Bend
  {
    std::size_t curve;
    Vector place;
    double turn;
    Sides sides = {};
    std::optional<Joint_course> corner = {}; // where the sides meet if they are followed
    std::size_t target = no_target;          // of m_targets, which is this corner
  };

  // where a third edge may lead to
  struct Target
  {
    Vector place;
    std::size_t node; // no_node of a bend
  };

  std::vector<Bend> m_bends; // curve by curve, in the order in which these come to them
  std::vector<Target> m_targets;
  std::vector<Eigen::AlignedBox3d> m_boxes; // of the curves
  std::size_t m_split_curve = no_curve;     // the last one, whose bends see others behind them than they did

public:
  using Joint_editor::Joint_editor;

  // joint_fit(center, polylines) makes a Joint_fit of what is before and behind a place; a smooth course must be better
  // by `margin`. Returns whether there is a new corner. In precise fields there is none, since they show roundings.
  template <class Make_joint_fit>
  bool run(const Make_joint_fit& joint_fit, const Curve_evidence& evidence, double margin)
  {
    if (m_options.noise < least_noise_without_fits)
      return false;
    for (std::size_t c = 0; c < m_network.curves.size(); ++c)
    {
      m_boxes.push_back(box_of(m_network.curves[c].points));
      if (m_network.curves[c].is_alive && goes_on())
        find_bends(c);
    }
    if (m_bends.empty())
      return false;
    find_targets(joint_fit);
    std::vector<Vector> places;
    for (const Target& target : m_targets)
      places.push_back(target.place);
    const Ball_search search(places);
    bool changed = false;
    // the last of a curve first, so that what comes before a bend keeps its place
    for (std::size_t b = m_bends.size(); b-- > 0 && goes_on();)
      if (m_bends[b].target != no_target && sharpen(b, joint_fit, evidence, search, margin))
        changed = true;
    return changed;
  }

private:
  static Eigen::AlignedBox3d box_of(const std::vector<Vector>& points)
  {
    Eigen::AlignedBox3d box;
    for (const Vector& p : points)
      box.extend(p);
    return box;
  }

  // the places of a curve that turn most
  void find_bends(std::size_t c)
  {
    const std::vector<Vector>& points = m_network.curves[c].points;
    std::vector<Bend> found;
    for (std::size_t k = 1; k + 1 < points.size(); ++k)
    {
      const double turn = turn_at(points, k, m_network.curves[c].is_closed_without_node());
      if (turn > m_options.smooth_turn)
        found.push_back({c, points[k], turn});
    }
    std::vector<std::size_t> order(found.size()), kept;
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return found[i].turn > found[j].turn; });
    for (std::size_t i : order)
      if (std::none_of(kept.begin(), kept.end(),
                       [&](std::size_t j) { return (found[i].place - found[j].place).norm() < between_bends; }))
        kept.push_back(i);
    std::sort(kept.begin(), kept.end());
    for (std::size_t i : kept)
      m_bends.push_back(found[i]);
  }

  // by which a curve turns at its k-th point, or 0 where it turns about as much before it or behind it
  static double turn_at(const std::vector<Vector>& points, std::size_t k, bool is_closed)
  {
    std::array<Vector, 2> near, far;
    for (int side = 0; side < 2; ++side)
    {
      const Vector& first = at_distance(points, k, side, half_of_bend, is_closed);
      const Vector& second = at_distance(points, k, side, half_of_bend + length_of_chord, is_closed);
      near[side] = second - first;
      far[side] = at_distance(points, k, side, half_of_bend + 2. * length_of_chord, is_closed) - second;
      if (near[side].norm() < shortest_chord)
        return 0.;
    }
    const double turn = angle(-near[0], near[1]);
    for (int side = 0; side < 2; ++side)
      if (far[side].norm() >= shortest_chord && angle(near[side], far[side]) > most_turn_of_sides * turn)
        return 0.;
    return turn;
  }

  // the point so far before (side 0) or behind (1) the k-th one, or the last one there
  static const Vector& at_distance(const std::vector<Vector>& points, std::size_t k, int side, double distance,
                                   bool is_closed)
  {
    const std::size_t end = points.size() - 1; // where a closed one comes back to its first point
    std::size_t i = k;
    for (std::size_t steps = 0; steps < end && (points[i] - points[k]).norm() < distance; ++steps)
    {
      if (!is_closed && i == (side == 0 ? 0 : end))
        break;
      if (side == 0)
        i = i == 0 ? end - 1 : i - 1;
      else
        i = i == end ? 1 : i + 1;
    }
    return points[i];
  }

  static double angle(const Vector& a, const Vector& b)
  {
    return std::acos((std::max)(-1., (std::min)(1., a.normalized().dot(b.normalized()))));
  }

  // the corners that bends would be, and the nodes of the network
  template <class Make_joint_fit>
  void find_targets(const Make_joint_fit& joint_fit)
  {
    for (std::size_t b = 0; b < m_bends.size() && goes_on(); ++b)
    {
      find_corner(b, joint_fit);
      if (!m_bends[b].corner)
        continue;
      m_bends[b].target = m_targets.size();
      m_targets.push_back({m_bends[b].corner->polylines[0].back(), no_node});
    }
    const Incidences incidences = m_network.incidences();
    for (std::size_t node = 0; node < incidences.size(); ++node)
      if (!incidences[node].empty())
        m_targets.push_back({m_network.nodes[node], node});
  }

  // up to the bends before and behind it
  Sides sides_of(std::size_t b) const
  {
    const std::size_t c = m_bends[b].curve;
    const std::vector<Vector>& points = m_network.curves[c].points;
    const auto index_of = [&](const Vector& place) {
      const auto nearer = [&](const Vector& p, const Vector& q) {
        return (p - place).squaredNorm() < (q - place).squaredNorm();
      };
      return std::size_t(std::min_element(points.begin(), points.end(), nearer) - points.begin());
    };
    const std::size_t middle = index_of(m_bends[b].place);
    std::size_t least = 0, most = points.size() - 1;
    if (b > 0 && m_bends[b - 1].curve == c)
      least = (std::min)(index_of(m_bends[b - 1].place), middle);
    if (b + 1 < m_bends.size() && m_bends[b + 1].curve == c)
      most = (std::max)(index_of(m_bends[b + 1].place), middle);
    Sides sides{middle, middle, {}, {}};
    for (double length = 0.; sides.first > least && length <= length_of_joint; --sides.first)
      length += (points[sides.first] - points[sides.first - 1]).norm();
    for (double length = 0.; sides.last < most && length <= length_of_joint; ++sides.last)
      length += (points[sides.last + 1] - points[sides.last]).norm();
    sides.head.assign(points.begin() + sides.first, points.begin() + middle + 1);
    sides.tail.assign(points.begin() + middle, points.begin() + sides.last + 1);
    return sides;
  }

  template <class Make_joint_fit>
  void find_corner(std::size_t b, const Make_joint_fit& joint_fit)
  {
    m_bends[b].sides = sides_of(b);
    const Sides& sides = m_bends[b].sides;
    m_bends[b].corner = best_extrapolated_corner(
      joint_fit(m_bends[b].place, std::vector<std::vector<Vector>>{sides.head, sides.tail}), sides.head, sides.tail);
  }

  template <class Make_joint_fit>
  bool sharpen(std::size_t b, const Make_joint_fit& joint_fit, const Curve_evidence& evidence,
               const Ball_search& search, double margin)
  {
    if (m_bends[b].curve == m_split_curve)
      find_corner(b, joint_fit);
    if (!m_bends[b].corner)
      return false;
    const std::array<std::vector<Vector>, 2> parts = parts_at(m_bends[b]);
    const std::vector<const std::vector<Vector>*> others = curves_near(b);
    const auto loss = [&](std::vector<const std::vector<Vector>*> polylines) {
      polylines.insert(polylines.end(), others.begin(), others.end());
      return evidence.loss_around(m_bends[b].place, radius_of_judgement, polylines);
    };
    const double smooth = loss({&m_network.curves[m_bends[b].curve].points}), sharp = loss({&parts[0], &parts[1]});
    std::vector<std::size_t> found;
    search.query(parts[0].back(), longest_edge, found);
    for (std::size_t t : found)
    {
      if (!may_lead_to(t, b))
        continue;
      const std::vector<Vector> edge = straight(parts[0].back(), m_targets[t].place);
      const bool is_there = m_targets[t].node != no_node && (edge.back() - edge.front()).norm() < least_edge;
      if (is_there ? sharp - margin <= smooth
                   : leaves(edge, parts) && evidence.support(edge) > least_support
              && loss({&parts[0], &parts[1], &edge}) - margin <= smooth)
      {
        split(b, parts);
        return true;
      }
    }
    return false;
  }

  // a third edge leads neither back nor to the ends of the two others
  bool may_lead_to(std::size_t t, std::size_t b) const
  {
    const Network_curve& own = m_network.curves[m_bends[b].curve];
    return m_targets[t].node == no_node ? t != m_bends[b].target
                                        : m_targets[t].node != own.nodes[0] && m_targets[t].node != own.nodes[1];
  }

  static bool leaves(const std::vector<Vector>& edge, const std::array<std::vector<Vector>, 2>& parts)
  {
    const Vector direction = edge.back() - edge.front();
    const Vector before = at_distance(parts[0], parts[0].size() - 1, 0, length_of_chord, false) - edge.front();
    const Vector behind = at_distance(parts[1], 0, 1, length_of_chord, false) - edge.front();
    return direction.norm() >= least_edge && angle(direction, before) > least_angle
      && angle(direction, behind) > least_angle;
  }

  // the curves that the points which judge a bend may belong to, without its own
  std::vector<const std::vector<Vector>*> curves_near(std::size_t b) const
  {
    const double reach = radius_of_judgement + Curve_evidence::farthest;
    std::vector<const std::vector<Vector>*> result;
    for (std::size_t c = 0; c < m_network.curves.size(); ++c)
      if (c != m_bends[b].curve && m_network.curves[c].is_alive
          && m_boxes[c].squaredExteriorDistance(m_bends[b].place) < reach * reach)
        result.push_back(&m_network.curves[c].points);
    return result;
  }

  // the whole curve up to the corner, and from there
  std::array<std::vector<Vector>, 2> parts_at(const Bend& bend) const
  {
    const std::vector<Vector>& points = m_network.curves[bend.curve].points;
    std::array<std::vector<Vector>, 2> parts{bend.corner->polylines[0], bend.corner->polylines[1]};
    parts[0].insert(parts[0].begin(), points.begin(), points.begin() + bend.sides.first);
    parts[1].insert(parts[1].end(), points.begin() + bend.sides.last + 1, points.end());
    return parts;
  }

  void split(std::size_t b, const std::array<std::vector<Vector>, 2>& parts)
  {
    const std::size_t c = m_bends[b].curve, node = m_network.nodes.size();
    m_network.nodes.push_back(parts[0].back());
    if (m_network.curves[c].is_closed_without_node())
    {
      Network_curve& curve = m_network.curves[c];
      curve.points = parts[1];
      curve.points.insert(curve.points.end(), parts[0].begin() + 1, parts[0].end());
      curve.nodes = {node, node};
      set_tips(curve);
    }
    else
    {
      Network_curve second = m_network.curves[c];
      second.points = parts[1];
      second.nodes[0] = node;
      set_tip(second, 0);
      Network_curve& first = m_network.curves[c];
      first.points = parts[0];
      first.nodes[1] = node;
      set_tip(first, 1);
      m_network.curves.push_back(second);
      m_boxes.push_back(box_of(second.points));
    }
    m_boxes[c] = box_of(m_network.curves[c].points);
    m_split_curve = c;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_BEND_SHARPENER_H
