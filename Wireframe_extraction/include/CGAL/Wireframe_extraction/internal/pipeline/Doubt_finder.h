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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_DOUBT_FINDER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_DOUBT_FINDER_H

#include <CGAL/Wireframe_extraction/Wireframe.h>
#include <CGAL/Wireframe_extraction/internal/base/Plain_traits.h>
#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/Vector.h>
#include <CGAL/Wireframe_extraction/internal/base/error_rates.h>
#include <CGAL/Wireframe_extraction/internal/base/median.h>
#include <CGAL/Wireframe_extraction/internal/base/polyline_tools.h>
#include <CGAL/Wireframe_extraction/internal/network/Fold_evidence.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Field_band.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/Skeleton_data.h>
#include <CGAL/Wireframe_extraction/internal/skeleton/polyline_feet.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Tells which curves of a finished wireframe may be wrong, and why: what was too little against a curve to leave it
// out, but enough to look at it. Of types, those who recognize them know.
class Doubt_finder
{
  typedef CGAL::Wireframe<Plain_traits> Wireframe;

  // in r: what errors of the field can make up; the larger these are, the longer
  static constexpr double least_length = 5., least_length_per_noise = 5.;

  // In r: points so near to a curve tell of it. Of as many as its length lets expect, this share has to agree with it:
  // errors of fields have long tails.
  static constexpr double nearby = 1.5, least_share = 0.7;
  // in r: pieces in each of which points are to be expected; those of fewer points are empty; and such a share of the
  // length may be a gap of the cloud
  static constexpr double piece = 1.5, most_empty = 1. / 3.;
  static constexpr std::size_t least_in_piece = 2;

  // In r: the root mean square of residuals that the field's noise explains, and what fields err by where they say that
  // they are precise. The noise is a median, of residuals with long tails.
  static constexpr double misfit = 0.15, misfit_per_noise = 1.5;

  // In r: two curves so near to each other are one where the field errs. They may be so near where they meet; of the
  // rest, not along more than this share.
  static constexpr double beside = 1.5, most_share_beside = 0.5;

  static constexpr double step = 0.5; // r, of polylines: an arc of radius 2 r is missed by 0.016 r

  const Skeleton_data& m_skeleton;
  const Field_band m_nothing;
  const Field_band& m_surroundings; // empty where the field is precise: then it knows better than the surface
  const double m_noise;
  Wireframe& m_wireframe;
  Progress& m_progress;
  std::vector<std::vector<Vector>> m_polylines;

public:
  Doubt_finder(const Skeleton_data& skeleton, double noise, Wireframe& wireframe, Progress& progress)
    : m_skeleton(skeleton),
      m_surroundings(skeleton.surroundings && !(skeleton.contraction && skeleton.contraction->is_precise())
                       ? *skeleton.surroundings
                       : m_nothing),
      m_noise(noise), m_wireframe(wireframe), m_progress(progress)
  {}

  // after cancelling, some doubts are missing
  void run()
  {
    find_free_ends();
    for (const auto& curve : m_wireframe.curves)
      m_polylines.push_back(polyline_of(curve));
    find_short_ones();
    find_little_support();
    find_misfits();
    find_no_folds();
    find_close_ones();
  }

private:
  typedef Wireframe_curve<Plain_traits> Curve;

  void doubt(std::size_t c, Wireframe_doubt doubt) { m_wireframe.curves[c].doubts.insert(doubt); }

  std::size_t size() const { return m_wireframe.curves.size(); }

  std::vector<Vector> polyline_of(const Curve& curve) const
  {
    std::vector<Plain_traits::Point_3> points;
    curve.spline.sample_by_distance(step * m_skeleton.unit, std::back_inserter(points));
    std::vector<Vector> polyline;
    for (const Plain_traits::Point_3& p : points)
      polyline.push_back(m_skeleton.to_local(Vector(p[0], p[1], p[2])));
    return polyline;
  }

  void find_free_ends()
  {
    std::vector<std::size_t> degrees(m_wireframe.vertices.size(), 0);
    for (const Curve& curve : m_wireframe.curves)
      if (curve.source != Curve::no_vertex)
      {
        ++degrees[curve.source];
        ++degrees[curve.target];
      }
    for (std::size_t c = 0; c < size(); ++c)
    {
      const Curve& curve = m_wireframe.curves[c];
      if (curve.source != Curve::no_vertex && (degrees[curve.source] == 1 || degrees[curve.target] == 1))
        doubt(c, Wireframe_doubt::FREE_END);
    }
  }

  void find_short_ones()
  {
    for (std::size_t c = 0; c < size(); ++c)
      if (polyline_length(m_polylines[c]) < least_length + least_length_per_noise * m_noise)
        doubt(c, Wireframe_doubt::SHORT);
  }

  // the numbers of points in the pieces of each curve, of those points of a band that are near and that count
  template <class Predicate>
  std::vector<std::vector<std::size_t>> numbers_in_pieces(const Field_band& band, const Predicate& counts)
  {
    std::vector<std::vector<double>> lengths;
    std::vector<std::vector<std::size_t>> numbers;
    for (const std::vector<Vector>& polyline : m_polylines)
    {
      lengths.push_back(arc_lengths(polyline));
      numbers.emplace_back((std::max)(std::size_t(1), std::size_t(lengths.back().back() / piece)), 0);
    }
    const std::vector<Polyline_foot> feet = nearest_feet(band, pointers_to(m_polylines), nearby, &m_progress);
    for (std::size_t i = 0; i < feet.size(); ++i)
      if (feet[i].is_valid() && counts(i, feet[i].distance))
      {
        std::vector<std::size_t>& pieces = numbers[feet[i].curve];
        const std::vector<double>& of_curve = lengths[feet[i].curve];
        const double share = feet[i].interpolate(of_curve) / of_curve.back();
        ++pieces[(std::min)(pieces.size() - 1, std::size_t(share * double(pieces.size())))];
      }
    return numbers;
  }

  static double sum(const std::vector<std::size_t>& numbers)
  {
    return double(std::accumulate(numbers.begin(), numbers.end(), std::size_t(0)));
  }

  // the share of the longest run of empty pieces
  static double largest_gap(const std::vector<std::size_t>& pieces, bool is_closed)
  {
    const std::size_t n = pieces.size();
    std::size_t run = 0, longest = 0;
    for (std::size_t k = 0; k < (is_closed ? 2 * n : n); ++k)
    {
      run = pieces[k % n] < least_in_piece ? run + 1 : 0;
      longest = (std::max)(longest, run);
    }
    return double((std::min)(longest, n)) / double(n);
  }

  // how many points are near a piece of length 1 r, of half of the curves or more; short ones tell nothing of it
  double usual_density(const std::vector<std::vector<std::size_t>>& numbers) const
  {
    std::vector<double> densities;
    for (std::size_t c = 0; c < size(); ++c)
      if (polyline_length(m_polylines[c]) > least_length)
        densities.push_back(sum(numbers[c]) / polyline_length(m_polylines[c]));
    return densities.empty() ? 0. : median(densities);
  }

  void find_little_support()
  {
    const Field_band& band = *m_skeleton.band;
    const Field_band& all = m_surroundings.size() > 0 ? m_surroundings : band;
    const auto near_ones = numbers_in_pieces(all, [](std::size_t, double) { return true; });
    const auto agreeing = numbers_in_pieces(band, [&](std::size_t i, double distance) {
      return std::abs(band.distances[i] - distance) < agreement_tolerance(band.deviation(i, m_noise));
    });
    const double density = usual_density(near_ones);
    for (std::size_t c = 0; c < size(); ++c)
    {
      const double expected = (std::max)(sum(near_ones[c]), density * polyline_length(m_polylines[c]));
      // a number of points has a Poisson distribution: its variance is its mean
      const double asked = least_share * expected - exceeded_by_one_in_22 * std::sqrt(least_share * expected);
      if (sum(agreeing[c]) < asked || largest_gap(agreeing[c], m_wireframe.curves[c].is_closed()) > most_empty)
        doubt(c, Wireframe_doubt::LITTLE_SUPPORT);
    }
  }

  void find_misfits()
  {
    const double most = (std::max)(misfit, misfit_per_noise * m_noise) * m_skeleton.unit;
    for (std::size_t c = 0; c < size(); ++c)
      if (m_wireframe.curves[c].rms > most)
        doubt(c, Wireframe_doubt::MISFIT);
  }

  void find_no_folds()
  {
    if (m_surroundings.size() == 0)
      return;
    const std::vector<Fold_evidence::Fold> folds =
      Fold_evidence(m_surroundings, &m_progress).folds(pointers_to(m_polylines));
    for (std::size_t c = 0; c < size(); ++c)
      if (folds[c].is_flat()) // what is so beyond doubt was left out when the curves were traced
        doubt(c, Wireframe_doubt::NO_FOLD);
  }

  void find_close_ones()
  {
    // the places of all curves, as if they were points of a cloud
    Field_band places;
    std::vector<std::size_t> owners, number(size(), 0);
    for (std::size_t c = 0; c < size(); ++c)
    {
      const std::vector<Vector>& polyline = m_polylines[c];
      const std::vector<double> lengths = arc_lengths(polyline);
      for (std::size_t k = 0; k + 1 < polyline.size(); ++k)
        if (m_wireframe.curves[c].source == Curve::no_vertex
            || (lengths[k] > beside && lengths[k] < lengths.back() - beside))
        {
          places.points.push_back(polyline[k]);
          owners.push_back(c);
          ++number[c];
        }
    }
    places.search.build(places.points, places.points.size());
    std::vector<char> is_beside(places.points.size(), 0);
    for (std::size_t c = 0; c < size() && m_progress.goes_on(); ++c)
      visit_feet(places, c, m_polylines[c], beside, [&](std::size_t i, const Polyline_foot&) {
        if (owners[i] != c)
          is_beside[i] = 1;
      });
    std::vector<std::size_t> number_beside(size(), 0);
    for (std::size_t i = 0; i < owners.size(); ++i)
      number_beside[owners[i]] += std::size_t(is_beside[i]);
    for (std::size_t c = 0; c < size(); ++c)
      if (double(number_beside[c]) > most_share_beside * double(number[c]))
        doubt(c, Wireframe_doubt::BESIDE_ANOTHER);
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_PIPELINE_DOUBT_FINDER_H
