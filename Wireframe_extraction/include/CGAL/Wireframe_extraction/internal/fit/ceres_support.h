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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CERES_SUPPORT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CERES_SUPPORT_H

// Ceres is included here only: its headers are heavy and not free of warnings.

#if defined(__GNUC__)
#pragma GCC system_header
#endif

// not <ceres/ceres.h>, half of which serves nothing here
#include <ceres/cost_function.h>
#include <ceres/evaluation_callback.h>
#include <ceres/iteration_callback.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// for a sparse problem whose solution must depend neither on the axes nor on the number of threads
inline ceres::Solver::Options solver_options(int most_iterations, double function_tolerance)
{
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = function_tolerance;
  // damping that is the same in all directions: the axes must not matter
  options.jacobi_scaling = false;
  options.min_lm_diagonal = options.max_lm_diagonal = 1.;
  options.logging_type = ceres::SILENT;
  options.num_threads = 1; // sums over threads would depend on their number
  return options;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIT_CERES_SUPPORT_H
