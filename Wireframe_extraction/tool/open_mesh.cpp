#include "open_mesh.h"
#include "Cloud_in_memory.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/IO/internal/mesh/mesh_formats.h>
#include <CGAL/Wireframe_extraction/Sharp_mesh_report.h>
#include <CGAL/Wireframe_extraction/internal/base/different_positions.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_mesh.h>
#include <CGAL/Wireframe_extraction/internal/mesh/report_on_mesh.h>

#include <cstddef>
#include <cstdio>
#include <new>

namespace tool {
namespace {

namespace wireframe = CGAL::Wireframe_extraction;
namespace internal = CGAL::Wireframe_extraction::internal;
using CGAL::IO::internal::plural;

internal::Sharp_mesh_options options_of(const Input& input)
{
  internal::Sharp_mesh_options options;
  options.sampling_distance = input.sampling_distance;
  options.maximum_number_of_points = static_cast<std::size_t>(input.maximum_number_of_points);
  options.minimum_fold = input.minimum_fold;
  options.maximum_facet_fold = input.maximum_facet_fold;
  options.use_boundaries = input.use_boundaries;
  return options;
}

// the vertices of a scanned mesh are a cloud without distances, which are not always welcome
std::string scan_text(const std::string& name)
{
  return name
    + ": the mesh is a scan: its vertices are a cloud without distances; give a cloud with them, have them estimated "
      "(--field), or if the mesh is a shape whose edges are edges of the mesh, --mesh cad";
}

// Takes the vertices of a mesh that is a scan, each once: in STL, every triangle has vertices of its own. Returns what
// is wrong with that.
std::string take_vertices(const Input& input, const internal::Polygon_soup& soup, const std::string& name,
                          Cloud_in_memory& result)
{
  if (input.field_origin == wireframe::Field_origin::GIVEN)
    return scan_text(name);
  for (std::size_t i : internal::different_positions(soup.points))
    result.samples.push_back({soup.points[i].x(), soup.points[i].y(), soup.points[i].z(), 0.});
  result.kind_of_mesh = "scan";
  result.text = "the mesh was taken for a scan (--mesh scan), whose vertices are the points";
  result.are_distances_known = false;
  return std::string();
}

std::string no_sharp_edge_text(const std::string& name, const internal::Sharp_mesh& mesh,
                               const internal::Sharp_mesh_options& options)
{
  char angle[32];
  std::snprintf(angle, sizeof(angle), "%g", options.minimum_fold);
  std::string text = name + ": no edge of the mesh is sharp, that is, folded by " + angle + " degrees (minimum_fold)";
  if (mesh.sharp.number_of_facet_edges > 0)
    text += "; " + plural(mesh.sharp.number_of_facet_edges, "edge is", "edges are")
      + " taken for facets of a curved surface (maximum_facet_fold)";
  if (mesh.sharp.number_of_boundary_edges > 0)
    text += "; " + plural(mesh.sharp.number_of_boundary_edges, "edge", "edges")
      + " of one face only do not count (use_boundaries)";
  return text;
}

std::string note_on(const internal::Sharp_mesh& mesh, const internal::Mesh_samples& samples)
{
  const wireframe::Sharp_mesh_report report = internal::report_on_mesh(mesh);
  char r[32];
  std::snprintf(r, sizeof(r), "%.4g", samples.sampling_distance);
  std::string text =
    "the mesh was taken for a shape (--mesh cad): " + plural(report.number_of_triangles, "triangle", "triangles") + ", "
    + plural(report.number_of_sharp_edges, "sharp edge", "sharp edges") + " in "
    + plural(report.number_of_sharp_curves, "curve", "curves") + ", sampled with r = " + r;
  const auto add = [&text](std::size_t count, const std::string& one, const std::string& many) {
    if (count > 0)
      text += "; " + plural(count, one, many);
  };
  add(report.number_of_degenerate_faces, "triangle without area left out", "triangles without area left out");
  add(report.number_of_duplicate_faces, "triangle that was there twice", "triangles that were there twice");
  add(report.number_of_non_manifold_edges, "edge of more than two faces", "edges of more than two faces");
  add(report.number_of_boundary_edges, "edge of one face only", "edges of one face only");
  return text;
}

} // namespace

std::string why_no_distances(const Input& input)
{
  using CGAL::IO::internal::Mesh_format;
  const std::string& filename = input.files.front();
  const Mesh_format format = CGAL::IO::internal::find_mesh_format(input.extension());
  const bool is_mesh_only = format == Mesh_format::STL || format == Mesh_format::OBJ;
  if (!is_mesh_only || !(input.has_distances || input.names_distances()))
    return std::string();
  return filename + ": a mesh in " + input.extension()
    + " has no distances, and gets none of a file (distance_property, distances_dataset, --distances); write it as "
      ".ply or "
      ".off, whose vertices are the points then, or leave these options out";
}

bool is_mesh(const Input& input)
{
  const auto format = CGAL::IO::internal::find_mesh_format(input.extension());
  return CGAL::IO::internal::look_at_mesh_file(input.files.front(), format).is_mesh;
}

bool is_mesh_to_sample(const Input& input, bool is_once_only)
{
  using CGAL::IO::internal::Mesh_format;
  if (input.are_patches || input.has_distances)
    return false;
  const std::string& filename = input.files.front();
  const Mesh_format format = CGAL::IO::internal::find_mesh_format(input.extension());
  if (input.mesh == Mesh_choice::CAD || format == Mesh_format::STL || format == Mesh_format::OBJ)
    return true;
  if (input.mesh == Mesh_choice::SCAN || is_once_only || format == Mesh_format::UNKNOWN || input.names_distances())
    return false;
  const CGAL::IO::internal::Mesh_file_content content = CGAL::IO::internal::look_at_mesh_file(filename, format);
  return content.is_mesh && !content.has_distances;
}

std::unique_ptr<Input_cloud> cloud_of_mesh(const internal::Polygon_soup& soup, const std::string& name,
                                           const Input& input, std::string& error)
{
  auto result = std::make_unique<Cloud_in_memory>();
  try
  {
    if (input.mesh == Mesh_choice::SCAN)
    {
      error = take_vertices(input, soup, name, *result);
      return result;
    }
    internal::Sharp_mesh mesh;
    const internal::Sharp_mesh_options options = options_of(input);
    error = internal::make_sharp_mesh(soup, options, mesh);
    if (!error.empty())
      error = name + ": " + error;
    else if (input.mesh == Mesh_choice::AUTOMATIC && mesh.kind == wireframe::Mesh_kind::SCAN)
      error = take_vertices(input, soup, name, *result);
    if (!error.empty() || !result->kind_of_mesh.empty())
      return result;
    result->kind_of_mesh = "cad";
    if (mesh.sharp.edges.empty())
    {
      result->text_without_feature = no_sharp_edge_text(name, mesh, options);
      return result;
    }
    const internal::Mesh_samples samples = internal::sample_mesh(mesh, options, input.callback);
    if (samples.points.empty())
      error = name + ": cancelled";
    for (std::size_t i = 0; i < samples.points.size(); ++i)
      result->samples.push_back(
        {samples.points[i].x(), samples.points[i].y(), samples.points[i].z(), samples.distances[i]});
    result->are_distances_known = input.field_origin != wireframe::Field_origin::ESTIMATED;
    result->text = note_on(mesh, samples);
  }
  catch (const std::bad_alloc&)
  {
    error = name + ": there is not enough memory to sample its mesh";
  }
  return result;
}

std::unique_ptr<Input_cloud> open_mesh(const Input& input, std::string& error)
{
  internal::Polygon_soup soup;
  error = CGAL::IO::internal::read_mesh_file(input.files.front(), input.extension(), soup);
  if (!error.empty())
    return std::make_unique<Cloud_in_memory>();
  return cloud_of_mesh(soup, input.files.front(), input, error);
}

} // namespace tool
