// A small wireframe with a line, splines, an arc and a circle, some of them closed.

#ifndef THETA_WIREFRAME_H
#define THETA_WIREFRAME_H

#include <CGAL/Wireframe_extraction/Wireframe.h>

#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstddef>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;

inline CGAL::Wireframe<Kernel> theta_wireframe()
{
  typedef CGAL::Wireframe_curve<Kernel> Curve;
  typedef Curve::Spline Spline;
  CGAL::Wireframe<Kernel> wireframe;
  wireframe.sampling_distance = 0.4;
  wireframe.vertices = {Point(0, 0, 0), Point(1, 0, 0)};
  const auto add = [&wireframe](CGAL::Wireframe_curve_type type, const Spline& spline, std::size_t source,
                                std::size_t target) {
    Curve curve;
    curve.type = type;
    curve.spline = spline;
    curve.source = source;
    curve.target = target;
    wireframe.curves.push_back(curve);
  };
  const Point p = wireframe.vertices[0], q = wireframe.vertices[1];
  add(CGAL::Wireframe_curve_type::LINE, Spline(1, {0, 0, 1, 1}, {p, q}), 0, 1);
  add(CGAL::Wireframe_curve_type::BSPLINE, Spline(2, {0, 0, 0, 1, 1, 1}, {q, Point(0.5, 1, 0), p}), 1, 0);
  add(CGAL::Wireframe_curve_type::ARC,
      Spline(2, {0, 0, 0, 1, 1, 1}, {p, Point(0.5, -0.5, 0), q}, {1., std::sqrt(0.5), 1.}), 0, 1);
  add(CGAL::Wireframe_curve_type::BSPLINE,
      Spline(3, {0, 0, 0, 0, 1, 1, 1, 1}, {p, Point(0, 0, 3), Point(0, 3, 0), p}, true), 0, 0);
  const double w = std::sqrt(0.5);
  const std::size_t none = Curve::no_vertex;
  add(CGAL::Wireframe_curve_type::CIRCLE,
      Spline(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4},
             {Point(6, 0, 0), Point(6, 1, 0), Point(5, 1, 0), Point(4, 1, 0), Point(4, 0, 0), Point(4, -1, 0),
              Point(5, -1, 0), Point(6, -1, 0), Point(6, 0, 0)},
             {1., w, 1., w, 1., w, 1., w, 1.}, true),
      none, none);
  typedef Kernel::Vector_3 Vector;
  wireframe.curves[2].conic =
    CGAL::Wireframe_conic<Kernel>{Point(0.5, 0.5, 0), Vector(0, 0, 1), Vector(-w, -w, 0), w, w, 0, 0.5 * CGAL_PI};
  wireframe.curves[4].conic =
    CGAL::Wireframe_conic<Kernel>{Point(5, 0, 0), Vector(0, 0, 1), Vector(1, 0, 0), 1, 1, 0, 2 * CGAL_PI};
  return wireframe;
}

#endif // THETA_WIREFRAME_H
