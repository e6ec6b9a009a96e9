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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_CUTTER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_CUTTER_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_course.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_fit.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// A run of stations that one line, circle or ellipse explains, or none.
struct Curve_piece
{
  std::size_t first = 0, size = 0;          // of the stations; may pass the end of a closed curve
  std::shared_ptr<const Primitive_fit> fit; // null: it stays a spline
  bool is_line() const { return fit && fit->curve.kind == Primitive_kind::LINE; }
};

// Cuts a curve into the fewest lines, circles and ellipses that explain its stations. Where a single one does, nothing
// is cut; else the cuts are those of least cost, found by dynamic programming: twice the negative log-likelihood, and
// as many parameters as there are times the logarithm of the number of observations (Schwarz 1978).
class Curve_cutter
{
  static constexpr std::size_t most_places = 250; // for cuts
  static constexpr std::size_t reach = 2;         // how far around the ends of pieces cuts are tried, in stations
  static constexpr double most_turn = 15. * CGAL_PI / 180., most_gap = 0.5; // from one piece to the next
  static constexpr double most_miss = 1.;               // how far from its vertex a curve may pass before vertices move
  static constexpr double least_spline_parameters = 3.; // of one that goes on smoothly at both ends
  // Of the way along a curve: steps back are errors of neighboring stations, and cancel; that of a curve that the
  // stations follow forth and back is one.
  static constexpr double most_backward = 0.1;
  // Of the stations of a piece, at least so many are places that points show: a piece is no guess over a gap.
  static constexpr double least_share_supported = 0.5;
  // What fails on one window of stations may be an outlier at its end; on a second, larger one, hardly ever.
  static constexpr int most_failures = 2;
  static constexpr std::size_t least_step = 2; // in stations, between places for cuts where nothing fits

  const std::vector<Station>& m_stations;
  const std::array<Vector, 2> m_ends;
  const bool m_is_closed;
  const double m_significance, m_log_size;
  const std::vector<double> m_spline_costs;
  Progress* const m_progress;
  mutable std::map<std::tuple<Primitive_kind, std::size_t, std::size_t>, Curve_piece> m_known;

public:
  // `density` is the number of parameters that the spline has per station; `ends` are those of the curve, which count
  // unless it is closed and free of vertices. After cancelling, what run() returns is of no use.
  Curve_cutter(const std::vector<Station>& stations, double density, const std::array<Vector, 2>& ends, bool is_closed,
               double significance, Progress* progress = nullptr)
    : m_stations(stations), m_ends(ends), m_is_closed(is_closed), m_significance(significance),
      m_log_size(std::log(2. * double(stations.size()))), m_spline_costs(spline_costs(stations, density * m_log_size)),
      m_progress(progress)
  {}

  std::vector<Curve_piece> run() const
  {
    const std::size_t n = m_stations.size();
    const Curve_piece whole =
      first_that_fits({Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE}, 0, n);
    if (whole.fit)
      return {whole};
    std::vector<Curve_piece> pieces = cut(0);
    // a closed curve has no natural start: the end of its largest piece is one
    if (m_is_closed && pieces.size() > 1)
    {
      const auto largest = std::max_element(pieces.begin(), pieces.end(),
                                            [](const Curve_piece& a, const Curve_piece& b) { return a.size < b.size; });
      pieces = cut_closed((largest->first + largest->size) % n);
      // what is joined below must not depend on where the curve starts
      const auto line =
        std::find_if(pieces.begin(), pieces.end(), [](const Curve_piece& piece) { return piece.is_line(); });
      if (line != pieces.end())
        std::rotate(pieces.begin(), line, pieces.end());
    }
    join_arcs(pieces);
    join_chains_of_arcs(pieces);
    return pieces;
  }

private:
  bool goes_on() const { return internal::goes_on(m_progress); }

  Station_range range(std::size_t first, std::size_t size) const { return Station_range(m_stations, first, size); }

  // At least so many stations: through 2, 3 and 5 places in general position pass a line, a circle and an ellipse that
  // nothing shows to be there.
  static std::size_t least_size(Primitive_kind kind)
  {
    return kind == Primitive_kind::LINE ? 3 : kind == Primitive_kind::CIRCLE ? 4 : 7;
  }

  bool is_supported(std::size_t first, std::size_t size, Primitive_kind kind) const
  {
    std::size_t supported = 0;
    const Station_range stations = range(first, size);
    for (std::size_t i = 0; i < size; ++i)
      supported += stations[i].is_supported();
    return supported >= least_size(kind) && double(supported) >= least_share_supported * double(size);
  }

  // a piece without fit if the kind is not what the stations show
  Curve_piece try_piece(Primitive_kind kind, std::size_t first, std::size_t size) const
  {
    // the same pieces are tried from every start of a closed curve
    const auto known = m_known.find({kind, first, size});
    if (known != m_known.end())
      return known->second;
    return m_known[{kind, first, size}] = fit_piece(kind, first, size);
  }

  Curve_piece fit_piece(Primitive_kind kind, std::size_t first, std::size_t size) const
  {
    Curve_piece piece;
    piece.first = first;
    piece.size = size;
    const bool is_whole_loop = m_is_closed && size == m_stations.size();
    if (!is_supported(first, size, kind) || (is_whole_loop && kind == Primitive_kind::LINE))
      return piece;
    const auto fit = std::make_shared<Primitive_fit>(kind, range(first, size), m_significance);
    if (fit->is_valid && fit->misfit.probability(fit->curve.number_of_parameters()) >= m_significance
        && runs_forward(fit->curve, first, size) && reaches_ends(fit->curve, first, size)
        && Primitive_course(fit->curve).follows(range(first, size), is_whole_loop))
      piece.fit = fit;
    return piece;
  }

  // Outliers in the middle are errors of the field, but where the stations leave the curve at its end for good, it has
  // ended before.
  bool reaches_ends(const Primitive_curve& curve, std::size_t first, std::size_t size) const
  {
    const std::size_t n = m_stations.size();
    if (m_is_closed && size == n)
      return true;
    const auto leaves = [&](std::size_t i) { return !(Primitive_fit::square(curve, m_stations[i % n]) < Misfit::cap); };
    const auto misses = [&](const Vector& p) { return !((curve.foot(p) - p).norm() < most_miss); };
    const bool starts_at_vertex = !m_is_closed && first == 0, ends_at_vertex = !m_is_closed && first + size == n;
    return !(starts_at_vertex ? misses(m_ends[0]) : leaves(first))
      && !(ends_at_vertex ? misses(m_ends[1]) : leaves(first + size - 1));
  }

  // whether the stations follow the curve without turning back, and go round it once at most
  bool runs_forward(const Primitive_curve& curve, std::size_t first, std::size_t size) const
  {
    const Station_range stations = range(first, size);
    double forward = 0., backward = 0.;
    for (std::size_t i = 1; i < size; ++i)
    {
      double step = curve.parameter(stations[i].position) - curve.parameter(stations[i - 1].position);
      if (curve.kind != Primitive_kind::LINE)
        step = std::remainder(step, 2. * CGAL_PI);
      (step > 0. ? forward : backward) += std::abs(step);
    }
    return (std::min)(forward, backward) < most_backward * (std::max)(forward, backward)
      && (curve.kind == Primitive_kind::LINE || std::abs(forward - backward) < 2. * CGAL_PI);
  }

  double cost(const Curve_piece& piece) const
  {
    if (piece.fit)
      return Misfit::share_of_independent * piece.fit->misfit.capped()
        + (piece.fit->curve.number_of_parameters() + 1) * m_log_size;
    return least_spline_parameters * m_log_size + m_spline_costs[piece.first + piece.size]
      - m_spline_costs[piece.first];
  }

  // sums of what the spline costs at each station; twice round, for pieces that pass the end of a closed curve
  static std::vector<double> spline_costs(const std::vector<Station>& stations, double cost_of_parameters)
  {
    std::vector<double> sums(1, 0.);
    for (std::size_t i = 0; i < 2 * stations.size(); ++i)
    {
      const Station& station = stations[i % stations.size()];
      const Vector residual = station.followed - station.position;
      Misfit misfit;
      misfit.add(residual.dot(station.information * residual));
      sums.push_back(sums.back() + Misfit::share_of_independent * misfit.capped() + cost_of_parameters);
    }
    return sums;
  }

  // Whether a smooth curve may go on from one piece to the next: their curves meet in the middle between the stations
  // around the cut, and in the same direction.
  bool can_follow(const Curve_piece& before, const Curve_piece& after) const
  {
    if (!before.fit || !after.fit)
      return true;
    const std::size_t n = m_stations.size();
    const Station &last = m_stations[(after.first + n - 1) % n], &next = m_stations[after.first % n];
    const Vector middle = 0.5 * (last.position + next.position);
    const Vector tangent = next.position - last.position;
    const Vector one = oriented(before.fit->curve.tangent(middle), tangent);
    const Vector two = oriented(after.fit->curve.tangent(middle), tangent);
    const double gap = (before.fit->curve.foot(middle) - after.fit->curve.foot(middle)).norm();
    return gap < most_gap && one.dot(two) > std::cos(most_turn);
  }

  static Vector oriented(const Vector& v, const Vector& along) { return v.dot(along) < 0. ? Vector(-v) : v; }

  Curve_piece spline(std::size_t first, std::size_t size) const
  {
    Curve_piece result;
    result.first = first % m_stations.size();
    result.size = size;
    return result;
  }

  // a path of pieces from the start to a node, the last of which is `piece`
  struct Path
  {
    Curve_piece piece;
    double total = 0.;
    std::size_t node = 0, path = 0; // the path that it continues
  };

  // the pieces between two nodes that are possible; the spline always is
  void add_paths(std::size_t start, std::size_t from, std::size_t size, std::array<int, 2>& failures,
                 std::vector<Path>& paths) const
  {
    Path path;
    path.piece = spline(start + from, size);
    paths.push_back(path);
    for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE})
    {
      int& failed = failures[kind == Primitive_kind::LINE ? 0 : 1];
      // what fails on two windows in a row fails on all that contain them
      if (failed >= most_failures || size < least_size(kind))
        continue;
      path.piece = try_piece(kind, path.piece.first, size);
      failed = path.piece.fit ? 0 : failed + 1;
      if (path.piece.fit)
        paths.push_back(path);
      if (path.piece.is_line())
        break;
    }
  }

  // How many stations one line or circle explains, from station `from` of those after `start` on: forward up to `end`,
  // or backward down to 0. Found by doubling and bisection.
  std::size_t largest_window(std::size_t start, std::size_t from, std::size_t end, bool is_forward) const
  {
    const std::size_t available = is_forward ? end - from : from;
    const auto is_explained = [&](Primitive_kind kind, std::size_t size) {
      const std::size_t first = is_forward ? from : from - size;
      return bool(try_piece(kind, (start + first) % m_stations.size(), size).fit);
    };
    std::size_t largest = 0;
    for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE})
    {
      std::size_t good = (std::max)(largest, least_size(kind)), bad = good;
      if (good > available || !is_explained(kind, good))
        continue;
      while (bad == good && good < available)
      {
        const std::size_t next = (std::min)(2 * good, available);
        if (is_explained(kind, next))
          good = bad = next;
        else
          bad = next;
      }
      while (bad > good + 1)
      {
        const std::size_t middle = (good + bad) / 2;
        (is_explained(kind, middle) ? good : bad) = middle;
      }
      largest = (std::max)(largest, good);
    }
    return largest;
  }

  // Where lines and circles that start as early as possible, or as late as possible, end; and the stations around.
  std::vector<std::size_t> places_for_cuts(std::size_t start) const
  {
    const std::size_t n = m_stations.size();
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < n && goes_on();)
    {
      i += (std::max)(+least_step, largest_window(start, i, n, true));
      ends.push_back(i);
    }
    for (std::size_t i = n; i > 0 && goes_on();)
    {
      i -= (std::min)(i, (std::max)(+least_step, largest_window(start, i, n, false)));
      ends.push_back(i);
    }
    std::vector<std::size_t> places{0, n};
    for (const std::size_t end : ends)
      for (std::size_t i = end > reach ? end - reach : 0; i <= (std::min)(n, end + reach); ++i)
        places.push_back(i);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (places.size() > most_places)
      thin_out(places);
    return places;
  }

  // Along a free-form curve there are many places, none of which matters much.
  static void thin_out(std::vector<std::size_t>& places)
  {
    const std::size_t step = (places.size() + most_places - 1) / most_places;
    std::vector<std::size_t> fewer;
    for (std::size_t i = 0; i + 1 < places.size(); i += step)
      fewer.push_back(places[i]);
    fewer.push_back(places.back());
    places = fewer;
  }

  std::vector<Curve_piece> cut(std::size_t start) const
  {
    const std::vector<std::size_t> nodes = places_for_cuts(start);
    std::vector<std::vector<Path>> paths(nodes.size());
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    {
      if (!goes_on())
        return {spline(start, m_stations.size())};
      std::array<int, 2> failures{{0, 0}};
      for (std::size_t j = i + 1; j < nodes.size(); ++j)
      {
        std::vector<Path> next;
        add_paths(start, nodes[i], nodes[j] - nodes[i], failures, next);
        for (Path& path : next)
          if (extend(paths[i], i, path))
            paths[j].push_back(path);
      }
    }
    const auto best = std::min_element(paths.back().begin(), paths.back().end(),
                                       [](const Path& a, const Path& b) { return a.total < b.total; });
    std::vector<Curve_piece> pieces;
    for (const Path* path = &*best;; path = &paths[path->node][path->path])
    {
      pieces.push_back(path->piece);
      if (path->node == 0)
        break;
    }
    std::reverse(pieces.begin(), pieces.end());
    return pieces;
  }

  // continues the cheapest of the paths that end where `path` starts and that it can follow
  bool extend(const std::vector<Path>& before, std::size_t node, Path& path) const
  {
    path.node = node;
    path.total = cost(path.piece);
    if (node == 0)
      return true;
    double least = (std::numeric_limits<double>::max)();
    for (std::size_t k = 0; k < before.size(); ++k)
      if (before[k].total < least && can_follow(before[k].piece, path.piece))
      {
        least = before[k].total;
        path.path = k;
      }
    path.total += least;
    return least < (std::numeric_limits<double>::max)();
  }

  // from the best start around the given one, such that the last piece goes on in the first one
  std::vector<Curve_piece> cut_closed(std::size_t start) const
  {
    const std::size_t n = m_stations.size();
    std::vector<Curve_piece> best;
    double least = (std::numeric_limits<double>::max)();
    for (std::size_t shift = 0; shift <= 2 * reach && shift < n; ++shift)
    {
      const std::vector<Curve_piece> pieces = cut((start + n + shift - (std::min)(reach, n)) % n);
      double total = 0.;
      for (const Curve_piece& piece : pieces)
        total += cost(piece);
      if (total < least && can_follow(pieces.back(), pieces.front()))
      {
        least = total;
        best = pieces;
      }
    }
    if (best.empty())
    {
      best = cut(start);
      part_where_it_closes(best);
    }
    return best;
  }

  // puts a spline where the curve closes
  void part_where_it_closes(std::vector<Curve_piece>& pieces) const
  {
    const std::size_t n = m_stations.size();
    Curve_piece &last = pieces.back(), &first = pieces.front();
    if (last.size < 2 || first.size < 2)
      return;
    const Curve_piece between = spline(first.first + n - 1, 2);
    last = same_kind(last, last.first, last.size - 1);
    first = same_kind(first, (first.first + 1) % n, first.size - 1);
    pieces.push_back(between);
  }

  Curve_piece same_kind(const Curve_piece& piece, std::size_t first, std::size_t size) const
  {
    return piece.fit ? try_piece(piece.fit->curve.kind, first, size) : spline(first, size);
  }

  // Enough arcs approximate any smooth curve: three in a row, two and a spline, or less of arcs than of splines, are no
  // evidence of arcs.
  void join_chains_of_arcs(std::vector<Curve_piece>& pieces) const
  {
    std::vector<Curve_piece> result;
    for (std::size_t k = 0; k < pieces.size();)
    {
      if (pieces[k].is_line())
      {
        result.push_back(pieces[k++]);
        continue;
      }
      std::size_t end = k, arcs = 0, on_arcs = 0;
      Curve_piece joined;
      joined.first = pieces[k].first;
      for (; end < pieces.size() && !pieces[end].is_line(); ++end)
      {
        joined.size += pieces[end].size;
        arcs += bool(pieces[end].fit);
        on_arcs += pieces[end].fit ? pieces[end].size : 0;
      }
      if ((end >= k + 3 && arcs >= 2) || 2 * on_arcs < joined.size)
        result.push_back(joined);
      else
        result.insert(result.end(), pieces.begin() + long(k), pieces.begin() + long(end));
      k = end;
    }
    pieces = result;
  }

  // arcs of circles and splines side by side may be one arc, of a circle or an ellipse
  void join_arcs(std::vector<Curve_piece>& pieces) const
  {
    std::vector<Curve_piece> result;
    for (std::size_t k = 0; k < pieces.size();)
    {
      std::size_t end = k, size = 0;
      double total = 0.;
      for (; end < pieces.size() && !pieces[end].is_line(); ++end)
      {
        size += pieces[end].size;
        total += cost(pieces[end]);
      }
      Curve_piece joined;
      if (end > k + 1 || (end == k + 1 && !pieces[k].fit))
        joined = first_that_fits({Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE}, pieces[k].first, size);
      end = (std::max)(end, k + 1);
      if (joined.fit && cost(joined) < total && (result.empty() || can_follow(result.back(), joined))
          && (end == pieces.size() || can_follow(joined, pieces[end])))
        result.push_back(joined);
      else
        result.insert(result.end(), pieces.begin() + long(k), pieces.begin() + long(end));
      k = end;
    }
    pieces = result;
  }

  Curve_piece first_that_fits(std::initializer_list<Primitive_kind> kinds, std::size_t first, std::size_t size) const
  {
    Curve_piece piece;
    for (const Primitive_kind kind : kinds)
      if (!piece.fit)
        piece = try_piece(kind, first, size);
    return piece;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_CUTTER_H
