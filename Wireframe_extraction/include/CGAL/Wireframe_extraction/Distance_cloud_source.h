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

#ifndef CGAL_WIREFRAME_EXTRACTION_DISTANCE_CLOUD_SOURCE_H
#define CGAL_WIREFRAME_EXTRACTION_DISTANCE_CLOUD_SOURCE_H

#include <cstddef>
#include <functional>
#include <string>

namespace CGAL {
namespace Wireframe_extraction {

/*!
\ingroup PkgWireframeExtractionClasses

The base of clouds that need not be in memory: they hand out their points chunk by chunk, as often as they are asked,
with distances or without. `IO::Distance_cloud_file` is one; derive from this class what comes from elsewhere, for
instance from a data base.

\sa `extract_wireframe_from_source()`
*/
class Distance_cloud_source
{
public:
  /// a point and its distance
  struct Sample
  {
    double x;        ///< coordinate
    double y;        ///< coordinate
    double z;        ///< coordinate
    double distance; ///< distance to the nearest sharp feature; any number if it is unknown
  };

  /// what takes a chunk of samples, and returns whether it wants more
  typedef std::function<bool(const Sample* first, const Sample* beyond)> Sink;

  /// destroys what was derived from it.
  virtual ~Distance_cloud_source() {}

  /// hands out all samples, in the same order each time, unless the sink wants no more. Returns whether that went well,
  /// also if the sink wanted no more; if not, `error_message()` says why.
  virtual bool read(const Sink& sink) = 0;

  /// returns whether the distances of the samples are known. If not, they are not looked at, and
  /// `extract_wireframe_from_source()` estimates them, for which all points have to be in memory. It is asked once the
  /// first samples were handed out. The default is `true`.
  virtual bool has_distances() const { return true; }

  /// returns the number of samples if it is known without reading them, else 0, as the default does. It serves to
  /// reserve memory.
  virtual std::size_t size_hint() const { return 0; }

  /// returns what went wrong, in one line; empty if nothing did. A class whose `read()` can fail is expected to
  /// override it: the message becomes that of the report. The default is an empty text, for which the report says no
  /// more than that the cloud cannot be read.
  virtual std::string error_message() const { return std::string(); }
};

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_DISTANCE_CLOUD_SOURCE_H
