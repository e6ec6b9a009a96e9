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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_CUTTER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_CUTTER_H

#include <CGAL/Wireframe_extraction/internal/Primitive_fit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A run of stations that one line, circle or ellipse explains, or none.
struct Curve_piece
{
  std::size_t first = 0, size = 0;              // of the stations; may pass the end of a closed curve
  std::shared_ptr<const Primitive_fit> fit;     // null: it stays a spline
  bool is_line() const { return fit && fit->curve.kind == Primitive_kind::LINE; }
};

// Cuts a curve into the fewest lines, circles and ellipses that explain its stations. Where a single one does, nothing is
// cut; else the cuts are those of least cost, found by dynamic programming: twice the negative log-likelihood, and as many
// parameters as there are times the logarithm of the number of observations (Schwarz 1978).
class Curve_cutter
{
  static constexpr std::size_t most_nodes = 40;     // places for cuts that are tried at first

  const std::vector<Station>& m_stations;
  const std::vector<double>& m_spline_parameters;   // of the spline, at each station
  const bool m_is_closed;
  const double m_significance, m_log_size;

public:
  Curve_cutter(const std::vector<Station>& stations, const std::vector<double>& spline_parameters, bool is_closed,
               double significance)
    : m_stations(stations), m_spline_parameters(spline_parameters), m_is_closed(is_closed),
      m_significance(significance), m_log_size(std::log(2. * double(stations.size())))
  {}

  std::vector<Curve_piece> run() const
  {
    const std::size_t n = m_stations.size();
    for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
      if (!(m_is_closed && kind == Primitive_kind::LINE)) {
        const Curve_piece whole = try_piece(kind, 0, n);
        if (whole.fit)
          return {whole};
      }
    std::vector<Curve_piece> pieces = cut(0);
    // a closed curve has no natural start: the end of its largest piece is one
    if (m_is_closed && pieces.size() > 1) {
      const auto largest = std::max_element(pieces.begin(), pieces.end(), [](const Curve_piece& a, const Curve_piece& b) {
        return a.size < b.size;
      });
      pieces = cut((largest->first + largest->size) % n);
    }
    shift_cuts(pieces);
    join_to_ellipses(pieces);
    join_chains_of_arcs(pieces);
    return pieces;
  }

private:
  Station_range range(std::size_t first, std::size_t size) const { return Station_range(m_stations, first, size); }

  // at least so many stations beyond those that any such curve passes through
  static std::size_t least_size(Primitive_kind kind)
  {
    return kind == Primitive_kind::LINE ? 3 : kind == Primitive_kind::CIRCLE ? 4 : 7;
  }

  bool is_supported(std::size_t first, std::size_t size, Primitive_kind kind) const
  {
    std::size_t supported = 0;
    const Station_range stations = range(first, size);
    for (std::size_t i = 0; i < size; ++i)
      supported += stations[i].support >= 3;
    return supported >= least_size(kind) && 3 * supported >= 2 * size;
  }

  // a piece without fit if the kind is not what the stations show
  Curve_piece try_piece(Primitive_kind kind, std::size_t first, std::size_t size) const
  {
    Curve_piece piece;
    piece.first = first;
    piece.size = size;
    if (!is_supported(first, size, kind))
      return piece;
    const auto fit = std::make_shared<Primitive_fit>(kind, range(first, size));
    if (fit->is_valid && fit->misfit.probability(fit->curve.number_of_parameters()) >= m_significance
        && runs_forward(fit->curve, first, size))
      piece.fit = fit;
    return piece;
  }

  // whether the stations follow the curve without turning back, and go round it once at most
  bool runs_forward(const Primitive_curve& curve, std::size_t first, std::size_t size) const
  {
    const Station_range stations = range(first, size);
    double forward = 0., backward = 0.;
    for (std::size_t i = 1; i < size; ++i) {
      double step = curve.parameter(stations[i].position) - curve.parameter(stations[i - 1].position);
      if (curve.kind != Primitive_kind::LINE)
        step = std::remainder(step, 2. * CGAL_PI);
      (step > 0. ? forward : backward) += std::abs(step);
    }
    const double total = (std::max)(forward, backward);
    return (std::min)(forward, backward) < 0.1 * total
      && (curve.kind == Primitive_kind::LINE || total < 2. * CGAL_PI + 1e-6);
  }

  double cost(const Curve_piece& piece) const
  {
    if (piece.fit)
      return Misfit::share_of_independent * piece.fit->misfit.capped()
        + (piece.fit->curve.number_of_parameters() + 1) * m_log_size;
    Misfit misfit;
    double parameters = 9.;  // at its ends a spline is as free as a curve of degree two
    for (std::size_t i = piece.first; i < piece.first + piece.size; ++i) {
      const Station& station = m_stations[i % m_stations.size()];
      const Vector residual = station.followed - station.position;
      misfit.add(residual.dot(station.information * residual));
      parameters += m_spline_parameters[i % m_stations.size()];
    }
    return Misfit::share_of_independent * misfit.capped() + parameters * m_log_size;
  }

  Curve_piece best_piece(std::size_t first, std::size_t size, bool try_line, bool try_circle) const
  {
    Curve_piece best;
    best.first = first;
    best.size = size;
    double least = cost(best);
    for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE}) {
      if (!(kind == Primitive_kind::LINE ? try_line : try_circle))
        continue;
      const Curve_piece piece = try_piece(kind, first, size);
      if (piece.fit && cost(piece) < least) {
        least = cost(piece);
        best = piece;
      }
    }
    return best;
  }

  std::vector<Curve_piece> cut(std::size_t start) const
  {
    const std::size_t n = m_stations.size(), step = (n + most_nodes - 1) / most_nodes;
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < n; i += step)
      nodes.push_back(i);
    nodes.push_back(n);
    std::vector<double> least(nodes.size(), (std::numeric_limits<double>::max)());
    std::vector<Curve_piece> last(nodes.size());
    std::vector<std::size_t> from(nodes.size(), 0);
    least[0] = 0.;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      // what fails on two windows in a row fails on all that contain them
      int line_failures = 0, circle_failures = 0;
      for (std::size_t j = i + 1; j < nodes.size(); ++j) {
        const std::size_t size = nodes[j] - nodes[i];
        Curve_piece piece = best_piece((start + nodes[i]) % n, size, line_failures < 2, false);
        if (size >= least_size(Primitive_kind::LINE))
          line_failures = piece.fit ? 0 : line_failures + 1;
        if (!piece.fit && circle_failures < 2) {
          piece = best_piece((start + nodes[i]) % n, size, false, true);
          if (size >= least_size(Primitive_kind::CIRCLE))
            circle_failures = piece.fit ? 0 : circle_failures + 1;
        }
        const double total = least[i] + cost(piece);
        if (total < least[j]) {
          least[j] = total;
          last[j] = piece;
          from[j] = i;
        }
      }
    }
    std::vector<Curve_piece> pieces;
    for (std::size_t j = nodes.size() - 1; j > 0; j = from[j])
      pieces.push_back(last[j]);
    std::reverse(pieces.begin(), pieces.end());
    return pieces;
  }

  // moves each cut to the best place between those that were tried
  void shift_cuts(std::vector<Curve_piece>& pieces) const
  {
    const long reach = long((m_stations.size() + most_nodes - 1) / most_nodes);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      const Curve_piece before = pieces[k - 1], after = pieces[k];
      double least = cost(before) + cost(after);
      for (long shift = -reach; shift <= reach; ++shift) {
        const long first_size = long(before.size) + shift, second_size = long(after.size) - shift;
        if (shift == 0 || first_size < 1 || second_size < 1)
          continue;
        const Curve_piece first = same_kind(before, before.first, std::size_t(first_size));
        const Curve_piece second = same_kind(after, (before.first + std::size_t(first_size)) % m_stations.size(),
                                             std::size_t(second_size));
        if (bool(first.fit) == bool(before.fit) && bool(second.fit) == bool(after.fit)
            && cost(first) + cost(second) < least) {
          least = cost(first) + cost(second);
          pieces[k - 1] = first;
          pieces[k] = second;
        }
      }
    }
  }

  Curve_piece same_kind(const Curve_piece& piece, std::size_t first, std::size_t size) const
  {
    if (piece.fit)
      return try_piece(piece.fit->curve.kind, first, size);
    Curve_piece result;
    result.first = first;
    result.size = size;
    return result;
  }

  // Enough arcs approximate any smooth curve: three and more in a row are no evidence of arcs.
  void join_chains_of_arcs(std::vector<Curve_piece>& pieces) const
  {
    std::vector<Curve_piece> result;
    for (std::size_t k = 0; k < pieces.size();) {
      std::size_t end = k, arcs = 0;
      Curve_piece joined;
      joined.first = pieces[k].first;
      for (; end < pieces.size() && !pieces[end].is_line(); ++end) {
        joined.size += pieces[end].size;
        arcs += bool(pieces[end].fit);
      }
      if (arcs >= 3)
        result.push_back(joined);
      else
        result.insert(result.end(), pieces.begin() + k, pieces.begin() + (std::max)(end, k + 1));
      k = (std::max)(end, k + 1);
    }
    pieces = result;
  }

  // arcs of circles side by side, and splines, may be one arc of an ellipse
  void join_to_ellipses(std::vector<Curve_piece>& pieces) const
  {
    std::vector<Curve_piece> result;
    for (std::size_t k = 0; k < pieces.size();) {
      std::size_t end = k, size = 0;
      double total = 0.;
      for (; end < pieces.size() && !pieces[end].is_line(); ++end) {
        size += pieces[end].size;
        total += cost(pieces[end]);
      }
      const bool is_candidate = end > k + 1 || (end == k + 1 && !pieces[k].fit);
      const Curve_piece ellipse = is_candidate ? try_piece(Primitive_kind::ELLIPSE, pieces[k].first, size) : Curve_piece();
      if (ellipse.fit && cost(ellipse) < total)
        result.push_back(ellipse);
      else
        result.insert(result.end(), pieces.begin() + k, pieces.begin() + (std::max)(end, k + 1));
      k = (std::max)(end, k + 1);
    }
    pieces = result;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_CURVE_CUTTER_H
