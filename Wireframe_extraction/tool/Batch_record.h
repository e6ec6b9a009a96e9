// What a batch remembers of one cloud, so that another run can go on where one ended.

#ifndef EXTRACT_WIREFRAME_BATCH_RECORD_H
#define EXTRACT_WIREFRAME_BATCH_RECORD_H

#include "Error.h"
#include "run_batch.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace tool {

// Tells whether a file is still the same one, without reading it.
struct File_state
{
  std::uintmax_t size = 0;
  std::int64_t time = 0;

  File_state() {}

  explicit File_state(const std::filesystem::path& path)
  {
    std::error_code code;
    size = std::filesystem::file_size(path, code);
    const auto last_write = std::filesystem::last_write_time(path, code);
    if (!code)
      time = static_cast<std::int64_t>(last_write.time_since_epoch().count());
  }

  bool operator==(const File_state& other) const { return size == other.size && time == other.time; }
};

struct Batch_record
{
  enum State
  {
    NONE,
    STARTED,
    SUCCEEDED,
    FAILED
  };

  State state = NONE;
  std::string settings;
  File_state cloud;
  std::vector<std::pair<std::string, std::uintmax_t>> outputs; // their formats and sizes; names need not be UTF-8
  Cloud_result result;
  double seconds = 0., processor_seconds = 0., peak_megabytes = 0.;

  bool has_output(const std::string& format) const
  {
    for (const auto& output : outputs)
      if (output.first == format)
        return true;
    return false;
  }
};

inline std::string to_text(const Batch_record& record)
{
  nlohmann::json document = {{"state", record.state},
                             {"settings", record.settings},
                             {"cloud", {record.cloud.size, record.cloud.time}},
                             {"outputs", record.outputs},
                             {"exit_code", record.result.exit_code},
                             {"error", record.result.error},
                             {"points", record.result.number_of_points},
                             {"curves", record.result.number_of_curves},
                             {"corners", record.result.number_of_corners},
                             {"doubtful", record.result.number_of_doubtful_curves},
                             {"types", record.result.types},
                             {"rms", record.result.rms},
                             {"sampling_distance", record.result.sampling_distance},
                             {"mesh", record.result.mesh_kind},
                             {"warnings", record.result.warnings},
                             {"seconds", record.seconds},
                             {"processor_seconds", record.processor_seconds},
                             {"peak_megabytes", record.peak_megabytes}};
  return document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

inline Batch_record record_of_text(const std::string& text)
{
  const nlohmann::json document = nlohmann::json::parse(text);
  Batch_record record;
  record.state = document.at("state").get<Batch_record::State>();
  document.at("settings").get_to(record.settings);
  document.at("cloud").at(0).get_to(record.cloud.size);
  document.at("cloud").at(1).get_to(record.cloud.time);
  document.at("outputs").get_to(record.outputs);
  document.at("exit_code").get_to(record.result.exit_code);
  document.at("error").get_to(record.result.error);
  document.at("points").get_to(record.result.number_of_points);
  document.at("curves").get_to(record.result.number_of_curves);
  document.at("corners").get_to(record.result.number_of_corners);
  document.at("sampling_distance").get_to(record.result.sampling_distance);
  // what older records have not
  record.result.mesh_kind = document.value("mesh", std::string());
  record.result.number_of_doubtful_curves = document.value("doubtful", std::size_t(0));
  record.result.types = document.value("types", std::string());
  record.result.rms = document.value("rms", 0.);
  document.at("warnings").get_to(record.result.warnings);
  document.at("seconds").get_to(record.seconds);
  document.at("processor_seconds").get_to(record.processor_seconds);
  document.at("peak_megabytes").get_to(record.peak_megabytes);
  return record;
}

inline std::string text_of_file(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

// A record that cannot be read, as the machine stopped just then, is one of a cloud that was started.
inline Batch_record read_record(const std::filesystem::path& path, const std::vector<std::string>& formats)
{
  Batch_record record;
  std::error_code code;
  if (!std::filesystem::exists(path, code))
    return record;
  try
  {
    return record_of_text(text_of_file(path));
  }
  catch (const nlohmann::json::exception&)
  {
    record.state = Batch_record::STARTED;
    for (const std::string& format : formats)
      record.outputs.emplace_back(format, 0);
  }
  return record;
}

// Writes to `draft` first, which is in the same file system: a record is there as a whole or not at all.
inline void write_record(const Batch_record& record, const std::filesystem::path& path,
                         const std::filesystem::path& draft)
{
  namespace fs = std::filesystem;
  std::error_code code;
  fs::create_directories(path.parent_path(), code);
  std::ofstream stream(draft, std::ios::binary | std::ios::trunc);
  stream << to_text(record);
  stream.close();
  if (!stream)
    throw Error(INTERNAL_ERROR, draft.string() + ": cannot be written (is the disk full?)");
  fs::rename(draft, path, code);
  if (code)
    throw Error(INTERNAL_ERROR, path.string() + ": cannot be written: " + code.message());
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_RECORD_H
