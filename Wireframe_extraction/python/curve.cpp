// The class Curve of the module.

#include "Curve_handle.h"
#include "arrays.h"
#include "bindings.h"
#include "run_beside.h"

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/curve_tools.h>

#include <boost/iterator/function_output_iterator.hpp>
#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace python {
namespace {

namespace py = pybind11;

// the value of a function of a conic; none for other curves
template <class Function>
auto of_conic(const Curve_handle& handle, const Function& function)
  -> std::optional<decltype(function(*handle.curve().conic))>
{
  if (!handle.curve().conic)
    return std::nullopt;
  return function(*handle.curve().conic);
}

typedef std::array<double, 3> Triple;

template <class Position>
Triple to_triple(const Position& p)
{
  return {{p.x(), p.y(), p.z()}};
}

// evaluates something at many parameters, as rows of three numbers
template <class Function>
py::array rows_at(const Double_array& parameters, const Function& function)
{
  std::vector<double> coordinates;
  {
    const py::gil_scoped_release release;
    coordinates.reserve(3 * static_cast<std::size_t>(parameters.size()));
    for (py::ssize_t i = 0; i < parameters.size(); ++i)
      append(function(parameters.data()[i]), coordinates);
  }
  return to_rows(std::move(coordinates));
}

py::array curvature_at(const Curve_handle& handle, const Double_array& parameters)
{
  std::vector<double> values;
  {
    const py::gil_scoped_release release;
    values.reserve(static_cast<std::size_t>(parameters.size()));
    for (py::ssize_t i = 0; i < parameters.size(); ++i)
      values.push_back(handle.spline().curvature(parameters.data()[i]));
  }
  return to_array(std::move(values));
}

// By step if there is one, else by count. What writes the points is what can be stopped: each takes microseconds.
py::array sample(const Curve_handle& handle, double step, std::size_t count)
{
  struct Stopped
  {};
  std::vector<double> coordinates;
  const auto work = [&](Work_state& state) {
    const auto take = boost::make_function_output_iterator([&](const Point& p) {
      if (state.is_stopped())
        throw Stopped();
      append(p, coordinates);
    });
    try
    {
      if (step > 0.)
        handle.spline().sample_by_distance(step, take);
      else
        handle.spline().sample_by_count(count, take);
    }
    catch (const Stopped&)
    {}
  };
  run_beside(work, 1, py::none());
  return to_rows(std::move(coordinates));
}

// parameters, points and distances
py::tuple closest(const Curve_handle& handle, const Double_array& queries)
{
  const std::vector<Point> points = to_points(queries);
  std::vector<double> parameters, coordinates, distances;
  run_in_pieces(points.size(), [&](std::size_t first, std::size_t beyond) {
    std::vector<Wireframe::Curve::Spline::Closest_point> found;
    handle.spline().closest_points(&points[first], points.data() + beyond, std::back_inserter(found));
    for (const auto& one : found)
    {
      parameters.push_back(one.parameter);
      append(one.point, coordinates);
      distances.push_back(one.distance);
    }
  });
  return py::make_tuple(to_array(std::move(parameters)), to_rows(std::move(coordinates)),
                        to_array(std::move(distances)));
}

py::dict uncertainty(const Curve_handle& handle)
{
  const auto& values = handle.curve().uncertainty;
  py::dict result;
  result["position"] = values.position;
  result["direction"] = values.direction;
  result["major_radius"] = values.major_radius;
  result["minor_radius"] = values.minor_radius;
  return result;
}

py::tuple doubts(const Curve_handle& handle)
{
  py::list names;
  for (const CGAL::Wireframe_doubt doubt : handle.curve().doubts)
    names.append(to_string(doubt));
  return py::tuple(names);
}

// A wireframe with this curve alone, and with its vertices, by which the curve can be handed on.
std::shared_ptr<Wireframe> alone(const Curve_handle& handle)
{
  const Wireframe& wireframe = handle.wireframe();
  auto result = std::make_shared<Wireframe>();
  result->sampling_distance = wireframe.sampling_distance;
  Wireframe::Curve curve = handle.curve();
  if (curve.source != Wireframe::Curve::no_vertex)
  {
    result->vertices = {wireframe.vertices[curve.source], wireframe.vertices[curve.target]};
    curve.target = curve.source == curve.target ? 0 : 1;
    curve.source = 0;
  }
  result->curves.push_back(std::move(curve));
  return result;
}

std::optional<std::size_t> vertex_of(std::size_t index)
{
  return index == Wireframe::Curve::no_vertex ? std::nullopt : std::optional<std::size_t>(index);
}

// the color of each type, the same in all files
py::dict colors()
{
  py::dict result;
  for (const CGAL::Wireframe_curve_type type : CGAL::IO::internal::all_curve_types())
    result[to_string(type).c_str()] = CGAL::IO::internal::hexadecimal(CGAL::IO::internal::colour_of(type));
  return result;
}

void bind_values(py::class_<Curve_handle>& curve)
{
  typedef const Curve_handle& C;
  curve.def_property_readonly("type", [](C c) { return to_string(c.curve().type); })
    .def_property_readonly("closed", [](C c) { return c.curve().is_closed(); })
    .def_property_readonly("source", [](C c) { return vertex_of(c.curve().source); })
    .def_property_readonly("target", [](C c) { return vertex_of(c.curve().target); })
    .def_property_readonly("rms", [](C c) { return c.curve().rms; })
    .def_property_readonly("max", [](C c) { return c.curve().max; })
    .def_property_readonly("support", [](C c) { return c.curve().support; })
    .def_property_readonly("doubts", &doubts)
    .def_property_readonly("degree", [](C c) { return c.spline().degree(); })
    .def_property_readonly("range", [](C c) { return c.spline().parameter_range(); })
    .def_property_readonly("uncertainty", &uncertainty);
}

void bind_conic(py::class_<Curve_handle>& curve)
{
  typedef const Curve_handle& C;
  curve
    .def_property_readonly(
      "radii", [](C c) { return of_conic(c, [](auto& k) { return std::make_pair(k.major_radius, k.minor_radius); }); })
    .def_property_readonly(
      "angles", [](C c) { return of_conic(c, [](auto& k) { return std::make_pair(k.start_angle, k.end_angle); }); })
    .def_property_readonly("center", [](C c) { return of_conic(c, [](auto& k) { return to_triple(k.center); }); })
    .def_property_readonly("axis", [](C c) { return of_conic(c, [](auto& k) { return to_triple(k.axis); }); })
    .def_property_readonly("major_direction",
                           [](C c) { return of_conic(c, [](auto& k) { return to_triple(k.major_direction); }); });
}

void bind_spline(py::class_<Curve_handle>& curve)
{
  typedef const Curve_handle& C;
  curve.def_property_readonly("knots", [](C c) { return copy_of(c.spline().knots()); })
    .def_property_readonly("control_points", [](C c) { return copy_of(c.spline().control_points()); })
    .def_property_readonly("weights", [](C c) -> py::object {
      if (!c.spline().is_rational())
        return py::none();
      return copy_of(c.spline().weights());
    });
}

void bind_functions(py::class_<Curve_handle>& curve)
{
  typedef const Curve_handle& C;
  curve
    .def(
      "length", [](C c) { return c.spline().length(); }, py::call_guard<py::gil_scoped_release>())
    .def("points", [](C c, const Double_array& t) { return rows_at(t, [&](double u) { return c.spline().point(u); }); })
    .def("derivatives",
         [](C c, const Double_array& t, std::size_t order) {
           return rows_at(t, [&](double u) { return c.spline().derivative(u, order); });
         })
    .def("tangents",
         [](C c, const Double_array& t) { return rows_at(t, [&](double u) { return c.spline().tangent(u); }); })
    .def("curvatures", &curvature_at)
    .def("sample", &sample)
    .def("closest", &closest)
    .def("alone", &alone);
}

} // namespace

void bind_curve(py::module_& module)
{
  module.def("colors", &colors);
  py::class_<Curve_handle> curve(module, "Curve");
  bind_values(curve);
  bind_conic(curve);
  bind_spline(curve);
  bind_functions(curve);
}

} // namespace python
