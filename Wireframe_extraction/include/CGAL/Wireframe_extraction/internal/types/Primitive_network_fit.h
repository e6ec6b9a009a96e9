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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_NETWORK_FIT_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_NETWORK_FIT_H

#include <CGAL/Wireframe_extraction/internal/base/Matrix_3.h>
#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/fit/ceres_support.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_regularities.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_fit.h>
#include <CGAL/Wireframe_extraction/internal/types/primitive_residuals.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Fits lines, circles and ellipses that share vertices to their stations, all at once. Lines and circles pass through
// their vertices by construction; what else has to hold exactly, tangents that agree and vertices on ellipses, is
// enforced by augmented Lagrangians.
class Primitive_network_fit
{
public:
  // a spline that ends in a vertex keeps it on its tangent, as firmly as the field kept the spline
  struct Spline_end
  {
    std::size_t vertex;
    Vector position, tangent;
    double deviation;
    double along = (std::numeric_limits<double>::infinity)(); // deviation along the tangent
  };
  // two edges that go on into each other at a vertex
  struct Tangency
  {
    std::size_t vertex;
    std::array<std::size_t, 2> edges;
  };

  std::vector<Vector> vertices;
  std::vector<Primitive_edge> edges;
  std::vector<Spline_end> spline_ends;
  std::vector<Tangency> tangencies;
  std::vector<Regularity> regularities; // of edges

  // whether an edge does not meet what has to hold exactly
  bool is_violated(std::size_t edge) const { return edge < m_is_violated.size() && m_is_violated[edge]; }

  void set_violated(std::size_t edge, bool is_violated)
  {
    m_is_violated.resize(edges.size(), 0);
    m_is_violated[edge] = is_violated;
  }

  // after cancelling, the result is of no use
  void run(Progress* progress = nullptr)
  {
    m_progress = progress;
    m_is_violated.assign(edges.size(), 0);
    m_roots.clear();
    for (const Primitive_edge& edge : edges)
      for (const Station& station : edge.stations)
        m_roots.push_back(square_root(station.information));
    const std::vector<Vector> anchors = vertices;
    const std::vector<Constraint> constraints = make_constraints();
    std::vector<Vector> multipliers(constraints.size(), Vector::Zero());
    double weight = first_weight;
    solve(anchors, constraints, multipliers, 0.);
    for (int round = 0; round < (constraints.empty() ? 0 : most_rounds);
         ++round, weight = (std::min)(+most_weight, weight_factor * weight))
    {
      solve(anchors, constraints, multipliers, weight);
      double worst = 0.;
      for (std::size_t i = 0; i < constraints.size(); ++i)
      {
        const Vector value = constraints[i].function(constraints[i].blocks.data());
        multipliers[i] += weight * value;
        worst = (std::max)(worst, value.norm());
      }
      if (worst < least_violation || is_cancelled())
        break;
    }
    for (const Constraint& constraint : constraints)
      if (!(constraint.function(constraint.blocks.data()).norm() < most_violation))
        for (const std::size_t edge : constraint.edges)
          m_is_violated[edge] = 1;
  }

private:
  // Augmented Lagrangians converge whatever the weights are; these, in units of a squared standard deviation per r^2,
  // keep each round well conditioned.
  static constexpr double first_weight = 1e4, most_weight = 1e8, weight_factor = 10.;
  static constexpr int most_rounds = 9;
  static constexpr double least_violation = 1e-10, most_violation = 1e-6; // r, or radians: reached, and not reached
  static constexpr int most_iterations = 20;                              // of the solver in a round
  static constexpr double relative_gain = 1e-12;                          // of the sum, with which it stops
  // Beyond so many standard deviations a station counts as an outlier, as in the fits of single curves.
  static constexpr double outlier_deviations = 4.;
  // What holds vertices that no curve holds: 1 r counts as a tenth of a standard deviation, far less than any station.
  static constexpr double pull_on_vertices = 0.1;

  Progress* m_progress = nullptr;
  std::vector<char> m_is_violated;
  std::vector<Matrix_3> m_roots; // of the information of all stations, edge after edge

  bool is_cancelled() const { return m_progress && m_progress->is_cancelled(); }

  // stops a solver
  class Cancelling_callback : public ceres::IterationCallback
  {
    Progress& m_progress;

  public:
    explicit Cancelling_callback(Progress& progress) : m_progress(progress) {}

    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override
    {
      return m_progress.goes_on() ? ceres::SOLVER_CONTINUE : ceres::SOLVER_ABORT;
    }
  };

  struct Constraint
  {
    std::vector<std::size_t> edges;
    std::vector<double*> blocks;
    std::function<Vector(double const* const*)> function;
  };

  // index of each block of the edge in `all`, which grows where it is missing
  static std::vector<std::size_t> enter(const std::vector<double*>& blocks, std::vector<double*>& all)
  {
    std::vector<std::size_t> indices;
    for (double* block : blocks)
    {
      const auto found = std::find(all.begin(), all.end(), block);
      indices.push_back(std::size_t(found - all.begin()));
      if (found == all.end())
        all.push_back(block);
    }
    return indices;
  }

  // the curve of an edge as a function of the blocks of a constraint
  struct Edge_curve
  {
    Primitive_kind kind;
    std::vector<std::size_t> indices; // of the edge's blocks among those of the constraint

    Primitive_curve operator()(double const* const* blocks) const
    {
      std::array<const double*, 3> own{};
      for (std::size_t i = 0; i < indices.size(); ++i)
        own[i] = blocks[indices[i]];
      return Primitive_edge::curve(kind, own.data());
    }
  };

  Edge_curve take_part(std::size_t edge, Constraint& constraint)
  {
    constraint.edges.push_back(edge);
    return {edges[edge].kind, enter(edges[edge].blocks(vertices), constraint.blocks)};
  }

  std::vector<Constraint> make_constraints()
  {
    std::vector<Constraint> result;
    for (const Tangency& tangency : tangencies)
      result.push_back(tangency_constraint(tangency));
    for (const Regularity& regularity : regularities)
    {
      result.push_back(regularity_constraint(regularity));
      if (regularity.kind == Regularity_kind::COAXIAL)
        result.push_back(regularity_constraint({Regularity_kind::PARALLEL, regularity.curves}));
    }
    for (std::size_t k = 0; k < edges.size(); ++k)
      if (edges[k].kind == Primitive_kind::ELLIPSE && edges[k].has_vertex())
        for (std::size_t e = 0; e < (edges[k].is_loop() ? 1u : 2u); ++e)
          result.push_back(incidence_constraint(k, edges[k].vertices[e]));
    return result;
  }

  Constraint tangency_constraint(const Tangency& tangency)
  {
    Constraint result;
    const Edge_curve one = take_part(tangency.edges[0], result), two = take_part(tangency.edges[1], result);
    const std::size_t vertex = enter({vertices[tangency.vertex].data()}, result.blocks)[0];
    result.function = [=](double const* const* blocks) {
      const Vector place = Vector(blocks[vertex]);
      return Vector(one(blocks).tangent(place).cross(two(blocks).tangent(place)));
    };
    return result;
  }

  Constraint regularity_constraint(const Regularity& regularity)
  {
    Constraint result;
    const Edge_curve one = take_part(regularity.curves[0], result), two = take_part(regularity.curves[1], result);
    const Regularity_kind kind = regularity.kind;
    result.function = [=](double const* const* blocks) { return discrepancy(kind, one(blocks), two(blocks)); };
    return result;
  }

  // zero where the regularity holds; angles are those between arms of about the length of a curve
  static Vector discrepancy(Regularity_kind kind, const Primitive_curve& one, const Primitive_curve& two)
  {
    constexpr double arm = 10.;
    const Vector &a = one.axis, &b = two.axis, offset = two.center - one.center;
    switch (kind)
    {
    case Regularity_kind::EQUAL_RADII: return Vector(one.major_radius - two.major_radius, 0., 0.);
    case Regularity_kind::COAXIAL:
      // that the axes are parallel is a constraint of its own
      return offset - offset.dot(a) * a;
    case Regularity_kind::PARALLEL: return arm * a.cross(b);
    case Regularity_kind::ORTHOGONAL: return Vector(arm * a.dot(b), 0., 0.);
    }
    return Vector::Zero();
  }

  Constraint incidence_constraint(std::size_t edge, std::size_t vertex)
  {
    Constraint result;
    const Edge_curve curve = take_part(edge, result);
    const std::size_t place = enter({vertices[vertex].data()}, result.blocks)[0];
    result.function = [=](double const* const* blocks) {
      const Vector p = Vector(blocks[place]);
      return Vector(curve(blocks).foot(p) - p);
    };
    return result;
  }

  static Matrix_3 square_root(const Matrix_3& matrix)
  {
    // the eigenvalue along the tangent is zero, but for rounding
    const Principal_axes principal = principal_axes(matrix);
    Matrix_3 root = Matrix_3::Zero();
    for (int k = 0; k < 3; ++k)
      root += Matrix_3::outer(std::sqrt((std::max)(0., principal.values[k])) * principal.axes[k], principal.axes[k]);
    return root;
  }

  void solve(const std::vector<Vector>& anchors, const std::vector<Constraint>& constraints,
             const std::vector<Vector>& multipliers, double weight)
  {
    std::vector<Edge_variations> variations;
    for (Primitive_edge& edge : edges)
      variations.emplace_back(edge.kind, edge.blocks(vertices));
    Edge_updater updater(variations);
    ceres::Problem::Options problem_options;
    problem_options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    problem_options.evaluation_callback = &updater;
    ceres::Problem problem(problem_options);
    ceres::CauchyLoss robust(outlier_deviations);
    auto next_root = m_roots.begin();
    for (std::size_t k = 0; k < edges.size(); ++k)
      for (const Station& station : edges[k].stations)
        problem.AddResidualBlock(new Station_residual(variations[k], station.position, *next_root++), &robust,
                                 variations[k].blocks());
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (problem.HasParameterBlock(vertices[v].data()))
        add_pull(problem, vertices[v], pull_on_vertices * Matrix_3::Identity(), anchors[v]);
    for (const Spline_end& end : spline_ends)
      if (problem.HasParameterBlock(vertices[end.vertex].data()))
      {
        const Matrix_3 along = Matrix_3::outer(end.tangent, end.tangent);
        add_pull(problem, vertices[end.vertex], (Matrix_3::Identity() - along) / end.deviation + along / end.along,
                 end.position);
      }
    if (weight > 0.)
      for (std::size_t i = 0; i < constraints.size(); ++i)
      {
        const auto function = constraints[i].function;
        const double factor = std::sqrt(weight);
        const Vector shift = multipliers[i] / weight;
        problem.AddResidualBlock(new Geometric_residual(constraints[i].blocks.size(),
                                                        [=](double const* const* parameters) {
                                                          return Vector(factor * (function(parameters) + shift));
                                                        }),
                                 nullptr, constraints[i].blocks);
      }
    if (problem.NumResidualBlocks() == 0)
      return;
    ceres::Solver::Options options = solver_options(most_iterations, relative_gain);
    std::unique_ptr<Cancelling_callback> callback;
    if (m_progress)
    {
      callback = std::make_unique<Cancelling_callback>(*m_progress);
      options.callbacks.push_back(callback.get());
    }
    ceres::Solver::Summary summary;
    const std::vector<Vector> kept = vertices;
    const std::vector<Primitive_edge> kept_edges = edges;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable())
    {
      std::copy(kept.begin(), kept.end(), vertices.begin());
      for (std::size_t i = 0; i < edges.size(); ++i)
        edges[i].points = kept_edges[i].points;
    }
  }

  static void add_pull(ceres::Problem& problem, Vector& vertex, const Matrix_3& root, const Vector& place)
  {
    problem.AddResidualBlock(
      new Geometric_residual(
        1, [root, place](double const* const* parameters) { return Vector(root * (Vector(parameters[0]) - place)); }),
      nullptr, vertex.data());
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_PRIMITIVE_NETWORK_FIT_H
