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

#ifndef CGAL_WIREFRAME_EXTRACTION_WIREFRAME_SKELETON_H
#define CGAL_WIREFRAME_EXTRACTION_WIREFRAME_SKELETON_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>

namespace CGAL {

/// \ingroup PkgWireframeExtractionClasses
/// The points of a cloud that lie near sharp features, sorted by their distance to them. The first `size()` points are
/// the skeleton; the `support_size()` points include those a little farther away that support the fits.
///
/// Copies share their data.
///
/// \tparam GeomTraits a model of `WireframeExtractionTraits_3`
template <class GeomTraits>
class Wireframe_skeleton
{
public:
  typedef GeomTraits Geom_traits;                 ///< the traits class
  typedef typename GeomTraits::FT FT;             ///< the number type
  typedef typename GeomTraits::Point_3 Point_3;   ///< the point type
  typedef typename GeomTraits::Vector_3 Vector_3; ///< the vector type

  /// constructs an empty skeleton.
  Wireframe_skeleton() {}

  /// returns the number of points of the skeleton.
  std::size_t size() const { return m_data.size(); }

  /// returns the number of all points that were kept.
  std::size_t support_size() const { return m_data.support_size(); }

  /// returns whether the skeleton has no point.
  bool is_empty() const { return size() == 0; }

  /// returns the sampling distance, in the cloud's unit.
  FT sampling_distance() const { return FT(m_data.unit); }

  /// returns the number of points that were left out since they repeat another one exactly.
  std::size_t number_of_duplicates() const { return m_data.number_of_duplicates; }

  /// returns the number of points that were left out since they are farther than 10<sup>9</sup> sampling distances from
  /// the others.
  std::size_t number_of_strays() const { return m_data.number_of_strays; }

  /// returns the `i`-th point. \pre `i < support_size()`
  Point_3 point(std::size_t i) const
  {
    CGAL_precondition(i < support_size());
    return to_point(m_data.band->points[i]);
  }

  /// returns the distance of the `i`-th point to the nearest sharp feature. \pre `i < support_size()`
  FT distance(std::size_t i) const
  {
    CGAL_precondition(i < support_size());
    return FT(m_data.band->distances[i] * m_data.unit);
  }

  /// returns the position of the `i`-th point in the cloud. \pre `i < support_size()`
  std::size_t index(std::size_t i) const
  {
    CGAL_precondition(i < support_size());
    return m_data.band->indices[i];
  }

  /// returns whether `contract_skeleton()` was called.
  bool is_contracted() const { return m_data.contraction != nullptr; }

  /// returns the foot of the `i`-th point: the nearest point of the curve that the field draws near it.
  /// \pre `is_contracted()` and `i < size()`
  Point_3 foot(std::size_t i) const { return to_point(contraction().curves[i].point); }

  /// returns the unit tangent of that curve at the foot; its sign has no meaning.
  /// \pre `is_contracted()` and `i < size()`
  Vector_3 tangent(std::size_t i) const
  {
    const internal_Vector& t = contraction().curves[i].tangent;
    return m_traits.construct_vector_3_object()(FT(t.x()), FT(t.y()), FT(t.z()));
  }

  /// returns the root mean square of the field's residuals close to the foot, of those points that no other curve
  /// nearby explains better, in the cloud's unit.
  /// \pre `is_contracted()` and `i < size()`
  FT residual(std::size_t i) const { return FT(contraction().own_residuals[i] * m_data.unit); }

  /// returns the noise level of the field, in the cloud's unit: `noise_level` times the sampling distance if that named
  /// parameter was given, else the median of the residuals, or after `refine_field()` the typical deviation of the
  /// creases if that is larger.
  /// \pre `is_contracted()`
  FT noise() const { return FT(contraction().noise * m_data.unit); }

  /// \cond SKIP_IN_MANUAL
  typedef Wireframe_extraction::internal::Vector internal_Vector;
  typedef Wireframe_extraction::internal::Skeleton_data Data;

  Wireframe_skeleton(Data data, const GeomTraits& traits) : m_data(std::move(data)), m_traits(traits) {}

  const Data& data() const { return m_data; }
  Data& data() { return m_data; }
  const GeomTraits& traits() const { return m_traits; }

  // between the cloud's coordinates and local ones
  Point_3 to_point(const internal_Vector& p) const
  {
    const internal_Vector q = m_data.to_global(p);
    return m_traits.construct_point_3_object()(FT(q.x()), FT(q.y()), FT(q.z()));
  }
  internal_Vector to_local(const Point_3& p) const
  {
    auto c = m_traits.construct_cartesian_const_iterator_3_object()(p);
    internal_Vector q;
    for (int k = 0; k < 3; ++k, ++c)
      q[k] = CGAL::to_double(*c);
    return m_data.to_local(q);
  }
  /// \endcond

private:
  Data m_data;
  GeomTraits m_traits;

  const Wireframe_extraction::internal::Contraction& contraction() const
  {
    CGAL_precondition_msg(is_contracted(), "call contract_skeleton() first");
    return *m_data.contraction;
  }
};

} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_WIREFRAME_SKELETON_H
