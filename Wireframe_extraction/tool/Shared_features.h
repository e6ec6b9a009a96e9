// What circles and arcs of a wireframe have in common, as a table: equal diameters, a common axis, bolt circles.

#ifndef EXTRACT_WIREFRAME_SHARED_FEATURES_H
#define EXTRACT_WIREFRAME_SHARED_FEATURES_H

#include "Kernel.h"

#include <CGAL/Wireframe_extraction/IO/internal/wireframe/wireframe_tools.h>
#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/text_tools.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_regularities.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

// Finds them with the bounds of --regularize: three standard deviations, and at least 0.02 and at most 0.3 sampling
// distances.
class Shared_features
{
  typedef CGAL::Wireframe_extraction::internal::Vector Vector;
  typedef CGAL::Wireframe_extraction::internal::Measured_curve Measured_curve;
  typedef CGAL::Wireframe_extraction::internal::Regularity_kind Kind;
  typedef std::vector<std::size_t> Group; // places in `m_circles`

public:
  explicit Shared_features(const CGAL::Wireframe<Kernel>& wireframe)
    : m_unit(wireframe.sampling_distance > 0. ? wireframe.sampling_distance : 1.)
  {
    for (std::size_t i = 0; i < wireframe.curves.size(); ++i)
    {
      const auto& curve = wireframe.curves[i];
      if (curve.type != CGAL::Wireframe_curve_type::CIRCLE && curve.type != CGAL::Wireframe_curve_type::ARC)
        continue;
      m_curves.push_back(i);
      m_circles.push_back(measured(curve));
    }
  }

  static const char* header()
  {
    return "kind,count,diameter,center_x,center_y,center_z,axis_x,axis_y,axis_z,deviation,curves\r\n";
  }

  void write(std::ostream& out) const
  {
    out << header();
    const auto regularities = CGAL::Wireframe_extraction::internal::Regularity_finder(m_circles).run();
    const std::vector<Group> equal = groups(regularities, Kind::EQUAL_RADII),
                             coaxial = groups(regularities, Kind::COAXIAL);
    for (const Group& group : equal)
      write_equal(out, group);
    for (const Group& group : coaxial)
      write_coaxial(out, group);
    for (const Group& group : equal)
      for (const Group& level : by_plane(group))
        write_bolt_circle(out, level);
  }

private:
  static constexpr double least_length = 0.02, most_length = 0.3; // in sampling distances, as of regularities
  static constexpr double number_of_deviations = 3.;
  static constexpr std::size_t least_bolts = 3; // that determine a circle

  Measured_curve measured(const CGAL::Wireframe_curve<Kernel>& curve) const
  {
    const auto& conic = *curve.conic;
    Measured_curve circle;
    circle.curve.kind = CGAL::Wireframe_extraction::internal::Primitive_kind::CIRCLE;
    circle.curve.center = Vector(conic.center.x(), conic.center.y(), conic.center.z()) / m_unit;
    circle.curve.axis = Vector(conic.axis.x(), conic.axis.y(), conic.axis.z());
    circle.curve.major_radius = circle.curve.minor_radius = conic.major_radius / m_unit;
    circle.position_deviation = curve.uncertainty.position / m_unit;
    circle.direction_deviation = curve.uncertainty.direction;
    circle.radius_deviation = curve.uncertainty.major_radius / m_unit;
    return circle;
  }

  // those that are more than one, each in ascending order, and in the order of their first curves
  std::vector<Group> groups(const std::vector<CGAL::Wireframe_extraction::internal::Regularity>& regularities,
                            Kind kind) const
  {
    std::vector<std::size_t> leader(m_circles.size());
    std::iota(leader.begin(), leader.end(), std::size_t(0));
    for (const auto& regularity : regularities)
      if (regularity.kind == kind)
        leader[regularity.curves[1]] = regularity.curves[0];
    std::map<std::size_t, Group> members;
    for (std::size_t i = 0; i < leader.size(); ++i)
      members[leader[i]].push_back(i);
    std::vector<Group> result;
    for (const auto& group : members)
      if (group.second.size() > 1)
        result.push_back(group.second);
    std::sort(result.begin(), result.end());
    return result;
  }

  // circles with parallel axes whose centers are in one plane across these
  std::vector<Group> by_plane(const Group& group) const
  {
    std::vector<Group> levels;
    for (const std::size_t i : group)
    {
      const auto level = std::find_if(levels.begin(), levels.end(), [&](const Group& members) {
        const auto &first = m_circles[members.front()].curve, &other = m_circles[i].curve;
        const Vector offset = other.center - first.center;
        return first.axis.cross(other.axis).norm() < most_angle
          && std::abs(offset.dot(first.axis)) < bound(members.front(), i) + most_angle * offset.norm() * 0.1;
      });
      if (level == levels.end())
        levels.push_back({i});
      else if (std::none_of(level->begin(), level->end(), [&](std::size_t j) {
                 return (m_circles[j].curve.center - m_circles[i].curve.center).norm() < bound(i, j);
               }))
        level->push_back(i); // the arcs of one hole are one bolt
    }
    return levels;
  }

  double bound(std::size_t i, std::size_t j) const
  {
    return (std::min)(
      most_length,
      (std::max)(least_length,
                 number_of_deviations * std::hypot(m_circles[i].position_deviation, m_circles[j].position_deviation)));
  }

  double mean_radius(const Group& group) const
  {
    double sum = 0.;
    for (const std::size_t i : group)
      sum += m_circles[i].curve.major_radius;
    return sum / double(group.size());
  }

  void write_equal(std::ostream& out, const Group& group) const
  {
    const double radius = mean_radius(group);
    double deviation = 0.;
    for (const std::size_t i : group)
      deviation = (std::max)(deviation, std::abs(m_circles[i].curve.major_radius - radius));
    write_row(out, "equal_diameter", group, 2. * radius, nullptr, nullptr, deviation);
  }

  // the middle of the centers; the diameter only if all have the same
  void write_coaxial(std::ostream& out, const Group& group) const
  {
    const Vector axis = m_circles[group.front()].curve.axis;
    Vector center(0., 0., 0.);
    for (const std::size_t i : group)
      center = center + m_circles[i].curve.center / double(group.size());
    double deviation = 0., spread = 0.;
    const double radius = mean_radius(group);
    for (const std::size_t i : group)
    {
      const Vector offset = m_circles[i].curve.center - center;
      deviation = (std::max)(deviation, (offset - offset.dot(axis) * axis).norm());
      spread = (std::max)(spread, std::abs(m_circles[i].curve.major_radius - radius));
    }
    write_row(out, "coaxial", group, spread < least_length ? 2. * radius : 0., &center, &axis, deviation);
  }

  // Three holes or more at equal angles on a circle; its center is the mean of theirs, then.
  void write_bolt_circle(std::ostream& out, const Group& group) const
  {
    if (group.size() < least_bolts)
      return;
    const Vector axis = m_circles[group.front()].curve.axis;
    Vector center(0., 0., 0.);
    for (const std::size_t i : group)
      center = center + m_circles[i].curve.center / double(group.size());
    double radius = 0.;
    for (const std::size_t i : group)
      radius += (m_circles[i].curve.center - center).norm() / double(group.size());
    const Vector x = (m_circles[group.front()].curve.center - center) / radius, y = axis.cross(x);
    std::vector<double> angles;
    double deviation = 0., most = 0.;
    for (const std::size_t i : group)
    {
      const Vector offset = m_circles[i].curve.center - center;
      double angle = std::atan2(offset.dot(y), offset.dot(x));
      angle += angle < -1e-6 ? 2. * CGAL_PI : 0.;
      angles.push_back(angle);
      deviation = (std::max)(deviation, std::abs(offset.norm() - radius));
      most = (std::max)(most, bound(i, group.front()));
    }
    std::sort(angles.begin(), angles.end());
    for (std::size_t k = 0; k < angles.size(); ++k)
      deviation =
        (std::max)(deviation, radius * std::abs(angles[k] - 2. * CGAL_PI * double(k) / double(angles.size())));
    if (deviation < most)
      write_row(out, "bolt_circle", group, 2. * radius, &center, &axis, deviation);
  }

  // a diameter of 0 is none
  void write_row(std::ostream& out, const char* kind, const Group& group, double diameter, const Vector* center,
                 const Vector* axis, double deviation) const
  {
    using CGAL::IO::internal::number_to_string;
    out << kind << ',' << group.size() << ',' << (diameter > 0. ? number_to_string(diameter * m_unit) : std::string());
    for (const Vector* const vector : {center, axis})
      for (std::size_t k = 0; k < 3; ++k)
        out << ','
            << (vector == nullptr ? std::string() : number_to_string((*vector)[k] * (vector == center ? m_unit : 1.)));
    out << ',' << number_to_string(deviation * m_unit) << ',';
    for (std::size_t k = 0; k < group.size(); ++k)
      out << (k == 0 ? "" : " ") << m_curves[group[k]];
    out << "\r\n";
  }

  static constexpr double most_angle = 0.05; // between axes, in radians, as of regularities

  double m_unit;                         // the sampling distance
  std::vector<std::size_t> m_curves;     // of the circles, their indices in the wireframe
  std::vector<Measured_curve> m_circles; // in sampling distances
};

} // namespace tool

#endif // EXTRACT_WIREFRAME_SHARED_FEATURES_H
