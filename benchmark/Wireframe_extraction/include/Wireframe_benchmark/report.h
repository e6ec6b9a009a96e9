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

#ifndef WIREFRAME_BENCHMARK_REPORT_H
#define WIREFRAME_BENCHMARK_REPORT_H

#include <Wireframe_benchmark/Benchmark_row.h>
#include <Wireframe_benchmark/Summary.h>
#include <Wireframe_benchmark/Text_table.h>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {

/// returns the summaries as a table.
inline Text_table summary_table(const std::vector<Summary>& summaries)
{
  std::vector<std::string> headings = {"family", "field", "n", "fail"};
  for (const Summary_column& column : summary_columns())
    headings.push_back(column.heading);
  Text_table table(std::move(headings), 2);
  for (const Summary& summary : summaries)
  {
    std::vector<std::string> line = {summary.family.empty() ? "(all)" : summary.family, summary.field,
                                     std::to_string(summary.number_of_cases),
                                     std::to_string(summary.number_of_failures)};
    for (std::size_t i = 0; i < summary_columns().size(); ++i)
      line.push_back(fixed(summary.figures[i], summary_columns()[i].digits));
    table.add(std::move(line));
  }
  return table;
}

/// returns the rows as a table, in their order.
inline Text_table case_table(const std::vector<Benchmark_row>& rows)
{
  Text_table table({"family", "case", "field", "failure", "CD/r", "HD/r", "F1@r", "curveF1", "curveR6", "curves",
                    "chains", "cornerR", "cornerP", "typedR", "typedP", "seconds", "MB"},
                   4);
  for (const Benchmark_row& row : rows)
    table.add({row.family, row.name, row.field, row.failure, fixed(row.value("chamfer_distance_r"), 3),
               fixed(row.value("hausdorff_distance_r"), 2), fixed(row.value("f1_at_1r"), 3),
               fixed(row.value("curve_f1"), 3), fixed(row.value("long_curve_recall"), 3),
               fixed(row.value("true_curves"), 0), fixed(row.value("predicted_chains"), 0),
               fixed(row.value("corner_recall"), 3), fixed(row.value("corner_precision"), 3),
               fixed(row.value("typed_recall"), 3), fixed(row.value("typed_precision"), 3),
               fixed(row.value("seconds"), 2), fixed(row.value("peak_megabytes"), 0)});
  return table;
}

/// writes the report as Markdown: the summaries, then all cases in their order.
inline void write_markdown(std::ostream& out, const std::vector<Benchmark_row>& rows)
{
  out << "# Benchmark\n\n"
         "Lengths are in sampling distances r; md is the median, q90 the 90 % quantile. CD is the Chamfer distance,\n"
         "HD the Hausdorff distance, curveR6 the recall of curves of 6 r and longer, count the ratio of predicted to\n"
         "true curves. A failed case counts as CD = HD = the diagonal, and 0 for all rates.\n\n";
  summary_table(summarize_groups(rows)).write_markdown(out);
  out << "\n## Cases, worst first\n\n";
  case_table(rows).write_markdown(out);
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_REPORT_H
