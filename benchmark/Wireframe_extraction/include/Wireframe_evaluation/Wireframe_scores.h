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

#ifndef WIREFRAME_EVALUATION_WIREFRAME_SCORES_H
#define WIREFRAME_EVALUATION_WIREFRAME_SCORES_H

#include <cstddef>
#include <limits>
#include <string>

namespace Wireframe_evaluation {

/*!
How well a wireframe agrees with the true one. Lengths are in the unit of the cloud, shares between 0 and 1; what does
not apply is not a number. If `failure` is not empty there was no usable result: then all distances are the diagonal
of the box around the true curves, and all shares are 0.
*/
struct Wireframe_scores
{
  static constexpr double not_applicable = std::numeric_limits<double>::quiet_NaN();

  std::string failure;          ///< why there is no usable result; empty if there is one
  double sampling_distance = 0; ///< r, of the truth
  double diagonal = 0;          ///< of the box around the true curves

  /// \name Distances
  /// Of samples 0.1 r apart along the curves, to the curves of the other side.
  /// @{
  double chamfer_distance = 0;   ///< mean of the two one-sided mean distances, not squared
  double hausdorff_distance = 0; ///< larger one of the two one-sided largest distances
  double recall_at_1r = 0;       ///< share of the true samples closer than r to the prediction
  double precision_at_1r = 0;    ///< share of the predicted samples closer than r to the truth
  double f1_at_1r = 0;           ///< their harmonic mean
  double recall_at_2r = 0;       ///< as above, for 2 r
  double precision_at_2r = 0;    ///< as above, for 2 r
  double f1_at_2r = 0;           ///< as above, for 2 r
  /// @}

  /// \name Distances as Other Papers Report Them
  /// After the box around the true curves is scaled to the cube from -1 to 1, its longest side filling it. They have no
  /// unit, and are not to be compared with those above.
  /// @{
  double squared_chamfer_unit_cube = 0;    ///< sum of the two one-sided means of squared distances
  double averaged_hausdorff_unit_cube = 0; ///< mean of the two one-sided largest distances
  /// @}

  /// \name Corners
  /// Matched one to one within 3 r.
  /// @{
  std::size_t true_corners = 0;
  std::size_t predicted_corners = 0;
  double corner_recall = 0;
  double corner_precision = 0;
  /// @}

  /// \name Curves
  /// Chained through smooth vertices on both sides, and matched one to one where their mutual Hausdorff distance is
  /// below 2 r.
  /// @{
  std::size_t true_curves = 0;      ///< number of true chains
  std::size_t predicted_curves = 0; ///< number of curves in the file
  std::size_t predicted_chains = 0; ///< number of chains they make
  double curve_count_ratio = 0;     ///< predicted chains per true chain
  double curve_recall = 0;
  double curve_precision = 0;
  double curve_f1 = 0;          ///< harmonic mean of the two
  double long_curve_recall = 0; ///< recall of the true chains of 6 r and longer; 1 if there are none
  /// @}

  /// \name Types
  /// Of single curves: lines, circles and arcs, ellipses. They apply if the prediction has such curves at all, and
  /// the truth has segments. Pieces of one line or circle are joined first.
  /// @{
  double typed_recall = not_applicable;    ///< of true primitives of 8 r and longer: matched with their type
  double typed_precision = not_applicable; ///< of predicted primitives of 8 r and longer: matched with their type
  double splines_called_primitive = not_applicable; ///< share of the matched true splines
  double radius_error = not_applicable;             ///< median over the matched circles and arcs of 8 r and longer
  /// @}

  double end_gap = 0; ///< largest distance of the end of a curve to its vertex, or of a closed curve's two ends
};

/// returns the harmonic mean, the F1 score of a recall and a precision.
inline double f1_score(double recall, double precision)
{
  return recall + precision > 0. ? 2. * recall * precision / (recall + precision) : 0.;
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_WIREFRAME_SCORES_H
