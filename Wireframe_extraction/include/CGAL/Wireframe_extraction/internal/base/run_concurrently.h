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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_RUN_CONCURRENTLY_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_RUN_CONCURRENTLY_H

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <type_traits>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Runs a function, and what it runs at the same time: with all threads that there are, or with one only. The result
// must not depend on it.
template <class ConcurrencyTag, class Function>
auto run_concurrently(const Function& function) -> decltype(function())
{
#ifdef CGAL_LINKED_WITH_TBB
  if (!std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value)
  {
    tbb::task_arena arena(1);
    return arena.execute(function);
  }
#else
  static_assert(!std::is_convertible<ConcurrencyTag, CGAL::Parallel_tag>::value,
                "Parallel_tag needs TBB: link with it, or take Parallel_if_available_tag");
#endif
  return function();
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_RUN_CONCURRENTLY_H
