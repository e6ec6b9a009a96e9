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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_FIELD_BAND_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_FIELD_BAND_H

#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Splitters.h>
#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <Eigen/Core>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

typedef Eigen::Vector3d Vector;

struct Construct_vector_coordinates
{
  typedef const double* result_type;
  const double* operator()(const Vector& p) const { return p.data(); }
  const double* operator()(const Vector& p, int) const { return p.data() + 3; }
};

struct Position_map
{
  typedef std::size_t key_type;
  typedef Vector value_type;
  typedef const Vector& reference;
  typedef boost::lvalue_property_map_tag category;

  const Vector* positions = nullptr;
  friend reference get(const Position_map& map, key_type i) { return map.positions[i]; }
  reference operator[](key_type i) const { return positions[i]; }
};

// The indices of the positions that differ from all earlier ones, ascending. A kd-tree cannot split equal positions.
inline std::vector<std::size_t> different_positions(const std::vector<Vector>& positions)
{
  // Equal positions have equal keys, and different ones hardly ever: the sort needs to look at keys only.
  struct Keyed
  {
    double key;
    std::size_t index;
  };
  std::vector<Keyed> order(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = {positions[i].x() + 0.7548776662466927 * positions[i].y() + 0.5698402909980532 * positions[i].z(), i};
  std::sort(order.begin(), order.end(),
            [](const Keyed& a, const Keyed& b) { return a.key < b.key || (a.key == b.key && a.index < b.index); });
  std::vector<std::size_t> result;
  for (std::size_t first = 0, beyond = 0; first < order.size(); first = beyond)
  {
    const std::size_t known = result.size();
    for (beyond = first; beyond < order.size() && order[beyond].key == order[first].key; ++beyond)
    {
      const Vector& p = positions[order[beyond].index];
      if (std::none_of(result.begin() + known, result.end(), [&](std::size_t i) { return positions[i] == p; }))
        result.push_back(order[beyond].index);
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

// Ball queries over a vector of positions that stays where it is. Answers are indices.
class Ball_search
{
  typedef CGAL::Search_traits<double, Vector, const double*, Construct_vector_coordinates, CGAL::Dimension_tag<3>>
    Base_traits;
  typedef CGAL::Search_traits_adapter<std::size_t, Position_map, Base_traits> Traits;
  typedef CGAL::Sliding_midpoint<Traits> Splitter;
  typedef CGAL::Kd_tree<Traits, Splitter, CGAL::Tag_true, CGAL::Tag_true> Tree;
  typedef CGAL::Fuzzy_sphere<Traits> Ball;

  Position_map m_map;
  std::unique_ptr<Tree> m_tree;

public:
  Ball_search() {}

  explicit Ball_search(const std::vector<Vector>& positions) { build(positions, positions.size()); }

  // indexes the first `count` positions; few of them may be equal
  void build(const std::vector<Vector>& positions, std::size_t count)
  {
    m_map.positions = positions.data();
    m_tree.reset();
    if (count == 0)
      return;
    m_tree = std::make_unique<Tree>(boost::counting_iterator<std::size_t>(0),
                                    boost::counting_iterator<std::size_t>(count), Splitter(), Traits(m_map));
    m_tree->build();
  }

  // the indices of all positions, those of neighbors close to each other: who visits them in this order finds the
  // memory around them in the caches
  std::vector<std::size_t> spatial_order() const
  {
    return m_tree ? std::vector<std::size_t>(m_tree->begin(), m_tree->end()) : std::vector<std::size_t>();
  }

  // writes the indices of the positions closer than `radius` to `center` into `found`
  void query(const Vector& center, double radius, std::vector<std::size_t>& found) const
  {
    found.clear();
    if (m_tree)
      m_tree->search(std::back_inserter(found), Ball(center, radius, 0., m_tree->traits()));
  }
};

// The points of a cloud that lie near features, with their distances, in units of the sampling distance and
// relative to a common origin. They are sorted by distance, so that what lies under a smaller threshold is a prefix,
// and so that no later stage depends on the order of the input.
struct Field_band
{
  std::vector<Vector> points;
  std::vector<double> distances;
  std::vector<std::size_t> indices; // into the cloud
  std::vector<double> deviations;   // standard deviations of the distances, where they are known
  std::vector<char> is_on_crease;   // whether the surface has a crease there, where that is known
  std::size_t skeleton_size = 0;    // the first ones are the skeleton
  Ball_search search;

  std::size_t size() const { return points.size(); }

  // standard deviation of a distance, where the field's noise level is `noise`
  double deviation(std::size_t i, double noise) const
  {
    return deviations.empty() ? noise : (std::max)(noise, deviations[i]);
  }
};

// residuals beyond it belong to no curve, where the field's noise level is `noise`
inline double residual_cutoff(double noise) { return (std::max)(0.5, 4. * noise); }

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_FIELD_FIELD_BAND_H
