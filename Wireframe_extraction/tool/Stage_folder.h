// Where the results of the stages are written, --stages.

#ifndef EXTRACT_WIREFRAME_STAGE_FOLDER_H
#define EXTRACT_WIREFRAME_STAGE_FOLDER_H

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace tool {

// The folder for the stages, made if missing. What was made and stays empty is removed at the end.
class Stage_folder
{
public:
  static const std::vector<std::string>& file_names()
  {
    static const std::vector<std::string> names = {"0_field.ply",    "1_skeleton.ply", "2_feet.ply",  "3_corners.ply",
                                                   "4_clusters.ply", "5_graph.ply",    "6_curves.ply"};
    return names;
  }

  Stage_folder() {}
  Stage_folder(const Stage_folder&) = delete;
  Stage_folder& operator=(const Stage_folder&) = delete;

  ~Stage_folder()
  {
    std::error_code ignored; // a folder that is not empty is not removed
    for (auto folder = m_made.rbegin(); folder != m_made.rend(); ++folder)
      std::filesystem::remove(*folder, ignored);
  }

  // returns what went wrong, nothing if all went well
  std::string make(const std::string& name)
  {
    namespace fs = std::filesystem;
    if (name.empty())
      return "the name of the folder for the stages is empty";
    m_path = fs::path(name);
    std::error_code code;
    std::vector<fs::path> missing;
    for (fs::path p = fs::absolute(m_path, code).lexically_normal(); !fs::exists(p, code); p = p.parent_path())
      if (p.has_filename())
        missing.push_back(p);
    for (auto folder = missing.rbegin(); folder != missing.rend(); ++folder)
    {
      if (!fs::create_directory(*folder, code))
        return name + ": the folder for the stages cannot be made: " + code.message();
      m_made.push_back(*folder);
    }
    if (!fs::is_directory(m_path, code))
      return name + ": is not a folder, so the stages cannot be written there";
    return std::string();
  }

  bool is_given() const { return !m_path.empty(); }
  std::string path_of(const std::string& file_name) const { return (m_path / file_name).string(); }

  // an old result must not be taken for one of this run
  void remove_old_files() const
  {
    std::error_code ignored;
    for (const std::string& name : file_names())
      if (std::filesystem::is_regular_file(m_path / name, ignored))
        std::filesystem::remove(m_path / name, ignored);
  }

private:
  std::filesystem::path m_path;
  std::vector<std::filesystem::path> m_made;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_STAGE_FOLDER_H
