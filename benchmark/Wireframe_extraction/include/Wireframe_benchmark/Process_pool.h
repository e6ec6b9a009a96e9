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

#ifndef WIREFRAME_BENCHMARK_PROCESS_POOL_H
#define WIREFRAME_BENCHMARK_PROCESS_POOL_H

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <deque>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_benchmark {

/*!
Runs pieces of work, each in a process of its own, several at once. A piece of work returns a text, which is passed
on to this process. That of a process that crashes does not come, and nothing else happens.
*/
class Process_pool
{
public:
  /// A piece of work, run in the new process; it must not throw.
  typedef std::function<std::string()> Work;

  /// What is called in this process when one has ended: with the number of the work, whether it ended well, and its
  /// text, or how it ended.
  typedef std::function<void(std::size_t, bool, const std::string&)> Done;

  explicit Process_pool(std::size_t number_of_processes) : m_size(number_of_processes) {}

  ~Process_pool()
  {
    for (const Worker& worker : m_workers)
    {
      kill(worker.process, SIGTERM);
      waitpid(worker.process, nullptr, 0);
      close(worker.pipe);
    }
  }

  Process_pool(const Process_pool&) = delete;
  Process_pool& operator=(const Process_pool&) = delete;

  /// adds a piece of work; allowed while the pool runs, too. Returns its number.
  std::size_t add(Work work)
  {
    m_works.push_back(std::move(work));
    return m_works.size() - 1;
  }

  /// runs all work. Returns `false` if `is_stopped` was set meanwhile; the destructor ends what then runs on.
  bool run(const Done& done, const volatile std::sig_atomic_t& is_stopped)
  {
    while (is_stopped == 0 && (m_next < m_works.size() || !m_workers.empty()))
    {
      while (m_next < m_works.size() && m_workers.size() < m_size)
        start(m_next++);
      read_some(done);
    }
    return is_stopped == 0;
  }

private:
  struct Worker
  {
    std::size_t work;
    pid_t process;
    int pipe;
    std::string text;
  };

  void start(std::size_t work)
  {
    int ends[2];
    std::fflush(nullptr); // what is in buffers is not to be written twice
    if (pipe(ends) != 0)
      throw std::runtime_error(std::string("there can be no more pipes: ") + std::strerror(errno));
    const pid_t process = fork();
    if (process < 0)
      throw std::runtime_error(std::string("there can be no more processes: ") + std::strerror(errno));
    if (process == 0)
    {
      std::signal(SIGINT, SIG_DFL);
      std::signal(SIGTERM, SIG_DFL);
      close(ends[0]);
      for (const Worker& other : m_workers)
        close(other.pipe);
      write_all(ends[1], m_works[work]());
      _exit(0);
    }
    close(ends[1]);
    m_workers.push_back(Worker{work, process, ends[0], std::string()});
  }

  // The text may be empty; with a line feed at its end it is not, where it is complete.
  static void write_all(int pipe, const std::string& text)
  {
    const std::string all = text + '\n';
    std::size_t begin = 0;
    while (begin < all.size())
    {
      const ssize_t n = write(pipe, all.data() + begin, all.size() - begin);
      if (n < 0 && errno != EINTR)
        _exit(1);
      begin += n < 0 ? 0 : static_cast<std::size_t>(n);
    }
  }

  void read_some(const Done& done)
  {
    std::vector<pollfd> polled;
    for (const Worker& worker : m_workers)
      polled.push_back(pollfd{worker.pipe, POLLIN, 0});
    if (poll(polled.data(), static_cast<nfds_t>(polled.size()), 1000) < 0)
      return; // a signal; the caller looks at what it was
    for (std::size_t i = polled.size(); i-- > 0;)
    {
      if (polled[i].revents == 0)
        continue;
      char buffer[4096];
      const ssize_t n = read(m_workers[i].pipe, buffer, sizeof(buffer));
      if (n > 0)
        m_workers[i].text.append(buffer, static_cast<std::size_t>(n));
      else if (n == 0 || errno != EINTR)
        finish(i, done);
    }
  }

  void finish(std::size_t i, const Done& done)
  {
    Worker worker = std::move(m_workers[i]);
    m_workers.erase(m_workers.begin() + static_cast<std::ptrdiff_t>(i));
    close(worker.pipe);
    int status = 0;
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR)
    {}
    const bool is_complete = WIFEXITED(status) && WEXITSTATUS(status) == 0 && !worker.text.empty();
    if (is_complete)
      worker.text.pop_back();
    else if (WIFSIGNALED(status))
      worker.text = std::string("signal ") + std::to_string(WTERMSIG(status));
    else
      worker.text = "exit " + std::to_string(WEXITSTATUS(status));
    done(worker.work, is_complete, worker.text);
  }

  const std::size_t m_size;
  std::deque<Work> m_works;
  std::size_t m_next = 0;
  std::vector<Worker> m_workers;
};

} // namespace Wireframe_benchmark

#endif // WIREFRAME_BENCHMARK_PROCESS_POOL_H
