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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_FOR_EACH_PIECE_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_FOR_EACH_PIECE_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Calls work(begin, end) on pieces of [0, count) of about `size`, at the same time where there are threads for it. How
// it is cut must not matter.
template <class Work>
void for_each_piece(std::size_t count, const Work& work, std::size_t size = 256)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, size),
                    [&](const tbb::blocked_range<std::size_t>& range) { work(range.begin(), range.end()); });
#else
  for (std::size_t begin = 0; begin < count; begin += size)
    work(begin, (std::min)(count, begin + size));
#endif
}

// The same, but at least before every 64 `proceed(share)` is asked whether to go on, by the rule of Progress: the
// slowest of what is done take a millisecond each. Returns whether all is done.
template <class Work, class Proceed>
bool for_each_piece_or_cancel(std::size_t count, const Work& work, const Proceed& proceed)
{
  static constexpr std::size_t most = 64;
  const std::function<bool(double)> ask = [&proceed](double share) { return proceed(share); };
  Progress progress(ask);
  std::atomic<std::size_t> done{0};
  for_each_piece(count, [&](std::size_t begin, std::size_t end) {
    // threads take pieces of any size
    for (std::size_t first = begin; first < end && progress.reach(double(done) / double(count)); first += most)
    {
      work(first, (std::min)(end, first + most));
      done += (std::min)(most, end - first);
    }
  });
  return !progress.is_cancelled();
}

// how many pieces may be worked on at the same time
inline std::size_t concurrency()
{
#ifdef CGAL_LINKED_WITH_TBB
  return (std::min)(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
                    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
#else
  return 1;
#endif
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_FOR_EACH_PIECE_H
