// The functions of the module that take a cloud, and run all stages or the first.

#include "Array_cloud.h"
#include "Cloud_maps.h"
#include "Stoppable_cloud.h"
#include "arrays.h"
#include "bindings.h"
#include "input_of.h"
#include "messages.h"
#include "parameters.h"
#include "report_dict.h"
#include "run_beside.h"

#include <Field_scale.h>
#include <open_mesh.h>

#include <CGAL/Wireframe_extraction/estimate_distance_field.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Polygon_soup.h>
#include <CGAL/extract_wireframe.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace python {
namespace {

namespace py = pybind11;
namespace wireframe = CGAL::Wireframe_extraction;
typedef wireframe::Distance_cloud_source Cloud;
typedef py::array_t<std::int64_t, py::array::c_style> Index_array;

// the wireframe of any cloud, without Python's lock; `share_before` of the work is done
Wireframe extract(Cloud& cloud, const Parameters& parameters, Report& report, Work_state& state,
                  double share_before = 0.)
{
  Stoppable_cloud stoppable(cloud, state);
  const std::function<bool(double)> callback = [&state, share_before](double share) {
    return state.proceed(share_before + (1. - share_before) * share);
  };
  return CGAL::extract_wireframe_from_source<Kernel>(stoppable, named_parameters(parameters, report, callback));
}

Number_view view_or_none(const py::object& array)
{
  return array.is_none() ? Number_view() : Number_view(py::array(array));
}

py::tuple extract_arrays(const py::array& points, const py::object& distances, const py::dict& values, int threads,
                         const py::object& progress)
{
  const Parameters parameters = parameters_of(values);
  Array_cloud cloud(Number_view(points), view_or_none(distances), !distances.is_none());
  auto result = std::make_shared<Wireframe>();
  Report report;
  run_beside([&](Work_state& state) { *result = extract(cloud, parameters, report, state); }, threads, progress);
  return py::make_tuple(result, report_dict(report));
}

// takes what the header of a field says, unless it was given, as the tool does
void take_scale(const tool::Field_header& header, Parameters& parameters)
{
  tool::Options options;
  options.sampling_distance = parameters.sampling_distance;
  options.extraction = parameters;
  const tool::Field_scale scale(options, header);
  parameters.sampling_distance = scale.sampling_distance;
  parameters.noise_level = scale.noise_level;
}

// Extracts the wireframe of what `open(input, error)` opens. Returns it, the report, what the reader tells, and why
// there is no feature if that is known from the start.
template <class Open>
py::tuple extract_opened(tool::Input input, const py::dict& values, int threads, const py::object& progress,
                         const Open& open)
{
  static constexpr double share_of_sampling = 0.2; // of a mesh, about
  Parameters parameters = parameters_of(values);
  auto result = std::make_shared<Wireframe>();
  Report report;
  std::string error, note, no_feature;
  run_beside(
    [&](Work_state& state) {
      input.callback = [&state](double share) { return state.proceed(share_of_sampling * share); };
      const std::unique_ptr<tool::Input_cloud> cloud = open(input, error);
      no_feature = cloud->no_feature();
      note = cloud->note();
      if (!error.empty() || !no_feature.empty())
        return;
      take_scale(cloud->field_header(), parameters);
      *result = extract(*cloud, parameters, report, state, cloud->mesh_kind() == "cad" ? share_of_sampling : 0.);
      error = cloud->error_message();
      note = cloud->note();
      report.number_of_skipped_points += cloud->number_of_skipped();
    },
    threads, progress);
  if (!error.empty())
    throw_value_error(error);
  return py::make_tuple(result, report_dict(report), to_text(note), to_text(no_feature));
}

py::tuple extract_file(const py::dict& input_values, const py::dict& values, int threads, const py::object& progress)
{
  return extract_opened(input_of(input_values), values, threads, progress, &tool::open_input);
}

// of a mesh, whose faces have all as many corners
py::tuple extract_mesh(const py::array& points, const Index_array& faces, const py::dict& input_values,
                       const py::dict& values, int threads, const py::object& progress)
{
  const Number_view view{points};
  const std::int64_t* const indices = faces.data();
  const std::size_t number_of_faces = static_cast<std::size_t>(faces.shape(0));
  const std::size_t corners = static_cast<std::size_t>(faces.shape(1));
  const auto open = [&](const tool::Input& input, std::string& error) {
    wireframe::internal::Polygon_soup soup;
    for (std::size_t i = 0; i < view.rows(); ++i)
      soup.points.emplace_back(view(i, 0), view(i, 1), view(i, 2));
    for (std::size_t i = 0; i < number_of_faces; ++i)
      soup.polygons.emplace_back(indices + i * corners, indices + (i + 1) * corners);
    return tool::cloud_of_mesh(soup, "faces", input, error);
  };
  return extract_opened(input_of(input_values), values, threads, progress, open);
}

// points, distances if they are known, what the reader tells, and how many points were left out
py::tuple read_cloud(const py::dict& input_values)
{
  tool::Input input = input_of(input_values);
  std::vector<double> coordinates, distances;
  std::string error, note;
  std::size_t number_of_skipped = 0;
  bool has_distances = false;
  const auto read = [&](Work_state& state) {
    input.callback = [&state](double share) { return state.proceed(share); };
    const std::unique_ptr<tool::Input_cloud> cloud = tool::open_input(input, error);
    if (!error.empty())
      return;
    Stoppable_cloud(*cloud, state).read([&](const Cloud::Sample* sample, const Cloud::Sample* beyond) {
      for (; sample != beyond; ++sample)
      {
        coordinates.insert(coordinates.end(), {sample->x, sample->y, sample->z});
        distances.push_back(sample->distance);
      }
      return true;
    });
    error = cloud->no_feature().empty() ? cloud->error_message() : cloud->no_feature();
    note = cloud->note();
    number_of_skipped = cloud->number_of_skipped();
    has_distances = cloud->has_distances();
  };
  run_beside(read, 0, py::none());
  if (!error.empty())
    throw_value_error(error);
  const py::object known = has_distances ? py::object(to_array(std::move(distances))) : py::none();
  return py::make_tuple(to_rows(std::move(coordinates)), known, to_text(note), number_of_skipped);
}

// distances, deviations, and the report
py::tuple estimate_distances(const py::array& points, const py::dict& values, int threads, const py::object& progress)
{
  const Parameters parameters = parameters_of(values);
  const Point_at map{Number_view(points)};
  wireframe::Distance_field field;
  Report report;
  const auto estimate = [&](Work_state& state) {
    const std::function<bool(double)> callback = [&state](double share) { return state.proceed(share); };
    const auto range = index_range(map.points);
    field = wireframe::estimate_distance_field(range, named_parameters(parameters, report, callback).point_map(map));
  };
  run_beside(estimate, threads, progress);
  return py::make_tuple(to_array(std::move(field.distances)), to_array(std::move(field.deviations)),
                        report_dict(report));
}

} // namespace

void bind_extraction(py::module_& module)
{
  module.def("extract_arrays", &extract_arrays);
  module.def("extract_file", &extract_file);
  module.def("extract_mesh", &extract_mesh);
  module.def("read_cloud", &read_cloud);
  module.def("estimate_distances", &estimate_distances);
}

} // namespace python
