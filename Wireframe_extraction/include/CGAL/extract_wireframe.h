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

#ifndef CGAL_EXTRACT_WIREFRAME_H
#define CGAL_EXTRACT_WIREFRAME_H

#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/recognize_curve_types.h>
#include <CGAL/Wireframe_extraction/refine_field.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>

#include <CGAL/Real_timer.h>
#include <CGAL/number_utils.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Reads the cloud for the first time; returns false, with a message, if it cannot be read or has points that must not
// be skipped.
inline bool survey(Surveyed_cloud& cloud, bool skip_invalid, Wireframe_extraction_report& report)
{
  const bool is_read = cloud.survey();
  const std::size_t invalid = cloud.number_of_not_finite() + cloud.number_of_negative();
  report.number_of_points = cloud.number_of_points();
  report.number_of_skipped_points = invalid;
  std::ostringstream message;
  if (!is_read)
    message << cloud.error();
  else if (cloud.number_of_points() == 0)
    message << "the cloud has no points; a wireframe needs points of a surface";
  else if (invalid > 0 && !skip_invalid)
    message << cloud.number_of_not_finite() << " points have coordinates or distances that are not finite and "
            << cloud.number_of_negative() << " have negative distances; the first is the point with index "
            << cloud.first_invalid() << " (counted from 0); remove them, or leave them out by skip_invalid(true)";
  else if (cloud.number_of_valid() == 0)
    message << "none of the " << cloud.number_of_points() << " points is valid; repair coordinates and distances";
  report.message = message.str();
  return report.message.empty();
}

// The dimension of the affine hull, up to rounding, of some points without the outermost tenth: a single outlier must
// not make the rest look like a point.
inline int dimension(const std::vector<Vector>& positions, const std::vector<std::size_t>& sample)
{
  Vector center;
  double largest = 0.;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> coordinates;
    for (std::size_t i : sample) {
      coordinates.push_back(positions[i][k]);
      largest = (std::max)(largest, std::abs(positions[i][k]));
    }
    center[k] = median(coordinates);
  }
  std::vector<Vector> offsets;
  double extent = 0.;
  for (std::size_t i : sample)
    offsets.push_back(positions[i] - center);
  std::sort(offsets.begin(), offsets.end(), [](const Vector& a, const Vector& b) {
    return a.stableNorm() < b.stableNorm();
  });
  offsets.resize((std::max)(std::size_t(1), offsets.size() - offsets.size() / 10));
  extent = offsets.back().stableNorm();
  if (!(extent > 1e-12 * largest))
    return 0;
  Vector mean = Vector::Zero();
  for (Vector& offset : offsets) {
    offset /= extent;
    mean += offset / double(offsets.size());
  }
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Vector& offset : offsets)
    covariance += (offset - mean) * (offset - mean).transpose() / double(offsets.size());
  const Vector variances = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues();
  return int(variances[0] > 1e-14) + int(variances[1] > 1e-14) + int(variances[2] > 1e-14);
}

inline int dimension(const std::vector<Vector>& positions)
{
  const int result = dimension(positions, spread_indices(positions.size()));
  if (result > 1)
    return result;
  // scanners write many points at one place: those count once
  const std::vector<std::size_t> different = different_positions(positions);
  std::vector<std::size_t> sample = spread_indices(different.size());
  for (std::size_t& i : sample)
    i = different[i];
  return dimension(positions, sample);
}

// whether points, distances and a sampling distance given by the caller (or 0) have the same unit
inline bool check_scale(const Surveyed_cloud& cloud, const Cloud_scale& scale, double given,
                        Wireframe_extraction_report& report)
{
  std::ostringstream message;
  if (cloud.smallest_distance() == cloud.largest_distance())
    message << "all distances are " << cloud.smallest_distance() << ": this is no distance field; "
            << "give each point its own distance to the nearest sharp curve";
  else if (scale.slope > 8.)
    message << "the distances do not fit the points: from point to point they change " << scale.slope
            << " times as much as the points are apart; are they in another unit?";
  else if (scale.slope < 0.1)
    message << "the distances do not fit the points: from point to point they change only " << scale.slope
            << " times as much as the points are apart; are they in another unit?";
  else if (!(given >= 0.) || !std::isfinite(given))
    message << "the sampling distance must be positive and finite, not " << given;
  else if (given > 10. * scale.sampling_distance || (given > 0. && given < 0.1 * scale.sampling_distance))
    message << "a sampling distance of " << given << " does not fit the points: their density says "
            << scale.sampling_distance << "; is it in another unit?";
  report.message = message.str();
  return report.message.empty();
}

inline std::string no_feature_message(const Surveyed_cloud& cloud, double unit, double threshold)
{
  const double smallest = cloud.smallest_distance();
  std::ostringstream message;
  message << "no point lies near a feature: the smallest distance is " << smallest << ", the threshold is "
          << threshold * unit << " (" << threshold << " times the sampling distance " << unit << ")";
  if (smallest > 50. * unit)
    message << "; are the distances in another unit than the points?";
  return message.str();
}

template <class T> T& referred(T& object) { return object; }
template <class T> T& referred(std::reference_wrapper<T>& reference) { return reference.get(); }

// Runs the stages, keeps the time, and stops where the callback says so.
class Stage_runner
{
  std::function<bool(double)> m_callback;
  Wireframe_extraction_report& m_report;
  double m_begin = 0., m_end = 0.;
  bool m_is_cancelled = false;

public:
  Stage_runner(const std::function<bool(double)>& callback, Wireframe_extraction_report& report)
    : m_callback(callback), m_report(report)
  {}

  bool is_cancelled() const { return m_is_cancelled; }

  // progress within the current stage
  bool proceed(double share)
  {
    if (!m_is_cancelled && m_callback)
      m_is_cancelled = !m_callback(m_begin + (std::min)(1., (std::max)(0., share)) * (m_end - m_begin));
    return !m_is_cancelled;
  }

  // what is no stage is done
  bool reach(double share)
  {
    m_begin = m_end = share;
    return proceed(1.);
  }

  template <class Stage>
  bool run(const char* name, double share_when_done, const Stage& stage)
  {
    m_begin = m_end;
    m_end = share_when_done;
    CGAL::Real_timer timer;
    timer.start();
    stage();
    timer.stop();
    m_report.seconds.emplace_back(name, timer.time());
    return proceed(1.);
  }
};

// What both `extract_wireframe()` and `extract_wireframe_from_source()` do.
template <class GeomTraits, class NamedParameters>
Wireframe<GeomTraits> extract(Distance_cloud_source& source, const GeomTraits& traits, bool is_reading_timed,
                              const NamedParameters& np)
{
  namespace WE = Wireframe_extraction;
  namespace np_tags = WE::internal_np;
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  typedef Wireframe_extraction_report Report;

  Report own_report;
  Report& report = choose_parameter(get_parameter(np, np_tags::extraction_report), std::ref(own_report)).get();
  report = Report();
  WE::Default_visitor no_visitor;
  auto given_visitor = choose_parameter(get_parameter(np, np_tags::visitor), std::ref(no_visitor));
  auto& visitor = referred(given_visitor);
  const std::function<bool(double)> callback = choose_parameter(
    get_parameter(np, CGAL::internal_np::callback), std::function<bool(double)>());
  Stage_runner runner(callback, report);
  const Extraction_options options = extraction_options(np);

  Wireframe<GeomTraits> wireframe;
  const auto give_up = [&](Report::Status status) {
    report.status = status;
    if (status == Report::Status::CANCELLED)
      report.message = "cancelled";
    return Wireframe<GeomTraits>();
  };

  auto cloud = std::make_unique<Surveyed_cloud>(source, points_in_memory(np));
  const bool skip_invalid = choose_parameter(get_parameter(np, np_tags::skip_invalid), false);
  CGAL::Real_timer timer;
  timer.start();
  if (!survey(*cloud, skip_invalid, report))
    return give_up(Report::Status::INVALID_INPUT);
  if (is_reading_timed)
    report.seconds.emplace_back("reading", timer.time());
  if (!runner.reach(0.02))
    return give_up(Report::Status::CANCELLED);
  const auto is_unreadable = [&] {
    report.message = cloud->error();
    return !report.message.empty();
  };
  const int dimension = internal::dimension(cloud->sample().positions);
  if (dimension < 2) {
    report.message = std::string(dimension == 0 ? "all points coincide" : "all points lie on one line")
                     + "; a wireframe needs points of a surface, so check what holds x, y and z";
    return give_up(Report::Status::INVALID_INPUT);
  }
  if (dimension == 2)
    report.warnings.push_back("all points lie in one plane");

  const double given = CGAL::to_double(choose_parameter(get_parameter(np, np_tags::sampling_distance), 0.));
  Cloud_scale scale;
  if (!runner.run("sampling distance", 0.15, [&] { scale = cloud->scale(); }))
    return give_up(Report::Status::CANCELLED);
  if (is_unreadable() || !check_scale(*cloud, scale, given, report))
    return give_up(Report::Status::INVALID_INPUT);
  const double unit = given > 0. ? given : scale.sampling_distance;
  report.sampling_distance = unit;
  visitor.sampling_distance_estimated(unit);

  Wireframe_skeleton<GeomTraits> skeleton;
  if (!runner.run("skeleton", 0.2, [&] {
        skeleton = select_skeleton(*cloud, unit, options, traits);
      }))
    return give_up(Report::Status::CANCELLED);
  if (is_unreadable())
    return give_up(Report::Status::INVALID_INPUT);
  report.skeleton_size = skeleton.size();
  report.number_of_duplicates = skeleton.number_of_duplicates();
  if (report.number_of_duplicates > 0)
    report.warnings.push_back(std::to_string(report.number_of_duplicates)
                              + " points near features lie exactly where others do and were left out");
  if (skeleton.is_empty()) {
    report.message = no_feature_message(*cloud, unit, options.skeleton_distance);
    return give_up(Report::Status::NO_FEATURE);
  }
  visitor.skeleton_selected(skeleton);
  cloud.reset();

  if (!runner.run("contraction", 0.35, [&] { WE::contract_skeleton(skeleton, np); }))
    return give_up(Report::Status::CANCELLED);
  if (options.use_creases && !runner.run("refinement", 0.5, [&] { WE::refine_field(skeleton, np); }))
    return give_up(Report::Status::CANCELLED);
  report.noise = skeleton.contraction().noise * unit;
  visitor.skeleton_contracted(skeleton);

  std::vector<Wireframe_corner<GeomTraits> > corners;
  if (!runner.run("corners", 0.55, [&] { corners = WE::detect_corners(skeleton, np); }))
    return give_up(Report::Status::CANCELLED);
  visitor.corners_detected(skeleton, corners);

  std::vector<std::vector<std::size_t> > clusters;
  if (!runner.run("segmentation", 0.6, [&] { clusters = WE::segment_curves(skeleton, corners, np); }))
    return give_up(Report::Status::CANCELLED);
  report.number_of_clusters = clusters.size();
  visitor.curves_segmented(skeleton, clusters);

  const auto progress = [&](double share) { return runner.proceed(share); };
  Wireframe_graph<GeomTraits> graph;
  if (!runner.run("graph", 0.8, [&] {
        graph = build_graph(skeleton, corners, clusters, options, progress);
      }))
    return give_up(Report::Status::CANCELLED);
  visitor.graph_built(graph);

  if (!runner.run("splines", 0.95, [&] { wireframe = fit(skeleton, graph, options, progress); }))
    return give_up(Report::Status::CANCELLED);
  if (wireframe.is_empty()) {
    report.message = "no curve explains the field";
    return give_up(Report::Status::NO_FEATURE);
  }
  visitor.curves_fitted(wireframe);
  if (options.recognize_types) {
    if (!runner.run("types", 1., [&] { wireframe = recognize(skeleton, wireframe, options, report.regularities); }))
      return give_up(Report::Status::CANCELLED);
    visitor.types_recognized(wireframe);
  }
  std::vector<std::size_t> ends(wireframe.vertices.size(), 0);
  for (const Wireframe_curve<GeomTraits>& curve : wireframe.curves)
    if (curve.source != curve.no_vertex) {
      ++ends[curve.source];
      ++ends[curve.target];
    }
  report.number_of_free_ends = std::count(ends.begin(), ends.end(), std::size_t(1));
  report.number_of_corners = wireframe.vertices.size() - report.number_of_free_ends;
  report.number_of_curves = wireframe.curves.size();
  double squares = 0., support = 0.;
  for (const Wireframe_curve<GeomTraits>& curve : wireframe.curves) {
    const double rms = CGAL::to_double(curve.root_mean_square);
    squares += rms * rms * double(curve.support);
    support += double(curve.support);
    report.maximum_deviation = (std::max)(report.maximum_deviation, CGAL::to_double(curve.maximum_deviation));
  }
  report.root_mean_square = support > 0. ? std::sqrt(squares / support) : 0.;
  return wireframe;
}

} // namespace internal
} // namespace Wireframe_extraction

/*!
\ingroup PkgWireframeExtractionFunctions

extracts the parametric wireframe of a shape from a dense point cloud of its surface, in which every point carries an
estimate of its distance to the nearest sharp feature curve.

The function chains `estimate_sampling_distance()`, `select_skeleton()`, `contract_skeleton()`, `refine_field()`,
`detect_corners()`, `segment_curves()`, `build_topological_graph()`, `fit_curves()` and `recognize_curve_types()`, which
extend the method of \cgalCite{MAZB21}; every named parameter of these functions can be
given. The result does not depend on the order of the points or the number of threads, and moves and scales with the
cloud, up to rounding.

\tparam PointRange a model of `ConstRange` whose iterators are forward iterators
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the cloud
\param np an optional sequence of named parameters, those of the stages and:
\cgalNamedParamsBegin
  \cgalParamNBegin{point_map}
    \cgalParamDescription{a property map from the value type of `points` to points}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the first of a pair, or the value itself}
  \cgalParamNEnd
  \cgalParamNBegin{distance_map}
    \cgalParamDescription{a property map from the value type of `points` to the distance to the nearest sharp feature}
    \cgalParamType{a model of `ReadablePropertyMap`}
    \cgalParamDefault{the second of a pair}
  \cgalParamNEnd
  \cgalParamNBegin{sampling_distance}
    \cgalParamDescription{the sampling distance r of the cloud, in its unit}
    \cgalParamType{`double`}
    \cgalParamDefault{what `estimate_sampling_distance()` finds}
  \cgalParamNEnd
  \cgalParamNBegin{points_in_memory}
    \cgalParamDescription{up to how many points are copied; a larger cloud is gone over several times instead}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{1048576}
    \cgalParamExtra{The result is the same, up to rounding.}
  \cgalParamNEnd
  \cgalParamNBegin{skip_invalid}
    \cgalParamDescription{whether points that are not finite or have a negative distance are left out; otherwise they
                          are an error}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{use_creases}
    \cgalParamDescription{whether `refine_field()` corrects the field by the surface}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{recognize_types}
    \cgalParamDescription{whether `recognize_curve_types()` replaces splines by lines, circles and ellipses}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{extraction_report}
    \cgalParamDescription{a reference to what shall tell how the extraction went: `std::ref(report)`}
    \cgalParamType{`std::reference_wrapper<Wireframe_extraction_report>`}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{a visitor that sees the result of each stage; pass `std::ref(visitor)` to keep it}
    \cgalParamType{a model of `WireframeExtractionVisitor`, or a `std::reference_wrapper` of one}
    \cgalParamDefault{`Wireframe_extraction::Default_visitor`}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that is called with the share that is done and returns whether to go on}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{unused}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a model of `WireframeExtractionTraits_3`}
    \cgalParamDefault{the kernel of the point type}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the wireframe. It is empty if the input is invalid, if there is no feature, or after cancelling; the report
says which.

Complexity: O(n log n) for n points. Beyond the cloud itself, memory goes to at most `points_in_memory` points and to
those around the features.
*/
template <class PointRange, class NamedParameters = CGAL::parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
Wireframe<GeomTraits>
#else
Wireframe<typename Wireframe_extraction::internal::Cloud_access<PointRange, NamedParameters>::Geom_traits>
#endif
extract_wireframe(const PointRange& points, const NamedParameters& np = CGAL::parameters::default_values())
{
  typedef Wireframe_extraction::internal::Cloud_access<PointRange, NamedParameters> Access;
  const Access access(np);
  Wireframe_extraction::internal::Range_source<PointRange, Access> source(points, access);
  return Wireframe_extraction::internal::extract(source, access.traits(), false, np);
}

/*!
\ingroup PkgWireframeExtractionFunctions

extracts the parametric wireframe of a shape from a cloud that need not be in memory. It is read several times, and what
is kept of it are `points_in_memory` points and those around the features. The result is that of
`extract_wireframe()` for the same points.

\tparam GeomTraits a model of `WireframeExtractionTraits_3`, for instance a kernel
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param source the cloud, for instance an `IO::Distance_cloud_file`. If it cannot be read, the report has the reason.
\param np an optional sequence of named parameters: those of `extract_wireframe()`, except `point_map` and
`distance_map`

\return the wireframe. It is empty if the input is invalid, if there is no feature, or after cancelling; the report
says which.

Complexity: O(n log n) for n points. A cloud of more than `points_in_memory` points is read five times, four times
without `use_creases`.
*/
template <class GeomTraits, class NamedParameters = CGAL::parameters::Default_named_parameters>
Wireframe<GeomTraits>
extract_wireframe_from_source(Wireframe_extraction::Distance_cloud_source& source,
                              const NamedParameters& np = CGAL::parameters::default_values())
{
  const GeomTraits traits = CGAL::parameters::choose_parameter<GeomTraits>(
    CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits));
  return Wireframe_extraction::internal::extract(source, traits, true, np);
}

} // namespace CGAL

#endif // CGAL_EXTRACT_WIREFRAME_H
