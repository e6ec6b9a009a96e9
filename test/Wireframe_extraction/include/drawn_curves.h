// Curves drawn by hand, as if they had been traced.

#ifndef DRAWN_CURVES_H
#define DRAWN_CURVES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Traced_curve.h>

#include <cstddef>
#include <vector>

// along a polyline, straight on at both ends
inline CGAL::Wireframe_extraction::internal::Traced_curve open_curve(
  const std::vector<CGAL::Wireframe_extraction::internal::Vector>& points)
{
  CGAL::Wireframe_extraction::internal::Traced_curve curve;
  curve.points = points;
  const std::size_t n = points.size();
  curve.tips[0].point = points.front();
  curve.tips[0].tangent = (points[0] - points[1]).normalized();
  curve.tips[1].point = points.back();
  curve.tips[1].tangent = (points[n - 1] - points[n - 2]).normalized();
  return curve;
}

#endif // DRAWN_CURVES_H
