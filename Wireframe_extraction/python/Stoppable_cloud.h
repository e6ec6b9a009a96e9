// A cloud whose reading can be stopped: nothing else asks whether to go on while a large one is read.

#ifndef WIREFRAME_EXTRACTION_PYTHON_STOPPABLE_CLOUD_H
#define WIREFRAME_EXTRACTION_PYTHON_STOPPABLE_CLOUD_H

#include "run_beside.h"

#include <CGAL/Wireframe_extraction/Distance_cloud_source.h>

#include <cstddef>
#include <string>

namespace python {

class Stoppable_cloud : public CGAL::Wireframe_extraction::Distance_cloud_source
{
public:
  explicit Stoppable_cloud(Distance_cloud_source& cloud) : m_cloud(cloud) {}
  Stoppable_cloud(Distance_cloud_source& cloud, const Work_state& state) : m_cloud(cloud), m_state(&state) {}

  // who stops it from now on
  void set_state(const Work_state& state) { m_state = &state; }

  bool has_distances() const override { return m_cloud.has_distances(); }
  std::size_t size_hint() const override { return m_cloud.size_hint(); }

  bool read(const Sink& sink) override
  {
    return m_cloud.read([&](const Sample* first, const Sample* beyond) { return !is_stopped() && sink(first, beyond); })
      && !is_stopped();
  }

  std::string error_message() const override { return is_stopped() ? "stopped" : m_cloud.error_message(); }

private:
  bool is_stopped() const { return m_state != nullptr && m_state->is_stopped(); }

  Distance_cloud_source& m_cloud;
  const Work_state* m_state = nullptr;
};

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_STOPPABLE_CLOUD_H
