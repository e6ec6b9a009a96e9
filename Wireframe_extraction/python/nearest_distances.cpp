#include "nearest_distances.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <utility>

namespace python {
namespace {

typedef Wireframe::Curve::Spline Spline;

constexpr double infinity = (std::numeric_limits<double>::infinity)();

// a curve lies in the box of its control points
CGAL::Bbox_3 box_of(const Spline& spline)
{
  CGAL::Bbox_3 box;
  for (const Point& p : spline.control_points())
    box += p.bbox();
  return box;
}

double least_distance(const CGAL::Bbox_3& box, const Point& p)
{
  double squares = 0.;
  for (int k = 0; k < 3; ++k)
  {
    const double outside = (std::max)({(box.min)(k)-p[k], p[k] - (box.max)(k), 0.});
    squares += outside * outside;
  }
  return std::sqrt(squares);
}

class Nearest_curves
{
public:
  Nearest_curves(const Wireframe& wireframe, const std::vector<Point>& points)
    : m_wireframe(wireframe), m_points(points), m_distances(points.size(), infinity)
  {
    for (const Wireframe::Curve& curve : wireframe.curves)
      m_boxes.push_back(box_of(curve.spline));
  }

  // First the curve with the nearest box, then those whose boxes are nearer than what was found.
  std::vector<double> operator()()
  {
    std::vector<std::vector<std::size_t>> queries(m_boxes.size());
    if (!m_boxes.empty())
      for (std::size_t i = 0; i < m_points.size(); ++i)
        queries[nearest_box(m_points[i])].push_back(i);
    for (std::size_t c = 0; c < m_boxes.size(); ++c)
      look_at(c, queries[c]);
    const std::vector<std::vector<std::size_t>> done = std::move(queries);
    std::vector<bool> is_done(m_points.size());
    for (std::size_t c = 0; c < m_boxes.size(); ++c)
      look_at(c, not_farther(c, done[c], is_done));
    return std::move(m_distances);
  }

private:
  std::size_t nearest_box(const Point& p) const
  {
    std::size_t nearest = 0;
    double least = infinity;
    for (std::size_t c = 0; c < m_boxes.size(); ++c)
      if (const double distance = least_distance(m_boxes[c], p); distance < least)
      {
        least = distance;
        nearest = c;
      }
    return nearest;
  }

  std::vector<std::size_t> not_farther(std::size_t c, const std::vector<std::size_t>& done, std::vector<bool>& is_done)
  {
    for (const std::size_t i : done)
      is_done[i] = true;
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      if (!is_done[i] && least_distance(m_boxes[c], m_points[i]) < m_distances[i])
        result.push_back(i);
    for (const std::size_t i : done)
      is_done[i] = false;
    return result;
  }

  void look_at(std::size_t c, const std::vector<std::size_t>& queries)
  {
    std::vector<Point> points;
    for (const std::size_t i : queries)
      points.push_back(m_points[i]);
    std::vector<Spline::Closest_point> found;
    m_wireframe.curves[c].spline.closest_points(points.begin(), points.end(), std::back_inserter(found));
    for (std::size_t k = 0; k < queries.size(); ++k)
      m_distances[queries[k]] = (std::min)(m_distances[queries[k]], found[k].distance);
  }

  const Wireframe& m_wireframe;
  const std::vector<Point>& m_points;
  std::vector<CGAL::Bbox_3> m_boxes;
  std::vector<double> m_distances;
};

} // namespace

std::vector<double> nearest_distances(const Wireframe& wireframe, const std::vector<Point>& points)
{
  return Nearest_curves(wireframe, points)();
}

} // namespace python
