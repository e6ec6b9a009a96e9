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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_PARTS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_PARTS_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_network_fit.h>

#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Fits the connected parts of networks, each by itself, and keeps what it found: of a network of which some edges have
// changed since, the other parts need not be fitted again.
class Primitive_parts
{
  struct Part
  {
    Primitive_network_fit network;
    std::vector<std::size_t> edges, vertices; // in the whole network
  };

  struct Solution
  {
    std::vector<Vector> vertices;
    std::vector<std::array<Vector, 3>> points;
    std::vector<char> is_violated; // of the edges
  };

  std::map<std::vector<double>, Solution> m_known; // by all that determines it
  std::size_t m_number_of_fits = 0;

public:
  // how many parts were fitted so far
  std::size_t number_of_fits() const { return m_number_of_fits; }

  // Fits all parts, or those that regularities hold. After cancelling, the result is of no use.
  void run(Primitive_network_fit& network, Progress* progress, bool only_regular = false)
  {
    std::vector<Part> parts = split(network);
    std::vector<std::vector<double>> keys;
    std::vector<std::size_t> unknown;
    for (std::size_t k = 0; k < parts.size(); ++k)
    {
      const bool is_left = only_regular && parts[k].network.regularities.empty();
      keys.push_back(key(parts[k].network));
      if (!is_left && m_known.find(keys[k]) == m_known.end())
        unknown.push_back(k);
    }
    for_each_piece(
      unknown.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end && !(progress && progress->is_cancelled()); ++k)
          parts[unknown[k]].network.run(progress);
      },
      1);
    if (progress && progress->is_cancelled())
      return;
    for (const std::size_t k : unknown)
      m_known[keys[k]] = solution(parts[k].network);
    m_number_of_fits += unknown.size();
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!only_regular || !parts[k].network.regularities.empty())
        take_over(m_known[keys[k]], parts[k], network);
  }

private:
  static std::size_t root(std::vector<std::size_t>& parents, std::size_t i)
  {
    while (parents[i] != i)
      i = parents[i] = parents[parents[i]];
    return i;
  }

  // of each edge, which part it belongs to; parts are in the order of their first edges
  static std::vector<std::size_t> part_of_edge(const Primitive_network_fit& network, std::size_t& number_of_parts)
  {
    const std::size_t n = network.edges.size();
    std::vector<std::size_t> parents(n + network.vertices.size());
    std::iota(parents.begin(), parents.end(), std::size_t(0));
    const auto join = [&](std::size_t i, std::size_t j) { parents[root(parents, i)] = root(parents, j); };
    for (std::size_t k = 0; k < n; ++k)
      if (network.edges[k].has_vertex())
        for (const std::size_t v : network.edges[k].vertices)
          join(k, n + v);
    for (const Primitive_network_fit::Tangency& tangency : network.tangencies)
      join(tangency.edges[0], tangency.edges[1]);
    for (const Regularity& regularity : network.regularities)
      join(regularity.curves[0], regularity.curves[1]);
    std::vector<std::size_t> part_of_root(parents.size(), parents.size()), result;
    number_of_parts = 0;
    for (std::size_t k = 0; k < n; ++k)
    {
      std::size_t& part = part_of_root[root(parents, k)];
      if (part == parents.size())
        part = number_of_parts++;
      result.push_back(part);
    }
    return result;
  }

  static std::vector<Part> split(const Primitive_network_fit& network)
  {
    std::size_t number_of_parts;
    const std::vector<std::size_t> part_of = part_of_edge(network, number_of_parts);
    std::vector<Part> parts(number_of_parts);
    std::vector<std::size_t> edge_index, vertex_index(network.vertices.size()),
      part_of_vertex(network.vertices.size(), number_of_parts);
    for (std::size_t k = 0; k < network.edges.size(); ++k)
    {
      Part& part = parts[part_of[k]];
      edge_index.push_back(part.edges.size());
      part.edges.push_back(k);
      part.network.edges.push_back(network.edges[k]);
      if (!network.edges[k].has_vertex())
        continue;
      for (std::size_t& v : part.network.edges.back().vertices)
      {
        if (part_of_vertex[v] == number_of_parts)
        {
          part_of_vertex[v] = part_of[k];
          vertex_index[v] = part.vertices.size();
          part.vertices.push_back(v);
          part.network.vertices.push_back(network.vertices[v]);
        }
        v = vertex_index[v];
      }
    }
    for (Primitive_network_fit::Tangency tangency : network.tangencies)
    {
      Part& part = parts[part_of[tangency.edges[0]]];
      tangency.vertex = vertex_index[tangency.vertex];
      for (std::size_t& k : tangency.edges)
        k = edge_index[k];
      part.network.tangencies.push_back(tangency);
    }
    for (Primitive_network_fit::Spline_end end : network.spline_ends)
      if (part_of_vertex[end.vertex] < number_of_parts)
      {
        Part& part = parts[part_of_vertex[end.vertex]];
        end.vertex = vertex_index[end.vertex];
        part.network.spline_ends.push_back(end);
      }
    for (Regularity regularity : network.regularities)
    {
      Part& part = parts[part_of[regularity.curves[0]]];
      for (std::size_t& k : regularity.curves)
        k = edge_index[k];
      part.network.regularities.push_back(regularity);
    }
    return parts;
  }

  static void append(std::initializer_list<Vector> vectors, std::vector<double>& key)
  {
    for (const Vector& v : vectors)
      key.insert(key.end(), {v.x(), v.y(), v.z()});
  }

  // all that the fit starts from; of its stations, which are runs of those of a curve, how many,
  // and the first and the last
  static std::vector<double> key(const Primitive_network_fit& network)
  {
    std::vector<double> key{double(network.vertices.size()), double(network.edges.size()),
                            double(network.tangencies.size()), double(network.spline_ends.size())};
    for (const Vector& v : network.vertices)
      append({v}, key);
    for (const Primitive_edge& edge : network.edges)
    {
      key.insert(key.end(),
                 {double(edge.kind), double(edge.vertices[0]), double(edge.vertices[1]), double(edge.stations.size())});
      append(
        {edge.points[0], edge.points[1], edge.points[2], edge.stations.front().position, edge.stations.back().position},
        key);
    }
    for (const Primitive_network_fit::Tangency& tangency : network.tangencies)
      key.insert(key.end(), {double(tangency.vertex), double(tangency.edges[0]), double(tangency.edges[1])});
    for (const Primitive_network_fit::Spline_end& end : network.spline_ends)
    {
      key.insert(key.end(), {double(end.vertex), end.deviation});
      append({end.position, end.tangent}, key);
    }
    for (const Regularity& regularity : network.regularities)
      key.insert(key.end(), {double(regularity.kind), double(regularity.curves[0]), double(regularity.curves[1])});
    return key;
  }

  static Solution solution(const Primitive_network_fit& network)
  {
    Solution result;
    result.vertices = network.vertices;
    for (std::size_t k = 0; k < network.edges.size(); ++k)
    {
      result.points.push_back(network.edges[k].points);
      result.is_violated.push_back(network.is_violated(k));
    }
    return result;
  }

  static void take_over(const Solution& solution, const Part& part, Primitive_network_fit& network)
  {
    for (std::size_t i = 0; i < part.vertices.size(); ++i)
      network.vertices[part.vertices[i]] = solution.vertices[i];
    for (std::size_t i = 0; i < part.edges.size(); ++i)
    {
      network.edges[part.edges[i]].points = solution.points[i];
      network.set_violated(part.edges[i], solution.is_violated[i] != 0);
    }
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_PARTS_H
