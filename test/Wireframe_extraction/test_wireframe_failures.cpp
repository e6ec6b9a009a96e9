// Stages and the one call fail alike: nothing is thrown, nothing is changed, and the report says why.

#include <CGAL/Wireframe_extraction/recognize_curve_types.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Wireframe_extraction/Default_visitor.h>
#include <CGAL/Wireframe_extraction/build_topological_graph.h>
#include <CGAL/Wireframe_extraction/contract_skeleton.h>
#include <CGAL/Wireframe_extraction/detect_corners.h>
#include <CGAL/Wireframe_extraction/estimate_distance_field.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/Wireframe_extraction/find_doubts.h>
#include <CGAL/Wireframe_extraction/fit_curves.h>
#include <CGAL/Wireframe_extraction/refine_field.h>
#include <CGAL/Wireframe_extraction/segment_curves.h>
#include <CGAL/Wireframe_extraction/select_skeleton.h>
#include <CGAL/extract_wireframe.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef CGAL::Wireframe_extraction_report Report;
typedef Report::Status Status;

namespace WE = CGAL::Wireframe_extraction;
namespace WP = CGAL::Wireframe_extraction::parameters;

// ---- named parameters

// identifiers and functions of a list, "visitor_t" and "visitor"
std::vector<std::string> names_of_cgal()
{
  return {
#define CGAL_add_named_parameter(X, Y, Z) #X, #Y, #Z,
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) #X, #Y, #Z,
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z) #X, #Y, #Z,
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z) #X, #Y, #Z,
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) #X, #Y, #Z,
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_ref_only
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility
  };
}

std::vector<std::string> names_of_ours()
{
  return {
#include CGAL_WIREFRAME_NP_LIST
  };
}

std::vector<std::string> names_of_shared()
{
  return
  {
#include CGAL_WIREFRAME_SHARED_NP_LIST
#undef CGAL_add_named_parameter
  };
}

// A parameter of both lists would be two, and the one of CGAL would be passed over.
void test_lists_are_disjoint()
{
  const std::vector<std::string> cgal = names_of_cgal();
  assert(cgal.size() > 100 && names_of_ours().size() > 100);
  const auto has = [&](const std::string& name) { return std::find(cgal.begin(), cgal.end(), name) != cgal.end(); };
  for (const std::string& name : names_of_ours())
    assert(!has(name));
  for (const std::string& name : names_of_shared())
    assert(has(name));
}

struct Counting_visitor : WE::Default_visitor
{
  int number_of_calls = 0;
  void sampling_distance_estimated(double) { ++number_of_calls; }
};

// the edge of a roof: its points, and their distances to the ridge
Cloud roof(double height = 0.5, int half_width = 15)
{
  Cloud cloud;
  const double r = 0.05;
  for (int i = 0; i < 40; ++i)
    for (int j = -half_width; j <= half_width; ++j)
      cloud.emplace_back(Point(r * i, r * j, -height * r * std::abs(j)), r * std::abs(j) * std::hypot(1., height));
  return cloud;
}

void test_visitors()
{
  Counting_visitor visitor;
  (void)CGAL::extract_wireframe(roof(), CGAL::parameters::visitor(std::ref(visitor)));
  assert(visitor.number_of_calls == 1);
  (void)CGAL::extract_wireframe(roof(), WP::visitor(std::ref(visitor)).use_creases(false));
  assert(visitor.number_of_calls == 2);
  // what CGAL has may stand before what it has not, and after
  (void)CGAL::extract_wireframe(
    roof(), WP::callback([](double) { return true; }).use_creases(false).visitor(std::ref(visitor)).noise_level(0.1));
  assert(visitor.number_of_calls == 3);
}

// ---- failures

bool says(const Report& report, const std::string& text) { return report.message.find(text) != std::string::npos; }

void spoil(Report& report)
{
  report.status = Status::NO_FEATURE;
  report.message = "before";
}

// the first stages and the whole refuse the cloud for the same reason
void test_cloud(const Cloud& cloud, const std::string& text)
{
  Report report;
  assert(WE::estimate_sampling_distance(cloud, WP::extraction_report(std::ref(report))) == 0.);
  assert(report.status == Status::INVALID_INPUT && says(report, text));
  spoil(report);
  assert(WE::select_skeleton(cloud, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::INVALID_INPUT && says(report, text));
  spoil(report);
  assert(CGAL::extract_wireframe(cloud, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::INVALID_INPUT && says(report, text));
}

void test_clouds()
{
  test_cloud(Cloud(), "no points");
  Cloud cloud = roof();
  cloud[7].first = Point(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  cloud[9].second = -1.;
  test_cloud(cloud, "the first is the point with index 7");
  Report report;
  assert(WE::estimate_sampling_distance(cloud, WP::skip_invalid(true).extraction_report(std::ref(report))) > 0.);
  assert(report.status == Status::SUCCESS && report.message.empty());
  assert(!WE::select_skeleton(cloud, WP::skip_invalid(true).extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::SUCCESS && report.message.empty());

  const Cloud same(100, std::make_pair(Point(1, 2, 3), 0.));
  assert(WE::select_skeleton(same, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::INVALID_INPUT && says(report, "coincide"));
  for (const double r : {-1., std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
  {
    assert(WE::select_skeleton(roof(), WP::sampling_distance(r).extraction_report(std::ref(report))).is_empty());
    assert(report.status == Status::INVALID_INPUT && says(report, "sampling distance"));
  }
  Cloud far = roof();
  for (auto& sample : far)
    sample.second += 5.;
  assert(WE::select_skeleton(far, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::NO_FEATURE && !report.message.empty());
}

// What the whole extraction refuses, with its reason, the stages that see the cloud refuse, with the same.
void test_same_refusal(const Cloud& cloud, const std::string& text)
{
  Report whole, part;
  assert(CGAL::extract_wireframe(cloud, WP::extraction_report(std::ref(whole))).is_empty());
  assert(whole.status == Status::INVALID_INPUT && says(whole, text));
  const auto is_same = [&] {
    const bool result = part.status == whole.status && part.message == whole.message;
    spoil(part);
    return result;
  };
  assert(WE::select_skeleton(cloud, WP::extraction_report(std::ref(part))).is_empty() && is_same());
  assert(WE::estimate_sampling_distance(cloud, WP::extraction_report(std::ref(part))) == 0. && is_same());
}

// the same of clouds without distances
void test_same_refusal(const std::vector<Point>& points, const std::string& text)
{
  Report whole, part;
  assert(CGAL::extract_wireframe(points, WP::extraction_report(std::ref(whole))).is_empty());
  assert(whole.status == Status::INVALID_INPUT && says(whole, text));
  assert(WE::estimate_distance_field(points, WP::extraction_report(std::ref(part))).is_empty());
  assert(part.status == whole.status && part.message == whole.message);
  spoil(part);
  assert(WE::estimate_sampling_distance(points, WP::extraction_report(std::ref(part))) == 0.);
  assert(part.status == whole.status && part.message == whole.message);
}

void test_one_rule()
{
  Cloud line, unit = roof(), constant = roof(), cut_off = roof(0.5, 3), flat = roof();
  std::vector<Point> bare_line;
  for (int i = 0; i < 500; ++i)
  {
    line.emplace_back(Point(0.1 * i, 0.2 * i, 0.3 * i), 0.01 * (i % 7));
    bare_line.push_back(line.back().first);
  }
  for (std::size_t i = 0; i < unit.size(); ++i)
  {
    unit[i].second *= 1000.;
    constant[i].second = 0.05;
    flat[i].second *= 0.01;
  }
  for (auto& sample : cut_off)
    sample.second = (std::min)(sample.second, 0.06);
  test_same_refusal(line, "one line");
  test_same_refusal(bare_line, "one line");
  test_same_refusal(unit, "another unit");
  test_same_refusal(flat, "another unit");
  test_same_refusal(constant, "all distances are");
  test_same_refusal(cut_off, "cut off");
  // a sampling distance that does not fit
  Report report;
  for (const double r : {0.05 * 30., 0.05 / 30.})
  {
    const auto np = WP::sampling_distance(r).extraction_report(std::ref(report));
    assert(WE::select_skeleton(roof(), np).is_empty() && report.status == Status::INVALID_INPUT);
    assert(says(report, "does not fit the points"));
    spoil(report);
    std::vector<Point> points;
    for (const auto& sample : roof())
      points.push_back(sample.first);
    assert(WE::estimate_distance_field(points, np).is_empty() && report.status == Status::INVALID_INPUT);
    assert(says(report, "does not fit the points"));
  }
  // what is only odd is told once, however often the report is used
  Cloud odd = roof();
  for (auto& sample : odd)
    sample.second *= 0.5;
  for (int i = 0; i < 2; ++i)
    assert(!WE::select_skeleton(odd, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.warnings.size() == 1 && report.sampling_distance > 0.);
}

// fields that mean something else than a distance, each with its likely reason
void test_other_meanings()
{
  const auto changed = [](double scale, const auto& function) {
    Cloud cloud = roof();
    for (auto& sample : cloud)
    {
      const Point& p = sample.first;
      sample = {Point(scale * p.x(), scale * p.y(), scale * p.z()), function(scale * sample.second)};
    }
    return cloud;
  };
  for (const double scale : {1., 40., 0.1})
  {
    const double r = 0.05 * scale;
    test_same_refusal(changed(scale, [](double d) { return d * d; }), "squared");
    test_same_refusal(changed(scale, [=](double d) { return std::exp(-d / r); }), "probability");
    test_same_refusal(changed(scale, [=](double d) { return std::exp(-d / (4. * r)); }), "probability");
    test_same_refusal(changed(scale, [=](double d) { return d < 1.5 * r ? 1. : 0.; }), "only two values, 0 and 1");
    test_same_refusal(changed(scale, [=](double d) { return (std::max)(0., 1. - d / (3. * r)); }), "probability");
    test_same_refusal(changed(scale, [](double d) { return 4. * d; }), "another unit");
    assert(!WE::select_skeleton(changed(scale, [](double d) { return d; })).is_empty());
    // regressors know distances up to some limit
    for (const double limit : {3.2, 4., 6., 10.})
      assert(!WE::select_skeleton(changed(scale, [=](double d) { return (std::min)(d, limit * r); })).is_empty());
  }
}

// single precision far from the origin
void test_resolution()
{
  const auto at = [](double offset) {
    Cloud cloud = roof();
    for (auto& sample : cloud)
    {
      const Point& p = sample.first;
      sample.first = Point(float(p.x()), float(p.y() + offset), float(p.z()));
    }
    return cloud;
  };
  test_same_refusal(at(-1e6), "single precision");
  Report report;
  assert(!WE::select_skeleton(at(1e5), WP::extraction_report(std::ref(report))).is_empty());
  assert(report.warnings.size() == 1 && report.warnings[0].find("single precision") != std::string::npos);
  spoil(report);
  assert(!WE::select_skeleton(at(1e3), WP::extraction_report(std::ref(report))).is_empty() && report.warnings.empty());
}

// every stage refuses parameters out of their ranges, and leaves what it would have changed
void test_parameters()
{
  const auto skeleton = WE::select_skeleton(roof());
  auto changed = skeleton;
  Report report;
  const auto refused = [&](const char* name) {
    const bool is_refused = report.status == Status::INVALID_INPUT && says(report, name);
    spoil(report);
    return is_refused;
  };
  const auto bad = WP::fitting_radius(-4.).extraction_report(std::ref(report));
  assert(WE::select_skeleton(roof(), bad).is_empty() && refused("fitting_radius"));
  assert(!WE::contract_skeleton(changed, bad) && !changed.is_contracted() && refused("fitting_radius"));
  assert(WE::contract_skeleton(changed) && changed.is_contracted());
  assert(!WE::refine_field(changed, bad) && refused("fitting_radius"));
  const auto corners = WE::detect_corners(changed);
  assert(WE::detect_corners(changed, bad).empty() && refused("fitting_radius"));
  const auto clusters = WE::segment_curves(changed, corners);
  assert(!clusters.empty());
  assert(WE::segment_curves(changed, corners, bad).empty() && refused("fitting_radius"));
  const auto graph = WE::build_topological_graph(changed, corners, clusters);
  assert(num_edges(graph) > 0);
  assert(num_vertices(WE::build_topological_graph(changed, corners, clusters, bad)) == 0 && refused("fitting_radius"));
  const auto wireframe = WE::fit_curves(changed, graph);
  assert(!wireframe.is_empty());
  assert(WE::fit_curves(changed, graph, bad).is_empty() && refused("fitting_radius"));
  assert(WE::recognize_curve_types(changed, wireframe, bad).is_empty() && refused("fitting_radius"));
  auto doubted = wireframe;
  assert(!WE::find_doubts(changed, doubted, bad) && refused("fitting_radius"));
  assert(WE::find_doubts(changed, doubted, WP::extraction_report(std::ref(report))));
  assert(report.status == Status::SUCCESS && report.message.empty());
  assert(!WE::recognize_curve_types(changed, wireframe, WP::extraction_report(std::ref(report))).is_empty());
  assert(report.status == Status::SUCCESS && report.message.empty());
}

// a stage that was cancelled can be told from one that was not
void test_cancelling()
{
  Cloud cloud = roof();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    cloud[i].second += 0.02 * ((i * 7919) % 13) / 13.; // too noisy to be precise
  auto skeleton = WE::select_skeleton(cloud);
  Report report;
  const auto stop = WP::callback([](double) { return false; }).extraction_report(std::ref(report));
  assert(!WE::contract_skeleton(skeleton, stop) && report.status == Status::CANCELLED && !skeleton.is_contracted());
  assert(WE::contract_skeleton(skeleton, WP::extraction_report(std::ref(report))));
  assert(report.status == Status::SUCCESS && skeleton.is_contracted());
  assert(!WE::refine_field(skeleton, stop) && report.status == Status::CANCELLED && report.message == "cancelled");
  assert(WE::refine_field(skeleton, WP::extraction_report(std::ref(report))) && report.status == Status::SUCCESS);
  const auto corners = WE::detect_corners(skeleton, WP::extraction_report(std::ref(report)));
  assert(report.status == Status::SUCCESS);
  for (const WE::Corner_measure measure : {WE::Corner_measure::FIELD_RESIDUAL, WE::Corner_measure::VARIANCE})
  {
    const auto np = WP::corner_measure(measure).corner_residual(0.).corner_variance(0.);
    assert(!WE::detect_corners(skeleton, np).empty());
    spoil(report);
    const auto stopped = np.extraction_report(std::ref(report)).callback([](double) { return false; });
    assert(WE::detect_corners(skeleton, stopped).empty() && report.status == Status::CANCELLED);
  }
  // also later than at the first question
  std::size_t asked = 0;
  const auto late = WP::corner_measure(WE::Corner_measure::VARIANCE).extraction_report(std::ref(report));
  assert(WE::detect_corners(skeleton, late.corner_variance(0.).callback([&](double) { return ++asked < 2; })).empty());
  assert(report.status == Status::CANCELLED && asked == 2);
  const auto clusters = WE::segment_curves(skeleton, corners);
  assert(!clusters.empty());
  assert(WE::segment_curves(skeleton, corners, stop).empty() && report.status == Status::CANCELLED);
  (void)WE::build_topological_graph(skeleton, corners, clusters, stop);
  assert(report.status == Status::CANCELLED);
  // the published graph asks for each curve and each of its points
  const auto subdivided = WP::graph_method(WE::Graph_method::SUBDIVIDED).split_threshold(0.01);
  std::size_t calls = 0;
  (void)WE::build_topological_graph(skeleton, corners, clusters,
                                    subdivided.callback([&](double) { return ++calls > 0; }));
  assert(calls > clusters.size() + 10);
  for (const std::size_t most : {std::size_t(1), std::size_t(3), calls - 1})
  {
    std::size_t made = 0;
    spoil(report);
    (void)WE::build_topological_graph(
      skeleton, corners, clusters,
      subdivided.extraction_report(std::ref(report)).callback([&](double) { return ++made < most; }));
    assert(made == most && report.status == Status::CANCELLED);
  }
  const auto graph = WE::build_topological_graph(skeleton, corners, clusters, WP::extraction_report(std::ref(report)));
  assert(report.status == Status::SUCCESS);
  (void)WE::fit_curves(skeleton, graph, stop);
  assert(report.status == Status::CANCELLED);
  auto wireframe = WE::fit_curves(skeleton, graph);
  assert(!WE::recognize_curve_types(skeleton, wireframe).is_empty());
  assert(WE::recognize_curve_types(skeleton, wireframe, stop).is_empty() && report.status == Status::CANCELLED);
  assert(!WE::find_doubts(skeleton, wireframe, stop) && report.status == Status::CANCELLED);
  assert(WE::find_doubts(skeleton, wireframe, WP::extraction_report(std::ref(report))));
  assert(report.status == Status::SUCCESS && report.message.empty());
}

int main()
{
  test_lists_are_disjoint();
  test_visitors();
  test_clouds();
  test_one_rule();
  test_other_meanings();
  test_resolution();
  test_parameters();
  test_cancelling();
  return 0;
}
