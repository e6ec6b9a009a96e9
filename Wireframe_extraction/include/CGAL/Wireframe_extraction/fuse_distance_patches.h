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

#ifndef CGAL_WIREFRAME_EXTRACTION_FUSE_DISTANCE_PATCHES_H
#define CGAL_WIREFRAME_EXTRACTION_FUSE_DISTANCE_PATCHES_H

#include <CGAL/Wireframe_extraction/Distance_patch.h>
#include <CGAL/Wireframe_extraction/IO/internal/file/parameter_tools.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Patch_fuser.h>
#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {

/// \ingroup PkgWireframeExtractionFunctions
/// puts patches of a cloud that overlap together: every point gets one distance.
///
/// If all patches have indices, points with the same index are the same, and the cloud has the order of the indices.
/// Otherwise points are the same that are closer to each other than 10<sup>-6</sup> of the diagonal of the box around
/// the middle nine tenths of the coordinates, and the cloud is sorted by `x`, `y` and `z`. Of points that are the same,
/// the first one in the order of `x`, `y` and `z` is kept. The result does not depend on the order of the patches.
///
/// A regressor such as DEF sees one patch at a time. What a point is close to may lie outside of its patch; then the
/// estimate is too large, mostly the bound at which distances are cut off. Errors of this kind, which the minimum
/// leaves out, are the ones to be expected near the borders of patches, so it is the default. The median leaves
/// out single estimates that are too small, at the price of features which few of the patches see.
///
/// \tparam Point a point type with the member functions `x()`, `y()` and `z()`
/// \tparam FT a model of `FieldNumberType` that is constructible from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param patches the patches
/// \param cloud the points and their distances. What it held before is replaced; it is left as it was on failure.
/// \param np an optional sequence of named parameters among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{patch_fusion}
///     \cgalParamDescription{what becomes of several distances of a point}
///     \cgalParamType{`Patch_fusion`}
///     \cgalParamDefault{`Patch_fusion::MINIMUM`}
///   \cgalParamNEnd
///   \wireframeParamErrorMessage
/// \cgalNamedParamsEnd
///
/// \return `true` if there is a cloud, else `false`: there are no points, a coordinate or distance is not finite, a
///   distance is negative, or an index stands for points that are more than 10<sup>-3</sup> of that diagonal apart.
///
/// Takes \f$ O(n \log n) \f$ time and linear memory for \f$ n \f$ points, unless many of them lie within a layer
/// that is thinner than the tolerance and perpendicular to one direction, which no plane of a shape is likely to be.
template <class Point, class FT, typename CGAL_NP_TEMPLATE_PARAMETERS>
bool fuse_distance_patches(const std::vector<Distance_patch<Point, FT>>& patches,
                           std::vector<std::pair<Point, FT>>& cloud,
                           const CGAL_NP_CLASS& np = CGAL::parameters::default_values())
{
  const Patch_fusion fusion = CGAL::parameters::choose_parameter(
    CGAL::parameters::get_parameter(np, internal_np::patch_fusion), Patch_fusion::MINIMUM);
  std::vector<std::pair<Point, FT>> result;
  const std::string error = internal::Patch_fuser<Point, FT>(fusion).fuse(patches, result);
  if (error.empty())
    cloud.swap(result);
  return CGAL::IO::internal::report(np, error);
}

} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_FUSE_DISTANCE_PATCHES_H
