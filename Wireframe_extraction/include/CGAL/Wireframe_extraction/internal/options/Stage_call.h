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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_STAGE_CALL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_STAGE_CALL_H

#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <functional>
#include <string>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What a single stage is called with: its options, whom it tells how it went, and who may stop it. It fails as the
// whole extraction does: nothing is thrown, and the report has the reason.
class Stage_call
{
  typedef Wireframe_extraction_report Report;

  const Extraction_options m_options;
  const std::function<bool(double)> m_callback;
  Report m_own_report;
  Report& m_report;

public:
  template <class NamedParameters>
  explicit Stage_call(const NamedParameters& np)
    : m_options(given_options(np)),
      m_callback(CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::callback),
                                                    std::function<bool(double)>())),
      m_report(CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::extraction_report),
                                                  std::ref(m_own_report))
                 .get())
  {
    m_report.status = Report::Status::SUCCESS;
    m_report.message = out_of_range(m_options);
    if (!m_report.message.empty())
      m_report.status = Report::Status::INVALID_INPUT;
  }
  Stage_call(const Stage_call&) = delete;
  Stage_call& operator=(const Stage_call&) = delete;

  const Extraction_options& options() const { return m_options; }
  Report& report() { return m_report; }
  bool is_well() const { return m_report.status == Report::Status::SUCCESS; }

  bool fail(Report::Status status, const std::string& message)
  {
    m_report.status = status;
    m_report.message = message;
    return false;
  }

  // what the stage asks whether to go on
  std::function<bool(double)> progress()
  {
    return [this](double share) {
      if (is_well() && m_callback && !m_callback(share))
        fail(Report::Status::CANCELLED, "cancelled");
      return is_well();
    };
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_OPTIONS_STAGE_CALL_H
