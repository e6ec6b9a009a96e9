// The same wireframe, whatever kernel, traits or property maps the points come with; visitors and callbacks.

#include <CGAL/Wireframe_extraction/segment_curves.h>

#include "sample_clouds.h"

#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/estimate_distance_field.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/recognize_curve_types.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>
#include <CGAL/extract_wireframe.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Point_set_3.h>
#include <CGAL/Simple_cartesian.h>

#include <Sample_solids/Sample_solids.h>

#include "minimal_traits.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <list>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Epick;
typedef CGAL::Simple_cartesian<double> Cartesian;
typedef CGAL::Wireframe_extraction_report Report;

namespace WE = CGAL::Wireframe_extraction;
namespace WP = CGAL::Wireframe_extraction::parameters;

const Sample_solids::Cloud& samples()
{
  static const Sample_solids::Cloud result = [] {
    Sample_solids::Sampling_options options;
    options.sampling_distance = 0.025;
    return Sample_solids::sample(Sample_solids::make_solid("box_with_hole"), options);
  }();
  return result;
}

template <class Kernel>
std::vector<std::pair<typename Kernel::Point_3, double>> cloud()
{
  return cloud_of_samples<typename Kernel::Point_3>(samples());
}

template <class Traits>
std::array<double, 3> coordinates(const typename Traits::Point_3& p)
{
  auto c = Traits().construct_cartesian_const_iterator_3_object()(p);
  std::array<double, 3> result;
  for (double& x : result)
    x = CGAL::to_double(*c++);
  return result;
}

// to the last bit, as all calculation is in double
template <class A, class B>
bool are_equal(const CGAL::Wireframe<A>& a, const CGAL::Wireframe<B>& b)
{
  if (a.sampling_distance != b.sampling_distance || a.vertices.size() != b.vertices.size()
      || a.curves.size() != b.curves.size())
    return false;
  for (std::size_t v = 0; v < a.vertices.size(); ++v)
    if (coordinates<A>(a.vertices[v]) != coordinates<B>(b.vertices[v]))
      return false;
  for (std::size_t c = 0; c < a.curves.size(); ++c)
  {
    const auto& x = a.curves[c];
    const auto& y = b.curves[c];
    if (x.source != y.source || x.target != y.target || x.is_closed() != y.is_closed() || x.support != y.support
        || x.rms != y.rms || x.max != y.max
        || !std::equal(x.spline.knots().begin(), x.spline.knots().end(), y.spline.knots().begin(),
                       y.spline.knots().end())
        || x.spline.control_points().size() != y.spline.control_points().size())
      return false;
    for (std::size_t i = 0; i < x.spline.control_points().size(); ++i)
      if (coordinates<A>(x.spline.control_points()[i]) != coordinates<B>(y.spline.control_points()[i]))
        return false;
  }
  return true;
}

const CGAL::Wireframe<Epick>& expected()
{
  static const CGAL::Wireframe<Epick> result = CGAL::extract_wireframe(cloud<Epick>());
  return result;
}

// ---- kernels, traits, ranges, property maps

struct Measurement
{
  Minimal_point position;
  float confidence;
  double field;
};

struct Position_map
{
  typedef Measurement key_type;
  typedef Minimal_point value_type;
  typedef const Minimal_point& reference;
  typedef boost::readable_property_map_tag category;
  friend reference get(Position_map, const Measurement& m) { return m.position; }
};

struct Field_map
{
  typedef Measurement key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;
  friend reference get(Field_map, const Measurement& m) { return m.field; }
};

void test_kernels()
{
  assert(expected().curves.size() == 14 && expected().vertices.size() == 8);
  assert(are_equal(expected(), expected()));
  assert(!are_equal(expected(), CGAL::Wireframe<Epick>()));
  assert(are_equal(expected(), CGAL::extract_wireframe(cloud<Cartesian>())));
}

void test_minimal_traits()
{
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < samples().points.size(); ++i)
  {
    const Sample_solids::Point& p = samples().points[i];
    measurements.push_back({Minimal_point(p[0], p[1], p[2]), 1.f, samples().distances[i]});
  }
  Report report;
  const CGAL::Wireframe<Minimal_traits> wireframe = CGAL::extract_wireframe(measurements,
                                                                            WP::distance_map(Field_map())
                                                                              .extraction_report(std::ref(report))
                                                                              .point_map(Position_map())
                                                                              .geom_traits(Minimal_traits()));
  assert(report.status == Report::Status::SUCCESS);
  assert(are_equal(expected(), wireframe));
  // the stages and the published method get along with the traits as well
  const auto np = WP::distance_map(Field_map()).point_map(Position_map()).geom_traits(Minimal_traits());
  assert(WE::estimate_sampling_distance(measurements, np) > 0.);
  CGAL::Wireframe_skeleton<Minimal_traits> skeleton = WE::select_skeleton(measurements, np);
  WE::contract_skeleton(skeleton);
  const auto corners = WE::detect_corners(skeleton, WP::corner_measure(WE::Corner_measure::VARIANCE));
  const auto clusters = WE::segment_curves(skeleton, corners);
  const auto graph = WE::build_topological_graph(skeleton, corners, clusters);
  assert(!WE::fit_curves(skeleton, graph).is_empty());
}

// a range that is no vector, with traits that are known from the points
void test_other_range()
{
  const auto vector = cloud<Cartesian>();
  const std::list<std::pair<Cartesian::Point_3, double>> list(vector.begin(), vector.end());
  assert(are_equal(expected(), CGAL::extract_wireframe(list)));
  const CGAL::Wireframe<Cartesian> with_traits =
    CGAL::extract_wireframe(list, WP::skip_invalid(false).geom_traits(Cartesian()));
  assert(are_equal(expected(), with_traits));
}

// A point set has its maps: nothing needs to be said about them.
void test_point_set()
{
  CGAL::Point_set_3<Epick::Point_3> points, bare;
  const auto distances = points.add_property_map<double>("distance", 0.).first;
  std::vector<Epick::Point_3> positions;
  for (const auto& sample : cloud<Epick>())
  {
    distances[*points.insert(sample.first)] = sample.second;
    bare.insert(sample.first);
    positions.push_back(sample.first);
  }
  assert(are_equal(
    expected(),
    CGAL::extract_wireframe(points, WP::distance_map(distances).point_map(points.point_map()).geom_traits(Epick()))));
  const CGAL::Point_set_3<Epick::Point_3>& constant = points;
  assert(are_equal(expected(), CGAL::extract_wireframe(constant)));
  const double r = WE::estimate_sampling_distance(points);
  assert(r > 0. && !WE::select_skeleton(points, WP::sampling_distance(r)).is_empty());
  // what was removed is no point
  auto fewer = points;
  for (int i = 0; i < 100; ++i)
  {
    fewer.insert(Epick::Point_3(0., 0., 100. * i));
    fewer.remove(fewer.end() - 1);
  }
  assert(are_equal(expected(), CGAL::extract_wireframe(fewer)));

  // without distances, they are estimated
  CGAL::Wireframe_extraction_report report, same;
  const auto wireframe = CGAL::extract_wireframe(bare, WP::extraction_report(std::ref(report)));
  assert(report.is_field_estimated);
  assert(are_equal(CGAL::extract_wireframe(positions, WP::extraction_report(std::ref(same))), wireframe));
  assert(same.status == report.status);
  assert(WE::select_skeleton(bare, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == CGAL::Wireframe_extraction_report::Status::INVALID_INPUT);
  // and written to the property, if there is one
  const auto estimated = bare.add_property_map<double>("distance", -1.).first;
  const WE::Distance_field field = WE::estimate_distance_field(bare);
  for (std::size_t i = 0; i < field.distances.size(); ++i)
    assert(estimated[*(bare.begin() + std::ptrdiff_t(i))] == field.distances[i]);
}

// indices into two arrays
void test_indices()
{
  const auto pairs = cloud<Epick>();
  std::vector<Epick::Point_3> points;
  std::vector<double> distances;
  std::vector<std::size_t> indices;
  for (const auto& sample : pairs)
  {
    indices.push_back(points.size());
    points.push_back(sample.first);
    distances.push_back(sample.second);
  }
  assert(are_equal(
    expected(),
    CGAL::extract_wireframe(
      indices, WP::distance_map(CGAL::make_property_map(distances)).point_map(CGAL::make_property_map(points)))));
}

// ---- visitors

// notes which functions were called, and whether what it got fits together
struct Recorder : WE::Default_visitor
{
  std::vector<std::string> calls;
  double unit = 0.;
  std::size_t skeleton_size = 0, number_of_corners = 0, number_of_clusters = 0, number_of_curves = 0;

  void sampling_distance_estimated(double r)
  {
    calls.push_back("unit");
    unit = r;
  }

  void field_estimated(const WE::Distance_field&) { calls.push_back("field"); } // not of clouds with distances

  template <class Skeleton>
  void skeleton_selected(const Skeleton& skeleton)
  {
    calls.push_back("skeleton");
    assert(!skeleton.is_contracted() && skeleton.sampling_distance() == unit);
    skeleton_size = skeleton.size();
  }

  template <class Skeleton>
  void skeleton_contracted(const Skeleton& skeleton)
  {
    calls.push_back("contraction");
    assert(skeleton.is_contracted() && skeleton.size() == skeleton_size);
  }

  template <class Skeleton, class Corners>
  void corners_detected(const Skeleton& skeleton, const Corners& corners)
  {
    calls.push_back("corners");
    number_of_corners = corners.size();
    for (const auto& corner : corners)
      for (std::size_t i : corner.members)
        assert(i < skeleton.size());
  }

  template <class Skeleton, class Clusters>
  void curves_segmented(const Skeleton& skeleton, const Clusters& clusters)
  {
    calls.push_back("clusters");
    number_of_clusters = clusters.size();
    for (const auto& cluster : clusters)
      for (std::size_t i : cluster)
        assert(i < skeleton.size());
  }

  template <class Graph>
  void graph_built(const Graph& graph)
  {
    calls.push_back("graph");
    for (const auto& edge : boost::make_iterator_range(boost::edges(graph)))
      number_of_curves = (std::max)(number_of_curves, graph[edge].curve_id + 1);
  }

  template <class Wireframe>
  void curves_fitted(const Wireframe& wireframe)
  {
    calls.push_back("curves");
    assert(wireframe.curves.size() == number_of_curves);
  }

  template <class Wireframe>
  void types_recognized(const Wireframe& wireframe)
  {
    calls.push_back("types");
    assert(wireframe.curves.size() >= number_of_curves);
  }
};

// only one function is of interest
struct Graph_counter : WE::Default_visitor
{
  std::size_t* vertices;
  explicit Graph_counter(std::size_t& counter) : vertices(&counter) {}
  template <class Graph>
  void graph_built(const Graph& graph)
  {
    *vertices += boost::num_vertices(graph);
  }
};

// keeps what it sees
template <class Traits>
struct Keeper : WE::Default_visitor
{
  CGAL::Wireframe_skeleton<Traits> selected, contracted;
  std::vector<CGAL::Wireframe_corner<Traits>> corners;
  std::vector<std::vector<std::size_t>> clusters;
  CGAL::Wireframe_graph<Traits> graph;
  CGAL::Wireframe<Traits> fitted, typed;

  void skeleton_selected(const CGAL::Wireframe_skeleton<Traits>& s) { selected = s; }
  void skeleton_contracted(const CGAL::Wireframe_skeleton<Traits>& s) { contracted = s; }
  void corners_detected(const CGAL::Wireframe_skeleton<Traits>&,
                        const std::vector<CGAL::Wireframe_corner<Traits>>& detected)
  {
    corners = detected;
  }
  void curves_segmented(const CGAL::Wireframe_skeleton<Traits>&, const std::vector<std::vector<std::size_t>>& segmented)
  {
    clusters = segmented;
  }
  void graph_built(const CGAL::Wireframe_graph<Traits>& built) { graph = built; }
  void curves_fitted(const CGAL::Wireframe<Traits>& wireframe) { fitted = wireframe; }
  void types_recognized(const CGAL::Wireframe<Traits>& wireframe) { typed = wireframe; }
};

const std::vector<std::string> all_calls{"unit",     "skeleton", "contraction", "corners",
                                         "clusters", "graph",    "curves",      "types"};

void test_visitor()
{
  Recorder recorder;
  Report report;
  const auto wireframe =
    CGAL::extract_wireframe(cloud<Epick>(), WP::visitor(std::ref(recorder)).extraction_report(std::ref(report)));
  assert(are_equal(expected(), wireframe)); // watching changes nothing
  assert(recorder.calls == all_calls);
  assert(recorder.unit == report.sampling_distance);
  assert(recorder.skeleton_size == report.skeleton_size);
  assert(recorder.number_of_corners >= 8);
  assert(recorder.number_of_clusters == report.number_of_clusters);
  assert(recorder.number_of_curves == report.number_of_curves);

  std::size_t vertices = 0;
  CGAL::extract_wireframe(cloud<Epick>(), WP::visitor(Graph_counter(vertices)));
  assert(vertices > 100);

  // where there is no feature, the visitor sees how far it went
  Recorder disappointed;
  auto far = cloud<Epick>();
  for (auto& sample : far)
    sample.second += 1.;
  assert(CGAL::extract_wireframe(far, WP::visitor(std::ref(disappointed))).is_empty());
  assert(disappointed.calls == std::vector<std::string>{"unit"});
}

// the types are the user's, and what is in them is what the stages give that are called one by one
template <class Kernel, class Points, class NamedParameters>
void test_seen(const Points& points, const NamedParameters& np)
{
  Keeper<Kernel> seen;
  const CGAL::Wireframe<Kernel> wireframe = CGAL::extract_wireframe(points, np.visitor(std::ref(seen)));
  assert(are_equal(expected(), wireframe) && are_equal(wireframe, seen.typed));

  CGAL::Wireframe_skeleton<Kernel> skeleton = WE::select_skeleton(points, np);
  assert(seen.selected.size() == skeleton.size() && !seen.selected.is_contracted());
  WE::contract_skeleton(skeleton);
  assert(seen.contracted.size() == skeleton.size() && seen.contracted.is_contracted());
  for (std::size_t i = 0; i < skeleton.size(); ++i)
  {
    assert(seen.selected.index(i) == skeleton.index(i) && seen.selected.distance(i) == skeleton.distance(i));
    assert(coordinates<Kernel>(seen.selected.point(i)) == coordinates<Kernel>(skeleton.point(i)));
    assert(coordinates<Kernel>(seen.contracted.foot(i)) == coordinates<Kernel>(skeleton.foot(i)));
  }
  const auto corners = WE::detect_corners(skeleton);
  assert(seen.corners.size() == corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    assert(coordinates<Kernel>(seen.corners[i].center) == coordinates<Kernel>(corners[i].center));
    assert(seen.corners[i].radius == corners[i].radius && seen.corners[i].members == corners[i].members);
  }
  const auto clusters = WE::segment_curves(skeleton, corners);
  assert(seen.clusters == clusters);
  const auto graph = WE::build_topological_graph(skeleton, corners, clusters);
  assert(num_vertices(seen.graph) == num_vertices(graph) && num_edges(seen.graph) == num_edges(graph));
  for (std::size_t v = 0; v < num_vertices(graph); ++v)
  {
    assert(coordinates<Kernel>(get(CGAL::vertex_point, seen.graph, v))
           == coordinates<Kernel>(get(CGAL::vertex_point, graph, v)));
    assert(seen.graph[v].is_corner == graph[v].is_corner);
  }
  auto other = edges(seen.graph).first;
  for (const auto e : boost::make_iterator_range(edges(graph)))
  {
    assert(source(*other, seen.graph) == source(e, graph) && target(*other, seen.graph) == target(e, graph));
    assert(seen.graph[*other++].curve_id == graph[e].curve_id);
  }
  const CGAL::Wireframe<Kernel> fitted = WE::fit_curves(skeleton, graph);
  assert(are_equal(seen.fitted, fitted));
  assert(are_equal(seen.typed, WE::recognize_curve_types(skeleton, fitted)));
}

void test_seen_by_kernels()
{
  test_seen<Epick>(cloud<Epick>(), WP::skip_invalid(false));
  std::vector<std::pair<Minimal_point, double>> points;
  for (const auto& sample : cloud<Cartesian>())
    points.emplace_back(Minimal_point(sample.first.x(), sample.first.y(), sample.first.z()), sample.second);
  test_seen<Minimal_traits>(points, WP::skip_invalid(false).geom_traits(Minimal_traits()));
}

// ---- callbacks

void test_progress()
{
  std::vector<double> shares;
  const std::function<bool(double)> callback = [&](double share) {
    shares.push_back(share);
    return true;
  };
  Report report;
  const auto wireframe =
    CGAL::extract_wireframe(cloud<Epick>(), WP::extraction_report(std::ref(report)).callback(callback));
  assert(are_equal(expected(), wireframe));
  assert(report.status == Report::Status::SUCCESS);
  assert(shares.size() >= 8); // every stage, at least
  assert(std::is_sorted(shares.begin(), shares.end()));
  assert(shares.front() > 0. && shares.back() == 1.);
  assert(report.seconds.size() == 10);
  for (const auto& stage : report.seconds)
    assert(!stage.first.empty() && stage.second >= 0.);
}

void test_cancelling()
{
  std::size_t last_number_of_calls = 0;
  for (double limit : {0., 0.16, 0.3, 0.52, 0.58, 0.65, 0.85, 0.95})
  {
    bool is_cancelled = false;
    std::size_t calls_afterwards = 0;
    const std::function<bool(double)> callback = [&](double share) {
      calls_afterwards += is_cancelled;
      is_cancelled = is_cancelled || share > limit;
      return !is_cancelled;
    };
    Recorder recorder;
    Report report;
    const auto wireframe = CGAL::extract_wireframe(
      cloud<Epick>(), WP::visitor(std::ref(recorder)).extraction_report(std::ref(report)).callback(callback));
    assert(is_cancelled && calls_afterwards == 0);
    assert(report.status == Report::Status::CANCELLED && !report.message.empty());
    assert(wireframe.is_empty() && wireframe.vertices.empty());
    // a stage that was cancelled is not shown
    assert(recorder.calls.size() < all_calls.size() && recorder.calls.size() >= last_number_of_calls);
    assert(std::equal(recorder.calls.begin(), recorder.calls.end(), all_calls.begin()));
    last_number_of_calls = recorder.calls.size();
  }
  assert(last_number_of_calls >= 6);

  // at the very end it is too late to matter, but the answer is respected
  Report report;
  const std::function<bool(double)> at_the_end = [](double share) { return share < 1.; };
  assert(
    CGAL::extract_wireframe(cloud<Epick>(), WP::extraction_report(std::ref(report)).callback(at_the_end)).is_empty());
  assert(report.status == Report::Status::CANCELLED);
}

// ---- parameters

void test_paper_defaults()
{
  Report report;
  const auto published =
    CGAL::extract_wireframe(cloud<Epick>(), WP::paper_defaults().extraction_report(std::ref(report)));
  assert(report.status == Report::Status::SUCCESS && !published.is_empty());
  assert(!are_equal(expected(), published));
  for (const auto& curve : published.curves)
    for (const auto& p : curve.spline.control_points())
      assert(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()));
  // a parameter after the pack wins
  const auto coarse = CGAL::extract_wireframe(cloud<Epick>(), WP::paper_defaults().sampling_distance(0.03));
  assert(coarse.sampling_distance == 0.03);
  assert(!are_equal(coarse, published));
}

void test_defaults_are_defaults()
{
  const auto wireframe = CGAL::extract_wireframe(cloud<Epick>(),
                                                 WP::skeleton_distance(1.5)
                                                   .support_distance(3.)
                                                   .fitting_radius(4.)
                                                   .corner_measure(WE::Corner_measure::FIELD_RESIDUAL)
                                                   .connection_radius(3.)
                                                   .connection_angle(30.)
                                                   .use_tangents(true)
                                                   .graph_method(WE::Graph_method::TRACED)
                                                   .corner_reach(5.)
                                                   .maximum_gap(18.)
                                                   .smooth_angle(20.)
                                                   .minimum_evidence(2.)
                                                   .use_creases(true)
                                                   .use_robust_loss(true)
                                                   .move_corners(true)
                                                   .adapt_knots(true)
                                                   .number_of_rounds(3)
                                                   .skip_invalid(false));
  assert(are_equal(expected(), wireframe));
  // integers and floats are numbers, too
  assert(are_equal(expected(), CGAL::extract_wireframe(cloud<Epick>(), WP::fitting_radius(4).support_distance(3.f))));
}

} // namespace

int main()
{
  test_kernels();
  test_minimal_traits();
  test_other_range();
  test_point_set();
  test_indices();
  test_visitor();
  test_seen_by_kernels();
  test_progress();
  test_cancelling();
  test_paper_defaults();
  test_defaults_are_defaults();
  return 0;
}
