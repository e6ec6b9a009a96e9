// The class Wireframe of the module.

#include "Curve_handle.h"
#include "arrays.h"
#include "bindings.h"
#include "nearest_distances.h"
#include "run_beside.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace python {
namespace {

namespace py = pybind11;

// the vertices of each curve; -1 where there is none
py::array edges(const Wireframe& wireframe)
{
  std::vector<std::int64_t> indices;
  for (const Wireframe::Curve& curve : wireframe.curves)
    for (const std::size_t vertex : {curve.source, curve.target})
      indices.push_back(vertex == Wireframe::Curve::no_vertex ? -1 : static_cast<std::int64_t>(vertex));
  return to_array(std::move(indices)).reshape({static_cast<py::ssize_t>(wireframe.curves.size()), py::ssize_t(2)});
}

py::list curves(const std::shared_ptr<Wireframe>& wireframe)
{
  py::list result;
  for (std::size_t i = 0; i < wireframe->curves.size(); ++i)
    result.append(Curve_handle(wireframe, i));
  return result;
}

// why the wireframe cannot be written; empty if it can
std::string problem(const Wireframe& wireframe)
{
  std::string why;
  wireframe.is_valid(&why);
  return why;
}

py::array distances(const Wireframe& wireframe, const Double_array& rows)
{
  const std::vector<Point> points = to_points(rows);
  std::vector<double> result;
  run_in_pieces(points.size(), [&](std::size_t first, std::size_t beyond) {
    const std::vector<double> piece = nearest_distances(wireframe, {&points[first], points.data() + beyond});
    result.insert(result.end(), piece.begin(), piece.end());
  });
  return to_array(std::move(result));
}

} // namespace

void bind_wireframe(py::module_& module)
{
  py::class_<Wireframe, std::shared_ptr<Wireframe>>(module, "Wireframe")
    .def(py::init<>())
    .def_readonly("sampling_distance", &Wireframe::sampling_distance)
    .def_property_readonly("vertices", [](const Wireframe& w) { return copy_of(w.vertices); })
    .def("edges", &edges)
    .def("curves", &curves)
    .def("problem", &problem)
    .def("distances", &distances);
}

} // namespace python
