// Which options of the tool extract_wireframe have no effect without others.

#ifndef EXTRACT_WIREFRAME_CHECK_EFFECTS_H
#define EXTRACT_WIREFRAME_CHECK_EFFECTS_H

#include "Options.h"

#include <CGAL/Wireframe_extraction/IO/internal/file/file_tools.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace tool {

// What is off anyway may be switched off everywhere.
inline void require(const CLI::App& app, const std::string& name, bool is_fulfilled, const std::string& what)
{
  const CLI::Option* const option = app.get_option(name);
  if (option->count() == 0 || is_fulfilled)
    return;
  if (option->get_default_str() != "false" || option->results().back() != "false")
    throw CLI::RequiresError(name, what);
}

// whether the wireframe is written into a file with one of these extensions
inline bool writes(const Options& options, const std::vector<std::string>& extensions)
{
  std::vector<std::string> names = options.outputs;
  for (const std::string& format : options.batch.formats)
    names.push_back("OUT." + format);
  if (!options.output_format.empty())
    names.push_back("OUT." + options.output_format);
  return std::any_of(names.begin(), names.end(), [&extensions](const std::string& name) {
    const std::string extension = CGAL::IO::internal::lower_extension(name);
    return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
  });
}

// whether what is read can be a mesh whose faces are looked at
inline bool may_be_mesh(const Options& options)
{
  if (options.has_batch)
    return true;
  if (options.input.are_patches || options.input.has_distances || options.input.files.empty())
    return false;
  const std::string extension = options.input.extension();
  return extension == ".stl" || extension == ".obj" || extension == ".off" || extension == ".ply";
}

inline void check_effects_on_outputs(const CLI::App& app, const Options& options)
{
  require(app, "--view", options.has_png || writes(options, {".png"}), "--png");
  require(app, "--output-format", std::count(options.outputs.begin(), options.outputs.end(), "-") > 0, "-o -");
  require(app, "--step-schema", writes(options, {".step", ".stp"}), "an output .step or .stp");
  require(app, "--obj-splines", writes(options, {".obj"}), "an output .obj");
  require(app, "--dxf-splines", writes(options, {".dxf"}), "an output .dxf");
  require(app, "--dimensions", writes(options, {".svg"}), "an output .svg");
  const bool is_sampled = writes(options, {".ply", ".vtp", ".gltf", ".glb", ".txt", ".cgal"})
    || (writes(options, {".obj"}) && !options.has_obj_splines);
  for (const char* const name : {"--sampling-step", "--chord-tolerance"})
    require(app, name, is_sampled, "an output of sampled curves: .obj .ply .vtp .gltf .glb .polylines.txt .txt .cgal");
}

inline void check_effects_on_curves(const CLI::App& app, const Extraction_options& extraction)
{
  namespace wireframe = CGAL::Wireframe_extraction;
  const bool is_variance = extraction.corner_measure == wireframe::Corner_measure::VARIANCE;
  const bool is_traced = extraction.graph_method == wireframe::Graph_method::TRACED;
  for (const char* const name : {"--corner-variance", "--corner-radius", "--corner-sampling-ratio"})
    require(app, name, is_variance, "--corner-measure variance");
  require(app, "--corner-residual", !is_variance, "--corner-measure field-residual");
  for (const char* const name : {"--end-detection", "--split-threshold"})
    require(app, name, !is_traced, "--graph-method subdivided");
  for (const char* const name : {"--maximum-gap", "--minimum-evidence"})
    require(app, name, is_traced, "--graph-method traced");
  for (const char* const name : {"--regularize", "--type-significance"})
    require(app, name, extraction.recognize_types, "--recognize-types true (and no --splines-only)");
}

// Whoever gives an option expects an effect, so that one that has none here is refused.
inline void check_effects(const CLI::App& app, const Options& options)
{
  for (const char* const name : {"--fuse", "--indices-dataset", "--use-indices"})
    require(app, name, options.input.are_patches, "--patches");
  const bool has_mesh = may_be_mesh(options) && options.input.mesh != Mesh_choice::SCAN;
  const bool is_given = options.input.field_origin == CGAL::Wireframe_extraction::Field_origin::GIVEN
    || options.input.has_distances || options.input.are_patches;
  for (const char* const name : {"--mesh", "--maximum-facet-fold", "--use-boundaries", "--maximum-number-of-points"})
    require(app, name, may_be_mesh(options), "a mesh without --distances: .stl, .obj, .off or .ply");
  for (const char* const name : {"--maximum-facet-fold", "--use-boundaries", "--maximum-number-of-points"})
    require(app, name, has_mesh, "a mesh that is no --mesh scan");
  require(app, "--minimum-fold", has_mesh || !is_given, "a mesh, or a CLOUD whose distances are estimated (--field)");
  require(app, "--write-field", !is_given, "a CLOUD whose distances are estimated (--field)");
  check_effects_on_outputs(app, options);
  check_effects_on_curves(app, options.extraction);
}

} // namespace tool

#endif // EXTRACT_WIREFRAME_CHECK_EFFECTS_H
