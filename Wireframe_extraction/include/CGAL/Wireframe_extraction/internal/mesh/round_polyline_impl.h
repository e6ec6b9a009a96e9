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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUND_POLYLINE_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUND_POLYLINE_IMPL_H

#include <CGAL/Wireframe_extraction/internal/mesh/round_polyline.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Tells which segments of a polyline are chords of arcs, and rounds them.
class Polyline_rounder
{
public:
  explicit Polyline_rounder(const std::vector<Vector>& polyline)
    : m_points(polyline), m_is_closed(polyline.size() > 3 && polyline.front() == polyline.back())
  {
    const std::size_t n = number_of_segments();
    for (std::size_t i = 0; i < n; ++i)
    {
      m_lengths.push_back((m_points[i + 1] - m_points[i]).norm());
      m_turns.push_back(turn_at(i));
    }
    m_turns.push_back(m_is_closed ? m_turns.front() : Turn());
    for (std::size_t i = 0; i < n; ++i)
      m_angles.push_back(angle_between_turns(i));
    if (!m_is_closed && n > 2)
    {
      m_angles.front() = angle_at_end(0, 1, m_turns[1]);
      m_angles.back() = angle_at_end(n - 1, n - 2, m_turns[n - 1]);
    }
  }

  std::vector<Vector> round() const
  {
    std::vector<Vector> result = {m_points.front()};
    for (std::size_t i = 0; i < number_of_segments(); ++i)
    {
      add_arc(i, result);
      result.push_back(m_points[i + 1]);
    }
    return result;
  }

private:
  // where two segments meet
  struct Turn
  {
    double angle = 0.;              // radians
    Vector inward = Vector::Zero(); // the direction in which the polyline is bent
  };

  static constexpr double same_length = 1.8; // chords of an arc differ in their lengths by no more than this factor
  static constexpr double same_turn = 0.7;   // and the turns at both their ends at least by this one;
  static constexpr double tangential = 0.35; // at the end of an arc a line turns half as much
  static constexpr double finest = 0.03;     // radians: the angle of the arcs of the result

  std::size_t number_of_segments() const { return m_points.size() - 1; }

  Turn turn_at(std::size_t i) const
  {
    Turn turn;
    if (i == 0 && !m_is_closed)
      return turn;
    const Vector before = m_points[i] - m_points[i > 0 ? i - 1 : number_of_segments() - 1];
    const Vector behind = m_points[i + 1] - m_points[i];
    const Vector a = before.normalized(), b = behind.normalized();
    turn.angle = std::acos((std::max)(-1., (std::min)(1., a.dot(b))));
    if ((b - a).norm() > 0.)
      turn.inward = (b - a).normalized();
    return turn;
  }

  bool are_alike(std::size_t i, std::size_t j) const
  {
    return m_lengths[i] <= same_length * m_lengths[j] && m_lengths[j] <= same_length * m_lengths[i];
  }

  // the angle of the arc of a segment with neighbors, 0 if it is a line
  double angle_between_turns(std::size_t i) const
  {
    const std::size_t n = number_of_segments();
    if (!m_is_closed && (i == 0 || i + 1 == n))
      return 0.;
    const Turn &one = m_turns[i], &other = m_turns[i + 1];
    const double least = (std::min)(one.angle, other.angle), most = (std::max)(one.angle, other.angle);
    if (!(least > tangential * most) || !(one.inward.dot(other.inward) > 0.5))
      return 0.;
    const std::size_t neighbor = one.angle > other.angle ? (i + n - 1) % n : (i + 1) % n; // where it turns more
    if (!are_alike(i, neighbor) && !(least > same_turn * most && are_alike(i, (2 * i + n - neighbor) % n)))
      return 0.;
    return least > same_turn * most ? 0.5 * (least + most) : most;
  }

  // the same for a segment at an end
  double angle_at_end(std::size_t i, std::size_t neighbor, const Turn& turn) const
  {
    const double angle = m_angles[neighbor];
    return are_alike(i, neighbor) && turn.angle > same_turn * angle && same_turn * turn.angle < angle ? angle : 0.;
  }

  void add_arc(std::size_t i, std::vector<Vector>& result) const
  {
    const double angle = m_angles[i];
    const std::size_t pieces = static_cast<std::size_t>(std::ceil(angle / finest));
    if (pieces < 2)
      return;
    const Vector step = m_points[i + 1] - m_points[i], along = step / m_lengths[i];
    Vector outward = -(m_turns[i].inward + m_turns[i + 1].inward);
    outward -= outward.dot(along) * along;
    if (!(outward.norm() > 0.))
      return;
    outward.normalize();
    const double radius = 0.5 * m_lengths[i] / std::sin(0.5 * angle);
    for (std::size_t k = 1; k < pieces; ++k)
    {
      const double place = angle * (double(k) / double(pieces) - 0.5);
      result.push_back(0.5 * (m_points[i] + m_points[i + 1]) + radius * std::sin(place) * along
                       + radius * (std::cos(place) - std::cos(0.5 * angle)) * outward);
    }
  }

  const std::vector<Vector>& m_points;
  const bool m_is_closed;
  std::vector<double> m_lengths, m_angles; // of the segments
  std::vector<Turn> m_turns;               // at the points
};

CGAL_WIREFRAME_EXTRACTION_INLINE std::vector<Vector> round_polyline(const std::vector<Vector>& polyline)
{
  return polyline.size() < 4 ? polyline : Polyline_rounder(polyline).round();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_ROUND_POLYLINE_IMPL_H
