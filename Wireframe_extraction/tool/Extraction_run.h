// One cloud in, its wireframe and all that shows it out.

#ifndef EXTRACT_WIREFRAME_EXTRACTION_RUN_H
#define EXTRACT_WIREFRAME_EXTRACTION_RUN_H

#include "Command_line.h"
#include "Error.h"
#include "Field_scale.h"
#include "Kernel.h"
#include "Options.h"
#include "Output_files.h"
#include "Progress.h"
#include "Shared_features.h"
#include "Stage_folder.h"
#include "Stage_recorder.h"
#include "Stage_visitor.h"
#include "open_input.h"
#include "run_batch.h"
#include "shown_cloud.h"
#include "summary.h"
#include "write_field.h"
#include "write_page.h"
#include "write_picture.h"

#include <CGAL/Wireframe_extraction/Distance_field.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/Wireframe_provenance.h>
#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/extract_wireframe.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tool {

typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_extraction_report Report;
namespace parameters = CGAL::Wireframe_extraction::parameters;

class Extraction_run
{
public:
  Extraction_run(const Command_line& command_line, const Options& options)
    : m_command_line(command_line), m_options(options), m_outputs(options)
  {}

  void run()
  {
    check_that_files_differ(m_options);
    m_outputs.check();
    if (m_options.has_stages)
      throw_if(m_folder.make(m_options.stages_folder), USAGE_ERROR);
    limit_threads();
    Progress progress(!m_options.is_quiet && is_error_stream_terminal());
    progress.start("reading");
    const std::unique_ptr<Input_cloud> cloud = open();
    Stage_recorder stages(m_folder, m_options.has_html);
    const Wireframe wireframe = extract(*cloud, progress, stages);
    throw_if(stages.error(), INTERNAL_ERROR);
    throw_if(with_option_names(cloud->error_message()), BAD_INPUT);
    if (m_options.has_field && cloud->has_distances())
      throw Error(
        USAGE_ERROR,
        m_options.input.files.front()
          + ": has distances, so none are estimated that --write-field could write; --field estimated estimates "
            "them all the same");
    throw_if_failed(wireframe);
    m_number_of_skipped = cloud->number_of_skipped();
    m_distance_place = cloud->distance_place();
    if (!cloud->note().empty())
      m_notes.push_back(with_option_names(cloud->note()));
    const auto begin = Clock::now();
    m_seconds.insert(m_seconds.begin(), m_report.seconds.begin(), m_report.seconds.end());
    m_seconds.front().second += m_seconds_of_opening;
    Cloud shown;
    if ((m_options.has_html || m_options.has_png) && !sample(*cloud, m_field, shown))
      throw Error(BAD_INPUT, with_option_names(cloud->error_message()));
    std::string problems;
    m_written = m_outputs.write(wireframe, provenance(), pictures(*cloud, shown, stages, wireframe), problems);
    m_seconds.emplace_back("writing", seconds_since(begin));
    progress.clear();
    m_number_of_curves = wireframe.curves.size();
    m_types = curves_text(wireframe);
    if (!m_options.is_quiet)
      summarize(wireframe, stages);
    throw_if(problems, INTERNAL_ERROR);
  }

  // what a batch tells of this cloud
  Cloud_result result() const
  {
    Cloud_result result;
    result.number_of_points = m_report.number_of_points;
    result.number_of_curves = m_number_of_curves;
    result.number_of_corners = m_report.number_of_corners;
    result.number_of_doubtful_curves = m_report.number_of_doubtful_curves;
    result.sampling_distance = m_report.sampling_distance;
    result.rms = m_report.rms;
    result.types = m_types;
    result.mesh_kind = m_mesh_kind;
    for (const std::string& warning : m_report.warnings)
      result.warnings.push_back(m_command_line.with_option_names(warning));
    return result;
  }

private:
  typedef std::chrono::steady_clock Clock;

  static constexpr const char* program = "extract_wireframe " WIREFRAME_EXTRACTION_VERSION_STRING;

  static double seconds_since(Clock::time_point begin)
  {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  static void throw_if(const std::string& error, Exit_code code)
  {
    if (!error.empty())
      throw Error(code, error);
  }

  void limit_threads()
  {
    if (m_options.number_of_threads == 0)
      return;
#ifdef CGAL_LINKED_WITH_TBB
    m_thread_limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                           static_cast<std::size_t>(m_options.number_of_threads));
#else
    if (m_options.number_of_threads > 1)
      m_notes.push_back("--threads has no effect: the tool was built without TBB and uses one thread");
#endif
  }

  std::unique_ptr<Input_cloud> open()
  {
    const auto begin = Clock::now();
    std::string error;
    std::unique_ptr<Input_cloud> cloud = open_input(m_options.input, error);
    throw_if(with_option_names(error), BAD_INPUT);
    m_mesh_kind = cloud->mesh_kind();
    throw_if(with_option_names(cloud->no_feature()), NO_FEATURE);
    m_scale = Field_scale(m_options, cloud->field_header());
    m_seconds_of_opening = seconds_since(begin);
    return cloud;
  }

  // the name of a file, with which messages begin, stays as it is
  std::string with_option_names(const std::string& text) const
  {
    std::size_t size = 0;
    for (const std::string& name : m_options.input.files)
      if (text.compare(0, name.size(), name) == 0)
        size = (std::max)(size, name.size());
    return text.substr(0, size) + m_command_line.with_option_names(text.substr(size));
  }

  // All parameters are given each time, so that the library is compiled for one pack of them.
  Wireframe extract(Input_cloud& cloud, Progress& progress, Stage_recorder& stages)
  {
    const Extraction_options& options = m_options.extraction;
    bool is_read = false, is_field_known = false;
    const auto use_field = [&, this](const CGAL::Wireframe_extraction::Distance_field& field) {
      stages.record_field(cloud, field);
      if (m_options.has_html || m_options.has_png || m_options.has_field)
        m_field = field;
    };
    Stage_visitor visitor(progress, stages, is_field_known, use_field);
    const std::function<bool(double)> callback = [&, this](double share) {
      if (!is_read) // the first call comes once the cloud is known to be usable
      {
        is_read = true;
        is_field_known = cloud.has_distances();
        if (m_options.has_field && is_field_known)
          return false;
        if (m_options.has_stages)
          m_folder.remove_old_files();
        progress.start("estimating the sampling distance");
      }
      progress.set(share);
      return stages.error().empty();
    };
    return CGAL::extract_wireframe_from_source<Kernel>(
      cloud,
      parameters::sampling_distance(m_scale.sampling_distance)
        .points_in_memory(static_cast<std::size_t>(m_options.points_in_memory))
        .minimum_fold(m_options.input.minimum_fold)
        .noise_level(m_scale.noise_level)
        .skeleton_distance(options.skeleton_distance)
        .support_distance(options.support_distance)
        .fitting_radius(options.fitting_radius)
        .use_creases(options.use_creases)
        .corner_measure(options.corner_measure)
        .corner_sampling_ratio(options.corner_sampling_ratio)
        .corner_radius(options.corner_radius)
        .corner_variance(options.corner_variance)
        .corner_residual(options.corner_residual)
        .connection_radius(options.connection_radius)
        .connection_angle(options.connection_angle)
        .use_tangents(options.use_tangents)
        .graph_method(options.graph_method)
        .end_detection(options.end_detection)
        .split_threshold(options.split_threshold)
        .corner_reach(options.corner_reach)
        .maximum_gap(options.maximum_gap)
        .smooth_angle(options.smooth_angle)
        .minimum_evidence(options.minimum_evidence)
        .use_robust_loss(options.use_robust_loss)
        .move_corners(options.move_corners)
        .adapt_knots(options.adapt_knots)
        .number_of_rounds(options.number_of_rounds)
        .recognize_types(options.recognize_types)
        .type_significance(options.type_significance)
        .regularize(options.regularize)
        .skip_invalid(m_options.input.skip_invalid)
        .extraction_report(std::ref(m_report))
        .visitor(std::ref(visitor))
        .callback(callback));
  }

  void throw_if_failed(const Wireframe& wireframe) const
  {
    if (m_report.status == Report::Status::SUCCESS && !wireframe.is_empty())
      return;
    std::string text = m_report.message;
    for (const std::string& warning : m_report.warnings)
      text += "; " + warning;
    text = m_options.input.files.front() + ": " + m_command_line.with_option_names(text);
    if (m_report.status == Report::Status::INVALID_INPUT)
      throw Error(BAD_INPUT, text);
    if (m_report.status != Report::Status::NO_FEATURE)
      throw Error(INTERNAL_ERROR, text);
    throw Error(NO_FEATURE,
                text
                  + (m_report.is_field_estimated && m_report.number_of_near_points == 0 ? ""
                       : m_report.skeleton_size == 0 ? "; --skeleton-distance sets the threshold"
                                                     : "; --stages DIR shows what the stages found"));
  }

  Summary summary(const Wireframe& wireframe) const
  {
    return summary_of(m_scale, wireframe, m_report, m_number_of_skipped + m_report.number_of_skipped_points,
                      m_distance_place,
                      m_command_line.is_unit_given() ? CGAL::IO::internal::symbol_of(m_options.unit) : std::string());
  }

  // notes on how the input was taken, and what looks odd
  std::vector<std::string> remarks() const
  {
    std::vector<std::string> texts;
    for (const std::string& note : m_notes)
      texts.push_back("Note: " + note);
    for (const std::string& warning : m_report.warnings)
      texts.push_back("Warning: " + m_command_line.with_option_names(warning));
    return texts;
  }

  std::vector<Picture> pictures(Input_cloud& input, const Cloud& cloud, const Stage_recorder& stages,
                                const Wireframe& wireframe) const
  {
    std::vector<Picture> result;
    if (m_options.has_html)
      result.push_back({m_options.html, [this, &cloud, &stages, &wireframe](std::ostream& stream, std::string& error) {
                          return write_page(stream, page_texts(wireframe), cloud, stages.stages(), wireframe, error);
                        }});
    if (m_options.has_png)
      result.push_back({m_options.png, [this, &cloud, &wireframe](std::ostream& stream, std::string& error) {
                          return write_picture(stream, m_options.view, cloud, wireframe, error);
                        }});
    if (m_options.has_shared_features)
      result.push_back({m_options.shared_features, [&wireframe](std::ostream& stream, std::string&) {
                          Shared_features(wireframe).write(stream);
                          return static_cast<bool>(stream);
                        }});
    if (m_options.has_field)
      result.push_back({m_options.field, [this, &input](std::ostream& stream, std::string& error) {
                          return write_field(stream, input, m_field, error);
                        }});
    return result;
  }

  static bool decides_on_results(const Parameter& parameter)
  {
    return (parameter.group != "Run" && parameter.group != "Many clouds") || parameter.name == "--paper";
  }

  // Names without folders, and no options that change nothing: the same cloud gives the same files, wherever it is.
  CGAL::Wireframe_provenance provenance() const
  {
    CGAL::Wireframe_provenance result;
    result.program = program;
    for (const std::string& file : m_options.input.files)
      result.inputs.push_back(std::filesystem::path(file).filename().string());
    for (const Parameter& parameter : m_command_line.parameters())
      if (parameter.is_given && decides_on_results(parameter))
        result.options.emplace_back(parameter.name, parameter.value);
    result.noise_level = m_report.noise;
    result.regularities = m_report.regularities;
    if (m_command_line.is_unit_given())
      result.unit = CGAL::IO::internal::symbol_of(m_options.unit);
    for (const std::string& warning : m_report.warnings)
      result.warnings.push_back(m_command_line.with_option_names(warning));
    return result;
  }

  Page_texts page_texts(const Wireframe& wireframe) const
  {
    Page_texts texts;
    const std::vector<std::string>& files = m_options.input.files;
    texts.title = std::filesystem::path(files.front()).filename().string()
      + (files.size() > 1 ? " and " + std::to_string(files.size() - 1) + " more" : "");
    texts.unit = CGAL::IO::internal::symbol_of(m_options.unit);
    texts.program = program;
    texts.summary = summary(wireframe);
    for (const auto& row : doubts_of(wireframe))
      texts.summary.push_back(row);
    texts.seconds = m_seconds;
    texts.warnings = remarks();
    texts.parameters = m_command_line.parameters();
    return texts;
  }

  void summarize(const Wireframe& wireframe, const Stage_recorder& stages) const
  {
    std::vector<std::string> files = m_written;
    files.insert(files.end(), stages.written_files().begin(), stages.written_files().end());
    const bool is_standard_output_taken = std::count(m_written.begin(), m_written.end(), "-") > 0;
    std::ostream& out = is_standard_output_taken ? std::cerr : std::cout;
    print_summary(out, summary(wireframe), m_seconds, files);
    for (const std::string& remark : remarks())
      out << remark << '\n';
    for (const auto& row : doubts_of(wireframe))
      print_row(out, row.first, row.second);
  }

  const Command_line& m_command_line;
  const Options& m_options;
  const Output_files<Kernel> m_outputs;
  Stage_folder m_folder;
  Report m_report;
  CGAL::Wireframe_extraction::Distance_field m_field; // that was estimated, if it is needed
  Field_scale m_scale;
  std::string m_mesh_kind, m_distance_place, m_types;
  std::size_t m_number_of_skipped = 0, m_number_of_curves = 0;
  double m_seconds_of_opening = 0.;
  std::vector<std::pair<std::string, double>> m_seconds;
  std::vector<std::string> m_notes, m_written;
#ifdef CGAL_LINKED_WITH_TBB
  std::unique_ptr<tbb::global_control> m_thread_limit;
#endif
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_EXTRACTION_RUN_H
