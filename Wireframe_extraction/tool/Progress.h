// What the tool says while it is at work, to the standard error stream.

#ifndef EXTRACT_WIREFRAME_PROGRESS_H
#define EXTRACT_WIREFRAME_PROGRESS_H

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <atomic>
#include <cstdio>

namespace tool {

inline bool is_error_stream_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// One line on a terminal that says how far the work is; nothing elsewhere.
class Progress
{
public:
  explicit Progress(bool is_on) : m_is_on(is_on) {}
  ~Progress() { clear(); }

  void start(const char* what)
  {
    m_what = what;
    show();
  }

  // may be called by another thread
  void set(double share)
  {
    const int percent = static_cast<int>(100. * share);
    if (m_percent.exchange(percent) != percent)
      show();
  }

  void clear() const
  {
    if (m_is_on)
      std::fputs("\r\033[K", stderr);
  }

private:
  void show() const
  {
    if (m_is_on)
      std::fprintf(stderr, "\r\033[K%3d %% %s", m_percent.load(), m_what.load());
  }

  const bool m_is_on;
  std::atomic<const char*> m_what{""};
  std::atomic<int> m_percent{0};
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_PROGRESS_H
