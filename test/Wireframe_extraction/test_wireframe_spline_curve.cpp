// Spline_curve_3: points, derivatives, pieces and knots of open, closed and degenerate curves.

#include <CGAL/Wireframe_extraction/Spline_curve_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include "minimal_traits.h"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace {

const double pi = std::acos(-1.);

typedef std::array<double, 3> Triple;

template <class Point>
Triple triple(const Point& p)
{
  return Triple{p.x(), p.y(), p.z()};
}

Triple triple(const double* p) { return Triple{p[0], p[1], p[2]}; }
Triple triple(const Minimal_point& p) { return triple(p.coordinates); }
Triple triple(const Minimal_vector& v) { return triple(v.coordinates); }

double distance(const Triple& a, const Triple& b)
{
  double sum = 0.;
  for (int i = 0; i < 3; ++i)
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

template <class P, class Q>
double distance(const P& p, const Q& q)
{
  return distance(triple(p), triple(q));
}

double norm(const Triple& a) { return distance(a, Triple{0., 0., 0.}); }

bool is_near(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

// in units of the tolerance, relative to the size of the expected vector
bool is_near(const Triple& a, const Triple& b, double tolerance)
{
  return distance(a, b) <= tolerance * (1. + norm(b));
}

template <class Traits>
struct Tester
{
  typedef CGAL::Spline_curve_3<Traits> Spline;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point_3 Point_3;
  typedef typename Traits::Vector_3 Vector_3;
  typedef std::vector<FT> Numbers;
  typedef std::vector<Point_3> Points;

  static Point_3 point(double x, double y, double z) { return Point_3(x, y, z); }

  // knots of random distances and multiplicities, clamped or not, and random control points and weights
  static Spline random_spline(std::mt19937& random, std::size_t degree, std::size_t number_of_spans, bool is_rational,
                              bool is_clamped)
  {
    std::uniform_real_distribution<double> unit(0., 1.);
    Numbers knots;
    double knot = -1.;
    for (std::size_t i = 0; i <= degree; ++i)
      knots.push_back(is_clamped ? knot : knot += unit(random));
    for (std::size_t span = 1; span < number_of_spans; ++span)
    {
      knot += 0.1 + unit(random);
      knots.insert(knots.end(), 1 + random() % degree, knot);
    }
    knot += 0.1 + unit(random);
    for (std::size_t i = 0; i <= degree; ++i)
      knots.push_back(is_clamped ? knot : knot += unit(random));

    Points points;
    Numbers weights;
    for (std::size_t i = 0; i + degree + 1 < knots.size(); ++i)
    {
      points.push_back(point(unit(random), unit(random), unit(random)));
      if (is_rational)
        weights.push_back(0.2 + 3. * unit(random));
    }
    return Spline(degree, knots, points, weights);
  }

  static double at(const Spline& s, double fraction)
  {
    return s.parameter_range().first + fraction * (s.parameter_range().second - s.parameter_range().first);
  }

  static Spline quarter_circle(double radius, const Triple& center)
  {
    const double x = center[0], y = center[1], z = center[2];
    return Spline(2, {0., 0., 0., 1., 1., 1.},
                  {point(x + radius, y, z), point(x + radius, y + radius, z), point(x, y + radius, z)},
                  {1., std::sqrt(0.5), 1.});
  }

  // a full circle of four quarters, closed
  static Spline circle(double radius)
  {
    const double h = std::sqrt(0.5), r = radius;
    return Spline(2, {0., 0., 0., 1., 1., 2., 2., 3., 3., 4., 4., 4.},
                  {point(r, 0, 0), point(r, r, 0), point(0, r, 0), point(-r, r, 0), point(-r, 0, 0), point(-r, -r, 0),
                   point(0, -r, 0), point(r, -r, 0), point(r, 0, 0)},
                  {1., h, 1., h, 1., h, 1., h, 1.}, true);
  }

  static void test_access()
  {
    static_assert(std::is_same<typename Spline::Geom_traits, Traits>::value, "the traits are exported");
    const Spline empty;
    assert(empty.is_empty() && empty.degree() == 0 && empty.knots().empty() && empty.control_points().empty());
    assert(empty.weights().empty() && !empty.is_rational() && !empty.is_closed());

    const Spline arc = quarter_circle(1., Triple{0., 0., 0.});
    assert(!arc.is_empty() && arc.degree() == 2 && arc.knots().size() == 6 && arc.control_points().size() == 3);
    assert(arc.is_rational() && arc.weights().size() == 3 && !arc.is_closed());
    assert(arc.parameter_range() == std::make_pair(FT(0), FT(1)));

    // a knot vector that is not clamped starts later than its first knot
    const Spline uniform(2, {0., 1., 2., 3., 4., 5., 6.},
                         {point(0, 0, 0), point(1, 0, 0), point(1, 1, 0), point(2, 1, 0)});
    assert(!uniform.is_rational() && uniform.parameter_range() == std::make_pair(FT(2), FT(4)));
    assert(is_near(triple(uniform.point(2.)), Triple{0.5, 0., 0.}, 1e-15));
    assert(is_near(triple(uniform.point(4.)), Triple{1.5, 1., 0.}, 1e-15));
  }

  static bool has_fault(std::size_t degree, const Numbers& knots, const Points& points, const Numbers& weights,
                        const std::string& part)
  {
    std::string why;
    const bool is_valid = Spline::is_valid(degree, knots, points, weights, &why);
    return !is_valid && !Spline::is_valid(degree, knots, points, weights) && why.find(part) != std::string::npos;
  }

  static void test_validity()
  {
    const double infinity = std::numeric_limits<double>::infinity();
    const Points points = {point(0, 0, 0), point(1, 0, 0), point(1, 1, 0)};
    std::string why = "untouched";
    assert(Spline::is_valid(2, {0., 0., 0., 1., 1., 1.}, points, {}, &why) && why == "untouched");
    assert(Spline::is_valid(1, {0., 0., 1., 2., 2.}, points));
    assert(Spline::is_valid(2, {0., 1., 2., 3., 4., 5.}, points, {1., 2., 3.}));

    assert(has_fault(0, {0., 1., 2., 3.}, points, {}, "degree is 0"));
    assert(has_fault(3, {0., 0., 0., 0., 1., 1., 1.}, points, {}, "there are 3"));
    assert(has_fault((std::numeric_limits<std::size_t>::max)(), {0., 1.}, points, {}, "control points"));
    assert(has_fault(1, {}, {}, {}, "there are 0"));
    assert(has_fault(2, {0., 0., 0., 1., 1.}, points, {}, "need 6 knots; there are 5"));
    assert(has_fault(1, {0., 0., 2., 1., 1.}, points, {}, "Knot 3 is smaller"));
    assert(has_fault(1, {0., 0., infinity, infinity, infinity}, points, {}, "Knot 2 is not finite"));
    assert(has_fault(1, {0., std::nan(""), 1., 1., 1.}, points, {}, "Knot 1 is not finite"));
    assert(has_fault(2, {1., 1., 1., 1., 1., 1.}, points, {}, "range of parameters is empty"));
    assert(has_fault(1, {0., 0., 1., 1., 2., 2.}, {points[0], points[1], points[2], points[0]}, {}, "Knot 3"));
    assert(has_fault(1, {0., 0., 0., 1., 1.}, points, {}, "Knot 2"));
    assert(has_fault(1, {0., 0., 1., 2., 2.}, points, {1., 1.}, "2 weights for 3"));
    assert(has_fault(1, {0., 0., 1., 2., 2.}, points, {1., 0., 1.}, "Weight 1"));
    assert(has_fault(1, {0., 0., 1., 2., 2.}, points, {1., 1., -1.}, "Weight 2"));
    assert(has_fault(1, {0., 0., 1., 2., 2.}, points, {std::nan(""), 1., 1.}, "Weight 0"));
    assert(has_fault(1, {0., 0., 1., 2., 2.}, {points[0], point(0, infinity, 0), points[2]}, {}, "point 1"));
  }

  template <class Function>
  static bool violates_precondition(const Function& function)
  {
    try
    {
      function();
    }
    catch (const CGAL::Precondition_exception&)
    {
      return true;
    }
    return false;
  }

  static void test_preconditions()
  {
    const Spline empty;
    assert(violates_precondition([&]() { empty.parameter_range(); }));
    assert(violates_precondition([&]() { empty.point(0.); }));
    assert(violates_precondition([&]() { empty.derivative(0.); }));
    assert(violates_precondition([&]() { empty.tangent(0.); }));
    assert(violates_precondition([&]() { empty.curvature(0.); }));
    assert(violates_precondition([&]() { empty.length(); }));
    assert(violates_precondition([&]() { empty.length(0., 1.); }));
    assert(violates_precondition([&]() { empty.parameter_at_length(0.); }));
    assert(violates_precondition([&]() { empty.closest_point(point(0, 0, 0)); }));
    assert(violates_precondition([&]() { empty.split(0.); }));
    assert(violates_precondition([&]() { empty.reversed(); }));
    Points points;
    std::vector<Spline> pieces;
    assert(violates_precondition([&]() { empty.sample_by_count(2, std::back_inserter(points)); }));
    assert(violates_precondition([&]() { empty.sample_by_distance(1., std::back_inserter(points)); }));
    assert(violates_precondition([&]() { empty.bezier_pieces(std::back_inserter(pieces)); }));

    const Spline line(1, {0., 0., 1., 1.}, {point(0, 0, 0), point(1, 0, 0)});
    assert(violates_precondition([&]() { line.split(0.); }));
    assert(violates_precondition([&]() { line.split(1.); }));
    assert(violates_precondition([&]() { line.split(2.); }));
    assert(violates_precondition([&]() { line.sample_by_distance(0., std::back_inserter(points)); }));
    assert(violates_precondition([&]() { line.sample_by_distance(-1., std::back_inserter(points)); }));
    assert(violates_precondition([&]() { line.sample_by_distance(1e-300, std::back_inserter(points)); }));
    assert(violates_precondition([&]() { Spline(1, {0., 0., 1.}, {point(0, 0, 0), point(1, 0, 0)}); }));
    assert(points.empty() && pieces.empty());
  }

  static void test_line()
  {
    const Spline line(1, {2., 2., 4., 4.}, {point(1, 2, 3), point(3, 5, 9)});
    assert(is_near(triple(line.point(3.)), Triple{2., 3.5, 6.}, 1e-15));
    assert(triple(line.point(2.)) == triple(point(1, 2, 3)) && triple(line.point(4.)) == triple(point(3, 5, 9)));
    // outside, the end points
    assert(triple(line.point(-10.)) == triple(point(1, 2, 3)) && triple(line.point(10.)) == triple(point(3, 5, 9)));
    assert(is_near(triple(line.derivative(2.5)), Triple{1., 1.5, 3.}, 1e-15));
    assert(is_near(triple(line.derivative(2.5, 0)), triple(line.point(2.5)), 1e-15));
    assert(triple(line.derivative(2.5, 2)) == (Triple{0., 0., 0.}));
    assert(triple(line.derivative(2.5, 7)) == (Triple{0., 0., 0.}));
    assert(is_near(triple(line.tangent(4.)), Triple{2. / 7., 3. / 7., 6. / 7.}, 1e-15));
    assert(line.curvature(2.) == 0. && line.curvature(3.3) < 1e-14);
    assert(is_near(line.length(), 7., 1e-14) && is_near(line.length(2.5, 3.), 1.75, 1e-14));
    assert(is_near(line.length(3., 2.5), 1.75, 1e-14) && line.length(3., 3.) == 0.);
    assert(is_near(line.length(-5., 3.), 3.5, 1e-14) && line.length(5., 6.) == 0.);
    assert(is_near(line.parameter_at_length(1.75), 2.5, 1e-14));
    assert(line.parameter_at_length(-1.) == 2. && line.parameter_at_length(8.) == 4.);
    const auto closest = line.closest_point(point(2 + 3, 3.5 - 2, 6));
    assert(is_near(closest.parameter, 3., 1e-14) && is_near(closest.distance, std::sqrt(13.), 1e-14));
    assert(is_near(triple(closest.point), Triple{2., 3.5, 6.}, 1e-14));
    assert(line.closest_point(point(-1, -1, -1)).parameter == 2.);
    assert(line.closest_point(point(9, 9, 99)).parameter == 4.);
  }

  static void test_quarter_circle(double radius, const Triple& center, double tolerance)
  {
    const Spline arc = quarter_circle(radius, center);
    for (int i = 0; i <= 100; ++i)
    {
      const double u = i / 100.;
      const Triple p = triple(arc.point(u));
      assert(is_near(distance(p, center), radius, tolerance * radius));
      assert(is_near(arc.curvature(u), 1. / radius, tolerance / radius));
      const Triple t = triple(arc.tangent(u));
      assert(is_near(norm(t), 1., 1e-14));
      assert(is_near(t[0] * (p[0] - center[0]) + t[1] * (p[1] - center[1]), 0., tolerance * radius));
      assert(-t[0] * (p[1] - center[1]) + t[1] * (p[0] - center[0]) > 0.);
      // its arc length is its angle
      const double angle = std::atan2(p[1] - center[1], p[0] - center[0]);
      assert(is_near(arc.length(0., u), radius * angle, 1e-10 * radius + tolerance * radius));
    }
    assert(is_near(arc.length(), pi * radius / 2., 1e-10 * pi * radius / 2.));
    assert(is_near(arc.parameter_at_length(pi * radius / 4.), 0.5, 1e-12));
    // both ends have the derivative 2 w1 / w0 (P1 - P0), of length sqrt(2) R
    assert(is_near(triple(arc.derivative(0.)), Triple{0., std::sqrt(2.) * radius, 0.}, 1e-13));
    assert(is_near(triple(arc.derivative(1.)), Triple{-std::sqrt(2.) * radius, 0., 0.}, 1e-13));
  }

  // Derivatives of every order against those of the power basis, and of a quotient of such polynomials.
  static void test_bezier()
  {
    // (t, t^2, t^3) for t from 1 to 3 is this Bezier curve by its polar form
    const Spline twisted(3, {1., 1., 1., 1., 3., 3., 3., 3.},
                         {point(1, 1, 1), point(5. / 3., 7. / 3., 3), point(7. / 3., 5, 9), point(3, 9, 27)});
    for (int i = 0; i <= 20; ++i)
    {
      const double t = 1. + i / 10.;
      assert(is_near(triple(twisted.point(t)), Triple{t, t * t, t * t * t}, 1e-14));
      assert(is_near(triple(twisted.derivative(t)), Triple{1., 2. * t, 3. * t * t}, 1e-13));
      assert(is_near(triple(twisted.derivative(t, 2)), Triple{0., 2., 6. * t}, 1e-13));
      assert(is_near(triple(twisted.derivative(t, 3)), Triple{0., 0., 6.}, 1e-13));
      assert(triple(twisted.derivative(t, 4)) == (Triple{0., 0., 0.}));
      const double speed = std::sqrt(1. + 4. * t * t + 9. * t * t * t * t);
      const double cross = std::sqrt(36. * t * t * t * t + 36. * t * t + 4.);
      assert(is_near(twisted.curvature(t), cross / (speed * speed * speed), 1e-13));
      assert(is_near(triple(twisted.tangent(t)), Triple{1. / speed, 2. * t / speed, 3. * t * t / speed}, 1e-13));
    }

    // the hyperbola (1 / t, 1, 0) for t from 1 to 2: weights 1 and 2, points 1 / 1 and 1 / 2
    const Spline hyperbola(1, {1., 1., 2., 2.}, {point(1, 1, 0), point(0.5, 1, 0)}, {1., 2.});
    for (int i = 0; i <= 10; ++i)
    {
      const double t = 1. + i / 10.;
      double expected = 1. / t;
      for (std::size_t order = 0; order < 6; ++order)
      {
        const Triple d = triple(hyperbola.derivative(t, order));
        assert(is_near(d, Triple{expected, order == 0 ? 1. : 0., 0.}, 1e-12));
        expected *= -double(order + 1) / t;
      }
    }
  }

  // Each derivative is that of the one before, by central differences inside the spans.
  static void test_derivatives(std::mt19937& random)
  {
    for (std::size_t degree = 1; degree <= 5; ++degree)
      for (int kind = 0; kind < 4; ++kind)
      {
        const Spline s = random_spline(random, degree, 4, kind % 2 == 1, kind / 2 == 1);
        for (std::size_t i = degree; i < s.control_points().size(); ++i)
        {
          const double begin = s.knots()[i], width = s.knots()[i + 1] - s.knots()[i];
          if (width < 0.01)
            continue;
          for (std::size_t order = 1; order <= 3; ++order)
          {
            const double h = 1e-5 * width, u = begin + 0.4 * width;
            const Triple after = triple(s.derivative(u + h, order - 1));
            const Triple before = triple(s.derivative(u - h, order - 1));
            Triple expected;
            for (int c = 0; c < 3; ++c)
              expected[c] = (after[c] - before[c]) / (2. * h);
            const double scale = std::pow(10. * double(degree) / width, double(order));
            assert(distance(triple(s.derivative(u, order)), expected) < 1e-6 * scale);
          }
        }
      }
  }

  static void test_polyline()
  {
    const Points corners = {point(0, 0, 0), point(3, 0, 0), point(3, 4, 0), point(3, 4, 12)};
    const Spline polyline = Spline::from_polyline(corners);
    assert(polyline.degree() == 1 && !polyline.is_closed() && polyline.control_points().size() == 4);
    assert(polyline.knots() == (Numbers{0., 0., 3., 7., 19., 19.}));
    for (std::size_t i = 0; i < 4; ++i)
      assert(triple(polyline.point(polyline.knots()[i + 1])) == triple(corners[i]));
    assert(is_near(triple(polyline.point(5.)), Triple{3., 2., 0.}, 1e-15));
    assert(is_near(polyline.length(), 19., 1e-13) && is_near(polyline.length(1., 8.), 7., 1e-13));
    // at a corner the tangent is that of the segment that follows, at the end that of the last one
    assert(is_near(triple(polyline.tangent(3.)), Triple{0., 1., 0.}, 1e-15));
    assert(is_near(triple(polyline.tangent(2.999)), Triple{1., 0., 0.}, 1e-15));
    assert(is_near(triple(polyline.tangent(19.)), Triple{0., 0., 1.}, 1e-15));

    // points without arc length of their own are left out, the ends stay
    const Spline repeated = Spline::from_polyline({corners[0], corners[0], corners[1], corners[1], corners[1]});
    assert(repeated.knots() == (Numbers{0., 0., 3., 3.}) && repeated.control_points().size() == 2);
    assert(triple(repeated.point(3.)) == triple(corners[1]));

    assert(Spline::from_polyline(Points()).is_empty());
    const Spline single = Spline::from_polyline({corners[2]});
    assert(single.control_points().size() == 2 && single.length() == 0.);
    assert(triple(single.point(0.5)) == triple(corners[2]));
    const Spline twice = Spline::from_polyline({corners[2], corners[2], corners[2]});
    assert(twice.control_points().size() == 2 && twice.length() == 0.);

    const Points triangle_corners = {point(0, 0, 0), point(3, 0, 0), point(0, 4, 0), point(0, 0, 0)};
    const Spline triangle = Spline::from_polyline(triangle_corners, true);
    assert(triangle.is_closed() && is_near(triangle.length(), 12., 1e-13));
    assert(is_near(triple(triangle.point(13.)), Triple{1., 0., 0.}, 1e-14));
  }

  // Two curves are the same between u0 and u1, with the same parameters.
  static void check_same(const Spline& a, const Spline& b, double u0, double u1)
  {
    for (int i = 0; i <= 20; ++i)
    {
      const double u = u0 + (u1 - u0) * (i / 20.);
      assert(is_near(triple(a.point(u)), triple(b.point(u)), 1e-13));
      if (i > 0 && i < 20)
        assert(distance(a.derivative(u), b.derivative(u)) < 1e-10 * (1. + norm(triple(a.derivative(u)))));
    }
  }

  static bool is_clamped(const Spline& s)
  {
    return s.knots()[0] == s.knots()[s.degree()] && s.knots().back() == s.knots()[s.control_points().size()];
  }

  static void test_pieces(std::mt19937& random)
  {
    for (std::size_t degree = 1; degree <= 6; ++degree)
      for (int kind = 0; kind < 4; ++kind)
      {
        const Spline s = random_spline(random, degree, 5, kind % 2 == 1, kind / 2 == 1);
        const double begin = s.parameter_range().first, end = s.parameter_range().second;

        std::vector<double> cuts = {at(s, 0.01), at(s, 0.37), at(s, 0.5), at(s, 0.99)};
        for (const double knot : s.knots())
          if (knot > begin && knot < end)
            cuts.push_back(knot);
        for (const double u : cuts)
        {
          const std::pair<Spline, Spline> halves = s.split(u);
          for (const Spline* half : {&halves.first, &halves.second})
          {
            assert(half->degree() == degree && half->is_rational() == s.is_rational() && !half->is_closed());
            assert(is_clamped(*half));
            assert(Spline::is_valid(degree, half->knots(), half->control_points(), half->weights()));
          }
          assert(halves.first.parameter_range() == std::make_pair(FT(begin), FT(u)));
          assert(halves.second.parameter_range() == std::make_pair(FT(u), FT(end)));
          assert(triple(halves.first.control_points().back()) == triple(halves.second.control_points().front()));
          check_same(halves.first, s, begin, u);
          check_same(halves.second, s, u, end);
        }

        std::vector<Spline> pieces;
        s.bezier_pieces(std::back_inserter(pieces));
        assert(pieces.front().parameter_range().first == begin && pieces.back().parameter_range().second == end);
        for (std::size_t i = 0; i < pieces.size(); ++i)
        {
          const Spline& piece = pieces[i];
          const std::pair<FT, FT> range = piece.parameter_range();
          assert(piece.control_points().size() == degree + 1 && is_clamped(piece));
          assert(piece.is_rational() == s.is_rational());
          check_same(piece, s, range.first, range.second);
          if (i == 0)
            continue;
          assert(range.first == pieces[i - 1].parameter_range().second);
          assert(triple(piece.control_points().front()) == triple(pieces[i - 1].control_points().back()));
        }

        const Spline back = s.reversed();
        assert(Spline::is_valid(degree, back.knots(), back.control_points(), back.weights()));
        assert(back.is_rational() == s.is_rational() && is_near(back.length(), s.length(), 1e-10 * s.length()));
        assert(back.parameter_range() == s.parameter_range());
        for (int i = 0; i <= 20; ++i)
          assert(is_near(triple(back.point(at(s, i / 20.))), triple(s.point(at(s, 1. - i / 20.))), 1e-12));
        assert(triple(back.point(begin)) == triple(s.point(end)) || !is_clamped(s));
      }
  }

  static void test_closest_point(std::mt19937& random)
  {
    std::uniform_real_distribution<double> coordinate(-0.5, 1.5);
    for (std::size_t degree = 1; degree <= 5; ++degree)
      for (int kind = 0; kind < 4; ++kind)
      {
        const Spline s = random_spline(random, degree, 4, kind % 2 == 1, kind / 2 == 1);
        const int count = 4000;
        Points samples;
        for (int i = 0; i <= count; ++i)
          samples.push_back(s.point(at(s, double(i) / count)));

        Points queries;
        std::vector<typename Spline::Closest_point> results;
        for (int i = 0; i < 60; ++i)
          queries.push_back(point(coordinate(random), coordinate(random), coordinate(random)));
        s.closest_points(queries.begin(), queries.end(), std::back_inserter(results));
        assert(results.size() == queries.size());
        for (std::size_t i = 0; i < queries.size(); ++i)
        {
          double least = std::numeric_limits<double>::infinity(), gap = 0.;
          for (std::size_t j = 0; j < samples.size(); ++j)
          {
            least = (std::min)(least, distance(samples[j], queries[i]));
            gap = j == 0 ? 0. : (std::max)(gap, distance(samples[j], samples[j - 1]));
          }
          const auto& found = results[i];
          assert(found.distance <= least + 1e-13);
          assert(found.distance >= least - gap);
          assert(is_near(distance(found.point, queries[i]), found.distance, 1e-14));
          assert(is_near(triple(s.point(found.parameter)), triple(found.point), 1e-14));
          // the curve is perpendicular to the way to the query, unless it has an end or a knot there
          const Triple t = triple(s.tangent(found.parameter));
          const Triple f = triple(found.point), q = triple(queries[i]);
          const double along = t[0] * (q[0] - f[0]) + t[1] * (q[1] - f[1]) + t[2] * (q[2] - f[2]);
          bool is_at_knot = false;
          for (const double knot : s.knots())
            is_at_knot = is_at_knot || std::abs(knot - found.parameter) < 1e-9;
          assert(std::abs(along) < 1e-7 || is_at_knot);
          const auto alone = s.closest_point(queries[i]);
          assert(alone.parameter == found.parameter && alone.distance == found.distance);
        }
        // a point of the curve is its own closest point
        for (int i = 0; i <= 10; ++i)
          assert(s.closest_point(s.point(at(s, i / 10.))).distance < 1e-12);
      }
  }

  static void check_uniform(const Spline& s, const Points& points, double length)
  {
    // the parameters of the samples are found again by their length
    const double spacing = length / double(points.size() - 1);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double u = s.parameter_at_length(spacing * double(i));
      assert(is_near(s.length(s.parameter_range().first, u), spacing * double(i), 1e-9 * length));
      assert(distance(s.point(u), points[i]) < 1e-9 * length);
      assert(i == 0 || distance(points[i], points[i - 1]) <= spacing * (1. + 1e-9));
    }
  }

  static void test_sampling(std::mt19937& random)
  {
    for (std::size_t degree = 1; degree <= 4; ++degree)
      for (int kind = 0; kind < 2; ++kind)
      {
        const Spline s = random_spline(random, degree, 4, kind == 1, true);
        const double length = s.length();
        // the length is the limit of those of inscribed polylines that have a corner at each knot
        double chords = 0.;
        for (std::size_t i = degree; i < s.control_points().size(); ++i)
        {
          const double begin = s.knots()[i], width = s.knots()[i + 1] - begin;
          for (int j = 0; j < 5000; ++j)
            chords += distance(s.point(begin + width * (j / 5000.)), s.point(begin + width * ((j + 1) / 5000.)));
        }
        assert(chords <= length * (1. + 1e-10) && chords > length * (1. - 1e-6));
        const double u = at(s, 0.3), v = at(s, 0.6);
        assert(is_near(s.length(at(s, 0.), u) + s.length(u, v) + s.length(v, at(s, 1.)), length, 1e-10 * length));

        for (const std::size_t count : {2, 3, 17})
        {
          Points points;
          s.sample_by_count(count, std::back_inserter(points));
          assert(points.size() == count);
          assert(triple(points.front()) == triple(s.control_points().front()));
          assert(triple(points.back()) == triple(s.control_points().back()));
          check_uniform(s, points, length);
        }
        Points points;
        s.sample_by_count(0, std::back_inserter(points));
        assert(points.empty());
        s.sample_by_count(1, std::back_inserter(points));
        assert(points.size() == 1 && triple(points[0]) == triple(s.control_points().front()));

        for (const double step : {2. * length, length, length / 7., length / 7.5})
        {
          points.clear();
          s.sample_by_distance(step, std::back_inserter(points));
          const std::size_t expected = step >= length ? 2 : 1 + std::size_t(std::ceil(length / step - 1e-9));
          assert(points.size() == expected);
          assert(triple(points.back()) == triple(s.control_points().back()));
          check_uniform(s, points, length);
        }
      }
  }

  static void test_closed()
  {
    const double radius = 2.;
    const Spline s = circle(radius);
    const double length = 2. * pi * radius;
    assert(s.is_closed() && is_near(s.length(), length, 1e-10 * length));
    for (int i = -30; i <= 60; ++i)
    {
      const double u = 0.1 * i;
      double inside = std::fmod(u, 4.);
      if (inside < 0.)
        inside += 4.;
      assert(is_near(triple(s.point(u)), triple(s.point(inside)), 1e-13));
      assert(is_near(triple(s.tangent(u)), triple(s.tangent(inside)), 1e-13));
    }
    assert(triple(s.point(0.)) == triple(s.point(4.)) && triple(s.point(8.)) == triple(s.point(0.)));
    assert(is_near(triple(s.tangent(0.)), triple(s.tangent(4.)), 1e-14));

    // across the seam, and over several turns
    assert(is_near(s.length(3.5, 4.5), length / 4., 1e-9) && is_near(s.length(-0.5, 0.5), length / 4., 1e-9));
    assert(is_near(s.length(0., 8.), 2. * length, 1e-9) && is_near(s.length(-4., 4.), 2. * length, 1e-9));
    assert(is_near(s.length(1., 13.), 3. * length, 1e-9) && is_near(s.length(13., 1.), 3. * length, 1e-9));
    assert(is_near(s.parameter_at_length(1.25 * length), 1., 1e-10));
    assert(is_near(s.parameter_at_length(-0.25 * length), 3., 1e-10));

    // just before and behind the seam
    for (const double angle : {-1e-3, 0., 1e-3, 1., 3., 5.})
    {
      const auto closest = s.closest_point(point(3. * std::cos(angle), 3. * std::sin(angle), 4.));
      assert(is_near(triple(closest.point), Triple{2. * std::cos(angle), 2. * std::sin(angle), 0.}, 1e-10));
      assert(is_near(closest.distance, std::sqrt(17.), 1e-13));
    }
    // every point of the circle is the closest one to its centre
    assert(is_near(s.closest_point(point(0, 0, 0)).distance, radius, 1e-14));
    assert(is_near(s.closest_point(point(0, 0, 5)).distance, std::sqrt(29.), 1e-14));

    Points points;
    s.sample_by_count(9, std::back_inserter(points));
    assert(points.size() == 9 && triple(points.front()) == triple(points.back()));
    for (int i = 0; i < 9; ++i)
      assert(is_near(triple(points[i]), Triple{2. * std::cos(i * pi / 4.), 2. * std::sin(i * pi / 4.), 0.}, 1e-10));

    const std::pair<Spline, Spline> halves = s.split(5.);
    assert(!halves.first.is_closed() && !halves.second.is_closed());
    assert(is_near(halves.first.length(), length / 4., 1e-9) && is_near(halves.second.length(), 0.75 * length, 1e-9));
    assert(s.reversed().is_closed() && is_near(triple(s.reversed().tangent(0.)), Triple{0., -1., 0.}, 1e-14));

    // a uniform periodic cubic: closed without being clamped
    Points control;
    Numbers knots;
    for (int i = 0; i < 6 + 3; ++i)
      control.push_back(point(std::cos(i * pi / 3.), std::sin(i * pi / 3.), 0.1 * (i % 6)));
    for (int i = 0; i < 6 + 3 + 4; ++i)
      knots.push_back(i);
    const Spline periodic(3, knots, control, true);
    assert(periodic.parameter_range() == std::make_pair(FT(3), FT(9)));
    for (int i = 0; i < 12; ++i)
    {
      assert(is_near(triple(periodic.point(3. + i / 2.)), triple(periodic.point(9. + i / 2.)), 1e-14));
      assert(is_near(triple(periodic.derivative(3. + i / 2., 2)), triple(periodic.derivative(9. + i / 2., 2)), 1e-13));
    }
    points.clear();
    periodic.sample_by_count(5, std::back_inserter(points));
    assert(triple(points.front()) == triple(points.back()));
  }

  static void test_degenerate()
  {
    // a point
    const Triple place = {1e3, 2e-3, 7.};
    const Points same(5, point(place[0], place[1], place[2]));
    for (const Numbers& weights : {Numbers(), Numbers{1., 2., 0.3, 4., 5.}})
    {
      const Spline s(3, {0., 0., 0., 0., 1., 2., 2., 2., 2.}, same, weights);
      assert(triple(s.point(0.7)) == place && s.length() == 0. && s.length(0.2, 1.7) == 0.);
      assert(triple(s.tangent(0.7)) == (Triple{0., 0., 0.}) && s.curvature(0.7) == 0.);
      const auto closest = s.closest_point(point(1e3, 3. + 2e-3, 11.));
      assert(is_near(closest.distance, 5., 1e-12) && triple(closest.point) == place);
      Points points;
      s.sample_by_count(4, std::back_inserter(points));
      assert(points.size() == 4);
      s.sample_by_distance(0.1, std::back_inserter(points));
      assert(points.size() == 6);
      for (const Point_3& p : points)
        assert(triple(p) == place);
      assert(s.parameter_at_length(0.) == 0.);
      assert(s.split(0.5).second.length() == 0. && s.reversed().length() == 0.);
    }

    // repeated end control points: the first derivative vanishes, tangent and curvature are limits.
    // c(t) = t^2 (0, 3, 0) + t^3 (...): the lowest term has order two
    const Spline slow(3, {0., 0., 0., 0., 1., 1., 1., 1.},
                      {point(0, 0, 0), point(0, 0, 0), point(0, 1, 0), point(1, 1, 0)});
    assert(triple(slow.derivative(0.)) == (Triple{0., 0., 0.}));
    assert(is_near(triple(slow.tangent(0.)), Triple{0., 1., 0.}, 1e-15));
    assert(is_near(triple(slow.tangent(1e-5)), Triple{0., 1., 0.}, 1e-4));
    assert(slow.curvature(0.) == (std::numeric_limits<double>::max)() && slow.curvature(1e-4) > 1e2);
    assert(is_near(triple(slow.reversed().tangent(1.)), Triple{0., -1., 0.}, 1e-15));

    // t^2 (1, 0, 0) + t^4 (0, 1, 0) is the parabola y = x^2, with curvature 2 at its apex
    const Spline parabola(4, {0., 0., 0., 0., 0., 1., 1., 1., 1., 1.},
                          {point(0, 0, 0), point(0, 0, 0), point(1. / 6., 0, 0), point(0.5, 0, 0), point(1, 1, 0)});
    assert(is_near(triple(parabola.point(0.5)), Triple{0.25, 0.0625, 0.}, 1e-15));
    assert(is_near(parabola.curvature(0.), 2., 1e-12) && is_near(parabola.curvature(1e-3), 2., 1e-4));
    // three equal points: a line in t^3
    const Spline straight(3, {0., 0., 0., 0., 1., 1., 1., 1.},
                          {point(0, 0, 0), point(0, 0, 0), point(0, 0, 0), point(0, 0, 2)});
    assert(is_near(triple(straight.tangent(0.)), Triple{0., 0., 1.}, 1e-15) && straight.curvature(0.) == 0.);
    assert(is_near(straight.length(), 2., 1e-12) && is_near(straight.parameter_at_length(0.25), 0.5, 1e-10));
    assert(is_near(triple(straight.closest_point(point(1, 0, 0.25)).point), Triple{0., 0., 0.25}, 1e-10));

    // where the curve stands still, the tangent is that with which it goes on, or at the end that before
    const Spline pause(1, {0., 0., 1., 2., 3., 4., 4.},
                       {point(0, 0, 0), point(1, 0, 0), point(1, 0, 0), point(1, 1, 0), point(1, 1, 0)});
    assert(is_near(triple(pause.tangent(1.5)), Triple{0., 1., 0.}, 1e-15));
    assert(is_near(triple(pause.tangent(3.5)), Triple{0., 1., 0.}, 1e-15));
    assert(is_near(triple(pause.tangent(4.)), Triple{0., 1., 0.}, 1e-15));
    assert(is_near(pause.length(), 2., 1e-14));
    Points points;
    pause.sample_by_count(5, std::back_inserter(points));
    assert(is_near(triple(points[1]), Triple{0.5, 0., 0.}, 1e-12)
           && is_near(triple(points[3]), Triple{1., 0.5, 0.}, 1e-12));

    // a cusp inside: (t^2, t^3) for t from -1 to 1, whose length is known
    const Spline cusp(3, {-1., -1., -1., -1., 1., 1., 1., 1.},
                      {point(1, -1, 0), point(-1. / 3., 1, 0), point(-1. / 3., -1, 0), point(1, 1, 0)});
    assert(is_near(triple(cusp.point(0.5)), Triple{0.25, 0.125, 0.}, 1e-15));
    const double branch = (std::pow(13., 1.5) - 8.) / 27.;
    assert(is_near(cusp.length(), 2. * branch, 2e-10 * branch));
    assert(is_near(cusp.length(0., 1.), branch, 1e-10 * branch));
    assert(is_near(cusp.closest_point(point(-1, 0, 0)).distance, 1., 1e-12));

    // an inner knot as often as the degree makes a corner there
    const Spline corner(
      3, {0., 0., 0., 0., 1., 1., 1., 2., 2., 2., 2.},
      {point(0, 0, 0), point(1, 0, 0), point(2, 0, 0), point(3, 0, 0), point(3, 1, 0), point(3, 2, 0), point(3, 3, 0)});
    assert(is_near(triple(corner.point(1.)), Triple{3., 0., 0.}, 1e-15) && is_near(corner.length(), 6., 1e-12));
    assert(is_near(triple(corner.tangent(1.)), Triple{0., 1., 0.}, 1e-15));
    assert(is_near(corner.closest_point(point(4, -1, 0)).parameter, 1., 1e-12));
    assert(is_near(corner.parameter_at_length(3.), 1., 1e-12));

    // far from the origin and small, the shape keeps what the coordinates hold
    const Spline far = quarter_circle(1e-3, Triple{1e3, -2e3, 5e2});
    assert(is_near(far.length(), pi * 0.5e-3, 1e-12) && is_near(far.curvature(0.3), 1e3, 1e-4));

    // knots of any scale
    const Spline scaled(2, {0., 0., 0., 1e9, 1e9, 1e9}, {point(1, 0, 0), point(1, 1, 0), point(0, 1, 0)},
                        {1., std::sqrt(0.5), 1.});
    assert(is_near(scaled.length(), pi / 2., 1e-10) && is_near(scaled.curvature(3e8), 1., 1e-12));
    assert(is_near(scaled.closest_point(point(2, 2, 0)).parameter, 5e8, 1.));
  }

  static void test_high_degree()
  {
    // a straight line in degree nine, with control points equally spaced: the identity
    Points control;
    for (int i = 0; i <= 9; ++i)
      control.push_back(point(i / 9., 0, 0));
    Numbers knots(10, FT(0));
    knots.insert(knots.end(), 10, FT(1));
    const Spline s(9, knots, control);
    for (int i = 0; i <= 10; ++i)
    {
      assert(is_near(triple(s.point(i / 10.)), Triple{i / 10., 0., 0.}, 1e-14));
      assert(is_near(s.parameter_at_length(i / 10.), i / 10., 1e-12));
      assert(is_near(s.closest_point(point(i / 10., 3, 4)).parameter, i / 10., 1e-12));
    }
    assert(is_near(triple(s.derivative(0.3, 2)), Triple{0., 0., 0.}, 1e-10));
  }

  static void run()
  {
    std::mt19937 random(7);
    test_access();
    test_validity();
    test_preconditions();
    test_line();
    test_quarter_circle(1., Triple{0., 0., 0.}, 1e-14);
    test_quarter_circle(250., Triple{3., -2., 7.}, 1e-12);
    test_bezier();
    test_derivatives(random);
    test_polyline();
    test_pieces(random);
    test_closest_point(random);
    test_sampling(random);
    test_closed();
    test_degenerate();
    test_high_degree();
  }
};

// The basis functions alone: they add up to one, their derivatives to zero.
void test_basis()
{
  using namespace CGAL::Wireframe_extraction::internal;
  const std::vector<double> knots = {0., 0., 0., 0., 1., 2., 2., 3., 3., 3., 5., 5., 5., 5.};
  assert(find_span(knots, 3, 0.) == 3 && find_span(knots, 3, -1.) == 3 && find_span(knots, 3, 1.) == 4);
  assert(find_span(knots, 3, 2.) == 6 && find_span(knots, 3, 2.999) == 6 && find_span(knots, 3, 3.) == 9);
  assert(find_span(knots, 3, 5.) == 9 && find_span(knots, 3, 6.) == 9);
  for (int i = 0; i <= 50; ++i)
  {
    const double u = i / 10.;
    double values[5 * 4];
    basis_functions(find_span(knots, 3, u), u, 3, knots, 4, values);
    for (int order = 0; order <= 4; ++order)
    {
      double sum = 0.;
      for (int j = 0; j < 4; ++j)
        sum += values[4 * order + j];
      assert(is_near(sum, order == 0 ? 1. : 0., 1e-12));
    }
    for (int j = 0; j < 4; ++j)
      assert(values[j] >= 0. && values[j] <= 1. + 1e-15 && values[4 * 4 + j] == 0.);
  }
}

} // namespace

int main()
{
  // A violated precondition is to be caught here, without its message on the screen.
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {});

  test_basis();
  Tester<CGAL::Exact_predicates_inexact_constructions_kernel>::run();
  Tester<CGAL::Simple_cartesian<double>>::run();
  Tester<Minimal_traits>::run();
  return 0;
}
