// Keeps two batches from working on the same clouds in the same folder.

#ifndef EXTRACT_WIREFRAME_BATCH_LOCK_H
#define EXTRACT_WIREFRAME_BATCH_LOCK_H

#include "Error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

namespace tool {

// A lock that the system takes back when the process ends, however it ends. Processes that were forked off hold it as
// well: who gets it knows that the last one is gone.
class File_lock
{
public:
  explicit File_lock(const std::filesystem::path& path) : m_file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
  {
    if (m_file < 0)
      throw Error(USAGE_ERROR, path.string() + ": cannot be written: " + std::strerror(errno));
  }

  ~File_lock() { close(m_file); }
  File_lock(const File_lock&) = delete;
  File_lock& operator=(const File_lock&) = delete;

  // there are file systems without locks, where users have to take care
  bool try_alone() { return try_to(LOCK_EX); }
  bool try_shared() { return try_to(LOCK_SH); }
  void release() { flock(m_file, LOCK_UN); }

  std::string text() const
  {
    std::string result(4096, '\0');
    const ssize_t size = pread(m_file, &result[0], result.size(), 0);
    result.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return result;
  }

  bool set_text(const std::string& text)
  {
    return ftruncate(m_file, 0) == 0
      && pwrite(m_file, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
  }

private:
  bool try_to(int operation)
  {
    return flock(m_file, operation | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR);
  }

  const int m_file;
};

// A whole batch has its folder for itself. Parts share it, if they are parts of the same batch: `key` tells that.
class Batch_lock
{
public:
  Batch_lock(const std::filesystem::path& folder, const std::string& part_name, const std::string& key)
    : m_folder_lock(folder / "lock"), m_part_lock(folder / ("lock-" + part_name))
  {
    const bool is_part = !key.empty();
    // what a killed batch leaves behind ends a moment later
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
    while (!(m_part_lock.try_alone() && (is_part ? share(key) : m_folder_lock.try_alone())))
    {
      if (std::chrono::steady_clock::now() > end)
        throw Error(BUSY,
                    folder.parent_path().string()
                      + ": another batch is at work there; wait until it has ended, or give another --output-dir");
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }

private:
  bool share(const std::string& key)
  {
    if (m_folder_lock.try_shared() && m_folder_lock.text() == key)
      return true;
    m_folder_lock.release();
    if (!m_folder_lock.try_alone())
      return false;
    const bool is_set = m_folder_lock.set_text(key);
    // another one may come in between
    return is_set && m_folder_lock.try_shared() && m_folder_lock.text() == key;
  }

  File_lock m_folder_lock, m_part_lock;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_LOCK_H
