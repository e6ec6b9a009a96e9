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

#ifndef WIREFRAME_BENCHMARK_RUN_CASES_H
#define WIREFRAME_BENCHMARK_RUN_CASES_H

#include <Wireframe_benchmark/Benchmark_row.h>
#include <Wireframe_benchmark/Process_pool.h>
#include <Wireframe_benchmark/run_case.h>

#include <nlohmann/json.hpp>

#include <csignal>
#include <cstddef>
#include <exception>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {

/// What came out for all cases that could be run, and what was wrong with the others.
struct Run_result
{
  std::vector<Benchmark_row> rows;
  std::vector<std::string> errors;
  bool is_complete = true; ///< `false` if it was stopped
};

namespace internal {

typedef nlohmann::json Json;

// runs in a process of its own, whose only way to tell something is this text
inline std::string row_as_text(const std::function<Benchmark_row()>& make_row)
{
  Json document;
  try
  {
    const Benchmark_row row = make_row();
    document["failure"] = row.failure;
    document["values"] = Json::object();
    for (const auto& value : row.values)
      document["values"][value.first] = value.second; // an infinite one becomes null
  }
  catch (const std::exception& error)
  {
    document = Json{{"error", error.what()}};
  }
  return document.dump(-1, ' ', false, Json::error_handler_t::replace);
}

inline Benchmark_row row_of_text(const Benchmark_case& c, const Json& document)
{
  Benchmark_row row = row_of(c);
  row.failure = document["failure"].get<std::string>();
  for (const auto& value : document["values"].items())
    if (value.value().is_number())
      row.values[value.key()] = value.value().get<double>();
  return row;
}

} // namespace internal

/*!
runs cases, each in a process of its own that runs the tool and evaluates what it writes: so the process that calls
this stays small and whatever happens, the other cases go on.

\param cases the cases
\param options how they are run
\param number_of_jobs how many at once
\param is_stopped is looked at all the time; when it is set all processes are ended
\param progress is called with every row as it comes

\return the rows, in the order in which they came
*/
inline Run_result run_cases(const std::vector<Benchmark_case>& cases, const Run_options& options,
                            std::size_t number_of_jobs, const volatile std::sig_atomic_t& is_stopped,
                            const std::function<void(const Benchmark_row&)>& progress)
{
  Run_result result;
  Process_pool pool(number_of_jobs);
  std::vector<std::size_t> case_of_work;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    const Benchmark_case& c = cases[i];
    pool.add([&c, &options, i] {
      end_together_with_program();
      return internal::row_as_text([&] { return run_case(c, options, i); });
    });
    case_of_work.push_back(i);
  }
  result.is_complete = pool.run(
    [&](std::size_t work, bool is_well, const std::string& text) {
      const Benchmark_case& c = cases[case_of_work[work]];
      const bool is_first_try = work < cases.size();
      if (!is_well && is_first_try)
      {
        const std::string failure = "the evaluation crashed: " + text;
        pool.add([&c, failure] { return internal::row_as_text([&] { return failed_case(c, failure); }); });
        case_of_work.push_back(case_of_work[work]);
        return;
      }
      const internal::Json document = is_well ? internal::Json::parse(text) : internal::Json{{"error", text}};
      if (document.contains("error"))
      {
        result.errors.push_back(c.truth.string() + ": " + document["error"].get<std::string>());
        return;
      }
      result.rows.push_back(internal::row_of_text(c, document));
      progress(result.rows.back());
    },
    is_stopped);
  return result;
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_RUN_CASES_H
