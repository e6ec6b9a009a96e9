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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_SAMPLED_WIREFRAME_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_SAMPLED_WIREFRAME_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// The curves of a wireframe as polylines over one list of points. The vertices of the wireframe are its first
// points, so that curves which share a vertex share a point. A closed polyline ends with the index it starts
// with.
class Sampled_wireframe
{
public:
  std::vector<Coordinates> points;
  std::vector<std::vector<std::size_t>> polylines;

  // samples by arc length; a step of 0 stands for the default
  template <class GeomTraits>
  bool sample(const CGAL::Wireframe<GeomTraits>& wireframe, double step, const GeomTraits& traits, std::string& error)
  {
    error = wireframe_problem(wireframe, traits);
    if (error.empty() && !(step >= 0. && std::isfinite(step)))
      error = "sampling_step is " + number_to_string(step) + "; it has to be finite and positive";
    if (!error.empty())
      return false;
    if (step == 0.)
      step = default_step(wireframe);
    for (const auto& vertex : wireframe.vertices)
      points.push_back(coordinates_of(vertex, traits));
    for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
      if (!sample_curve(wireframe.curves[i], step, traits))
      {
        error = "curve " + std::to_string(i) + " cannot be sampled at a step of " + number_to_string(step)
          + ": it is too long for that; give a larger sampling_step";
        return false;
      }
    return true;
  }

private:
  template <class GeomTraits>
  static double default_step(const CGAL::Wireframe<GeomTraits>& wireframe)
  {
    // A circle of radius 2 r is missed by 0.004 r. Without r, a curve of a hundred pieces looks smooth, and any step is
    // as good where no curve has a length.
    static constexpr double step_per_sampling_distance = 0.25, step_per_length = 0.01, any_step = 1.;
    const double sampling_distance = CGAL::to_double(wireframe.sampling_distance);
    if (sampling_distance > 0.)
      return step_per_sampling_distance * sampling_distance;
    double longest = 0.;
    for (const auto& curve : wireframe.curves)
      longest = (std::max)(longest, CGAL::to_double(curve.spline.length()));
    return longest > 0. ? step_per_length * longest : any_step;
  }

  template <class GeomTraits>
  bool sample_curve(const Wireframe_curve<GeomTraits>& curve, double step, const GeomTraits& traits)
  {
    static constexpr double rounding = 1e-12; // a length of a whole number of steps makes no more pieces
    static constexpr double most_steps = 1e7; // hundreds of megabytes
    const double number_of_steps = std::ceil(CGAL::to_double(curve.spline.length()) / step * (1. - rounding));
    // fails for what is not a number, too
    if (!(number_of_steps <= most_steps))
      return false;
    // fewer would fold a closed curve into a point or a segment
    const std::size_t least = curve.is_closed() ? 3 : 1;
    const std::size_t count = (std::max)(static_cast<std::size_t>(number_of_steps), least) + 1;
    std::vector<typename GeomTraits::Point_3> samples;
    samples.reserve(count);
    curve.spline.sample_by_count(count, std::back_inserter(samples));

    std::vector<std::size_t> polyline;
    polyline.reserve(count);
    for (std::size_t i = 0; i + 1 < count; ++i)
      polyline.push_back(i == 0 && has_vertex(curve) ? curve.source : add_point(coordinates_of(samples[i], traits)));
    polyline.push_back(has_vertex(curve) ? curve.target : polyline.front());
    polylines.push_back(polyline);
    return true;
  }

  template <class GeomTraits>
  static bool has_vertex(const Wireframe_curve<GeomTraits>& curve)
  {
    return curve.source != Wireframe_curve<GeomTraits>::no_vertex;
  }

  std::size_t add_point(const Coordinates& point)
  {
    points.push_back(point);
    return points.size() - 1;
  }
};

// the same with what the named parameter `sampling_step` says, if there is one
inline bool sample_wireframe(const Plain_wireframe& wireframe, const std::optional<double>& step,
                             Sampled_wireframe& sampled, std::string& error)
{
  if (step && !(*step > 0.))
  {
    error = "sampling_step is " + number_to_string(*step) + "; it has to be finite and positive";
    return false;
  }
  return sampled.sample(wireframe, step.value_or(0.), Plain_traits(), error);
}

// "x y z" with all digits
inline std::string to_text(const Coordinates& point)
{
  return number_to_string(point[0]) + " " + number_to_string(point[1]) + " " + number_to_string(point[2]);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_SAMPLED_WIREFRAME_H
