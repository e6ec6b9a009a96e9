// The command line tool: a cloud with distances in, its wireframe out. See extract_wireframe --help.

#include "Command_line.h"
#include "Error.h"
#include "Extraction_run.h"
#include "Options.h"
#include "Output_files.h"
#include "run_batch.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/write_beside_and_rename.h>

#ifdef EXTRACT_WIREFRAME_WITH_GLOG
#include <glog/logging.h>
#endif

#include <algorithm>
#include <exception>
#include <functional>
#include <iostream>
#include <new>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace tool {

// Does some work, and returns how it ended: the exit code, and what went wrong.
std::pair<int, std::string> outcome_of(const std::function<int()>& work)
{
  try
  {
    return {work(), std::string()};
  }
  catch (const Error& error)
  {
    return {error.exit_code, error.what()};
  }
  catch (const std::bad_alloc&)
  {
    return {INTERNAL_ERROR, "there is not enough memory for this cloud"};
  }
  catch (const std::exception& error)
  {
    return {INTERNAL_ERROR, std::string("unexpected: ") + error.what()};
  }
}

int run_one(const Command_line& command_line, const Options& options)
{
  Extraction_run(command_line, options).run();
  return SUCCESS;
}

// pages and pictures have options of their own
void take_output(const std::string& name, Options& options)
{
  const std::string extension = CGAL::IO::internal::lower_extension(name);
  options.has_html = options.has_html || extension == ".html";
  options.has_png = options.has_png || extension == ".png";
  if (extension == ".html")
    options.html = name;
  else if (extension == ".png")
    options.png = name;
  else
    options.outputs.push_back(name);
}

// Cloud by cloud, each in a process of its own, where this is the same as if the tool were called for it.
int run_many(const Command_line& command_line, const Options& options)
{
  Options of_cloud = options;
  of_cloud.is_quiet = true;
  if (of_cloud.number_of_threads == 0)
    of_cloud.number_of_threads = (std::max)(number_of_processors() / (std::max)(options.batch.number_of_jobs, 1), 1);
  if (options.batch.number_of_jobs == 0)
    of_cloud.number_of_threads = (std::max)(options.number_of_threads, 1);
  for (const std::string& format : options.batch.formats)
    if (format == "html" ? !has_viewer() : format == "png" ? !has_png() : true)
      Output_files<Kernel>::check_extension("--format ." + format,
                                            CGAL::IO::internal::lower_extension("OUT." + format));
  return run_batch(options.batch, [&](const std::string& cloud, const std::vector<std::string>& outputs) {
    Cloud_result result;
    of_cloud.input.files = {cloud};
    of_cloud.outputs.clear();
    for (const std::string& output : outputs)
      take_output(output, of_cloud);
    std::tie(result.exit_code, result.error) = outcome_of([&] {
      Extraction_run run(command_line, of_cloud);
      try
      {
        run.run();
      }
      catch (...)
      {
        result.mesh_kind = run.result().mesh_kind; // which may be why
        throw;
      }
      result = run.result();
      return SUCCESS;
    });
    return result;
  });
}

// what is wrong with the command line, and which option was meant if one is none
std::string usage_text(const Command_line& command_line, int argc, char** argv, const CLI::ParseError& error)
{
  const std::string text = error.what();
  const std::string unknown_in_file = "INI was not able to parse "; // what CLI11 says, and then the name
  if (text.compare(0, unknown_in_file.size(), unknown_in_file) == 0)
  {
    const std::string name = text.substr(unknown_in_file.size());
    return "the file of --config has no line for an option, but " + name + command_line.suggestion("--" + name);
  }
  if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError))
    for (int i = 1; i < argc; ++i)
      if (text.find(argv[i]) != std::string::npos && !command_line.suggestion(argv[i]).empty())
        return text + command_line.suggestion(argv[i]);
  return text;
}

void write_configuration(const Command_line& command_line, const std::string& name)
{
  std::string error;
  const bool is_written = CGAL::IO::internal::write_beside_and_rename(
    name,
    [&](std::ostream& stream, std::string&) {
      stream << "# extract_wireframe " WIREFRAME_EXTRACTION_VERSION_STRING ": options for --config\n"
             << command_line.configuration();
      return static_cast<bool>(stream);
    },
    error);
  if (!is_written)
    throw Error(USAGE_ERROR, error);
}

int parse_and_run(int argc, char** argv)
{
  Options options;
  Command_line command_line(options);
  try
  {
    command_line.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
      return command_line.show_help_or_version(error);
    throw Error(USAGE_ERROR, usage_text(command_line, argc, argv, error) + " (extract_wireframe --help tells more)");
  }
  if (options.completion != Completion::NONE)
  {
    std::cout << command_line.completion_script();
    return SUCCESS;
  }
  if (options.has_configuration)
    write_configuration(command_line, options.configuration);
  if (options.input.files.empty() && !options.has_batch)
    return SUCCESS;
  return options.has_batch ? run_many(command_line, options) : run_one(command_line, options);
}

} // namespace tool

int main(int argc, char** argv)
{
#ifdef EXTRACT_WIREFRAME_WITH_GLOG
  // Ceres logs what it cannot solve, which the library looks at by itself, to the standard error stream
  FLAGS_minloglevel = google::GLOG_FATAL;
#endif
  const std::pair<int, std::string> outcome = tool::outcome_of([=] { return tool::parse_and_run(argc, argv); });
  if (!outcome.second.empty())
    std::cerr << "extract_wireframe: error: " << tool::one_line(outcome.second) << '\n';
  return outcome.first;
}
