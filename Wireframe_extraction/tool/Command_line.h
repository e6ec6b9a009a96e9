// The command line of the tool extract_wireframe: all of its options, with names, help and bounds. They fill Options.h.

#ifndef EXTRACT_WIREFRAME_COMMAND_LINE_H
#define EXTRACT_WIREFRAME_COMMAND_LINE_H

#include "Option_parser.h"
#include "Options.h"
#include "built_in.h"
#include "check_effects.h"
#include "completion.h"

#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tool {

class Command_line : public Option_parser
{
public:
  explicit Command_line(Options& options)
    : Option_parser("Extracts a parametric wireframe from a point cloud, with or without distances, or from a mesh.",
                    "extract_wireframe"),
      m_options(options)
  {
    m_app.set_help_flag(); // for now, so that the files come first
    add_files();
    add_input();
    add_mesh();
    add_batch();
    add_run();
    add_skeleton();
    add_corners();
    add_curves();
    add_graph();
    add_fit();
    add_types();
    m_app.footer("Exit codes: 0 success, 1 internal error (or a full disk), 2 wrong usage, 3 bad input,\n"
                 "4 no sharp feature found; of a batch also 5 some clouds failed, 6 another batch is at work there,\n"
                 "128 and more ended by a signal. On failure no OUT is left behind or overwritten.\n\n"
                 "Examples: extract_wireframe part.ply -o part.json -o part.obj\n"
                 "          extract_wireframe --batch clouds.txt --output-dir wireframes --format json --format step");
  }

  // whether it is said what the coordinates are in
  bool is_unit_given() const { return m_app.count("--unit") > 0; }

  // the script with which a shell completes the command line
  std::string completion_script() const
  {
    return m_options.completion == Completion::BASH ? bash_completion(m_app) : zsh_completion(m_app);
  }

  // throws CLI::ParseError, also when the help or the version is asked for
  void parse(int argc, char** argv)
  {
    const std::vector<std::string> words = words_of(argc, argv);
    m_app.parse(std::vector<std::string>(words));
    if (m_options.is_paper)
    {
      // once more, so that what was given counts on top of the published behaviour
      namespace wireframe = CGAL::Wireframe_extraction;
      m_options.extraction = wireframe::internal::extraction_options(wireframe::parameters::paper_defaults());
      m_app.parse(std::vector<std::string>(words));
    }
    if (m_app.count("--splines-only") > 0)
      m_options.extraction.recognize_types = !m_has_splines_only;
    m_options.has_configuration = m_app.count("--write-config") > 0;
    m_options.has_batch = m_app.count("--batch") > 0;
    if (m_options.has_batch)
      complete_batch();
    else
      check_files_are_given();
    take_standard_streams();
    m_options.input.has_distances = m_app.count("--distances") > 0;
    m_options.input.sampling_distance = m_options.sampling_distance;
    check_clouds();
    m_options.has_stages = m_app.count("--stages") > 0;
    m_options.has_html = m_app.count("--html") > 0;
    m_options.has_png = m_app.count("--png") > 0;
    m_options.has_field = m_app.count("--write-field") > 0;
    m_options.has_shared_features = m_app.count("--shared-features") > 0;
    check_effects(m_app, m_options);
  }

private:
  void add_files()
  {
    const std::string group = "Files";
    m_app
      .add_option(
        "CLOUD", m_options.input.files,
        std::string(
          "The points, and their distances if there are any: .ply .pcd .npy .npz .h5 .hdf5, or a text of three "
          "columns, or four with the distances: .xyz .txt .csv .asc .pts. Or a mesh: .stl .obj .off .ply. With "
          "--patches, as many clouds as there are")
          + note_if_missing(Part::HDF5, ".h5 .hdf5") + note_if_missing(Part::ZLIB, "compressed .npz"))
      ->type_name(" ");
    m_app
      .add_option("-o,--output", m_options.outputs,
                  std::string("Where the wireframe goes, as often as needed; the extension gives the format: .json "
                              "(all of it), .step .stp .iges .igs .brep .dxf (its curves), .obj .ply .vtp .gltf .glb "
                              ".polylines.txt .txt .cgal (sampled curves), .svg (a drawing), or .csv (a table)")
                    + note_if_missing(Part::CAD, ".step .stp .iges .igs .brep"))
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("OUT")
      ->group(group);
    m_app
      .add_option("--html", m_options.html,
                  std::string("Write a page that shows the cloud, the stages and the curves in a browser, in one file "
                              "that needs nothing else")
                    + note_if_missing(Part::PAGE, "--html"))
      ->type_name("OUT.html")
      ->group(group);
    m_app
      .add_option("--png", m_options.png,
                  std::string("Write a picture of the cloud, the curves and the vertices; it takes no display")
                    + note_if_missing(Part::PNG, "--png"))
      ->type_name("OUT.png")
      ->group(group);
    m_app
      .add_option("--write-field", m_options.field,
                  "Write the points with the distances that were estimated, and with their standard deviations, for "
                  "MeshLab, CloudCompare, or to go on from there")
      ->type_name("OUT.ply")
      ->group(group);
    m_app
      .add_option(
        "--shared-features", m_options.shared_features,
        "Write a table of what circles and arcs have in common: equal diameters, a common axis, bolt circles; "
        "with --regularize, they are made so before")
      ->type_name("OUT.csv")
      ->group(group);
    m_app
      .add_option(
        "--output-format", m_options.output_format,
        "The format of -o -, the standard output, as the extension that stands for it; the summary goes to the "
        "standard error then")
      ->type_name("EXTENSION")
      ->group(group);
    add_choice("--view", m_options.view,
               {{"isometric", View::ISOMETRIC}, {"front", View::FRONT}, {"right", View::RIGHT}, {"top", View::TOP}},
               "From where the picture of --png is taken, as in .svg", group);
    add_choice("--unit", m_options.unit,
               {{"um", Length_unit::MICROMETER},
                {"mm", Length_unit::MILLIMETER},
                {"cm", Length_unit::CENTIMETER},
                {"m", Length_unit::METER},
                {"in", Length_unit::INCH},
                {"ft", Length_unit::FOOT}},
               "What the coordinates of CLOUD are in, for formats that say so; nothing is converted", group);
    add_choice("--step-schema", m_options.step_schema, {{"ap214", Step_schema::AP214}, {"ap242", Step_schema::AP242}},
               "The application protocol of .step and .stp", group);
    add_boolean("--obj-splines", m_options.has_obj_splines,
                "Write curves into .obj as free-form curves instead of polylines; not every program reads these",
                group);
    add_boolean("--dxf-splines", m_options.has_dxf_splines,
                "Write circles, ellipses and their arcs that are tilted against the xy plane into .dxf as splines, for "
                "programs that flatten them or put them elsewhere",
                group);
    add_boolean("--dimensions", m_options.has_dimensions,
                "Write the radii of arcs and the diameters of circles into .svg", group);
    add_number("--sampling-step", m_options.sampling_step, 0., infinity, false,
               "How long the pieces of sampled curves may be, in the unit of CLOUD; otherwise 0.25 r", group, false);
    add_number("--chord-tolerance", m_options.chord_tolerance, 0., infinity, false,
               "How far sampled curves may be from their pieces, in the unit of CLOUD; a line is one piece then", group,
               false);
    m_app
      .add_option("--stages", m_options.stages_folder,
                  "Write the result of each stage into this folder (made if missing), as coloured PLY "
                  "files 1_skeleton.ply to 6_curves.ply for MeshLab or CloudCompare, and 0_field.ply if the field is "
                  "estimated; those of an earlier run are replaced. They stay if a later stage fails")
      ->type_name("DIR")
      ->group(group);
  }

  void add_input()
  {
    const std::string group = "Input";
    namespace wireframe = CGAL::Wireframe_extraction;
    add_choice("--field,--field-origin", m_options.input.field_origin,
               {{"given", wireframe::Field_origin::GIVEN},
                {"estimated", wireframe::Field_origin::ESTIMATED},
                {"auto", wireframe::Field_origin::AUTOMATIC}},
               "Where the distances come from: they are in CLOUD (or --distances), and it is an error if they are not; "
               "they are estimated from the points, whatever is in CLOUD; or they are estimated if there are none",
               group);
    m_app
      .add_option("--input-format", m_options.input.format,
                  "The format of CLOUD, as the extension that stands for it, if the name of the file has another one; "
                  "it is needed where CLOUD is -, the standard input")
      ->type_name("EXTENSION")
      ->group(group);
    CLI::Option* const distances =
      m_app
        .add_option(
          "--distances", m_options.input.distances,
          "A file with the distances, if they are not in CLOUD: text with one per line, or .npy .npz .h5 .hdf5")
        ->type_name("FILE")
        ->group(group);
    add_coordinates(group);
    m_app
      .add_option("--distance-property", m_options.input.distance_property,
                  "The property or column of CLOUD that holds the distances, or of a text without names the number "
                  "of the column; otherwise the first that is there of distance, distances, sharpness, "
                  "scalar_distance, quality")
      ->type_name("NAME")
      ->excludes(distances)
      ->group(group);
    m_app
      .add_option("--points-dataset", m_options.input.points_dataset,
                  "The data set of HDF5, or array of .npz, that holds the points; otherwise points")
      ->type_name("NAME")
      ->group(group);
    m_app
      .add_option("--distances-dataset", m_options.input.distances_dataset,
                  "The same for the distances; otherwise as for --distance-property")
      ->type_name("NAME")
      ->group(group);
    add_boolean("--patches", m_options.input.are_patches,
                "CLOUD is a file with overlapping patches of a cloud, or several ones: a point in several "
                "patches, each with a distance of its own, becomes one",
                group);
    add_choice("--fuse", m_options.input.fusion,
               {{"minimum", CGAL::Wireframe_extraction::Patch_fusion::MINIMUM},
                {"median", CGAL::Wireframe_extraction::Patch_fusion::MEDIAN}},
               "What becomes of the distances of a point in several patches", group);
    m_app
      .add_option("--indices-dataset", m_options.input.indices_dataset,
                  "The data set or array that says where the points of patches are in the cloud; otherwise the "
                  "first that is there of indices, indexes_in_whole")
      ->type_name("NAME")
      ->group(group);
    add_boolean("--use-indices", m_options.input.use_indices,
                "Whether points of patches are the same by their indices, if there are any, or else by their "
                "positions",
                group);
    add_boolean("--skip-invalid", m_options.input.skip_invalid,
                "Leave out points with a number that is not finite, or a negative distance", group);
    add_boolean("--clamp-negative", m_options.input.clamp_negative,
                "Let negative distances count as zero, as regressors predict them; those of more than a tenth of the "
                "largest distance are an error",
                group);
  }

  void add_coordinates(const std::string& group)
  {
    const auto names_of = [](const std::string& text) {
      std::vector<std::string_view> names;
      CGAL::IO::internal::split_at(',', text, names);
      return std::vector<std::string>(names.begin(), names.end());
    };
    const auto check = [names_of](const std::string& text) {
      const std::vector<std::string> names = names_of(text);
      const std::set<std::string> different(names.begin(), names.end());
      return names.size() == 3 && different.size() == 3 && different.count("") == 0
        ? std::string()
        : "\"" + text + "\" is not three names, such as u,v,w";
    };
    m_app
      .add_option_function<std::string>(
        "--coordinates,--coordinate-properties",
        [this, names_of](const std::string& text) { m_options.input.coordinate_properties = names_of(text); },
        "The properties or columns of CLOUD that hold the coordinates, or of columns without names their numbers, "
        "counted from 1; otherwise x,y,z or Points:0,Points:1,Points:2, or the first three")
      ->check(CLI::Validator(check, ""))
      ->type_name("X,Y,Z")
      ->group(group);
  }

  void add_mesh()
  {
    const std::string group = "Meshes";
    Input& input = m_options.input;
    add_choice("--mesh", input.mesh,
               {{"auto", Mesh_choice::AUTOMATIC}, {"cad", Mesh_choice::CAD}, {"scan", Mesh_choice::SCAN}},
               "What a mesh is taken for: a shape, whose surface is sampled and whose sharp edges give the distances, "
               "or a scan, whose vertices are the points; otherwise its edges tell, and distances that its vertices "
               "have count",
               group);
    add_number("--minimum-fold", input.minimum_fold, 0., 180., false,
               "The angle between two faces from which on their edge is sharp; and where distances are estimated, the "
               "least angle by which the surface is folded at a sharp feature, in degrees",
               group);
    add_number("--maximum-facet-fold", input.maximum_facet_fold, 0., 180., true,
               "Up to which angle regular folds are the facets of a curved surface, in degrees", group);
    add_boolean("--use-boundaries", input.use_boundaries, "Whether edges of one face only are sharp", group);
    add_checked("--maximum-number-of-points", input.maximum_number_of_points, 100, 50000000,
                "About how many points a mesh is sampled by at most, if --sampling-distance is not given", group)
      ->capture_default_str();
  }

  void add_batch()
  {
    const std::string group = "Many clouds";
    Batch_options& batch = m_options.batch;
    CLI::Option* const list =
      m_app
        .add_option(
          "--batch", batch.list,
          "Instead of CLOUD: a text that names one cloud per line (- is the standard input), relative to "
          "its own folder; empty lines and lines that start with # do not count. Every cloud gets a process of "
          "its own, so that whatever happens to one, the others go on")
        ->type_name("LIST")
        ->group(group);
    const auto add = [&](const char* name, auto& value, const char* type, const char* description) {
      return m_app.add_option(name, value, description)->type_name(type)->needs(list)->group(group);
    };
    add("--output-dir", batch.output_folder, "DIR",
        "Instead of OUT: the folder (made if missing) that gets the wireframe of a/b.ply as a/b.json. What is finished "
        "there is skipped, unless the cloud or the options have changed");
    add(
      "--format", batch.formats, "EXTENSION",
      "What is written, as often as needed: the extension of an OUT, also html and png, which are shown by index.html "
      "in the output folder; json if not given")
      ->take_all()
      ->allow_extra_args(false);
    add("--input-dir", batch.input_folder, "DIR",
        "Where relative names in LIST start, and paths in the output folder; otherwise the folder of LIST, or for - "
        "the current one");
    add("--summary", batch.summary, "FILE",
        "The table with a row per cloud, as CSV; otherwise summary.csv in the output folder");
    add_checked("--jobs", batch.number_of_jobs, 1, 1024,
                "How many clouds at once; otherwise as many as there are processors. --threads counts for each of "
                "them, and is such that they share the processors unless given",
                group)
      ->needs(list);
    add_number("--timeout", batch.time_limit, 0., 1e8, false, "A cloud that takes longer fails, in seconds", group,
               false)
      ->needs(list);
    add_checked("--memory-limit", batch.memory_limit, 1, 99999999, "A cloud that needs more fails, in megabytes", group)
      ->needs(list);
    add_boolean("--keep-failed", batch.are_failed_kept,
                "Do not try again what failed before with the same cloud and options", group)
      ->needs(list);
    add("--part", batch.part, "K/N",
        "Only the K-th of N parts of LIST, for jobs of a cluster, which may run at the same time with one output "
        "folder; the summary is summary-K-of-N.csv then");
  }

  // - is the standard input or output
  void take_standard_streams()
  {
    std::vector<std::string>& files = m_options.input.files;
    if (std::count(files.begin(), files.end(), "-") > 0 && m_options.input.format.empty())
      throw CLI::RequiresError("CLOUD -", "--input-format, such as --input-format ply");
    std::replace(files.begin(), files.end(), std::string("-"), std::string("/dev/stdin"));
    const auto& outputs = m_options.outputs;
    if (std::count(outputs.begin(), outputs.end(), "-") > 0 && m_options.output_format.empty())
      throw CLI::RequiresError("--output -", "--output-format, such as --output-format json");
    std::string& format = m_options.output_format;
    format.erase(0, format.find_first_not_of('.')); // .json is as good as json
  }

  void check_clouds() const
  {
    const Input& input = m_options.input;
    for (const std::string& file : input.files)
      for (const char* const value : {"true", "false"})
        if (CGAL::IO::internal::to_lower(file) == value)
          throw CLI::ValidationError("CLOUD",
                                     "\"" + file
                                       + "\" is no cloud; true and false stand right behind their "
                                         "option, as in --quiet true");
    if (input.files.size() > 1 && !input.are_patches)
      throw CLI::ExtrasError("extract_wireframe", {input.files[1] + " (several clouds are read as --patches of one)"});
    for (const char* const name : {"--distance-property", "--distances-dataset"})
      if (input.mesh == Mesh_choice::CAD && m_app.count(name) > 0)
        throw CLI::ExcludesError("--mesh cad", name);
    const bool is_estimated = input.field_origin == CGAL::Wireframe_extraction::Field_origin::ESTIMATED;
    for (const char* const name : {"--distances", "--distance-property", "--distances-dataset", "--patches"})
      if (is_estimated && (name == std::string("--patches") ? input.are_patches : m_app.count(name) > 0))
        throw CLI::ExcludesError("--field estimated", name);
    if (input.are_patches && input.has_distances)
      throw CLI::ExcludesError("--patches", "--distances");
  }

  void check_files_are_given() const
  {
    if (m_options.completion != Completion::NONE)
      return;
    bool has_output = false;
    for (const char* const name : {"--output", "--html", "--png", "--write-field", "--shared-features"})
      has_output = has_output || m_app.count(name) > 0;
    // a file of options may be all that is wanted
    if (m_app.count("CLOUD") == 0 && (has_output || !m_options.has_configuration))
      throw CLI::RequiredError("CLOUD");
    if (!has_output && !m_options.has_configuration)
      throw CLI::RequiredError("--output (or --html, --png, --write-field or --shared-features)");
  }

  void complete_batch()
  {
    for (const char* const name : {"CLOUD", "--output", "--html", "--png", "--write-field", "--shared-features",
                                   "--stages", "--distances", "--input-format", "--output-format"})
      if (m_app.count(name) > 0)
        throw CLI::ExcludesError("--batch", name);
    if (m_options.batch.output_folder.empty())
      throw CLI::RequiredError("--batch: --output-dir");
    complete_formats(m_options.batch.formats);
    m_options.batch.is_quiet = m_options.is_quiet;
    m_options.batch.settings = settings();
  }

  static void complete_formats(std::vector<std::string>& formats)
  {
    if (formats.empty())
      formats = {"json"};
    for (std::string& format : formats)
      format.erase(0, format.find_first_not_of('.')); // .json is as good as json
    for (std::size_t i = 0; i < formats.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (formats[i] == formats[j])
          throw CLI::ValidationError("--format: " + formats[i] + " is given twice");
  }

  // what was given and differs from the defaults, as it decides on the results; the version says
  // which defaults these are
  std::string settings() const
  {
    std::string text = "version " WIREFRAME_EXTRACTION_VERSION_STRING;
    for (const CLI::Option* const option : m_app.get_options())
    {
      const bool is_of_run = option->get_group() == "Many clouds" || option->get_group() == "Run";
      if (option->count() == 0 || (is_of_run && option->get_name() != "--paper"))
        continue;
      std::string value;
      for (const std::string& word : option->results())
        value += " " + word;
      if (value != " " + option->get_default_str())
        text += " " + option->get_name() + value;
    }
    return text;
  }

  void add_run()
  {
    const std::string group = "Run";
    add_boolean("--paper", m_options.is_paper,
                "Start from the behaviour published in arXiv 2107.06165 instead of the defaults shown "
                "here; other options count on top of it. All curves are splines then, unless "
                "--recognize-types is given",
                group);
    add_checked("--threads", m_options.number_of_threads, 1, 1024,
                "Use at most this many threads" + note_if_missing(Part::THREADS, "more than one"), group)
      ->type_name("N");
    add_checked(
      "--points-in-memory", m_options.points_in_memory, 1, 99999999,
      "A larger CLOUD stays in its file, which is then read up to five times, and only what lies near features is "
      "kept; the result is the same. Where distances are estimated, all points are in memory",
      group)
      ->capture_default_str();
    add_boolean("--quiet", m_options.is_quiet, "Print nothing but errors", group);
    m_app.set_help_flag("-h,--help", "Print this help")->group(group);
    add_configuration(group);
    m_app.set_version_flag("-V,--version", version_text(), "Print the version, and what is built in")->group(group);
  }

  void add_configuration(const std::string& group)
  {
    m_app.allow_config_extras(CLI::config_extras_mode::error);
    m_app
      .set_config("--config", "",
                  "Take options from FILE, one per line as in: regularize = true. The command line counts more")
      ->type_name("FILE")
      ->group(group);
    m_app
      .add_option("--write-config", m_options.configuration,
                  "Write the options that are given, and as comments all others with their defaults, for --config")
      ->type_name("OUT")
      ->configurable(false)
      ->group(group);
    add_choice("--completion", m_options.completion,
               {{"none", Completion::NONE}, {"bash", Completion::BASH}, {"zsh", Completion::ZSH}},
               "Print the script with which a shell completes options: source <(extract_wireframe --completion bash)",
               group)
      ->configurable(false);
  }

  void add_skeleton()
  {
    const std::string group = "Scale and skeleton (r is the sampling distance)";
    Extraction_options& extraction = m_options.extraction;
    add_number("--sampling-distance", m_options.sampling_distance, 0., infinity, false,
               "The sampling distance r, in the cloud's unit; estimated if not given", group, false);
    add_number("--noise-level", extraction.noise_level, 0., 1., true,
               "Noise of the distances, in r; estimated if not given", group, false);
    add_number("--skeleton-distance", extraction.skeleton_distance, 0., infinity, false,
               "Points with a smaller distance form the skeleton, in r", group);
    add_number("--support-distance", extraction.support_distance, 0., infinity, false,
               "Points with a smaller distance support the fits, in r", group);
    add_number("--fitting-radius", extraction.fitting_radius, 0., infinity, false,
               "Radius of the balls in which curves are fitted to the field, in r", group);
    add_boolean("--use-creases", extraction.use_creases, "Whether creases of the surface correct the field", group);
  }

  void add_corners()
  {
    namespace wireframe = CGAL::Wireframe_extraction;
    const std::string group = "Corners";
    Extraction_options& extraction = m_options.extraction;
    add_choice("--corner-measure", extraction.corner_measure,
               {{"field-residual", wireframe::Corner_measure::FIELD_RESIDUAL},
                {"variance", wireframe::Corner_measure::VARIANCE}},
               "What tells a corner: the residual of a fit to the field, or the variance of the points", group);
    add_number("--corner-sampling-ratio", extraction.corner_sampling_ratio, 0., 1., false,
               "Share of the skeleton at which corners are looked for", group);
    add_number("--corner-radius", extraction.corner_radius, 0., infinity, false,
               "Radius of the balls in which corners are looked for, in r", group);
    add_number("--corner-variance", extraction.corner_variance, 0., 1., true,
               "Explained variance ratio above which a ball holds a corner, for variance", group);
    add_number("--corner-residual", extraction.corner_residual, 0., infinity, false,
               "Residual above which a ball holds a corner, for field-residual, in r; follows from the noise "
               "if not given",
               group, false);
  }

  void add_curves()
  {
    const std::string group = "Curve clusters";
    Extraction_options& extraction = m_options.extraction;
    add_number("--connection-radius", extraction.connection_radius, 0., infinity, false,
               "Points closer than this may belong to one curve, in r", group);
    add_number("--connection-angle", extraction.connection_angle, 0., 90., true,
               "Largest angle between the tangents of connected points, in degrees", group);
    add_boolean("--use-tangents", extraction.use_tangents, "Whether tangents decide on connections", group);
  }

  void add_graph()
  {
    namespace wireframe = CGAL::Wireframe_extraction;
    const std::string group = "Topological graph";
    Extraction_options& extraction = m_options.extraction;
    add_choice("--graph-method", extraction.graph_method,
               {{"traced", wireframe::Graph_method::TRACED}, {"subdivided", wireframe::Graph_method::SUBDIVIDED}},
               "Trace curves through the field, or subdivide a polyline per cluster", group);
    add_choice("--end-detection", extraction.end_detection,
               {{"graph-distance", wireframe::End_detection::GRAPH_DISTANCE},
                {"main-axis", wireframe::End_detection::MAIN_AXIS}},
               "How the ends of a cluster are found, for subdivided", group);
    add_number("--split-threshold", extraction.split_threshold, 0., infinity, false,
               "Residual above which a polyline is subdivided, for subdivided, in r", group);
    add_number("--corner-reach", extraction.corner_reach, 0., infinity, true,
               "How far from a corner a curve may end to be joined to it, in r", group);
    add_number("--maximum-gap", extraction.maximum_gap, 0., infinity, true,
               "Longest gap between facing ends that is bridged, for traced, in r", group);
    add_number("--smooth-angle", extraction.smooth_angle, 0., 180., true,
               "A curve that turns by less goes on through a vertex, in degrees", group);
    add_number("--minimum-evidence", extraction.minimum_evidence, 0., infinity, true,
               "Support of the field a curve must have to be kept, for traced", group);
  }

  void add_fit()
  {
    const std::string group = "Fit";
    Extraction_options& extraction = m_options.extraction;
    add_boolean("--use-robust-loss", extraction.use_robust_loss, "Whether outliers of the field count less", group);
    add_boolean("--move-corners", extraction.move_corners, "Whether corners move to where curves meet", group);
    add_boolean("--adapt-knots", extraction.adapt_knots, "Whether knots are added where residuals ask for them", group);
    add_checked("--number-of-rounds", extraction.number_of_rounds, 1, 1000,
                "Rounds of the fit, each with new foot points", group)
      ->capture_default_str();
  }

  void add_types()
  {
    const std::string group = "Curve types";
    Extraction_options& extraction = m_options.extraction;
    add_boolean("--recognize-types", extraction.recognize_types,
                "Whether lines, circles, ellipses and their arcs replace splines", group);
    add_boolean("--splines-only", m_has_splines_only, "The same as --recognize-types false", group);
    add_number("--type-significance", extraction.type_significance, 0., 1., false,
               "Share of true lines, circles and ellipses that may be taken for splines", group);
    add_boolean("--regularize", extraction.regularize,
                "Make radii equal, circles coaxial, and directions parallel or orthogonal, where the field agrees; "
                "what was changed is printed",
                group);
  }

  Options& m_options;
  bool m_has_splines_only = false;
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_COMMAND_LINE_H
