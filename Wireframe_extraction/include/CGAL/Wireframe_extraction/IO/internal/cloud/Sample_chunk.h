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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_CHUNK_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_CHUNK_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>
#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_sink.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace internal {

// Collects samples and hands them out many at once, to a sink that says whether it wants more.
class Sample_chunk
{
public:
  static constexpr std::size_t capacity = 4096;

  // returns whether more samples are wanted
  bool add(const Distance_sample& sample, Sample_sink& sink)
  {
    m_samples.push_back(sample);
    return m_samples.size() < capacity || flush(sink);
  }

  bool flush(Sample_sink& sink)
  {
    const bool goes_on = m_samples.empty() || sink(m_samples.data(), m_samples.data() + m_samples.size());
    m_samples.clear();
    return goes_on;
  }

  // for messages, when no more samples are wanted
  static std::string stopped_text() { return "reading was stopped"; }

private:
  std::vector<Distance_sample> m_samples;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_CHUNK_H
