// The functions of the module that take a cloud, and run all stages or the first.

#include "Array_cloud.h"
#include "Cloud_maps.h"
#include "Stoppable_cloud.h"
#include "arrays.h"
#include "bindings.h"
#include "input_of.h"
#include "parameters.h"
#include "report_dict.h"
#include "run_beside.h"

#include <Field_scale.h>

#include <CGAL/Wireframe_extraction/Sharp_mesh_report.h>
#include <CGAL/Wireframe_extraction/estimate_distance_field.h>
#include <CGAL/Wireframe_extraction/sample_sharp_mesh.h>
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

// the wireframe of any cloud, without Python's lock
Wireframe extract(Cloud& cloud, const Parameters& parameters, Report& report, Work_state& state)
{
  Stoppable_cloud stoppable(cloud, state);
  const std::function<bool(double)> callback = [&state](double share) { return state.proceed(share); };
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

// the wireframe, the report, what the reader tells, and why there is no feature if that is known from the start
py::tuple extract_file(const py::dict& input_values, const py::dict& values, int threads, const py::object& progress)
{
  Parameters parameters = parameters_of(values);
  const tool::Input input = input_of(input_values);
  auto result = std::make_shared<Wireframe>();
  Report report;
  std::string error, note, no_feature;
  run_beside(
    [&](Work_state& state) {
      const std::unique_ptr<tool::Input_cloud> cloud = tool::open_input(input, error);
      no_feature = cloud->no_feature();
      if (!error.empty() || !no_feature.empty())
        return;
      take_scale(cloud->field_header(), parameters);
      *result = extract(*cloud, parameters, report, state);
      error = cloud->error_message();
      note = cloud->note();
      report.number_of_skipped_points += cloud->number_of_skipped();
    },
    threads, progress);
  if (!error.empty())
    throw py::value_error(error);
  return py::make_tuple(result, report_dict(report), note, no_feature);
}

// points, distances if they are known, what the reader tells, and how many points were left out
py::tuple read_cloud(const py::dict& input_values)
{
  const tool::Input input = input_of(input_values);
  std::vector<double> coordinates, distances;
  std::string error, note;
  std::size_t number_of_skipped = 0;
  bool has_distances = false;
  const auto read = [&](Work_state& state) {
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
    throw py::value_error(error);
  const py::object known = has_distances ? py::object(to_array(std::move(distances))) : py::none();
  return py::make_tuple(to_rows(std::move(coordinates)), known, note, number_of_skipped);
}

// points, distances, and whether the mesh is a scan, which is not sampled
py::tuple sample_mesh(const Double_array& vertices, const py::array_t<std::int64_t, py::array::c_style>& faces,
                      const py::dict& values)
{
  namespace parameters = CGAL::Wireframe_extraction::parameters;
  const tool::Input input = input_of(values);
  const std::vector<Point> points = to_points(vertices);
  std::vector<std::vector<std::size_t>> polygons;
  for (py::ssize_t i = 0; i < faces.shape(0); ++i)
    polygons.emplace_back(faces.data(i), faces.data(i) + faces.shape(1));
  std::vector<std::pair<Point, double>> cloud;
  wireframe::Sharp_mesh_report report;
  std::string error;
  const auto sample = [&](Work_state&) {
    wireframe::sample_sharp_mesh(points, polygons, cloud,
                                 parameters::sampling_distance(input.sampling_distance)
                                   .minimum_fold(input.minimum_fold)
                                   .maximum_facet_fold(input.maximum_facet_fold)
                                   .maximum_number_of_points(input.maximum_number_of_points)
                                   .use_boundaries(input.use_boundaries)
                                   .mesh_report(std::ref(report))
                                   .error_message(&error));
  };
  run_beside(sample, 0, py::none());
  if (report.kind == wireframe::Mesh_kind::SCAN && input.mesh != tool::Mesh_choice::CAD)
    return py::make_tuple(py::none(), py::none(), true);
  if (!error.empty())
    throw py::value_error(error);
  std::vector<double> coordinates, distances;
  for (const auto& point : cloud)
  {
    append(point.first, coordinates);
    distances.push_back(point.second);
  }
  return py::make_tuple(to_rows(std::move(coordinates)), to_array(std::move(distances)), false);
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
  module.def("read_cloud", &read_cloud);
  module.def("sample_mesh", &sample_mesh);
  module.def("estimate_distances", &estimate_distances);
}

} // namespace python
