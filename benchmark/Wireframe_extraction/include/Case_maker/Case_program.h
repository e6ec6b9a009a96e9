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

#ifndef CASE_MAKER_CASE_PROGRAM_H
#define CASE_MAKER_CASE_PROGRAM_H

#include <Case_maker/Annotated_shape.h>
#include <Case_maker/Case_error.h>
#include <Case_maker/choose_scale.h>
#include <Case_maker/number_check.h>
#include <Sample_solids/field_error.h>
#include <Sample_solids/write_case.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <new>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace Case_maker {

/// One shape to make a case of.
struct Case_job
{
  std::string name;
  std::vector<std::string> files;
  std::string problem; ///< why it cannot be made; empty if it can
};

/// The part that programs which make cases have in common: options, writing, and going through many shapes.
class Case_program
{
public:
  /// makes the shape of a job, scaled
  typedef std::function<Annotated_shape(const Case_job&, const Scale_rule&)> Shape_maker;
  /// says what is to be done, once the options are known
  typedef std::function<std::vector<Case_job>()> Job_maker;

  Case_program(const std::string& name, const std::string& description) : m_name(name), m_app(description, name)
  {
    m_app.set_version_flag("--version", m_name + " " + WIREFRAME_EXTRACTION_VERSION_STRING);
    m_app.add_option("-o,--output", m_output, "directory in which each shape gets a directory of its own");
    m_app.add_option("--name", m_case_name, "name of the directory of a single shape; default: that of its file");
    m_app.add_option("--batch", m_batch, "make a case of every shape in this directory and those below");
    m_app.add_option("--r,--sampling-distance", m_rule.sampling_distance, "sampling distance, after scaling")
      ->capture_default_str()
      ->check(number_check());
    m_app
      .add_option("--quantile", m_rule.quantile,
                  "shapes are scaled by this quantile of the lengths of their sharp curves; 0 is the shortest "
                  "curve, 1 the longest")
      ->capture_default_str()
      ->check(CLI::Range(0., 1.));
    m_app
      .add_option("--quantile-length", m_rule.quantile_length,
                  "how long the curves of this quantile become, in sampling distances")
      ->capture_default_str()
      ->check(number_check());
    m_app.add_option("--max-points", m_rule.max_points, "most points of a cloud")
      ->capture_default_str()
      ->check(CLI::Range(std::size_t(50), std::size_t(100000000)));
    m_app
      .add_option("--too-many", m_too_many,
                  "what becomes of shapes that need more points: they are made smaller, so that their curves "
                  "become shorter, or left out")
      ->capture_default_str()
      ->check(CLI::IsMember({"coarsen", "skip"}));
    m_app.add_option("--truncate", m_sampling.truncation, "upper bound of the field, in sampling distances")
      ->capture_default_str()
      ->check(number_check());
    m_app
      .add_option("--field-scope", m_scope,
                  "which sharp curves count: those of the point's own surface and the surfaces adjacent to it, "
                  "or all")
      ->capture_default_str()
      ->check(CLI::IsMember({"adjacent", "all"}));
    m_app.add_option("--fields", m_fields, "the fields, separated by commas")
      ->capture_default_str()
      ->delimiter(',')
      ->check(CLI::IsMember({"exact", "def", "noisy"}));
    m_app
      .add_option("--position-noise", m_position_noise,
                  "by how much the noisy field's points are moved: the standard deviation per coordinate, in "
                  "sampling distances")
      ->capture_default_str()
      ->check(CLI::NonNegativeNumber);
    m_app.add_option("--seed", m_sampling.seed, "of the random numbers, a whole number")->capture_default_str();
    m_app.add_flag("--force", m_is_forced, "overwrite cases that exist");
    m_app.add_flag("--skip-existing", m_is_existing_skipped, "leave out cases that exist, to go on with a batch");
  }

  CLI::App& options() { return m_app; }
  const std::string& batch_directory() const { return m_batch; }
  const std::string& name_of_case() const { return m_case_name; }

  int run(int argc, char** argv, const Job_maker& make_jobs, const Shape_maker& make_shape)
  {
    try
    {
      m_app.parse(argc, argv);
      check();
      const std::vector<Case_job> jobs = make_jobs();
      if (!m_batch.empty())
        return run_batch(jobs, make_shape);
      run_job(jobs.front(), make_shape);
      return SUCCESS;
    }
    catch (const CLI::ParseError& error)
    {
      if (error.get_exit_code() == 0)
        return m_app.exit(error);
      return report(error.what(), USAGE_ERROR);
    }
    catch (const std::exception& error)
    {
      return report(error);
    }
  }

private:
  void check()
  {
    if (m_output.empty())
      throw Case_error(USAGE_ERROR, "say where to write: -o DIRECTORY");
    if (!m_batch.empty() && !m_case_name.empty())
      throw Case_error(USAGE_ERROR, "--name is for a single shape, not for a batch");
    if (m_is_forced && m_is_existing_skipped)
      throw Case_error(USAGE_ERROR, "--force and --skip-existing contradict each other");
    if (!m_batch.empty() && !std::filesystem::is_directory(m_batch))
      throw Case_error(USAGE_ERROR, "'" + m_batch + "' is not a directory");
    m_sampling.sampling_distance = m_rule.sampling_distance;
    m_sampling.scope = m_scope == "all" ? Field_scope::ALL : Field_scope::ADJACENT;
    m_rule.is_coarsened = m_too_many == "coarsen";
  }

  /// makes all cases; what goes wrong with one is told, and the others are made.
  int run_batch(const std::vector<Case_job>& jobs, const Shape_maker& make_shape)
  {
    std::size_t made = 0, skipped = 0, failed = 0;
    for (const Case_job& job : jobs)
      try
      {
        run_job(job, make_shape);
        ++made;
      }
      catch (const Case_skipped& reason)
      {
        std::cout << job.name << ": left out: " << reason.what() << std::endl;
        ++skipped;
      }
      catch (const Case_error& error)
      {
        if (error.exit_code() == NO_SHARP_CURVE) // such shapes there are, and nothing is wrong with them
        {
          std::cout << job.name << ": left out: " << error.what() << std::endl;
          ++skipped;
          continue;
        }
        if (error.exit_code() == INTERNAL_ERROR) // the disk is full: the others would fail, too
          throw;
        std::cerr << m_name << ": " << job.name << ": " << error.what() << std::endl;
        ++failed;
      }
      catch (const std::exception& error)
      {
        std::cerr << m_name << ": " << job.name << ": ";
        report(error);
        ++failed;
      }
    std::cout << made << " cases made, " << skipped << " left out, " << failed << " failed\n";
    return failed > 0 ? BAD_INPUT : SUCCESS;
  }

  void run_job(const Case_job& job, const Shape_maker& make_shape)
  {
    namespace fs = std::filesystem;
    if (!job.problem.empty())
      throw bad_input(job.problem);
    const fs::path directory = fs::path(m_output) / job.name;
    // the truth is written last: where it is, the case is complete
    if (fs::exists(directory / "truth.json") && !m_is_forced)
    {
      if (m_is_existing_skipped)
        throw Case_skipped("it exists");
      throw Case_error(USAGE_ERROR,
                       "'" + directory.string()
                         + "' exists; --force overwrites it, "
                           "--skip-existing leaves it out");
    }
    const Annotated_shape shape = make_shape(job, m_rule);
    std::error_code ignored;
    fs::create_directories(directory, ignored);
    if (!fs::is_directory(directory))
      throw Case_error(USAGE_ERROR, "cannot make the directory '" + directory.string() + "'");
    fs::remove(directory / "truth.json", ignored);
    write_case(directory, job.name, shape);
  }

  void write_case(const std::filesystem::path& directory, const std::string& case_of, const Annotated_shape& shape)
  {
    Cloud exact = sample_exactly(shape, m_sampling);
    const double r = m_sampling.sampling_distance;
    const Ground_truth truth = ground_truth(shape.edges, r);
    std::ostringstream text;
    text << case_of << ": " << exact.points.size() << " points, sampling distance " << r << ", " << truth.curves.size()
         << " curves (" << truth.segments.size() << " segments), " << truth.corners.size() << " corners";
    if (!shape.remarks.empty())
      text << "; " << shape.remarks;
    std::cout << text.str() << std::endl;
    for (const std::string& field : m_fields)
    {
      const Field_kind kind = field_kind_of(field);
      Cloud cloud = exact;
      disturb(cloud, kind, kind == Field_kind::NOISY ? m_position_noise : 0., m_sampling.seed);
      write(directory / (field + ".ply"), [&](std::ostream& out) { return write_ply(out, cloud); });
    }
    write(directory / "truth.json",
          [&](std::ostream& out) { return write_truth(out, truth, case_of, exact.points.size()); });
  }

  template <class Writer>
  static void write(const std::filesystem::path& path, Writer writer)
  {
    std::ofstream out(path, std::ios::binary);
    if (!out)
      throw Case_error(USAGE_ERROR, "cannot write '" + path.string() + "'; may its directory be written?");
    if (!writer(out))
      throw Case_error(INTERNAL_ERROR, "writing '" + path.string() + "' failed; is the disk full?");
  }

  int report(const std::string& text, int code) const
  {
    std::cerr << m_name << ": " << text << '\n';
    return code;
  }

  int report(const std::exception& error) const
  {
    if (const Case_error* known = dynamic_cast<const Case_error*>(&error))
      return report(known->what(), known->exit_code());
    if (dynamic_cast<const Case_skipped*>(&error))
      return report(std::string("left out: ") + error.what(), SUCCESS);
    if (dynamic_cast<const std::bad_alloc*>(&error))
      return report("not enough memory; ask for fewer points (--max-points)", INTERNAL_ERROR);
    return report(error.what(), INTERNAL_ERROR);
  }

  std::string m_name;
  CLI::App m_app;
  std::string m_output, m_case_name, m_batch, m_too_many = "coarsen", m_scope = "adjacent";
  std::vector<std::string> m_fields = {"exact", "def", "noisy"};
  Scale_rule m_rule;
  Case_sampling m_sampling;
  double m_position_noise = 0.25;
  bool m_is_forced = false, m_is_existing_skipped = false;
};

/// returns the files below a directory whose names end in one of the given ways, sorted.
inline std::vector<std::string> files_below(const std::string& directory, const std::vector<std::string>& endings)
{
  namespace fs = std::filesystem;
  std::vector<std::string> result;
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(directory, fs::directory_options::skip_permission_denied))
  {
    std::string ending = entry.path().extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (entry.is_regular_file() && std::find(endings.begin(), endings.end(), ending) != endings.end())
      result.push_back(entry.path().string());
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// marks all but the first of the jobs that have the same name.
inline void mark_duplicates(std::vector<Case_job>& jobs)
{
  for (std::size_t i = 0; i < jobs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (jobs[i].name == jobs[j].name && jobs[i].problem.empty())
        jobs[i].problem =
          "'" + jobs[i].files.front() + "' would get the same directory as '" + jobs[j].files.front() + "'; rename one";
}

} // namespace Case_maker

#endif // CASE_MAKER_CASE_PROGRAM_H
