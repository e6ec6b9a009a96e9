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

#ifndef WIREFRAME_PERFORMANCE_PIPELINE_H
#define WIREFRAME_PERFORMANCE_PIPELINE_H

#include <Wireframe_performance/Timed_cloud.h>

#include <CGAL/Wireframe_extraction/IO/read_distance_cloud.h>
#include <CGAL/Wireframe_extraction/estimate_sampling_distance.h>
#include <CGAL/extract_wireframe.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Fuzzy_sphere.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Search_traits_3.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <cstddef>
#include <cstdio>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Wireframe_performance {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef std::vector<std::pair<Kernel::Point_3, double>> Cloud;

/// What all stages get and give, for one cloud.
class Pipeline
{
  typedef CGAL::Wireframe_skeleton<Kernel> Skeleton;

  Timed_cloud m_case;
  std::string m_filename;
  Cloud m_cloud;
  double m_sampling_distance = 0.;
  Skeleton m_selected, m_contracted, m_refined;
  std::vector<CGAL::Wireframe_corner<Kernel>> m_corners;
  std::vector<std::vector<std::size_t>> m_clusters;
  CGAL::Wireframe_graph<Kernel> m_graph;
  CGAL::Wireframe<Kernel> m_wireframe;

public:
  /// makes the cloud, writes it into a file in this folder, and runs all stages.
  Pipeline(const Timed_cloud& c, const std::string& folder) : m_case(c)
  {
    // several of these programs may run at once
    m_filename = folder + "/wireframe_extraction_benchmark_" + std::to_string(std::random_device()()) + ".ply";
    {
      std::ofstream out(m_filename, std::ios::binary);
      if (!Sample_solids::write_ply(out, sample(c)))
        throw std::runtime_error("cannot write '" + m_filename + "'");
    }
    m_cloud = read();
    m_sampling_distance = scale();
    m_selected = select();
    m_contracted = contract();
    m_refined = refine();
    m_corners = corners();
    m_clusters = segment();
    m_graph = graph();
    m_wireframe = fit();
  }

  Pipeline(const Pipeline&) = delete;
  Pipeline& operator=(const Pipeline&) = delete;
  ~Pipeline() { std::remove(m_filename.c_str()); }

  const Timed_cloud& of() const { return m_case; }
  std::size_t size() const { return m_cloud.size(); }
  std::size_t skeleton_size() const { return m_selected.size(); }
  std::size_t support_size() const { return m_selected.support_size(); }
  std::size_t number_of_curves() const { return m_wireframe.curves.size(); }

  Cloud read() const
  {
    Cloud cloud;
    if (!CGAL::IO::read_distance_cloud(m_filename, cloud))
      throw std::runtime_error("cannot read '" + m_filename + "'");
    return cloud;
  }

  // The stages, each from what those before it gave.
  double scale() const { return CGAL::Wireframe_extraction::estimate_sampling_distance(m_cloud); }

  Skeleton select() const
  {
    return CGAL::Wireframe_extraction::select_skeleton(
      m_cloud, CGAL::Wireframe_extraction::parameters::sampling_distance(m_sampling_distance));
  }

  Skeleton contract() const
  {
    Skeleton skeleton = m_selected;
    CGAL::Wireframe_extraction::contract_skeleton(skeleton);
    return skeleton;
  }

  Skeleton refine() const
  {
    Skeleton skeleton = m_contracted;
    CGAL::Wireframe_extraction::refine_field(skeleton);
    return skeleton;
  }

  std::vector<CGAL::Wireframe_corner<Kernel>> corners() const
  {
    return CGAL::Wireframe_extraction::detect_corners(m_refined);
  }

  std::vector<std::vector<std::size_t>> segment() const
  {
    return CGAL::Wireframe_extraction::segment_curves(m_refined, m_corners);
  }

  CGAL::Wireframe_graph<Kernel> graph() const
  {
    return CGAL::Wireframe_extraction::build_topological_graph(m_refined, m_corners, m_clusters);
  }

  CGAL::Wireframe<Kernel> fit() const { return CGAL::Wireframe_extraction::fit_curves(m_refined, m_graph); }

  CGAL::Wireframe<Kernel> recognize() const
  {
    return CGAL::Wireframe_extraction::recognize_curve_types(m_refined, m_wireframe);
  }

  /// from the file to the wireframe
  CGAL::Wireframe<Kernel> all() const { return CGAL::extract_wireframe(read()); }

  /// What hardly any method can do without: reading the cloud, a kd-tree of all points that some stage uses, and a ball
  /// query around each point of the skeleton, with one thread. Returns how many points are in the balls.
  std::size_t floor() const
  {
    typedef CGAL::Search_traits_3<Kernel> Traits;
    typedef CGAL::Sliding_midpoint<Traits> Splitter;
    typedef CGAL::Kd_tree<Traits, Splitter, CGAL::Tag_true, CGAL::Tag_true> Tree;
    const Cloud cloud = read();
    const std::vector<Kernel::Point_3> points = points_in_use();
    Tree tree(points.begin(), points.end());
    tree.build();
    std::size_t found = 0;
    const boost::function_output_iterator<Counter> count{Counter{&found}};
    for (std::size_t i = 0; i < m_selected.size(); ++i)
      tree.search(count, CGAL::Fuzzy_sphere<Traits>(m_selected.point(i), 4. * m_sampling_distance));
    return found + cloud.size();
  }

private:
  struct Counter // kd-trees assign iterators, which lambdas do not permit
  {
    std::size_t* count;
    void operator()(const Kernel::Point_3&) const { ++*count; }
  };

  // those that support the fits, and, unless the field is precise, those around the skeleton,
  // where creases are looked for
  std::vector<Kernel::Point_3> points_in_use() const
  {
    const auto& band = m_selected.band();
    const auto& surroundings = m_contracted.surroundings();
    std::vector<char> is_in_use(m_cloud.size(), 0);
    for (const auto* indices : {&band.indices, &surroundings.indices})
      for (std::size_t i : *indices)
        is_in_use[i] = 1;
    std::vector<Kernel::Point_3> points;
    for (std::size_t i = 0; i < m_cloud.size(); ++i)
      if (is_in_use[i])
        points.push_back(m_cloud[i].first);
    return points;
  }
};

} // namespace Wireframe_performance

#endif // WIREFRAME_PERFORMANCE_PIPELINE_H
