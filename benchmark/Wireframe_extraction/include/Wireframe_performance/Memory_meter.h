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

#ifndef WIREFRAME_PERFORMANCE_MEMORY_METER_H
#define WIREFRAME_PERFORMANCE_MEMORY_METER_H

// To be included in one source file of a program: with the GNU C library, it counts the memory that is in use, whoever
// asks for it. What the system says of a process is its peak since it began, which tells nothing of single stages.

#include <atomic>
#include <cstddef>

#ifdef __GLIBC__
#include <cerrno>
#include <malloc.h>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}
#endif

namespace Wireframe_performance {

/// The memory in use, and its peak since a moment.
class Memory_meter
{
  static std::atomic<long long>& used()
  {
    static std::atomic<long long> bytes{0};
    return bytes;
  }

  static std::atomic<long long>& most_used()
  {
    static std::atomic<long long> bytes{0};
    return bytes;
  }

public:
  static bool is_available()
  {
#ifdef __GLIBC__
    return true;
#else
    return false;
#endif
  }

  static void add(long long bytes)
  {
    const long long now = used().fetch_add(bytes, std::memory_order_relaxed) + bytes;
    long long most = most_used().load(std::memory_order_relaxed);
    while (now > most && !most_used().compare_exchange_weak(most, now, std::memory_order_relaxed))
      ;
  }

  /// starts to look for a peak.
  Memory_meter() : m_begin(used().load()) { most_used().store(m_begin); }

  /// returns by how many bytes the memory in use has been above that at the start.
  double peak() const { return static_cast<double>(most_used().load() - m_begin); }

private:
  long long m_begin;
};

} // namespace Wireframe_performance

#ifdef __GLIBC__
namespace Wireframe_performance {
namespace internal {

inline void* counted(void* memory)
{
  if (memory != nullptr)
    Memory_meter::add(static_cast<long long>(malloc_usable_size(memory)));
  return memory;
}

} // namespace internal
} // namespace Wireframe_performance

extern "C" {

void* malloc(std::size_t size) noexcept { return Wireframe_performance::internal::counted(__libc_malloc(size)); }

void* calloc(std::size_t count, std::size_t size) noexcept
{
  return Wireframe_performance::internal::counted(__libc_calloc(count, size));
}

void free(void* memory) noexcept
{
  if (memory != nullptr)
    Wireframe_performance::Memory_meter::add(-static_cast<long long>(malloc_usable_size(memory)));
  __libc_free(memory);
}

void* realloc(void* memory, std::size_t size) noexcept
{
  const long long before = memory != nullptr ? static_cast<long long>(malloc_usable_size(memory)) : 0;
  void* const result = __libc_realloc(memory, size);
  if (result != nullptr || size == 0)
  {
    Wireframe_performance::Memory_meter::add(-before);
    Wireframe_performance::internal::counted(result);
  }
  return result;
}

void* memalign(std::size_t alignment, std::size_t size) noexcept
{
  return Wireframe_performance::internal::counted(__libc_memalign(alignment, size));
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept { return memalign(alignment, size); }

int posix_memalign(void** result, std::size_t alignment, std::size_t size) noexcept
{
  void* const memory = memalign(alignment, size);
  if (memory == nullptr)
    return ENOMEM;
  *result = memory;
  return 0;
}

} // extern "C"
#endif

#endif // WIREFRAME_PERFORMANCE_MEMORY_METER_H
