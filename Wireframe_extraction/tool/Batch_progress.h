// What a batch says while it is at work, to the standard error stream.

#ifndef EXTRACT_WIREFRAME_BATCH_PROGRESS_H
#define EXTRACT_WIREFRAME_BATCH_PROGRESS_H

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace tool {

// On a terminal one line that changes, elsewhere a line once a minute.
class Batch_progress
{
public:
  Batch_progress(bool is_on, std::size_t number_to_do)
    : m_is_on(is_on), m_is_terminal(isatty(STDERR_FILENO) != 0), m_number_to_do(number_to_do)
  {}

  // a line that stays
  void say(const std::string& text)
  {
    if (m_is_on)
      std::fprintf(stderr, "%s%s\n", m_is_terminal ? "\r\033[K" : "", text.c_str());
  }

  void count(bool is_well)
  {
    ++m_number_done;
    m_number_failed += is_well ? 0 : 1;
  }

  void show(std::size_t number_of_running)
  {
    const auto now = Clock::now();
    const double pause = m_is_terminal ? 0.2 : 60.;
    if (!m_is_on || std::chrono::duration<double>(now - m_shown).count() < pause)
      return;
    m_shown = now;
    const std::string text = std::to_string(m_number_done) + " of " + std::to_string(m_number_to_do) + " done, "
      + std::to_string(m_number_failed) + " failed, " + std::to_string(number_of_running) + " at work" + time_left(now);
    if (m_is_terminal)
      std::fprintf(stderr, "\r\033[K%s", text.c_str());
    else
      std::fprintf(stderr, "%s\n", text.c_str());
  }

  void clear() const
  {
    if (m_is_on && m_is_terminal)
      std::fputs("\r\033[K", stderr);
  }

private:
  typedef std::chrono::steady_clock Clock;

  std::string time_left(Clock::time_point now) const
  {
    if (m_number_done == 0)
      return std::string();
    const double seconds = std::chrono::duration<double>(now - m_begin).count() * double(m_number_to_do - m_number_done)
      / double(m_number_done);
    char text[64];
    std::snprintf(text, sizeof(text), ", about %.0f:%02d h left", std::floor(seconds / 3600.),
                  static_cast<int>(std::fmod(seconds / 60., 60.)));
    return text;
  }

  const bool m_is_on, m_is_terminal;
  const std::size_t m_number_to_do;
  std::size_t m_number_done = 0, m_number_failed = 0;
  const Clock::time_point m_begin = Clock::now();
  Clock::time_point m_shown = m_begin;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_BATCH_PROGRESS_H
