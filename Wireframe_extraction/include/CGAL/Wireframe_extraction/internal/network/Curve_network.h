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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_NETWORK_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_NETWORK_H

#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Traced_curve.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

constexpr std::size_t no_node = static_cast<std::size_t>(-1);

// A polyline between two nodes of a network. A closed one without node repeats its first point at the end.
struct Network_curve
{
  std::vector<Vector> points;
  std::array<std::size_t, 2> nodes = {no_node, no_node};
  std::array<Local_curve, 2> tips; // the outward course at the two ends
  std::array<bool, 2> ends_in_void = {false, false};
  bool is_alive = true;

  bool is_closed_without_node() const { return nodes[0] == no_node; }

  // whether a place on the curve is farther than `distance_to_ends` from them
  bool has_inside(const Vector& place, double distance_to_ends) const
  {
    return is_closed_without_node()
      || ((place - points.front()).norm() > distance_to_ends && (place - points.back()).norm() > distance_to_ends);
  }
};

// Curves that meet in nodes.
struct Curve_network
{
  std::vector<Vector> nodes;
  std::vector<Network_curve> curves;

  Curve_network() {}

  // open curves get nodes of their own
  explicit Curve_network(const std::vector<Traced_curve>& traced_curves)
  {
    for (const Traced_curve& traced : traced_curves)
    {
      Network_curve curve;
      curve.points = traced.points;
      if (!traced.is_closed)
        for (int e = 0; e < 2; ++e)
        {
          curve.nodes[e] = nodes.size();
          nodes.push_back(e == 0 ? traced.points.front() : traced.points.back());
          curve.tips[e] = traced.tips[e];
          curve.ends_in_void[e] = traced.ends_in_void[e];
        }
      curves.push_back(curve);
    }
  }

  // of the curves, null where one is no longer alive
  std::vector<const std::vector<Vector>*> polylines() const
  {
    std::vector<const std::vector<Vector>*> result;
    for (const Network_curve& curve : curves)
      result.push_back(curve.is_alive ? &curve.points : nullptr);
    return result;
  }

  // of the living curves, each with its index
  Segment_grid segments() const
  {
    Segment_grid grid;
    for (std::size_t c = 0; c < curves.size(); ++c)
      if (curves[c].is_alive)
        grid.add(c, curves[c].points);
    return grid;
  }

  // all (curve, end) pairs of the living curves, by node
  std::vector<std::vector<std::pair<std::size_t, int>>> incidences() const
  {
    std::vector<std::vector<std::pair<std::size_t, int>>> result(nodes.size());
    for (std::size_t c = 0; c < curves.size(); ++c)
      if (curves[c].is_alive)
        for (int e = 0; e < 2; ++e)
          if (curves[c].nodes[e] != no_node)
            result[curves[c].nodes[e]].emplace_back(c, e);
    return result;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CURVE_NETWORK_H
