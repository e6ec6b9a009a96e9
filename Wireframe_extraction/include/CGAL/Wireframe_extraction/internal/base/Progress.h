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
#include <cstddef>
#include <functional>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The callback of a stage, for its inner loops, which may run at the same time. One rule for all: any thread asks, but
// never two at the same time, and none waits for another one's answer, so that callbacks may use threads themselves.
// Once the answer was no, or the callback has thrown, nobody is asked any more, and every loop that looks stops.
class Progress
{
  const std::function<bool(double)>& m_callback; // may be empty
  double m_share = 0.;                           // the largest so far, for who is asking
  std::atomic_flag m_is_asking = ATOMIC_FLAG_INIT;
  std::atomic<bool> m_is_cancelled{false};

public:
  explicit Progress(const std::function<bool(double)>& callback) : m_callback(callback) {}
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // whether to go on, after at least this share of the work
  bool reach(double share)
  {
    if (m_is_cancelled || !m_callback || m_is_asking.test_and_set(std::memory_order_acquire))
      return !m_is_cancelled;
    try
    {
      if (!m_is_cancelled) // another thread may just have heard no
      {
        m_share = (std::max)(m_share, share);
        m_is_cancelled = !m_callback(m_share);
      }
    }
    catch (...)
    {
      m_is_cancelled = true;
      m_is_asking.clear(std::memory_order_release);
      throw;
    }
    m_is_asking.clear(std::memory_order_release);
    return !m_is_cancelled;
  }

  // whether to go on, somewhere within the work
  bool goes_on() { return reach(0.); }

  bool is_cancelled() const { return m_is_cancelled; }
};

// Loops over many points, each of which takes microseconds, ask so often.
constexpr std::size_t points_between_questions = 256;

// for those who may have none
inline bool goes_on(Progress* progress) { return !progress || progress->goes_on(); }

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_PROGRESS_H
