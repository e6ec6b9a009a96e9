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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CONTRACTED_CURVES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CONTRACTED_CURVES_H

#include <CGAL/Wireframe_extraction/internal/skeleton/Contraction.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/distinct_curves.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What the skeleton points around a front have found: which curves pass nearby, and where the front's own one goes on.
class Contracted_curves
{
  const Field_band& m_band;
  const Contraction* m_contraction; // null where points were contracted to single curves, which lie between two
  std::vector<std::size_t> m_ball;

  // Lengths in r. The balls whose points say something of the front's own curve, and of its neighbors.
  static constexpr double own_radius = 2.5, others_radius = 3.;
  static constexpr double farthest_along = 2.;
  // parabolas that turn by more (29 degrees) are not believed
  static constexpr double most_turn = 0.5;
  // the front's own curve passes it as near as feet of two points of one curve differ, within 26 degrees
  static constexpr double own_distance = 0.3, own_cosine = 0.9;
  // others are outside of its corridor, or cross it by 37 degrees or more
  static constexpr double other_cosine = 0.8;
  static constexpr std::size_t most_others = 30, least_own = 3;
  // near points count more, up to half an r; residuals below 0.05 r are equal
  static constexpr double half_length = 0.5, equal_residual = 0.05;

public:
  Contracted_curves(const Field_band& band, const Contraction* contraction)
    : m_band(band), m_contraction(contraction && contraction->has_several_curves ? contraction : nullptr)
  {}

  bool is_known() const { return m_contraction != nullptr; }

  // the curves near the front that are not its own, moved to it
  std::vector<Local_curve> others(const Local_curve& front, double corridor)
  {
    m_band.search.query(front.point, others_radius, m_ball);
    sort_by_distance(m_ball, m_band.points, front.point);
    std::vector<Local_curve> found;
    for (std::size_t i : m_ball)
    {
      if (i >= m_band.skeleton_size || !reaches(m_contraction->curves[i], front.point))
        continue;
      Local_curve curve = m_contraction->curves[i];
      curve.move_along_to(front.point);
      if (std::abs(curve.tangent.dot(front.tangent)) < other_cosine || (curve.point - front.point).norm() > corridor)
        found.push_back(curve);
    }
    return distinct_curves(found, front.point, most_others);
  }

  // Moves the front to the mean of what the points around have found of its curve. Returns whether there are enough.
  bool agree_on(Local_curve& front, double noise)
  {
    m_band.search.query(front.point, own_radius, m_ball);
    Vector point = Vector::Zero(), tangent = Vector::Zero(), bend = Vector::Zero();
    double total = 0.;
    std::size_t count = 0;
    for (std::size_t i : m_ball)
    {
      if (i >= m_band.skeleton_size || !reaches(m_contraction->curves[i], front.point))
        continue;
      Local_curve curve = m_contraction->curves[i];
      const double s = curve.parameter(front.point), residual = m_contraction->own_residuals[i];
      curve.move_along_to(front.point);
      const double cosine = curve.tangent.dot(front.tangent);
      if (std::abs(s) > farthest_along || std::abs(cosine) < own_cosine
          || (curve.point - front.point).norm() > own_distance + noise)
        continue;
      const double weight =
        1. / ((half_length * half_length + s * s) * (equal_residual * equal_residual + residual * residual));
      point += weight * curve.point;
      tangent += (cosine < 0. ? -weight : weight) * curve.tangent;
      bend += weight * curve.bend;
      total += weight;
      ++count;
    }
    if (count < least_own)
      return false;
    front.point = point / total;
    front.tangent = tangent.normalized();
    front.bend = bend / total - bend.dot(front.tangent) / total * front.tangent;
    return true;
  }

private:
  static bool reaches(const Local_curve& curve, const Vector& p)
  {
    return std::abs(curve.parameter(p)) * curve.bend.norm() < most_turn;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_CONTRACTED_CURVES_H
