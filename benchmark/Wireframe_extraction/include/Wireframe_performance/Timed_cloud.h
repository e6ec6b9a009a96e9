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

#ifndef WIREFRAME_PERFORMANCE_TIMED_CLOUD_H
#define WIREFRAME_PERFORMANCE_TIMED_CLOUD_H

#include <Sample_solids/Sample_solids.h>

#include <cstddef>
#include <string>
#include <vector>

namespace Wireframe_performance {

/// a cloud that times are measured on
struct Timed_cloud
{
  std::string shape;
  Sample_solids::Field_kind field = Sample_solids::Field_kind::EXACT;
  std::size_t points = 0;

  bool operator==(const Timed_cloud& other) const
  {
    return shape == other.shape && field == other.field && points == other.points;
  }

  std::string name() const { return shape + "/" + Sample_solids::name_of(field) + "/" + std::to_string(points); }
};

/// A plate with 23 x 22 round holes: 1012 circles, and 12 lines.
inline Sample_solids::Solid perforated_plate()
{
  using namespace Sample_solids;
  Solid solid;
  solid.name = "perforated_plate";
  const int columns = 23, rows = 22;
  std::vector<Loop> loops = {rectangle_loop(0, 0, columns, rows)};
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j)
      loops.push_back(circle_loop(i + 0.5, j + 0.5, 0.25));
  extrude(solid, Frame(), Profile(loops), 0.6);
  solid.finish();
  return solid;
}

inline Sample_solids::Solid solid_of(const std::string& shape)
{
  return shape == "perforated_plate" ? perforated_plate() : Sample_solids::make_solid(shape);
}

/// Poisson-disk points take too long where they are many.
inline Sample_solids::Cloud sample(const Timed_cloud& c)
{
  const Sample_solids::Solid solid = solid_of(c.shape);
  Sample_solids::Sampling_options options;
  options.sampling_distance = Sample_solids::sampling_distance_for(solid.area(), c.points);
  options.sampling = Sample_solids::Sampling::UNIFORM;
  options.field = c.field;
  return Sample_solids::sample(solid, options);
}

} // namespace Wireframe_performance

#endif // WIREFRAME_PERFORMANCE_TIMED_CLOUD_H
