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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SKELETON_DATA_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SKELETON_DATA_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Contraction.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// What a skeleton is in plain numbers: local coordinates, in units of the sampling distance, relative to `origin`.
struct Skeleton_data
{
  std::shared_ptr<const Field_band> band;
  std::shared_ptr<const Field_band> surroundings; // the points around the skeleton, whatever their distances
  std::shared_ptr<const Contraction> contraction; // once it is contracted
  double unit = 1.;                               // the sampling distance, in the cloud's unit
  Vector origin = Vector::Zero();                 // in the cloud's coordinates
  std::size_t number_of_duplicates = 0, number_of_strays = 0;

  std::size_t size() const { return band ? band->skeleton_size : 0; }
  std::size_t support_size() const { return band ? band->size() : 0; }

  Vector to_local(const Vector& p) const { return (p - origin) / unit; }
  Vector to_global(const Vector& p) const { return origin + unit * p; }

  // the noise level that was given, or else that of the contraction
  double noise(const Extraction_options& options) const
  {
    static constexpr double unknown = 0.1; // before the contraction, which measures it: that of a fair regressor
    return options.noise_or(contraction ? contraction->noise : unknown);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SKELETON_DATA_H
