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

#ifndef WIREFRAME_BENCHMARK_RUN_CASE_H
#define WIREFRAME_BENCHMARK_RUN_CASE_H

#include <Wireframe_benchmark/Benchmark_row.h>
#include <Wireframe_benchmark/Tool_command.h>
#include <Wireframe_benchmark/find_cases.h>
#include <Wireframe_benchmark/run_process.h>
#include <Wireframe_benchmark/write_bare_points.h>

#include <Wireframe_evaluation/evaluate_wireframe.h>
#include <Wireframe_evaluation/one_line.h>
#include <Wireframe_evaluation/read_truth.h>

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace Wireframe_benchmark {

/// How all cases are run.
struct Run_options
{
  Tool_command tool;
  Process_limits limits;
  fs::path work_folder; ///< for results, which are removed again
  bool is_raw = false;  ///< whether the tool gets positions only
};

namespace internal {

// a row without values
inline Benchmark_row row_of(const Benchmark_case& c)
{
  Benchmark_row row;
  row.family = c.family;
  row.name = c.name;
  row.field = c.field;
  return row;
}

// the last line that says something, in one line of moderate length
inline std::string last_line(const fs::path& path)
{
  std::ifstream in(path);
  std::string line, last;
  while (std::getline(in, line))
    if (line.find_first_not_of(" \t\r") != std::string::npos)
      last = line;
  return Wireframe_evaluation::one_line(last);
}

inline std::string replaced(std::string text, const std::string& what, const std::string& by)
{
  for (std::size_t i = text.find(what); i != std::string::npos; i = text.find(what, i + by.size()))
    text.replace(i, what.size(), by);
  return text;
}

inline std::string shortened(const std::string& text)
{
  const std::size_t most = 200;
  return text.size() <= most ? text : text.substr(0, most) + " ...";
}

inline std::string failure_of_process(const Process_result& process, const Process_limits& limits,
                                      const std::string& message)
{
  std::ostringstream text;
  if (process.is_timed_out)
    text << "timeout: killed after " << limits.seconds << " s";
  else if (process.signal != 0)
    text << "killed by signal " << process.signal << " (" << strsignal(process.signal) << ")";
  else if (process.exit_code != 0)
    text << "exit " << process.exit_code;
  if (text.str().empty() || process.is_timed_out || message.empty())
    return text.str();
  return text.str() + ": " + shortened(message);
}

} // namespace internal

/*!
runs the tool on a case, and evaluates what it writes. Whatever the tool does wrong makes a failed case.

Throws `Wireframe_evaluation::Format_error` if the truth cannot be read, and `std::runtime_error` if no process can
be started.

\param c the case
\param options how to run it
\param id tells the files of this case from those of others
*/
inline Benchmark_row run_case(const Benchmark_case& c, const Run_options& options, std::size_t id)
{
  using namespace Wireframe_evaluation;
  const std::string result = (options.work_folder / (std::to_string(id) + ".json")).string();
  const std::string errors = (options.work_folder / (std::to_string(id) + ".txt")).string();
  std::ostringstream r;
  r.precision(17);
  if (options.tool.uses_sampling_distance())
    r << read_truth(c.truth.string()).sampling_distance;

  fs::path cloud = c.cloud;
  if (options.is_raw)
  {
    cloud = options.work_folder / (std::to_string(id) + ".ply");
    write_bare_points(c.cloud, cloud);
  }

  // The truth is read after this: the memory that this process has at the fork counts as the tool's.
  const Process_result process =
    run_process(options.tool.words(cloud.string(), result, r.str()), errors, options.limits);
  // the files have long names that tell nothing
  std::string message = internal::replaced(internal::last_line(errors), cloud.string(), c.cloud.filename().string());
  message = internal::replaced(message, result, "the result");
  const std::string failure = internal::failure_of_process(process, options.limits, message);

  const True_wireframe truth = read_truth(c.truth.string());
  Wireframe_scores scores;
  if (!failure.empty())
    scores = failed_scores(truth, failure);
  else if (!fs::exists(result))
    scores = failed_scores(truth, "no result was written");
  else
    scores = evaluate_wireframe(truth, result);
  std::error_code ignored;
  fs::remove(result, ignored);
  fs::remove(errors, ignored);
  if (options.is_raw)
    fs::remove(cloud, ignored);

  Benchmark_row row = internal::row_of(c);
  set_scores(row, scores);
  if (truth.number_of_points > 0)
    row.values["points"] = double(truth.number_of_points);
  row.values["seconds"] = process.seconds;
  row.values["cpu_seconds"] = process.cpu_seconds;
  row.values["peak_megabytes"] = process.peak_megabytes;
  return row;
}

/// returns the row of a case that failed outside of the tool. Throws as `run_case()`.
inline Benchmark_row failed_case(const Benchmark_case& c, const std::string& failure)
{
  Benchmark_row row = internal::row_of(c);
  set_scores(row, Wireframe_evaluation::failed_scores(Wireframe_evaluation::read_truth(c.truth.string()), failure));
  return row;
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_RUN_CASE_H
