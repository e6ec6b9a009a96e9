// The files of CAD programs: a module of its own, so that only who writes one loads OpenCASCADE.

#include "messages.h"
#include "types.h"
#include "units.h"

#include <CGAL/Wireframe_extraction/IO/write_wireframe_brep.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_iges.h>
#include <CGAL/Wireframe_extraction/IO/write_wireframe_step.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <pybind11/pybind11.h>

#include <mutex>
#include <string>

namespace {

namespace py = pybind11;
namespace parameters = CGAL::Wireframe_extraction::parameters;
using CGAL::Wireframe_extraction::Step_schema;

// `extension` is in lower case and has its dot
void write_cad(const python::Wireframe& wireframe, const std::string& path, const std::string& extension,
               const std::string& unit, const std::string& schema)
{
  // OpenCASCADE keeps the unit and the schema in settings that all of a process share
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  std::string error;
  CGAL::Wireframe_provenance provenance;
  provenance.program = "wireframe_extraction " WIREFRAME_EXTRACTION_VERSION_STRING;
  const auto np = parameters::error_message(&error)
                    .unit(python::unit_of(unit))
                    .step_schema(schema == "ap242" ? Step_schema::AP242 : Step_schema::AP214);
  const bool is_written = extension == ".brep" ? CGAL::IO::write_wireframe_brep(path, wireframe, np)
    : extension == ".step" || extension == ".stp"
    ? CGAL::IO::write_wireframe_step(path, wireframe, np.provenance(provenance))
    : CGAL::IO::write_wireframe_iges(path, wireframe, np);
  if (!is_written)
    python::throw_value_error(error);
}

} // namespace

PYBIND11_MODULE(_cad, module)
{
  module.doc() = "Writes STEP, IGES and BREP. The module _core has to be imported before: it has the class Wireframe.";
  module.def("write", &write_cad, py::call_guard<py::gil_scoped_release>());
}
