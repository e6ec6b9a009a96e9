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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_SAMPLING_STEP_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_SAMPLING_STEP_H

#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/number_utils.h>

#include <optional>
#include <type_traits>

namespace CGAL {
namespace IO {
namespace internal {

// the named parameter `sampling_step`, if it was given
template <class NamedParameters>
std::optional<double> get_sampling_step(const NamedParameters& np)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  typedef CGAL::internal_np::Param_not_found Not_found;
  const auto step = CGAL::parameters::get_parameter(np, internal_np::sampling_step);
  if constexpr (std::is_same<std::decay_t<decltype(step)>, Not_found>::value)
    return std::nullopt;
  else
    return CGAL::to_double(step);
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_SAMPLING_STEP_H
