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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CONTRACT_IMPL_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CONTRACT_IMPL_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Local_curve_fit.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Several_curves_contraction.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/contract.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

CGAL_WIREFRAME_EXTRACTION_INLINE bool contract(const Field_band& band, double radius,
                                               const std::function<bool(double)>& proceed, Contraction& result)
{
  result.curves.resize(band.skeleton_size);
  result.residuals.resize(band.skeleton_size);
  std::vector<std::size_t> order = band.search.spatial_order();
  order.erase(std::remove_if(order.begin(), order.end(), [&](std::size_t i) { return i >= band.skeleton_size; }),
              order.end());
  // the fits of balls that are smaller, and see one of several curves more often
  static constexpr double share_of_small_balls = 0.7;
  static constexpr double share_of_singles = 0.3; // of the time, about, where fits of several curves follow
  std::vector<std::vector<Local_curve>> small(band.skeleton_size);
  const bool is_complete = for_each_piece_or_cancel(
    order.size(),
    [&](std::size_t begin, std::size_t end) {
      Local_curve_fit fit(band);
      Local_fit_options options;
      options.radius = radius;
      for (std::size_t k = begin; k < end; ++k)
      {
        const std::size_t i = order[k];
        result.residuals[i] = fit.refine_with_best_radius(result.curves[i], options,
                                                          [&](Local_curve& curve, const Local_fit_options& scaled) {
                                                            curve = fit.principal_axis(band.points[i], scaled.radius);
                                                            fit.refine(curve, band.points[i], scaled);
                                                            orient(curve, band, fit.ball());
                                                            if (scaled.radius < share_of_small_balls * radius)
                                                              small[i].push_back(curve);
                                                          });
      }
    },
    [&](double share) { return proceed(share_of_singles * share); });
  result.noise = median(result.residuals);
  result.own_residuals = result.residuals;
  if (!is_complete)
    return false;
  Several_curves_contraction several(band, order, small, result);
  if (!several.is_of_use())
    return true;
  return several.run([&](double share) { return proceed(share_of_singles + (1. - share_of_singles) * share); });
}

CGAL_WIREFRAME_EXTRACTION_INLINE bool contract(Skeleton_data& skeleton, const Extraction_options& options,
                                               const std::function<bool(double)>& proceed)
{
  if (skeleton.support_size() == 0)
    return true;
  auto contraction = std::make_shared<Contraction>();
  if (!contract(*skeleton.band, options.fitting_radius, proceed, *contraction))
    return false;
  contraction->noise = options.noise_or(contraction->noise);
  skeleton.contraction = contraction;
  if (contraction->is_precise())
    skeleton.surroundings = std::make_shared<Field_band>();
  return true;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_CONTRACT_IMPL_H
