// Copyright (c) 2026 The Wireframe_extraction authors.
// All rights reserved.
//
// This file is part of Wireframe_extraction, a package in the conventions of CGAL (www.cgal.org).
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Wireframe_extraction authors

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_ACCESS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_ACCESS_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/parameters.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {

template <class Point, class Vector>
class Point_set_3;

namespace Wireframe_extraction {
namespace internal {

// what a cloud without distances has as map
struct No_distances
{};

// The distances of a point set: its property map `distance`, if it has one.
template <class PointSet>
class Distances_of_point_set
{
  typedef decltype(std::declval<const PointSet&>().template property_map<double>("distance")) Found;

  Found m_found;

  template <class Map>
  static const Map& map_of(const std::pair<Map, bool>& found) // before CGAL 6
  {
    return found.first;
  }
  template <class Optional>
  static auto map_of(const Optional& found) -> decltype(*found)
  {
    return *found;
  }
  template <class Map>
  static bool is_found(const std::pair<Map, bool>& found)
  {
    return found.second;
  }
  template <class Optional>
  static auto is_found(const Optional& found) -> decltype(found.has_value())
  {
    return found.has_value();
  }

public:
  typedef typename PointSet::Index key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::read_write_property_map_tag category;

  explicit Distances_of_point_set(const PointSet& points) : m_found(points.template property_map<double>("distance")) {}

  bool are_known() const { return is_found(m_found); }

  friend double get(const Distances_of_point_set& map, const key_type& index)
  {
    return get(map_of(map.m_found), index);
  }
  // nothing, if there is no such property
  friend void put(const Distances_of_point_set& map, const key_type& index, double distance)
  {
    if (map.are_known())
      put(map_of(map.m_found), index, distance);
  }
};

// The maps of a range that are not given. They fit bare points, pairs of a point and a distance, and pairs of a point
// and anything else, such as a normal.
template <class PointRange, class Value, class = void>
struct Default_maps
{
  typedef CGAL::Identity_property_map<Value> Point_map;
  typedef No_distances Distance_map;
  static Point_map point_map(const PointRange&) { return Point_map(); }
  static Distance_map distance_map(const PointRange&) { return Distance_map(); }
};

template <class PointRange, class P, class F>
struct Default_maps<PointRange, std::pair<P, F>>
{
  typedef CGAL::First_of_pair_property_map<std::pair<P, F>> Point_map;
  typedef
    typename std::conditional<CGAL::Real_embeddable_traits<F>::Is_real_embeddable::value,
                              CGAL::Second_of_pair_property_map<std::pair<P, F>>, No_distances>::type Distance_map;
  static Point_map point_map(const PointRange&) { return Point_map(); }
  static Distance_map distance_map(const PointRange&) { return Distance_map(); }
};

template <class P, class V, class Value>
struct Default_maps<CGAL::Point_set_3<P, V>, Value>
{
  typedef CGAL::Point_set_3<P, V> Point_set;
  typedef typename Point_set::Point_map Point_map;
  typedef Distances_of_point_set<Point_set> Distance_map;
  static Point_map point_map(const Point_set& points) { return points.point_map(); }
  static Distance_map distance_map(const Point_set& points) { return Distance_map(points); }
};

// The property maps and the traits of a cloud, out of the named parameters.
template <class PointRange, class NamedParameters>
class Cloud_access
{
  typedef typename std::iterator_traits<typename PointRange::const_iterator>::value_type Value;

  typedef Default_maps<typename std::remove_const<PointRange>::type, Value> Defaults;

public:
  typedef typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::point_t, NamedParameters,
                                                             typename Defaults::Point_map>::type Point_map;
  typedef typename CGAL::internal_np::Lookup_named_param_def<internal_np::distance_map_t, NamedParameters,
                                                             typename Defaults::Distance_map>::type Distance_map;
  // bare points, and those with normals, have none
  static constexpr bool has_distances = !std::is_same<typename std::decay<Distance_map>::type, No_distances>::value;
  typedef typename boost::property_traits<typename std::decay<Point_map>::type>::value_type Point;
  typedef typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::geom_traits_t, NamedParameters,
                                                             typename CGAL::Kernel_traits<Point>::Kernel>::type Traits_;
  typedef typename std::decay<Traits_>::type Geom_traits;

private:
  typename std::decay<Point_map>::type m_point_map;
  typename std::decay<Distance_map>::type m_distance_map;
  Geom_traits m_traits;

public:
  Cloud_access(const PointRange& points, const NamedParameters& np)
    : m_point_map(CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::point_map),
                                                     Defaults::point_map(points))),
      m_distance_map(CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, internal_np::distance_map),
                                                        Defaults::distance_map(points))),
      m_traits(CGAL::parameters::choose_parameter<Geom_traits>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits)))
  {}

  // whether there are distances: a range that may have them need not
  bool are_distances_known() const
  {
    if constexpr (std::is_same<typename std::decay<Distance_map>::type,
                               Distances_of_point_set<typename std::remove_const<PointRange>::type>>::value)
      return m_distance_map.are_known();
    else
      return has_distances;
  }

  const Geom_traits& traits() const { return m_traits; }
  const typename std::decay<Distance_map>::type& distance_map() const { return m_distance_map; }

  Vector position(const Value& v) const
  {
    const auto construct = m_traits.construct_cartesian_const_iterator_3_object();
    const auto& p = get(m_point_map, v);
    auto c = construct(p);
    Vector result;
    for (int k = 0; k < 3; ++k, ++c)
      result[k] = CGAL::to_double(*c);
    return result;
  }

  double distance(const Value& v) const { return CGAL::to_double(get(m_distance_map, v)); }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_ACCESS_H
