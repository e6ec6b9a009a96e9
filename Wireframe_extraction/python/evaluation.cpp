// The function of the module that compares two wireframes.

#include "bindings.h"
#include "messages.h"

#include <Wireframe_evaluation/chain_curves.h>
#include <Wireframe_evaluation/evaluate_wireframe.h>
#include <Wireframe_evaluation/read_truth.h>
#include <Wireframe_evaluation/score_columns.h>

#include <cstddef>
#include <string>

namespace python {
namespace {

namespace py = pybind11;
namespace evaluation = Wireframe_evaluation;

// A wireframe as the true one: its curves are chained as those of the truth are.
evaluation::True_wireframe to_truth(const std::string& json)
{
  const auto document = evaluation::internal::Json::parse(json);
  evaluation::True_wireframe truth;
  truth.sampling_distance = document["sampling_distance"].get<double>();
  const double r = truth.sampling_distance;
  const evaluation::Predicted_wireframe wireframe = evaluation::internal::Prediction_reader(0.05 * r).read(document);
  const evaluation::Chained_curves chained = evaluation::chain_curves(wireframe.curves, 0.5 * r, 20.);
  truth.curves = chained.curves;
  truth.segments = wireframe.curves;
  for (const std::size_t vertex : chained.vertices)
    truth.corners.push_back(wireframe.vertices[vertex]);
  return truth;
}

evaluation::Wireframe_scores scores_of(const evaluation::True_wireframe& truth, const std::string& json)
{
  const auto document = evaluation::internal::Json::parse(json);
  const double step = 0.05 * truth.sampling_distance;
  return evaluation::evaluate_wireframe(truth, evaluation::internal::Prediction_reader(step).read(document));
}

py::dict to_dict(const evaluation::Wireframe_scores& scores)
{
  py::dict result;
  result["failure"] = scores.failure.empty() ? py::object(py::none()) : py::object(py::str(scores.failure));
  result["sampling_distance"] = scores.sampling_distance;
  result["diagonal"] = scores.diagonal;
  for (const evaluation::Score_column& column : evaluation::score_columns())
    if (column.unit == evaluation::Score_unit::COUNT)
      result[column.name] = static_cast<long long>(column.get(scores));
    else
      result[column.name] = column.get(scores);
  return result;
}

// `truth` is the name of a file that make_cloud and others write, or a wireframe in JSON.
py::dict evaluate(const std::string& truth, bool is_truth_json, const std::string& json)
{
  evaluation::Wireframe_scores scores;
  try
  {
    const py::gil_scoped_release release;
    scores = scores_of(is_truth_json ? to_truth(truth) : evaluation::read_truth(truth), json);
  }
  catch (const evaluation::Format_error& error)
  {
    throw_value_error(is_truth_json ? error.what() : truth + ": " + error.what());
  }
  return to_dict(scores);
}

} // namespace

void bind_evaluation(py::module_& module) { module.def("evaluate", &evaluate); }

} // namespace python
