// The meshes that the tool extract_wireframe reads. All that knows about meshes is compiled apart from the rest.

#ifndef EXTRACT_WIREFRAME_OPEN_MESH_H
#define EXTRACT_WIREFRAME_OPEN_MESH_H

#include "open_input.h"

#include <CGAL/Wireframe_extraction/internal/mesh/Polygon_soup.h>

#include <memory>
#include <string>

namespace tool {

// Returns what is wrong if distances are named of a mesh that cannot have any, else nothing.
std::string why_no_distances(const Input& input);

// Whether a file has faces, as far as its beginning tells.
bool is_mesh(const Input& input);

// Whether the input is a mesh whose faces are to be looked at: it is none for its points and distances.
bool is_mesh_to_sample(const Input& input, bool is_once_only);

// Reads a mesh, and makes a cloud of it.
std::unique_ptr<Input_cloud> open_mesh(const Input& input, std::string& error);

// Makes a cloud of a mesh: samples it if it is a shape, or takes its vertices if it is a scan. Messages call it `name`.
std::unique_ptr<Input_cloud> cloud_of_mesh(const CGAL::Wireframe_extraction::internal::Polygon_soup& mesh,
                                           const std::string& name, const Input& input, std::string& error);

} // namespace tool

#endif // EXTRACT_WIREFRAME_OPEN_MESH_H
