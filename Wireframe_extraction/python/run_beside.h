// Runs what takes long without Python's lock, and meanwhile shows progress and looks for Ctrl-C.

#ifndef WIREFRAME_EXTRACTION_PYTHON_RUN_BESIDE_H
#define WIREFRAME_EXTRACTION_PYTHON_RUN_BESIDE_H

#include <pybind11/pybind11.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>

namespace python {

// What the work tells, and what it is told. Any thread may call these.
class Work_state
{
public:
  bool is_stopped() const { return m_is_stopped; }
  double share() const { return m_share; }
  void stop() { m_is_stopped = true; }

  // takes the share that is done, and returns whether to go on
  bool proceed(double share)
  {
    m_share = share;
    return !m_is_stopped;
  }

private:
  std::atomic<bool> m_is_stopped{false};
  std::atomic<double> m_share{0.};
};

// Runs the work in a thread of its own with at most that many threads, as many as there are for 0. The thread that
// calls waits, calls `progress` with the share that is done unless it is None, and lets Python handle signals. If one
// of these throws, the work is stopped, and the exception goes on once it has ended. What the work
// throws goes on as well.
void run_beside(const std::function<void(Work_state&)>& work, int number_of_threads, const pybind11::object& progress);

// The same for what is done for many points, some thousands at a time: calls `work(first, beyond)` for ranges of them,
// one after the other.
template <class Work>
void run_in_pieces(std::size_t size, const Work& work)
{
  static constexpr std::size_t points_per_piece = 65536;
  run_beside(
    [&](Work_state& state) {
      for (std::size_t first = 0; first < size && !state.is_stopped(); first += points_per_piece)
        work(first, (std::min)(first + points_per_piece, size));
    },
    1, pybind11::none());
}

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_RUN_BESIDE_H
