// The function of the module that makes the page for a browser.

#include "arrays.h"
#include "bindings.h"
#include "messages.h"

#include <write_page.h>

#include <pybind11/stl.h>

#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace python {
namespace {

namespace py = pybind11;

typedef std::vector<std::pair<std::string, std::string>> Rows;

// The page that the tool writes with --html. `samples` has rows of three coordinates and a distance.
std::string page(const Wireframe& wireframe, const Double_array& samples, const std::string& title,
                 const std::string& unit, const Rows& summary, const std::vector<std::string>& warnings)
{
  tool::Page_texts texts;
  texts.title = title;
  texts.unit = unit;
  texts.program = "wireframe_extraction " WIREFRAME_EXTRACTION_VERSION_STRING;
  texts.summary = summary;
  texts.warnings = warnings;
  tool::Cloud cloud;
  for (py::ssize_t i = 0; i < samples.shape(0); ++i)
    cloud.emplace_back(Point(samples.at(i, 0), samples.at(i, 1), samples.at(i, 2)), samples.at(i, 3));
  const py::gil_scoped_release release;
  std::ostringstream stream;
  std::string error;
  if (!tool::write_page(stream, texts, cloud, {}, wireframe, error))
    throw_value_error(error);
  return stream.str();
}

} // namespace

void bind_page(py::module_& module)
{
  module.def("has_viewer", &tool::has_viewer);
  module.def("page", &page);
}

} // namespace python
