// Makes clouds with ground truth from parts in STEP files.

#include <Case_maker/Case_program.h>
#include <Case_maker/read_step_shape.h>

#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace Case_maker;

Case_job job_of(const std::string& path, const std::string& name)
{
  return {name.empty() ? std::filesystem::path(path).stem().string() : name, {path}, ""};
}

std::vector<Case_job> jobs_of_batch(const std::string& directory)
{
  std::vector<Case_job> jobs;
  for (const std::string& path : files_below(directory, {".stp", ".step"}))
    jobs.push_back(job_of(path, ""));
  if (jobs.empty())
    throw bad_input("there is no STEP file (.stp, .step) in '" + directory + "'");
  mark_duplicates(jobs);
  return jobs;
}

} // namespace

int main(int argc, char** argv)
{
  Case_program program("make_step_case", "Makes clouds with ground truth from parts in STEP files.");
  std::string file;
  Step_options options;
  program.options().add_option("part", file, "a single part (STEP)");
  program.options()
    .add_option("--sharp-angle", options.sharp_angle,
                "an edge is sharp if the normals of its faces differ by more, in degrees")
    ->capture_default_str()
    ->check(CLI::Range(0., 180.));
  program.options()
    .add_option("--sew", options.sewing,
                "first make one edge of edges that are closer than this, in millimetres; 0: do not")
    ->capture_default_str()
    ->check(CLI::NonNegativeNumber);
  const auto make_jobs = [&]() {
    if (program.batch_directory().empty() != !file.empty())
      throw Case_error(USAGE_ERROR, "give a part, PART.stp, or --batch DIRECTORY");
    return file.empty() ? jobs_of_batch(program.batch_directory())
                        : std::vector<Case_job>{job_of(file, program.name_of_case())};
  };
  return program.run(argc, argv, make_jobs, [&options](const Case_job& job, const Scale_rule& rule) {
    return read_step_shape(job.files[0], options, rule);
  });
}
