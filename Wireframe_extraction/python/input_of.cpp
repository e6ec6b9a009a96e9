#include "input_of.h"

#include <CGAL/Wireframe_extraction/policies.h>

#include <pybind11/stl.h>

#include <string>

namespace python {
namespace {

namespace py = pybind11;
namespace wireframe = CGAL::Wireframe_extraction;

template <class Value>
void read(const py::dict& values, const char* name, Value& value)
{
  if (values.contains(name))
    value = values[name].template cast<Value>();
}

std::string text(const py::dict& values, const char* name)
{
  std::string value;
  read(values, name, value);
  return value;
}

} // namespace

tool::Input input_of(const py::dict& values)
{
  tool::Input input;
  read(values, "files", input.files);
  read(values, "distances", input.distances);
  input.has_distances = values.contains("distances");
  read(values, "patches", input.are_patches);
  read(values, "input_format", input.format);
  read(values, "coordinate_properties", input.coordinate_properties);
  read(values, "distance_property", input.distance_property);
  read(values, "points_dataset", input.points_dataset);
  read(values, "distances_dataset", input.distances_dataset);
  read(values, "indices_dataset", input.indices_dataset);
  read(values, "use_indices", input.use_indices);
  read(values, "skip_invalid", input.skip_invalid);
  read(values, "clamp_negative", input.clamp_negative);
  read(values, "sampling_distance", input.sampling_distance);
  read(values, "minimum_fold", input.minimum_fold);
  read(values, "maximum_facet_fold", input.maximum_facet_fold);
  read(values, "maximum_number_of_points", input.maximum_number_of_points);
  read(values, "use_boundaries", input.use_boundaries);
  if (text(values, "fusion") == "median")
    input.fusion = wireframe::Patch_fusion::MEDIAN;
  const std::string field = text(values, "field"), mesh = text(values, "mesh");
  if (field == "given" || field == "estimated")
    input.field_origin = field == "given" ? wireframe::Field_origin::GIVEN : wireframe::Field_origin::ESTIMATED;
  if (mesh == "cad" || mesh == "scan")
    input.mesh = mesh == "cad" ? tool::Mesh_choice::CAD : tool::Mesh_choice::SCAN;
  return input;
}

} // namespace python
