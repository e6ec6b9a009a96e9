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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SEVERAL_CURVES_CONTRACTION_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SEVERAL_CURVES_CONTRACTION_H

#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Contraction.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Several_curves_fit.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/distinct_curves.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/orient.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Contracts a precise field where a ball sees several curves. Fits of one curve lie between curves that are up to 3 r
// apart; local models of several, whose candidates come from the fits at neighbors, put the feet on the right ones.
// Two passes: the second one chooses from what the first one found.
class Several_curves_contraction
{
  const Field_band& m_band;
  const std::vector<std::size_t>& m_order;              // of the skeleton points, near ones together
  const std::vector<std::vector<Local_curve>>& m_small; // more candidates of the first pass, by skeleton point
  Contraction& m_contraction;
  double m_noise;

  static constexpr int number_of_passes = 2;
  static constexpr double pool_radius = 3.; // r, in which candidates are looked for
  // The noise is that of models of several curves: fits of one would measure how many curves there are. It is known
  // well from that many of them, for which a moderate noise is assumed.
  static constexpr std::size_t most_noise_fits = 300;
  static constexpr double noise_of_noise_fits = 0.2;
  // r: beyond, a field is not good enough to tell curves apart that a single fit does not
  static constexpr double most_noise = 0.08;
  static constexpr double radius_of_orientation = 4.; // as that of usual balls

  // of one thread
  struct Workspace
  {
    Several_curves_fit fit;
    std::vector<std::size_t> ball;
    std::vector<Local_curve> pool;
  };

public:
  // `contraction` holds the fits of single curves; `order` and `small` must outlive this
  Several_curves_contraction(const Field_band& band, const std::vector<std::size_t>& order,
                             const std::vector<std::vector<Local_curve>>& small, Contraction& contraction)
    : m_band(band), m_order(order), m_small(small), m_contraction(contraction), m_noise(typical_residual())
  {}

  // whether the field is precise
  bool is_of_use() const { return m_noise < most_noise; }

  // Replaces the curves. Returns false if it was cancelled.
  bool run(const std::function<bool(double)>& proceed)
  {
    const std::vector<Local_curve> singles = m_contraction.curves;
    for (int pass = 0; pass < number_of_passes; ++pass)
    {
      std::vector<Local_curve> fitted(singles.size());
      const bool is_complete = for_each_piece_or_cancel(
        m_order.size(),
        [&](std::size_t begin, std::size_t end) {
          Workspace workspace{Several_curves_fit(m_band, m_noise), {}, {}};
          for (std::size_t k = begin; k < end; ++k)
          {
            const std::size_t i = m_order[k];
            const Several_curves_fit::Result found = fit(workspace, i, singles[i], pass == 0);
            fitted[i] = found.curves[found.own];
            if (pass + 1 == number_of_passes)
              orient(workspace, fitted[i]);
            m_contraction.own_residuals[i] = found.residual;
          }
        },
        [&](double share) { return proceed((double(pass) + share) / double(number_of_passes)); });
      if (!is_complete)
        return false;
      m_contraction.curves.swap(fitted);
    }
    m_contraction.has_several_curves = true;
    m_contraction.noise = median(m_contraction.own_residuals);
    return true;
  }

private:
  double typical_residual() const
  {
    const std::size_t count = (std::min)(most_noise_fits, m_band.skeleton_size);
    if (count == 0)
      return 0.;
    std::vector<double> residuals(count);
    for_each_piece(
      count,
      [&](std::size_t begin, std::size_t end) {
        Workspace workspace{Several_curves_fit(m_band, noise_of_noise_fits), {}, {}};
        for (std::size_t k = begin; k < end; ++k)
        {
          const std::size_t i = k * m_band.skeleton_size / count;
          residuals[k] = fit(workspace, i, m_contraction.curves[i], true).residual;
        }
      },
      16);
    return median(residuals);
  }

  Several_curves_fit::Result fit(Workspace& workspace, std::size_t i, const Local_curve& single, bool is_first) const
  {
    m_band.search.query(m_band.points[i], pool_radius, workspace.ball);
    sort_by_distance(workspace.ball, m_band.points, m_band.points[i]); // near points know best
    workspace.pool.clear();
    for (std::size_t j : workspace.ball)
      if (j < m_band.skeleton_size)
      {
        workspace.pool.push_back(m_contraction.curves[j]);
        if (is_first)
          workspace.pool.insert(workspace.pool.end(), m_small[j].begin(), m_small[j].end());
      }
    return workspace.fit.fit(m_band.points[i], single, workspace.pool);
  }

  void orient(Workspace& workspace, Local_curve& curve) const
  {
    m_band.search.query(curve.point, radius_of_orientation, workspace.ball);
    internal::orient(curve, m_band, workspace.ball);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_SKELETON_SEVERAL_CURVES_CONTRACTION_H
