// A curve of a wireframe, which it keeps.

#ifndef WIREFRAME_EXTRACTION_PYTHON_CURVE_HANDLE_H
#define WIREFRAME_EXTRACTION_PYTHON_CURVE_HANDLE_H

#include "types.h"

#include <cstddef>
#include <memory>
#include <utility>

namespace python {

class Curve_handle
{
public:
  Curve_handle(std::shared_ptr<const Wireframe> wireframe, std::size_t index)
    : m_wireframe(std::move(wireframe)), m_index(index)
  {}

  const Wireframe& wireframe() const { return *m_wireframe; }
  const Wireframe::Curve& curve() const { return m_wireframe->curves[m_index]; }
  const Wireframe::Curve::Spline& spline() const { return curve().spline; }

private:
  std::shared_ptr<const Wireframe> m_wireframe;
  std::size_t m_index;
};

} // namespace python

#endif // WIREFRAME_EXTRACTION_PYTHON_CURVE_HANDLE_H
