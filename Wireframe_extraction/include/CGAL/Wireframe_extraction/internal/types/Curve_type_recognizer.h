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

#ifndef CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_TYPE_RECOGNIZER_H
#define CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_TYPE_RECOGNIZER_H

#include <CGAL/Wireframe_extraction/internal/base/Progress.h>
#include <CGAL/Wireframe_extraction/internal/base/for_each_piece.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_cutter.h>
#include <CGAL/Wireframe_extraction/internal/types/Curve_stations.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_course.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_network_fit.h>
#include <CGAL/Wireframe_extraction/internal/types/Primitive_parts.h>
#include <CGAL/Wireframe_extraction/internal/types/Typed_piece.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL {
namespace Wireframe_extraction {
namespace internal {

// Finds the lines, circles and ellipses among curves, and cuts curves that are made of several.
class Curve_type_recognizer
{
  // a cut does not become a tangent join where the pieces meet at a larger angle
  static constexpr double most_tangent_angle = 15. * CGAL_PI / 180.;
  static constexpr double most_kink = 8. * CGAL_PI / 180.; // and none is left where they do not become tangent
  // the tangent of a spline may change by that much from the cut to its first station
  static constexpr double most_spline_turn = 85. * CGAL_PI / 180.;

  // Near a vertex, the points of the other curves that meet there mix in: up to such a distance, since that is how far
  // points support a curve, with an error that falls from the vertex on.
  static constexpr double vertex_reach = 3., most_vertex_deviation = 0.1; // r
  // How firmly the field kept the end of a spline.
  static constexpr double least_spline_deviation = 0.05, spline_deviation_per_noise = 2.;
  // In stations: a shorter primitive keeps its ends, or too little would be left of what shows it
  // (a circle needs four).
  static constexpr std::size_t least_left_of_primitive = 5;
  // r, along a smooth curve that is cut into a primitive and a spline: half of what a station stands for
  static constexpr double deviation_of_cut = 0.5 * Curve_stations::spacing;
  // further than from one station to the next but one, no vertex goes by itself
  static constexpr double farthest_move = 2. * Curve_stations::spacing;
  // of the significance: what is less likely is refuted beyond doubt
  static constexpr double share_of_narrow = 0.01;
  static constexpr double least_extent = 1e-3; // r, of a line or a radius: below, it is a point
  // Shares of the time, for who waits: finding the points of the curves, and cutting these. How many rounds the common
  // fit takes is not known; each is taken for a half of what is left.
  static constexpr double share_of_support = 0.1, share_of_cuts = 0.6, share_of_round = 0.5;

  struct Candidate
  {
    std::vector<Station> stations;
    double length = 0.;
    std::vector<Curve_piece> pieces;
    std::vector<std::size_t> vertices; // before each piece, and after the last
    std::vector<char> is_tangent;      // whether the join before each piece may be tangent
    bool is_closed = false;            // and free of vertices, but for cuts
  };

  const Field_band& m_band;
  const double m_noise, m_support_distance, m_significance;
  const bool m_is_regularized;
  const std::vector<Untyped_curve>& m_curves;
  std::vector<std::vector<Curve_support>> m_support;
  std::vector<Candidate> m_candidates;
  std::vector<Vector> m_anchors, m_vertices;
  std::vector<Regularity> m_regularities; // of the pieces
  Primitive_parts m_parts;
  Progress m_progress;

  struct Edge_of_piece
  {
    std::size_t curve, piece;
  };

public:
  Curve_type_recognizer(const Field_band& band, double noise, double support_distance, double significance,
                        bool is_regularized, const std::vector<Vector>& vertices,
                        const std::vector<Untyped_curve>& curves, const std::function<bool(double)>& proceed)
    : m_band(band), m_noise(noise), m_support_distance(support_distance), m_significance(significance),
      m_is_regularized(is_regularized), m_curves(curves), m_anchors(vertices), m_vertices(vertices), m_progress(proceed)
  {}

  const std::vector<Vector>& vertices() const { return m_vertices; }
  const std::vector<Regularity>& regularities() const { return m_regularities; }

  bool is_cancelled() const { return m_progress.is_cancelled(); }

  // after cancelling, nothing
  std::vector<Typed_piece> run()
  {
    if (!m_progress.goes_on())
      return {};
    const Curve_stations stations(m_band, m_noise, m_support_distance);
    std::vector<std::vector<Vector>> polylines;
    for (const Untyped_curve& curve : m_curves)
      polylines.push_back(curve.polyline);
    m_support = stations.find_support(polylines);
    m_candidates.resize(m_curves.size());
    std::atomic<std::size_t> number_cut{0};
    const auto goes_on = [&] {
      const double share = double(number_cut) / double(m_curves.size());
      return m_progress.reach(share_of_support + share * (share_of_cuts - share_of_support));
    };
    for_each_piece(
      m_curves.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end && goes_on(); ++c, ++number_cut)
          m_candidates[c] = cut(m_curves[c], stations.run(polylines[c], m_support[c]));
      },
      1);
    if (is_cancelled())
      return {};
    for (std::size_t c = 0; c < m_curves.size(); ++c)
      place_vertices(m_curves[c], m_candidates[c]);
    std::vector<Typed_piece> result;
    // each round leaves fewer tangencies or primitives
    double left = 1. - share_of_cuts;
    while (m_progress.reach(1. - left) && !fit(result))
      left *= share_of_round;
    if (is_cancelled())
      result.clear();
    return result;
  }

private:
  Candidate cut(const Untyped_curve& curve, std::vector<Station> stations)
  {
    Candidate result;
    result.stations = std::move(stations);
    result.length = arc_lengths(curve.polyline).back();
    if (!curve.is_closed_without_vertex())
      loosen_ends(result.stations, result.length);
    // no spline can use more parameters than there are observations
    const double density = (std::min)(1., curve.number_of_parameters / double(result.stations.size()));
    result.pieces = Curve_cutter(result.stations, density, {{curve.polyline.front(), curve.polyline.back()}},
                                 curve.is_closed_without_vertex(), m_significance, &m_progress)
                      .run();
    result.is_closed = curve.is_closed_without_vertex();
    if (curve.is_loop() && result.pieces.size() == 1 && result.pieces[0].is_line())
      result.pieces[0].fit.reset();
    merge_splines(result);
    lengthen_splines(result);
    return result;
  }

  void place_vertices(const Untyped_curve& curve, Candidate& result)
  {
    result.vertices.push_back(curve.vertices[0]);
    for (std::size_t i = 1; i < result.pieces.size(); ++i)
      result.vertices.push_back(add_vertex(place_of_cut(result, i)));
    result.vertices.push_back(curve.vertices[1]);
    if (curve.is_closed_without_vertex() && result.pieces.size() > 1)
      result.vertices.front() = result.vertices.back() = add_vertex(place_of_cut(result, 0));
    result.is_tangent.assign(result.pieces.size(), 1);
    result.is_tangent[0] = curve.is_closed_without_vertex() && result.pieces.size() > 1;
  }

  static void loosen_ends(std::vector<Station>& stations, double length)
  {
    for (Station& station : stations)
    {
      const double distance = (std::min)(station.parameter, length - station.parameter);
      const double deviation = most_vertex_deviation * (std::max)(0., 1. - distance / vertex_reach);
      // where there is most information, its inverse grows by the variance
      station.information /= 1. + 0.5 * station.information.trace() * deviation * deviation;
    }
  }

  // splines side by side are one
  void merge_splines(Candidate& candidate) const
  {
    std::vector<Curve_piece> pieces;
    for (const Curve_piece& piece : candidate.pieces)
      if (!piece.fit && !pieces.empty() && !pieces.back().fit)
        pieces.back().size += piece.size;
      else
        pieces.push_back(piece);
    if (candidate.is_closed && pieces.size() > 1 && !pieces.front().fit && !pieces.back().fit)
    {
      pieces.back().size += pieces.front().size;
      pieces.erase(pieces.begin());
    }
    candidate.pieces = pieces;
  }

  // A primitive may reach as far into the bend that follows as the noise allows; the spline that was fitted to the bend
  // leads over from it only where both are the same. So a spline takes over the last station of its neighbors.
  static void lengthen_splines(Candidate& candidate)
  {
    const std::size_t n = candidate.pieces.size();
    for (std::size_t i = candidate.is_closed ? 0 : 1; n > 1 && i < n; ++i)
    {
      Curve_piece &before = candidate.pieces[(i + n - 1) % n], &after = candidate.pieces[i];
      if (bool(before.fit) == bool(after.fit))
        continue;
      Curve_piece& primitive = before.fit ? before : after;
      if (primitive.size <= least_left_of_primitive)
        continue;
      --primitive.size;
      ++(before.fit ? after : before).size;
      if (before.fit)
        after.first = (after.first + candidate.stations.size() - 1) % candidate.stations.size();
      else
        after.first = (after.first + 1) % candidate.stations.size();
    }
  }

  std::size_t add_vertex(const Vector& place)
  {
    m_anchors.push_back(place);
    m_vertices.push_back(place);
    return m_anchors.size() - 1;
  }

  // between the last station of one piece and the first of the next
  static Vector place_of_cut(const Candidate& candidate, std::size_t i)
  {
    const std::size_t n = candidate.stations.size(), first = candidate.pieces[i].first;
    const Station &before = candidate.stations[(first + n - 1) % n], &after = candidate.stations[first % n];
    return 0.5 * (before.position + after.position);
  }

  static Station_range range(const Candidate& candidate, const Curve_piece& piece)
  {
    return Station_range(candidate.stations, piece.first, piece.size);
  }

  // The edges that others hold: a closed curve without vertex is among them only if regularities may hold it.
  bool is_in_network(std::size_t c, std::size_t i) const
  {
    return m_candidates[c].pieces[i].fit
      && (m_is_regularized || m_candidates[c].vertices[i] != Untyped_curve::no_vertex);
  }

  // Fits all primitives and writes the pieces. Returns false if some do not go together with the others, or after
  // cancelling.
  bool fit(std::vector<Typed_piece>& result)
  {
    Primitive_network_fit network;
    network.vertices = m_anchors;
    std::vector<Edge_of_piece> places;
    std::vector<std::vector<std::size_t>> edges(m_candidates.size());
    for (std::size_t c = 0; c < m_candidates.size(); ++c)
      for (std::size_t i = 0; i < m_candidates[c].pieces.size(); ++i)
      {
        edges[c].push_back(network.edges.size());
        if (is_in_network(c, i))
        {
          network.edges.push_back(make_edge(m_candidates[c], i));
          places.push_back({c, i});
        }
      }
    for (std::size_t c = 0; c < m_candidates.size(); ++c)
    {
      add_tangencies(c, edges[c], network);
      add_spline_ends(c, network);
    }
    m_parts.run(network, &m_progress);
    if (is_cancelled() || take_back(network, places, edges))
      return false;
    if (m_is_regularized)
      regularize(network, places);
    if (is_cancelled())
      return false;
    m_vertices = network.vertices;
    write(network, edges, result);
    return true;
  }

  // Makes regular what the evidence allows: a curve that would contradict the field is left as it is.
  void regularize(Primitive_network_fit& network, const std::vector<Edge_of_piece>& places)
  {
    std::vector<Measured_curve> curves;
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      Typed_piece piece;
      const Candidate& candidate = m_candidates[places[k].curve];
      set_deviations(candidate, candidate.pieces[places[k].piece], piece);
      curves.push_back({network.edges[k].curve(network.vertices), piece.position_deviation, piece.direction_deviation,
                        piece.major_radius_deviation});
    }
    const Primitive_network_fit kept = network;
    std::vector<Regularity> regularities = Regularity_finder(curves).run();
    while (!regularities.empty())
    {
      network = kept;
      network.regularities = regularities;
      m_parts.run(network, &m_progress, true);
      if (is_cancelled())
        return;
      std::vector<char> is_contradicted(places.size(), 0);
      for (std::size_t k = 0; k < places.size(); ++k)
        is_contradicted[k] = network.is_violated(k)
          || !is_supported(network.edges[k].curve(network.vertices), network, network.edges[k],
                           m_candidates[places[k].curve], places[k].piece);
      const auto first_bad =
        std::remove_if(regularities.begin(), regularities.end(), [&](const Regularity& regularity) {
          return is_contradicted[regularity.curves[0]] || is_contradicted[regularity.curves[1]];
        });
      const bool is_done = std::find(is_contradicted.begin(), is_contradicted.end(), 1) == is_contradicted.end();
      if (is_done || first_bad == regularities.end())
      {
        if (!is_done)
          regularities.clear();
        break;
      }
      regularities.erase(first_bad, regularities.end());
    }
    if (regularities.empty())
      network = kept;
    m_regularities = of_pieces(regularities, places);
  }

  // with indices of pieces in the order in which they are written, in place of those of edges
  std::vector<Regularity> of_pieces(std::vector<Regularity> regularities,
                                    const std::vector<Edge_of_piece>& places) const
  {
    std::vector<std::size_t> first(1, 0);
    for (const Candidate& candidate : m_candidates)
      first.push_back(first.back() + candidate.pieces.size());
    for (Regularity& regularity : regularities)
      for (std::size_t& k : regularity.curves)
        k = first[places[k].curve] + places[k].piece;
    return regularities;
  }

  static Primitive_edge make_edge(const Candidate& candidate, std::size_t i)
  {
    const Curve_piece& piece = candidate.pieces[i];
    const Primitive_curve& curve = piece.fit->curve;
    const Station_range stations = range(candidate, piece);
    const auto point = [&](double share) {
      return curve.foot(
        stations[(std::min)(stations.size() - 1, std::size_t(share * double(stations.size())))].position);
    };
    Primitive_edge edge;
    edge.kind = curve.kind;
    edge.vertices = {{candidate.vertices[i], candidate.vertices[i + 1]}};
    if (edge.kind == Primitive_kind::CIRCLE && !edge.has_vertex())
      edge.points = {{point(0.), point(1. / 3.), point(2. / 3.)}};
    else if (edge.kind == Primitive_kind::ELLIPSE)
      edge.points = {{curve.center, curve.at(0.), curve.at(0.5 * CGAL_PI)}};
    else if (edge.is_loop())
      edge.points = {{point(1. / 3.), point(2. / 3.), Vector::Zero()}};
    else
      edge.points[0] = point(0.5);
    for (std::size_t k = 0; k < stations.size(); ++k)
      edge.stations.push_back(stations[k]);
    return edge;
  }

  void add_tangencies(std::size_t c, const std::vector<std::size_t>& edges, Primitive_network_fit& network) const
  {
    const Candidate& candidate = m_candidates[c];
    const std::size_t n = candidate.pieces.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t before = (i + n - 1) % n;
      if (candidate.is_tangent[i] && candidate.pieces[i].fit && candidate.pieces[before].fit
          && are_tangent(candidate, before, i))
        network.tangencies.push_back({candidate.vertices[i], {{edges[before], edges[i]}}});
    }
  }

  bool are_tangent(const Candidate& candidate, std::size_t before, std::size_t after) const
  {
    const Curve_piece &one = candidate.pieces[before], &two = candidate.pieces[after];
    if (one.is_line() && two.is_line())
      return false;
    const Vector& place = m_anchors[candidate.vertices[after]];
    return one.fit->curve.tangent(place).cross(two.fit->curve.tangent(place)).norm() < std::sin(most_tangent_angle);
  }

  void add_spline_ends(std::size_t c, Primitive_network_fit& network) const
  {
    const Candidate& candidate = m_candidates[c];
    for (std::size_t i = 0; i < candidate.pieces.size(); ++i)
    {
      if (candidate.pieces[i].fit || candidate.vertices[i] == Untyped_curve::no_vertex)
        continue;
      const Station_range stations = range(candidate, candidate.pieces[i]);
      const double deviation = (std::max)(+least_spline_deviation, spline_deviation_per_noise * m_noise);
      for (int e = 0; e < 2; ++e)
      {
        const std::size_t vertex = candidate.vertices[i + std::size_t(e)], n = candidate.pieces.size(),
                          neighbor = e == 0 ? (i + n - 1) % n : (i + 1) % n;
        Primitive_network_fit::Spline_end end{
          vertex, m_anchors[vertex], (e == 0 ? stations[0] : stations[stations.size() - 1]).tangent, deviation};
        if (is_cut(candidate, e == 0 ? i : neighbor) && candidate.pieces[neighbor].fit)
        {
          // the primitive tells the direction, the cut the place: there, no other curve holds the vertex
          end.tangent = candidate.pieces[neighbor].fit->curve.tangent(m_anchors[vertex]);
          end.along = deviation_of_cut;
        }
        network.spline_ends.push_back(end);
      }
    }
  }

  // Gives up what does not go together: tangencies first, then primitives. Returns whether there was such a thing.
  bool take_back(Primitive_network_fit& network, const std::vector<Edge_of_piece>& places,
                 const std::vector<std::vector<std::size_t>>& edges)
  {
    bool is_changed = false;
    std::vector<std::vector<char>> were_tangent; // before this round: the order of the edges must not matter
    for (const Candidate& candidate : m_candidates)
      were_tangent.push_back(candidate.is_tangent);
    for (std::size_t k = 0; k < places.size(); ++k)
    {
      Candidate& candidate = m_candidates[places[k].curve];
      const std::vector<char>& was_tangent = were_tangent[places[k].curve];
      const std::size_t i = places[k].piece, n = candidate.pieces.size();
      const Primitive_curve curve = network.edges[k].curve(network.vertices);
      if (!network.is_violated(k) && is_supported(curve, network, network.edges[k], candidate, i))
        continue;
      is_changed = true;
      if (was_tangent[i] || was_tangent[(i + 1) % n])
        candidate.is_tangent[i] = candidate.is_tangent[(i + 1) % n] = 0;
      else
        candidate.pieces[i].fit.reset();
    }
    is_changed = is_changed || take_back_kinks(network, edges);
    if (is_changed)
      for (std::size_t c = 0; c < m_candidates.size(); ++c)
        drop_cuts_between_splines(c);
    return is_changed;
  }

  // Of two pieces that are no longer tangent where a smooth curve was cut, the shorter one is no primitive.
  bool take_back_kinks(Primitive_network_fit& network, const std::vector<std::vector<std::size_t>>& edges)
  {
    bool is_changed = false;
    for (std::size_t c = 0; c < m_candidates.size(); ++c)
    {
      const Candidate& candidate = m_candidates[c];
      std::vector<Curve_piece>& pieces = m_candidates[c].pieces;
      for (std::size_t i = 0; i < pieces.size(); ++i)
      {
        const std::size_t before = (i + pieces.size() - 1) % pieces.size();
        if (!is_cut(candidate, i) || !pieces[i].fit || !pieces[before].fit)
          continue;
        const Vector& place = network.vertices[candidate.vertices[i]];
        const double sine = network.edges[edges[c][i]]
                              .curve(network.vertices)
                              .tangent(place)
                              .cross(network.edges[edges[c][before]].curve(network.vertices).tangent(place))
                              .norm();
        if (sine > std::sin(most_kink))
        {
          pieces[pieces[i].size < pieces[before].size ? i : before].fit.reset();
          is_changed = true;
        }
      }
    }
    return is_changed;
  }

  // whether the curve was cut before this piece; before the first one that can only be if it is closed
  bool is_cut(const Candidate& candidate, std::size_t i) const
  {
    return i > 0 || (candidate.pieces.size() > 1 && candidate.is_closed);
  }

  void drop_cuts_between_splines(std::size_t c)
  {
    Candidate& candidate = m_candidates[c];
    std::vector<Curve_piece>& pieces = candidate.pieces;
    for (std::size_t i = pieces.size() - 1; i > 0; --i)
      if (!pieces[i].fit && !pieces[i - 1].fit)
      {
        pieces[i - 1].size += pieces[i].size;
        pieces.erase(pieces.begin() + long(i));
        candidate.vertices.erase(candidate.vertices.begin() + long(i));
        candidate.is_tangent.erase(candidate.is_tangent.begin() + long(i));
      }
    if (candidate.is_closed && pieces.size() > 1 && !pieces.front().fit && !pieces.back().fit)
    {
      pieces.back().size += pieces.front().size;
      pieces.erase(pieces.begin());
      candidate.vertices.erase(candidate.vertices.begin());
      candidate.vertices.back() = candidate.vertices.front();
      candidate.is_tangent.erase(candidate.is_tangent.begin());
    }
    if (pieces.size() == 1 && !pieces[0].fit)
    {
      pieces[0].first = 0;
      candidate.vertices = {m_curves[c].vertices[0], m_curves[c].vertices[1]};
      candidate.is_tangent = {0};
    }
  }

  bool is_supported(const Primitive_curve& curve, const Primitive_network_fit& network, const Primitive_edge& edge,
                    const Candidate& candidate, std::size_t i) const
  {
    for (const std::size_t v : edge.vertices)
      if (edge.has_vertex() && !((network.vertices[v] - m_anchors[v]).norm() < farthest_move))
        return false;
    if (!edge.is_loop()
        && !((network.vertices[edge.vertices[0]] - network.vertices[edge.vertices[1]]).norm() > least_extent))
      return false;
    return curve.is_finite() && (curve.kind == Primitive_kind::LINE || curve.minor_radius > least_extent)
      && Primitive_fit::misfit_of(curve, range(candidate, candidate.pieces[i]))
           .probability(curve.number_of_parameters())
      >= m_significance
      && keeps_course(curve, network, edge, candidate, i);
  }

  // whether the curve that would be written stays with the one that it replaces
  bool keeps_course(const Primitive_curve& curve, const Primitive_network_fit& network, const Primitive_edge& edge,
                    const Candidate& candidate, std::size_t i) const
  {
    const Primitive_course course(curve);
    const Station_range stations = range(candidate, candidate.pieces[i]);
    if (!edge.has_vertex())
      return course.follows(stations, true);
    const auto end = [&](int e) {
      return Primitive_course::End{network.vertices[edge.vertices[e]], m_anchors[edge.vertices[e]]};
    };
    return edge.is_loop() ? course.follows(stations, end(0)) : course.follows(stations, end(0), end(1));
  }

  void write(Primitive_network_fit& network, const std::vector<std::vector<std::size_t>>& edges,
             std::vector<Typed_piece>& result) const
  {
    for (std::size_t c = 0; c < m_candidates.size(); ++c)
    {
      const Candidate& candidate = m_candidates[c];
      for (std::size_t i = 0; i < candidate.pieces.size(); ++i)
      {
        Typed_piece piece = outline(c, i);
        if (candidate.pieces[i].fit)
        {
          piece.is_primitive = true;
          piece.shape =
            is_in_network(c, i) ? network.edges[edges[c][i]].curve(network.vertices) : candidate.pieces[i].fit->curve;
          set_deviations(candidate, candidate.pieces[i], piece);
          measure(piece);
        }
        else
        {
          piece.is_type_uncertain = is_narrowly_refuted(range(candidate, candidate.pieces[i]));
          if (!piece.is_whole)
          {
            set_end_tangents(candidate, i, network, edges[c], piece);
            measure(piece);
          }
        }
        result.push_back(piece);
      }
    }
  }

  // whether the most likely primitive is less likely than the significance, but not by far
  bool is_narrowly_refuted(const Station_range& stations) const
  {
    const double least = share_of_narrow * m_significance;
    double best = 0.;
    for (const Primitive_kind kind : {Primitive_kind::LINE, Primitive_kind::CIRCLE, Primitive_kind::ELLIPSE})
    {
      const Primitive_fit fit(kind, stations, least);
      if (fit.is_valid)
        best = (std::max)(best, fit.misfit.probability(fit.curve.number_of_parameters()));
    }
    return best >= least && best < m_significance;
  }

  Typed_piece outline(std::size_t c, std::size_t i) const
  {
    const Candidate& candidate = m_candidates[c];
    const Curve_piece& stations = candidate.pieces[i];
    Typed_piece piece;
    piece.curve = c;
    piece.is_whole = candidate.pieces.size() == 1;
    piece.vertices = {{candidate.vertices[i], candidate.vertices[i + 1]}};
    const double step = candidate.length / double(candidate.stations.size());
    piece.range = {{step * double(stations.first), step * double(stations.first + stations.size)}};
    piece.middle = range(candidate, stations)[stations.size / 2].position;
    return piece;
  }

  static void set_deviations(const Candidate& candidate, const Curve_piece& stations, Typed_piece& piece)
  {
    const Primitive_fit& fit = *stations.fit;
    const Primitive_fit::Covariance covariance = fit.covariance(range(candidate, stations));
    const auto deviation = [&](std::initializer_list<int> indices) {
      double variance = 0.;
      for (const int i : indices)
        variance += covariance(i, i) / Misfit::share_of_independent;
      return variance > 0. && std::isfinite(variance) ? std::sqrt(variance) : 0.;
    };
    switch (fit.curve.kind)
    {
    case Primitive_kind::LINE:
      piece.position_deviation = deviation({0, 1});
      piece.direction_deviation = deviation({2, 3});
      break;
    case Primitive_kind::CIRCLE:
      piece.position_deviation = deviation({0, 1, 2});
      piece.direction_deviation = deviation({3, 4});
      piece.major_radius_deviation = piece.minor_radius_deviation = deviation({5});
      break;
    case Primitive_kind::ELLIPSE:
      piece.position_deviation = deviation({0, 1, 2});
      piece.direction_deviation = deviation({3, 4});
      piece.major_radius_deviation = deviation({6});
      piece.minor_radius_deviation = deviation({7});
    }
  }

  // a spline goes on in the direction of the primitives that it was cut from
  void set_end_tangents(const Candidate& candidate, std::size_t i, Primitive_network_fit& network,
                        const std::vector<std::size_t>& edges, Typed_piece& piece) const
  {
    const std::size_t n = candidate.pieces.size();
    const Station_range stations = range(candidate, candidate.pieces[i]);
    for (const bool is_end : {false, true})
    {
      const std::size_t neighbor = is_end ? (i + 1) % n : (i + n - 1) % n;
      if (!is_cut(candidate, is_end ? neighbor : i) || !candidate.pieces[neighbor].fit)
        continue;
      const Vector& place = network.vertices[candidate.vertices[is_end ? i + 1 : i]];
      Vector tangent = network.edges[edges[neighbor]].curve(network.vertices).tangent(place);
      const Vector& along = (is_end ? stations[stations.size() - 1] : stations[0]).tangent;
      if (tangent.dot(along) < 0.)
        tangent = -tangent;
      if (tangent.dot(along) > std::cos(most_spline_turn))
        piece.end_tangents[is_end ? 1 : 0] = tangent;
    }
  }

  // how well the field's points agree
  void measure(Typed_piece& piece) const
  {
    const double cutoff = residual_cutoff(m_noise), length = m_candidates[piece.curve].length;
    double squares = 0.;
    for (const Curve_support& s : m_support[piece.curve])
    {
      const bool is_inside = (s.parameter >= piece.range[0] && s.parameter < piece.range[1])
        || (s.parameter + length >= piece.range[0] && s.parameter + length < piece.range[1]);
      if (!is_inside)
        continue;
      const Vector& p = m_band.points[s.point];
      const Vector foot = piece.is_primitive ? piece.shape.foot(p) : s.foot;
      const double e = std::abs(m_band.distances[s.point] - (p - foot).norm());
      if (e > cutoff)
        continue;
      squares += e * e;
      piece.maximum_deviation = (std::max)(piece.maximum_deviation, e);
      ++piece.support;
    }
    piece.root_mean_square = piece.support > 0 ? std::sqrt(squares / double(piece.support)) : 0.;
  }
};

} // namespace internal
} // namespace Wireframe_extraction
} // namespace CGAL

#endif // CGAL_WIREFRAME_EXTRACTION_INTERNAL_TYPES_CURVE_TYPE_RECOGNIZER_H
