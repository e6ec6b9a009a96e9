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

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Curve_sampling.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Plain_wireframe.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
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

  // Samples such that no piece leaves its curve by more than the tolerance, and none is longer than the step, if there
  // is one. A line is one piece.
  template <class GeomTraits>
  bool sample_by_chords(const CGAL::Wireframe<GeomTraits>& wireframe, const Curve_sampling& sampling,
                        const GeomTraits& traits, std::string& error)
  {
    error = wireframe_problem(wireframe, traits);
    if (!error.empty())
      return false;
    for (const auto& vertex : wireframe.vertices)
      points.push_back(coordinates_of(vertex, traits));
    for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    {
      const auto& curve = wireframe.curves[i];
      if (curve.spline.degree() == 1 && !sampling.step)
      {
        add_polyline(curve, curve.spline.control_points(), traits); // which it is
        continue;
      }
      double number = pieces_within(curve, *sampling.chord_tolerance, traits);
      if (sampling.step)
        number = (std::max)(number, number_of_steps(curve, *sampling.step));
      if (!(number <= most_steps))
      {
        error = "curve " + std::to_string(i) + " cannot be sampled with a chord tolerance of "
          + number_to_string(*sampling.chord_tolerance) + ": it is too long for that; give a larger chord_tolerance";
        return false;
      }
      add_pieces(curve, number, traits);
    }
    return true;
  }

private:
  static constexpr double most_steps = 1e7; // hundreds of megabytes
  // how many times as many the law of the errors has to ask for to be believed before they are tried
  static constexpr double far_beyond = 4.;

  // fewer would fold a closed curve into a point or a segment
  template <class GeomTraits>
  static double least_pieces(const Wireframe_curve<GeomTraits>& curve)
  {
    return curve.is_closed() ? 3. : 1.;
  }

  template <class GeomTraits>
  static double number_of_steps(const Wireframe_curve<GeomTraits>& curve, double step)
  {
    static constexpr double rounding = 1e-12; // a length of a whole number of steps makes no more pieces
    return std::ceil(CGAL::to_double(curve.spline.length()) / step * (1. - rounding));
  }

  // How many pieces of one length keep to the tolerance: doubled until they do, and as the error falls with the square
  // of their number, reduced again. Infinitely many if it will not be reached with a number that can be had.
  template <class GeomTraits>
  static double pieces_within(const Wireframe_curve<GeomTraits>& curve, double tolerance, const GeomTraits& traits)
  {
    double number = least_pieces(curve);
    double deviation = deviation_of_pieces(curve, number, traits);
    for (; deviation > tolerance && number <= most_steps; deviation = deviation_of_pieces(curve, number, traits))
      if (number * std::sqrt(deviation / tolerance) > far_beyond * most_steps)
        return (std::numeric_limits<double>::infinity)();
      else
        number *= 2.;
    const double fewer = (std::max)(least_pieces(curve), std::ceil(number * std::sqrt(deviation / tolerance)));
    return fewer < number && deviation_of_pieces(curve, fewer, traits) <= tolerance ? fewer : number;
  }

  // how far the curve is from its pieces, at several places of each
  template <class GeomTraits>
  static double deviation_of_pieces(const Wireframe_curve<GeomTraits>& curve, double number, const GeomTraits& traits)
  {
    static constexpr std::size_t places = 4;
    if (curve.type == Wireframe_curve_type::LINE || !(number <= most_steps))
      return 0.;
    std::vector<typename GeomTraits::Point_3> samples;
    curve.spline.sample_by_count(static_cast<std::size_t>(number) * places + 1, std::back_inserter(samples));
    double largest = 0.;
    for (std::size_t i = 0; i + places < samples.size(); i += places)
    {
      const Spline_vector a = vector_of(samples[i], traits), chord = vector_of(samples[i + places], traits) - a;
      for (std::size_t k = 1; k < places; ++k)
      {
        const Spline_vector offset = vector_of(samples[i + k], traits) - a;
        const double squared = dot(chord, chord);
        const double t = squared > 0. ? (std::min)(1., (std::max)(0., dot(offset, chord) / squared)) : 0.;
        largest = (std::max)(largest, norm(offset - t * chord));
      }
    }
    return largest;
  }

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
    const double number = number_of_steps(curve, step);
    // fails for what is not a number, too
    if (!(number <= most_steps))
      return false;
    add_pieces(curve, (std::max)(number, least_pieces(curve)), traits);
    return true;
  }

  template <class GeomTraits>
  void add_pieces(const Wireframe_curve<GeomTraits>& curve, double number, const GeomTraits& traits)
  {
    const std::size_t count = static_cast<std::size_t>(number) + 1;
    std::vector<typename GeomTraits::Point_3> samples;
    samples.reserve(count);
    curve.spline.sample_by_count(count, std::back_inserter(samples));

    add_polyline(curve, samples, traits);
  }

  template <class GeomTraits>
  void add_polyline(const Wireframe_curve<GeomTraits>& curve, const std::vector<typename GeomTraits::Point_3>& samples,
                    const GeomTraits& traits)
  {
    std::vector<std::size_t> polyline;
    polyline.reserve(samples.size());
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      polyline.push_back(i == 0 && has_vertex(curve) ? curve.source : add_point(coordinates_of(samples[i], traits)));
    polyline.push_back(has_vertex(curve) ? curve.target : polyline.front());
    polylines.push_back(polyline);
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

// the same with what named parameters say
inline bool sample_wireframe(const Plain_wireframe& wireframe, const Curve_sampling& sampling,
                             Sampled_wireframe& sampled, std::string& error)
{
  const auto is_wrong = [](const std::optional<double>& value) {
    return value && !(*value > 0. && std::isfinite(*value));
  };
  if (is_wrong(sampling.step))
    error = "sampling_step is " + number_to_string(*sampling.step) + "; it has to be finite and positive";
  else if (is_wrong(sampling.chord_tolerance))
    error = "chord_tolerance is " + number_to_string(*sampling.chord_tolerance) + "; it has to be finite and positive";
  else if (sampling.chord_tolerance)
    return sampled.sample_by_chords(wireframe, sampling, Plain_traits(), error);
  else
    return sampled.sample(wireframe, sampling.step.value_or(0.), Plain_traits(), error);
  return false;
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
