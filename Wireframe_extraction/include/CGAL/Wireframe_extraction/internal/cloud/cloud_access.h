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
namespace Wireframe_extraction {
namespace internal {

// The property maps and the traits of a cloud, out of the named parameters.
template <class PointRange, class NamedParameters>
class Cloud_access
{
  typedef typename std::iterator_traits<typename PointRange::const_iterator>::value_type Value;

  // what a cloud without distances has as map
  struct No_distances
  {};

  // The defaults fit bare points, pairs of a point and a distance, and pairs of a point and
  // anything else, such as a normal.
  template <class V, class = void>
  struct Defaults
  {
    typedef CGAL::Identity_property_map<V> Point_map;
    typedef No_distances Distance_map;
  };
  template <class P, class F>
  struct Defaults<std::pair<P, F>,
                  typename std::enable_if<!CGAL::Real_embeddable_traits<F>::Is_real_embeddable::value>::type>
  {
    typedef CGAL::First_of_pair_property_map<std::pair<P, F>> Point_map;
    typedef No_distances Distance_map;
  };
  template <class P, class F>
  struct Defaults<std::pair<P, F>,
                  typename std::enable_if<CGAL::Real_embeddable_traits<F>::Is_real_embeddable::value>::type>
  {
    typedef CGAL::First_of_pair_property_map<std::pair<P, F>> Point_map;
    typedef CGAL::Second_of_pair_property_map<std::pair<P, F>> Distance_map;
  };

public:
  typedef typename CGAL::internal_np::Lookup_named_param_def<CGAL::internal_np::point_t, NamedParameters,
                                                             typename Defaults<Value>::Point_map>::type Point_map;
  typedef typename CGAL::internal_np::Lookup_named_param_def<internal_np::distance_map_t, NamedParameters,
                                                             typename Defaults<Value>::Distance_map>::type Distance_map;
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
  explicit Cloud_access(const NamedParameters& np)
    : m_point_map(CGAL::parameters::choose_parameter<typename std::decay<Point_map>::type>(
      CGAL::parameters::get_parameter(np, CGAL::internal_np::point_map))),
      m_distance_map(CGAL::parameters::choose_parameter<typename std::decay<Distance_map>::type>(
        CGAL::parameters::get_parameter(np, internal_np::distance_map))),
      m_traits(CGAL::parameters::choose_parameter<Geom_traits>(
        CGAL::parameters::get_parameter(np, CGAL::internal_np::geom_traits)))
  {}

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
