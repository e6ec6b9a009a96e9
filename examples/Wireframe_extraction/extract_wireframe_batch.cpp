#include "extract_wireframe_batch.h"

#ifdef _WIN32

#include "extract_wireframe_error.h"

namespace tool {

int number_of_processors() { return 1; }

int run_batch(const Batch_options&, const Extract_cloud&)
{
  throw Error(USAGE_ERROR, "--batch needs processes that can be forked, which Windows has not; call the tool cloud by "
                           "cloud");
}

} // namespace tool

#else

#include "extract_wireframe_batch_list.h"
#include "extract_wireframe_batch_lock.h"
#include "extract_wireframe_batch_progress.h"
#include "extract_wireframe_batch_record.h"
#include "extract_wireframe_batch_summary.h"
#include "extract_wireframe_error.h"
#include "extract_wireframe_processes.h"

#include <CGAL/Wireframe_extraction/IO/internal/write_beside_and_rename.h>

#include <boost/crc.hpp>

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace tool {

namespace fs = std::filesystem;

namespace {

// which clouds of the list are those of this run
struct Part
{
  std::size_t number = 1, count = 1;

  explicit Part(const std::string& text)
  {
    int end = 0;
    if(!text.empty()
       && (text.size() > 20 || std::sscanf(text.c_str(), "%zu/%zu%n", &number, &count, &end) != 2
           || static_cast<std::size_t>(end) != text.size() || number < 1 || number > count))
      throw Error(USAGE_ERROR, "--part: \"" + text + "\" is not a part K/N, with K from 1 to N");
  }

  std::size_t begin(std::size_t size) const
  {
    return size / count * (number - 1) + (std::min)(number - 1, size % count);
  }

  std::size_t end(std::size_t size) const { return begin(size) + size / count + (number - 1 < size % count ? 1 : 0); }
  std::string name() const { return std::to_string(number) + "-of-" + std::to_string(count); }
};

std::string one_line(std::string text)
{
  for(char& c : text)
    if(static_cast<unsigned char>(c) < 32 || c == 127)
      c = ' ';
  return text;
}

std::string last_line(const fs::path& path)
{
  const std::string text = text_of_file(path);
  const std::size_t end = text.find_last_not_of(" \t\r\n");
  if(end == std::string::npos)
    return std::string();
  const std::size_t line_feed = text.rfind('\n', end);
  const std::size_t begin = (line_feed == std::string::npos) ? 0 : line_feed + 1;
  return one_line(text.substr(begin, (std::min)(end + 1 - begin, std::size_t(500))));
}

class Batch
{
public:
  Batch(const Batch_options& options, const Extract_cloud& extract)
    : m_options(options), m_extract(extract), m_part(options.part), m_list(options),
      m_begin(m_part.begin(m_list.size())), m_end(m_part.end(m_list.size())),
      m_folder(options.output_folder), m_own_folder(m_folder / ".batch"),
      m_work_folder(m_own_folder / ("work-" + part_name())),
      m_summary(options.summary.empty() ? m_folder / (options.part.empty() ? "summary.csv"
                                                                            : "summary-" + m_part.name() + ".csv")
                                        : fs::path(options.summary)),
      m_statuses(m_end - m_begin, Batch_status::PENDING)
  {}

  int run()
  {
    check_summary();
    make_folder(m_own_folder);
    const Batch_lock lock(m_own_folder, part_name(), key_of_part());
    remove(m_work_folder); // of a run that was killed
    make_folder(m_work_folder);
    check_reserved_names();
    remove(m_summary);     // which holds when the batch has ended
    Processes processes(number_of_jobs(), Process_limits{ m_options.time_limit, m_options.memory_limit });
    const std::vector<std::size_t> to_do = find_work(processes);
    Batch_progress progress(!m_options.is_quiet, to_do.size());
    say_what_is_done_again(progress);
    extract_all(to_do, processes, progress);
    end(processes);
    progress.clear();
    write_summary();
    remove(m_work_folder);
    return tell_outcome();
  }

private:
  struct Job
  {
    std::size_t cloud = 0;
    Batch_record record;
  };

  std::string part_name() const { return m_options.part.empty() ? "all" : m_part.name(); }

  std::size_t number_of_jobs() const
  {
    return static_cast<std::size_t>(m_options.number_of_jobs > 0 ? m_options.number_of_jobs : number_of_processors());
  }

  // Parts may be at work at the same time if they share no cloud.
  std::string key_of_part() const
  {
    if(m_options.part.empty())
      return std::string();
    boost::crc_32_type code;
    for(const std::string& text : { m_list.text(), m_list.folder(), m_options.settings })
      code.process_bytes(text.data(), text.size());
    for(const std::string& format : m_options.formats)
      code.process_bytes(format.data(), format.size());
    return std::to_string(m_part.count) + " parts of list " + std::to_string(m_list.text().size()) + " "
           + std::to_string(code.checksum()) + "\n";
  }

  // A table may only replace one of its kind.
  void check_summary() const
  {
    std::error_code code;
    if(fs::is_directory(m_summary, code))
      throw Error(USAGE_ERROR, m_summary.string() + ": is a folder, so the summary cannot be written there");
    if(!fs::is_regular_file(m_summary, code))
      return;
    std::ifstream stream(m_summary);
    std::string line;
    std::getline(stream, line);
    if(line != summary_header())
      throw Error(USAGE_ERROR, m_summary.string() + ": is there, and is not the summary of a batch; give "
                               "another --summary");
  }

  void check_reserved_names() const
  {
    std::error_code code;
    const fs::path folder = fs::weakly_canonical(m_folder, code);
    const std::string summary = fs::weakly_canonical(m_summary, code).lexically_relative(folder).generic_string();
    for(std::size_t i = m_begin; i < m_end; ++i)
    {
      const std::string name = m_list.output_name(i);
      bool is_taken = name.compare(0, 7, ".batch/") == 0 || name == ".batch";
      for(const std::string& format : m_options.formats)
        is_taken = is_taken || name + "." + format == summary;
      if(is_taken)
        throw Error(BAD_INPUT, m_list.place(i) + ": " + name + " is the name of a file of the batch itself; rename "
                               + m_list.entry(i) + ", or give another --summary");
    }
  }

  static void make_folder(const fs::path& folder)
  {
    std::error_code code;
    fs::create_directories(folder, code);
    if(!fs::is_directory(folder))
      throw Error(USAGE_ERROR, folder.string() + ": the folder cannot be made: " + code.message());
  }

  static void remove(const fs::path& path)
  {
    std::error_code code;
    fs::remove_all(path, code);
    if(code)
      throw Error(USAGE_ERROR, path.string() + ": cannot be removed: " + code.message());
  }

  fs::path output(std::size_t i, const std::string& format) const
  {
    return m_folder / (m_list.output_name(i) + "." + format);
  }

  Batch_record known_record(std::size_t i) const { return read_record(record_path(i), m_options.formats); }

  fs::path record_path(std::size_t i) const { return m_own_folder / "records" / (m_list.output_name(i) + ".record"); }
  fs::path slot_folder(std::size_t slot) const { return m_work_folder / std::to_string(slot); }

  // What was finished is left as it is: only the states of files are looked at, not what is in them.
  std::vector<std::size_t> find_work(Processes& processes)
  {
    std::vector<std::size_t> to_do;
    for(std::size_t i = m_begin; i < m_end && signal_to_end() == 0; ++i)
    {
      const Batch_record record = known_record(i);
      if(!is_up_to_date(i, record))
        to_do.push_back(i);
      else
        status(i) = record.state == Batch_record::FAILED ? Batch_status::FAILED : Batch_status::SKIPPED;
      processes.let_signals_in();
    }
    return to_do;
  }

  bool is_up_to_date(std::size_t i, const Batch_record& record)
  {
    const bool is_kept = record.state == Batch_record::FAILED && m_options.are_failed_kept;
    if(record.state != Batch_record::SUCCEEDED && !is_kept)
      return false;
    if(!(record.cloud == File_state(m_list.cloud(i))))
    {
      ++m_number_of_changed_clouds;
      return false;
    }
    if(record.settings != m_options.settings)
    {
      ++m_number_of_changed_settings;
      m_old_settings = record.settings;
      return false;
    }
    if(is_kept || are_outputs_there(i, record))
      return true;
    ++m_number_of_missing_outputs;
    return false;
  }

  bool are_outputs_there(std::size_t i, const Batch_record& record) const
  {
    if(record.outputs.size() != m_options.formats.size())
      return false;
    for(const auto& known : record.outputs)
    {
      std::error_code code;
      const std::uintmax_t size = fs::file_size(output(i, known.first), code);
      if(code || size != known.second)
        return false;
    }
    return std::all_of(m_options.formats.begin(), m_options.formats.end(),
                       [&](const std::string& format) { return record.has_output(format); });
  }

  Batch_status& status(std::size_t i) { return m_statuses[i - m_begin]; }

  void say_what_is_done_again(Batch_progress& progress) const
  {
    if(m_number_of_changed_clouds > 0)
      progress.say("Clouds that have changed since, so that they are done again: "
                   + std::to_string(m_number_of_changed_clouds));
    if(m_number_of_missing_outputs > 0)
      progress.say("Clouds whose outputs are of another --format, or no longer what they were, so that they are done "
                   "again: "
                   + std::to_string(m_number_of_missing_outputs));
    if(m_number_of_changed_settings > 0)
      progress.say("Clouds that were done with other options (" + m_old_settings + "; now " + m_options.settings
                   + "), so that they are done again: " + std::to_string(m_number_of_changed_settings));
  }

  void extract_all(const std::vector<std::size_t>& to_do, Processes& processes, Batch_progress& progress)
  {
    m_jobs.resize(number_of_jobs());
    const auto done = [this, &progress](const Ended_process& ended) { finish(ended, progress); };
    for(std::size_t next = 0; signal_to_end() == 0 && (next < to_do.size() || !processes.is_idle());)
    {
      const std::size_t slot = processes.free_slot();
      const bool starts = next < to_do.size() && slot < m_jobs.size();
      if(starts)
        start(to_do[next++], slot, processes, progress);
      processes.wait(starts && (next < to_do.size()) ? 0. : 1., done);
      progress.show(processes.number_of_running());
    }
  }

  void start(std::size_t i, std::size_t slot, Processes& processes, Batch_progress& progress)
  {
    std::string problem;
    try
    {
      problem = prepare(i, slot);
    }
    catch(const Error& error) // other clouds may have better names
    {
      problem = error.what();
    }
    if(problem.empty())
      processes.start(slot, (slot_folder(slot) / "messages").string(), [this, i, slot] { return extract(i, slot); });
    else
      tell_failure_without_record(i, problem, progress);
  }

  // returns why the cloud cannot be started, nothing if it can
  std::string prepare(std::size_t i, std::size_t slot)
  {
    const Batch_record old = known_record(i);
    const std::string problem = why_outputs_are_not_ours(i, old);
    if(!problem.empty())
      return problem;
    for(const auto& known : old.outputs)
      remove(output(i, known.first)); // it may be of other options, or of what the cloud was
    Job& job = m_jobs[slot];
    job.cloud = i;
    job.record = Batch_record();
    job.record.settings = m_options.settings;
    job.record.cloud = File_state(m_list.cloud(i));
    job.record.state = Batch_record::STARTED;
    for(const std::string& format : m_options.formats)
      job.record.outputs.emplace_back(format, 0);
    remove(slot_folder(slot));
    make_folder(slot_folder(slot) / "outputs");
    write_record(job.record, record_path(i), slot_folder(slot) / "record");
    return std::string();
  }

  // No file is overwritten that no batch has made, least of all a cloud.
  std::string why_outputs_are_not_ours(std::size_t i, const Batch_record& record) const
  {
    std::error_code code;
    for(const auto& known : record.outputs)
      if(fs::equivalent(output(i, known.first), m_list.cloud(i), code))
        return m_list.cloud(i) + ": was made by a batch in the same folder, and is a cloud now; give another "
               "--output-dir";
    for(const std::string& format : m_options.formats)
    {
      const fs::path path = output(i, format);
      if(fs::exists(fs::symlink_status(path, code)) && !record.has_output(format))
        return path.string() + ": is there already, and no batch has made it; move it away, or give another "
               "--output-dir";
    }
    return std::string();
  }

  // in the process of this cloud
  int extract(std::size_t i, std::size_t slot) const
  {
    try
    {
      std::vector<std::string> drafts;
      for(const std::string& format : m_options.formats)
        drafts.push_back(draft(i, slot, format).string());
      Batch_record record;
      record.result = m_extract(m_list.cloud(i), drafts);
      std::ofstream stream(slot_folder(slot) / "result", std::ios::binary);
      stream << to_text(record);
      stream.close();
      return stream ? record.result.exit_code : INTERNAL_ERROR;
    }
    catch(const std::exception& error)
    {
      std::fprintf(stderr, "%s\n", error.what());
      return INTERNAL_ERROR;
    }
  }

  fs::path draft(std::size_t i, std::size_t slot, const std::string& format) const
  {
    return slot_folder(slot) / "outputs" / output(i, format).filename();
  }

  void finish(const Ended_process& ended, Batch_progress& progress)
  {
    Job& job = m_jobs[ended.slot];
    const std::size_t i = job.cloud;
    Batch_record& record = job.record;
    record.seconds = ended.seconds;
    record.processor_seconds = ended.processor_seconds;
    record.peak_megabytes = ended.peak_megabytes;
    record.result = result_of(ended);
    if(record.result.error.empty())
      move_outputs(i, ended.slot, record);
    const bool is_well = record.result.error.empty();
    record.state = is_well ? Batch_record::SUCCEEDED : Batch_record::FAILED;
    if(!is_well)
      record.outputs.clear();
    try
    {
      write_record(record, record_path(i), slot_folder(ended.slot) / "record");
      remove(slot_folder(ended.slot));
    }
    catch(const Error& error)
    {
      return tell_failure_without_record(i, error.what(), progress);
    }
    status(i) = is_well ? Batch_status::OK : Batch_status::FAILED;
    if(is_well)
      progress.count(true);
    else
      tell_failure(i, record.result.error, progress);
  }

  void tell_failure_without_record(std::size_t i, const std::string& error, Batch_progress& progress)
  {
    m_problems[i] = one_line(error);
    tell_failure(i, m_problems[i], progress);
  }

  Cloud_result result_of(const Ended_process& ended) const
  {
    const fs::path folder = slot_folder(ended.slot);
    Cloud_result result;
    if(!ended.is_timed_out && ended.signal == 0)
      try
      {
        result = record_of_text(text_of_file(folder / "result")).result;
        result.error = one_line(result.error);
        if(result.exit_code == ended.exit_code && result.error.empty() == (result.exit_code == 0))
          return result;
      }
      catch(const nlohmann::json::exception&)
      {
      }
    result = Cloud_result();
    result.exit_code = ended.is_timed_out ? 124 : ended.signal != 0 ? 128 + ended.signal : INTERNAL_ERROR;
    result.error = why_without_result(ended, last_line(folder / "messages"));
    return result;
  }

  std::string why_without_result(const Ended_process& ended, const std::string& message) const
  {
    if(ended.is_timed_out)
      return "took longer than " + csv_number(m_options.time_limit, "%g") + " seconds (--timeout)";
    std::string text = ended.signal != 0
                         ? "crashed: signal " + std::to_string(ended.signal) + ", " + strsignal(ended.signal)
                         : "ended without a result, with exit code " + std::to_string(ended.exit_code);
    if(!message.empty())
      text += ": " + message;
    if(m_options.memory_limit > 0)
      text += " (its memory was limited to " + std::to_string(m_options.memory_limit) + " MB by --memory-limit)";
    else if(ended.signal == SIGKILL)
      text += " (the memory may have been too small for that many --jobs)";
    return text;
  }

  // to where they belong; what went wrong is told in the record
  void move_outputs(std::size_t i, std::size_t slot, Batch_record& record) const
  {
    std::error_code code;
    for(auto& made : record.outputs)
    {
      const fs::path target = output(i, made.first);
      fs::create_directories(target.parent_path(), code);
      if(!code)
        made.second = fs::file_size(draft(i, slot, made.first), code);
      if(!code)
        fs::rename(draft(i, slot, made.first), target, code);
      if(code)
      {
        record.result.exit_code = INTERNAL_ERROR;
        record.result.error = target.string() + ": cannot be written: " + code.message();
        break;
      }
    }
    if(!record.result.error.empty())
      for(const auto& made : record.outputs)
        fs::remove(output(i, made.first), code);
  }

  void tell_failure(std::size_t i, const std::string& error, Batch_progress& progress)
  {
    status(i) = Batch_status::FAILED;
    progress.count(false);
    progress.say("failed: " + m_list.entry(i) + ": " + error);
  }

  // what is still at work when the batch is to end leaves nothing behind
  void end(Processes& processes)
  {
    if(processes.is_idle())
      return;
    processes.end_all();
    for(const Job& job : m_jobs)
      if(job.record.state == Batch_record::STARTED)
        remove(record_path(job.cloud));
  }

  void write_summary() const
  {
    std::string error;
    const bool is_written = CGAL::IO::internal::write_beside_and_rename(m_summary.string(),
      [this](std::ostream& stream, std::string&)
      {
        stream << summary_header() << '\n';
        for(std::size_t i = m_begin; i < m_end; ++i)
          write_row(stream, m_list.entry(i), m_list.output_name(i), m_statuses[i - m_begin], record_for_summary(i));
        return static_cast<bool>(stream);
      }, error);
    if(!is_written)
      throw Error(INTERNAL_ERROR, error);
  }

  Batch_record record_for_summary(std::size_t i) const
  {
    Batch_record record;
    if(m_statuses[i - m_begin] == Batch_status::PENDING)
      return record;
    const auto problem = m_problems.find(i);
    if(problem == m_problems.end())
      return known_record(i);
    record.result.exit_code = USAGE_ERROR;
    record.result.error = problem->second;
    return record;
  }

  int tell_outcome() const
  {
    const auto count = [this](Batch_status status)
    {
      return static_cast<std::size_t>(std::count(m_statuses.begin(), m_statuses.end(), status));
    };
    const std::size_t failed = count(Batch_status::FAILED);
    if(!m_options.is_quiet)
      std::cout << "Clouds      " << m_statuses.size() << ": " << count(Batch_status::OK) << " ok, "
                << count(Batch_status::SKIPPED) << " done before, " << failed << " failed, "
                << count(Batch_status::PENDING) << " pending\nSummary     " << m_summary.string() << std::endl;
    if(signal_to_end() != 0)
      return 128 + signal_to_end();
    if(failed > 0)
      throw Error(SOME_FAILED, std::to_string(failed) + " of " + std::to_string(m_statuses.size())
                               + " clouds failed; " + m_summary.string() + " tells which, and why");
    return SUCCESS;
  }

  const Batch_options& m_options;
  const Extract_cloud& m_extract;
  const Part m_part;
  const Batch_list m_list;
  const std::size_t m_begin, m_end;
  const fs::path m_folder, m_own_folder, m_work_folder, m_summary;
  std::vector<Batch_status> m_statuses;
  std::vector<Job> m_jobs;
  std::map<std::size_t, std::string> m_problems; // of clouds that were not started
  std::size_t m_number_of_changed_clouds = 0, m_number_of_changed_settings = 0, m_number_of_missing_outputs = 0;
  std::string m_old_settings;
};

} // namespace

int number_of_processors()
{
#ifdef __linux__
  cpu_set_t processors;
  if(sched_getaffinity(0, sizeof(processors), &processors) == 0) // a job on a cluster may not use all there are
    return (std::max)(CPU_COUNT(&processors), 1);
#endif
  return (std::max)(static_cast<int>(std::thread::hardware_concurrency()), 1);
}

int run_batch(const Batch_options& options, const Extract_cloud& extract)
{
  return Batch(options, extract).run();
}

} // namespace tool

#endif // _WIN32
