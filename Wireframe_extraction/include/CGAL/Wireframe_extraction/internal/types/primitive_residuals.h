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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_RESIDUALS_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_RESIDUALS_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/fit/ceres_support.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_edge.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Writes a vector, `stride` from one coordinate to the next. Returns whether it is finite.
inline bool put(const Vector& v, double* values, int stride)
{
  for (int i = 0; i < 3; ++i)
    values[i * stride] = v[i];
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

// The whitened offset of a function of several points of three coordinates, by central differences.
class Geometric_residual : public ceres::CostFunction
{
  typedef std::function<Vector(double const* const*)> Function;
  Function m_function;

public:
  Geometric_residual(std::size_t number_of_blocks, Function function) : m_function(std::move(function))
  {
    set_num_residuals(3);
    mutable_parameter_block_sizes()->assign(number_of_blocks, 3);
  }

  bool Evaluate(double const* const* blocks, double* residuals, double** jacobians) const override
  {
    if (!put(m_function(blocks), residuals, 1))
      return false;
    if (!jacobians)
      return true;
    const std::size_t count = parameter_block_sizes().size();
    std::vector<Vector> changed(count);
    std::vector<const double*> pointers(count);
    for (std::size_t b = 0; b < count; ++b)
    {
      changed[b] = Vector(blocks[b]);
      pointers[b] = changed[b].data();
    }
    constexpr double h = 1e-5;
    for (std::size_t b = 0; b < count; ++b)
    {
      if (!jacobians[b])
        continue;
      for (int k = 0; k < 3; ++k)
      {
        const double kept = changed[b][k];
        changed[b][k] = kept + h;
        const Vector ahead = m_function(pointers.data());
        changed[b][k] = kept - h;
        if (!put((ahead - m_function(pointers.data())) / (2. * h), jacobians[b] + k, 3))
          return false;
        changed[b][k] = kept;
      }
    }
    return true;
  }
};

// The curve of an edge, and those after a small step of each parameter: computed once for all stations of the edge,
// each time a solver has moved the parameters.
class Edge_variations
{
  Primitive_kind m_kind;
  std::vector<double*> m_blocks;
  Primitive_curve m_curve;
  std::vector<Primitive_curve> m_ahead, m_behind; // three for each block

public:
  static constexpr double step = 1e-5;

  Edge_variations(Primitive_kind kind, std::vector<double*> blocks) : m_kind(kind), m_blocks(std::move(blocks)) {}

  const std::vector<double*>& blocks() const { return m_blocks; }
  const Primitive_curve& curve() const { return m_curve; }
  const Primitive_curve& ahead(std::size_t parameter) const { return m_ahead[parameter]; }
  const Primitive_curve& behind(std::size_t parameter) const { return m_behind[parameter]; }

  void update(bool with_steps)
  {
    m_curve = Primitive_edge::curve(m_kind, m_blocks.data());
    m_ahead.clear();
    m_behind.clear();
    for (std::size_t b = 0; with_steps && b < m_blocks.size(); ++b)
      for (int k = 0; k < 3; ++k)
      {
        m_ahead.push_back(after_step(b, k, step));
        m_behind.push_back(after_step(b, k, -step));
      }
  }

private:
  Primitive_curve after_step(std::size_t block, int coordinate, double by) const
  {
    std::array<const double*, 3> pointers{};
    std::copy(m_blocks.begin(), m_blocks.end(), pointers.begin());
    Vector changed = Vector(m_blocks[block]);
    changed[coordinate] += by;
    pointers[block] = changed.data();
    return Primitive_edge::curve(m_kind, pointers.data());
  }
};

// Brings the curves of all edges up to date when the solver has moved the parameters.
class Edge_updater : public ceres::EvaluationCallback
{
  std::vector<Edge_variations>& m_edges;

public:
  explicit Edge_updater(std::vector<Edge_variations>& edges) : m_edges(edges) {}

  void PrepareForEvaluation(bool evaluate_jacobians, bool) override
  {
    for (Edge_variations& edge : m_edges)
      edge.update(evaluate_jacobians);
  }
};

// The whitened offset of a station from its curve, by central differences; the parameters are those of the variations.
class Station_residual : public ceres::CostFunction
{
  const Edge_variations& m_edge;
  Vector m_position;
  Matrix_3 m_root;

public:
  Station_residual(const Edge_variations& edge, const Vector& position, const Matrix_3& root)
    : m_edge(edge), m_position(position), m_root(root)
  {
    set_num_residuals(3);
    mutable_parameter_block_sizes()->assign(edge.blocks().size(), 3);
  }

  bool Evaluate(double const* const*, double* residuals, double** jacobians) const override
  {
    if (!put(m_root * (m_edge.curve().foot(m_position) - m_position), residuals, 1))
      return false;
    for (std::size_t b = 0; jacobians && b < m_edge.blocks().size(); ++b)
    {
      if (!jacobians[b])
        continue;
      for (int k = 0; k < 3; ++k)
      {
        const Vector difference = m_edge.ahead(3 * b + k).foot(m_position) - m_edge.behind(3 * b + k).foot(m_position);
        if (!put(m_root * difference / (2. * Edge_variations::step), jacobians[b] + k, 3))
          return false;
      }
    }
    return true;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_RESIDUALS_H
