// The generator of clouds with ground truth: what it says of each solid is held against closed forms that are
// written down here anew.

#include <Sample_solids/Sample_solids.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace Sample_solids;

typedef std::function<double(const Point&)> Implicit;

// ---- implicit functions: zero exactly on the solid's surface

double box(const Point& p, const Point& low, const Point& high)
{
  double value = -1e300;
  for (int k = 0; k < 3; ++k)
    value = (std::max)(value, (std::max)(low[k] - p[k], p[k] - high[k]));
  return value;
}

double cylinder_x(const Point& p, double y, double z, double r) { return std::hypot(p[1] - y, p[2] - z) - r; }

double cylinder_z(const Point& p, double x, double y, double r) { return std::hypot(p[0] - x, p[1] - y) - r; }

double wedge(const Point& p, double degrees)
{
  const double half = degrees * pi / 360.;
  const double sides = std::abs(p[1]) * std::cos(half) - p[0] * std::sin(half);
  return (std::max)({sides, p[0] - 1.2 * std::cos(half), -p[2], p[2] - 0.8});
}

double polygon(const Point& p, int n, double r)
{
  double value = -1e300;
  for (int i = 0; i < n; ++i)
    value = (std::max)(value, p[0] * std::cos((2 * i + 1) * pi / n) + p[1] * std::sin((2 * i + 1) * pi / n));
  return value - r * std::cos(pi / n);
}

double gear(const Point& p)
{
  const double radius = std::hypot(p[0], p[1]), pitch = pi / 6;
  double angle = std::atan2(p[1], p[0]);
  angle = std::abs(angle - pitch * std::round(angle / pitch)); // a tooth is symmetric about the angle 0
  const double x = radius * std::cos(angle), y = radius * std::sin(angle), degree = pi / 180;
  const double a[2] = {std::cos(7.5 * degree), std::sin(7.5 * degree)};
  const double b[2] = {1.3 * std::cos(4.5 * degree), 1.3 * std::sin(4.5 * degree)};
  const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
  const double flank = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / length;
  const double outline = (std::min)(radius - 1.0, (std::max)(flank, radius - 1.3));
  return (std::max)({outline, 0.4 - radius, -p[2], p[2] - 0.4});
}

double slotted_plate(const Point& p)
{
  const double slot = (std::min)(
    {cylinder_z(p, 0.4, 0, 0.22), cylinder_z(p, -0.4, 0, 0.22), box(p, {{-0.4, -0.22, -9}}, {{0.4, 0.22, 9}})});
  return (std::max)(box(p, {{-0.8, -0.5, 0}}, {{0.8, 0.5, 0.3}}), -slot);
}

double bracket(const Point& p)
{
  const double body = (std::min)(box(p, {{0, 0, 0}}, {{1.1, 0.8, 0.25}}), box(p, {{0, 0, 0}}, {{0.25, 0.8, 1}}));
  // each hole goes through one leg only
  const double low = (std::max)(cylinder_z(p, 0.7, 0.4, 0.2), p[2] - 0.3);
  const double high = (std::max)(cylinder_x(p, 0.4, 0.62, 0.18), p[0] - 0.3);
  return (std::max)({body, -low, -high});
}

double crossing(const Point& p)
{
  const double thick = (std::max)(cylinder_z(p, 0, 0, 0.4), std::abs(p[2]) - 0.75);
  return (std::min)(thick, (std::max)(cylinder_x(p, 0, 0, 0.25), std::abs(p[0]) - 0.85));
}

double torus(const Point& p) { return (std::max)(std::hypot(std::hypot(p[0], p[1]) - 0.6, p[2]) - 0.3, p[2] - 0.15); }

double frustum(const Point& p)
{
  const double slant = std::hypot(p[0], p[1]) - (0.6 - 0.25 * p[2] / 0.8);
  return (std::max)({slant, -p[2], p[2] - 0.8});
}

double flange(const Point& p)
{
  double value = (std::max)({cylinder_z(p, 0, 0, 1), -cylinder_z(p, 0, 0, 0.35), -p[2], p[2] - 0.3});
  for (int i = 0; i < 6; ++i)
    value = (std::max)(value, -cylinder_z(p, 0.68 * std::cos(i * pi / 3), 0.68 * std::sin(i * pi / 3), 0.12));
  return value;
}

double elliptic_cut(const Point& p) { return (std::max)({cylinder_z(p, 0, 0, 0.5), -p[2], p[2] - 0.8 - 0.6 * p[0]}); }

double oblique_hole(const Point& p)
{
  const double angle = 35 * pi / 180;
  const double hole = std::hypot(p[0] * std::cos(angle) - (p[2] - 0.15) * std::sin(angle), p[1]) - 0.25;
  return (std::max)(box(p, {{-0.65, -0.45, 0}}, {{0.65, 0.45, 0.3}}), -hole);
}

double rounded_plate(const Point& p, double radius)
{
  const double x = std::abs(p[0]) - 0.8 + radius, y = std::abs(p[1]) - 0.55 + radius;
  const double outline = x > 0 && y > 0 ? std::hypot(x, y) - radius : (std::max)(x, y) - radius;
  return (std::max)({outline, -p[2], p[2] - 0.4});
}

// ---- what is known of each solid

struct Facts
{
  std::string name;
  std::size_t faces, curves, segments, corners, closed;
  double length, area;
  Implicit surface;
};

/// The lengths of closed curves by the trapezium rule, which converges fast on periodic functions.
double ellipse_length(double a, double b)
{
  double sum = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i)
    sum += std::hypot(a * std::sin(2 * pi * i / n), b * std::cos(2 * pi * i / n));
  return sum * 2 * pi / n;
}

double crossing_length(double thick, double thin)
{
  double sum = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i)
  {
    const double a = 2 * pi * i / n, y = thin * std::cos(a), dy = -thin * std::sin(a);
    sum += std::hypot(thin, y * dy / std::sqrt(thick * thick - y * y));
  }
  return sum * 2 * pi / n;
}

/// The area inside a thin cylinder on one side of a thick one that it crosses, by the midpoint rule.
double window_area(double thick, double thin)
{
  double sum = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i)
  {
    // y = thin sin(a): the height of the window is 2 thin cos(a)
    const double a = pi * ((i + 0.5) / n - 0.5), y = thin * std::sin(a);
    sum += 2 * thin * std::cos(a) * thick * thin * std::cos(a) / std::sqrt(thick * thick - y * y);
  }
  return sum * pi / n;
}

/// The area of one stub of the thin cylinder, from the thick one to its end.
double stub_area(double thick, double thin, double reach)
{
  double sum = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i)
  {
    const double y = thin * std::cos(2 * pi * i / n);
    sum += thin * (reach - std::sqrt(thick * thick - y * y));
  }
  return sum * 2 * pi / n;
}

Facts wedge_facts(const std::string& name, double degrees)
{
  const double a = degrees * pi / 180., base = 2.4 * std::sin(a / 2), end = 0.72 * std::sin(a);
  return {name, 5, 9, 9, 6, 0, 2 * (2.4 + base) + 3 * 0.8, 2 * end + (2.4 + base) * 0.8, [degrees](const Point& p) {
            return wedge(p, degrees);
          }};
}

Facts gear_facts()
{
  const double degree = pi / 180;
  const double flank = std::sqrt(1.69 + 1 - 2.6 * std::cos(3 * degree));
  const double outline = 12 * (2 * flank + 1.3 * 9 * degree + 15 * degree);
  // per tooth: the sector of the tip, that of the gap, and two triangles from the centre to a flank
  const double tooth = 0.5 * 1.69 * 9 * degree + 0.5 * 15 * degree + 1.3 * std::sin(3 * degree);
  const double face = 12 * tooth - pi * 0.16;
  return {"gear", 51, 146, 146, 96, 2, 2 * outline + 48 * 0.4 + 1.6 * pi, 2 * face + 0.4 * (outline + 0.8 * pi), gear};
}

Facts flange_facts()
{
  return {"flange", 10, 16, 16, 0, 16, 8.28 * pi, 2 * pi * (1 - 0.1225 - 6 * 0.0144) + 0.3 * 4.14 * pi, flange};
}

Facts elliptic_cut_facts()
{
  const double stretch = std::sqrt(1.36);
  return {"elliptic_cut", 3, 2, 2, 0, 2, pi + ellipse_length(0.5 * stretch, 0.5), 0.25 * pi * (1 + stretch) + 0.8 * pi,
          elliptic_cut};
}

Facts oblique_hole_facts()
{
  const double stretch = 1 / std::cos(35 * pi / 180);
  return {"oblique_hole",
          7,
          14,
          14,
          8,
          2,
          4 * 2.2 + 4 * 0.3 + 2 * ellipse_length(0.25 * stretch, 0.25),
          2 * (1.17 - 0.0625 * pi * stretch) + 0.3 * (4.4 + 0.5 * pi * stretch),
          oblique_hole};
}

Facts rounded_plate_facts(double radius)
{
  const double outline = 5.4 + (2 * pi - 8) * radius;
  return {"rounded_plate",
          10,
          2,
          16,
          0,
          2,
          2 * outline,
          2 * (1.76 - (4 - pi) * radius * radius) + 0.4 * outline,
          [radius](const Point& p) { return rounded_plate(p, radius); }};
}

Facts faceted_disc_facts()
{
  const double outline = 24 * 0.6 * std::sin(pi / 12);
  return {"faceted_disc",
          14,
          36,
          36,
          24,
          0,
          2 * outline + 12 * 0.14,
          2 * 3 * 0.36 + 0.14 * outline,
          [](const Point& p) {
            return (std::max)({polygon(p, 12, 0.6), -p[2], p[2] - 0.14});
          }};
}

std::vector<Facts> all_facts()
{
  const double rim = std::sqrt(0.16 - 0.19 * 0.19), slope = std::hypot(0.25, 0.8);
  const double t = std::sqrt(0.09 - 0.0225);
  // the angle that the torus's tube turns by, and by Pappus' theorem its area
  const double left = 2 * pi - 2 * std::atan2(t, 0.15);
  std::vector<Facts> facts = {
    {"box", 6, 12, 12, 8, 0, 12, 5.92,
     [](const Point& p) {
       return box(p, {{-0.6, -0.5, 0}}, {{0.6, 0.5, 0.8}});
     }},
    {"cylinder", 3, 2, 2, 0, 2, 2 * pi, 1.5 * pi,
     [](const Point& p) {
       return (std::max)({cylinder_z(p, 0, 0, 0.5), -p[2], p[2] - 1});
     }},
    {"frustum", 3, 2, 2, 0, 2, 1.9 * pi, pi * (0.36 + 0.1225 + 0.95 * slope), frustum},
    {"box_with_hole", 7, 14, 14, 8, 2, 11.2 + 1.2 * pi, 5.04 - 0.18 * pi + 0.36 * pi,
     [](const Point& p) {
       return (std::max)(box(p, {{-0.6, -0.5, 0}}, {{0.6, 0.5, 0.6}}), -cylinder_z(p, 0.1, 0, 0.3));
     }},
    {"l_bracket", 10, 22, 22, 12, 4, 2 * 4.2 + 6 * 0.8 + pi * 1.52,
     2 * (0.275 + 0.1875) + 4.2 * 0.8 + 2 * pi * (0.25 * 0.38 - 0.04 - 0.0324), bracket},
    {"nut", 9, 20, 20, 12, 2, 8.4 + 3 + 1.44 * pi,
     2 * (1.5 * std::sqrt(3.) * 0.49 - pi * 0.1296) + 0.5 * (4.2 + 0.72 * pi),
     [](const Point& p) {
       return (std::max)({polygon(p, 6, 0.7), -cylinder_z(p, 0, 0, 0.36), -p[2], p[2] - 0.5});
     }},
    wedge_facts("wedge", 30),
    wedge_facts("wedge_15", 15),
    wedge_facts("wedge_30", 30),
    wedge_facts("wedge_60", 60),
    {"dimple", 7, 13, 13, 8, 1, 10.8 + 2 * pi * rim, 4.6 - pi * rim * rim + 2 * pi * 0.4 * 0.21,
     [](const Point& p) {
       return (std::max)(box(p, {{-0.6, -0.5, 0}}, {{0.6, 0.5, 0.5}}), 0.4 - distance(p, {{0, 0, 0.69}}));
     }},
    {"inscribed_boss", 8, 14, 14, 8, 2, 8 + 1.6 + 2 * pi, 3.6 + 0.4 * pi,
     [](const Point& p) {
       return (std::min)(box(p, {{-0.5, -0.5, 0}}, {{0.5, 0.5, 0.4}}),
                         (std::max)({cylinder_z(p, 0, 0, 0.5), -p[2], p[2] - 0.8}));
     }},
    {"crossing_cylinders", 7, 6, 6, 0, 6, 1.6 * pi + pi + 2 * crossing_length(0.4, 0.25),
     2 * pi * 0.16 + 1.2 * pi + 2 * pi * 0.0625 - 2 * window_area(0.4, 0.25) + 2 * stub_area(0.4, 0.25, 0.85),
     crossing},
    {"u_channel", 10, 24, 24, 16, 0, 2 * 4.7 + 8 * 1.2, 2 * (0.8 - 0.275) + 4.7 * 1.2,
     [](const Point& p) {
       return (std::max)(box(p, {{0, 0, 0}}, {{1, 1.2, 0.8}}), -box(p, {{0.25, -9, 0.25}}, {{0.75, 9, 9}}));
     }},
    {"slotted_plate", 10, 14, 20, 8, 2, 4 * 2.6 + 4 * 0.3 + 2 * (1.6 + 0.44 * pi),
     2 * (1.6 - 0.352 - pi * 0.0484) + 0.3 * (5.2 + 1.6 + 0.44 * pi), slotted_plate},
    {"thin_plate", 6, 12, 12, 8, 0, 8.4 + 0.16, 2.16 + 4.2 * 0.04,
     [](const Point& p) { return box(p, {{-0.6, -0.45, 0}}, {{0.6, 0.45, 0.04}}); }},
    {"torus", 2, 2, 2, 0, 2, 2.4 * pi, pi * ((0.6 + t) * (0.6 + t) - (0.6 - t) * (0.6 - t)) + 2 * pi * 0.6 * 0.3 * left,
     torus},
    gear_facts(),
    flange_facts(),
    elliptic_cut_facts(),
    oblique_hole_facts(),
    rounded_plate_facts(0.02),
    faceted_disc_facts()};
  return facts;
}

// ---- checks

bool is_near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

void check_truth(const Facts& facts, const Solid& solid)
{
  const Ground_truth truth = ground_truth(solid, 0.02);
  assert(solid.faces.size() == facts.faces);
  assert(truth.curves.size() == facts.curves);
  assert(truth.segments.size() == facts.segments);
  assert(truth.corners.size() == facts.corners);
  double length = 0, polyline = 0;
  std::size_t closed = 0, open = 0;
  for (const True_curve& curve : truth.curves)
  {
    length += curve.length;
    (curve.is_closed ? closed : open) += 1;
    assert(!curve.is_closed || curve.points.front() == curve.points.back());
    for (std::size_t i = 1; i < curve.points.size(); ++i)
    {
      const double step = distance(curve.points[i - 1], curve.points[i]);
      assert(step > 0 && step < 0.25 * 0.02 * (1 + 1e-5));
      polyline += step;
    }
    for (const Point& p : curve.points)
      assert(std::abs(facts.surface(p)) < 1e-9);
  }
  assert(closed == facts.closed);
  assert(is_near(length, facts.length, 1e-6 * facts.length));
  assert(is_near(polyline, facts.length, 1e-4 * facts.length));
  // three curves meet at every corner of these solids
  assert(2 * open == 3 * truth.corners.size());
  assert(is_near(solid.area(), facts.area, 1e-4 * facts.area));
}

double smallest_radius(const Solid& solid)
{
  double radius = 0.15; // no curve without a radius bends more
  for (const Curve& curve : solid.curves)
    if (curve.kind == Curve_kind::CIRCLE || curve.kind == Curve_kind::ARC)
      radius = (std::min)(radius, curve.radius);
  return radius;
}

/// The nearest of the sampled points of the curves that count: not less than the exact distance, hardly more.
void check_distances(const Solid& solid, const Cloud& cloud, bool is_all)
{
  std::vector<std::vector<Point>> samples;
  const double step = 0.1 * cloud.sampling_distance, radius = smallest_radius(solid);
  for (const Curve& curve : solid.curves)
    samples.push_back(curve.is_sharp ? curve.sampled(step) : std::vector<Point>());
  for (std::size_t i = 0; i < cloud.points.size(); i += 61)
  {
    std::vector<std::size_t> counting = solid.sharp_curves();
    if (!is_all)
      counting = solid.curves_around(cloud.faces[i]);
    double least = 50 * cloud.sampling_distance;
    for (std::size_t c : counting)
      for (const Point& p : samples[c])
        least = (std::min)(least, distance(p, cloud.points[i]));
    const double d = cloud.exact_distances[i];
    assert(d <= least + 1e-12);
    // outside a circle of radius R the samples are farther by the factor 1 + d / R
    assert(d * d >= least * least - 0.26 * step * step * (1 + d / radius));
  }
}

double mean_nearest_neighbour(const Cloud& cloud)
{
  const double r = cloud.sampling_distance;
  Point_grid grid(2 * r, cloud.points.size());
  for (const Point& p : cloud.points)
    grid.add(p);
  double sum = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    double best = 9 * r * r;
    grid.visit_ball(cloud.points[i], 3 * r, [&](std::size_t j, double d) {
      if (j != i)
        best = (std::min)(best, d);
      return true;
    });
    sum += std::sqrt(best);
  }
  return sum / static_cast<double>(cloud.points.size());
}

void check_points(const Facts& facts, const Solid& solid, const Cloud& cloud, bool is_poisson)
{
  const double r = cloud.sampling_distance, n = static_cast<double>(cloud.points.size());
  assert(cloud.faces.size() == cloud.points.size() && cloud.distances.size() == cloud.points.size());
  for (const Point& p : cloud.points)
    assert(std::abs(facts.surface(p)) < 1e-9);
  assert(is_near(n, 0.82 * facts.area / (r * r), 0.03 * n));
  if (is_poisson)
    assert(is_near(mean_nearest_neighbour(cloud), r, 0.05 * r));
  // every face has its share
  std::vector<double> counts(solid.faces.size(), 0.);
  for (std::uint32_t face : cloud.faces)
    counts[face] += 1;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const double wanted = 0.82 * solid.faces[i].area / (r * r);
    assert(
      is_near(counts[i], wanted, is_poisson ? 4 + 0.06 * wanted + 1.5 * std::sqrt(wanted) : 5 * std::sqrt(wanted)));
  }
}

/// Of the errors of the points between 0.5 and 3 r from an edge, the given quantile.
double near_quantile(const Cloud& cloud, double quantile)
{
  const double r = cloud.sampling_distance;
  std::vector<double> errors;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    if (cloud.exact_distances[i] > 0.5 * r && cloud.exact_distances[i] < 3 * r)
      errors.push_back((cloud.distances[i] - cloud.exact_distances[i]) / r);
  std::sort(errors.begin(), errors.end());
  return errors[static_cast<std::size_t>(quantile * static_cast<double>(errors.size() - 1))];
}

void check_field(const Cloud& exact, Field_kind kind)
{
  Cloud cloud = exact;
  disturb(cloud, kind, -1, 3);
  const bool is_noisy = kind == Field_kind::NOISY;
  const Field_statistics statistics = field_statistics(cloud);
  const double rms = is_noisy ? 1.9 : 1.1, share = is_noisy ? 0.35 : 0.20, half = is_noisy ? 0.36 : 0.20;
  assert(is_near(statistics.root_mean_square, rms, 0.1 * rms));
  assert(statistics.share_off > share - 0.04 && statistics.share_off < share + 0.02);
  assert(near_quantile(cloud, 0.25) < -0.5 * half && near_quantile(cloud, 0.25) > -1.5 * half);
  assert(near_quantile(cloud, 0.75) > 0.5 * half && near_quantile(cloud, 0.75) < 1.5 * half);
  for (double d : cloud.distances)
    assert(d >= 0 && d <= cloud.truncation * cloud.sampling_distance);

  double moved = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    moved += squared_distance(cloud.points[i], exact.points[i]);
  moved = std::sqrt(moved / (3. * static_cast<double>(cloud.points.size()))) / cloud.sampling_distance;
  assert(is_near(moved, is_noisy ? 0.25 : 0., is_noisy ? 0.01 : 0.));
}

void check_wrong_patches()
{
  // large errors are mostly those of the wrong patches: missed edges make the field larger, spurious smaller
  Sampling_options options;
  options.sampling_distance = 0.01;
  options.field = Field_kind::DEF;
  const Cloud cloud = sample(make_solid("box"), options);
  std::size_t off = 0, too_large = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
  {
    const double error = (cloud.distances[i] - cloud.exact_distances[i]) / cloud.sampling_distance;
    off += std::abs(error) > 2.5 ? 1 : 0;
    too_large += error > 2.5 ? 1 : 0;
  }
  const double share = static_cast<double>(off) / static_cast<double>(cloud.points.size());
  assert(share > 0.02 && share < 0.07);
  assert(too_large > off / 10 && too_large < off);
}

bool are_equal(const Cloud& a, const Cloud& b)
{
  return a.points == b.points && a.distances == b.distances && a.faces == b.faces;
}

void check_determinism()
{
  const Solid solid = make_solid("frustum");
  for (Sampling sampling : {Sampling::POISSON, Sampling::UNIFORM})
  {
    Sampling_options options;
    options.sampling_distance = 0.04;
    options.sampling = sampling;
    options.field = Field_kind::NOISY;
    const Cloud a = sample(solid, options);
    assert(are_equal(a, sample(make_solid("frustum"), options)));
    options.seed = 2;
    assert(!are_equal(a, sample(solid, options)));
  }
  // the engine's numbers are specified, and the transforms are ours: the same everywhere
  Random random(1);
  const double first = random.uniform();
  Random again(1);
  assert(first == again.uniform() && first != random.uniform());
  assert(Random(1, 1).uniform() != first);
}

void check_random_numbers()
{
  Random random(5);
  const int n = 200000;
  double sum = 0, squares = 0, inside = 0;
  for (int i = 0; i < n; ++i)
  {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    inside += std::abs(random.student_3()) < 0.7649 ? 1 : 0; // the quartile of Student's t
  }
  assert(is_near(sum / n, 0, 0.01) && is_near(squares / n, 1, 0.02) && is_near(inside / n, 0.5, 0.006));
}

void check_scopes()
{
  const Solid solid = make_solid("thin_plate");
  Sampling_options options;
  const Cloud adjacent = sample(solid, options);
  options.scope = Field_scope::ALL;
  const Cloud all = sample(solid, options);
  assert(adjacent.points == all.points);
  check_distances(solid, all, true);

  // on a U the nearest edge of all may be on the other side of a wall, where the adjacent faces' are not
  const Solid channel = make_solid("u_channel");
  const Cloud near = sample(channel, options);
  options.scope = Field_scope::ADJACENT;
  const Cloud whole = sample(channel, options);
  options.truncation = 5;
  const Cloud cut = sample(channel, options);
  bool differs = false;
  for (std::size_t i = 0; i < near.points.size(); ++i)
  {
    assert(near.distances[i] <= whole.distances[i]);
    assert(cut.distances[i] == (std::min)(whole.distances[i], 5 * 0.02));
    differs = differs || near.distances[i] < whole.distances[i] - 0.02;
  }
  assert(differs);
}

bool is_refused(const std::string& name, const Solid_options& options = Solid_options())
{
  try
  {
    make_solid(name, options);
  }
  catch (const std::invalid_argument&)
  {
    return true;
  }
  return false;
}

void check_options()
{
  Solid_options options;
  options.angle = 90;
  const Solid solid = make_solid("wedge", options);
  assert(is_near(solid.area(), wedge_facts("wedge", 90).area, 1e-9));
  for (double angle : {4., 171., std::nan("")})
  {
    options.angle = angle;
    assert(is_refused("wedge", options));
  }
  options.radius = 3;
  options.sampling_distance = 0.01;
  check_truth(rounded_plate_facts(0.03), make_solid("rounded_plate", options));
  for (double radius : {0., 11., std::nan("")})
  {
    options.radius = radius;
    assert(is_refused("rounded_plate", options));
  }
  assert(is_refused("teapot"));
}

/// The kinds of the true curves and of their parts.
void check_kinds()
{
  const auto count = [](const std::vector<True_curve>& curves, Curve_kind kind) {
    return std::count_if(curves.begin(), curves.end(), [kind](const True_curve& c) { return c.kind == kind; });
  };
  assert(count(ground_truth(make_solid("flange"), 0.02).segments, Curve_kind::CIRCLE) == 16);
  const Ground_truth cut = ground_truth(make_solid("elliptic_cut"), 0.02);
  assert(count(cut.segments, Curve_kind::CIRCLE) == 1 && count(cut.segments, Curve_kind::ELLIPSE) == 1);
  const Ground_truth hole = ground_truth(make_solid("oblique_hole"), 0.02);
  assert(count(hole.segments, Curve_kind::LINE) == 12 && count(hole.segments, Curve_kind::ELLIPSE) == 2);
  const Ground_truth plate = ground_truth(make_solid("rounded_plate"), 0.02);
  assert(count(plate.segments, Curve_kind::LINE) == 8 && count(plate.segments, Curve_kind::ARC) == 8);
  assert(count(plate.curves, Curve_kind::COMPOSITE) == 2);
}

void check_output()
{
  const Solid solid = make_solid("slotted_plate");
  Sampling_options options;
  options.sampling_distance = 0.05;
  Cloud cloud = sample(solid, options);
  Ground_truth truth = ground_truth(solid, 0.05);
  scale(cloud, 10);
  scale(truth, 10);
  assert(is_near(truth.sampling_distance, 0.5, 1e-12) && is_near(cloud.sampling_distance, 0.5, 1e-12));
  std::size_t composite = 0;
  for (const True_curve& curve : truth.curves)
    if (curve.kind == Curve_kind::COMPOSITE)
    {
      ++composite;
      assert(curve.is_closed && is_near(curve.length, 10 * (1.6 + 0.44 * pi), 1e-9));
    }
  assert(composite == 2);

  std::ostringstream ply;
  assert(write_ply(ply, cloud));
  const std::string text = ply.str(), mark = "end_header\n";
  const std::size_t header = text.find(mark) + mark.size();
  assert(text.find("comment sampling distance 0.5\n") < header);
  assert(text.find("element vertex " + std::to_string(cloud.points.size()) + "\n") < header);
  assert(text.size() == header + 16 * cloud.points.size());
  const unsigned char* last = reinterpret_cast<const unsigned char*>(text.data()) + text.size() - 4;
  const std::uint32_t bits =
    last[0] | (std::uint32_t(last[1]) << 8) | (std::uint32_t(last[2]) << 16) | (std::uint32_t(last[3]) << 24);
  float value;
  std::memcpy(&value, &bits, 4);
  assert(value == static_cast<float>(cloud.distances.back()));

  std::ostringstream json;
  assert(write_truth(json, truth, "slotted_plate", cloud.points.size()));
  assert(json.str().find("\"r\": 0.5,") != std::string::npos);
  assert(json.str().find("\"kind\": \"composite\", \"closed\": true") != std::string::npos);
}

} // namespace

int main()
{
  const std::vector<Facts> facts = all_facts();
  assert(facts.size() == solid_names().size());
  for (std::size_t i = 0; i < facts.size(); ++i)
  {
    assert(facts[i].name == solid_names()[i].first);
    const Solid solid = make_solid(facts[i].name);
    check_truth(facts[i], solid);
    Sampling_options options;
    options.seed = 7;
    const Cloud cloud = sample(solid, options);
    check_points(facts[i], solid, cloud, true);
    check_distances(solid, cloud, false);
    check_field(cloud, Field_kind::DEF);
    check_field(cloud, Field_kind::NOISY);
    options.sampling = Sampling::UNIFORM;
    check_points(facts[i], solid, sample(solid, options), false);
  }
  check_wrong_patches();
  check_determinism();
  check_random_numbers();
  check_scopes();
  check_options();
  check_kinds();
  check_output();
  return 0;
}
