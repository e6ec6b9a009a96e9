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
  Stoppable_cloud(Distance_cloud_source& cloud, const Work_state& state) : m_cloud(cloud), m_state(state) {}

  bool has_distances() const override { return m_cloud.has_distances(); }
  std::size_t size_hint() const override { return m_cloud.size_hint(); }

  bool read(const Sink& sink) override
  {
    return m_cloud.read([&](const Sample* first, const Sample* beyond) {
      return !m_state.is_stopped() && sink(first, beyond);
    }) && !m_state.is_stopped();
  }

  std::string error_message() const override { return m_state.is_stopped() ? "stopped" : m_cloud.error_message(); }

private:
  Distance_cloud_source& m_cloud;
  const Work_state& m_state;
};

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_STOPPABLE_CLOUD_H
