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

#ifndef SAMPLE_SOLIDS_SAMPLE_SOLIDS_H
#define SAMPLE_SOLIDS_SAMPLE_SOLIDS_H

/// \file
/// Clouds with exact ground truth from closed-form solids, for tests and benchmarks:
/// \code
/// Sample_solids::Solid solid = Sample_solids::make_solid("box");
/// Sample_solids::Sampling_options options;
/// options.sampling_distance = 0.02;
/// Sample_solids::Cloud cloud = Sample_solids::sample(solid, options);
/// Sample_solids::Ground_truth truth = Sample_solids::ground_truth(solid, options.sampling_distance);
/// \endcode
/// Lengths are chosen for a sampling distance of 0.02: edges are 10 to 80 of these long (those of the thin
/// plate's thickness 2), clouds have 5,000 to 30,000 points.

#include <Sample_solids/Ground_truth.h>
#include <Sample_solids/make_solid.h>
#include <Sample_solids/sampling.h>
#include <Sample_solids/scale.h>
#include <Sample_solids/write_case.h>

#endif // SAMPLE_SOLIDS_SAMPLE_SOLIDS_H
