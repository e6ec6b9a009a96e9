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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CANCELLATION_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CANCELLATION_H

#include <algorithm>
#include <atomic>
#include <functional>
#include <thread>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Asks a callback whether to go on, from inside loops of any thread: the callback itself is called by the thread that
// made this object only, since callbacks are written for one thread; the others hear of it.
class Cancellation
{
  const std::function<bool(double)>& m_proceed;
  const std::thread::id m_thread = std::this_thread::get_id();
  double m_share = 0.;
  std::atomic<bool> m_is_cancelled{false};

public:
  explicit Cancellation(const std::function<bool(double)>& proceed) : m_proceed(proceed) {}

  bool is_cancelled() const { return m_is_cancelled; }

  // `share` is what is done at least
  bool goes_on(double share = 0.)
  {
    if (m_is_cancelled || !m_proceed || std::this_thread::get_id() != m_thread)
      return !m_is_cancelled;
    m_share = (std::max)(m_share, share);
    m_is_cancelled = !m_proceed(m_share);
    return !m_is_cancelled;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CANCELLATION_H
