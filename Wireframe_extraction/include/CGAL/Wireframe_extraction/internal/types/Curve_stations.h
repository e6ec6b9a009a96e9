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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_STATIONS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_STATIONS_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/polyline_feet.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Where the field has a piece of a curve: the place, and how firmly it is held in each direction across the curve.
struct Station
{
  double parameter = 0.;                   // arc length along the curve that was followed
  Vector position = Vector::Zero();        // where the field has the curve
  Vector followed = Vector::Zero();        // where the curve that was followed is
  Vector tangent = Vector::UnitX();        // of the curve that was followed
  Matrix_3 information = Matrix_3::Zero(); // inverse covariance of the position; 0 along the tangent
  std::size_t support = 0;                 // number of points

  static constexpr std::size_t least_support = 2; // points, with which it is a place that the field shows
  bool is_supported() const { return support >= least_support; }

  // the standard deviation of its position across the curve
  double deviation() const { return std::sqrt(2. / information.trace()); }
};

// A point of the band and its foot on a curve.
struct Curve_support
{
  std::size_t point;
  double parameter;
  Vector foot;
};

// Follows polylines through the field and tells, about every 1.5 sampling distances, where the field has them. The
// variance of a station is that of a single distance, which the noise level of the field tells, over the sum of its
// points' weights: the errors of the refined field, and those of points that share a patch of the surface, are alike
// over some sampling distances, so that the scatter within a station would promise too much.
class Curve_stations
{
  // Even an exact field is known at points only, and curves are sampled.
  static constexpr double least_deviation = 0.008; // r
  // Points that support a curve may lie farther from the spline than from the place where the field has it.
  static constexpr double most_shift = 1.; // r, from the spline to that place
  // Of the scale beyond which residuals lose weight: errors of fields have longer tails than the normal distribution.
  static constexpr double least_scale = 0.05, scale_per_noise = 1.5;
  // Points of which the field knows less count less; that of two small deviations one is twice the other means nothing.
  static constexpr double comparable_deviation = 0.03; // r, where fields count as precise
  // Distances far from a curve tell less of it: the curve is bent, and the error of the direction grows.
  static constexpr double weight_per_square = 0.5; // halves the weight at 1.4 r
  // Of the mean information, what is there in directions in which the points say nothing: holds
  // stations where they are.
  static constexpr double relative_damping = 0.02, least_damping = 1e-6;
  static constexpr int number_of_rounds = 4;        // of Gauss and Newton
  static constexpr double negligible_length = 1e-9; // r: such an offset has no direction

  const Field_band& m_band;
  double m_noise, m_support_distance;

public:
  // r: enough points for a place, and the smallest circle that a cloud shows, of radius r, has four stations
  static constexpr double spacing = 1.5;

  Curve_stations(const Field_band& band, double noise, double support_distance)
    : m_band(band), m_noise(noise), m_support_distance(support_distance)
  {}

  // for each polyline the points nearest to it, except those beyond its ends
  std::vector<std::vector<Curve_support>> find_support(const std::vector<std::vector<Vector>>& polylines) const
  {
    std::vector<std::vector<double>> lengths;
    for (const std::vector<Vector>& polyline : polylines)
      lengths.push_back(arc_lengths(polyline));
    const std::vector<Polyline_foot> feet =
      nearest_feet(m_band, pointers_to(polylines), m_support_distance + most_shift);
    std::vector<std::vector<Curve_support>> support(polylines.size());
    for (std::size_t i = 0; i < m_band.size(); ++i)
    {
      if (!feet[i].is_valid())
        continue;
      const std::size_t c = feet[i].curve;
      const std::vector<Vector>& polyline = polylines[c];
      const double u = feet[i].interpolate(lengths[c]);
      const bool is_closed = polyline.front() == polyline.back();
      if (is_closed || !is_at_end(u, lengths[c].back()))
        support[c].push_back({i, u, feet[i].point(polyline)});
    }
    return support;
  }

  // the stations of a polyline, in its order
  std::vector<Station> run(const std::vector<Vector>& polyline, const std::vector<Curve_support>& support) const
  {
    const std::vector<double> lengths = arc_lengths(polyline);
    const std::size_t count = (std::max)(std::size_t(1), static_cast<std::size_t>(lengths.back() / spacing));
    std::vector<std::vector<const Curve_support*>> members(count);
    for (const Curve_support& s : support)
    {
      const std::size_t i = static_cast<std::size_t>(s.parameter / lengths.back() * double(count));
      members[(std::min)(count - 1, i)].push_back(&s);
    }
    std::vector<Station> stations;
    Polyline_walk walk(polyline, lengths);
    for (std::size_t i = 0; i < count; ++i)
    {
      Station station;
      station.parameter = lengths.back() * (double(i) + 0.5) / double(count);
      station.position = walk.advance_to(station.parameter);
      station.tangent = walk.segment().normalized();
      locate(members[i], station);
      stations.push_back(station);
    }
    return stations;
  }

private:
  // moves the station across the curve until the residuals of its points are least
  void locate(const std::vector<const Curve_support*>& members, Station& station) const
  {
    const Vector across = station.tangent.unitOrthogonal(), up = station.tangent.cross(across);
    double shift[2] = {0., 0.};
    double normal_matrix[2][2];
    const double scale = least_scale + scale_per_noise * m_noise;
    for (int round = 0; round < number_of_rounds; ++round)
    {
      double right_side[2] = {0., 0.};
      for (auto& row : normal_matrix)
        row[0] = row[1] = 0.;
      station.support = 0;
      const Vector moved = shift[0] * across + shift[1] * up;
      for (const Curve_support* member : members)
      {
        const Vector offset = m_band.points[member->point] - member->foot - moved;
        const double length = offset.norm(), d = m_band.distances[member->point], e = d - length;
        if (length < negligible_length || std::abs(e) > residual_cutoff(m_noise))
          continue;
        const double worth =
          (comparable_deviation + m_noise) / (comparable_deviation + m_band.deviation(member->point, m_noise));
        const double weight = worth * worth / (1. + weight_per_square * d * d) / (1. + e * e / (scale * scale));
        const double gradient[2] = {offset.dot(across) / length, offset.dot(up) / length};
        for (int i = 0; i < 2; ++i)
        {
          for (int j = 0; j < 2; ++j)
            normal_matrix[i][j] += weight * gradient[i] * gradient[j];
          right_side[i] -= weight * e * gradient[i];
        }
        ++station.support;
      }
      // Where the points lie in one plane through the curve, they say nothing of the direction across it.
      const double damping = relative_damping * (normal_matrix[0][0] + normal_matrix[1][1]) + least_damping;
      const double a = normal_matrix[0][0] + damping, b = normal_matrix[0][1], c = normal_matrix[1][1] + damping;
      shift[0] += (c * right_side[0] - b * right_side[1]) / (a * c - b * b);
      shift[1] += (a * right_side[1] - b * right_side[0]) / (a * c - b * b);
      const double length = std::sqrt(shift[0] * shift[0] + shift[1] * shift[1]);
      if (length > most_shift)
        for (double& coordinate : shift)
          coordinate = most_shift * (coordinate / length);
    }
    station.followed = station.position;
    station.position += shift[0] * across + shift[1] * up;
    const Vector by_across = normal_matrix[0][0] * across + normal_matrix[1][0] * up;
    const Vector by_up = normal_matrix[0][1] * across + normal_matrix[1][1] * up;
    station.information = (Matrix_3::outer(by_across, across) + Matrix_3::outer(by_up, up))
      / (m_noise * m_noise + least_deviation * least_deviation);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_STATIONS_H
