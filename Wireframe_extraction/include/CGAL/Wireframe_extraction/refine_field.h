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

#ifndef CGAL_WIREFRAME_EXTRACTION_REFINE_FIELD_H
#define CGAL_WIREFRAME_EXTRACTION_REFINE_FIELD_H

#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/base/run_concurrently.h>
#include <CGAL/Wireframe_extraction/internal/field/Field_refinement.h>
#include <CGAL/Wireframe_extraction/internal/options/Extraction_options.h>
#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>

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

// returns whether it was not cancelled
template <class GeomTraits>
bool refine(Wireframe_skeleton<GeomTraits>& skeleton, const Extraction_options& options,
            const std::function<bool(double)>& proceed)
{
  if (skeleton.support_size() == 0 || skeleton.surroundings().size() == 0 || skeleton.contraction().is_precise())
    return true;
  // the fits of creases take most of the time
  const auto part = [&](double begin, double end) {
    return [&proceed, begin, end](double share) { return proceed(begin + share * (end - begin)); };
  };
  Field_refinement refinement(skeleton.surroundings(), skeleton.contraction(), options.fitting_radius);
  if (!refinement.run(part(0., 0.8)))
    return false;
  const std::shared_ptr<Field_band> band = refined_band(skeleton.surroundings(), refinement, options, part(0.8, 0.9));
  if (!band)
    return false;
  auto contraction = std::make_shared<Contraction>();
  if (!contract(*band, options.fitting_radius, part(0.9, 1.), *contraction))
    return false;
  contraction->noise = options.noise_or((std::max)(contraction->noise, refinement.typical_deviation()));
  contraction->creases = refinement.curves();
  skeleton = skeleton.with_band(band);
  skeleton.set_contraction(contraction);
  return true;
}

} // namespace internal

/*!
\ingroup PkgWireframeExtractionFunctions

corrects the field by the surface, where the surface shows more: a sharp curve is a crease of the surface, and the
points on both sides tell where it is, often better than the estimated distances do.

At every point of the skeleton a crease is fitted to the points around it: two strips that leave a common local curve,
each with a curvature and a twist of its own. Robust Gauss-Newton steps minimise the distances of the points to the
strips, and, with the weight that the noise of the field allows, the differences between the distances to the curve and
the field's. Balls of several radii around `fitting_radius` are tried, and the one is taken that leaves the least
uncertainty. Creases that are sure, sharper than 20 degrees, are followed step by step, also for up to 40 r where the
field does not see them; the next stages start from these curves. Then all distances are computed anew: from the creases
where they agree with the field or were followed; points for which no crease speaks and around which the surface is flat
are left out; others keep their distances. The skeleton and its contraction are replaced.

Precise fields, whose noise level is below 0.03 r, are left as they are, and so is a skeleton that was selected with
`use_creases(false)`.

\tparam ConcurrencyTag `CGAL::Sequential_tag`, `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag` (the default)
\tparam GeomTraits a model of `WireframeExtractionTraits_3`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param skeleton what `select_skeleton()` returns. \pre `skeleton.is_contracted()`, unless it is empty
\param np an optional sequence of named parameters:
\cgalNamedParamsBegin
  \cgalParamNBegin{skeleton_distance}
    \cgalParamDescription{the threshold below which a point belongs to the new skeleton, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{1.5}
  \cgalParamNEnd
  \cgalParamNBegin{support_distance}
    \cgalParamDescription{the threshold below which a point supports the fits, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{3}
  \cgalParamNEnd
  \cgalParamNBegin{fitting_radius}
    \cgalParamDescription{the radius of the balls that the fits take their points from, in multiples of r}
    \cgalParamType{`double`}
    \cgalParamDefault{4}
  \cgalParamNEnd
  \cgalParamNBegin{noise_level}
    \cgalParamDescription{the noise level of the new field, in multiples of r, at most 1}
    \cgalParamType{`double`}
    \cgalParamDefault{the median of the residuals, or the typical deviation of the creases if that is larger}
    \cgalParamExtra{A negative value stands for the default.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a function that is called with the share that is done and returns whether to go on}
    \cgalParamType{an instance of `std::function<bool(double)>`}
    \cgalParamDefault{unused}
    \cgalParamExtra{After cancelling, the skeleton is as it was before.}
  \cgalParamNEnd
\cgalNamedParamsEnd

Complexity: O(n (log n + k)) for n points around the skeleton with k neighbors each. The result is the same for all
tags.
*/
template <class ConcurrencyTag = CGAL::Parallel_if_available_tag, class GeomTraits,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
void refine_field(Wireframe_skeleton<GeomTraits>& skeleton,
                  const NamedParameters& np = CGAL::parameters::default_values())
{
  const std::function<bool(double)> proceed = internal::progress_callback(np);
  const internal::Extraction_options options = internal::extraction_options(np);
  internal::run_concurrently<ConcurrencyTag>([&] { internal::refine(skeleton, options, proceed); });
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_REFINE_FIELD_H
