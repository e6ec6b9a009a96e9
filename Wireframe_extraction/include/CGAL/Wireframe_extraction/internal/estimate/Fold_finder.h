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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_FINDER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_FINDER_H

#include <CGAL/Wireframe_extraction/internal/base/Ball_search.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/base/principal_axes.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_fit.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_scales.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Fold_votes.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Sheet_fit.h>
#include <CGAL/Wireframe_extraction/internal/estimate/Sheet_pair.h>
#include <CGAL/Wireframe_extraction/internal/estimate/fold_balls.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Asks every point where around it the surface is folded. Two ways of asking complement one another. A height function
// with a fold uses all points of a ball, so that it sees weak folds and bears noise, but nothing else may be in the
// ball. Sheets take from a ball what is theirs, so that they see folds that are close to one
// another, but only clear ones.
class Fold_finder
{
  const std::vector<Vector>& m_points;
  const Ball_search& m_search;
  const Fold_scales m_scales;
  const double m_minimum_fold; // in radians

  const std::vector<std::size_t> m_order;      // neighbors follow one another
  std::vector<char> m_is_smooth;               // whether one sheet explains the ball around a point
  std::vector<std::vector<Fold_vote>> m_votes; // of each point

  // one sheet explains a ball if its variance is below that share of what points have: then it has nothing else to say
  static constexpr double least_variance_ratio = 0.85;
  // a fold is known up to so far from the center of the ball, and at that share of the radius
  static constexpr double farthest_foot = 2.5, farthest_share = 0.65;

public:
  Fold_finder(const std::vector<Vector>& points, const Ball_search& search, const Fold_scales& scales,
              double minimum_fold)
    : m_points(points), m_search(search), m_scales(scales), m_minimum_fold(minimum_fold * CGAL_PI / 180.),
      m_order(search.spatial_order()), m_is_smooth(points.size()), m_votes(points.size())
  {}

  template <class Proceed>
  bool run(const Proceed& proceed)
  {
    return vote_by_heights([&](double share) { return proceed(0.6 * share); })
      && vote_by_sheets([&](double share) { return proceed(0.6 + 0.4 * share); });
  }

  std::vector<Fold_vote> votes() const
  {
    std::vector<Fold_vote> result;
    for (const std::vector<Fold_vote>& votes : m_votes)
      result.insert(result.end(), votes.begin(), votes.end());
    return result;
  }

private:
  template <class Proceed>
  bool vote_by_heights(const Proceed& proceed)
  {
    return for_each_piece_or_cancel(
      m_points.size(),
      [&](std::size_t begin, std::size_t end) {
        Fold_fit fit(m_scales.are_frames_turned);
        Fold_ball ball;
        for (std::size_t n = begin; n < end; ++n)
        {
          const std::size_t i = m_order[n];
          m_is_smooth[i] =
            vote_by_heights(i, m_scales.large, fit, ball) || vote_by_heights(i, m_scales.small, fit, ball);
          if (m_scales.are_wide_balls_asked && !m_is_smooth[i] && !is_sure(m_votes[i]))
            vote_by_heights(i, m_scales.wide, fit, ball);
        }
      },
      proceed);
  }

  static bool is_sure(const std::vector<Fold_vote>& votes)
  {
    return std::any_of(votes.begin(), votes.end(), [](const Fold_vote& vote) { return vote.is_strong; });
  }

  // returns whether one sheet explains the ball
  bool vote_by_heights(std::size_t i, const Fold_scales::Balls& balls, Fold_fit& fit, Fold_ball& ball)
  {
    const double radius = balls.radius, variance = m_scales.deviation * m_scales.deviation;
    ball.collect(m_points, m_search, m_points[i], radius);
    const Fold_fit_result result = fit.fit(ball.offsets, radius, variance, least_variance_ratio * variance);
    const double least_evidence = balls.least_evidence;
    if (result.number_of_folds == 0 || !(result.folds[0].evidence > least_evidence)
        || result.folded_residual > balls.most_residual * m_scales.deviation)
      return result.is_smooth;
    const bool is_strong =
      result.folds[0].margin > balls.strong_margin && result.folds[0].evidence > m_scales.strong_evidence;
    const double farthest = (std::min)(farthest_foot, farthest_share * radius);
    for (int k = 0; k < result.number_of_folds; ++k)
    {
      const Fold& fold = result.folds[k];
      if (fold.evidence > least_evidence && fold.angle > m_minimum_fold && fold.foot.norm() < farthest)
        m_votes[i].push_back({m_points[i] + fold.foot, is_strong});
    }
    return result.is_smooth;
  }

  template <class Proceed>
  bool vote_by_sheets(const Proceed& proceed)
  {
    const std::vector<Sheet> sheets = fit_sheets();
    return for_each_piece_or_cancel(
      m_points.size(),
      [&](std::size_t begin, std::size_t end) {
        std::vector<std::size_t> neighbors;
        std::vector<Vector> around;
        for (std::size_t n = begin; n < end; ++n)
        {
          const std::size_t i = m_order[n];
          if (!m_is_smooth[i] && sheets[i].is_known)
            vote_by_sheets(i, sheets, neighbors, around);
        }
      },
      proceed);
  }

  std::vector<Sheet> fit_sheets() const
  {
    const std::vector<Plane_of_points> planes = fit_planes();
    std::vector<Sheet> sheets(m_points.size());
    for_each_piece(m_points.size(), [&](std::size_t begin, std::size_t end) {
      Sheet_fit fit(m_scales.deviation);
      Fold_ball ball;
      std::vector<Plane_of_points> near;
      for (std::size_t n = begin; n < end; ++n)
      {
        const std::size_t i = m_order[n];
        if (m_is_smooth[i])
          continue;
        find_in_ball(m_search, m_points[i], m_scales.plane_reach, ball.indices);
        near.clear();
        for (std::size_t j : ball.indices)
          near.push_back(planes[j]);
        ball.collect(m_points, m_search, m_points[i], m_scales.sheet_radius);
        sheets[i] = fit.fit(m_points[i], ball.offsets, near);
      }
    });
    return sheets;
  }

  // of the points that have one nearby which is not smooth: nobody asks for the others
  std::vector<Plane_of_points> fit_planes() const
  {
    std::vector<char> is_wanted(m_points.size());
    std::vector<std::size_t> found;
    for (std::size_t i : m_order)
      if (!m_is_smooth[i])
      {
        m_search.query(m_points[i], m_scales.plane_reach, found);
        for (std::size_t j : found)
          is_wanted[j] = true;
      }
    std::vector<Plane_of_points> planes(m_points.size());
    for_each_piece(m_points.size(), [&](std::size_t begin, std::size_t end) {
      std::vector<std::size_t> ball;
      for (std::size_t n = begin; n < end; ++n)
      {
        const std::size_t i = m_order[n];
        if (!is_wanted[i])
          continue;
        find_in_ball(m_search, m_points[i], m_scales.plane_radius, ball);
        planes[i] = plane_of(ball);
      }
    });
    return planes;
  }

  Plane_of_points plane_of(const std::vector<std::size_t>& ball) const
  {
    const auto position = [&](std::size_t i) -> const Vector& { return m_points[i]; };
    const Scatter points = scatter(ball, position);
    return {points.mean, principal_axes(points.matrix).axes[0]};
  }

  void collect(const Vector& center, double radius, std::vector<std::size_t>& indices, std::vector<Vector>& ball) const
  {
    find_in_ball(m_search, center, radius, indices);
    ball.clear();
    for (std::size_t j : indices)
      ball.push_back(m_points[j]);
  }

  // in the smallest ball that tells: of narrow faces few points are near
  bool do_both_end(Sheet_pair& pair, std::vector<std::size_t>& found, std::vector<Vector>& around) const
  {
    for (double radius : m_scales.radii_of_ends)
    {
      collect(pair.foot(), radius, found, around);
      const Sheet_pair::Ends ends = pair.find_ends(around);
      if (ends != Sheet_pair::Ends::UNKNOWN)
        return ends == Sheet_pair::Ends::BOTH;
    }
    return false;
  }

  struct Meeting
  {
    Vector foot;
    double distance, margin;
  };

  void vote_by_sheets(std::size_t i, const std::vector<Sheet>& sheets, std::vector<std::size_t>& neighbors,
                      std::vector<Vector>& around)
  {
    static constexpr std::size_t most_neighbors = 64;   // twice what a ball of that radius has of a surface:
    static constexpr double neighborhood = 3.;          // whose sheets are looked at
    static constexpr double same = 0.3;                 // meetings this close are one
    static constexpr std::size_t most_votes = 2;        // of a point: the nearest ones
    static constexpr double least_angle = CGAL_PI / 6.; // what sheets of few points show by chance is less
    // of chi square: what clean balls ask of folds in the larger ones, and twice as much to be sure
    static constexpr double least_margin = Fold_scales::large_margin, strong_margin = 2. * least_margin;
    const double tolerance = Sheet_fit(m_scales.deviation).tolerance();
    std::vector<Meeting> meetings;
    std::vector<std::size_t> found;
    m_search.query(m_points[i], neighborhood, neighbors);
    thin_out(neighbors, most_neighbors);
    for (std::size_t j : neighbors)
    {
      if (!sheets[j].is_known || std::abs(sheets[i].offset(m_points[j])) < tolerance
          || std::abs(sheets[j].offset(m_points[i])) < tolerance)
        continue;
      Sheet_pair pair(sheets[i], sheets[j], tolerance);
      if (!pair.meet_near(m_points[i]))
        continue;
      const double distance = (pair.foot() - m_points[i]).norm();
      if (distance > farthest_foot || (pair.foot() - m_points[j]).norm() > neighborhood)
        continue;
      if (std::any_of(meetings.begin(), meetings.end(),
                      [&](const Meeting& m) { return (m.foot - pair.foot()).norm() < same; }))
        continue;
      if (!do_both_end(pair, found, around) || pair.angle() < (std::max)(least_angle, m_minimum_fold))
        continue;
      collect(pair.foot(), m_scales.radius_of_margin, found, around);
      const double margin = pair.margin(around, m_scales.deviation_of_sheets);
      if (margin > least_margin)
        meetings.push_back({pair.foot(), distance, margin});
    }
    std::sort(meetings.begin(), meetings.end(),
              [](const Meeting& a, const Meeting& b) { return a.distance < b.distance; });
    meetings.resize((std::min)(meetings.size(), most_votes));
    for (const Meeting& meeting : meetings)
      m_votes[i].push_back({meeting.foot, meeting.margin > strong_margin});
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_ESTIMATE_FOLD_FINDER_H
