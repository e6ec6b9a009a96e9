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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_CALL_SAMPLE_SHARP_MESH_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_CALL_SAMPLE_SHARP_MESH_H

#include <CGAL/Wireframe_extraction/Sharp_mesh_report.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Polygon_soup.h>
#include <CGAL/Wireframe_extraction/internal/mesh/Sharp_mesh.h>
#include <CGAL/Wireframe_extraction/internal/mesh/report_on_mesh.h>
#include <CGAL/Wireframe_extraction/parameters.h>
#include <CGAL/Wireframe_extraction/policies.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// what the named parameters say about a mesh
template <class NamedParameters>
Sharp_mesh_options sharp_mesh_options(const NamedParameters& np)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Sharp_mesh_options options;
  options.sampling_distance =
    choose_parameter(get_parameter(np, internal_np::sampling_distance), options.sampling_distance);
  options.maximum_number_of_points = static_cast<std::size_t>(
    choose_parameter(get_parameter(np, internal_np::maximum_number_of_points), options.maximum_number_of_points));
  options.minimum_fold = choose_parameter(get_parameter(np, internal_np::minimum_fold), options.minimum_fold);
  options.maximum_facet_fold =
    choose_parameter(get_parameter(np, internal_np::maximum_facet_fold), options.maximum_facet_fold);
  options.use_boundaries = choose_parameter(get_parameter(np, internal_np::use_boundaries), options.use_boundaries);
  options.random_seed =
    static_cast<std::uint32_t>(choose_parameter(get_parameter(np, internal_np::random_seed), options.random_seed));
  return options;
}

template <class PointRange, class PolygonRange>
Polygon_soup polygon_soup(const PointRange& points, const PolygonRange& polygons)
{
  Polygon_soup soup;
  for (const auto& p : points)
    soup.points.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
  for (const auto& polygon : polygons)
  {
    soup.polygons.emplace_back();
    for (const auto& index : polygon)
      soup.polygons.back().push_back(static_cast<std::size_t>(index));
  }
  return soup;
}

// hands what was found to the caller; returns whether there is no error
template <class NamedParameters>
bool tell_about_mesh(const NamedParameters& np, const Sharp_mesh_report& report, const std::string& error)
{
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  Sharp_mesh_report unused;
  Sharp_mesh_report& wanted =
    choose_parameter(get_parameter(np, internal_np::mesh_report), std::reference_wrapper<Sharp_mesh_report>(unused));
  wanted = report;
  std::string* const text =
    choose_parameter(get_parameter(np, internal_np::error_message), static_cast<std::string*>(nullptr));
  if (text != nullptr)
    *text = error;
  return error.empty();
}

// sample_sharp_mesh() and classify_mesh()
template <class PointRange, class PolygonRange, class Point, class FT, class NamedParameters>
bool sampled_sharp_mesh(const PointRange& points, const PolygonRange& polygons,
                        std::vector<std::pair<Point, FT>>& cloud, const NamedParameters& np)
{
  const Sharp_mesh_options options = sharp_mesh_options(np);
  Sharp_mesh mesh;
  const std::string error = make_sharp_mesh(polygon_soup(points, polygons), options, mesh);
  if (!error.empty())
    return tell_about_mesh(np, Sharp_mesh_report(), error);
  const Mesh_samples samples =
    sample_mesh(mesh, options,
                CGAL::parameters::choose_parameter(CGAL::parameters::get_parameter(np, CGAL::internal_np::callback),
                                                   std::function<bool(double)>()));
  if (samples.points.empty())
    return tell_about_mesh(np, report_on_mesh(mesh), "cancelled");
  cloud.clear();
  cloud.reserve(samples.points.size());
  for (std::size_t i = 0; i < samples.points.size(); ++i)
    cloud.emplace_back(Point(samples.points[i].x(), samples.points[i].y(), samples.points[i].z()),
                       FT(samples.distances[i]));
  Sharp_mesh_report report = report_on_mesh(mesh);
  report.sampling_distance = samples.sampling_distance;
  return tell_about_mesh(np, report, error);
}

template <class PointRange, class PolygonRange, class NamedParameters>
Mesh_kind kind_of_mesh(const PointRange& points, const PolygonRange& polygons, const NamedParameters& np)
{
  Sharp_mesh mesh;
  const std::string error = make_sharp_mesh(polygon_soup(points, polygons), sharp_mesh_options(np), mesh);
  tell_about_mesh(np, error.empty() ? report_on_mesh(mesh) : Sharp_mesh_report(), error);
  return mesh.kind;
}

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_MESH_CALL_SAMPLE_SHARP_MESH_H
