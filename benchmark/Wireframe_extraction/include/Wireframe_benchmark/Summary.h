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

#ifndef WIREFRAME_BENCHMARK_SUMMARY_H
#define WIREFRAME_BENCHMARK_SUMMARY_H

#include <Wireframe_benchmark/Benchmark_row.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {

/// returns the quantile `q` of values, between the two next to it in proportion; not a number if there is no value.
inline double quantile(std::vector<double> values, double q)
{
  if (values.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const double position = q * double(values.size() - 1);
  const std::size_t i = static_cast<std::size_t>(position);
  if (i + 1 >= values.size())
    return values.back();
  const double share = position - double(i);
  return share == 0. ? values[i] : (1. - share) * values[i] + share * values[i + 1];
}

/// returns the mean of values; not a number if there is none.
inline double mean(const std::vector<double>& values)
{
  double sum = 0.;
  for (double value : values)
    sum += value;
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : sum / double(values.size());
}

/// One figure of a summary: how it is headed and printed, and how it is made of rows.
struct Summary_column
{
  enum class Statistic
  {
    MEDIAN,
    MEAN,
    UPPER_DECILE
  };

  const char* heading;
  const char* value;
  Statistic statistic;
  int digits;         ///< behind the decimal point
  int good_direction; ///< 1 if more is better, -1 if less is better, 0 if neither
};

/// returns the columns of a summary. Rates of typed curves are only over the cases to which they apply.
inline const std::vector<Summary_column>& summary_columns()
{
  constexpr auto MEDIAN = Summary_column::Statistic::MEDIAN, MEAN = Summary_column::Statistic::MEAN,
                 UPPER_DECILE = Summary_column::Statistic::UPPER_DECILE;
  static const std::vector<Summary_column> columns = {{"CD/r md", "chamfer_distance_r", MEDIAN, 3, -1},
                                                      {"CD/r mean", "chamfer_distance_r", MEAN, 3, -1},
                                                      {"CD/r q90", "chamfer_distance_r", UPPER_DECILE, 3, -1},
                                                      {"HD/r md", "hausdorff_distance_r", MEDIAN, 2, -1},
                                                      {"HD/r q90", "hausdorff_distance_r", UPPER_DECILE, 2, -1},
                                                      {"F1@r", "f1_at_1r", MEAN, 3, 1},
                                                      {"curveF1", "curve_f1", MEAN, 3, 1},
                                                      {"curveR6", "long_curve_recall", MEAN, 3, 1},
                                                      {"count md", "curve_count_ratio", MEDIAN, 2, 0},
                                                      {"cornerR", "corner_recall", MEAN, 3, 1},
                                                      {"cornerP", "corner_precision", MEAN, 3, 1},
                                                      {"typedR", "typed_recall", MEAN, 3, 1},
                                                      {"typedP", "typed_precision", MEAN, 3, 1},
                                                      {"s md", "seconds", MEDIAN, 2, -1}};
  return columns;
}

/// The figures of a group of cases.
struct Summary
{
  std::string family, field; ///< an empty family stands for all
  std::size_t number_of_cases = 0, number_of_failures = 0;
  std::vector<double> figures; ///< one per column
};

namespace internal {

// A failed case counts as 0 among the rates of typed curves, if the tool gives types at all.
inline std::vector<double> values_of(const std::vector<Benchmark_row>& rows, const std::string& name)
{
  std::vector<double> result;
  std::size_t failures_without_value = 0;
  for (const Benchmark_row& row : rows)
  {
    const double value = row.value(name);
    if (!std::isnan(value))
      result.push_back(value);
    else if (row.is_failed())
      ++failures_without_value;
  }
  if (!result.empty() && name.compare(0, 5, "typed") == 0)
    result.insert(result.end(), failures_without_value, 0.);
  return result;
}

inline double figure(const std::vector<Benchmark_row>& rows, const Summary_column& column)
{
  const std::vector<double> values = values_of(rows, column.value);
  switch (column.statistic)
  {
  case Summary_column::Statistic::MEDIAN: return quantile(values, 0.5);
  case Summary_column::Statistic::UPPER_DECILE: return quantile(values, 0.9);
  case Summary_column::Statistic::MEAN: break;
  }
  return mean(values);
}

} // namespace internal

/// returns the figures of some rows.
inline Summary summarize(const std::vector<Benchmark_row>& rows, const std::string& family, const std::string& field)
{
  Summary result;
  result.family = family;
  result.field = field;
  result.number_of_cases = rows.size();
  result.number_of_failures = static_cast<std::size_t>(
    std::count_if(rows.begin(), rows.end(), [](const Benchmark_row& row) { return row.is_failed(); }));
  for (const Summary_column& column : summary_columns())
    result.figures.push_back(internal::figure(rows, column));
  return result;
}

/// returns one summary per family and field, and, if there are several families, one per field over all of them.
inline std::vector<Summary> summarize_groups(const std::vector<Benchmark_row>& rows)
{
  typedef std::pair<std::string, std::string> Group;
  std::map<Group, std::vector<Benchmark_row>> groups;
  std::map<std::string, std::vector<Benchmark_row>> fields;
  std::set<std::string> families;
  for (const Benchmark_row& row : rows)
  {
    groups[Group(row.family, row.field)].push_back(row);
    fields[row.field].push_back(row);
    families.insert(row.family);
  }
  std::vector<Summary> result;
  for (const auto& group : groups)
    result.push_back(summarize(group.second, group.first.first, group.first.second));
  if (families.size() > 1)
    for (const auto& field : fields)
      result.push_back(summarize(field.second, std::string(), field.first));
  return result;
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_SUMMARY_H
