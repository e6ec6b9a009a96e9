// Where the files of a batch are, and which of them it may write and remove.

#ifndef EXTRACT_WIREFRAME_BATCH_FILES_H
#define EXTRACT_WIREFRAME_BATCH_FILES_H

#include "Batch_list.h"
#include "Batch_part.h"
#include "Batch_record.h"
#include "Error.h"
#include "batch_index.h"
#include "batch_summary.h"
#include "run_batch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace tool {

// The outputs and the summary are the user's; the rest is in the folder .batch.
class Batch_files
{
public:
  Batch_files(const Batch_options& options, const Batch_part& part, const Batch_list& list)
    : m_options(options), m_list(list), m_folder(options.output_folder), m_own_folder(m_folder / ".batch"),
      m_work_folder(m_own_folder / ("work-" + part.name())),
      m_summary(options.summary.empty() ? m_folder / (part.is_all ? "summary.csv" : "summary-" + part.name() + ".csv")
                                        : std::filesystem::path(options.summary)),
      m_index_name(part.is_all ? "index.html" : "index-" + part.name() + ".html")
  {}

  const std::filesystem::path& own_folder() const { return m_own_folder; }
  const std::filesystem::path& work_folder() const { return m_work_folder; }
  const std::filesystem::path& summary() const { return m_summary; }
  std::filesystem::path index() const { return m_folder / m_index_name; }

  // whether there is something to see
  bool has_index() const
  {
    const auto is_shown = [](const std::string& format) { return format == "html" || format == "png"; };
    return std::any_of(m_options.formats.begin(), m_options.formats.end(), is_shown);
  }

  std::filesystem::path output(std::size_t i, const std::string& format) const
  {
    return m_folder / (m_list.output_name(i) + "." + format);
  }

  // what is remembered of the cloud
  Batch_record known_record(std::size_t i) const { return read_record(record_path(i), m_options.formats); }

  std::filesystem::path record_path(std::size_t i) const
  {
    return m_own_folder / "records" / (m_list.output_name(i) + ".record");
  }

  // of a process at work
  std::filesystem::path slot_folder(std::size_t slot) const { return m_work_folder / std::to_string(slot); }

  // an output that is not complete yet
  std::filesystem::path draft(std::size_t i, std::size_t slot, const std::string& format) const
  {
    return slot_folder(slot) / "outputs" / output(i, format).filename();
  }

  // A table may only replace one of its kind.
  void check_summary() const
  {
    std::error_code code;
    if (std::filesystem::is_directory(m_summary, code))
      throw Error(USAGE_ERROR, m_summary.string() + ": is a folder, so the summary cannot be written there");
    if (!std::filesystem::is_regular_file(m_summary, code))
      return;
    if (first_line(m_summary).compare(0, std::string(summary_mark()).size(), summary_mark()) != 0)
      throw Error(USAGE_ERROR,
                  m_summary.string()
                    + ": is there, and is not the summary of a batch; give "
                      "another --summary");
  }

  // So may the page that shows all.
  void check_index() const
  {
    std::error_code code;
    if (!has_index() || !std::filesystem::exists(index(), code))
      return;
    if (first_line(index()) != index_mark())
      throw Error(USAGE_ERROR,
                  index().string()
                    + ": is there, and is not the page of a batch; move it away, or give another --output-dir");
  }

  // the clouds from the first one to before the last one
  void check_reserved_names(std::size_t first, std::size_t last) const
  {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::path folder = fs::weakly_canonical(m_folder, code);
    const std::string summary = fs::weakly_canonical(m_summary, code).lexically_relative(folder).generic_string();
    for (std::size_t i = first; i < last; ++i)
    {
      const std::string name = m_list.output_name(i);
      bool is_taken = name.compare(0, 7, ".batch/") == 0 || name == ".batch";
      for (const std::string& format : m_options.formats)
        is_taken = is_taken || name + "." + format == summary || (has_index() && name + "." + format == m_index_name);
      if (is_taken)
        throw Error(BAD_INPUT,
                    m_list.place(i) + ": " + name + " is the name of a file of the batch itself; rename "
                      + m_list.entry(i) + ", or give another --summary");
    }
  }

  // nothing of an earlier run is among what this one works with
  void make_work_folder() const
  {
    remove(m_work_folder);
    make_folder(m_work_folder);
  }

  bool are_outputs_there(std::size_t i, const Batch_record& record) const
  {
    if (record.outputs.size() != m_options.formats.size())
      return false;
    for (const auto& known : record.outputs)
    {
      std::error_code code;
      const std::uintmax_t size = std::filesystem::file_size(output(i, known.first), code);
      if (code || size != known.second)
        return false;
    }
    return std::all_of(m_options.formats.begin(), m_options.formats.end(),
                       [&](const std::string& format) { return record.has_output(format); });
  }

  // No file is overwritten that no batch has made, least of all a cloud.
  std::string why_outputs_are_not_ours(std::size_t i, const Batch_record& record) const
  {
    std::error_code code;
    for (const auto& known : record.outputs)
      if (std::filesystem::equivalent(output(i, known.first), m_list.cloud(i), code))
        return m_list.cloud(i)
          + ": was made by a batch in the same folder, and is a cloud now; give another "
            "--output-dir";
    for (const std::string& format : m_options.formats)
    {
      const std::filesystem::path path = output(i, format);
      if (std::filesystem::exists(std::filesystem::symlink_status(path, code)) && !record.has_output(format))
        return path.string()
          + ": is there already, and no batch has made it; move it away, or give another "
            "--output-dir";
    }
    return std::string();
  }

  // to where they belong; what went wrong is told in the record
  void move_outputs(std::size_t i, std::size_t slot, Batch_record& record) const
  {
    std::error_code code;
    for (auto& made : record.outputs)
    {
      const std::filesystem::path target = output(i, made.first);
      std::filesystem::create_directories(target.parent_path(), code);
      if (!code)
        made.second = std::filesystem::file_size(draft(i, slot, made.first), code);
      if (!code)
        std::filesystem::rename(draft(i, slot, made.first), target, code);
      if (code)
      {
        record.result.exit_code = INTERNAL_ERROR;
        record.result.error = target.string() + ": cannot be written: " + code.message();
        break;
      }
    }
    if (!record.result.error.empty())
      for (const auto& made : record.outputs)
        std::filesystem::remove(output(i, made.first), code);
  }

  static void make_folder(const std::filesystem::path& folder)
  {
    std::error_code code;
    std::filesystem::create_directories(folder, code);
    if (!std::filesystem::is_directory(folder))
      throw Error(USAGE_ERROR, folder.string() + ": the folder cannot be made: " + code.message());
  }

  static void remove(const std::filesystem::path& path)
  {
    std::error_code code;
    std::filesystem::remove_all(path, code);
    if (code)
      throw Error(USAGE_ERROR, path.string() + ": cannot be removed: " + code.message());
  }

private:
  static std::string first_line(const std::filesystem::path& file)
  {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
  }

  const Batch_options& m_options;
  const Batch_list& m_list;
  const std::filesystem::path m_folder, m_own_folder, m_work_folder, m_summary;
  const std::string m_index_name;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_FILES_H
