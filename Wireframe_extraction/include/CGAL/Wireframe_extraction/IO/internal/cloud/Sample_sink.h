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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_SINK_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_SINK_H

#include <CGAL/Wireframe_extraction/IO/internal/cloud/Sample_filter.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace IO {
namespace internal {

// Gets the samples of a cloud, chunk after chunk.
class Sample_sink
{
public:
  virtual ~Sample_sink() {}

  // how many samples there will be, where that can be trusted
  virtual void reserve(std::size_t) {}

  // Is called before the first sample: whether distances are known (otherwise they are 0), what was assumed about a
  // file that does not say it, and what of the file holds the distances, as words for people.
  virtual void describe(bool /*has_distances*/, const std::string& /*assumption*/, const std::string& /*place*/) {}

  // returns whether more are wanted
  virtual bool operator()(const Distance_sample* first, const Distance_sample* last) = 0;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_SAMPLE_SINK_H
