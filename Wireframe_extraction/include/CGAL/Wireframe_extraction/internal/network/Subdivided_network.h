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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SUBDIVIDED_NETWORK_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SUBDIVIDED_NETWORK_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_network.h>
#include <CGAL/Wireframe_extraction/internal/network/find_corners.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The published way to a topological graph: one polyline per cluster of points, subdivided where the field disagrees
// with it most (eq. 2), whose ends join the nearest corners.
class Subdivided_network
{
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                                boost::property<boost::edge_weight_t, double>>
    Distance_graph;

  static constexpr std::size_t least_points = 3; // of a cluster: a closed curve needs as many
  // Half of what is cut out of a cluster to see whether its ends stay connected, in connection radii: more than 1 from
  // side to side, or points on the two sides of the cut are neighbors still.
  static constexpr double cut_by_connection = 1.5;

  const Field_band& m_band;
  const Extraction_options& m_options;
  Progress& m_progress;

public:
  Subdivided_network(const Field_band& band, const Extraction_options& options, Progress& progress)
    : m_band(band), m_options(options), m_progress(progress)
  {}

  // after cancelling, what was found so far
  Curve_network run(const std::vector<std::vector<std::size_t>>& clusters,
                    const std::vector<Corner_group>& corners) const
  {
    Curve_network network;
    for (const Corner_group& corner : corners)
      network.nodes.push_back(corner.center);
    std::size_t total = 0, done = 0;
    for (const std::vector<std::size_t>& cluster : clusters)
      total += cluster.size();
    for (const std::vector<std::size_t>& cluster : clusters)
    {
      if (!m_progress.reach(double(done) / double(total)))
        break;
      done += cluster.size();
      if (cluster.size() >= least_points)
        add(cluster, corners, network);
    }
    return network;
  }

private:
  void add(const std::vector<std::size_t>& cluster, const std::vector<Corner_group>& corners,
           Curve_network& network) const
  {
    const Distance_graph graph = neighbors(cluster);
    bool is_closed = false;
    std::vector<std::size_t> start = initial_polyline(cluster, graph, is_closed);
    if (start.size() < 2 || m_progress.is_cancelled())
      return;
    Network_curve curve;
    for (std::size_t k : start)
      curve.points.push_back(m_band.points[cluster[k]]);
    if (is_closed)
      curve.points.push_back(curve.points.front());
    subdivide(cluster, curve.points);
    if (m_progress.is_cancelled())
      return;
    if (!is_closed)
      for (int e = 0; e < 2; ++e)
        curve.nodes[e] = join_to_corner(curve.points, e, corners, network);
    network.curves.push_back(curve);
  }

  Distance_graph neighbors(const std::vector<std::size_t>& cluster) const
  {
    std::vector<Vector> positions;
    for (std::size_t i : cluster)
      positions.push_back(m_band.points[i]);
    const Ball_search search(positions);
    Distance_graph graph(cluster.size());
    std::vector<std::size_t> ball;
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      if (i % points_between_questions == 0 && !m_progress.goes_on())
        break;
      search.query(positions[i], m_options.connection_radius, ball);
      for (std::size_t j : ball)
        if (j < i)
          boost::add_edge(i, j, (positions[i] - positions[j]).norm(), graph);
    }
    return graph;
  }

  static std::vector<double> distances_from(std::size_t source, const Distance_graph& graph)
  {
    std::vector<double> distances(boost::num_vertices(graph));
    boost::dijkstra_shortest_paths(graph, source, boost::distance_map(distances.data()));
    return distances;
  }

  // of the points that can be reached
  static std::size_t farthest(const std::vector<double>& distances)
  {
    std::size_t best = 0;
    double largest = -1.;
    for (std::size_t i = 0; i < distances.size(); ++i)
      if (distances[i] < (std::numeric_limits<double>::max)() && distances[i] > largest)
      {
        largest = distances[i];
        best = i;
      }
    return best;
  }

  // two ends, or three points of a closed curve
  std::vector<std::size_t> initial_polyline(const std::vector<std::size_t>& cluster, const Distance_graph& graph,
                                            bool& is_closed) const
  {
    if (m_progress.is_cancelled())
      return {};
    const std::size_t a = farthest(distances_from(0, graph));
    const std::vector<double> from_a = distances_from(a, graph);
    const std::size_t b = farthest(from_a);
    const std::vector<double> from_b = distances_from(b, graph);
    // a point that is about as far from both ends as they are from each other lies on another way between them
    std::vector<double> detour(from_a.size());
    for (std::size_t i = 0; i < detour.size(); ++i)
      detour[i] = (std::min)(from_a[i], from_b[i]);
    std::size_t middle = farthest(detour);
    is_closed = is_cycle(cluster, graph, a, b, from_a, from_b);
    if (is_closed)
    {
      // the middle of the other half
      const Vector opposite = middle_of_path(cluster, a, b, from_a, from_b);
      double best = -1.;
      for (std::size_t i = 0; i < cluster.size(); ++i)
      {
        const double far = (std::min)(detour[i], (m_band.points[cluster[i]] - opposite).norm());
        if (far > best)
        {
          best = far;
          middle = i;
        }
      }
      return {a, b, middle};
    }
    if (m_options.end_detection == End_detection::GRAPH_DISTANCE)
      return a == b ? std::vector<std::size_t>() : std::vector<std::size_t>{a, b};
    return extremes_along_main_axis(cluster);
  }

  Vector middle_of_path(const std::vector<std::size_t>& cluster, std::size_t a, std::size_t b,
                        const std::vector<double>& from_a, const std::vector<double>& from_b) const
  {
    const double length = from_a[b];
    std::size_t middle = a;
    double best = (std::numeric_limits<double>::infinity)();
    for (std::size_t i = 0; i < cluster.size(); ++i)
    {
      const double off = (from_a[i] + from_b[i] - length) + std::abs(from_a[i] - from_b[i]);
      if (off < best)
      {
        best = off;
        middle = i;
      }
    }
    return m_band.points[cluster[middle]];
  }

  // whether the two ends stay connected when the middle of the shortest path between them is cut out
  bool is_cycle(const std::vector<std::size_t>& cluster, const Distance_graph& graph, std::size_t a, std::size_t b,
                const std::vector<double>& from_a, const std::vector<double>& from_b) const
  {
    const double cut = cut_by_connection * m_options.connection_radius;
    if (from_a[b] < 2. * cut) // which would take both ends
      return false;
    const Vector middle = middle_of_path(cluster, a, b, from_a, from_b);
    Distance_graph rest(cluster.size());
    const auto is_kept = [&](std::size_t i) { return (m_band.points[cluster[i]] - middle).norm() > cut; };
    for (const auto& edge : boost::make_iterator_range(boost::edges(graph)))
    {
      const std::size_t i = boost::source(edge, graph), j = boost::target(edge, graph);
      if (is_kept(i) && is_kept(j))
        boost::add_edge(i, j, 1., rest);
    }
    return distances_from(a, rest)[b] < (std::numeric_limits<double>::max)();
  }

  std::vector<std::size_t> extremes_along_main_axis(const std::vector<std::size_t>& cluster) const
  {
    const auto position = [&](std::size_t i) -> const Vector& { return m_band.points[i]; };
    const Vector axis = principal_axes(scatter(cluster, position).matrix).axes[2];
    std::size_t low = 0, high = 0;
    for (std::size_t k = 1; k < cluster.size(); ++k)
    {
      const double s = m_band.points[cluster[k]].dot(axis);
      if (s < m_band.points[cluster[low]].dot(axis))
        low = k;
      if (s > m_band.points[cluster[high]].dot(axis))
        high = k;
    }
    return low == high ? std::vector<std::size_t>() : std::vector<std::size_t>{low, high};
  }

  // eq. 2
  void subdivide(const std::vector<std::size_t>& cluster, std::vector<Vector>& polyline) const
  {
    while (polyline.size() < cluster.size() && m_progress.goes_on())
    {
      double worst = m_options.split_threshold;
      std::size_t split = cluster.size(), after = 0;
      for (std::size_t k = 0; k < cluster.size(); ++k)
      {
        const Vector& p = m_band.points[cluster[k]];
        double least = (std::numeric_limits<double>::infinity)(), nearest = least;
        std::size_t segment = 0;
        for (std::size_t s = 1; s < polyline.size(); ++s)
        {
          const double distance = std::sqrt(squared_distance_to_segment(p, polyline[s - 1], polyline[s]));
          least = (std::min)(least, std::abs(m_band.distances[cluster[k]] - distance));
          if (distance < nearest)
          {
            nearest = distance;
            segment = s;
          }
        }
        if (least > worst)
        {
          worst = least;
          split = k;
          after = segment;
        }
      }
      if (split == cluster.size())
        return;
      polyline.insert(polyline.begin() + after, m_band.points[cluster[split]]);
    }
  }

  std::size_t join_to_corner(std::vector<Vector>& polyline, int e, const std::vector<Corner_group>& corners,
                             Curve_network& network) const
  {
    const Vector end = e == 0 ? polyline.front() : polyline.back();
    double nearest = m_options.corner_reach;
    std::size_t node = no_node;
    for (std::size_t c = 0; c < corners.size(); ++c)
    {
      const double distance = (corners[c].center - end).norm() - corners[c].radius;
      if (distance < nearest)
      {
        nearest = distance;
        node = c;
      }
    }
    if (node == no_node)
    {
      network.nodes.push_back(end);
      return network.nodes.size() - 1;
    }
    polyline.insert(e == 0 ? polyline.begin() : polyline.end(), corners[node].center);
    return node;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_SUBDIVIDED_NETWORK_H
