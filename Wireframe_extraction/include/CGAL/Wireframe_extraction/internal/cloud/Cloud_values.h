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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_VALUES_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_VALUES_H

#include <CGAL/Wireframe_extraction/internal/base/Vector.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// The positions and distances of a cloud, and which of its values they belong to.
struct Cloud_values
{
  std::vector<Vector> positions;
  std::vector<double> distances;
  std::vector<std::size_t> indices; // none as long as no value of the cloud is missing

  std::size_t size() const { return positions.size(); }
  std::size_t index(std::size_t i) const { return indices.empty() ? i : indices[i]; }

  void reserve(std::size_t n)
  {
    positions.reserve(n);
    distances.reserve(n);
  }

  void add(const Vector& position, double distance, std::size_t index)
  {
    if (indices.empty() && index != size())
    {
      indices.resize(size());
      std::iota(indices.begin(), indices.end(), std::size_t(0));
    }
    if (!indices.empty() || index != size())
      indices.push_back(index);
    positions.push_back(position);
    distances.push_back(distance);
  }

  template <class Use>
  void for_each(const Use& use) const
  {
    for (std::size_t i = 0; i < positions.size(); ++i)
      use(positions[i], distances[i], index(i));
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CLOUD_CLOUD_VALUES_H
