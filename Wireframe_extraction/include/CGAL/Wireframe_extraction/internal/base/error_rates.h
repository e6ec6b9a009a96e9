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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_ERROR_RATES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_ERROR_RATES_H

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// How many standard deviations errors with a normal distribution rarely exceed: one in so many does.
constexpr double exceeded_by_one_in_22 = 2.;
constexpr double exceeded_by_one_in_80 = 2.5;
constexpr double exceeded_by_one_in_370 = 3.;
constexpr double exceeded_by_one_in_16000 = 4.;

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_BASE_ERROR_RATES_H
