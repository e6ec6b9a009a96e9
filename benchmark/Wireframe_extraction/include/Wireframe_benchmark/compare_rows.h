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

#ifndef WIREFRAME_BENCHMARK_COMPARE_ROWS_H
#define WIREFRAME_BENCHMARK_COMPARE_ROWS_H

#include <Wireframe_benchmark/Benchmark_row.h>
#include <Wireframe_benchmark/Summary.h>
#include <Wireframe_benchmark/Text_table.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {

/// A value that is compared case by case, and how much of a change is none.
struct Compared_value
{
  const char* heading;
  const char* name;
  int digits;
  bool is_less_better;
  double absolute_tolerance, relative_tolerance;
};

/// returns the values that are compared. Seconds are not among them: they differ from run to run.
inline const std::vector<Compared_value>& compared_values()
{
  static const std::vector<Compared_value> values = {{"CD/r", "chamfer_distance_r", 3, true, 0.005, 0.02},
                                                     {"HD/r", "hausdorff_distance_r", 2, true, 0.05, 0.02},
                                                     {"F1@r", "f1_at_1r", 3, false, 0.002, 0.},
                                                     {"curveF1", "curve_f1", 3, false, 0.002, 0.},
                                                     {"curveR6", "long_curve_recall", 3, false, 0.002, 0.},
                                                     {"cornerR", "corner_recall", 3, false, 0.002, 0.},
                                                     {"cornerP", "corner_precision", 3, false, 0.002, 0.},
                                                     {"typedR", "typed_recall", 3, false, 0.002, 0.},
                                                     {"typedP", "typed_precision", 3, false, 0.002, 0.}};
  return values;
}

/// The change of one case. A case is mixed if some of its values got better and others worse.
struct Case_change
{
  enum class Verdict
  {
    WORSE,
    MIXED,
    BETTER,
    SAME
  };

  Benchmark_row before, after;
  std::vector<int> signs; ///< per compared value: 1 better, -1 worse, 0 the same
  Verdict verdict = Verdict::SAME;
};

/// The difference of two runs.
struct Comparison
{
  std::vector<Case_change> changes;            ///< of all cases in both, the worst first
  std::vector<Benchmark_row> before, after;    ///< the rows of these cases
  std::size_t only_before = 0, only_after = 0; ///< how many cases are in one run only
};

namespace internal {

inline int sign_of_change(const Compared_value& value, double before, double after)
{
  if (std::isnan(before) || std::isnan(after))
    return 0;
  if (std::abs(after - before) <= value.absolute_tolerance + value.relative_tolerance * std::abs(before))
    return 0;
  return (after < before) == value.is_less_better ? 1 : -1;
}

inline Case_change change_of(const Benchmark_row& before, const Benchmark_row& after)
{
  Case_change change;
  change.before = before;
  change.after = after;
  bool is_better = before.is_failed() && !after.is_failed(), is_worse = !before.is_failed() && after.is_failed();
  const bool is_decided = is_better || is_worse; // whatever else changed
  for (const Compared_value& value : compared_values())
  {
    const int sign = sign_of_change(value, before.value(value.name), after.value(value.name));
    change.signs.push_back(sign);
    is_better = is_better || (!is_decided && sign > 0);
    is_worse = is_worse || (!is_decided && sign < 0);
  }
  change.verdict = is_worse ? (is_better ? Case_change::Verdict::MIXED : Case_change::Verdict::WORSE)
                            : (is_better ? Case_change::Verdict::BETTER : Case_change::Verdict::SAME);
  return change;
}

inline std::string arrow(const std::string& before, const std::string& after)
{
  return before == after ? before : before + " -> " + after;
}

} // namespace internal

/// compares two runs, case by case.
inline Comparison compare_rows(const std::vector<Benchmark_row>& before, const std::vector<Benchmark_row>& after)
{
  std::map<std::tuple<std::string, std::string, std::string>, Benchmark_row> old_rows;
  for (const Benchmark_row& row : before)
    old_rows[row.key()] = row;
  Comparison result;
  for (const Benchmark_row& row : after)
  {
    const auto it = old_rows.find(row.key());
    if (it == old_rows.end())
    {
      ++result.only_after;
      continue;
    }
    result.changes.push_back(internal::change_of(it->second, row));
    result.before.push_back(it->second);
    result.after.push_back(row);
  }
  result.only_before = old_rows.size() - result.changes.size();
  const auto badness = [](const Case_change& change) {
    const double curve = change.after.value("curve_f1") - change.before.value("curve_f1");
    const double distance = change.after.value("chamfer_distance_r") - change.before.value("chamfer_distance_r");
    return std::make_tuple(static_cast<int>(change.verdict), std::isnan(curve) ? 0. : curve,
                           std::isnan(distance) ? 0. : -distance, change.after.key());
  };
  std::sort(result.changes.begin(), result.changes.end(),
            [&badness](const Case_change& a, const Case_change& b) { return badness(a) < badness(b); });
  return result;
}

/// returns the cases that changed, as a table; values that did not are left empty.
inline Text_table change_table(const Comparison& comparison)
{
  std::vector<std::string> headings = {"change", "family", "case", "field", "failure"};
  for (const Compared_value& value : compared_values())
    headings.push_back(value.heading);
  Text_table table(std::move(headings), 5);
  const char* const verdicts[] = {"worse", "mixed", "better", "same"};
  for (const Case_change& change : comparison.changes)
  {
    if (change.verdict == Case_change::Verdict::SAME)
      continue;
    const auto state = [](const Benchmark_row& row) { return std::string(row.is_failed() ? "fail" : "ok"); };
    const bool is_failed = change.before.is_failed() || change.after.is_failed();
    std::vector<std::string> line = {verdicts[static_cast<int>(change.verdict)], change.after.family, change.after.name,
                                     change.after.field,
                                     is_failed ? internal::arrow(state(change.before), state(change.after)) : ""};
    for (std::size_t i = 0; i < compared_values().size(); ++i)
    {
      const Compared_value& value = compared_values()[i];
      line.push_back(change.signs[i] == 0 ? ""
                                          : internal::arrow(fixed(change.before.value(value.name), value.digits),
                                                            fixed(change.after.value(value.name), value.digits)));
    }
    table.add(std::move(line));
  }
  return table;
}

/// returns how the summaries changed, over the cases that are in both runs.
inline Text_table summary_change_table(const Comparison& comparison)
{
  std::vector<std::string> headings = {"family", "field", "n", "fail"};
  for (const Summary_column& column : summary_columns())
    headings.push_back(column.heading);
  Text_table table(std::move(headings), 2);
  const std::vector<Summary> before = summarize_groups(comparison.before), after = summarize_groups(comparison.after);
  for (std::size_t k = 0; k < after.size(); ++k) // the same groups in the same order
  {
    std::vector<std::string> line = {
      after[k].family.empty() ? "(all)" : after[k].family, after[k].field, std::to_string(after[k].number_of_cases),
      internal::arrow(std::to_string(before[k].number_of_failures), std::to_string(after[k].number_of_failures))};
    for (std::size_t i = 0; i < summary_columns().size(); ++i)
      line.push_back(internal::arrow(fixed(before[k].figures[i], summary_columns()[i].digits),
                                     fixed(after[k].figures[i], summary_columns()[i].digits)));
    table.add(std::move(line));
  }
  return table;
}

/// writes a comparison; `is_markdown` says in which form the tables are.
inline void write_comparison(std::ostream& out, const Comparison& comparison, bool is_markdown)
{
  const auto write = [&out, is_markdown](const Text_table& table) {
    if (is_markdown)
      table.write_markdown(out);
    else
      table.write_text(out);
  };
  std::size_t counts[4] = {0, 0, 0, 0};
  for (const Case_change& change : comparison.changes)
    ++counts[static_cast<int>(change.verdict)];
  out << "Of " << comparison.changes.size() << " cases in both runs: " << counts[2] << " better, " << counts[0]
      << " worse, " << counts[1] << " mixed, " << counts[3] << " the same";
  if (comparison.only_before + comparison.only_after > 0)
    out << "; " << comparison.only_before << " only before, " << comparison.only_after << " only now";
  out << ".\n";
  const Text_table changed = change_table(comparison);
  if (!changed.is_empty())
  {
    out << '\n';
    write(changed);
  }
  if (!comparison.changes.empty())
  {
    out << '\n';
    write(summary_change_table(comparison));
  }
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_COMPARE_ROWS_H
