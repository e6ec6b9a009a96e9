#include "run_beside.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <chrono>
#include <exception>
#include <future>
#include <thread>
#include <utility>

namespace python {
namespace {

namespace py = pybind11;

// often enough for Ctrl-C and for a bar that moves, and too rarely to cost time
constexpr std::chrono::milliseconds time_between_looks(50);

void run_with_threads(const std::function<void()>& work, int number_of_threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  // An arena, not a global limit: calls at the same time keep their own numbers of threads.
  if (number_of_threads > 0)
  {
    tbb::task_arena arena(number_of_threads);
    arena.execute(work);
    return;
  }
#endif
  work();
}

// Python's turn while the work goes on.
class Attendant
{
public:
  explicit Attendant(const py::object& progress) : m_progress(progress) {}

  void look(double share)
  {
    if (PyErr_CheckSignals() != 0)
      throw py::error_already_set();
    if (m_progress.is_none() || !(share > m_shown))
      return;
    m_shown = share;
    m_progress(share);
  }

private:
  const py::object& m_progress;
  double m_shown = 0.;
};

bool is_done(const std::future<void>& end)
{
  const py::gil_scoped_release release;
  return end.wait_for(time_between_looks) == std::future_status::ready;
}

} // namespace

void run_beside(const std::function<void(Work_state&)>& work, int number_of_threads, const py::object& progress)
{
  Work_state state;
  Attendant attendant(progress);
  std::packaged_task<void()> task([&] { run_with_threads([&] { work(state); }, number_of_threads); });
  std::future<void> end = task.get_future();
  std::thread thread(std::move(task));
  std::exception_ptr interruption;
  while (!is_done(end))
    try
    {
      if (!state.is_stopped())
        attendant.look(state.share());
    }
    catch (...)
    {
      interruption = std::current_exception();
      state.stop();
    }
  {
    const py::gil_scoped_release release;
    thread.join();
  }
  if (interruption)
    std::rethrow_exception(interruption);
  end.get();
  attendant.look(1.);
}

} // namespace python
