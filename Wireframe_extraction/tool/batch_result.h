// What the process of a cloud left behind.

#ifndef EXTRACT_WIREFRAME_BATCH_RESULT_H
#define EXTRACT_WIREFRAME_BATCH_RESULT_H

#include "Batch_record.h"
#include "Error.h"
#include "Processes.h"
#include "batch_summary.h"
#include "run_batch.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <string>

namespace tool {

inline std::string last_line(const std::filesystem::path& path)
{
  const std::string text = text_of_file(path);
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if (end == std::string::npos)
    return std::string();
  const std::size_t line_feed = text.rfind('\n', end);
  const std::size_t begin = (line_feed == std::string::npos) ? 0 : line_feed + 1;
  return one_line(text.substr(begin, (std::min)(end + 1 - begin, std::size_t(500))));
}

inline std::string why_without_result(const Ended_process& ended, const std::string& message,
                                      const Batch_options& options)
{
  if (ended.is_timed_out)
    return "took longer than " + csv_number(options.time_limit, "%g") + " seconds (--timeout)";
  std::string text = ended.signal != 0
    ? "crashed: signal " + std::to_string(ended.signal) + ", " + strsignal(ended.signal)
    : "ended without a result, with exit code " + std::to_string(ended.exit_code);
  if (!message.empty())
    text += ": " + message;
  if (options.memory_limit > 0)
    text += " (its memory was limited to " + std::to_string(options.memory_limit) + " MB by --memory-limit)";
  else if (ended.signal == SIGKILL)
    text += " (the memory may have been too small for that many --jobs)";
  return text;
}

// what came out, by the files that the process wrote into its folder
inline Cloud_result result_of(const Ended_process& ended, const std::filesystem::path& folder,
                              const Batch_options& options)
{
  Cloud_result result;
  if (!ended.is_timed_out && ended.signal == 0)
    try
    {
      result = record_of_text(text_of_file(folder / "result")).result;
      result.error = one_line(result.error);
      if (result.exit_code == ended.exit_code && result.error.empty() == (result.exit_code == 0))
        return result;
    }
    catch (const nlohmann::json::exception&)
    {}
  result = Cloud_result();
  result.exit_code = ended.is_timed_out ? 124 : ended.signal != 0 ? 128 + ended.signal : INTERNAL_ERROR;
  result.error = why_without_result(ended, last_line(folder / "messages"), options);
  return result;
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_RESULT_H
