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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_INFLATER_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_INFLATER_H

#include <cstddef>

namespace CGAL {
namespace IO {
namespace internal {

// Decompresses piece by piece what is deflated.
class Inflater
{
public:
  enum class Status
  {
    GOES_ON,
    AT_END,
    DAMAGED
  };

  virtual ~Inflater() {}

  virtual bool is_started() const = 0;
  // whether all input is used up
  virtual bool is_hungry() const = 0;
  virtual void feed(char* bytes, std::size_t size) = 0;
  // fills the target as far as the input goes; `done` is how far
  virtual Status inflate(char* target, std::size_t size, std::size_t& done) = 0;
};

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_CLOUD_INFLATER_H
