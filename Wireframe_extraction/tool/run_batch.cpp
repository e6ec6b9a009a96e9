#include "run_batch.h"

#ifdef _WIN32

#include "Error.h"

namespace tool {

int number_of_processors() { return 1; }

int run_batch(const Batch_options&, const Extract_cloud&)
{
  throw Error(USAGE_ERROR,
              "--batch needs processes that can be forked, which Windows has not; call the tool cloud by "
              "cloud");
}

} // namespace tool

#else

#include "Batch_files.h"
#include "Batch_list.h"
#include "Batch_lock.h"
#include "Batch_part.h"
#include "Batch_plan.h"
#include "Batch_progress.h"
#include "Batch_record.h"
#include "Error.h"
#include "Processes.h"
#include "batch_result.h"
#include "batch_summary.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/write_beside_and_rename.h>

#include <boost/crc.hpp>

#ifdef __linux__
#include <sched.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace tool {

namespace {

class Batch
{
public:
  Batch(const Batch_options& options, const Extract_cloud& extract)
    : m_options(options), m_extract(extract), m_part(options.part), m_list(options),
      m_begin(m_part.begin(m_list.size())), m_end(m_part.end(m_list.size())), m_files(options, m_part, m_list),
      m_plan(options, m_list, m_files), m_statuses(m_end - m_begin, Batch_status::PENDING)
  {}

  int run()
  {
    m_files.check_summary();
    m_files.check_index();
    Batch_files::make_folder(m_files.own_folder());
    const Batch_lock lock(m_files.own_folder(), m_part.name(), key_of_part());
    m_files.make_work_folder();
    m_files.check_reserved_names(m_begin, m_end);
    Batch_files::remove(m_files.summary()); // which holds when the batch has ended
    Processes processes(number_of_jobs(), Process_limits{m_options.time_limit, m_options.memory_limit});
    const std::vector<std::size_t> to_do = find_work(processes);
    Batch_progress progress(!m_options.is_quiet, to_do.size());
    m_plan.say_what_is_done_again(progress);
    extract_all(to_do, processes, progress);
    end(processes);
    progress.clear();
    write_summary();
    if (m_files.has_index())
      write_index();
    Batch_files::remove(m_files.work_folder());
    return tell_outcome();
  }

private:
  struct Job
  {
    std::size_t cloud = 0;
    Batch_record record;
  };

  std::size_t number_of_jobs() const
  {
    return static_cast<std::size_t>(m_options.number_of_jobs > 0 ? m_options.number_of_jobs : number_of_processors());
  }

  // Parts may be at work at the same time if they share no cloud.
  std::string key_of_part() const
  {
    if (m_part.is_all)
      return std::string();
    boost::crc_32_type code;
    for (const std::string& text : {m_list.text(), m_list.folder(), m_options.settings})
      code.process_bytes(text.data(), text.size());
    for (const std::string& format : m_options.formats)
      code.process_bytes(format.data(), format.size());
    return std::to_string(m_part.count) + " parts of list " + std::to_string(m_list.text().size()) + " "
      + std::to_string(code.checksum()) + "\n";
  }

  // what was finished is left as it is
  std::vector<std::size_t> find_work(Processes& processes)
  {
    std::vector<std::size_t> to_do;
    for (std::size_t i = m_begin; i < m_end && signal_to_end() == 0; ++i)
    {
      const Batch_record record = m_files.known_record(i);
      if (!m_plan.is_up_to_date(i, record))
        to_do.push_back(i);
      else
        status(i) = record.state == Batch_record::FAILED ? Batch_status::FAILED : Batch_status::SKIPPED;
      processes.let_signals_in();
    }
    return to_do;
  }

  Batch_status& status(std::size_t i) { return m_statuses[i - m_begin]; }

  void extract_all(const std::vector<std::size_t>& to_do, Processes& processes, Batch_progress& progress)
  {
    m_jobs.resize(number_of_jobs());
    const auto done = [this, &progress](const Ended_process& ended) { finish(ended, progress); };
    for (std::size_t next = 0; signal_to_end() == 0 && (next < to_do.size() || !processes.is_idle());)
    {
      const std::size_t slot = processes.free_slot();
      const bool starts = next < to_do.size() && slot < m_jobs.size();
      if (starts)
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
    catch (const Error& error) // other clouds may have better names
    {
      problem = error.what();
    }
    if (problem.empty())
      processes.start(slot, (m_files.slot_folder(slot) / "messages").string(),
                      [this, i, slot] { return extract(i, slot); });
    else
      tell_failure_without_record(i, problem, progress);
  }

  // returns why the cloud cannot be started, nothing if it can
  std::string prepare(std::size_t i, std::size_t slot)
  {
    const Batch_record old = m_files.known_record(i);
    const std::string problem = m_files.why_outputs_are_not_ours(i, old);
    if (!problem.empty())
      return problem;
    for (const auto& known : old.outputs)
      Batch_files::remove(m_files.output(i, known.first)); // it may be of other options, or of what the cloud was
    Job& job = m_jobs[slot];
    job.cloud = i;
    job.record = Batch_record();
    job.record.settings = m_options.settings;
    job.record.cloud = File_state(m_list.cloud(i));
    job.record.state = Batch_record::STARTED;
    for (const std::string& format : m_options.formats)
      job.record.outputs.emplace_back(format, 0);
    Batch_files::remove(m_files.slot_folder(slot));
    Batch_files::make_folder(m_files.slot_folder(slot) / "outputs");
    write_record(job.record, m_files.record_path(i), m_files.slot_folder(slot) / "record");
    return std::string();
  }

  // in the process of this cloud
  int extract(std::size_t i, std::size_t slot) const
  {
    try
    {
      std::vector<std::string> drafts;
      for (const std::string& format : m_options.formats)
        drafts.push_back(m_files.draft(i, slot, format).string());
      Batch_record record;
      record.result = m_extract(m_list.cloud(i), drafts);
      std::ofstream stream(m_files.slot_folder(slot) / "result", std::ios::binary);
      stream << to_text(record);
      stream.close();
      return stream ? record.result.exit_code : INTERNAL_ERROR;
    }
    catch (const std::exception& error)
    {
      std::fprintf(stderr, "%s\n", error.what());
      return INTERNAL_ERROR;
    }
  }

  void finish(const Ended_process& ended, Batch_progress& progress)
  {
    Job& job = m_jobs[ended.slot];
    const std::size_t i = job.cloud;
    Batch_record& record = job.record;
    record.seconds = ended.seconds;
    record.processor_seconds = ended.processor_seconds;
    record.peak_megabytes = ended.peak_megabytes;
    record.result = result_of(ended, m_files.slot_folder(ended.slot), m_options);
    if (record.result.error.empty())
      m_files.move_outputs(i, ended.slot, record);
    const bool is_well = record.result.error.empty();
    record.state = is_well ? Batch_record::SUCCEEDED : Batch_record::FAILED;
    if (!is_well)
      record.outputs.clear();
    try
    {
      write_record(record, m_files.record_path(i), m_files.slot_folder(ended.slot) / "record");
      Batch_files::remove(m_files.slot_folder(ended.slot));
    }
    catch (const Error& error)
    {
      return tell_failure_without_record(i, error.what(), progress);
    }
    status(i) = is_well ? Batch_status::OK : Batch_status::FAILED;
    if (is_well)
      progress.count(true);
    else
      tell_failure(i, record.result.error, progress);
  }

  void tell_failure_without_record(std::size_t i, const std::string& error, Batch_progress& progress)
  {
    m_problems[i] = one_line(error);
    tell_failure(i, m_problems[i], progress);
  }

  void tell_failure(std::size_t i, const std::string& error, Batch_progress& progress)
  {
    status(i) = Batch_status::FAILED;
    progress.count(false);
    const std::string name = one_line(m_list.cloud(i)) + ":"; // with which most errors start
    progress.say("failed: " + (error.compare(0, name.size(), name) == 0 ? error : m_list.entry(i) + ": " + error));
  }

  // what is still at work when the batch is to end leaves nothing behind
  void end(Processes& processes)
  {
    if (processes.is_idle())
      return;
    processes.end_all();
    for (const Job& job : m_jobs)
      if (job.record.state == Batch_record::STARTED)
        Batch_files::remove(m_files.record_path(job.cloud));
  }

  void write_summary() const
  {
    replace(m_files.summary(), [this](std::ostream& stream) {
      stream << summary_header() << '\n';
      for (std::size_t i = m_begin; i < m_end; ++i)
        write_row(stream, m_list.entry(i), m_list.output_name(i), m_statuses[i - m_begin], record_for_summary(i));
    });
  }

  void write_index() const
  {
    replace(m_files.index(), [this](std::ostream& stream) {
      write_index_start(stream);
      for (std::size_t i = m_begin; i < m_end; ++i)
        write_index_row(stream, m_list.entry(i), m_list.output_name(i), m_statuses[i - m_begin], record_for_summary(i));
      write_index_end(stream);
    });
  }

  // writes a file as a whole, or leaves the one that is there
  template <class Write>
  static void replace(const std::filesystem::path& name, const Write& write)
  {
    std::string error;
    const bool is_written = CGAL::IO::internal::write_beside_and_rename(
      name.string(),
      [&write](std::ostream& stream, std::string&) {
        write(stream);
        return static_cast<bool>(stream);
      },
      error);
    if (!is_written)
      throw Error(INTERNAL_ERROR, error);
  }

  Batch_record record_for_summary(std::size_t i) const
  {
    Batch_record record;
    if (m_statuses[i - m_begin] == Batch_status::PENDING)
      return record;
    const auto problem = m_problems.find(i);
    if (problem == m_problems.end())
      return m_files.known_record(i);
    record.result.exit_code = USAGE_ERROR;
    record.result.error = problem->second;
    return record;
  }

  int tell_outcome() const
  {
    const auto count = [this](Batch_status status) {
      return static_cast<std::size_t>(std::count(m_statuses.begin(), m_statuses.end(), status));
    };
    const std::size_t failed = count(Batch_status::FAILED);
    if (!m_options.is_quiet)
      std::cout << "Clouds      " << m_statuses.size() << ": " << count(Batch_status::OK) << " ok, "
                << count(Batch_status::SKIPPED) << " done before, " << failed << " failed, "
                << count(Batch_status::PENDING) << " pending\nSummary     " << m_files.summary().string()
                << (m_files.has_index() ? "\nPage        " + m_files.index().string() : "") << std::endl;
    if (signal_to_end() != 0)
      return 128 + signal_to_end();
    if (failed > 0)
      throw Error(SOME_FAILED,
                  std::to_string(failed) + " of " + std::to_string(m_statuses.size()) + " clouds failed; "
                    + m_files.summary().string() + " tells which, and why");
    return SUCCESS;
  }

  const Batch_options& m_options;
  const Extract_cloud& m_extract;
  const Batch_part m_part;
  const Batch_list m_list;
  const std::size_t m_begin, m_end;
  const Batch_files m_files;
  Batch_plan m_plan;
  std::vector<Batch_status> m_statuses;
  std::vector<Job> m_jobs;
  std::map<std::size_t, std::string> m_problems; // of clouds that were not started
};

} // namespace

int number_of_processors()
{
#ifdef __linux__
  cpu_set_t processors;
  if (sched_getaffinity(0, sizeof(processors), &processors) == 0) // a job on a cluster may not use all there are
    return (std::max)(CPU_COUNT(&processors), 1);
#endif
  return (std::max)(static_cast<int>(std::thread::hardware_concurrency()), 1);
}

int run_batch(const Batch_options& options, const Extract_cloud& extract) { return Batch(options, extract).run(); }

} // namespace tool

#endif // _WIN32
