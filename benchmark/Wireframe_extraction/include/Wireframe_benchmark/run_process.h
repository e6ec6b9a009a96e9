// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef WIREFRAME_BENCHMARK_RUN_PROCESS_H
#define WIREFRAME_BENCHMARK_RUN_PROCESS_H

#include <fcntl.h>
#include <sys/resource.h>
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
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace Wireframe_benchmark {

/// Bounds for a process; 0 is none.
struct Process_limits
{
  double seconds = 0;
  std::size_t megabytes = 0; ///< of address space
};

/// How a process ended, and what it took.
struct Process_result
{
  bool is_timed_out = false;
  int exit_code = 0; ///< 127 if the program could not be started
  int signal = 0;    ///< that ended it, or 0
  double seconds = 0;
  double cpu_seconds = 0;
  double peak_megabytes = 0; ///< of resident memory
};

namespace internal {

// the process that is running, or 0
inline volatile std::sig_atomic_t& running_process()
{
  static volatile std::sig_atomic_t process = 0;
  return process;
}

inline void end_with_running_process(int)
{
  if (running_process() > 0)
    kill(-running_process(), SIGKILL);
  _exit(1);
}

// Puts off interruptions while it lives.
class Interruptions_off
{
public:
  Interruptions_off()
  {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    sigprocmask(SIG_BLOCK, &signals, &m_before);
  }

  ~Interruptions_off() { end(); }

  Interruptions_off(const Interruptions_off&) = delete;
  Interruptions_off& operator=(const Interruptions_off&) = delete;

  void end() { sigprocmask(SIG_SETMASK, &m_before, nullptr); }

private:
  sigset_t m_before;
};

// Between fork and exec only what is safe there. The process leads a group, so that its children end with it.
[[noreturn]] inline void become(char* const* arguments, const char* errors, const Process_limits& limits,
                                Interruptions_off& interruptions)
{
  setpgid(0, 0);
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGPIPE, SIG_DFL);
  interruptions.end();
  if (limits.megabytes > 0)
  {
    const rlim_t bytes = static_cast<rlim_t>(limits.megabytes) << 20;
    const rlimit limit = {bytes, bytes};
    setrlimit(RLIMIT_AS, &limit);
  }
  const rlimit no_core = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  const int null = open("/dev/null", O_RDWR);
  const int error_file = open(errors, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(null, STDIN_FILENO);
  dup2(null, STDOUT_FILENO);
  dup2(error_file, STDERR_FILENO);
  execvp(arguments[0], arguments);
  const char* const reason = std::strerror(errno);
  if (write(STDERR_FILENO, "cannot be started: ", 19) < 0 || write(STDERR_FILENO, reason, std::strlen(reason)) < 0)
    _exit(126);
  _exit(127);
}

inline double seconds_of(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

} // namespace internal

/// lets an interruption of this process end the program too that it runs just then.
inline void end_together_with_program()
{
  std::signal(SIGINT, internal::end_with_running_process);
  std::signal(SIGTERM, internal::end_with_running_process);
}

/*!
runs a program, and waits until it ends; what exceeds the limits is killed with all its children. Its output is
dropped, what it writes to standard error goes to the file `errors`.

Throws `std::runtime_error` if there can be no new process.
*/
inline Process_result run_process(std::vector<std::string> words, const std::string& errors,
                                  const Process_limits& limits)
{
  typedef std::chrono::steady_clock Clock;
  std::vector<char*> arguments;
  for (std::string& word : words)
    arguments.push_back(&word[0]);
  arguments.push_back(nullptr);

  const Clock::time_point begin = Clock::now();
  const auto seconds = [begin] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
  pid_t child = 0;
  {
    internal::Interruptions_off interruptions; // until it is known what is to end with this process
    child = fork();
    if (child < 0)
      throw std::runtime_error(std::string("no process can be started: ") + std::strerror(errno));
    if (child == 0)
      internal::become(arguments.data(), errors.c_str(), limits, interruptions);
    setpgid(child, child); // here too, as it is not known who runs first
    internal::running_process() = child;
  }

  Process_result result;
  int status = 0;
  rusage usage = {};
  while (true)
  {
    const pid_t ended = wait4(child, &status, result.is_timed_out ? 0 : WNOHANG, &usage);
    if (ended == child)
      break;
    if (ended < 0 && errno != EINTR)
      throw std::runtime_error(std::string("a process got lost: ") + std::strerror(errno));
    if (limits.seconds > 0. && seconds() > limits.seconds)
    {
      result.is_timed_out = true;
      kill(-child, SIGKILL);
      continue;
    }
    // short processes are measured exactly, long ones seldom disturbed
    std::this_thread::sleep_for(std::chrono::duration<double>((std::min)(0.02, 0.001 + 0.01 * seconds())));
  }
  result.seconds = seconds();
  kill(-child, SIGKILL); // whatever it left behind
  internal::running_process() = 0;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 0;
  result.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  result.cpu_seconds = internal::seconds_of(usage.ru_utime) + internal::seconds_of(usage.ru_stime);
#ifdef __APPLE__
  result.peak_megabytes = double(usage.ru_maxrss) / 1048576.;
#else
  result.peak_megabytes = double(usage.ru_maxrss) / 1024.;
#endif
  return result;
}

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_RUN_PROCESS_H
