// Sharp edges of meshes, and clouds that are sampled from them.

#include "check_words.h"
#include "sample_meshes.h"

#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/sample_sharp_mesh.h>
#include <CGAL/extract_wireframe.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace wireframe = CGAL::Wireframe_extraction;
namespace parameters = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef std::vector<std::pair<Point, double>> Cloud;
typedef wireframe::Sharp_mesh_report Report;
using wireframe::Mesh_kind;

Report report_of(const Sample_mesh& mesh)
{
  Report report;
  std::string error;
  wireframe::classify_mesh(mesh.points, mesh.polygons, parameters::mesh_report(std::ref(report)).error_message(&error));
  if (!error.empty())
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(error.empty());
  return report;
}

template <class NamedParameters>
Cloud sample(const Sample_mesh& mesh, Report& report, const NamedParameters& np)
{
  Cloud cloud;
  std::string error;
  const bool is_sampled = wireframe::sample_sharp_mesh(mesh.points, mesh.polygons, cloud,
                                                       np.mesh_report(std::ref(report)).error_message(&error));
  if (!is_sampled)
    std::fprintf(stderr, "%s\n", error.c_str());
  assert(is_sampled && error.empty() && report.sampling_distance > 0.);
  return cloud;
}

void check_counts(const Sample_mesh& mesh, std::size_t edges, std::size_t curves, std::size_t corners)
{
  for (const Sample_mesh& form : {mesh, mesh.triangulated(), mesh.exploded(), mesh.triangulated().exploded()})
  {
    const Report report = report_of(form);
    if (report.number_of_sharp_edges != edges || report.number_of_sharp_curves != curves
        || report.number_of_corners != corners)
      std::fprintf(stderr, "%zu sharp edges in %zu curves, %zu corners; %zu, %zu and %zu are right\n",
                   report.number_of_sharp_edges, report.number_of_sharp_curves, report.number_of_corners, edges, curves,
                   corners);
    assert(report.number_of_sharp_edges == edges && report.number_of_sharp_curves == curves);
    assert(report.number_of_corners == corners && report.number_of_loose_ends == 0);
    assert(report.kind == Mesh_kind::CAD && report.number_of_boundary_edges == 0);
  }
}

void test_sharp_edges()
{
  check_counts(prism_mesh(rectangle_outline(2., 1.), 0., 0.7), 12, 12, 8);
  check_counts(prism_mesh({{0, 0}, {1, 0}, {1, .8}, {.8, 1}, {0, 1}}, 0., 0.6), 15, 15, 10); // a corner cut off
  const Report angle = report_of(prism_mesh({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 0., 1.)); // not convex
  assert(angle.number_of_sharp_edges == 18 && angle.number_of_corners == 12 && std::abs(angle.area - 22.) < 1e-12);
  check_counts(prism_mesh(circle_outline(6), 0., 1.), 18, 18, 12);
  assert(report_of(prism_mesh(gear_outline(12), 0., 0.5)).number_of_sharp_edges == 144);
  check_counts(grid_box_mesh(20, 0.), 240, 12, 8);
}

// Facets of curved surfaces are not sharp.
void test_facets()
{
  for (std::size_t n : {8, 9, 10, 12, 15, 16, 18, 20, 32, 64, 200})
  {
    check_counts(prism_mesh(circle_outline(n), 0., 1.3), 2 * n, 2, 0);
    check_counts(cone_mesh(n, 1.5), n, 1, 0);
  }
  check_counts(prism_mesh(circle_outline(7), 0., 1.3), 21, 21, 14); // folded by more than 50 degrees
  for (std::size_t chords : {3, 4, 8, 16})
    assert(report_of(prism_mesh(rounded_outline(chords), 0., 0.5)).number_of_sharp_edges == 8 * chords + 8);
  for (std::size_t n : {12, 16, 24, 64})
  {
    assert(report_of(torus_mesh(n, 2 * n / 3, 1., 0.3)).number_of_sharp_edges == 0);
    assert(report_of(torus_mesh(n, n / 2, 0., 1.)).number_of_sharp_edges == 0);
  }

  // rims are as round as the facets beside them, and the other way round
  Report report;
  sample(prism_mesh(circle_outline(6), 0., 1.), report, parameters::maximum_facet_fold(61.));
  assert(report.number_of_sharp_edges == 12 && report.number_of_sharp_curves == 2 && report.kind == Mesh_kind::CAD);
  for (std::size_t n : {8, 9, 10})
  {
    sample(prism_mesh(circle_outline(n), 0., 1.), report, parameters::maximum_facet_fold(30.));
    assert(report.number_of_sharp_edges == 3 * n && report.number_of_sharp_curves == 3 * n);
  }

  const Sample_mesh cylinder = prism_mesh(circle_outline(12), 0., 1.);
  const Cloud all = sample(cylinder, report, parameters::maximum_facet_fold(0.).sampling_distance(0.05));
  assert(report.number_of_sharp_edges == 36 && report.number_of_facet_edges == 0);
  sample(cylinder, report, parameters::minimum_fold(100.).sampling_distance(0.05));
  assert(report.number_of_sharp_edges == 0);
}

double distance_to_segment(const Point& p, const Point& a, const Point& b)
{
  const Kernel::Vector_3 step = b - a;
  const double t = (std::max)(0., (std::min)(1., ((p - a) * step) / step.squared_length()));
  return std::sqrt(CGAL::squared_distance(p, a + t * step));
}

// Distances are exact, points are on the surface and evenly spread.
void test_samples()
{
  const double x = 2., y = 1., z = 0.7;
  const Sample_mesh box = prism_mesh(rectangle_outline(x, y), 0., z);
  std::vector<std::pair<Point, Point>> edges;
  for (std::size_t i = 0; i < 4; ++i)
  {
    edges.emplace_back(box.points[i], box.points[(i + 1) % 4]);
    edges.emplace_back(box.points[4 + i], box.points[4 + (i + 1) % 4]);
    edges.emplace_back(box.points[i], box.points[4 + i]);
  }
  const double r = 0.02, area = 2. * (x * y + y * z + z * x);
  Report report;
  const Cloud cloud = sample(box, report, parameters::sampling_distance(r));
  assert(report.sampling_distance == r && std::abs(report.area - area) < 1e-12);
  for (const auto& point : cloud)
  {
    const Point& p = point.first;
    const double off = (std::min)({p.x(), x - p.x(), p.y(), y - p.y(), p.z(), z - p.z()});
    assert(std::abs(off) < 1e-12);
    double nearest = 50. * r;
    for (const auto& edge : edges)
      nearest = (std::min)(nearest, distance_to_segment(p, edge.first, edge.second));
    assert(std::abs(point.second - nearest) < 1e-12);
  }
  // the nearest neighbors of some, by looking at all
  double sum = 0., least = 1.;
  std::size_t count = 0;
  for (std::size_t i = 0; i < cloud.size(); i += 37, ++count)
  {
    double nearest = 1.;
    for (std::size_t j = 0; j < cloud.size(); ++j)
      if (i != j)
        nearest = (std::min)(nearest, CGAL::squared_distance(cloud[i].first, cloud[j].first));
    sum += std::sqrt(nearest);
    least = (std::min)(least, std::sqrt(nearest));
  }
  assert(least >= 0.9 * r && std::abs(sum / static_cast<double>(count) - r) < 0.05 * r);

  // what is far from all edges
  const Cloud coarse = sample(box, report, parameters::sampling_distance(0.005));
  const auto farthest =
    std::max_element(coarse.begin(), coarse.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  assert(farthest->second == 50. * 0.005);

  // both sides of a thin plate have as many points
  const Cloud plate =
    sample(prism_mesh(rectangle_outline(1., 1.), 0., 0.001), report, parameters::sampling_distance(0.02));
  const std::size_t above = static_cast<std::size_t>(
    std::count_if(plate.begin(), plate.end(), [](const auto& point) { return point.first.z() > 0.00099; }));
  assert(above > 1300 && plate.size() - above > 1300);
}

// Where facets approximate something round, so are the points and their distances.
void test_round_surfaces()
{
  const double r = 0.03;
  for (std::size_t n : {8, 9, 12, 16, 24, 64})
  {
    // up to what a parabola differs from an arc, and the caps from discs
    const double angle = 2. * CGAL_PI / static_cast<double>(n), sagitta = 1. - std::cos(0.5 * angle);
    const double tolerance = 0.12 * sagitta;
    Report report;
    double largest = 0.;
    for (const auto& point : sample(prism_mesh(circle_outline(n), 0., 1.3), report, parameters::sampling_distance(r)))
    {
      const Point& p = point.first;
      const double radius = std::hypot(p.x(), p.y()), height = (std::min)(p.z(), 1.3 - p.z());
      const bool is_on_cap = height < 1e-12 && radius < 1. - tolerance;
      assert(is_on_cap || std::abs(radius - 1.) < sagitta + tolerance);
      if (!is_on_cap && height > 1e-12)
        largest = (std::max)(largest, std::abs(radius - 1.));
      const double distance = (std::min)(50. * r, std::hypot(radius - 1., height));
      assert(std::abs(point.second - distance) < 1e-3 * sagitta + 1e-4);
    }
    assert(largest < tolerance);
  }
  // nothing of it where there are flat faces only
  Report report;
  for (const auto& point : sample(prism_mesh(circle_outline(6), 0., 1.), report, parameters::sampling_distance(0.05)))
  {
    const Point& p = point.first;
    double inside = (std::min)(p.z(), 1. - p.z());
    for (int i = 0; i < 6; ++i)
    {
      const double angle = (i + 0.5) * CGAL_PI / 3.;
      inside = (std::min)(inside, std::cos(CGAL_PI / 6.) - p.x() * std::cos(angle) - p.y() * std::sin(angle));
    }
    assert(std::abs(inside) < 1e-12);
  }
}

void test_sampling_distance()
{
  Report report;
  const Sample_mesh box = prism_mesh(rectangle_outline(2., 1.), 0., 0.7);
  const Cloud coarse = sample(box, report, parameters::random_seed(0));
  assert(coarse.size() > 18000 && coarse.size() < 24000);
  const Sample_mesh thin = prism_mesh(rectangle_outline(2., 1.), 0., 0.05); // whose short edges take more points
  const Cloud fine = sample(thin, report, parameters::random_seed(0));
  assert(std::abs(report.sampling_distance - 0.05 / 12.) < 1e-12);
  const Cloud limited = sample(thin, report, parameters::maximum_number_of_points(30000));
  assert(limited.size() < 35000 && fine.size() > 100000);

  const Cloud again = sample(box, report, parameters::random_seed(0)),
              other = sample(box, report, parameters::random_seed(1));
  assert(again == coarse && other != coarse);
}

// Meshes as they should not be.
void test_repair()
{
  const Sample_mesh box = prism_mesh(rectangle_outline(2., 1.), 0., 0.7);
  Sample_mesh bad = box.triangulated();
  std::reverse(bad.polygons[3].begin(), bad.polygons[3].end()); // the other way round
  bad.polygons.push_back(bad.polygons[0]);                      // twice
  std::reverse(bad.polygons.back().begin(), bad.polygons.back().end());
  bad.polygons.push_back({0, 0, 1}); // without area
  bad.points.emplace_back(1., 0., 0.);
  bad.polygons.push_back({0, 8, 1}); // also
  Report report = report_of(bad);
  assert(report.number_of_sharp_edges == 12 && report.number_of_triangles == 12);
  assert(report.number_of_degenerate_faces == 2 && report.number_of_duplicate_faces == 1);

  // a side is cut in two, without its neighbors: their edges pass the new vertices
  Sample_mesh cut = box;
  cut.points.emplace_back(2., 0.4, 0.);
  cut.points.emplace_back(2., 0.4, 0.7);
  cut.polygons[1] = {1, 8, 9, 5};
  cut.polygons.push_back({8, 2, 6, 9});
  for (const Sample_mesh& mesh : {cut, cut.triangulated(), cut.triangulated().exploded()})
  {
    report = report_of(mesh);
    assert(report.number_of_t_junctions == 2 && report.number_of_boundary_edges == 0);
    assert(report.number_of_sharp_edges == 14 && report.number_of_sharp_curves == 12);
  }

  // without a lid
  Sample_mesh open = box;
  open.polygons.pop_back();
  report = report_of(open);
  assert(report.number_of_boundary_edges == 4 && report.number_of_sharp_edges == 8);
  assert(report.kind == Mesh_kind::CAD && report.number_of_loose_ends == 0);
  sample(open, report, parameters::use_boundaries(true));
  assert(report.number_of_sharp_edges == 12);

  // points without a face do not matter, wherever they are
  for (std::size_t place : {std::size_t(0), cut.points.size()})
  {
    Sample_mesh littered = cut;
    littered.points.insert(littered.points.begin() + static_cast<std::ptrdiff_t>(place), Point(1e7, 1e7, 1e7));
    for (std::vector<std::size_t>& polygon : littered.polygons)
      for (std::size_t& v : polygon)
        v += place == 0 ? 1 : 0;
    report = report_of(littered);
    assert(report.number_of_t_junctions == 2 && report.number_of_sharp_edges == 14);
  }

  // two boxes that share an edge
  Sample_mesh two = box;
  two.add(prism_mesh({{2., 1.}, {3., 1.}, {3., 2.}, {2., 2.}}, 0., 0.7));
  report = report_of(two);
  assert(report.number_of_non_manifold_edges == 1 && report.number_of_sharp_edges == 23);
}

// Whether boundaries are sharp does not tell what a mesh is.
void test_kinds_of_open_meshes()
{
  const Sample_mesh box = prism_mesh(rectangle_outline(2., 1.), 0., 0.7);
  Sample_mesh sheet = box, tray = box, scan = grid_box_mesh(20, 0.25);
  sheet.polygons.resize(1);
  tray.polygons.pop_back();
  scan.polygons.pop_back();
  Report report;
  for (const Sample_mesh& mesh : {sheet, tray, sheet.triangulated(), tray.triangulated()})
  {
    sample(mesh, report, parameters::use_boundaries(true));
    assert(report.kind == Mesh_kind::CAD && report.number_of_loose_ends == 0);
    assert(report.number_of_sharp_edges == (mesh.polygons.size() < 3 ? 4u : 12u));
    assert(report.number_of_sharp_curves == report.number_of_sharp_edges);
  }
  for (bool use_boundaries : {false, true})
  {
    sample(scan, report, parameters::use_boundaries(use_boundaries).sampling_distance(0.1));
    assert(report.kind == Mesh_kind::SCAN);
  }
}

void test_kinds()
{
  for (double noise : {0., 0.01, 0.02})
    assert(report_of(grid_box_mesh(20, noise)).kind == Mesh_kind::CAD);
  for (double noise : {0.1, 0.15, 0.25, 0.5, 1.})
    assert(report_of(grid_box_mesh(20, noise)).kind == Mesh_kind::SCAN);
}

template <class NamedParameters>
void refuse(const Sample_mesh& mesh, const Words& words, const NamedParameters& np)
{
  const Cloud before = {{Point(1, 2, 3), 4.}};
  Cloud cloud = before;
  std::string error;
  assert(!wireframe::sample_sharp_mesh(mesh.points, mesh.polygons, cloud, np.error_message(&error)));
  assert(cloud == before);
  check_words(error, words);
}

void test_errors()
{
  const auto defaults = parameters::random_seed(0);
  const Sample_mesh box = prism_mesh(rectangle_outline(2., 1.), 0., 0.7);
  refuse(Sample_mesh(), {"no faces"}, defaults);
  Sample_mesh bad = box;
  bad.polygons[2] = {0, 1};
  refuse(bad, {"face 2", "2 vertices"}, defaults);
  bad.polygons[2] = {0, 1, 8};
  refuse(bad, {"face 2", "does not exist", "8 vertices"}, defaults);
  bad = box;
  bad.points[3] = Point(0., std::numeric_limits<double>::quiet_NaN(), 0.);
  refuse(bad, {"vertex 3", "finite"}, defaults);
  bad.points[3] = Point(0., 1e200, 0.);
  refuse(bad, {"vertex 3", "finite"}, defaults);
  bad.points.assign(8, Point(1., 1., 1.));
  refuse(bad, {"no face has an area"}, defaults);
  refuse(box, {"1e-06", "50 million"}, parameters::sampling_distance(1e-6));
}

// Stopped anywhere, it leaves the cloud as it was; not stopped, it tells shares that grow.
void test_cancelling()
{
  const Sample_mesh box = prism_mesh(rectangle_outline(2., 1.), 0., 0.7);
  double last = -1.;
  const auto watch = [&last](double share) {
    assert(share >= last && share <= 1.);
    last = share;
    return true;
  };
  Report report;
  sample(box, report, parameters::callback(std::function<bool(double)>(watch)));
  assert(last > 0.9);
  for (double share : {0., 0.5, 0.95})
    refuse(box, {"cancelled"},
           parameters::callback(std::function<bool(double)>([share](double done) { return done < share; })));
}

// other kernels, ranges and numbers
void test_types()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Other_kernel;
  const std::array<Other_kernel::Point_3, 4> points = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const std::vector<std::array<int, 3>> triangles = {{{0, 1, 2}}, {{0, 1, 3}}, {{0, 2, 3}}, {{1, 2, 3}}};
  std::vector<std::pair<Other_kernel::Point_3, float>> cloud;
  assert(wireframe::sample_sharp_mesh(points, triangles, cloud));
  assert(cloud.size() > 18000);
  assert(wireframe::classify_mesh(points, triangles) == Mesh_kind::CAD);
}

void test_wireframe()
{
  Report report;
  const Cloud cloud = sample(prism_mesh(rectangle_outline(2., 1.), 0., 0.7), report, parameters::random_seed(0));
  const CGAL::Wireframe<Kernel> result = CGAL::extract_wireframe(cloud);
  assert(result.vertices.size() == 8 && result.curves.size() == 12);
  for (const auto& curve : result.curves)
    assert(curve.type == CGAL::Wireframe_curve_type::LINE);
}

int main()
{
  test_sharp_edges();
  test_facets();
  test_samples();
  test_round_surfaces();
  test_sampling_distance();
  test_repair();
  test_kinds();
  test_kinds_of_open_meshes();
  test_errors();
  test_cancelling();
  test_types();
  test_wireframe();
  return 0;
}
