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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_POSITION_BELIEF_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_POSITION_BELIEF_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/Symmetric_factorization.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <algorithm>
#include <limits>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Where a curve ends is known well across the curve and badly along it. Such a belief is a Gaussian, and beliefs
// about the same corner multiply.
struct Position_belief
{
  Matrix_3 information = Matrix_3::Zero();
  Vector weighted = Vector::Zero(); // information * mean
  double constant = 0.;             // sum of mean^T information mean

  static Position_belief along_line(const Vector& mean, const Vector& direction, double along, double across)
  {
    Position_belief belief;
    const Matrix_3 parallel = Matrix_3::outer(direction, direction);
    belief.information = (Matrix_3::Identity() - parallel) / (across * across);
    if (along < (std::numeric_limits<double>::infinity)())
      belief.information += parallel / (along * along);
    belief.weighted = belief.information * mean;
    belief.constant = mean.dot(belief.weighted);
    return belief;
  }

  Position_belief operator*(const Position_belief& other) const
  {
    Position_belief product;
    product.information = information + other.information;
    product.weighted = weighted + other.weighted;
    product.constant = constant + other.constant;
    return product;
  }

  Vector mean() const { return Symmetric_factorization(information).solved(weighted); }

  // sum of the squared, normalised deviations of the single beliefs from their common mean
  double disagreement() const { return (std::max)(0., constant - weighted.dot(mean())); }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_NETWORK_POSITION_BELIEF_H
