// The doubts about curves: each reason where it is there, and not where it is not.

#include <CGAL/extract_wireframe.h>

#include <CGAL/Simple_cartesian.h>

#include <CGAL/Wireframe_extraction/internal/pipeline/Doubt_finder.h>

#include "sample_clouds.h"

#include <Sample_solids/Sample_solids.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace WI = CGAL::Wireframe_extraction::internal;
namespace WP = CGAL::Wireframe_extraction::parameters;

typedef CGAL::Wireframe_doubt Doubt;
typedef std::set<Doubt> Doubts;
typedef CGAL::Wireframe<WI::Plain_traits> Plain_wireframe;
typedef WI::Plain_traits::Point_3 Plain_point;

// ---- the reasons alone: a surface, a field, and curves that were not extracted ----

// All lengths are in sampling distances.
struct Scene
{
  std::vector<WI::Vector> points;
  std::vector<double> distances;
  double noise = 0.;
  bool has_surface = true;
  Plain_wireframe wireframe;

  void add_line(const Plain_point& from, const Plain_point& to)
  {
    Plain_wireframe::Curve curve;
    const double length = std::hypot(to[0] - from[0], to[1] - from[1], to[2] - from[2]);
    curve.type = CGAL::Wireframe_curve_type::LINE;
    curve.spline = Plain_wireframe::Curve::Spline(1, {0., 0., length, length}, {from, to}, false);
    curve.source = vertex(from);
    curve.target = vertex(to);
    curve.support = 1;
    wireframe.curves.push_back(curve);
  }

  std::size_t vertex(const Plain_point& p)
  {
    const auto place = std::find(wireframe.vertices.begin(), wireframe.vertices.end(), p);
    const std::size_t index = std::size_t(place - wireframe.vertices.begin());
    if (place == wireframe.vertices.end())
      wireframe.vertices.push_back(p);
    return index;
  }

  // what is found about the first curve
  Doubts operator()()
  {
    auto band = std::make_shared<WI::Field_band>(), surroundings = std::make_shared<WI::Field_band>();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      surroundings->points.push_back(points[i]);
      surroundings->distances.push_back(distances[i]);
      if (distances[i] > 2.5)
        continue;
      band->points.push_back(points[i]);
      band->distances.push_back(distances[i]);
    }
    band->skeleton_size = band->size();
    band->search.build(band->points, band->size());
    surroundings->search.build(surroundings->points, surroundings->size());
    WI::Skeleton_data skeleton;
    skeleton.band = band;
    skeleton.surroundings = has_surface ? surroundings : std::make_shared<WI::Field_band>();
    const std::function<bool(double)> nobody;
    WI::Progress progress(nobody);
    WI::Doubt_finder(skeleton, noise, wireframe, progress).run();
    return wireframe.curves[0].doubts;
  }
};

// A square of side 40 around the origin, folded by some angle along the x-axis, whose distances are those to that axis;
// and a square of four curves, the first of which is on the fold.
Scene folded_square(double fold)
{
  const double pi = 3.14159265358979, slope = std::tan(0.5 * fold * pi / 180.);
  Scene scene;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(-20., 20.);
  for (int i = 0; i < 2600; ++i)
  {
    const double x = number(random), y = number(random);
    scene.points.emplace_back(x, y, -slope * std::abs(y));
    scene.distances.push_back(std::hypot(y, slope * y));
  }
  const std::array<Plain_point, 4> corners = {{{{-15., 0., 0.}}, {{15., 0., 0.}}, {{15., 0., 15.}}, {{-15., 0., 15.}}}};
  for (std::size_t k = 0; k < 4; ++k)
    scene.add_line(corners[k], corners[(k + 1) % 4]);
  return scene;
}

void test_no_doubt()
{
  assert(folded_square(90.)().empty());
  Scene without_surface = folded_square(90.);
  without_surface.has_surface = false;
  assert(without_surface().empty());
  Scene noisy = folded_square(90.);
  noisy.noise = 0.2;
  assert(noisy().empty());
}

void test_free_end()
{
  Scene scene = folded_square(90.);
  scene.wireframe.curves.pop_back(); // the one that goes back to the start of the first
  assert(scene() == Doubts({Doubt::FREE_END}));
  // of a closed curve, there is no end
  Scene closed;
  closed.wireframe.curves.resize(1);
  closed.wireframe.curves[0].spline = Plain_wireframe::Curve::Spline(
    1, {0., 0., 1., 2., 3., 3.}, {{{0., 0., 0.}}, {{9., 0., 0.}}, {{9., 9., 0.}}, {{0., 0., 0.}}}, true);
  assert(closed().count(Doubt::FREE_END) == 0);
}

void test_short()
{
  for (const double noise : {0., 0.2})
    for (const double length : {4.9, 5.1, 5.9, 6.1})
    {
      Scene scene = folded_square(90.);
      scene.noise = noise;
      scene.wireframe = Plain_wireframe();
      const Plain_point a = {{0., 0., 0.}}, b = {{length, 0., 0.}}, c = {{0., 0., 20.}};
      scene.add_line(a, b);
      scene.add_line(b, c);
      scene.add_line(c, a);
      const bool is_short = length < (noise == 0. ? 5. : 6.);
      assert(scene() == (is_short ? Doubts({Doubt::SHORT}) : Doubts()));
    }
}

void test_little_support()
{
  // a fold that ends in the middle, where the field says so
  Scene half = folded_square(90.);
  half.has_surface = false;
  for (std::size_t i = 0; i < half.points.size(); ++i)
    half.distances[i] = std::hypot(half.distances[i], (std::max)(0., half.points[i].x()));
  assert(half() == Doubts({Doubt::LITTLE_SUPPORT}));
  // a gap of the cloud
  for (const double gap : {6., 14.})
  {
    Scene scene = folded_square(90.);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < scene.points.size(); ++i)
      if (std::abs(scene.points[i].x()) > 0.5 * gap)
      {
        scene.points[kept] = scene.points[i];
        scene.distances[kept++] = scene.distances[i];
      }
    scene.points.resize(kept);
    scene.distances.resize(kept);
    assert(scene() == (gap > 10. ? Doubts({Doubt::LITTLE_SUPPORT}) : Doubts()));
  }
  // Errors that are as large as the noise are none, others are; by the number of points near it, the first curve lost
  // more than chance makes it lose.
  for (const double noise : {0.05, 0.4})
  {
    Scene scene = folded_square(90.);
    scene.noise = noise;
    scene.has_surface = false;
    for (std::size_t i = 0; i < scene.points.size(); i += i % 3 == 0 ? 1 : 2)
      scene.distances[i] += 0.6;
    assert(scene() == (noise < 0.1 ? Doubts({Doubt::LITTLE_SUPPORT}) : Doubts()));
  }
}

void test_misfit()
{
  for (const double noise : {0.02, 0.3})
    for (const double rms : {0.1, 0.2, 0.4, 0.5})
    {
      Scene scene = folded_square(90.);
      scene.noise = noise;
      scene.wireframe.curves[0].rms = rms;
      const bool is_misfit = rms > (noise < 0.1 ? 0.15 : 0.45);
      assert(scene() == (is_misfit ? Doubts({Doubt::MISFIT}) : Doubts()));
    }
}

void test_no_fold()
{
  for (const double fold : {0., 10., 25., 60.})
  {
    Scene scene = folded_square(fold);
    assert(scene() == (fold < 17. ? Doubts({Doubt::NO_FOLD}) : Doubts()));
    // who does not look at the surface says nothing of it
    scene = folded_square(fold);
    scene.has_surface = false;
    assert(scene().empty());
  }
}

void test_beside_another()
{
  for (const double offset : {0.8, 1.2, 1.8, 4.})
  {
    Scene scene = folded_square(90.);
    scene.has_surface = false;
    // a curve that starts and ends like the first one, and is beside it between
    scene.add_line({{-15., 0., 0.}}, {{-14., 0., offset}});
    scene.add_line({{-14., 0., offset}}, {{14., 0., offset}});
    scene.add_line({{14., 0., offset}}, {{15., 0., 0.}});
    assert((scene().count(Doubt::BESIDE_ANOTHER) == 1) == (offset < 1.5));
    assert((scene.wireframe.curves[5].doubts.count(Doubt::BESIDE_ANOTHER) == 1) == (offset < 1.5));
    assert(scene.wireframe.curves[2].doubts.count(Doubt::BESIDE_ANOTHER) == 0);
  }
  // no longer than half of it
  Scene scene = folded_square(90.);
  scene.add_line({{-15., 0., 0.}}, {{-13., 0., 1.}});
  scene.add_line({{-13., 0., 1.}}, {{-3., 0., 1.}});
  scene.add_line({{-3., 0., 1.}}, {{-2., 0., 20.}});
  assert(scene().count(Doubt::BESIDE_ANOTHER) == 0);
}

// ---- doubts about curves that were extracted ----

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Wireframe<Kernel> Wireframe;
typedef std::vector<std::pair<Kernel::Point_3, double>> Cloud;

void test_box()
{
  Sample_solids::Sampling_options options;
  options.sampling_distance = 0.02;
  const Cloud cloud =
    cloud_of_samples<Kernel::Point_3>(Sample_solids::sample(Sample_solids::make_solid("box"), options));
  CGAL::Wireframe_extraction_report report;
  const Wireframe wireframe = CGAL::extract_wireframe(cloud, WP::extraction_report(std::ref(report)));
  assert(wireframe.curves.size() == 12 && report.number_of_doubtful_curves == 0);
  for (const Wireframe::Curve& curve : wireframe.curves)
    assert(!curve.is_doubtful());
}

// A field in a plane, with twice the errors that it is said to have: the distances to a piece of a sine curve, about
// two waves of it.
Doubts doubts_about_wave(double amplitude, double significance)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> x(-25., 25.), y(-8., 8.);
  std::normal_distribution<double> error(0., 0.2);
  Cloud cloud;
  for (int i = 0; i < 800; ++i)
  {
    const double px = x(random), py = y(random);
    double distance = 1e9;
    for (double s = -20.; s <= 20.; s += 0.05)
      distance = (std::min)(distance, std::hypot(px - s, py - amplitude * std::sin(0.3 * s)));
    cloud.emplace_back(Kernel::Point_3(px, py, 0.), (std::max)(0., distance + error(random)));
  }
  CGAL::Wireframe_extraction_report report;
  const Wireframe wireframe = CGAL::extract_wireframe(cloud,
                                                      WP::sampling_distance(1.)
                                                        .noise_level(0.1)
                                                        .use_creases(false)
                                                        .type_significance(significance)
                                                        .extraction_report(std::ref(report)));
  assert(wireframe.curves.size() == 1 && report.number_of_doubtful_curves == 1);
  const bool is_line = wireframe.curves[0].type == CGAL::Wireframe_curve_type::LINE;
  assert(is_line == (amplitude == 0. && significance < 0.5));
  return wireframe.curves[0].doubts;
}

// A true line is one; if nearly all of them are to be refuted, it is refuted narrowly. A wave is refuted clearly.
void test_uncertain_type()
{
  assert(doubts_about_wave(0., 0.001) == Doubts({Doubt::FREE_END, Doubt::MISFIT}));
  assert(doubts_about_wave(0., 0.999) == Doubts({Doubt::FREE_END, Doubt::MISFIT, Doubt::UNCERTAIN_TYPE}));
  assert(doubts_about_wave(2., 0.999) == Doubts({Doubt::FREE_END, Doubt::MISFIT}));
}

void test_names()
{
  std::set<std::string> names;
  for (const Doubt doubt : {Doubt::FREE_END, Doubt::SHORT, Doubt::LITTLE_SUPPORT, Doubt::MISFIT, Doubt::NO_FOLD,
                            Doubt::BESIDE_ANOTHER, Doubt::UNCERTAIN_TYPE})
    names.insert(to_string(doubt));
  assert(names.size() == 7 && names.count("little_support") == 1);
}

} // namespace

int main()
{
  test_no_doubt();
  test_free_end();
  test_short();
  test_little_support();
  test_misfit();
  test_no_fold();
  test_beside_another();
  test_box();
  test_uncertain_type();
  test_names();
  return 0;
}
