// The class Stages of the module: one stage after the other, with all that is in between.

#include "Array_cloud.h"
#include "Stoppable_cloud.h"
#include "arrays.h"
#include "bindings.h"
#include "parameters.h"
#include "report_dict.h"
#include "run_beside.h"

#include <CGAL/Wireframe_extraction/Wireframe_corner.h>
#include <CGAL/Wireframe_extraction/Wireframe_graph.h>
#include <CGAL/Wireframe_extraction/Wireframe_skeleton.h>
#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/find_doubts.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/call_select_skeleton.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/estimate_best_field.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/find_unit.h>
#include <CGAL/Wireframe_extraction/internal/pipeline/stage_reports.h>
#include <CGAL/Wireframe_extraction/recognize_curve_types.h>
#include <CGAL/Wireframe_extraction/refine_field.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>

#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace python {
namespace {

namespace py = pybind11;
namespace wireframe = CGAL::Wireframe_extraction;
namespace internal = CGAL::Wireframe_extraction::internal;

// The stages in their order.
enum Stage_number
{
  MEASURE,
  ESTIMATE,
  SELECT,
  CONTRACT,
  DETECT,
  SEGMENT,
  BUILD,
  FIT,
  RECOGNIZE
};

// Each stage is a function of what the stages before have left. What it makes is kept only once it has come to its end,
// and with Python's lock: a stage that was stopped leaves everything as it was, and is run again from the same values.
class Stages
{
public:
  typedef CGAL::Wireframe_corner<Kernel> Corner;
  typedef std::vector<std::vector<std::size_t>> Clusters;
  typedef CGAL::Wireframe_graph<Kernel> Graph;
  typedef CGAL::Wireframe_skeleton<Kernel> Skeleton;

  Stages(const py::array& points, const py::object& distances, const py::dict& values, int threads)
    : m_points_array(points), m_distances_array(distances), m_given(parameters_of(values)), m_threads(threads),
      m_array(Number_view(points), distances.is_none() ? Number_view() : Number_view(py::array(distances)),
              !distances.is_none()),
      m_source(m_array)
  {}

  // Of these, the first `number` are done, and what they have left is there.
  std::size_t number_of_done() const { return m_reports.size(); }

  // how these went
  py::dict report() const { return report_dict(m_reports.empty() ? Report() : m_reports.back()); }

  // looks at the cloud as the whole extraction does, which refuses more than the stages that follow
  py::dict measure(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback&) {
      // without distances, all points are looked at to have them
      const std::size_t points_in_memory =
        m_array.has_distances() ? m_given.points_in_memory : (std::numeric_limits<std::size_t>::max)();
      auto cloud = std::make_unique<internal::Surveyed_cloud>(m_source, points_in_memory);
      const auto at_once = [](const auto& measure) {
        measure();
        return true;
      };
      report.message = internal::out_of_range(m_given);
      if (!report.message.empty() || !internal::survey(*cloud, m_given.skip_invalid, report)
          || !internal::find_unit(*cloud, m_given.sampling_distance, m_given, report, at_once))
        report.status = Report::Status::INVALID_INPUT;
      return cloud;
    };
    return run(MEASURE, "sampling distance", progress, make,
               [this](auto&& cloud, Report&) { m_cloud = std::move(cloud); });
  }

  py::dict estimate(const py::object& progress)
  {
    if (m_array.has_distances())
      return skip(ESTIMATE);
    const auto make = [this](Report& report, const Callback& callback) {
      internal::Best_field best;
      if (internal::estimate_best_field(*m_cloud, report.sampling_distance, m_given.sampling_distance > 0.,
                                        m_given.minimum_fold, callback, best)
          && best.field.number_of_near_points == 0)
      {
        report.status = Report::Status::NO_FEATURE;
        report.message = internal::no_fold_message(m_given.minimum_fold);
      }
      return best;
    };
    return run(ESTIMATE, "field", progress, make, [this](internal::Best_field&& best, Report& report) {
      m_field = std::move(best);
      if (m_field.cloud)
      {
        m_cloud = std::move(m_field.cloud);
        report.sampling_distance = m_field.field.sampling_distance;
        report.warnings.push_back(m_field.warning);
      }
      internal::report_field(m_field.field, report);
      m_cloud->set_distances(m_field.field.distances);
      if (report.status == Report::Status::SUCCESS
          && !internal::check_truncation(*m_cloud, report.sampling_distance, m_given, report))
        report.status = Report::Status::INVALID_INPUT;
    });
  }

  py::dict select(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback&) {
      return internal::skeleton_of(*m_cloud, report.sampling_distance, m_given, report);
    };
    return run(SELECT, "skeleton", progress, make, [this](internal::Skeleton_data&& data, Report& report) {
      m_selected = Skeleton(std::move(data), Kernel());
      internal::report_skeleton(m_selected.data(), report);
      m_cloud.reset();
    });
  }

  py::dict contract(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback& callback) {
      Skeleton skeleton = m_selected; // the points and distances are shared
      const auto np = named_parameters(parameters(report), report, callback);
      if (wireframe::contract_skeleton(skeleton, np) && m_given.use_creases)
        wireframe::refine_field(skeleton, np);
      return skeleton;
    };
    return run(CONTRACT, "contraction", progress, make, [this](Skeleton&& skeleton, Report& report) {
      m_skeleton = std::move(skeleton);
      if (m_skeleton.is_contracted())
        report.noise = m_skeleton.noise();
    });
  }

  py::dict detect(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback& callback) {
      return wireframe::detect_corners(m_skeleton, named_parameters(parameters(report), report, callback));
    };
    return run(DETECT, "corners", progress, make, [this](auto&& corners, Report&) { m_corners = std::move(corners); });
  }

  py::dict segment(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback& callback) {
      return wireframe::segment_curves(m_skeleton, m_corners, named_parameters(parameters(report), report, callback));
    };
    return run(SEGMENT, "segmentation", progress, make, [this](Clusters&& clusters, Report& report) {
      m_clusters = std::move(clusters);
      report.number_of_clusters = m_clusters.size();
    });
  }

  py::dict build(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback& callback) {
      return wireframe::build_topological_graph(m_skeleton, m_corners, m_clusters,
                                                named_parameters(parameters(report), report, callback));
    };
    return run(BUILD, "graph", progress, make, [this](Graph&& graph, Report&) { m_graph = std::move(graph); });
  }

  py::dict fit(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback& callback) {
      auto result = std::make_shared<Wireframe>(
        wireframe::fit_curves(m_skeleton, m_graph, named_parameters(parameters(report), report, callback)));
      if (result->is_empty())
      {
        report.status = Report::Status::NO_FEATURE;
        report.message = internal::no_curve_message();
        *result = Wireframe(); // as of the whole extraction
      }
      return result;
    };
    return run(FIT, "splines", progress, make, [this](auto&& result, Report&) { m_curves = std::move(result); });
  }

  py::dict recognize(const py::object& progress)
  {
    const auto make = [this](Report& report, const Callback& callback) {
      const auto np = named_parameters(parameters(report), report, callback);
      auto result = std::make_shared<Wireframe>(
        m_given.recognize_types ? wireframe::recognize_curve_types(m_skeleton, *m_curves, np) : *m_curves);
      if (!result->is_empty())
        wireframe::find_doubts(m_skeleton, *result, np);
      return result;
    };
    return run(RECOGNIZE, "types", progress, make, [this](auto&& result, Report& report) {
      m_typed = std::move(result);
      internal::report_wireframe(*m_typed, report);
    });
  }

  // What they have left.

  // of the cloud, whatever the field is that of
  double sampling_distance() const { return m_reports[MEASURE].sampling_distance; }

  py::object distances() const
  {
    return m_array.has_distances() ? m_distances_array : copy_of(m_field.field.distances);
  }

  // points, distances, and their indices in the cloud
  py::tuple skeleton() const
  {
    std::vector<double> points, distances;
    std::vector<std::int64_t> indices;
    for (std::size_t i = 0; i < m_selected.size(); ++i)
    {
      append(m_selected.point(i), points);
      distances.push_back(m_selected.distance(i));
      indices.push_back(static_cast<std::int64_t>(m_selected.index(i)));
    }
    return py::make_tuple(to_rows(std::move(points)), to_array(std::move(distances)), to_array(std::move(indices)));
  }

  // points, tangents, residuals, and the noise of the field
  py::tuple feet() const
  {
    std::vector<double> points, tangents, residuals;
    for (std::size_t i = 0; i < m_skeleton.size(); ++i)
    {
      append(m_skeleton.foot(i), points);
      append(m_skeleton.tangent(i), tangents);
      residuals.push_back(m_skeleton.residual(i));
    }
    return py::make_tuple(to_rows(std::move(points)), to_rows(std::move(tangents)), to_array(std::move(residuals)),
                          m_skeleton.noise());
  }

  // for each a center, a radius, and the indices of its points in the skeleton
  py::list corners() const
  {
    py::list result;
    for (const Corner& corner : m_corners)
    {
      std::vector<double> center;
      append(corner.center, center);
      result.append(py::make_tuple(to_array(std::move(center)), corner.radius, to_indices(corner.members)));
    }
    return result;
  }

  void set_corners(const std::vector<std::pair<std::vector<double>, double>>& places,
                   const std::vector<std::vector<std::size_t>>& members)
  {
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const std::vector<double>& center = places[i].first;
      corners.push_back({Point(center[0], center[1], center[2]), places[i].second, members[i]});
    }
    m_corners.swap(corners);
    count_as_done(DETECT);
  }

  py::list clusters() const
  {
    py::list result;
    for (const std::vector<std::size_t>& cluster : m_clusters)
      result.append(to_indices(cluster));
    return result;
  }

  void set_clusters(const Clusters& clusters)
  {
    m_clusters = clusters;
    count_as_done(SEGMENT);
    m_reports.back().number_of_clusters = m_clusters.size();
  }

  // vertices, whether each is a corner, edges, and the curve of each edge
  py::tuple graph() const
  {
    std::vector<double> vertices;
    std::vector<std::uint8_t> are_corners;
    std::vector<std::int64_t> edges, curves;
    for (const auto vertex : boost::make_iterator_range(boost::vertices(m_graph)))
    {
      append(get(CGAL::vertex_point, m_graph, vertex), vertices);
      are_corners.push_back(m_graph[vertex].is_corner);
    }
    for (const auto edge : boost::make_iterator_range(boost::edges(m_graph)))
    {
      edges.push_back(static_cast<std::int64_t>(source(edge, m_graph)));
      edges.push_back(static_cast<std::int64_t>(target(edge, m_graph)));
      curves.push_back(static_cast<std::int64_t>(m_graph[edge].curve_id));
    }
    const py::ssize_t number_of_edges = static_cast<py::ssize_t>(curves.size());
    return py::make_tuple(to_rows(std::move(vertices)), to_array(std::move(are_corners)),
                          to_array(std::move(edges)).reshape({number_of_edges, py::ssize_t(2)}),
                          to_array(std::move(curves)));
  }

  std::shared_ptr<Wireframe> curves() const { return m_curves; }
  std::shared_ptr<Wireframe> typed() const { return m_typed; }

private:
  typedef std::function<bool(double)> Callback;

  // The parameters that were given, and what was found about the cloud.
  Parameters parameters(const Report& report) const
  {
    Parameters result = m_given;
    result.sampling_distance = report.sampling_distance;
    if (!m_array.has_distances())
      result.noise_level = m_given.noise_or(m_field.field.noise_level);
    return result;
  }

  // Runs `make(report, callback)` beside, and then `keep(what it made, report)` if nothing stopped it and the input is
  // valid. Returns the report of all stages up to this one.
  template <class Make, class Keep>
  py::dict run(Stage_number number, const char* name, const py::object& progress, const Make& make, const Keep& keep)
  {
    const Report before = m_reports.empty() ? Report() : m_reports.back();
    Report report = before;
    std::optional<decltype(make(report, Callback()))> made;
    run_beside(
      [&](Work_state& state) {
        m_source.set_state(state);
        CGAL::Real_timer timer;
        timer.start();
        made.emplace(make(report, [&state](double share) { return state.proceed(share); }));
        report.seconds.emplace_back(name, timer.time());
      },
      m_threads, progress);
    if (report.status != Report::Status::INVALID_INPUT)
      keep(std::move(*made), report);
    if (report.status == Report::Status::INVALID_INPUT)
      return report_dict(report);
    if (before.status == Report::Status::NO_FEATURE) // the first reason is the one that helps
    {
      report.status = before.status;
      report.message = before.message;
    }
    m_reports.resize(number);
    m_reports.push_back(report);
    return report_dict(report);
  }

  py::dict skip(Stage_number number)
  {
    count_as_done(number);
    return report_dict(m_reports.back());
  }

  // what was set, or need not be made
  void count_as_done(Stage_number number)
  {
    m_reports.resize((std::min)(m_reports.size(), static_cast<std::size_t>(number)));
    while (m_reports.size() <= number)
      m_reports.push_back(m_reports.back());
  }

  static py::array to_indices(const std::vector<std::size_t>& indices)
  {
    return to_array(std::vector<std::int64_t>(indices.begin(), indices.end()));
  }

  const py::array m_points_array; // the views refer to these
  const py::object m_distances_array;
  const Parameters m_given;
  const int m_threads;
  Array_cloud m_array;
  Stoppable_cloud m_source;
  std::vector<Report> m_reports;                     // of each stage that is done: how it all went up to there
  internal::Best_field m_field;                      // if the cloud has no distances
  std::unique_ptr<internal::Surveyed_cloud> m_cloud; // as long as it is needed; it may be that of means
  Skeleton m_selected, m_skeleton;                   // before and after the contraction
  std::vector<Corner> m_corners;
  Clusters m_clusters;
  Graph m_graph;
  std::shared_ptr<Wireframe> m_curves, m_typed;
};

} // namespace

void bind_stages(py::module_& module)
{
  py::class_<Stages>(module, "Stages")
    .def(py::init<const py::array&, const py::object&, const py::dict&, int>())
    .def("number_of_done", &Stages::number_of_done)
    .def("report", &Stages::report)
    .def("measure", &Stages::measure)
    .def("estimate", &Stages::estimate)
    .def("select", &Stages::select)
    .def("contract", &Stages::contract)
    .def("detect", &Stages::detect)
    .def("segment", &Stages::segment)
    .def("build", &Stages::build)
    .def("fit", &Stages::fit)
    .def("recognize", &Stages::recognize)
    .def("sampling_distance", &Stages::sampling_distance)
    .def("distances", &Stages::distances)
    .def("skeleton", &Stages::skeleton)
    .def("feet", &Stages::feet)
    .def("corners", &Stages::corners)
    .def("set_corners", &Stages::set_corners)
    .def("clusters", &Stages::clusters)
    .def("set_clusters", &Stages::set_clusters)
    .def("graph", &Stages::graph)
    .def("curves", &Stages::curves)
    .def("typed", &Stages::typed);
}

} // namespace python
