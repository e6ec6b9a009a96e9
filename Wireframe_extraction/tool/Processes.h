// Functions that run in processes of their own, with limits.

#ifndef EXTRACT_WIREFRAME_PROCESSES_H
#define EXTRACT_WIREFRAME_PROCESSES_H

#include "Error.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/select.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace tool {

// the signal that asked this process to end, or 0
inline volatile std::sig_atomic_t& signal_to_end()
{
  static volatile std::sig_atomic_t signal = 0;
  return signal;
}

struct Process_limits
{
  double seconds = 0.; // 0: none
  int megabytes = 0;   // 0: none
};

struct Ended_process
{
  std::size_t slot = 0;
  int exit_code = 0, signal = 0;
  bool is_timed_out = false;
  double seconds = 0., processor_seconds = 0., peak_megabytes = 0.;
};

// Signals wait while this lives, except where wait() lets them in: so nothing happens between two steps that belong
// together.
class Processes
{
public:
  Processes(std::size_t number_of_slots, const Process_limits& limits) : m_limits(limits), m_slots(number_of_slots)
  {
    sigset_t signals;
    sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD})
    {
      struct sigaction action = {};
      sigaction(signal, nullptr, &action);
      if (signal == SIGHUP && action.sa_handler == SIG_IGN)
        continue; // nohup
      sigaddset(&signals, signal);
      action.sa_handler = (signal == SIGCHLD) ? note_child : note_end;
      action.sa_flags = 0;
      sigemptyset(&action.sa_mask);
      sigaction(signal, &action, nullptr);
    }
    sigprocmask(SIG_BLOCK, &signals, &m_mask);
  }

  ~Processes() { end_all(); }
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  bool is_idle() const { return m_number_of_running == 0; }
  std::size_t number_of_running() const { return m_number_of_running; }

  // the first free slot, or the number of slots
  std::size_t free_slot() const
  {
    std::size_t slot = 0;
    while (slot < m_slots.size() && m_slots[slot].process != 0)
      ++slot;
    return slot;
  }

  // Runs `work` in a new process, which ends with what it returns. What the process says goes to the file `messages`.
  void start(std::size_t slot, const std::string& messages, const std::function<int()>& work)
  {
    std::fflush(nullptr); // what is in buffers is not to be written twice
    const pid_t parent = getpid();
    const pid_t process = fork();
    if (process < 0)
      throw Error(INTERNAL_ERROR,
                  std::string("no process can be started: ") + std::strerror(errno) + "; try fewer --jobs");
    if (process == 0)
    {
      prepare(parent, messages);
      _exit(work());
    }
    setpgid(process, process); // here too, as it is not known who runs first
    m_slots[slot] = Slot{process, Clock::now(), false};
    ++m_number_of_running;
  }

  // Waits until something happens, but not for longer than `seconds`; then tells which processes have ended.
  template <class Done>
  void wait(double seconds, const Done& done)
  {
    // The signal of a child that ends after this is pending or still to come: none gets lost.
    sleep(collect(done) ? 0. : seconds);
    collect(done);
    kill_late_ones();
  }

  void let_signals_in() const { sleep(0.); }

  void end_all()
  {
    for (const Slot& slot : m_slots)
      if (slot.process != 0)
        kill(-slot.process, SIGKILL);
    for (Slot& slot : m_slots)
      while (slot.process != 0)
        if (waitpid(slot.process, nullptr, 0) >= 0 || errno != EINTR)
          slot = Slot();
    m_number_of_running = 0;
  }

private:
  typedef std::chrono::steady_clock Clock;

  struct Slot
  {
    pid_t process = 0;
    Clock::time_point begin;
    bool is_timed_out = false;

    Slot() {}
    Slot(pid_t m_process, Clock::time_point m_begin, bool m_is_timed_out)
      : process(m_process), begin(m_begin), is_timed_out(m_is_timed_out)
    {}

    double seconds() const { return std::chrono::duration<double>(Clock::now() - begin).count(); }
  };

  static void note_child(int) {}
  static void note_end(int signal) { signal_to_end() = signal; }

  void prepare(pid_t parent, const std::string& messages) const
  {
    setpgid(0, 0); // a group of its own, so that its children end with it
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
    if (getppid() != parent)
      _exit(INTERNAL_ERROR); // it was killed just now
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGCHLD})
      std::signal(signal, SIG_DFL);
    sigprocmask(SIG_SETMASK, &m_mask, nullptr);
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    limit_memory();
    const int null = open("/dev/null", O_RDWR);
    const int file = open(messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0666);
    dup2(null, STDIN_FILENO);
    dup2(null, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
  }

  void limit_memory() const
  {
    if (m_limits.megabytes == 0)
      return;
    const rlim_t bytes = static_cast<rlim_t>(m_limits.megabytes) << 20;
    const rlimit limit = {bytes, bytes};
#ifdef __linux__
    setrlimit(RLIMIT_DATA, &limit); // not RLIMIT_AS, which counts what threads reserve and never touch
#else
    setrlimit(RLIMIT_AS, &limit);
#endif
  }

  template <class Done>
  bool collect(const Done& done)
  {
    bool is_one_done = false;
    for (std::size_t i = 0; i < m_slots.size(); ++i)
    {
      int status = 0;
      rusage usage = {};
      if (m_slots[i].process == 0 || wait4(m_slots[i].process, &status, WNOHANG, &usage) != m_slots[i].process)
        continue;
      const Slot slot = m_slots[i];
      m_slots[i] = Slot();
      --m_number_of_running;
      kill(-slot.process, SIGKILL); // whatever it left behind
      done(ended(i, slot, status, usage));
      is_one_done = true;
    }
    return is_one_done;
  }

  static Ended_process ended(std::size_t i, const Slot& slot, int status, const rusage& usage)
  {
    const auto seconds = [](const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); };
    Ended_process result;
    result.slot = i;
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    result.is_timed_out = slot.is_timed_out && result.signal != 0;
    result.seconds = slot.seconds();
    result.processor_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
#ifdef __APPLE__
    result.peak_megabytes = double(usage.ru_maxrss) / 1048576.;
#else
    result.peak_megabytes = double(usage.ru_maxrss) / 1024.;
#endif
    return result;
  }

  // Signals that are pending or come now end it early.
  void sleep(double seconds) const
  {
    if (m_limits.seconds > 0.)
      for (const Slot& slot : m_slots)
        if (slot.process != 0 && !slot.is_timed_out)
          seconds = (std::min)(seconds, (std::max)(m_limits.seconds - slot.seconds(), 0.) + 0.001);
    timespec time;
    time.tv_sec = static_cast<time_t>(seconds);
    time.tv_nsec = static_cast<long>(1e9 * (seconds - double(time.tv_sec)));
    pselect(0, nullptr, nullptr, nullptr, &time, &m_mask);
  }

  void kill_late_ones()
  {
    if (m_limits.seconds == 0.)
      return;
    for (Slot& slot : m_slots)
      if (slot.process != 0 && !slot.is_timed_out && slot.seconds() > m_limits.seconds)
      {
        slot.is_timed_out = true;
        kill(-slot.process, SIGKILL);
      }
  }

  const Process_limits m_limits;
  std::vector<Slot> m_slots;
  std::size_t m_number_of_running = 0;
  sigset_t m_mask;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_PROCESSES_H
