// The files that the module reads and writes, but for those of CAD programs.

#include "arrays.h"
#include "bindings.h"
#include "messages.h"
#include "units.h"

#include <CGAL/Wireframe_extraction/IO/read_wireframe_json.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <fstream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

namespace python {
namespace {

namespace py = pybind11;
namespace parameters = CGAL::Wireframe_extraction::parameters;

void check(bool is_well, const std::string& error)
{
  if (!is_well)
    throw_value_error(error);
}

std::shared_ptr<Wireframe> read(const std::string& path)
{
  auto wireframe = std::make_shared<Wireframe>();
  std::string error;
  const bool is_read = CGAL::IO::read_wireframe_json(path, *wireframe, parameters::error_message(&error));
  check(is_read, error);
  return wireframe;
}

std::shared_ptr<Wireframe> from_json(const std::string& text)
{
  auto wireframe = std::make_shared<Wireframe>();
  std::string error;
  std::istringstream stream(text);
  check(CGAL::IO::read_wireframe_json(stream, *wireframe, parameters::error_message(&error)), error);
  return wireframe;
}

std::string to_json(const Wireframe& wireframe)
{
  std::ostringstream stream;
  std::string error;
  check(CGAL::IO::write_wireframe_json(stream, wireframe, parameters::error_message(&error)), error);
  return stream.str();
}

std::string to_svg(const Wireframe& wireframe)
{
  std::ostringstream stream;
  std::string error;
  check(CGAL::IO::write_wireframe_svg(stream, wireframe, parameters::error_message(&error)), error);
  return stream.str();
}

// a step or a tolerance of 0 is not given
void write(const Wireframe& wireframe, const std::string& path, const std::string& unit, double step,
           double chord_tolerance, bool obj_splines, bool dxf_splines)
{
  const auto if_given = [](double value) { return value > 0. ? std::optional<double>(value) : std::nullopt; };
  std::string error;
  const auto np = parameters::error_message(&error)
                    .unit(unit_of(unit))
                    .obj_splines(obj_splines)
                    .dxf_splines(dxf_splines)
                    .sampling_step(if_given(step))
                    .chord_tolerance(if_given(chord_tolerance));
  check(CGAL::IO::write_wireframe(path, wireframe, np), error);
}

} // namespace

void bind_files(py::module_& module)
{
  const py::call_guard<py::gil_scoped_release> without_lock;
  module.def("read", &read, without_lock);
  module.def("write", &write, without_lock);
  module.def("from_json", &from_json, without_lock);
  module.def("to_json", &to_json, without_lock);
  module.def("to_svg", &to_svg, without_lock);
}

} // namespace python
