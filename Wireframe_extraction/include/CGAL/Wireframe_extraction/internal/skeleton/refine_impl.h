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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_REFINE_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_REFINE_IMPL_H

#include <CGAL/Wireframe_extraction/internal/skeleton/Field_refinement.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/complete_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/contract.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/refine.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Surfaces with less noise (in sampling distances) tell where they are flat, so that what is left of the field there is
// true; in the others, ends of curves are cut back to where the surface is folded.
constexpr double least_noise_to_trim = 0.1;

// the points of the surroundings that lie near features by their new distances; null after cancelling
inline std::shared_ptr<Field_band> refined_band(const Field_band& surroundings, const Field_refinement& refinement,
                                                const Extraction_options& options,
                                                const std::function<bool(double)>& proceed)
{
  std::vector<double> distances, deviations;
  std::vector<char> is_on_crease;
  if (!refinement.compute_distances(proceed, distances, deviations, is_on_crease))
    return nullptr;
  const double widest = (std::max)(options.skeleton_distance, options.support_distance);
  auto band = std::make_shared<Field_band>();
  for (std::size_t i = 0; i < surroundings.size(); ++i)
  {
    if (!(distances[i] < widest))
      continue;
    band->points.push_back(surroundings.points[i]);
    band->indices.push_back(surroundings.indices[i]);
    band->distances.push_back(distances[i]);
    band->deviations.push_back(deviations[i]);
    if (refinement.surface_noise() > least_noise_to_trim)
      band->is_on_crease.push_back(is_on_crease[i]);
  }
  complete_band(*band, options.skeleton_distance);
  return band;
}

CGAL_WIREFRAME_EXTRACTION_INLINE bool refine(Skeleton_data& skeleton, const Extraction_options& options,
                                             const std::function<bool(double)>& proceed)
{
  if (skeleton.support_size() == 0 || skeleton.surroundings->size() == 0 || skeleton.contraction->is_precise())
    return true;
  // the fits of creases take most of the time
  const auto part = [&](double begin, double end) {
    return [&proceed, begin, end](double share) { return proceed(begin + share * (end - begin)); };
  };
  Field_refinement refinement(*skeleton.surroundings, *skeleton.contraction, options.fitting_radius);
  if (!refinement.run(part(0., 0.8)))
    return false;
  const std::shared_ptr<Field_band> band = refined_band(*skeleton.surroundings, refinement, options, part(0.8, 0.9));
  if (!band)
    return false;
  auto contraction = std::make_shared<Contraction>();
  if (!contract(*band, options.fitting_radius, part(0.9, 1.), *contraction))
    return false;
  contraction->noise = options.noise_or((std::max)(contraction->noise, refinement.typical_deviation()));
  contraction->creases = refinement.curves();
  skeleton.band = band;
  skeleton.contraction = contraction;
  return true;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_REFINE_IMPL_H
