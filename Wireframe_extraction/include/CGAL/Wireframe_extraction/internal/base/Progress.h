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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PROGRESS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PROGRESS_H

#include <algorithm>
#include <atomic>
#include <functional>
#include <mutex>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The callback of a stage, for its inner loops, which may run at the same time. Once the answer was no, nobody is asked
// any more, and every loop that looks stops.
class Progress
{
  const std::function<bool(double)>& m_callback; // may be empty
  double m_share = 0.;
  std::mutex m_mutex;
  std::atomic<bool> m_is_cancelled{false};

public:
  explicit Progress(const std::function<bool(double)>& callback) : m_callback(callback) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // whether to go on, after this share of the work
  bool reach(double share)
  {
    if (m_is_cancelled)
      return false;
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_share = (std::max)(m_share, share);
    if (!m_is_cancelled && m_callback && !m_callback(m_share))
      m_is_cancelled = true;
    return !m_is_cancelled;
  }

  // whether to go on, somewhere within the work
  bool goes_on() { return reach(0.); }

  bool is_cancelled() const { return m_is_cancelled; }
};

// for those who may have none
inline bool goes_on(Progress* progress) { return !progress || progress->goes_on(); }

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PROGRESS_H
