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

#ifndef CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_GET_SAMPLING_H
#define CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_GET_SAMPLING_H

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/Curve_sampling.h>
#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/number_utils.h>

#include <optional>

namespace CGAL {
namespace IO {
namespace internal {

// a number, or one that may be there
inline std::optional<double> optional_number(const std::optional<double>& value) { return value; }

inline std::optional<double> optional_number(const CGAL::internal_np::Param_not_found&) { return std::nullopt; }

template <class Number>
std::optional<double> optional_number(const Number& value)
{
  return CGAL::to_double(value);
}

// the named parameters `sampling_step` and `chord_tolerance`
template <class NamedParameters>
Curve_sampling get_sampling(const NamedParameters& np)
{
  namespace internal_np = CGAL::Wireframe_extraction::internal_np;
  return {optional_number(CGAL::parameters::get_parameter(np, internal_np::sampling_step)),
          optional_number(CGAL::parameters::get_parameter(np, internal_np::chord_tolerance))};
}

} // namespace internal
} // namespace IO
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_IO_INTERNAL_WIREFRAME_GET_SAMPLING_H
