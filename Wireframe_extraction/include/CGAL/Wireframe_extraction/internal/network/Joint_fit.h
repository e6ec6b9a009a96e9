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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Segment_grid.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/fit/Spline_network_fit.h>
#include <CGAL/Wireframe_extraction/internal/network/Curve_evidence.h>
#include <CGAL/Wireframe_extraction/internal/network/Joint_course.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Fits what two curves may be where they meet, a corner or a smooth course, to the points around that no other curve
// explains better.
class Joint_fit
{
public:
  typedef std::vector<Vector> Polyline;

private:
  // Lengths in r. Points as far off a curve as it may be that its fit needs.
  static constexpr double farthest_of_points = 2.;
  static constexpr double equal_distance = 0.2;    // as that to a curve before it was rounded
  static constexpr double samples_per_length = 5.; // of a circle of radius 1.5, chords are off by less than 0.004
  static constexpr std::size_t least_samples = 8;
  static constexpr int rounds = 3; // the knots that a tight bend needs come with the second

  Field_band m_band; // the points around
  double m_noise, m_radius, m_tolerance;
  Vector m_center;
  Extraction_options m_options;

public:
  // Courses are judged by the points within `radius` of `center`, by `tolerance`. `grid` has the curves of a network,
  // of which parts, `own`, meet at the center.
  Joint_fit(const Field_band& band, double noise, const Extraction_options& options, const Vector& center,
            double radius, double reach, double tolerance, const Segment_grid& grid, const std::vector<Polyline>& own)
    : m_noise(noise), m_radius(radius), m_tolerance(tolerance), m_center(center), m_options(options)
  {
    m_options.number_of_rounds = rounds;
    std::vector<std::size_t> ball;
    band.search.query(center, reach, ball);
    std::sort(ball.begin(), ball.end());
    for (std::size_t i : ball)
    {
      const Segment_grid::Hit hit =
        grid.nearest(band.points[i], farthest_of_points, [](const Segment_grid::Hit&) { return true; });
      const double distance = distance_to(own, band.points[i]);
      if (distance > farthest_of_points || distance > hit.distance + equal_distance)
        continue;
      m_band.points.push_back(band.points[i]);
      m_band.distances.push_back(band.distances[i]);
      if (!band.deviations.empty())
        m_band.deviations.push_back(band.deviations[i]);
    }
    m_band.skeleton_size = m_band.size();
    m_band.search.build(m_band.points, m_band.size());
  }

  std::size_t size() const { return m_band.size(); }

  // from the first points of `head` over its last, the first of `tail`, which is a corner
  Joint_course corner(const Polyline& head, const Polyline& tail, Progress& progress) const
  {
    return fit({head, tail}, {head.front(), head.back(), tail.back()}, progress);
  }

  Joint_course smooth(const Polyline& path, Progress& progress) const
  {
    return fit({path}, {path.front(), path.back()}, progress);
  }

  // how badly they explain the points
  double loss(const std::vector<Polyline>& polylines) const
  {
    std::vector<const Polyline*> pointers;
    for (const Polyline& polyline : polylines)
      pointers.push_back(&polyline);
    return Curve_evidence(m_band, m_noise, nullptr, m_tolerance).loss_around(m_center, m_radius, pointers);
  }

private:
  static double distance_to(const std::vector<Polyline>& polylines, const Vector& p)
  {
    double square = (std::numeric_limits<double>::infinity)();
    for (const Polyline& polyline : polylines)
      for (std::size_t k = 1; k < polyline.size(); ++k)
        square = (std::min)(square, squared_distance_to_segment(p, polyline[k - 1], polyline[k]));
    return std::sqrt(square);
  }

  // the polylines lead from each vertex to the next
  Joint_course fit(const std::vector<Polyline>& paths, const std::vector<Vector>& vertices, Progress& progress) const
  {
    std::vector<Fitted_curve> curves;
    for (std::size_t k = 0; k < paths.size(); ++k)
    {
      Fitted_curve curve;
      curve.path = paths[k];
      curve.vertices = {k, k + 1};
      curves.push_back(curve);
    }
    Spline_network_fit fit(m_band, m_noise, m_options, vertices, curves);
    fit.run(progress);
    Joint_course course;
    for (const Fitted_curve& curve : fit.curves())
      course.polylines.push_back(sample(curve.spline));
    course.loss = loss(course.polylines);
    return course;
  }

  static Polyline sample(const Cubic_spline& spline)
  {
    Polyline result;
    for (double t : spline.even_parameters(samples_per_length, least_samples))
      result.push_back(spline.at(t));
    return result;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_JOINT_FIT_H
