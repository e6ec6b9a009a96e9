// The command line tool: a cloud with distances in, its wireframe out. See extract_wireframe --help.

#include "Command_line.h"
#include "Error.h"
#include "Options.h"
#include "Output_files.h"
#include "Stage_recorder.h"
#include "open_input.h"
#include "run_batch.h"
#include "shown_cloud.h"
#include "summary.h"
#include "write_page.h"
#include "write_picture.h"

#include <CGAL/extract_wireframe.h>
#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/Wireframe_extraction_report.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#ifdef EXTRACT_WIREFRAME_WITH_GLOG
#include <glog/logging.h>
#endif

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace tool {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef CGAL::Wireframe_extraction_report Report;
namespace parameters = CGAL::Wireframe_extraction::parameters;

inline bool is_error_stream_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

// One line on a terminal that says how far the work is; nothing elsewhere.
class Progress
{
public:
  explicit Progress(bool is_on) : m_is_on(is_on) {}
  ~Progress() { clear(); }

  void start(const char* what)
  {
    m_what = what;
    show();
  }

  // may be called by another thread
  void set(double share)
  {
    const int percent = static_cast<int>(100. * share);
    if(m_percent.exchange(percent) != percent)
      show();
  }

  void clear() const
  {
    if(m_is_on)
      std::fputs("\r\033[K", stderr);
  }

private:
  void show() const
  {
    if(m_is_on)
      std::fprintf(stderr, "\r\033[K%3d %% %s", m_percent.load(), m_what.load());
  }

  const bool m_is_on;
  std::atomic<const char*> m_what{""};
  std::atomic<int> m_percent{0};
};

// shows which stage is at work, and records what the stages made
class Visitor : public CGAL::Wireframe_extraction::Default_visitor
{
public:
  Visitor(Progress& progress, Stage_recorder& stages) : m_progress(progress), m_stages(stages) {}

  template <class FT>
  void sampling_distance_estimated(const FT&) { m_progress.start("selecting the skeleton"); }

  template <class Skeleton>
  void skeleton_selected(const Skeleton& skeleton)
  {
    m_stages.record_skeleton(skeleton);
    m_progress.start("contracting the skeleton");
  }

  template <class Skeleton>
  void skeleton_contracted(const Skeleton& skeleton)
  {
    m_stages.record_feet(skeleton);
    m_progress.start("detecting corners");
  }

  template <class Skeleton, class Corners>
  void corners_detected(const Skeleton& skeleton, const Corners& corners)
  {
    m_stages.record_corners(skeleton, corners);
    m_progress.start("segmenting curves");
  }

  template <class Skeleton, class Clusters>
  void curves_segmented(const Skeleton& skeleton, const Clusters& clusters)
  {
    m_stages.record_clusters(skeleton, clusters);
    m_progress.start("building the graph");
  }

  template <class Graph>
  void graph_built(const Graph& graph)
  {
    m_stages.record_graph(graph);
    m_progress.start("fitting curves");
  }

  template <class Result>
  void curves_fitted(const Result& wireframe)
  {
    m_stages.record_curves(wireframe);
    m_progress.start("recognizing curve types");
  }

private:
  Progress& m_progress;
  Stage_recorder& m_stages;
};

class Tool
{
public:
  explicit Tool(const Command_line& command_line, const Options& options)
    : m_command_line(command_line), m_options(options), m_outputs(options)
  {}

  void run()
  {
    check_that_files_differ(m_options);
    m_outputs.check();
    if(m_options.has_stages)
      throw_if(m_folder.make(m_options.stages_folder), USAGE_ERROR);
    limit_threads();
    Progress progress(!m_options.is_quiet && is_error_stream_terminal());
    progress.start("reading");
    const std::unique_ptr<Input_cloud> cloud = open();
    Stage_recorder stages(m_folder, m_options.has_html);
    const Wireframe wireframe = extract(*cloud, progress, stages);
    throw_if(stages.error(), INTERNAL_ERROR);
    throw_if(with_option_names(cloud->error_message()), BAD_INPUT);
    throw_if_failed(wireframe);
    m_number_of_skipped = cloud->number_of_skipped();
    if(!cloud->note().empty())
      m_notes.push_back(cloud->note());
    const auto begin = Clock::now();
    m_seconds.insert(m_seconds.begin(), m_report.seconds.begin(), m_report.seconds.end());
    m_seconds.front().second += m_seconds_of_opening;
    const Cloud shown = m_options.has_html || m_options.has_png ? sample_of(*cloud) : Cloud();
    m_outputs.write(wireframe, pictures(shown, stages, wireframe));
    m_seconds.emplace_back("writing", seconds_since(begin));
    progress.clear();
    m_number_of_curves = wireframe.curves.size();
    if(!m_options.is_quiet)
      summarize(wireframe, stages);
  }

  // what a batch tells of this cloud
  Cloud_result result() const
  {
    Cloud_result result;
    result.number_of_points = m_report.number_of_points;
    result.number_of_curves = m_number_of_curves;
    result.number_of_corners = m_report.number_of_corners;
    result.sampling_distance = m_report.sampling_distance;
    for(const std::string& warning : m_report.warnings)
      result.warnings.push_back(m_command_line.with_option_names(warning));
    return result;
  }

private:
  typedef std::chrono::steady_clock Clock;

  static double seconds_since(Clock::time_point begin)
  {
    return std::chrono::duration<double>(Clock::now() - begin).count();
  }

  static void throw_if(const std::string& error, Exit_code code)
  {
    if(!error.empty())
      throw Error(code, error);
  }

  void limit_threads()
  {
    if(m_options.number_of_threads == 0)
      return;
#ifdef CGAL_LINKED_WITH_TBB
    m_thread_limit = std::make_unique<tbb::global_control>(
      tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(m_options.number_of_threads));
#else
    if(m_options.number_of_threads > 1)
      m_notes.push_back("--threads has no effect: the tool was built without TBB and uses one thread");
#endif
  }

  std::unique_ptr<Input_cloud> open()
  {
    const auto begin = Clock::now();
    std::string error;
    std::unique_ptr<Input_cloud> cloud = open_input(m_options.input, error);
    throw_if(with_option_names(error), BAD_INPUT);
    m_seconds_of_opening = seconds_since(begin);
    return cloud;
  }

  // as many points as pictures show: of more, evenly many from everywhere
  Cloud sample_of(Input_cloud& cloud) const
  {
    constexpr std::size_t most = 1000000;
    Cloud result;
    std::size_t seen = 0;
    boost::random::mt19937_64 random(1);
    const bool is_read = cloud.read([&](const Input_cloud::Sample* first, const Input_cloud::Sample* beyond)
    {
      for(; first != beyond; ++first, ++seen)
      {
        const Cloud::value_type value(Kernel::Point_3(first->x, first->y, first->z), first->distance);
        if(result.size() < most)
          result.push_back(value);
        else
        {
          const std::size_t place = boost::random::uniform_int_distribution<std::size_t>(0, seen)(random);
          if(place < most)
            result[place] = value;
        }
      }
      return true;
    });
    if(!is_read)
      throw Error(BAD_INPUT, with_option_names(cloud.error_message()));
    return result;
  }

  // the name of a file, with which messages begin, stays as it is
  std::string with_option_names(const std::string& text) const
  {
    std::size_t size = 0;
    for(const std::string& name : m_options.input.files)
      if(text.compare(0, name.size(), name) == 0)
        size = (std::max)(size, name.size());
    return text.substr(0, size) + m_command_line.with_option_names(text.substr(size));
  }

  // All parameters are given each time, so that the library is compiled for one pack of them.
  Wireframe extract(Input_cloud& cloud, Progress& progress, Stage_recorder& stages)
  {
    const Extraction_options& options = m_options.extraction;
    Visitor visitor(progress, stages);
    bool is_read = false;
    const std::function<bool(double)> callback = [&, this](double share)
    {
      if(!is_read) // the first call comes once the cloud is known to be usable
      {
        is_read = true;
        if(m_options.has_stages)
          m_folder.remove_old_files();
        progress.start("estimating the sampling distance");
      }
      progress.set(share);
      return stages.error().empty();
    };
    return CGAL::extract_wireframe_from_source<Kernel>(cloud,
      parameters::sampling_distance(m_options.sampling_distance)
        .points_in_memory(static_cast<std::size_t>(m_options.points_in_memory))
        .noise_level(options.noise_level)
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
    if(m_report.status == Report::Status::SUCCESS && !wireframe.is_empty())
      return;
    std::string text = m_report.message;
    for(const std::string& warning : m_report.warnings)
      text += "; " + warning;
    text = m_options.input.files.front() + ": " + m_command_line.with_option_names(text);
    if(m_report.status == Report::Status::INVALID_INPUT)
      throw Error(BAD_INPUT, text);
    if(m_report.status != Report::Status::NO_FEATURE)
      throw Error(INTERNAL_ERROR, text);
    throw Error(NO_FEATURE, text + (m_report.skeleton_size == 0
                                      ? "; --skeleton-distance sets the threshold"
                                      : "; --stages DIR shows what the stages found"));
  }

  Summary summary(const Wireframe& wireframe) const
  {
    return summary_of(m_options, wireframe, m_report, m_number_of_skipped + m_report.number_of_skipped_points);
  }

  // notes on how the input was taken, and what looks odd
  std::vector<std::string> remarks() const
  {
    std::vector<std::string> texts;
    for(const std::string& note : m_notes)
      texts.push_back("Note: " + note);
    for(const std::string& warning : m_report.warnings)
      texts.push_back("Warning: " + m_command_line.with_option_names(warning));
    return texts;
  }

  std::vector<Picture> pictures(const Cloud& cloud, const Stage_recorder& stages, const Wireframe& wireframe) const
  {
    std::vector<Picture> result;
    if(m_options.has_html)
      result.push_back({ m_options.html, [this, &cloud, &stages, &wireframe](std::ostream& stream, std::string& error)
      {
        return write_page(stream, page_texts(wireframe), cloud, stages.stages(), wireframe, error);
      } });
    if(m_options.has_png)
      result.push_back({ m_options.png, [this, &cloud, &wireframe](std::ostream& stream, std::string& error)
      {
        return write_picture(stream, m_options.view, cloud, wireframe, error);
      } });
    return result;
  }

  Page_texts page_texts(const Wireframe& wireframe) const
  {
    Page_texts texts;
    const std::vector<std::string>& files = m_options.input.files;
    texts.title = std::filesystem::path(files.front()).filename().string()
                  + (files.size() > 1 ? " and " + std::to_string(files.size() - 1) + " more" : "");
    texts.unit = CGAL::IO::internal::symbol_of(m_options.unit);
    texts.program = "extract_wireframe " WIREFRAME_EXTRACTION_VERSION_STRING;
    texts.summary = summary(wireframe);
    texts.seconds = m_seconds;
    texts.warnings = remarks();
    texts.parameters = m_command_line.parameters();
    return texts;
  }

  void summarize(const Wireframe& wireframe, const Stage_recorder& stages) const
  {
    std::vector<std::string> files = m_options.outputs;
    if(m_options.has_html)
      files.push_back(m_options.html);
    if(m_options.has_png)
      files.push_back(m_options.png);
    files.insert(files.end(), stages.written_files().begin(), stages.written_files().end());
    print_summary(std::cout, summary(wireframe), m_seconds, files);
    for(const std::string& remark : remarks())
      std::cout << remark << '\n';
  }

  const Command_line& m_command_line;
  const Options& m_options;
  const Output_files<Kernel> m_outputs;
  Stage_folder m_folder;
  Report m_report;
  std::size_t m_number_of_skipped = 0, m_number_of_curves = 0;
  double m_seconds_of_opening = 0.;
  std::vector<std::pair<std::string, double> > m_seconds;
  std::vector<std::string> m_notes;
#ifdef CGAL_LINKED_WITH_TBB
  std::unique_ptr<tbb::global_control> m_thread_limit;
#endif
};

// Does some work, and returns how it ended: the exit code, and what went wrong.
std::pair<int, std::string> outcome_of(const std::function<int()>& work)
{
  try
  {
    return { work(), std::string() };
  }
  catch(const Error& error)
  {
    return { error.exit_code, error.what() };
  }
  catch(const std::bad_alloc&)
  {
    return { INTERNAL_ERROR, "there is not enough memory for this cloud" };
  }
  catch(const std::exception& error)
  {
    return { INTERNAL_ERROR, std::string("unexpected: ") + error.what() };
  }
}

int run_one(const Command_line& command_line, const Options& options)
{
  Tool(command_line, options).run();
  return SUCCESS;
}

// Cloud by cloud, each in a process of its own, where this is the same as if the tool were called for it.
int run_many(const Command_line& command_line, const Options& options)
{
  Options of_cloud = options;
  of_cloud.is_quiet = true;
  if(of_cloud.number_of_threads == 0)
    of_cloud.number_of_threads = (std::max)(number_of_processors() / (std::max)(options.batch.number_of_jobs, 1), 1);
  if(options.batch.number_of_jobs == 0)
    of_cloud.number_of_threads = (std::max)(options.number_of_threads, 1);
  for(const std::string& format : options.batch.formats)
    Output_files<Kernel>::check_extension("--format ." + format);
  return run_batch(options.batch, [&](const std::string& cloud, const std::vector<std::string>& outputs)
  {
    Cloud_result result;
    of_cloud.input.files = { cloud };
    of_cloud.outputs = outputs;
    std::tie(result.exit_code, result.error) = outcome_of([&]
    {
      Tool tool(command_line, of_cloud);
      tool.run();
      result = tool.result();
      return SUCCESS;
    });
    return result;
  });
}

int parse_and_run(int argc, char** argv)
{
  Options options;
  Command_line command_line(options);
  try
  {
    command_line.parse(argc, argv);
  }
  catch(const CLI::ParseError& error)
  {
    if(error.get_exit_code() == 0)
      return command_line.show_help_or_version(error);
    throw Error(USAGE_ERROR, std::string(error.what()) + " (extract_wireframe --help tells more)");
  }
  return options.has_batch ? run_many(command_line, options) : run_one(command_line, options);
}

} // namespace tool

int main(int argc, char** argv)
{
#ifdef EXTRACT_WIREFRAME_WITH_GLOG
  // Ceres logs what it cannot solve, which the library looks at by itself, to the standard error stream
  FLAGS_minloglevel = google::GLOG_FATAL;
#endif
  const std::pair<int, std::string> outcome = tool::outcome_of([=] { return tool::parse_and_run(argc, argv); });
  if(!outcome.second.empty())
    std::cerr << "extract_wireframe: error: " << tool::one_line(outcome.second) << '\n';
  return outcome.first;
}
