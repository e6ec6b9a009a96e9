// Runs the tool on all cases under a folder, and says how good the results are. See run_benchmark --help.

#include <Wireframe_benchmark/Temporary_folder.h>
#include <Wireframe_benchmark/compare_rows.h>
#include <Wireframe_benchmark/csv.h>
#include <Wireframe_benchmark/find_cases.h>
#include <Wireframe_benchmark/find_program.h>
#include <Wireframe_benchmark/report.h>
#include <Wireframe_benchmark/run_cases.h>
#include <Wireframe_evaluation/one_line.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace Wireframe_benchmark;

enum Exit_code
{
  SUCCESS = 0,
  INTERNAL_ERROR = 1,
  USAGE_ERROR = 2,
  BAD_INPUT = 3,
  STOPPED = 130
};

/// A failure that ends the run.
struct Error : std::runtime_error
{
  Exit_code exit_code;

  Error(Exit_code code, const std::string& text) : std::runtime_error(text), exit_code(code) {}
};

struct Arguments
{
  std::string folder, tool, match, csv, markdown, compare;
  std::vector<std::string> fields;
  std::size_t number_of_jobs = 1;
  double timeout = 120;
  std::size_t megabytes = 0;
  bool is_raw = false, is_quiet = false;
};

volatile std::sig_atomic_t is_stopped = 0;

void stop(int) { is_stopped = 1; }

Tool_command tool_command(const Arguments& a, const char* program)
{
  if (!a.tool.empty())
  {
    const Tool_command command(a.tool);
    if (!is_found(command.program()))
      throw Error(USAGE_ERROR, "--tool: there is no program '" + command.program() + "'");
    return command;
  }
  const fs::path tool = own_folder(program) / "extract_wireframe";
  if (!is_program(tool))
    throw Error(USAGE_ERROR, "there is no program '" + tool.string() + "'; name one with --tool");
  return Tool_command(std::vector<std::string>{tool.string(), "{in}", "-o", "{out}", "--quiet"});
}

std::vector<Benchmark_case> wanted_cases(const Arguments& a)
{
  if (!fs::is_directory(a.folder))
    throw Error(BAD_INPUT, a.folder + ": is not a folder");
  std::vector<Benchmark_case> cases = find_cases(a.folder);
  if (cases.empty())
    throw Error(BAD_INPUT, a.folder + ": there is no case, that is, no folder with truth.json and clouds FIELD.ply");
  std::set<std::string> fields;
  for (const Benchmark_case& c : cases)
    fields.insert(c.field);
  for (const std::string& field : a.fields)
    if (fields.count(field) == 0)
      throw Error(BAD_INPUT, a.folder + ": no case has a field '" + field + "'");
  const auto is_unwanted = [&a](const Benchmark_case& c) {
    return (!a.fields.empty() && std::find(a.fields.begin(), a.fields.end(), c.field) == a.fields.end())
      || (c.family + "/" + c.name).find(a.match) == std::string::npos;
  };
  cases.erase(std::remove_if(cases.begin(), cases.end(), is_unwanted), cases.end());
  if (cases.empty())
    throw Error(BAD_INPUT, a.folder + ": no case has '" + a.match + "' in its name");
  return cases;
}

std::vector<Benchmark_row> rows_before(const Arguments& a)
{
  if (a.compare.empty())
    return {};
  try
  {
    return read_csv(a.compare);
  }
  catch (const std::runtime_error& error)
  {
    throw Error(BAD_INPUT, error.what());
  }
}

/// finds out before the work is done whether a file can be written, without touching what is there.
void check_output(const std::string& path)
{
  if (!path.empty() && !std::ofstream(path, std::ios::app))
    throw Error(USAGE_ERROR, path + ": cannot be written; is its folder there?");
}

template <class Writer>
void write(const std::string& path, Writer writer)
{
  if (path.empty())
    return;
  std::ofstream out(path, std::ios::binary);
  writer(out);
  if (!out.flush())
    throw Error(INTERNAL_ERROR, path + ": cannot be written; is the disk full?");
}

void print_progress(const Benchmark_row& row, std::size_t number, std::size_t all)
{
  std::cerr << '[' << number << '/' << all << "] " << row.family << '/' << row.name << ' ' << row.field << ": ";
  if (row.is_failed())
    std::cerr << "FAIL " << row.failure << '\n';
  else
    std::cerr << "CD " << fixed(row.value("chamfer_distance_r"), 3) << " r, curveF1 " << fixed(row.value("curve_f1"), 3)
              << ", " << fixed(row.value("seconds"), 2) << " s\n";
}

void print_failures(const std::vector<Benchmark_row>& rows)
{
  for (const Benchmark_row& row : rows)
    if (row.is_failed())
      std::cout << "FAIL " << row.family << '/' << row.name << ' ' << row.field << ": " << row.failure << '\n';
}

Exit_code run(const Arguments& a, const char* program)
{
  const Tool_command tool = tool_command(a, program);
  const std::vector<Benchmark_row> old_rows = rows_before(a);
  const std::vector<Benchmark_case> cases = wanted_cases(a);
  check_output(a.csv);
  check_output(a.markdown);

  const Temporary_folder folder;
  const Run_options options = {tool, {a.timeout, a.megabytes}, folder.path(), a.is_raw};
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  std::size_t count = 0;
  Run_result result = run_cases(cases, options, a.number_of_jobs, is_stopped, [&](const Benchmark_row& row) {
    ++count;
    if (!a.is_quiet)
      print_progress(row, count, cases.size());
  });
  if (!result.is_complete)
    throw Error(STOPPED, "stopped");

  std::sort(result.rows.begin(), result.rows.end(), is_worse);
  write(a.csv, [&](std::ostream& out) { write_csv(out, result.rows); });
  const Comparison comparison = compare_rows(old_rows, result.rows);
  write(a.markdown, [&](std::ostream& out) {
    write_markdown(out, result.rows);
    if (!a.compare.empty())
    {
      out << "\n## Compared with before\n\n";
      write_comparison(out, comparison, true);
    }
  });
  summary_table(summarize_groups(result.rows)).write_text(std::cout);
  print_failures(result.rows);
  if (!a.compare.empty())
  {
    std::cout << '\n';
    write_comparison(std::cout, comparison, false);
  }
  std::cout.flush();
  for (const std::string& error : result.errors)
    std::cerr << "run_benchmark: error: " << error << '\n';
  return result.errors.empty() ? SUCCESS : BAD_INPUT;
}

void add_options(CLI::App& app, Arguments& a)
{
  app
    .add_option("DIR", a.folder,
                "a case, that is, a folder with truth.json and one cloud FIELD.ply per field, or a "
                "folder of cases, or of such folders")
    ->required();
  app.add_option("--tool", a.tool,
                 "the command to run on each cloud, with {in} for the cloud, {out} for the result "
                 "(wireframe JSON) and {r} for the sampling distance; without {in} and {out}, "
                 "'{in} -o {out}' is appended. Quotes protect spaces; there is no shell. Default: "
                 "extract_wireframe beside this program");
  app.add_option("-j,--jobs", a.number_of_jobs, "number of cases that run at once")
    ->capture_default_str()
    ->check(CLI::Range(std::size_t(1), std::size_t(1024)));
  app.add_flag("--raw", a.is_raw,
               "give the tool the positions of the points only, without distances and whatever else is known of them");
  app.add_option("--fields", a.fields, "run these fields only, separated by commas")
    ->delimiter(',')
    ->allow_extra_args(false);
  app.add_option("--match", a.match, "run only the cases with this text in FAMILY/NAME");
  app.add_option("--timeout", a.timeout, "seconds after which a run is killed, and the case fails; 0 is never")
    ->capture_default_str()
    ->check(CLI::Range(0., 1e9));
  app.add_option("--memory", a.megabytes, "megabytes of address space that a run may have; 0 is without bound")
    ->capture_default_str()
    ->check(CLI::Range(std::size_t(0), std::size_t(1) << 30));
  app.add_option("--csv", a.csv, "write all values of all cases to this file, the worst cases first");
  app.add_option("--markdown", a.markdown, "write a report to this file");
  app.add_option("--compare", a.compare, "list what got better and worse since this file was written by --csv");
  app.add_flag("--quiet", a.is_quiet, "no line per case while it runs");
  app.footer("A run that crashes, takes too long or writes nothing usable makes a failed case, which counts as\n"
             "CD = HD = the diagonal of the truth and 0 for all rates. Failed cases are results, not errors.\n"
             "Exit code: 0; 2 wrong usage; 3 no cases, or a truth or table that cannot be read.");
}

int fail(Exit_code code, const std::string& text)
{
  std::cerr << "run_benchmark: error: " << Wireframe_evaluation::one_line(text) << '\n';
  return code;
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app("Runs a tool on all cases under a folder, and says how good its wireframes are.", "run_benchmark");
  Arguments arguments;
  add_options(app, arguments);
  try
  {
    app.parse(argc, argv);
    return run(arguments, argv[0]);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
      return app.exit(error);
    return fail(USAGE_ERROR, std::string(error.what()) + " (run_benchmark --help tells more)");
  }
  catch (const Error& error)
  {
    return fail(error.exit_code, error.what());
  }
  catch (const std::invalid_argument& error)
  {
    return fail(USAGE_ERROR, error.what());
  }
  catch (const std::exception& error)
  {
    return fail(INTERNAL_ERROR, error.what());
  }
}
