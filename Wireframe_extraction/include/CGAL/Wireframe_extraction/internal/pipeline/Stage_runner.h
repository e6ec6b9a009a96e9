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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_STAGE_RUNNER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_STAGE_RUNNER_H

#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

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

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_STAGE_RUNNER_H
