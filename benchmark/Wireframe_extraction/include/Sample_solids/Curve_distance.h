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

#ifndef SAMPLE_SOLIDS_CURVE_DISTANCE_H
#define SAMPLE_SOLIDS_CURVE_DISTANCE_H

#include <Sample_solids/Solid.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace Sample_solids {

/// The exact distance to the nearest of many curves, by a tree of the bounding boxes of pieces of them.
/// Lines, circles and arcs answer in closed form, polylines by their segments, other curves by bracketing the
/// foot point on a short piece.
/// A query takes logarithmic time in the number of pieces. The curves must outlive the object.
class Curve_distance
{
public:
  Curve_distance(const std::vector<Curve>& curves, const std::vector<std::size_t>& selected) : m_curves(&curves)
  {
    for (std::size_t i : selected)
      add_pieces(i);
    if (!m_pieces.empty())
      build(0, m_pieces.size());
  }

  /// returns the distance of `p` to the nearest curve, or `bound` if that is smaller.
  double operator()(const Point& p, double bound) const
  {
    double best = bound;
    if (!m_nodes.empty())
      search(0, p, best);
    return best;
  }

private:
  struct Box
  {
    Point low = {{1e300, 1e300, 1e300}}, high = {{-1e300, -1e300, -1e300}};

    void add(const Point& p, double margin)
    {
      for (int k = 0; k < 3; ++k)
      {
        low[k] = (std::min)(low[k], p[k] - margin);
        high[k] = (std::max)(high[k], p[k] + margin);
      }
    }

    void add(const Box& other)
    {
      add(other.low, 0);
      add(other.high, 0);
    }

    double squared_distance_to(const Point& p) const
    {
      double sum = 0;
      for (int k = 0; k < 3; ++k)
      {
        const double d = (std::max)(0., (std::max)(low[k] - p[k], p[k] - high[k]));
        sum += d * d;
      }
      return sum;
    }
  };

  struct Piece
  {
    std::size_t curve;
    double low, high; ///< parameters; of a polyline the indices of two neighbouring points
    Box box;
  };

  struct Node
  {
    Box box;
    std::size_t begin = 0, end = 0;  ///< the pieces, of a leaf
    std::size_t left = 0, right = 0; ///< the children; 0 for a leaf
  };

  void add_pieces(std::size_t index)
  {
    const Curve& curve = (*m_curves)[index];
    for (std::size_t i = 0; i + 1 < curve.polyline.size(); ++i)
    {
      Piece piece = {index, double(i), double(i + 1), Box()};
      piece.box.add(curve.polyline[i], 0);
      piece.box.add(curve.polyline[i + 1], 0);
      m_pieces.push_back(piece);
    }
    if (!curve.polyline.empty())
      return;
    const int n = curve.kind == Curve_kind::LINE ? 1
      : curve.kind == Curve_kind::ARC            ? 2
      : curve.kind == Curve_kind::CIRCLE         ? 8
                                                 : 512;
    for (int i = 0; i < n; ++i)
    {
      Piece piece = {index, double(i) / n, double(i + 1) / n, Box()};
      const int m = curve.kind == Curve_kind::LINE ? 1 : 16;
      for (int k = 0; k <= m; ++k)
      {
        const double t = piece.low + (piece.high - piece.low) * k / m;
        const double chord = distance(curve.at(piece.low), curve.at(piece.high));
        // between samples the curve leaves their box by less than a small part of the chord
        piece.box.add(curve.at(t), curve.kind == Curve_kind::LINE ? 0. : 0.05 * chord);
      }
      m_pieces.push_back(piece);
    }
  }

  std::size_t build(std::size_t begin, std::size_t end)
  {
    const std::size_t index = m_nodes.size();
    m_nodes.push_back(Node());
    Box box, centers;
    for (std::size_t i = begin; i < end; ++i)
    {
      box.add(m_pieces[i].box);
      centers.add(0.5 * (m_pieces[i].box.low + m_pieces[i].box.high), 0);
    }
    m_nodes[index].box = box;
    if (end - begin <= 2)
    {
      m_nodes[index].begin = begin;
      m_nodes[index].end = end;
      return index;
    }
    const Point size = centers.high - centers.low;
    const auto longest = std::max_element(size.begin(), size.end());
    const std::size_t axis = static_cast<std::size_t>(longest - size.begin());
    const std::size_t middle = (begin + end) / 2;
    const auto at = [this](std::size_t i) { return m_pieces.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Piece& a, const Piece& b) {
      return a.box.low[axis] + a.box.high[axis] < b.box.low[axis] + b.box.high[axis];
    });
    const std::size_t left = build(begin, middle);
    const std::size_t right = build(middle, end);
    m_nodes[index].left = left;
    m_nodes[index].right = right;
    return index;
  }

  void search(std::size_t index, const Point& p, double& best) const
  {
    const Node& node = m_nodes[index];
    if (node.left == 0)
    {
      for (std::size_t i = node.begin; i < node.end; ++i)
        if (m_pieces[i].box.squared_distance_to(p) < best * best)
          best = (std::min)(best, distance_to_piece(m_pieces[i], p));
      return;
    }
    const double left = m_nodes[node.left].box.squared_distance_to(p);
    const double right = m_nodes[node.right].box.squared_distance_to(p);
    const bool is_left_first = left <= right;
    if ((std::min)(left, right) < best * best)
      search(is_left_first ? node.left : node.right, p, best);
    if ((std::max)(left, right) < best * best)
      search(is_left_first ? node.right : node.left, p, best);
  }

  double distance_to_piece(const Piece& piece, const Point& p) const
  {
    const Curve& curve = (*m_curves)[piece.curve];
    if (!curve.polyline.empty())
      return curve.distance_to_segment(p, static_cast<std::size_t>(piece.low));
    return curve.has_closed_form_distance() ? curve.closed_form_distance(p)
                                            : curve.local_distance(p, piece.low, piece.high);
  }

  const std::vector<Curve>* m_curves;
  std::vector<Piece> m_pieces;
  std::vector<Node> m_nodes;
};

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_CURVE_DISTANCE_H
