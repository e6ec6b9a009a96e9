// Small wireframes, true ones and predictions, whose scores are known.

#ifndef EVALUATED_CURVES_H
#define EVALUATED_CURVES_H

#include <Wireframe_evaluation/evaluate_wireframe.h>

#include <cassert>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <vector>

using namespace Wireframe_evaluation;

const double r = 0.1;
const double pi = 3.14159265358979323846;

inline void check_near(double value, double expected, double tolerance)
{
  if (!(std::abs(value - expected) <= tolerance))
    std::cerr << value << " instead of " << expected << '\n';
  assert(std::abs(value - expected) <= tolerance);
}

inline Evaluated_curve curve(const std::vector<Point>& points, std::size_t source = Evaluated_curve::no_vertex,
                             std::size_t target = Evaluated_curve::no_vertex)
{
  Evaluated_curve result{Polyline(points)};
  result.source = source;
  result.target = target;
  return result;
}

inline std::vector<Point> arc(double radius, double begin, double end, Point center = Point(0, 0, 0))
{
  std::vector<Point> result;
  const int n = 720;
  for (int i = 0; i <= n; ++i)
  {
    const double a = begin + (end - begin) * i / n;
    result.emplace_back(center.x() + radius * std::cos(a), center.y() + radius * std::sin(a), center.z());
  }
  return result;
}

inline Evaluated_curve circle(double radius, Point center = Point(0, 0, 0))
{
  std::vector<Point> points = arc(radius, 0, 2 * pi, center);
  points.back() = points.front();
  Evaluated_curve result = curve(points);
  result.is_closed = true;
  return result;
}

inline Evaluated_curve with_kind(Evaluated_curve c, Curve_kind kind)
{
  c.kind = kind;
  return c;
}

inline True_wireframe truth_of(const std::vector<Evaluated_curve>& curves, const std::vector<Point>& corners = {})
{
  True_wireframe result;
  result.sampling_distance = r;
  result.curves = curves;
  result.corners = corners;
  return result;
}

inline Predicted_wireframe prediction_of(const std::vector<Evaluated_curve>& curves,
                                         const std::vector<Point>& vertices = {})
{
  Predicted_wireframe result;
  result.curves = curves;
  result.vertices = vertices;
  return result;
}

// the scores of curves without vertices
inline Wireframe_scores scores_of(const std::vector<Evaluated_curve>& truth,
                                  const std::vector<Evaluated_curve>& prediction)
{
  return evaluate_wireframe(truth_of(truth), prediction_of(prediction));
}

inline Evaluated_curve segment(const Point& p, const Point& q) { return curve({p, q}); }

inline void check_failed(const Wireframe_scores& s, double diagonal)
{
  assert(!s.failure.empty());
  check_near(s.chamfer_distance, diagonal, 1e-12);
  check_near(s.hausdorff_distance, diagonal, 1e-12);
  assert(s.f1_at_1r == 0 && s.f1_at_2r == 0 && s.curve_f1 == 0 && s.curve_recall == 0 && s.long_curve_recall == 0);
  assert(s.corner_recall == 0 && s.corner_precision == 0 && s.curve_count_ratio == 0);
  assert(s.squared_chamfer_unit_cube > 0 && s.averaged_hausdorff_unit_cube > 0);
}

#endif // EVALUATED_CURVES_H
