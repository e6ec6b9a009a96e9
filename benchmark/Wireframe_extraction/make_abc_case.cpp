// Makes clouds with ground truth from shapes of the ABC dataset: a mesh (OBJ) and its features (YAML).

#include <Case_maker/Case_program.h>
#include <Case_maker/read_abc_shape.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace Case_maker;

std::string stem_of(const std::string& path) { return std::filesystem::path(path).stem().string(); }

/// The name by which a mesh and its features find each other: the dataset's files differ in one word.
std::string common_name(std::string stem)
{
  for (const std::string word : {"_trimesh", "_features"})
  {
    const std::size_t place = stem.rfind(word);
    if (place != std::string::npos && place > 0)
      return stem.erase(place, word.size());
  }
  return stem;
}

std::vector<Case_job> jobs_of_batch(const std::string& directory)
{
  std::map<std::string, std::vector<std::string>> features;
  for (const std::string& path : files_below(directory, {".yml", ".yaml"}))
    features[common_name(stem_of(path))].push_back(path);
  std::vector<Case_job> jobs;
  for (const std::string& path : files_below(directory, {".obj"}))
  {
    Case_job job = {common_name(stem_of(path)), {path}, ""};
    const std::vector<std::string>& found = features[job.name];
    if (found.empty())
      job.problem = "there is no YAML file with the features of '" + path + "'";
    else
      job.files.push_back(found.front());
    for (const std::string& other : found) // rather the one beside the mesh, if there are more
      if (std::filesystem::path(other).parent_path() == std::filesystem::path(path).parent_path())
        job.files.back() = other;
    jobs.push_back(job);
  }
  if (jobs.empty())
    throw bad_input("there is no OBJ file in '" + directory + "'");
  mark_duplicates(jobs);
  return jobs;
}

} // namespace

int main(int argc, char** argv)
{
  Case_program program("make_abc_case", "Makes clouds with ground truth from shapes of the ABC dataset.");
  std::vector<std::string> files;
  program.options()
    .add_option("files", files, "the mesh (OBJ) and its features (YAML) of a single shape")
    ->expected(0, 2);
  const auto make_jobs = [&]() {
    if (program.batch_directory().empty() != !files.empty())
      throw Case_error(USAGE_ERROR, "give a mesh and its features, MESH.obj FEATURES.yml, or --batch DIRECTORY");
    if (files.empty())
      return jobs_of_batch(program.batch_directory());
    if (files.size() != 2)
      throw Case_error(USAGE_ERROR, "two files are needed, MESH.obj FEATURES.yml");
    const std::string name = program.name_of_case();
    return std::vector<Case_job>{{name.empty() ? common_name(stem_of(files[0])) : name, files, ""}};
  };
  return program.run(argc, argv, make_jobs, [](const Case_job& job, const Scale_rule& rule) {
    return read_abc_shape(job.files[0], job.files[1], rule);
  });
}
