#include "parameters.h"
#include "bindings.h"

#include <pybind11/stl.h>

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace python {
namespace {

namespace py = pybind11;
namespace wireframe = CGAL::Wireframe_extraction;

template <class Choice>
using Names = std::vector<std::pair<const char*, Choice>>;

// the values of a parameter that is a choice, by the names that they have on the command line
const Names<wireframe::Corner_measure>& names_of(wireframe::Corner_measure)
{
  static const Names<wireframe::Corner_measure> names = {{"field-residual", wireframe::Corner_measure::FIELD_RESIDUAL},
                                                         {"variance", wireframe::Corner_measure::VARIANCE}};
  return names;
}
const Names<wireframe::Graph_method>& names_of(wireframe::Graph_method)
{
  static const Names<wireframe::Graph_method> names = {{"traced", wireframe::Graph_method::TRACED},
                                                       {"subdivided", wireframe::Graph_method::SUBDIVIDED}};
  return names;
}
const Names<wireframe::End_detection>& names_of(wireframe::End_detection)
{
  static const Names<wireframe::End_detection> names = {{"graph-distance", wireframe::End_detection::GRAPH_DISTANCE},
                                                        {"main-axis", wireframe::End_detection::MAIN_AXIS}};
  return names;
}

// the one list of names: calls `use(name, value)` for each parameter
template <class P, class Use>
void for_each(P& p, const Use& use)
{
  use("sampling_distance", p.sampling_distance);
  use("points_in_memory", p.points_in_memory);
  use("skip_invalid", p.skip_invalid);
  use("minimum_fold", p.minimum_fold);
  use("noise_level", p.noise_level);
  use("skeleton_distance", p.skeleton_distance);
  use("support_distance", p.support_distance);
  use("fitting_radius", p.fitting_radius);
  use("use_creases", p.use_creases);
  use("corner_measure", p.corner_measure);
  use("corner_sampling_ratio", p.corner_sampling_ratio);
  use("corner_radius", p.corner_radius);
  use("corner_variance", p.corner_variance);
  use("corner_residual", p.corner_residual);
  use("connection_radius", p.connection_radius);
  use("connection_angle", p.connection_angle);
  use("use_tangents", p.use_tangents);
  use("graph_method", p.graph_method);
  use("end_detection", p.end_detection);
  use("split_threshold", p.split_threshold);
  use("corner_reach", p.corner_reach);
  use("maximum_gap", p.maximum_gap);
  use("smooth_angle", p.smooth_angle);
  use("minimum_evidence", p.minimum_evidence);
  use("use_robust_loss", p.use_robust_loss);
  use("move_corners", p.move_corners);
  use("adapt_knots", p.adapt_knots);
  use("number_of_rounds", p.number_of_rounds);
  use("recognize_types", p.recognize_types);
  use("type_significance", p.type_significance);
  use("regularize", p.regularize);
}

// reads the value of one parameter, if it is there
class Reader
{
public:
  explicit Reader(const py::dict& values) : m_values(values) {}

  template <class Value>
  void operator()(const char* name, Value& value) const
  {
    if (!m_values.contains(name))
      return;
    if constexpr (std::is_enum<Value>::value)
      value = choice_of(name, m_values[name].template cast<std::string>(), value);
    else
      value = m_values[name].template cast<Value>();
  }

private:
  template <class Choice>
  static Choice choice_of(const char* name, const std::string& text, Choice value)
  {
    for (const auto& [known, choice] : names_of(value))
      if (text == known)
        return choice;
    throw py::value_error(std::string(name) + " cannot be \"" + text + "\"");
  }

  const py::dict& m_values;
};

} // namespace

Parameters parameters_of(const py::dict& values)
{
  Parameters parameters;
  for_each(parameters, Reader(values));
  return parameters;
}

py::dict to_dict(const Parameters& parameters)
{
  py::dict values;
  for_each(parameters, [&](const char* name, const auto& value) {
    if constexpr (std::is_enum<typename std::decay<decltype(value)>::type>::value)
    {
      for (const auto& [known, choice] : names_of(value))
        if (value == choice)
          values[name] = known;
    }
    else
      values[name] = value;
  });
  return values;
}

py::dict choices()
{
  py::dict result;
  const Parameters defaults;
  for_each(defaults, [&](const char* name, const auto& value) {
    if constexpr (std::is_enum<typename std::decay<decltype(value)>::type>::value)
    {
      py::list names;
      for (const auto& known : names_of(value))
        names.append(known.first);
      result[name] = names;
    }
  });
  return result;
}

Parameters paper_parameters()
{
  Parameters parameters;
  static_cast<wireframe::internal::Extraction_options&>(parameters) =
    wireframe::internal::given_options(wireframe::parameters::paper_defaults());
  return parameters;
}

void bind_parameters(py::module_& module)
{
  module.def("default_parameters", [] { return to_dict(Parameters()); });
  module.def("paper_parameters", [] { return to_dict(paper_parameters()); });
  module.def("choices", &choices);
}

} // namespace python
