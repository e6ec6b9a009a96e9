// The class Stages of the module: one stage after the other, with all that is in between.

#include "Array_cloud.h"
#include "Cloud_maps.h"
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
#include <CGAL/Wireframe_extraction/estimate_distance_field.h>
#include <CGAL/Wireframe_extraction/find_doubts.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/internal/cloud/Surveyed_cloud.h>
#include <CGAL/Wireframe_extraction/internal/cloud/input_checks.h>
#include <CGAL/Wireframe_extraction/recognize_curve_types.h>
#include <CGAL/Wireframe_extraction/refine_field.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>

#include <CGAL/boost/graph/properties.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace python {
namespace {

namespace py = pybind11;
namespace wireframe = CGAL::Wireframe_extraction;

class Stages
{
public:
  typedef CGAL::Wireframe_corner<Kernel> Corner;
  typedef std::vector<std::vector<std::size_t>> Clusters;
  typedef CGAL::Wireframe_graph<Kernel> Graph;

  Stages(const py::array& points, const py::object& distances, const py::dict& values, int threads)
    : m_points_array(points), m_distances_array(distances), m_parameters(parameters_of(values)),
      m_threads(threads), m_points{Number_view(points)}
  {
    if (!distances.is_none())
      m_distances.given = Number_view(py::array(distances));
  }

  // The stages in their order; each takes what the ones before have left.

  // looks at the cloud as the whole extraction does, which refuses more than the stages that follow
  py::dict measure(const py::object& progress)
  {
    Report report;
    run_beside(
      [&](Work_state& state) {
        if (!is_measured(state, report) && report.status == Report::Status::SUCCESS)
          report.status = Report::Status::INVALID_INPUT;
      },
      m_threads, progress);
    return report_dict(report);
  }

  py::dict estimate(const py::object& progress)
  {
    return run(progress, [this](const auto& np) {
      const auto range = index_range(m_points.points);
      wireframe::Distance_field field = wireframe::estimate_distance_field(range, np.point_map(m_points));
      m_parameters.noise_level = m_parameters.noise_or(field.noise_level);
      m_distances.estimated = std::make_shared<const std::vector<double>>(std::move(field.distances));
    });
  }

  py::dict select(const py::object& progress)
  {
    return run(progress, [this](const auto& np) {
      const auto range = index_range(m_points.points);
      m_skeleton = wireframe::select_skeleton(range, np.point_map(m_points).distance_map(m_distances));
    });
  }

  py::dict contract(const py::object& progress)
  {
    return run(progress, [this](const auto& np) {
      if (wireframe::contract_skeleton(m_skeleton, np) && m_parameters.use_creases)
        wireframe::refine_field(m_skeleton, np);
    });
  }

  py::dict detect(const py::object& progress)
  {
    return run(progress, [this](const auto& np) { m_corners = wireframe::detect_corners(m_skeleton, np); });
  }

  py::dict segment(const py::object& progress)
  {
    return run(progress, [this](const auto& np) { m_clusters = wireframe::segment_curves(m_skeleton, m_corners, np); });
  }

  py::dict build(const py::object& progress)
  {
    return run(progress, [this](const auto& np) {
      m_graph = wireframe::build_topological_graph(m_skeleton, m_corners, m_clusters, np);
    });
  }

  py::dict fit(const py::object& progress)
  {
    return run(progress, [this](const auto& np) {
      m_curves = std::make_shared<Wireframe>(wireframe::fit_curves(m_skeleton, m_graph, np));
    });
  }

  py::dict recognize(const py::object& progress)
  {
    return run(progress, [this](const auto& np) {
      m_typed = std::make_shared<Wireframe>(
        m_parameters.recognize_types ? wireframe::recognize_curve_types(m_skeleton, *m_curves, np) : *m_curves);
      wireframe::find_doubts(m_skeleton, *m_typed, np);
    });
  }

  // What they have left.

  double sampling_distance() const { return m_parameters.sampling_distance; }

  py::object distances() const
  {
    if (!m_distances.estimated)
      return m_distances_array;
    return to_array(std::vector<double>(*m_distances.estimated));
  }

  // points, distances, and their indices in the cloud
  py::tuple skeleton() const
  {
    std::vector<double> points, distances;
    std::vector<std::int64_t> indices;
    for (std::size_t i = 0; i < m_skeleton.size(); ++i)
    {
      append(m_skeleton.point(i), points);
      distances.push_back(m_skeleton.distance(i));
      indices.push_back(static_cast<std::int64_t>(m_skeleton.index(i)));
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
  }

  py::list clusters() const
  {
    py::list result;
    for (const std::vector<std::size_t>& cluster : m_clusters)
      result.append(to_indices(cluster));
    return result;
  }

  void set_clusters(const Clusters& clusters) { m_clusters = clusters; }

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
  // returns whether all is well; else the report has a message
  bool is_measured(Work_state& state, Report& report)
  {
    report.message = wireframe::internal::out_of_range(m_parameters);
    if (!report.message.empty())
      return false;
    Array_cloud array(m_points.points, m_distances.given, !m_distances_array.is_none());
    Stoppable_cloud source(array, state);
    wireframe::internal::Surveyed_cloud cloud(source, m_parameters.points_in_memory);
    if (!wireframe::internal::survey(cloud, m_parameters.skip_invalid, report)
        || !wireframe::internal::check_dimension(cloud, report))
      return false;
    const wireframe::internal::Cloud_scale scale = cloud.scale();
    double& r = m_parameters.sampling_distance;
    if (!wireframe::internal::check_scale(cloud, scale, r, report))
      return false;
    if (!(r > 0.))
      r = scale.sampling_distance;
    return !cloud.has_distances() || wireframe::internal::check_truncation(cloud, r, m_parameters, report);
  }

  // runs one stage, and returns how it went
  template <class Stage>
  py::dict run(const py::object& progress, const Stage& stage)
  {
    Report report;
    run_beside(
      [&](Work_state& state) {
        const std::function<bool(double)> callback = [&state](double share) { return state.proceed(share); };
        stage(named_parameters(m_parameters, report, callback));
      },
      m_threads, progress);
    return report_dict(report);
  }

  static py::array to_indices(const std::vector<std::size_t>& indices)
  {
    return to_array(std::vector<std::int64_t>(indices.begin(), indices.end()));
  }

  const py::array m_points_array; // the views refer to these
  const py::object m_distances_array;
  Parameters m_parameters;
  const int m_threads;
  const Point_at m_points;
  Distance_at m_distances;
  CGAL::Wireframe_skeleton<Kernel> m_skeleton;
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
