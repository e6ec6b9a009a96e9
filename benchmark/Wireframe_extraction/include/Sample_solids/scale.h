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

#ifndef SAMPLE_SOLIDS_SCALE_H
#define SAMPLE_SOLIDS_SCALE_H

#include <Sample_solids/Ground_truth.h>
#include <Sample_solids/field_error.h>

#include <vector>

namespace Sample_solids {

/// multiplies all lengths of a cloud by `s`.
inline void scale(Cloud& cloud, double s)
{
  cloud.sampling_distance *= s;
  for (Point& p : cloud.points)
    p = s * p;
  for (double& d : cloud.distances)
    d *= s;
  for (double& d : cloud.exact_distances)
    d *= s;
}

/// multiplies all lengths of a ground truth by `s`.
inline void scale(Ground_truth& truth, double s)
{
  truth.sampling_distance *= s;
  for (std::vector<True_curve>* list : {&truth.curves, &truth.segments})
    for (True_curve& curve : *list)
    {
      curve.length *= s;
      for (Point& p : curve.points)
        p = s * p;
    }
  for (Point& p : truth.corners)
    p = s * p;
}

} // namespace Sample_solids

#endif // SAMPLE_SOLIDS_SCALE_H
