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

#ifndef WIREFRAME_BENCHMARK_BENCHMARK_ROW_H
#define WIREFRAME_BENCHMARK_BENCHMARK_ROW_H

#include <Wireframe_evaluation/score_columns.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace Wireframe_benchmark {

/// What came out for one case: values by their names, lengths in sampling distances.
struct Benchmark_row
{
  std::string family, name, field;
  std::string failure;                  ///< empty if there is a usable result
  std::map<std::string, double> values; ///< only those that apply

  /// returns a value, which is not a number if it does not apply.
  double value(const std::string& key) const
  {
    const auto it = values.find(key);
    return it == values.end() ? std::numeric_limits<double>::quiet_NaN() : it->second;
  }

  bool is_failed() const { return !failure.empty(); }

  std::tuple<std::string, std::string, std::string> key() const { return std::make_tuple(family, name, field); }
};

namespace internal {

inline std::string value_name(const Wireframe_evaluation::Score_column& column)
{
  const bool is_length = column.unit == Wireframe_evaluation::Score_unit::LENGTH;
  return std::string(column.name) + (is_length ? "_r" : "");
}

} // namespace internal

/// returns the names of all values of a row, in the order in which they are written.
inline std::vector<std::string> value_names()
{
  std::vector<std::string> result = {"points", "seconds", "cpu_seconds", "peak_megabytes"};
  for (const Wireframe_evaluation::Score_column& column : Wireframe_evaluation::score_columns())
    result.push_back(internal::value_name(column));
  return result;
}

/// puts scores into a row.
inline void set_scores(Benchmark_row& row, const Wireframe_evaluation::Wireframe_scores& scores)
{
  row.failure = scores.failure;
  for (const Wireframe_evaluation::Score_column& column : Wireframe_evaluation::score_columns())
  {
    const bool is_length = column.unit == Wireframe_evaluation::Score_unit::LENGTH;
    const double value = column.get(scores) / (is_length ? scores.sampling_distance : 1.);
    if (!std::isnan(value))
      row.values[internal::value_name(column)] = value;
  }
}

/// returns whether `a` is worse than `b`: failures first, then what has the larger Chamfer distance.
inline bool is_worse(const Benchmark_row& a, const Benchmark_row& b)
{
  const auto badness = [](const Benchmark_row& row) {
    return std::make_tuple(!row.is_failed(), -row.value("chamfer_distance_r"), row.key());
  };
  return badness(a) < badness(b);
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_BENCHMARK_ROW_H
