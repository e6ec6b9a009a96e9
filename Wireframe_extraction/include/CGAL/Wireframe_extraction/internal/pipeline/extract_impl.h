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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACT_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACT_IMPL_H

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>
#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/internal/fit/fit_splines.h>
#include <CGAL/Wireframe_extraction/internal/network/build_graph.h>
#include <CGAL/Wireframe_extraction/internal/network/find_corners.h>
#include <CGAL/Wireframe_extraction/internal/network/separate_curves.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Extraction_request.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Plain_visitor.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/Stage_runner.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/add_doubts.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/estimate_best_field.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/estimate_distances.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/extract.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/find_unit.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/stage_reports.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/contract.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/find_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/refine.h>
#include <CGAL/Wireframe_extraction/internal/types/recognize_types.h>

#include <CGAL/Real_timer.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Runs all stages on a cloud, and reports how it went.
class Extraction
{
  typedef Wireframe_extraction_report Report;
  typedef Wireframe_skeleton<Plain_traits> Skeleton;

  const Extraction_request& m_request;
  Extraction_options m_options;
  Plain_visitor& m_visitor;
  Report& m_report;
  Stage_runner m_runner;
  const std::function<bool(double)> m_progress;
  double m_share_before = 0.;              // of the work that was done for the field
  Best_field m_field;                      // if it had to be estimated; the cloud may be that of its means
  std::unique_ptr<Surveyed_cloud> m_cloud; // as long as it is needed
  Skeleton m_skeleton;
  std::vector<Wireframe_corner<Plain_traits>> m_corners;
  std::vector<std::vector<std::size_t>> m_clusters;
  Wireframe_graph<Plain_traits> m_graph;
  Wireframe<Plain_traits> m_wireframe;

public:
  Extraction(const Extraction_request& request, Plain_visitor& visitor, Report& report)
    : m_request(request), m_options(request.options), m_visitor(visitor), m_report(report),
      m_runner(request.callback, m_report), m_progress([this](double share) { return m_runner.proceed(share); })
  {
    m_report = Report();
  }

  Wireframe<Plain_traits> run(Distance_cloud_source& source)
  {
    if (!read(source) || !find_scale() || !find_field() || !select_skeleton() || !find_curves() || !fit_all()
        || !doubt_curves())
      return Wireframe<Plain_traits>();
    report_wireframe(m_wireframe, m_report);
    return m_wireframe;
  }

private:
  bool fail(Report::Status status, const std::string& message)
  {
    m_report.status = status;
    m_report.message = message;
    return false;
  }

  template <class Stage>
  bool stage(const char* name, double share_when_done, const Stage& work)
  {
    return m_runner.run(name, m_share_before + (1. - m_share_before) * share_when_done, work)
      || fail(Report::Status::CANCELLED, "cancelled");
  }

  bool is_readable() { return m_cloud->error().empty() || fail(Report::Status::INVALID_INPUT, m_cloud->error()); }

  bool read(Distance_cloud_source& source)
  {
    const std::string problem = out_of_range(m_options);
    if (!problem.empty())
      return fail(Report::Status::INVALID_INPUT, problem);
    m_cloud = std::make_unique<Surveyed_cloud>(source, m_request.points_in_memory);
    CGAL::Real_timer timer;
    timer.start();
    if (!survey(*m_cloud, m_request.skip_invalid, m_report))
      return fail(Report::Status::INVALID_INPUT, m_report.message);
    // the estimate of a field looks at all points
    if (!source.has_distances() && !m_cloud->is_in_memory())
    {
      m_cloud = std::make_unique<Surveyed_cloud>(source, (std::numeric_limits<std::size_t>::max)());
      if (!survey(*m_cloud, m_request.skip_invalid, m_report))
        return fail(Report::Status::INVALID_INPUT, m_report.message);
    }
    if (m_request.is_reading_timed)
      m_report.seconds.emplace_back("reading", timer.time());
    return m_runner.reach(0.02) || fail(Report::Status::CANCELLED, "cancelled");
  }

  bool find_scale()
  {
    const auto run = [&](const auto& measure) { return stage("sampling distance", 0.06, measure); };
    if (!find_unit(*m_cloud, m_request.sampling_distance, m_options, m_report, run))
      return false;
    m_visitor.sampling_distance_estimated(m_report.sampling_distance);
    return true;
  }

  // Where the cloud has no distances, the points tell them, and how much they err.
  bool find_field()
  {
    static constexpr double share_when_done = 0.5;
    if (m_cloud->has_distances())
      return true;
    if (!stage("field", share_when_done, [&] { estimate_best(); }))
      return false;
    const double unit = m_report.sampling_distance;
    m_share_before = share_when_done;
    const Distance_field& field = m_field.field;
    report_field(field, m_report);
    m_visitor.field_estimated(field);
    if (field.number_of_near_points == 0)
      return fail(Report::Status::NO_FEATURE, no_fold_message(m_options.minimum_fold));
    m_cloud->set_distances(field.distances);
    m_options.noise_level = m_options.noise_or(field.noise_level);
    return check_truncation(*m_cloud, unit, m_options, m_report)
      || fail(Report::Status::INVALID_INPUT, m_report.message);
  }

  void estimate_best()
  {
    const double unit = m_report.sampling_distance;
    if (!estimate_best_field(*m_cloud, unit, m_request.sampling_distance > 0., m_options.minimum_fold, m_progress,
                             m_field)
        || !m_field.cloud)
      return;
    m_cloud = std::move(m_field.cloud);
    m_report.sampling_distance = m_field.field.sampling_distance;
    m_visitor.sampling_distance_estimated(m_report.sampling_distance);
    m_report.warnings.push_back(m_field.warning);
  }

  bool select_skeleton()
  {
    const double unit = m_report.sampling_distance;
    if (!stage("skeleton", 0.1,
               [&] { m_skeleton = Skeleton(find_skeleton(*m_cloud, unit, m_options), Plain_traits()); })
        || !is_readable())
      return false;
    report_skeleton(m_skeleton.data(), m_report);
    if (m_skeleton.is_empty())
      return fail(Report::Status::NO_FEATURE, no_feature_message(*m_cloud, unit, m_options.skeleton_distance));
    m_visitor.skeleton_selected(m_skeleton);
    if (!stage("contraction", 0.2, [&] { contract(m_skeleton.data(), m_options, m_progress); }))
      return false;
    if (m_options.use_creases && (!stage("refinement", 0.6, [&] { refine_where_needed(); }) || !is_readable()))
      return false;
    m_cloud.reset();
    m_report.noise = m_skeleton.data().contraction->noise * unit;
    m_visitor.skeleton_contracted(m_skeleton);
    return true;
  }

  // a precise field is as good as the surface, which need not be looked at
  void refine_where_needed()
  {
    if (m_skeleton.data().contraction->is_precise())
      return;
    find_surroundings(*m_cloud, m_options, m_skeleton.data());
    if (m_cloud->error().empty())
      refine(m_skeleton.data(), m_options, m_progress);
  }

  bool find_curves()
  {
    if (!stage("corners", 0.62, [&] { m_corners = find_corners(m_skeleton, m_options, m_progress); }))
      return false;
    m_visitor.corners_detected(m_skeleton, m_corners);
    if (!stage("segmentation", 0.65,
               [&] { m_clusters = separate_curves(m_skeleton, m_corners, m_options, m_progress); }))
      return false;
    m_report.number_of_clusters = m_clusters.size();
    m_visitor.curves_segmented(m_skeleton, m_clusters);
    if (!stage("graph", 0.85, [&] { m_graph = build_graph(m_skeleton, m_corners, m_clusters, m_options, m_progress); }))
      return false;
    m_visitor.graph_built(m_graph);
    return true;
  }

  bool fit_all()
  {
    if (!stage("splines", 0.92, [&] { m_wireframe = fit_splines(m_skeleton, m_graph, m_options, m_progress); }))
      return false;
    if (m_wireframe.is_empty())
      return fail(Report::Status::NO_FEATURE, no_curve_message());
    m_visitor.curves_fitted(m_wireframe);
    if (!m_options.recognize_types)
      return true;
    if (!stage("types", 0.98, [&] {
          recognize_types(m_skeleton, m_wireframe, m_options, m_progress, m_wireframe, m_report.regularities);
        }))
      return false;
    m_visitor.types_recognized(m_wireframe);
    return true;
  }

  bool doubt_curves()
  {
    return stage("doubts", 1., [&] { add_doubts(m_skeleton.data(), m_options, m_wireframe, m_progress); });
  }
};

CGAL_WIREFRAME_EXTRACTION_INLINE
Wireframe<Plain_traits> extract(Distance_cloud_source& source, const Extraction_request& request,
                                Plain_visitor& visitor, Wireframe_extraction_report& report)
{
  return Extraction(request, visitor, report).run(source);
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_EXTRACT_IMPL_H
