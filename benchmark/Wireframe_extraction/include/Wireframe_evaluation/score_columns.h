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

#ifndef WIREFRAME_EVALUATION_SCORE_COLUMNS_H
#define WIREFRAME_EVALUATION_SCORE_COLUMNS_H

#include <Wireframe_evaluation/Wireframe_scores.h>

#include <vector>

namespace Wireframe_evaluation {

enum class Score_unit
{
  LENGTH,
  NUMBER,
  COUNT
};

/// A score with its name in files, what it is, and how to get it.
struct Score_column
{
  const char* name;
  Score_unit unit;
  const char* description;
  double (*get)(const Wireframe_scores&);
};

/// returns all scores in the order in which they are written. One list, so that no writer forgets one.
inline const std::vector<Score_column>& score_columns()
{
  typedef const Wireframe_scores& S;
  constexpr Score_unit LENGTH = Score_unit::LENGTH, NUMBER = Score_unit::NUMBER, COUNT = Score_unit::COUNT;
  static const std::vector<Score_column> columns = {
    {"chamfer_distance", LENGTH, "mean of the two one-sided mean distances", [](S s) { return s.chamfer_distance; }},
    {"hausdorff_distance", LENGTH, "larger of the two one-sided largest distances",
     [](S s) { return s.hausdorff_distance; }},
    {"recall_at_1r", NUMBER, "share of the truth closer than r", [](S s) { return s.recall_at_1r; }},
    {"precision_at_1r", NUMBER, "share of the prediction closer than r", [](S s) { return s.precision_at_1r; }},
    {"f1_at_1r", NUMBER, "their harmonic mean", [](S s) { return s.f1_at_1r; }},
    {"recall_at_2r", NUMBER, "share of the truth closer than 2 r", [](S s) { return s.recall_at_2r; }},
    {"precision_at_2r", NUMBER, "share of the prediction closer than 2 r", [](S s) { return s.precision_at_2r; }},
    {"f1_at_2r", NUMBER, "their harmonic mean", [](S s) { return s.f1_at_2r; }},
    {"squared_chamfer_unit_cube", NUMBER, "sum of the mean squared distances, in the cube [-1, 1]",
     [](S s) { return s.squared_chamfer_unit_cube; }},
    {"averaged_hausdorff_unit_cube", NUMBER, "mean of the two largest distances, in the cube [-1, 1]",
     [](S s) { return s.averaged_hausdorff_unit_cube; }},
    {"true_corners", COUNT, "corners of the truth", [](S s) { return double(s.true_corners); }},
    {"predicted_corners", COUNT, "corners of the prediction", [](S s) { return double(s.predicted_corners); }},
    {"corner_recall", NUMBER, "share of the true corners found within 3 r", [](S s) { return s.corner_recall; }},
    {"corner_precision", NUMBER, "share of the predicted corners that match", [](S s) { return s.corner_precision; }},
    {"true_curves", COUNT, "chains of the truth", [](S s) { return double(s.true_curves); }},
    {"predicted_curves", COUNT, "curves of the prediction", [](S s) { return double(s.predicted_curves); }},
    {"predicted_chains", COUNT, "chains they make", [](S s) { return double(s.predicted_chains); }},
    {"curve_count_ratio", NUMBER, "predicted chains per true chain", [](S s) { return s.curve_count_ratio; }},
    {"curve_recall", NUMBER, "share of the true chains matched within 2 r", [](S s) { return s.curve_recall; }},
    {"curve_precision", NUMBER, "share of the predicted chains that match", [](S s) { return s.curve_precision; }},
    {"curve_f1", NUMBER, "their harmonic mean", [](S s) { return s.curve_f1; }},
    {"long_curve_recall", NUMBER, "curve recall of chains of 6 r and longer", [](S s) { return s.long_curve_recall; }},
    {"typed_recall", NUMBER, "share of the true primitives found as such", [](S s) { return s.typed_recall; }},
    {"typed_precision", NUMBER, "share of the predicted primitives that are right",
     [](S s) { return s.typed_precision; }},
    {"splines_called_primitive", NUMBER, "share of the matched true splines called something else",
     [](S s) { return s.splines_called_primitive; }},
    {"radius_error", LENGTH, "median over the matched circles and arcs", [](S s) { return s.radius_error; }},
    {"end_gap", LENGTH, "largest distance of an end to its vertex", [](S s) { return s.end_gap; }}};
  return columns;
}

} // namespace Wireframe_evaluation

#endif // WIREFRAME_EVALUATION_SCORE_COLUMNS_H
