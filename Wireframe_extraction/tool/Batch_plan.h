// Which clouds of a batch have to be extracted, as what was made of them is not there or no longer valid.

#ifndef EXTRACT_WIREFRAME_BATCH_PLAN_H
#define EXTRACT_WIREFRAME_BATCH_PLAN_H

#include "Batch_files.h"
#include "Batch_list.h"
#include "Batch_progress.h"
#include "Batch_record.h"
#include "run_batch.h"

#include <cstddef>
#include <string>

namespace tool {

// Only the states of files are looked at, not what is in them.
class Batch_plan
{
public:
  Batch_plan(const Batch_options& options, const Batch_list& list, const Batch_files& files)
    : m_options(options), m_list(list), m_files(files)
  {}

  // whether nothing has to be done for the cloud with this record
  bool is_up_to_date(std::size_t i, const Batch_record& record)
  {
    const bool is_kept = record.state == Batch_record::FAILED && m_options.are_failed_kept;
    if (record.state != Batch_record::SUCCEEDED && !is_kept)
      return false;
    if (!(record.cloud == File_state(m_list.cloud(i))))
    {
      ++m_number_of_changed_clouds;
      return false;
    }
    if (record.settings != m_options.settings)
    {
      ++m_number_of_changed_settings;
      m_old_settings = record.settings;
      return false;
    }
    if (is_kept || m_files.are_outputs_there(i, record))
      return true;
    ++m_number_of_missing_outputs;
    return false;
  }

  void say_what_is_done_again(Batch_progress& progress) const
  {
    if (m_number_of_changed_clouds > 0)
      progress.say("Clouds that have changed since, so that they are done again: "
                   + std::to_string(m_number_of_changed_clouds));
    if (m_number_of_missing_outputs > 0)
      progress.say("Clouds whose outputs are of another --format, or no longer what they were, so that they are done "
                   "again: "
                   + std::to_string(m_number_of_missing_outputs));
    if (m_number_of_changed_settings > 0)
      progress.say("Clouds that were done with other options (" + m_old_settings + "; now " + m_options.settings
                   + "), so that they are done again: " + std::to_string(m_number_of_changed_settings));
  }

private:
  const Batch_options& m_options;
  const Batch_list& m_list;
  const Batch_files& m_files;
  std::size_t m_number_of_changed_clouds = 0, m_number_of_changed_settings = 0, m_number_of_missing_outputs = 0;
  std::string m_old_settings;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_PLAN_H
